#include "swivel/reference.hpp"

#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"

// from_ and to_ axis_angle, spinor, matrix, euler.

namespace swivel::reference {

namespace {

template <class T>
quat<T> rotation_about(axis a, T radians) {
    const sine_cosine<T> h = sincos_of(T(0.5) * radians);
    const T zero = T(0) * std::fabs(h.sine);
    return {a == axis::x ? h.sine : zero, a == axis::y ? h.sine : zero, a == axis::z ? h.sine : zero,
            h.cosine};
}

template <class T>
quat<T> rotation_about(const unit_axis<T>& a, T radians) {
    const sine_cosine<T> h = sincos_of(T(0.5) * radians);
    return {h.sine * a.x, h.sine * a.y, h.sine * a.z, h.cosine};
}

// About an axis that may be zero.
template <class T>
quat<T> rotation_about(const vec3<T>& v, T radians) {
    const unit_axis<T> a = normalized(v);
    quat<T> q = rotation_about(a, radians);
    if (a.x == 0 && a.y == 0 && a.z == 0) q.w = 1;
    q.w = q.w + T(0) * ((q.x + q.y) + q.z);
    return q;
}

template <class T>
struct axis_and_angle {
    vec3<T> a;
    T radians;
};

template <class T>
axis_and_angle<T> axis_and_angle_of(const quat<T>& q) {
    const T scale = scale_for({std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
    const vec3<T> v{q.x * scale, q.y * scale, q.z * scale};
    const T squared = (v.x * v.x + v.y * v.y) + v.z * v.z, root = std::sqrt(squared);
    const T poison = T(0) * q.w + T(0) * squared;
    if (squared == 0) return {{1 + poison, poison, poison}, 2 * atan2_of(T(0), q.w) + poison};
    // Halved, since the reciprocal of the scale may be too small for a normal number.
    const T length = T(0.5) * root * (2 / scale);
    return {{v.x / root + poison, v.y / root + poison, v.z / root + poison},
            2 * atan2_of(length, q.w) + poison};
}

// The column of 4 q q^T whose diagonal element is the sum of 1 and what is positive of the matrix's diagonal.
template <class T>
quat<T> column_of(const matrix3<T>& m) {
    const T z = std::fabs(m.zz) + 1;
    if (m.zz < 0) {
        if (m.xx > m.yy) return {(m.xx - m.yy) + z, m.yx + m.xy, m.xz + m.zx, m.zy - m.yz};
        return {m.yx + m.xy, (m.yy - m.xx) + z, m.zy + m.yz, m.xz - m.zx};
    }
    if (m.xx < -m.yy) return {m.xz + m.zx, m.zy + m.yz, (-m.xx - m.yy) + z, m.yx - m.xy};
    return {m.zy - m.yz, m.xz - m.zx, m.yx - m.xy, (m.xx + m.yy) + z};
}

template <class T>
quat<T> rotation_of(const matrix3<T>& m) {
    const quat<T> c = column_of(m);
    const T root = std::sqrt(finite_or_nan(dot(c, c))), sign = c.w < 0 ? T(-1) : T(1);
    return {sign * (c.x / root), sign * (c.y / root), sign * (c.z / root), std::fabs(c.w / root)};
}

template <class T>
matrix3<T> matrix_of(const quat<T>& q) {
    const T x2 = q.x * q.x, y2 = q.y * q.y, z2 = q.z * q.z, w2 = q.w * q.w;
    const T squared = finite_or_nan((x2 + w2) + (y2 + z2));
    if (squared <= constants<T>::pole_floor) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const T reciprocal = 1 / squared, scale = reciprocal + reciprocal;
    const T X = scale * q.x, Y = scale * q.y, Z = scale * q.z;
    return {((x2 + w2) - (y2 + z2)) * reciprocal + 0, X * q.y - Z * q.w, X * q.z + Y * q.w, X * q.y + Z * q.w,
            ((y2 + w2) - (x2 + z2)) * reciprocal + 0, Y * q.z - X * q.w, X * q.z - Y * q.w, Y * q.z + X * q.w,
            ((z2 + w2) - (x2 + y2)) * reciprocal + 0};
}

// The components about the first and second axis and the one that is left. Of an odd order i j = -k, which k and its
// angle make up for by their signs. The angles are placed by axis, those of proper orders one after the other.
constexpr const char* axes_of_orders[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};

int axis_of(euler_order order, int k) { return axes_of_orders[static_cast<int>(order) % 6][k] - 'x'; }

bool is_odd(euler_order order) {
    const int axes = static_cast<int>(order) % 6;
    return axes == 1 || axes == 2 || axes == 5;
}

bool is_proper(euler_order order) { return order >= euler_order::xyx; }

int place_of_angle(euler_order order, int k) { return is_proper(order) ? k : axis_of(order, k); }

template <class T>
quat<T> rotation_by(const vec3<T>& radians, euler_order order) {
    const T angles[] = {radians.x, radians.y, radians.z}, sign = is_odd(order) ? T(-1) : T(1);
    const int i = axis_of(order, 0), j = axis_of(order, 1), k = axis_of(order, 2);
    const auto [si, ci] = sincos_of(T(0.5) * angles[place_of_angle(order, 0)]);
    const auto [sj, cj] = sincos_of(T(0.5) * angles[place_of_angle(order, 1)]);
    const auto [sk, ck] = sincos_of(T(0.5) * angles[place_of_angle(order, 2)]);
    T v[3];
    if (is_proper(order)) {
        v[i] = (ci * cj) * sk + (si * cj) * ck;
        v[j] = (si * sj) * sk + (ci * sj) * ck;
        v[k] = (ci * sj) * (-sign * sk) + (si * sj) * (sign * ck);
        return {v[0], v[1], v[2], (ci * cj) * ck - (si * cj) * sk};
    }
    v[i] = (ci * sj) * (sign * sk) + (si * cj) * ck;
    v[j] = (ci * sj) * ck - (si * cj) * (sign * sk);
    v[k] = (ci * cj) * sk + (si * sj) * (sign * ck);
    return {v[0], v[1], v[2], (ci * cj) * ck - (si * sj) * (sign * sk)};
}

// Whether the point is the one of (x, y) and (-x, -y) that is turned round, which brings its angle to [-pi/2,
// pi/2].
template <class T>
bool is_turned(T y, T x) {
    return std::signbit(x == 0 ? y : x);
}

template <class T>
T half_plane_angle(T y, T x) {
    return atan2_of(is_turned(y, x) ? -y : y, std::fabs(x));
}

// By pi to the other side of 0; 0 becomes pi.
template <class T>
T half_turn(T angle) {
    using C = constants<T>;
    const T sign = angle > 0 ? T(1) : T(-1);
    return (angle - sign * (2 * C::half_pi)) - sign * (2 * C::half_pi_rest);
}

template <class T>
vec3<T> angles_of(const quat<T>& q, euler_order order) {
    const T v[] = {q.x, q.y, q.z}, sign = is_odd(order) ? T(-1) : T(1);
    const T i = v[axis_of(order, 0)], j = v[axis_of(order, 1)], k = sign * v[axis_of(order, 2)], w = q.w;
    const bool proper = is_proper(order);
    const T px = proper ? w : w + j, py = proper ? i : i + k, mx = proper ? j : w - j,
            my = proper ? k : i - k;
    const T p_squared = py * py + px * px, m_squared = my * my + mx * mx, both = p_squared + m_squared;
    const T poison = T(0) * both;

    T sum = half_plane_angle(py, px), difference = half_plane_angle(my, mx);
    const T limit = constants<T>::pole_threshold * both + constants<T>::pole_floor;
    const bool no_difference = m_squared <= limit, no_sum = p_squared <= limit;
    if (no_difference) difference = sum;
    if (no_sum) sum = difference;
    T first = sum + difference, third = sum - difference;
    if (!no_difference && !no_sum && is_turned(py, px) != is_turned(my, mx)) {
        first = half_turn(first);
        third = half_turn(third);
    }
    const T lengths = std::sqrt(p_squared) * std::sqrt(m_squared);
    const T second =
        proper ? atan2_of(2 * lengths, p_squared - m_squared) : atan2_of(2 * (i * k + w * j), lengths);
    T angles[3];
    angles[place_of_angle(order, 0)] = first + poison;
    angles[place_of_angle(order, 1)] = second + poison;
    angles[place_of_angle(order, 2)] = (proper ? third : sign * third) + poison;
    return {angles[0], angles[1], angles[2]};
}

template <class T>
status from_axis_angle_all(const twist_axis<T>& a, const scalar_view<const T>& radians, const quat_view<T>& q,
                           const options& o) {
    using form = typename twist_axis<T>::form;
    if (a.kind == form::per_element)
        return for_each<T>(o, std::tuple(radians, a), std::tuple(q), [&](std::size_t i) {
            write(q, i, rotation_about(read(a.per_element, i), read(radians, i)));
        });
    unit_axis<T> unit{};
    if (a.kind == form::uniform) make_unit(a.uniform, unit);
    return for_each<T>(o, std::tuple(radians, a), std::tuple(q), [&](std::size_t i) {
        const T angle = read(radians, i);
        write(q, i,
              a.kind == form::uniform ? rotation_about(unit, angle) : rotation_about(a.coordinate, angle));
    });
}

template <class T>
status to_axis_angle_all(const quat_view<const T>& q, const vec3_view<T>& a, const scalar_view<T>& radians,
                         const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(a, radians), [&](std::size_t i) {
        const axis_and_angle<T> found = axis_and_angle_of(read(q, i));
        write(a, i, found.a);
        write(radians, i, found.radians);
    });
}

template <class T>
status from_spinor_all(const spinor_view<const T>& s, const quat_view<T>& q, const options& o) {
    return for_each<T>(o, std::tuple(s), std::tuple(q), [&](std::size_t i) {
        const auto at = [&](const T* first) { return *element(first, i, s.stride); };
        write(q, i, quat<T>{-at(s.c), -at(s.d), -at(s.b), at(s.a)});
    });
}

template <class T>
status to_spinor_all(const quat_view<const T>& q, const spinor_view<T>& s, const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(s), [&](std::size_t i) {
        const quat<T> in = read(q, i);
        *element(s.a, i, s.stride) = in.w;
        *element(s.b, i, s.stride) = -in.z;
        *element(s.c, i, s.stride) = -in.x;
        *element(s.d, i, s.stride) = -in.y;
    });
}

template <class T>
status from_matrix_all(const matrix_view<const T>& m, const quat_view<T>& q, const options& o) {
    return for_each<T>(o, std::tuple(m), std::tuple(q),
                       [&](std::size_t i) { write(q, i, rotation_of(read(m, i))); });
}

template <class T>
status to_matrix_all(const quat_view<const T>& q, const matrix_view<T>& m, const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(m),
                       [&](std::size_t i) { write(m, i, matrix_of(read(q, i))); });
}

template <class T>
status from_euler_all(const vec3_view<const T>& radians, euler_order order, const quat_view<T>& q,
                      const options& o) {
    return for_each<T>(
        o, std::tuple(radians), std::tuple(q),
        [&](std::size_t i) { write(q, i, rotation_by(read(radians, i), order)); }, check(order));
}

template <class T>
status to_euler_all(const quat_view<const T>& q, euler_order order, const vec3_view<T>& radians,
                    const options& o) {
    return for_each<T>(
        o, std::tuple(q), std::tuple(radians),
        [&](std::size_t i) { write(radians, i, angles_of(read(q, i), order)); }, check(order));
}

}  // namespace

