#include "src/exponentials/reference.hpp"

#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"
#include "swivel/reference.hpp"

// square_root, exp, log and power.

namespace swivel::reference {

namespace {

template <class T>
quat<T> square_root_of(const quat<T>& q) {
    const polar_form<T> p = polar(q, T(0.5));
    const T scale = scale_for({p.m, std::fabs(p.w)});
    const sine_cosine<T> h = half_of(p.m * scale, p.m == 0 && p.w == 0 ? T(1) : p.w * scale);
    return joined(p.along(h.sine), h.cosine);
}

template <class T>
quat<T> exp_of(const vec3<T>& b) {
    using C = constants<T>;
    const T squared = dot(b, b), zero_or_nan = T(0) * b.z + (T(0) * b.y + T(0) * b.x);
    const bool beyond = squared > C::largest_angle * C::largest_angle;
    const T angle = std::sqrt(floored(beyond ? zero_or_nan : squared));
    const sine_cosine<T> h = sincos_of(angle);
    const T factor = beyond ? zero_or_nan : h.sine / angle;
    return {b.x * factor, b.y * factor, b.z * factor, h.cosine};
}

template <class T>
vec3<T> log_of(const quat<T>& q) {
    const polar_form<T> p = polar(q, T(1));
    return p.along(atan2_of(p.m, p.w));
}

template <class T>
quat<T> power_of(const quat<T>& q, T t) {
    const polar_form<T> p = polar(q, T(1));
    const T angle = atan2_of(p.m, p.w), product = t * angle;
    if (T(0) * angle + t == 1) return q;
    const sine_cosine<T> h = sincos_of(std::fabs(product) > constants<T>::largest_angle ? T(0) * t : product);
    return joined(p.along(h.sine), h.cosine);
}

template <class T>
status square_root_all(const quat_view<const T>& q, const quat_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(out),
                       [&](std::size_t i) { write(out, i, square_root_of(read(q, i))); });
}

template <class T>
status exp_all(const vec3_view<const T>& b, const quat_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(b), std::tuple(out),
                       [&](std::size_t i) { write(out, i, exp_of(read(b, i))); });
}

template <class T>
status log_all(const quat_view<const T>& q, const vec3_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(out),
                       [&](std::size_t i) { write(out, i, log_of(read(q, i))); });
}

template <class T>
status power_all(const quat_view<const T>& q, const parameter<T>& t, const quat_view<T>& out,
                 const options& o) {
    return for_each<T>(o, std::tuple(q, t), std::tuple(out),
                       [&](std::size_t i) { write(out, i, power_of(read(q, i), read(t, i))); });
}

}  // namespace

status square_root(const quat_view<const float>& q, const quat_view<float>& out, options o) noexcept {
    return square_root_all<float>(q, out, o);
}
status square_root(const quat_view<const double>& q, const quat_view<double>& out, options o) noexcept {
    return square_root_all<double>(q, out, o);
}
status exp(const vec3_view<const float>& b, const quat_view<float>& out, options o) noexcept {
    return exp_all<float>(b, out, o);
}
status exp(const vec3_view<const double>& b, const quat_view<double>& out, options o) noexcept {
    return exp_all<double>(b, out, o);
}
status log(const quat_view<const float>& q, const vec3_view<float>& out, options o) noexcept {
    return log_all<float>(q, out, o);
}
status log(const quat_view<const double>& q, const vec3_view<double>& out, options o) noexcept {
    return log_all<double>(q, out, o);
}
status power(const quat_view<const float>& q, const parameter<float>& t, const quat_view<float>& out,
             options o) noexcept {
    return power_all<float>(q, t, out, o);
}
status power(const quat_view<const double>& q, const parameter<double>& t, const quat_view<double>& out,
             options o) noexcept {
    return power_all<double>(q, t, out, o);
}

}  // namespace swivel::reference
