#include "swivel/conformal.hpp"

#include "kernels/conformal/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_multiply(const conformal_view<const T>& a, const conformal_view<const T>& b,
                    const conformal_view<T>& out, const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.write(out);
    return c.template run<conformal_multiply_kernels>(index_of(o.accuracy));
}

template <class T>
status any_reverse(const conformal_view<const T>& r, const conformal_view<T>& out,
                   const options& o) noexcept {
    call<T> c(r.size, o);
    c.read(r);
    c.write(out);
    return c.template run<conformal_reverse_kernels>(0);
}

template <class T>
status any_from_motor(const motor_view<const T>& m, const conformal_view<T>& out, const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.write(out);
    return c.template run<conformal_from_motor_kernels>(0);
}

template <class T>
status any_from_rotation(const quat_view<const T>& q, const conformal_view<T>& out,
                         const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.write(out);
    return c.template run<conformal_from_rotation_kernels>(0);
}

template <class T>
status any_from_translation(const vec3_view<const T>& t, const conformal_view<T>& out,
                            const options& o) noexcept {
    call<T> c(t.size, o);
    c.read(t);
    c.write(out);
    return c.template run<conformal_from_translation_kernels>(0);
}

template <class T>
status any_from_dilation(const scalar_view<const T>& factor, const conformal_view<T>& out,
                         const options& o) noexcept {
    call<T> c(factor.size, o);
    c.read(factor);
    c.write(out);
    return c.template run<conformal_from_dilation_kernels>(0);
}

template <class T>
status any_transform(const conformal_view<const T>& r, const vec3_view<const T>& points,
                     const vec3_view<T>& out, const options& o) noexcept {
    call<T> c(r.size, o);
    c.read(r);
    c.read(points);
    c.write(out);
    return c.template run<conformal_transform_kernels>(index_of(o.accuracy));
}

}  // namespace

status multiply(const conformal_view<const float>& a, const conformal_view<const float>& b,
                const conformal_view<float>& out, options o) noexcept {
    return any_multiply<float>(a, b, out, o);
}
status multiply(const conformal_view<const double>& a, const conformal_view<const double>& b,
                const conformal_view<double>& out, options o) noexcept {
    return any_multiply<double>(a, b, out, o);
}
status reverse(const conformal_view<const float>& c, const conformal_view<float>& out, options o) noexcept {
    return any_reverse<float>(c, out, o);
}
status reverse(const conformal_view<const double>& c, const conformal_view<double>& out, options o) noexcept {
    return any_reverse<double>(c, out, o);
}
status from_motor(const motor_view<const float>& m, const conformal_view<float>& out, options o) noexcept {
    return any_from_motor<float>(m, out, o);
}
status from_motor(const motor_view<const double>& m, const conformal_view<double>& out, options o) noexcept {
    return any_from_motor<double>(m, out, o);
}
status from_rotation(const quat_view<const float>& q, const conformal_view<float>& out, options o) noexcept {
    return any_from_rotation<float>(q, out, o);
}
status from_rotation(const quat_view<const double>& q, const conformal_view<double>& out,
                     options o) noexcept {
    return any_from_rotation<double>(q, out, o);
}
status from_translation(const vec3_view<const float>& t, const conformal_view<float>& out,
                        options o) noexcept {
    return any_from_translation<float>(t, out, o);
}
status from_translation(const vec3_view<const double>& t, const conformal_view<double>& out,
                        options o) noexcept {
    return any_from_translation<double>(t, out, o);
}
status from_dilation(const scalar_view<const float>& factor, const conformal_view<float>& out,
                     options o) noexcept {
    return any_from_dilation<float>(factor, out, o);
}
status from_dilation(const scalar_view<const double>& factor, const conformal_view<double>& out,
                     options o) noexcept {
    return any_from_dilation<double>(factor, out, o);
}
status transform(const conformal_view<const float>& r, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options o) noexcept {
    return any_transform<float>(r, points, out, o);
}
status transform(const conformal_view<const double>& r, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options o) noexcept {
    return any_transform<double>(r, points, out, o);
}

}  // namespace swivel
