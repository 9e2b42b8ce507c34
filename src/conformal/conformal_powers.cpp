#include "kernels/conformal/tables.hpp"
#include "src/call/call.hpp"
#include "swivel/conformal.hpp"

namespace swivel {

namespace {

template <class T>
status any_square_root(const conformal_view<const T>& r, const conformal_view<T>& out,
                       const scalar_view<T>& unique, const options& o) noexcept {
    call<T> c(r.size, o);
    c.read(r);
    c.write(out);
    c.write(unique);
    return c.template run<conformal_square_root_kernels>(index_of(o.accuracy));
}

template <class T>
status any_exp(const bivector_view<const T>& b, const conformal_view<T>& out, const options& o) noexcept {
    call<T> c(b.size, o);
    c.read(b);
    c.write(out);
    return c.template run<conformal_exp_kernels>(index_of(o.accuracy));
}

template <class T>
status any_log(const conformal_view<const T>& r, const bivector_view<T>& out, const scalar_view<T>& unique,
               const options& o) noexcept {
    call<T> c(r.size, o);
    c.read(r);
    c.write(out);
    c.write(unique);
    return c.template run<conformal_log_kernels>(index_of(o.accuracy));
}

template <class T>
status any_power(const conformal_view<const T>& r, const parameter<T>& t, const conformal_view<T>& out,
                 const scalar_view<T>& unique, const options& o) noexcept {
    call<T> c(r.size, o);
    c.read(r);
    c.read(t);
    c.write(out);
    c.write(unique);
    return c.template run<conformal_power_kernels>(index_of(o.accuracy));
}

template <class T>
status any_interpolate(const conformal_view<const T>& a, const conformal_view<const T>& b,
                       const parameter<T>& t, const conformal_view<T>& out, const scalar_view<T>& unique,
                       const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.read(t);
    c.write(out);
    c.write(unique);
    return c.template run<conformal_interpolate_kernels>(index_of(o.accuracy));
}

template <class T>
status any_split(const bivector_view<const T>& b, const bivector_view<T>& first,
                 const bivector_view<T>& second, const scalar_view<T>& unique, const options& o) noexcept {
    call<T> c(b.size, o);
    c.read(b);
    c.write(first);
    c.write(second);
    c.write(unique);
    return c.template run<conformal_split_kernels>(index_of(o.accuracy));
}

}  // namespace

status square_root(const conformal_view<const float>& r, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options o) noexcept {
    return any_square_root<float>(r, out, unique, o);
}
status square_root(const conformal_view<const double>& r, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options o) noexcept {
    return any_square_root<double>(r, out, unique, o);
}
status exp(const bivector_view<const float>& b, const conformal_view<float>& out, options o) noexcept {
    return any_exp<float>(b, out, o);
}
status exp(const bivector_view<const double>& b, const conformal_view<double>& out, options o) noexcept {
    return any_exp<double>(b, out, o);
}
status log(const conformal_view<const float>& r, const bivector_view<float>& out,
           const scalar_view<float>& unique, options o) noexcept {
    return any_log<float>(r, out, unique, o);
}
status log(const conformal_view<const double>& r, const bivector_view<double>& out,
           const scalar_view<double>& unique, options o) noexcept {
    return any_log<double>(r, out, unique, o);
}
status power(const conformal_view<const float>& r, const parameter<float>& t,
             const conformal_view<float>& out, const scalar_view<float>& unique, options o) noexcept {
    return any_power<float>(r, t, out, unique, o);
}
status power(const conformal_view<const double>& r, const parameter<double>& t,
             const conformal_view<double>& out, const scalar_view<double>& unique, options o) noexcept {
    return any_power<double>(r, t, out, unique, o);
}
status interpolate(const conformal_view<const float>& a, const conformal_view<const float>& b,
                   const parameter<float>& t, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options o) noexcept {
    return any_interpolate<float>(a, b, t, out, unique, o);
}
status interpolate(const conformal_view<const double>& a, const conformal_view<const double>& b,
                   const parameter<double>& t, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options o) noexcept {
    return any_interpolate<double>(a, b, t, out, unique, o);
}
status split(const bivector_view<const float>& b, const bivector_view<float>& first,
             const bivector_view<float>& second, const scalar_view<float>& unique, options o) noexcept {
    return any_split<float>(b, first, second, unique, o);
}
status split(const bivector_view<const double>& b, const bivector_view<double>& first,
             const bivector_view<double>& second, const scalar_view<double>& unique, options o) noexcept {
    return any_split<double>(b, first, second, unique, o);
}

}  // namespace swivel
