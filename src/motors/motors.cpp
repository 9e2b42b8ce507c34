#include "kernels/motors/tables.hpp"
#include "src/call/call.hpp"
#include "swivel/motor.hpp"

namespace swivel {

namespace {

template <class T>
status any_multiply(const motor_view<const T>& a, const motor_view<const T>& b, const motor_view<T>& out,
                    const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.write(out);
    return c.template run<motor_multiply_kernels>(index_of(o.accuracy));
}

template <class T>
status any_conjugate(const motor_view<const T>& m, const motor_view<T>& out, const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.write(out);
    return c.template run<motor_conjugate_kernels>(0);
}

template <class T>
status any_normalize(const motor_view<const T>& m, const motor_view<T>& out, const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.write(out);
    return c.template run<motor_normalize_kernels>(index_of(o.accuracy));
}

template <class T>
status any_from_rotation_translation(const quat_view<const T>& q, const vec3_view<const T>& t,
                                     const motor_view<T>& out, const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.read(t);
    c.write(out);
    return c.template run<from_rotation_translation_kernels>(index_of(o.accuracy));
}

template <class T>
status any_to_rotation_translation(const motor_view<const T>& m, const quat_view<T>& q, const vec3_view<T>& t,
                                   const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.write(q);
    c.write(t);
    return c.template run<to_rotation_translation_kernels>(index_of(o.accuracy));
}

template <class T>
status any_transform(const motor_view<const T>& m, const vec3_view<const T>& points, const vec3_view<T>& out,
                     const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.read(points);
    c.write(out);
    return c.template run<motor_transform_kernels>(index_of(o.accuracy));
}

template <class T>
status any_compose(const quat_view<const T>& swing, const quat_view<const T>& twist,
                   const vec3_view<const T>& translation, const motor_view<T>& out,
                   const options& o) noexcept {
    const bool swing_left = o.order == product::swing_twist;
    call<T> c(swing.size, o);
    c.read(swing_left ? swing : twist);
    c.read(swing_left ? twist : swing);
    c.read(translation);
    c.write(out);
    return c.template run<motor_compose_kernels>(index_of(o.accuracy));
}

}  // namespace

status multiply(const motor_view<const float>& a, const motor_view<const float>& b,
                const motor_view<float>& out, options o) noexcept {
    return any_multiply<float>(a, b, out, o);
}
status multiply(const motor_view<const double>& a, const motor_view<const double>& b,
                const motor_view<double>& out, options o) noexcept {
    return any_multiply<double>(a, b, out, o);
}
status conjugate(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return any_conjugate<float>(m, out, o);
}
status conjugate(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return any_conjugate<double>(m, out, o);
}
status normalize(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return any_normalize<float>(m, out, o);
}
status normalize(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return any_normalize<double>(m, out, o);
}
status from_rotation_translation(const quat_view<const float>& q, const vec3_view<const float>& t,
                                 const motor_view<float>& out, options o) noexcept {
    return any_from_rotation_translation<float>(q, t, out, o);
}
status from_rotation_translation(const quat_view<const double>& q, const vec3_view<const double>& t,
                                 const motor_view<double>& out, options o) noexcept {
    return any_from_rotation_translation<double>(q, t, out, o);
}
status to_rotation_translation(const motor_view<const float>& m, const quat_view<float>& q,
                               const vec3_view<float>& t, options o) noexcept {
    return any_to_rotation_translation<float>(m, q, t, o);
}
status to_rotation_translation(const motor_view<const double>& m, const quat_view<double>& q,
                               const vec3_view<double>& t, options o) noexcept {
    return any_to_rotation_translation<double>(m, q, t, o);
}
status transform(const motor_view<const float>& m, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options o) noexcept {
    return any_transform<float>(m, points, out, o);
}
status transform(const motor_view<const double>& m, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options o) noexcept {
    return any_transform<double>(m, points, out, o);
}
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const vec3_view<const float>& translation, const motor_view<float>& out, options o) noexcept {
    return any_compose<float>(swing, twist, translation, out, o);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const vec3_view<const double>& translation, const motor_view<double>& out,
               options o) noexcept {
    return any_compose<double>(swing, twist, translation, out, o);
}

}  // namespace swivel
