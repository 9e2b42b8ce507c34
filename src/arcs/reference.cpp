#include "swivel/reference.hpp"

#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"

// shortest_arc and arc_with_twist.

namespace swivel::reference {

namespace {

// v less its part along a, given 1/|a|^2.
template <class T>
vec3<T> without_part(const vec3<T>& v, const vec3<T>& a, T scale) {
    const T part = dot(v, a) * scale;
    return {v.x - part * a.x, v.y - part * a.y, v.z - part * a.z};
}

// A positive multiple of the arc from a to b. Where they are more than 90 degrees apart it is a half turn
// from a to -a about an axis g, and then the arc from -a to b. A vector of zeros gives the identity.
template <class T>
quat<T> arc_between(const vec3<T>& a, const vec3<T>& b) {
    const T aa = dot(a, a), squares = aa * dot(b, b), cosine = dot(a, b);
    const vec3<T> c = cross(a, b);
    const T h = squares == 0 ? T(1) : std::sqrt(squares) + std::fabs(cosine);
    if (!(cosine < 0)) return {c.x, c.y, c.z, h};

    const T scale = 1 / aa;
    vec3<T> g = without_part(without_part(c, a, scale), a, scale);
    if (!(dot(g, g) > floored(T(0.75) * dot(c, c)))) g = perpendicular(a);
    const quat<T> q{(h * g.x - c.y * g.z) + c.z * g.y, (h * g.y - c.z * g.x) + c.x * g.z,
                    (h * g.z - c.x * g.y) + c.y * g.x, dot(c, g)};
    return std::signbit(q.w) ? quat<T>{-q.x, -q.y, -q.z, -q.w} : q;
}

template <class T>
quat<T> unit(const quat<T>& q) {
    const T length = std::sqrt(((q.x * q.x + q.y * q.y) + q.z * q.z) + q.w * q.w);
    return {q.x / length, q.y / length, q.z / length, q.w / length};
}

// By half of the angle; none about a vector without direction.
template <class T>
quat<T> twist_about(const vec3<T>& a, T radians) {
    const sine_cosine<T> h = sincos_of(T(0.5) * radians);
    const T squared = dot(a, a), factor = h.sine / std::sqrt(floored(squared));
    return {factor * a.x, factor * a.y, factor * a.z, squared == 0 ? T(1) : h.cosine};
}

template <class T>
quat<T> shortest_arc_of(const vec3<T>& v, const vec3<T>& w) {
    return unit(arc_between(in_range(v), in_range(w)));
}

template <class T>
quat<T> arc_with_twist_of(const vec3<T>& v, const vec3<T>& w, T radians, product order) {
    const vec3<T> a = in_range(v), b = in_range(w);
    const quat<T> arc = arc_between(a, b);
    return unit(order == product::swing_twist ? hamilton(arc, twist_about(a, radians))
                                              : hamilton(twist_about(b, radians), arc));
}

template <class T>
status shortest_arc_all(const vec3_view<const T>& v, const vec3_view<const T>& w, const quat_view<T>& out,
                        const options& o) {
    return for_each<T>(o, std::tuple(v, w), std::tuple(out),
                       [&](std::size_t i) { write(out, i, shortest_arc_of(read(v, i), read(w, i))); });
}

template <class T>
status arc_with_twist_all(const vec3_view<const T>& v, const vec3_view<const T>& w,
                          const parameter<T>& radians, const quat_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(v, w, radians), std::tuple(out), [&](std::size_t i) {
        write(out, i, arc_with_twist_of(read(v, i), read(w, i), read(radians, i), o.order));
    });
}

}  // namespace

status shortest_arc(const vec3_view<const float>& v, const vec3_view<const float>& w,
                    const quat_view<float>& out, options o) noexcept {
    return shortest_arc_all<float>(v, w, out, o);
}
status shortest_arc(const vec3_view<const double>& v, const vec3_view<const double>& w,
                    const quat_view<double>& out, options o) noexcept {
    return shortest_arc_all<double>(v, w, out, o);
}
status arc_with_twist(const vec3_view<const float>& v, const vec3_view<const float>& w,
                      const parameter<float>& radians, const quat_view<float>& out, options o) noexcept {
    return arc_with_twist_all<float>(v, w, radians, out, o);
}
status arc_with_twist(const vec3_view<const double>& v, const vec3_view<const double>& w,
                      const parameter<double>& radians, const quat_view<double>& out, options o) noexcept {
    return arc_with_twist_all<double>(v, w, radians, out, o);
}

}  // namespace swivel::reference