status from_axis_angle(const twist_axis<float>& a, const scalar_view<const float>& radians,
                       const quat_view<float>& q, options o) noexcept {
    return from_axis_angle_all<float>(a, radians, q, o);
}
status from_axis_angle(const twist_axis<double>& a, const scalar_view<const double>& radians,
                       const quat_view<double>& q, options o) noexcept {
    return from_axis_angle_all<double>(a, radians, q, o);
}
status to_axis_angle(const quat_view<const float>& q, const vec3_view<float>& a,
                     const scalar_view<float>& radians, options o) noexcept {
    return to_axis_angle_all<float>(q, a, radians, o);
}
status to_axis_angle(const quat_view<const double>& q, const vec3_view<double>& a,
                     const scalar_view<double>& radians, options o) noexcept {
    return to_axis_angle_all<double>(q, a, radians, o);
}
status from_spinor(const spinor_view<const float>& s, const quat_view<float>& q, options o) noexcept {
    return from_spinor_all<float>(s, q, o);
}
status from_spinor(const spinor_view<const double>& s, const quat_view<double>& q, options o) noexcept {
    return from_spinor_all<double>(s, q, o);
}
status to_spinor(const quat_view<const float>& q, const spinor_view<float>& s, options o) noexcept {
    return to_spinor_all<float>(q, s, o);
}
status to_spinor(const quat_view<const double>& q, const spinor_view<double>& s, options o) noexcept {
    return to_spinor_all<double>(q, s, o);
}
status from_matrix(const matrix_view<const float>& m, const quat_view<float>& q, options o) noexcept {
    return from_matrix_all<float>(m, q, o);
}
status from_matrix(const matrix_view<const double>& m, const quat_view<double>& q, options o) noexcept {
    return from_matrix_all<double>(m, q, o);
}
status to_matrix(const quat_view<const float>& q, const matrix_view<float>& m, options o) noexcept {
    return to_matrix_all<float>(q, m, o);
}
status to_matrix(const quat_view<const double>& q, const matrix_view<double>& m, options o) noexcept {
    return to_matrix_all<double>(q, m, o);
}
status from_euler(const vec3_view<const float>& radians, euler_order order, const quat_view<float>& q,
                  options o) noexcept {
    return from_euler_all<float>(radians, order, q, o);
}
status from_euler(const vec3_view<const double>& radians, euler_order order, const quat_view<double>& q,
                  options o) noexcept {
    return from_euler_all<double>(radians, order, q, o);
}
status to_euler(const quat_view<const float>& q, euler_order order, const vec3_view<float>& radians,
                options o) noexcept {
    return to_euler_all<float>(q, order, radians, o);
}
status to_euler(const quat_view<const double>& q, euler_order order, const vec3_view<double>& radians,
                options o) noexcept {
    return to_euler_all<double>(q, order, radians, o);
}

}  // namespace swivel::reference
