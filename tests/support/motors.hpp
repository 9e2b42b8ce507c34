#ifndef SWIVEL_TESTS_SUPPORT_MOTORS_HPP
#define SWIVEL_TESTS_SUPPORT_MOTORS_HPP

// Motors to test with, and rigid motions in long double as a rotation and a translation, taken apart as
// Chasles does: no dual quaternion takes part in the judging.

#include <numbers>

#include "support/buffers.hpp"
#include "support/interpolation.hpp"
#include "support/vectors.hpp"

namespace swivel::tests {

struct motion {
    exact_quat q;
    exact_vec3 t;
};

inline exact_vec3 sum(const exact_vec3& a, long double s, const exact_vec3& b) {
    return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
inline exact_vec3 moved(const motion& m, const exact_vec3& p) { return sum(rotated(m.q, p), 1, m.t); }

// First b, then a.
inline motion after(const motion& a, const motion& b) { return {times(a.q, b.q), moved(a, b.t)}; }
inline motion inverse(const motion& m) {
    const exact_quat back = conjugate(m.q);
    return {back, sum({0, 0, 0}, -1, rotated(back, m.t))};
}
inline motion negative(const motion& m) { return {sum(-1, m.q, 0, m.q), m.t}; }

inline exact_quat dual_part(const motion& m) {
    const exact_quat d = times(exact_quat{m.t.x, m.t.y, m.t.z, 0}, m.q);
    return sum(0.5L, d, 0, d);
}

// The motion of a dual quaternion that is one to rounding.
template <class T>
motion motion_of(const dual_quaternion<T>& m) {
    const exact_quat q = unit_of(m.r), d = widen<long double>(m.d);
    const long double length = norm(widen<long double>(m.r));
    const exact_quat t = times(d, conjugate(q));
    return {q, {2 * t.x / length, 2 * t.y / length, 2 * t.z / length}};
}

// The s-th part: on the screw about an axis through a point c, by s times the angle and s times the way.
inline motion power(const motion& m, long double s) {
    const long double sine = std::sqrt(m.q.x * m.q.x + m.q.y * m.q.y + m.q.z * m.q.z);
    if (sine == 0 && m.q.w > 0) return {{0, 0, 0, 1}, sum({0, 0, 0}, s, m.t)};
    const exact_vec3 u{m.q.x / sine, m.q.y / sine, m.q.z / sine};
    const long double half = std::atan2(sine, m.q.w), way = dotted(m.t, u);
    const exact_vec3 across = sum(m.t, -way, u), aside = crossed(u, across);
    // c is half of `across` and of `aside` times the cotangent of half the angle.
    const exact_vec3 c = sum({0.5L * across.x, 0.5L * across.y, 0.5L * across.z}, 0.5L * m.q.w / sine, aside);
    const long double part = s * half, versine = 2 * std::sin(part) * std::sin(part);
    const exact_vec3 t = sum(sum(sum({0, 0, 0}, versine, c), -std::sin(2 * part), crossed(u, c)), s * way, u);
    return {{std::sin(part) * u.x, std::sin(part) * u.y, std::sin(part) * u.z, std::cos(part)}, t};
}

// How far the parts of a dual quaternion are from those of the motion, in units of rounding; that of the dual
// part, as far as the size of the translations is not to blame.
struct motor_error {
    double real, dual;
};

template <class T>
motor_error distance(const dual_quaternion<T>& got, const motion& want, long double size) {
    const double unit = rounding_unit<T>;
    return {
        static_cast<double>(norm(minus(widen<long double>(got.r), want.q))) / unit,
        static_cast<double>(norm(minus(widen<long double>(got.d), dual_part(want))) / std::max(1.0L, size)) /
            unit};
}

template <class T>
dual_quaternion<T> rounded(const motion& m) {
    const exact_quat d = dual_part(m);
    return {{static_cast<T>(m.q.x), static_cast<T>(m.q.y), static_cast<T>(m.q.z), static_cast<T>(m.q.w)},
            {static_cast<T>(d.x), static_cast<T>(d.y), static_cast<T>(d.z), static_cast<T>(d.w)}};
}

inline motion random_motion(generator& g, double translation) {
    const vec3<double> t = random_direction<double>(g);
    const auto along = [&](double a) { return static_cast<long double>(a) * translation; };
    return {unit_of(random_rotation<double>(g)), {along(t.x), along(t.y), along(t.z)}};
}

template <class T>
dual_quaternion<T> random_motor(generator& g, double translation) {
    return rounded<T>(random_motion(g, translation));
}

// By that half of an angle, about a random axis.
inline motion motion_by(generator& g, long double half, double translation) {
    motion m = random_motion(g, translation);
    const vec3<double> u = random_direction<double>(g);
    m.q = unit_of(exact_quat{std::sin(half) * u.x, std::sin(half) * u.y, std::sin(half) * u.z, 0});
    const long double s = std::sin(half);
    m.q = {s * m.q.x, s * m.q.y, s * m.q.z, std::cos(half)};
    return m;
}

// Of all kinds: random, tiny, nearly half and nearly whole turns, pure translations.
inline motion any_motion(generator& g) {
    const double translation = uniform(g, 0, 4);
    const auto tiny = [&] { return std::ldexp(uniform(g, 0.5, 1), -static_cast<int>(g() % 60)); };
    const long double pi = std::numbers::pi_v<long double>;
    switch (g() % 6) {
        case 0:
            return motion_by(g, tiny(), translation);
        case 1:
            return motion_by(g, pi / 2 + (g() % 2 != 0 ? tiny() : -tiny()), translation);
        case 2: {
            motion m = random_motion(g, translation);
            m.q = {0, 0, 0, 1};
            return m;
        }
        default:
            return random_motion(g, translation);
    }
}

// Finite, and not always a motor: a rotation that is a corner, -1, minus a translation, nothing at all.
template <class T>
dual_quaternion<T> corner_motor(generator& g, const quat<T>& q) {
    const quat<T> none{0, 0, 0, 0};
    const vec3<T> t = random_direction<T>(g);
    const auto turn = [](T w) { return quat<T>{0, 0, 0, w}; };
    switch (g() % 8) {
        case 0:
            return {turn(1), none};
        case 1:
            return {turn(-1), none};
        case 2:
            return {turn(1), {t.x, t.y, t.z, 0}};
        case 3:
            return {turn(-1), {t.x, t.y, t.z, 0}};
        case 4:
            return {turn(-1), {std::numeric_limits<T>::denorm_min(), 0, 0, 0}};
        case 5:
            return {none, none};
        case 6: {
            const quat<T> d = random_rotation<T>(g);
            return {{std::numeric_limits<T>::denorm_min(), 0, T(-0.0), g() % 2 != 0 ? T(1) : T(-1)}, d};
        }
        default:
            return {q, none};
    }
}

}  // namespace swivel::tests

#endif
