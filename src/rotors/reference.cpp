#include "swivel/reference.hpp"

#include "src/exponentials/reference.hpp"
#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"

// multiply, conjugate, normalize, rotate, dot, angle_between and align_signs.

namespace swivel::reference {

namespace {

template <class T>
bool is_finite(const quat<T>& q) {
    return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w);
}

template <class T>
status multiply_all(const quat_view<const T>& a, const quat_view<const T>& b, const quat_view<T>& out,
                    const options& o) {
    return for_each<T>(o, std::tuple(a, b), std::tuple(out),
                       [&](std::size_t i) { write(out, i, multiply(read(a, i), read(b, i))); });
}

template <class T>
status conjugate_all(const quat_view<const T>& q, const quat_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(out), [&](std::size_t i) {
        const quat<T> e = read(q, i);
        write(out, i, {-e.x, -e.y, -e.z, e.w});
    });
}

template <class T>
status normalize_all(const quat_view<const T>& q, const quat_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(out),
                       [&](std::size_t i) { write(out, i, normalized(read(q, i))); });
}

template <class T>
status rotate_all(const quat_view<const T>& q, const vec3_view<const T>& v, const vec3_view<T>& out,
                  const options& o) {
    return for_each<T>(o, std::tuple(q, v), std::tuple(out),
                       [&](std::size_t i) { write(out, i, rotated(read(v, i), read(q, i))); });
}

template <class T>
status rotate_all(const quat<T>& q, const vec3_view<const T>& v, const vec3_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(v), std::tuple(out),
                       [&](std::size_t i) { write(out, i, rotated(read(v, i), q)); });
}

template <class T>
status dot_all(const quat_view<const T>& a, const quat_view<const T>& b, const scalar_view<T>& out,
               const options& o) {
    return for_each<T>(o, std::tuple(a, b), std::tuple(out),
                       [&](std::size_t i) { write(out, i, finite_or_nan(dot(read(a, i), read(b, i)))); });
}

template <class T>
T angle_between_of(const quat<T>& a, const quat<T>& b) {
    const T cosine = dot(a, b), a_squared = dot(a, a);
    const bool same_length = std::fabs(a_squared - dot(b, b)) < T(0x1p-10) * a_squared;
    const T k = same_length ? std::copysign(T(1), cosine) : cosine / floored(a_squared);
    const quat<T> apart{b.x - k * a.x, b.y - k * a.y, b.z - k * a.z, b.w - k * a.w};
    const quat<T> turn = hamilton(reversed(a), apart);
    const polar_form<T> q = polar({turn.x, turn.y, turn.z, std::fabs(cosine)}, T(1));
    const T half = atan2_of(q.m, q.w);
    return half + half;
}

template <class T>
status angle_between_all(const quat_view<const T>& a, const quat_view<const T>& b,
                         const scalar_view<T>& radians, const options& o) {
    return for_each<T>(o, std::tuple(a, b), std::tuple(radians),
                       [&](std::size_t i) { write(radians, i, angle_between_of(read(a, i), read(b, i))); });
}

template <class T>
quat<T> aligned(const quat<T>& q, const quat<T>& neighbour) {
    return finite_or_nan(dot(q, neighbour)) < 0 ? minus(q) : q;
}

template <class T>
status align_signs_all(const quat_view<const T>& q, const quat_view<const T>& neighbour,
                       const quat_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(q, neighbour), std::tuple(out), [&](std::size_t i) {
        const quat<T> e = read(q, i), n = read(neighbour, i);
        const T product = finite_or_nan(dot(e, n));
        write(out, i, std::isnan(product) ? quat<T>{product, product, product, product} : aligned(e, n));
    });
}

template <class T>
status align_signs_all(const quat_view<const T>& q, const quat_view<T>& out, const options& o) {
    quat<T> last_finite{};
    return for_each<T>(o, std::tuple(q), std::tuple(out), [&](std::size_t i) {
        const quat<T> e = aligned(read(q, i), last_finite);
        if (is_finite(e)) last_finite = e;
        write(out, i, e);
    });
}

}  // namespace

status multiply(const quat_view<const float>& a, const quat_view<const float>& b, const quat_view<float>& out,
                options o) noexcept {
    return multiply_all<float>(a, b, out, o);
}
status multiply(const quat_view<const double>& a, const quat_view<const double>& b,
                const quat_view<double>& out, options o) noexcept {
    return multiply_all<double>(a, b, out, o);
}
status conjugate(const quat_view<const float>& q, const quat_view<float>& out, options o) noexcept {
    return conjugate_all<float>(q, out, o);
}
status conjugate(const quat_view<const double>& q, const quat_view<double>& out, options o) noexcept {
    return conjugate_all<double>(q, out, o);
}
status normalize(const quat_view<const float>& q, const quat_view<float>& out, options o) noexcept {
    return normalize_all<float>(q, out, o);
}
status normalize(const quat_view<const double>& q, const quat_view<double>& out, options o) noexcept {
    return normalize_all<double>(q, out, o);
}
status rotate(const quat_view<const float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options o) noexcept {
    return rotate_all<float>(q, v, out, o);
}
status rotate(const quat_view<const double>& q, const vec3_view<const double>& v,
              const vec3_view<double>& out, options o) noexcept {
    return rotate_all<double>(q, v, out, o);
}
status rotate(const quat<float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options o) noexcept {
    return rotate_all<float>(q, v, out, o);
}
status rotate(const quat<double>& q, const vec3_view<const double>& v, const vec3_view<double>& out,
              options o) noexcept {
    return rotate_all<double>(q, v, out, o);
}
status dot(const quat_view<const float>& a, const quat_view<const float>& b, const scalar_view<float>& out,
           options o) noexcept {
    return dot_all<float>(a, b, out, o);
}
status dot(const quat_view<const double>& a, const quat_view<const double>& b, const scalar_view<double>& out,
           options o) noexcept {
    return dot_all<double>(a, b, out, o);
}
status angle_between(const quat_view<const float>& a, const quat_view<const float>& b,
                     const scalar_view<float>& radians, options o) noexcept {
    return angle_between_all<float>(a, b, radians, o);
}
status angle_between(const quat_view<const double>& a, const quat_view<const double>& b,
                     const scalar_view<double>& radians, options o) noexcept {
    return angle_between_all<double>(a, b, radians, o);
}
status align_signs(const quat_view<const float>& q, const quat_view<const float>& neighbour,
                   const quat_view<float>& out, options o) noexcept {
    return align_signs_all<float>(q, neighbour, out, o);
}
status align_signs(const quat_view<const double>& q, const quat_view<const double>& neighbour,
                   const quat_view<double>& out, options o) noexcept {
    return align_signs_all<double>(q, neighbour, out, o);
}
status align_signs(const quat_view<const float>& q, const quat_view<float>& out, options o) noexcept {
    return align_signs_all<float>(q, out, o);
}
status align_signs(const quat_view<const double>& q, const quat_view<double>& out, options o) noexcept {
    return align_signs_all<double>(q, out, o);
}

}  // namespace swivel::reference
