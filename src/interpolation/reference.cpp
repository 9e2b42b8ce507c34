#include "src/swing_twist/reference.hpp"

#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"
#include "swivel/reference.hpp"

// slerp, nlerp and sterp.

namespace swivel::reference {

namespace {

// a q + b r
template <class T>
quat<T> sum(T a, const quat<T>& q, T b, const quat<T>& r) {
    return {b * r.x + a * q.x, b * r.y + a * q.y, b * r.z + a * q.z, b * r.w + a * q.w};
}

// i q
template <class T>
quat<T> turned_about_x(const quat<T>& q) {
    return {q.w, 0 - q.z, q.y, 0 - q.x};
}

// The one of b and -b that is on the way; the w of b a* is the product of a and b.
template <class T>
quat<T> on_the_way(const quat<T>& b, T product, bool long_way) {
    return (product < 0) != long_way ? minus(b) : b;
}

template <class T>
quat<T> with_length_of(const quat<T>& a, const quat<T>& b) {
    const T scale = std::sqrt(dot(a, a) / floored(dot(b, b)));
    return {b.x * scale, b.y * scale, b.z * scale, b.w * scale};
}

// NaN where something is not finite.
template <class T>
quat<T> unit_of(const quat<T>& q, T least = constants<T>::pole_floor) {
    const T squared = finite_or_nan(dot(q, q)), length = std::sqrt(least > squared ? least : squared);
    return {q.x / length, q.y / length, q.z / length, q.w / length};
}

// The ends themselves, unless the result says that something is not finite.
template <class T>
quat<T> with_ends(const quat<T>& between, bool at_a, const quat<T>& a, bool at_b, const quat<T>& b) {
    if (std::isnan(between.w)) return between;
    return at_a ? a : at_b ? b : between;
}

// Weights of p and n, which are at right angles, on the way from -h to h, half the angle between a and b.
template <class T>
struct slerp_weights {
    T along, across;
};

template <class T>
slerp_weights<T> weights_of(T pp, T nn, T t, bool p_is_shorter) {
    const T least = p_is_shorter ? constants<T>::smallest_normal : constants<T>::pole_floor;
    const T p = std::sqrt(least > pp ? least : pp), n = std::sqrt(floored(nn));
    const T half =
        p_is_shorter ? constants<T>::half_pi + (constants<T>::half_pi_rest - atan_of(p / n)) : atan_of(n / p);
    const sine_cosine<T> f = sincos_of((t * 2 + -1) * half);
    return {f.cosine / p, f.sine / n};
}

template <class T>
quat<T> short_slerp(const quat<T>& a, const quat<T>& b, T t) {
    const T product = dot(a, b), aa = dot(a, a), ratio = std::sqrt(aa / floored(dot(b, b)));
    const T scale = product < 0 ? -ratio : ratio, same_length = std::fabs(product) * ratio;
    const quat<T> n{a.x - scale * b.x, a.y - scale * b.y, a.z - scale * b.z, a.w - scale * b.w};
    const auto [along, across] = weights_of((aa + aa) + (same_length + same_length), dot(n, n), t, false);
    return sum(along - across, a, (along + across) * scale, b);
}

template <class T>
quat<T> long_slerp(const quat<T>& a, const quat<T>& b, T t) {
    const quat<T> n{b.x - a.x, b.y - a.y, b.z - a.z, b.w - a.w};
    quat<T> p{a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
    const T nn = dot(n, n), part = dot(p, n) / floored(nn);
    p = {p.x - part * n.x, p.y - part * n.y, p.z - part * n.z, p.w - part * n.w};
    if (dot(p, p) <= constants<T>::pole_threshold * nn) {
        const quat<T> turned = turned_about_x(n);
        const T by = constants<T>::rounding * T(-0x1p-8);
        p = {turned.x * by, turned.y * by, turned.z * by, turned.w * by};
    }
    const auto [along, across] = weights_of(dot(p, p), nn, t, true);
    return sum(along, p, across, n);
}

template <class T>
quat<T> slerp_of(const quat<T>& a, const quat<T>& b, T t, bool long_way) {
    const quat<T> end = on_the_way(b, dot(a, b), long_way);
    const quat<T> between = long_way ? long_slerp(a, with_length_of(a, end), t) : short_slerp(a, b, t);
    return with_ends(between, t == 0, a, t == 1, end);
}

template <class T>
quat<T> nlerp_of(const quat<T>& a, const quat<T>& given, T t, bool long_way) {
    const quat<T> end = on_the_way(given, dot(a, given), long_way);
    const quat<T> m = sum(1 - t, a, t, with_length_of(a, end));
    const T mm = dot(m, m);
    const bool nothing = mm <= constants<T>::pole_threshold * dot(a, a);
    return with_ends(unit_of(nothing ? turned_about_x(a) : m, constants<T>::smallest_normal), t == 0, a,
                     t == 1, end);
}

// The t-th part of a turn whose half has that cosine and sine, times `length`.
template <class T>
sine_cosine<T> part_of_turn(T cosine, T sine, T length, T t, flavour motion) {
    if (motion == flavour::slerp) return sincos_of(t * angle_of(sine, cosine, length));
    T x = t * cosine + (1 - t) * length, y = t * sine;
    const T least = constants<T>::root_of_smallest_normal, size = least > std::fabs(y) ? least : std::fabs(y);
    T squared = size * size + x * x;
    if (squared <= constants<T>::pole_threshold * (length * length)) {
        x = 0;
        y = std::copysign(T(1), sine);
        squared = 1;
    }
    return {y / std::sqrt(squared), x / std::sqrt(squared)};
}

template <class T>
quat<T> sterp_of(const quat<T>& a, const quat<T>& b, const unit_axis<T>& axis, T s, T t, const options& o) {
    const quat<T> back = reversed(a);
    const bool in_body = o.axis_frame == frame::body;
    quat<T> d = in_body ? hamilton(back, b) : hamilton(b, back);
    d.w = d.w + T(0);
    const bool flip = (d.w < 0) != o.long_way;
    if (flip) d = minus(d);

    const half_twist<T> twist = half_twist_about(axis, d, threshold_of<T>(o));
    const T u = (axis.x * d.x + axis.y * d.y) + axis.z * d.z;
    const vec3<T> l{axis.x, axis.y, axis.z};
    const vec3<T> p{d.x - u * l.x, d.y - u * l.y, d.z - u * l.z}, k = cross(l, p);
    const T swing_cosine = twist.cosine * d.w + twist.sine * u;
    const T pp = floored((p.x * p.x + p.y * p.y) + p.z * p.z), length = std::sqrt(pp);
    const T whole = std::sqrt(swing_cosine * swing_cosine + pp);
    const sine_cosine<T> f = part_of_turn(swing_cosine, length, whole, s, o.motion);
    const sine_cosine<T> g = part_of_turn(twist.cosine, twist.sine, T(1), t, o.motion);
    const T across = f.sine / length, on_axis = f.cosine * g.sine;
    const T on_p = across * (twist.cosine * g.cosine + twist.sine * g.sine);
    const T on_k = across * (twist.sine * g.cosine - twist.cosine * g.sine);
    const quat<T> e{(on_axis * l.x + on_p * p.x) + on_k * k.x, (on_axis * l.y + on_p * p.y) + on_k * k.y,
                    (on_axis * l.z + on_p * p.z) + on_k * k.z, f.cosine * g.cosine};
    const quat<T> between = unit_of(in_body ? hamilton(a, e) : hamilton(e, a));
    return with_ends(between, s == 0 && t == 0, a, s == 1 && t == 1, flip ? minus(b) : b);
}

template <class T, class Between>
status between_all(const quat_view<const T>& a, const quat_view<const T>& b, const parameter<T>& t,
                   const quat_view<T>& out, const options& o, Between between) {
    return for_each<T>(o, std::tuple(a, b, t), std::tuple(out), [&](std::size_t i) {
        write(out, i, between(read(a, i), read(b, i), read(t, i), o.long_way));
    });
}

template <class T>
status sterp_all(const quat_view<const T>& a, const quat_view<const T>& b, const twist_axis<T>& axis,
                 const parameter<T>& swing, const parameter<T>& twist, const quat_view<T>& out,
                 const options& o) {
    const twist_axis<T> vector = as_vector(axis);
    const auto each = [&](std::size_t i, const unit_axis<T>& l) {
        write(out, i, sterp_of(read(a, i), read(b, i), l, read(swing, i), read(twist, i), o));
    };
    if (vector.kind == twist_axis<T>::form::per_element)
        return for_each<T>(o, std::tuple(a, b, vector, swing, twist), std::tuple(out),
                           [&](std::size_t i) { each(i, normalized(read(vector.per_element, i))); });
    unit_axis<T> unit{};
    (void)make_unit(vector.uniform, unit);
    return for_each<T>(
        o, std::tuple(a, b, vector, swing, twist), std::tuple(out), [&](std::size_t i) { each(i, unit); },
        check(axis.coordinate));
}

}  // namespace

status slerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options o) noexcept {
    return between_all<float>(a, b, t, out, o, slerp_of<float>);
}
status nlerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options o) noexcept {
    return between_all<float>(a, b, t, out, o, nlerp_of<float>);
}
status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& t, const quat_view<float>& out, options o) noexcept {
    return sterp_all<float>(a, b, axis, t, t, out, o);
}
status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& swing, const parameter<float>& twist, const quat_view<float>& out,
             options o) noexcept {
    return sterp_all<float>(a, b, axis, swing, twist, out, o);
}
status slerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options o) noexcept {
    return between_all<double>(a, b, t, out, o, slerp_of<double>);
}
status nlerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options o) noexcept {
    return between_all<double>(a, b, t, out, o, nlerp_of<double>);
}
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& t, const quat_view<double>& out,
             options o) noexcept {
    return sterp_all<double>(a, b, axis, t, t, out, o);
}
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& swing, const parameter<double>& twist,
             const quat_view<double>& out, options o) noexcept {
    return sterp_all<double>(a, b, axis, swing, twist, out, o);
}

}  // namespace swivel::reference
