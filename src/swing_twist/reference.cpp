#include "src/swing_twist/reference.hpp"

#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"
#include "swivel/reference.hpp"

// decompose, twist, swing, twist_angle and compose, one element at a time, the axis and the product spelled
// out.

namespace swivel::reference {

namespace {

using reference::half_twist_about;

template <class T>
half_twist<T> positive(const half_twist<T>& h, T w) {
    return {std::fabs(h.cosine), std::signbit(w) ? -h.sine : h.sine};
}

// (A; B, C), cyclic.
template <class T>
struct cyclic {
    T a, b, c, w;
};

template <class T>
cyclic<T> about(axis a, const quat<T>& q) {
    switch (a) {
        case axis::x:
            return {q.x, q.y, q.z, q.w};
        case axis::y:
            return {q.y, q.z, q.x, q.w};
        default:
            return {q.z, q.x, q.y, q.w};
    }
}

template <class T>
quat<T> from(axis a, const cyclic<T>& q) {
    switch (a) {
        case axis::x:
            return {q.a, q.b, q.c, q.w};
        case axis::y:
            return {q.c, q.a, q.b, q.w};
        default:
            return {q.b, q.c, q.a, q.w};
    }
}

template <class T>
T norm_squared_of(const cyclic<T>& q) {
    return (q.b * q.b + q.c * q.c) + (q.a * q.a + q.w * q.w);
}

template <class T>
half_twist<T> half_twist_about(axis a, const quat<T>& q, T threshold) {
    const cyclic<T> p = about(a, q);
    return half_twist_of(p.w, p.a, p.a * p.a + p.w * p.w, norm_squared_of(p), threshold);
}

template <class T>
factors<T> factors_about(axis a, const quat<T>& q, const half_twist<T>& h, product order) {
    const auto [A, B, C, w] = about(a, q);
    const T tc = h.cosine, ts = h.sine, sc = tc * w + ts * A;
    if (order == product::swing_twist) return {tc * B - ts * C, tc * C + ts * B, sc, ts, tc};
    return {tc * B + ts * C, tc * C - ts * B, sc, ts, tc};
}

// S = (c w + d u, c v - c u a + d a x v), where d u is written as T.v, which the rounding of u does not
// enter; the other order of the product has v x a.
template <class T>
quat<T> swing_about(const unit_axis<T>& a, const quat<T>& q, const half_twist<T>& h, product order) {
    const vec3<T> v{q.x, q.y, q.z};
    const vec3<T> t{h.sine * a.x, h.sine * a.y, h.sine * a.z};
    const T u = (a.x * q.x + a.y * q.y) + a.z * q.z;
    const vec3<T> turned = order == product::swing_twist ? cross(t, v) : cross(v, t);
    const T along = h.cosine * u;
    return {(h.cosine * v.x - along * a.x) + turned.x, (h.cosine * v.y - along * a.y) + turned.y,
            (h.cosine * v.z - along * a.z) + turned.z,
            h.cosine * q.w + ((t.x * v.x + t.y * v.y) + t.z * v.z)};
}

template <class T>
quat<T> twist_about(const unit_axis<T>& a, const quat<T>&, const half_twist<T>& h) {
    const vec3<T> t{h.sine * a.x, h.sine * a.y, h.sine * a.z};
    return {t.x, t.y, t.z, h.cosine};
}

// The component of a swing along the axis, and those of a twist across it: 0, but NaN where q has a NaN or an
// infinity.
template <class T>
T zero_or_nan(axis a, const quat<T>& q) {
    return T(0) * norm_squared_of(about(a, q));
}

template <class T>
quat<T> swing_about(axis a, const quat<T>& q, const half_twist<T>& h, product order) {
    const factors<T> f = factors_about(a, q, h, order);
    return from<T>(a, {zero_or_nan(a, q), f.s1, f.s2, f.sc});
}

template <class T>
quat<T> twist_about(axis a, const quat<T>& q, const half_twist<T>& h) {
    return from<T>(a, {h.sine, zero_or_nan(a, q), zero_or_nan(a, q), h.cosine});
}

template <class T>
quat<T> compose_about(axis a, const factors<T>& f, product order) {
    const T zero = T(0) * (f.s1 + f.s2) + (T(0) * f.sc + (T(0) * f.ts + T(0) * f.tc));
    const T A = f.sc * f.ts + zero, w = f.sc * f.tc + zero;
    if (order == product::swing_twist)
        return from<T>(a, {A, (f.s1 * f.tc + f.s2 * f.ts) + zero, (f.s2 * f.tc - f.s1 * f.ts) + zero, w});
    return from<T>(a, {A, (f.s1 * f.tc - f.s2 * f.ts) + zero, (f.s2 * f.tc + f.s1 * f.ts) + zero, w});
}

// Calls body(i, q, axis) for every element, the axis being an `axis` or a unit vector.
template <class T, class Body, class... Out>
status for_each_about_axis(const quat_view<const T>& q, const twist_axis<T>& a, const options& o, Body body,
                           const Out&... out) {
    unit_axis<T> unit{};
    if (a.kind == twist_axis<T>::form::uniform) make_unit(a.uniform, unit);
    return for_each<T>(o, std::tuple(q, a), std::tuple(out...), [&](std::size_t i) {
        switch (a.kind) {
            case twist_axis<T>::form::coordinate:
                body(i, read(q, i), a.coordinate);
                break;
            case twist_axis<T>::form::uniform:
                body(i, read(q, i), unit);
                break;
            case twist_axis<T>::form::per_element:
                body(i, read(q, i), normalized(read(a.per_element, i)));
                break;
        }
    });
}

template <class T, class... Signs>
status decompose_all(const quat_view<const T>& q, const twist_axis<T>& a, const quat_view<T>& swing,
                     const quat_view<T>& twist, const options& o, const Signs&... signs) {
    const auto body = [&](std::size_t i, const quat<T>& in, const auto& about_axis) {
        half_twist<T> h = half_twist_about(about_axis, in, threshold_of<T>(o));
        write(swing, i, swing_about(about_axis, in, h, o.order));
        if (o.positive_twist || sizeof...(signs) != 0) h = positive(h, in.w);
        write(twist, i, twist_about(about_axis, in, h));
        ((*element(signs.data, i, signs.stride) = std::copysign(T(1), in.w)), ...);
    };
    return for_each_about_axis(q, a, o, body, swing, twist, signs...);
}

template <class T, class... Signs>
status decompose_all(const quat_view<const T>& q, axis a, const factor_view<T>& out, const options& o,
                     const Signs&... signs) {
    const auto body = [&](std::size_t i, const quat<T>& in, const auto&) {
        half_twist<T> h = half_twist_about(a, in, threshold_of<T>(o));
        const factors<T> f = factors_about(a, in, h, o.order);
        if (o.positive_twist || sizeof...(signs) != 0) h = positive(h, in.w);
        out.s1[i] = f.s1;
        out.s2[i] = f.s2;
        out.sc[i] = f.sc;
        out.ts[i] = h.sine;
        out.tc[i] = h.cosine;
        ((*element(signs.data, i, signs.stride) = std::copysign(T(1), in.w)), ...);
    };
    return for_each_about_axis(q, twist_axis<T>(a), o, body, out, signs...);
}

template <class T>
status twist_all(const quat_view<const T>& q, const twist_axis<T>& a, const quat_view<T>& out,
                 const options& o) {
    const auto body = [&](std::size_t i, const quat<T>& in, const auto& about_axis) {
        half_twist<T> h = half_twist_about(about_axis, in, threshold_of<T>(o));
        if (o.positive_twist) h = positive(h, in.w);
        write(out, i, twist_about(about_axis, in, h));
    };
    return for_each_about_axis(q, a, o, body, out);
}

template <class T>
status swing_all(const quat_view<const T>& q, const twist_axis<T>& a, const quat_view<T>& out,
                 const options& o) {
    const auto body = [&](std::size_t i, const quat<T>& in, const auto& about_axis) {
        const half_twist<T> h = half_twist_about(about_axis, in, threshold_of<T>(o));
        write(out, i, swing_about(about_axis, in, h, o.order));
    };
    return for_each_about_axis(q, a, o, body, out);
}

template <class T>
status twist_angle_all(const quat_view<const T>& q, const twist_axis<T>& a, const scalar_view<T>& radians,
                       const options& o) {
    const auto body = [&](std::size_t i, const quat<T>& in, const auto& about_axis) {
        half_twist<T> h = half_twist_about(about_axis, in, threshold_of<T>(o));
        if (o.positive_twist) h = positive(h, in.w);
        // A sine of -0 beside a negative cosine would give -2 pi, which is outside the range.
        *element(radians.data, i, radians.stride) = 2 * atan2_of(h.sine + T(0), h.cosine);
    };
    return for_each_about_axis(q, a, o, body, radians);
}

template <class T, class... Signs>
bool any_negative([[maybe_unused]] std::size_t i, const Signs&... signs) {
    return (std::signbit(*element(signs.data, i, signs.stride)) || ... || false);
}

template <class T, class... Signs>
status compose_all(const quat_view<const T>& swing, const quat_view<const T>& twist, const quat_view<T>& q,
                   const options& o, const Signs&... signs) {
    return for_each<T>(o, std::tuple(swing, twist, signs...), std::tuple(q), [&](std::size_t i) {
        const quat<T> s = read(swing, i);
        quat<T> t = read(twist, i);
        if (any_negative<T>(i, signs...)) t = {-t.x, -t.y, -t.z, -t.w};
        write(q, i, o.order == product::swing_twist ? multiply(s, t) : multiply(t, s));
    });
}

template <class T, class... Signs>
status compose_all(const factor_view<const T>& in, axis a, const quat_view<T>& q, const options& o,
                   const Signs&... signs) {
    return for_each<T>(
        o, std::tuple(in, signs...), std::tuple(q),
        [&](std::size_t i) {
            factors<T> f = read(in, i);
            if (any_negative<T>(i, signs...)) {
                f.ts = -f.ts;
                f.tc = -f.tc;
            }
            write(q, i, compose_about(a, f, o.order));
        },
        check(a));
}

}  // namespace

status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, options o) noexcept {
    return decompose_all<float>(q, a, swing, twist, o);
}
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist, options o) noexcept {
    return decompose_all<double>(q, a, swing, twist, o);
}
status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const scalar_view<float>& signs, options o) noexcept {
    return decompose_all<float>(q, a, swing, twist, o, signs);
}
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const scalar_view<double>& signs, options o) noexcept {
    return decompose_all<double>(q, a, swing, twist, o, signs);
}
status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out, options o) noexcept {
    return decompose_all<float>(q, a, out, o);
}
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 options o) noexcept {
    return decompose_all<double>(q, a, out, o);
}
status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out,
                 const scalar_view<float>& signs, options o) noexcept {
    return decompose_all<float>(q, a, out, o, signs);
}
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 const scalar_view<double>& signs, options o) noexcept {
    return decompose_all<double>(q, a, out, o, signs);
}
status twist(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& out,
             options o) noexcept {
    return twist_all<float>(q, a, out, o);
}
status twist(const quat_view<const double>& q, const twist_axis<double>& a, const quat_view<double>& out,
             options o) noexcept {
    return twist_all<double>(q, a, out, o);
}
status swing(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& out,
             options o) noexcept {
    return swing_all<float>(q, a, out, o);
}
status swing(const quat_view<const double>& q, const twist_axis<double>& a, const quat_view<double>& out,
             options o) noexcept {
    return swing_all<double>(q, a, out, o);
}
status twist_angle(const quat_view<const float>& q, const twist_axis<float>& a,
                   const scalar_view<float>& radians, options o) noexcept {
    return twist_angle_all<float>(q, a, radians, o);
}
status twist_angle(const quat_view<const double>& q, const twist_axis<double>& a,
                   const scalar_view<double>& radians, options o) noexcept {
    return twist_angle_all<double>(q, a, radians, o);
}
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const quat_view<float>& q, options o) noexcept {
    return compose_all<float>(swing, twist, q, o);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const quat_view<double>& q, options o) noexcept {
    return compose_all<double>(swing, twist, q, o);
}
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const scalar_view<const float>& signs, const quat_view<float>& q, options o) noexcept {
    return compose_all<float>(swing, twist, q, o, signs);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const scalar_view<const double>& signs, const quat_view<double>& q, options o) noexcept {
    return compose_all<double>(swing, twist, q, o, signs);
}
status compose(const factor_view<const float>& factors, axis a, const quat_view<float>& q,
               options o) noexcept {
    return compose_all<float>(factors, a, q, o);
}
status compose(const factor_view<const double>& factors, axis a, const quat_view<double>& q,
               options o) noexcept {
    return compose_all<double>(factors, a, q, o);
}
status compose(const factor_view<const float>& factors, axis a, const scalar_view<const float>& signs,
               const quat_view<float>& q, options o) noexcept {
    return compose_all<float>(factors, a, q, o, signs);
}
status compose(const factor_view<const double>& factors, axis a, const scalar_view<const double>& signs,
               const quat_view<double>& q, options o) noexcept {
    return compose_all<double>(factors, a, q, o, signs);
}

}  // namespace swivel::reference
