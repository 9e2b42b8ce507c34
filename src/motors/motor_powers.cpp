#include "kernels/motors/tables.hpp"
#include "src/call/call.hpp"
#include "swivel/motor.hpp"

namespace swivel {

namespace {

template <class T>
status any_square_root(const motor_view<const T>& m, const motor_view<T>& out, const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.write(out);
    return c.template run<motor_square_root_kernels>(index_of(o.accuracy));
}

template <class T>
status any_log(const motor_view<const T>& m, const vec3_view<T>& b, const vec3_view<T>& n,
               const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.write(b);
    c.write(n);
    return c.template run<motor_log_kernels>(index_of(o.accuracy));
}

template <class T>
status any_exp(const vec3_view<const T>& b, const vec3_view<const T>& n, const motor_view<T>& out,
               const options& o) noexcept {
    call<T> c(b.size, o);
    c.read(b);
    c.read(n);
    c.write(out);
    return c.template run<motor_exp_kernels>(index_of(o.accuracy));
}

template <class T>
status any_power(const motor_view<const T>& m, const parameter<T>& t, const motor_view<T>& out,
                 const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.read(t);
    c.write(out);
    return c.template run<motor_power_kernels>(index_of(o.accuracy));
}

template <class T>
status any_sclerp(const motor_view<const T>& a, const motor_view<const T>& b, const parameter<T>& t,
                  const motor_view<T>& out, const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.read(t);
    c.write(out);
    return c.template run<sclerp_kernels>(o.long_way, index_of(o.accuracy));
}

}  // namespace

status square_root(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return any_square_root<float>(m, out, o);
}
status square_root(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return any_square_root<double>(m, out, o);
}
status log(const motor_view<const float>& m, const vec3_view<float>& b, const vec3_view<float>& n,
           options o) noexcept {
    return any_log<float>(m, b, n, o);
}
status log(const motor_view<const double>& m, const vec3_view<double>& b, const vec3_view<double>& n,
           options o) noexcept {
    return any_log<double>(m, b, n, o);
}
status exp(const vec3_view<const float>& b, const vec3_view<const float>& n, const motor_view<float>& out,
           options o) noexcept {
    return any_exp<float>(b, n, out, o);
}
status exp(const vec3_view<const double>& b, const vec3_view<const double>& n, const motor_view<double>& out,
           options o) noexcept {
    return any_exp<double>(b, n, out, o);
}
status power(const motor_view<const float>& m, const parameter<float>& t, const motor_view<float>& out,
             options o) noexcept {
    return any_power<float>(m, t, out, o);
}
status power(const motor_view<const double>& m, const parameter<double>& t, const motor_view<double>& out,
             options o) noexcept {
    return any_power<double>(m, t, out, o);
}
status sclerp(const motor_view<const float>& a, const motor_view<const float>& b, const parameter<float>& t,
              const motor_view<float>& out, options o) noexcept {
    return any_sclerp<float>(a, b, t, out, o);
}
status sclerp(const motor_view<const double>& a, const motor_view<const double>& b,
              const parameter<double>& t, const motor_view<double>& out, options o) noexcept {
    return any_sclerp<double>(a, b, t, out, o);
}

}  // namespace swivel
