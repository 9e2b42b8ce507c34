#include "swivel/versors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "src/reference/scalar.hpp"
#include "swivel/reference.hpp"

namespace swivel::reference {

namespace {

// (x, y) times 2^shift is the pair, the larger of x and y between 2 and 4 as far as there is one.
template <class T>
struct scaled_pair {
    T x, y;
    int shift;
};

template <class T>
scaled_pair<T> brought_near_one(T x, T y) {
    const T scale = scale_for({std::fabs(x), std::fabs(y)});
    int exponent;
    std::frexp(scale, &exponent);
    return {scale * x, scale * y, 1 - exponent};
}

template <class T>
bool is_zero(const vec3<T>& v) {
    return v.x == 0 && v.y == 0 && v.z == 0;
}

// A direction perpendicular to the axes of two unit quaternions.
template <class T>
vec3<T> common_perpendicular(const quat<T>& first, const quat<T>& second) {
    const vec3<T> v1 = vector_part(first), v2 = vector_part(second);
    const vec3<T> a = in_range(v1), b = in_range(v2);
    if (is_zero(a) && is_zero(b)) return {0, 1, 0};
    const T noise = 4 * std::numeric_limits<T>::epsilon();
    vec3<T> c = cross(a, b);
    if (dot(c, c) <= noise * noise * (dot(a, a) * dot(b, b))) c = perpendicular(is_zero(a) ? b : a);
    // What rounding left along the axis, which may be much of a short product.
    if (!is_zero(a)) {
        const T part = dot(c, a) / dot(a, a);
        c = {c.x - part * a.x, c.y - part * a.y, c.z - part * a.z};
    }
    const unit_axis<T> u = normalized(c);
    return {u.x, u.y, u.z};
}

// q c for a unit vector c perpendicular to the axis of q: c turned by half of the angle of q.
template <class T>
vec3<T> slid(const quat<T>& q, const vec3<T>& c) {
    const vec3<T> across = cross(vector_part(q), c);
    return {q.w * c.x + across.x, q.w * c.y + across.y, q.w * c.z + across.z};
}

template <class T>
quat<T> root_of(quat<T> q) {
    const quat_view<T> v{&q.x, &q.y, &q.z, &q.w, 1};
    // One element in place, which is never refused.
    static_cast<void>(square_root(v, v));
    return q;
}

}  // namespace

template <class T>
spinor2<T> ratio(const vec2<T>& b, const vec2<T>& a) noexcept {
    const scaled_pair<T> n = brought_near_one(b.x, b.y), m = brought_near_one(a.x, a.y);
    const T squared = m.x * m.x + m.y * m.y;
    if (squared == 0) {
        const T zero_or_nan = T(0) * n.x + T(0) * n.y;
        return {1 + zero_or_nan, zero_or_nan};
    }
    const int shift = n.shift - m.shift;
    return {std::ldexp((n.x * m.x + n.y * m.y) / squared, shift),
            std::ldexp((n.x * m.y - n.y * m.x) / squared, shift)};
}

template <class T>
vec2<T> apply(const spinor2<T>& s, const vec2<T>& v) noexcept {
    const scaled_pair<T> p = brought_near_one(s.scalar, s.e12), u = brought_near_one(v.x, v.y);
    const int shift = p.shift + u.shift;
    return {std::ldexp(p.x * u.x + p.y * u.y, shift), std::ldexp(p.x * u.y - p.y * u.x, shift)};
}

template <class T>
vec3<T> reflect(const vec3<T>& v, const vec3<T>& a) noexcept {
    const T scale = scale_for(v);
    const vec3<T> u = scaled(v, scale), n = in_range(a);
    const T squared = dot(n, n);
    const T part = dot(u, n) / (squared == 0 ? T(1) : squared);
    const vec3<T> h{part * n.x / scale, part * n.y / scale, part * n.z / scale};
    // Not twice h, which may be infinite where the difference is not.
    return {(v.x - h.x) - h.x, (v.y - h.y) - h.y, (v.z - h.z) - h.z};
}

template <class T>
quat<T> rotation_from_reflections(const vec3<T>& a, const vec3<T>& b) noexcept {
    const vec3<T> m = in_range(a), n = in_range(b), v = cross(m, n);
    return normalized(quat<T>{v.x, v.y, v.z, dot(m, n)});
}

template <class T>
T half_angle_cosine(T first_half_angle, T second_half_angle, T between_axes) noexcept {
    const T cosine = std::cos(first_half_angle) * std::cos(second_half_angle) -
                     std::sin(first_half_angle) * std::sin(second_half_angle) * std::cos(between_axes);
    return std::clamp(cosine, T(-1), T(1));
}

template <class T>
composed_arcs<T> compose_arcs(const quat<T>& first, const quat<T>& second) noexcept {
    const quat<T> q = normalized(first), r = normalized(second);
    const vec3<T> common = common_perpendicular(q, r);
    return {slid(reversed(q), common), common, slid(r, common), normalized(hamilton(r, q))};
}

template <class T>
quat<T> from_spinor(const spinor<T>& s) noexcept {
    return {-s.c, -s.d, -s.b, s.a};
}

template <class T>
spinor<T> to_spinor(const quat<T>& q) noexcept {
    return {q.w, -q.z, -q.x, -q.y};
}

template <class T>
quat<T> power_by_halving(const quat<T>& q, T t, int bits) noexcept {
    const quat<T> whole = normalized(q);
    const T zero_or_nan = T(0) * whole.w + T(0) * t;
    if (std::isnan(zero_or_nan)) return {zero_or_nan, zero_or_nan, zero_or_nan, zero_or_nan};
    const int places = std::clamp(bits, 0, 62);
    const auto fraction =
        static_cast<std::uint64_t>(std::llround(std::ldexp(std::clamp(t, T(0), T(1)), places)));
    if (fraction >> places != 0) return whole;
    quat<T> product{0, 0, 0, 1}, root = whole;
    for (int place = places - 1; place >= 0; --place) {
        root = root_of(root);
        if ((fraction >> place & 1U) != 0) product = hamilton(root, product);
    }
    return normalized(product);
}

template <class T>
quat<T> interpolate_by_halving(const quat<T>& a, const quat<T>& b, T t, int bits) noexcept {
    const quat<T> from = normalized(a), to = normalized(b);
    const quat<T> way = hamilton(dot(from, to) < 0 ? minus(to) : to, reversed(from));
    return normalized(hamilton(power_by_halving(way, t, bits), from));
}

#define SWIVEL_INSTANTIATE(T)                                                            \
    template spinor2<T> ratio(const vec2<T>&, const vec2<T>&) noexcept;                  \
    template vec2<T> apply(const spinor2<T>&, const vec2<T>&) noexcept;                  \
    template vec3<T> reflect(const vec3<T>&, const vec3<T>&) noexcept;                   \
    template quat<T> rotation_from_reflections(const vec3<T>&, const vec3<T>&) noexcept; \
    template T half_angle_cosine(T, T, T) noexcept;                                      \
    template composed_arcs<T> compose_arcs(const quat<T>&, const quat<T>&) noexcept;     \
    template quat<T> from_spinor(const spinor<T>&) noexcept;                             \
    template spinor<T> to_spinor(const quat<T>&) noexcept;                               \
    template quat<T> power_by_halving(const quat<T>&, T, int) noexcept;                  \
    template quat<T> interpolate_by_halving(const quat<T>&, const quat<T>&, T, int) noexcept

SWIVEL_INSTANTIATE(float);
SWIVEL_INSTANTIATE(double);

#undef SWIVEL_INSTANTIATE

}  // namespace swivel::reference
