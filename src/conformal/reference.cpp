#include "src/conformal/reference.hpp"

#include "swivel/reference.hpp"

// The algebra of conformal rotors: products, rotors of motions, and points.

namespace swivel::reference {

namespace {

// w - I3 (x, y, z) - (dx, dy, dz) ni - dw I3 ni.
template <class T>
even<T> from_motor_of(const motor<T>& m) {
    const quat<T>&r = m.r, &d = m.d;
    const T bad = zero_or_nan(std::array{r.x, r.y, r.z, r.w, d.x, d.y, d.z, d.w});
    even<T> c;
    c.fill(bad);
    c[0] = bad + r.w;
    c[e23] = bad - r.x;
    c[e13] = bad + r.y;
    c[e12] = bad - r.z;
    c[e14] = c[e15] = bad - d.x;
    c[e24] = c[e25] = bad - d.y;
    c[e34] = c[e35] = bad - d.z;
    c[e1234] = c[e1235] = bad - d.w;
    return c;
}

template <class T>
even<T> from_rotation_of(const quat<T>& q) {
    return from_motor_of(motor<T>{q, {0, 0, 0, 0}});
}

// 1 - t ni / 2.
template <class T>
even<T> from_translation_of(const vec3<T>& t) {
    return from_motor_of(motor<T>{{0, 0, 0, 1}, {T(0.5) * t.x, T(0.5) * t.y, T(0.5) * t.z, 0}});
}

// cosh(L/2) + sinh(L/2) e45 with the factor exp(-L).
template <class T>
even<T> from_dilation_of(T factor) {
    const T bad = zero_or_nan(std::array<T, 1>{factor}), f = factor > 0 ? factor : T(1), root = std::sqrt(f);
    even<T> c;
    c.fill(bad);
    c[0] = T(0.5) * (root + 1 / root) + bad;
    c[e45] = T(0.5) * ((1 - f) / root) + bad;
    return c;
}

// A vector and a part of I3; or, with the sign of the vector changed, a quaternion.
template <class T>
struct paravector {
    vec3<T> v;
    T s;
};

template <class T>
vec3<T> plus(const vec3<T>& a, T by, const vec3<T>& b) {
    return {a.x + by * b.x, a.y + by * b.y, a.z + by * b.z};
}

// a + b x c, with the terms from the left to the right.
template <class T>
vec3<T> plus_cross(const vec3<T>& a, const vec3<T>& b, const vec3<T>& c) {
    return {(a.x + b.y * c.z) - b.z * c.y, (a.y + b.z * c.x) - b.x * c.z, (a.z + b.x * c.y) - b.y * c.x};
}

// The rotor as a fraction (A p + b) / (c p + D) of the point p: A and D are what multiplies 1 and e45, b and
// c ni and no.
template <class T>
vec3<T> transformed(const even<T>& r, const vec3<T>& p) {
    const quat<T> A{r[e2345] - r[e23], r[e13] - r[e1345], r[e1245] - r[e12], r[0] - r[e45]};
    const quat<T> D{-(r[e2345] + r[e23]), r[e13] + r[e1345], -(r[e1245] + r[e12]), r[0] + r[e45]};
    const paravector<T> b{{-(r[e14] + r[e15]), -(r[e24] + r[e25]), -(r[e34] + r[e35])},
                          -(r[e1234] + r[e1235])};
    const paravector<T> c{{r[e14] - r[e15], r[e24] - r[e25], r[e34] - r[e35]}, r[e1234] - r[e1235]};

    const vec3<T> a{A.x, A.y, A.z}, n = plus_cross(plus(b.v, A.w, p), a, p);
    const T nt = ((b.s - A.x * p.x) - A.y * p.y) - A.z * p.z;
    const T qw = ((D.w + c.v.x * p.x) + c.v.y * p.y) + c.v.z * p.z;
    // D - c x p, whose terms are those of p x c with their signs changed twice.
    const vec3<T> d{(D.x - c.v.y * p.z) + c.v.z * p.y, (D.y - c.v.z * p.x) + c.v.x * p.z,
                    (D.z - c.v.x * p.y) + c.v.y * p.x};
    const vec3<T> q = plus(d, -c.s, p);

    const T bad = zero_or_nan(r) + zero_or_nan(std::array<T, 3>{p.x, p.y, p.z});
    const T weight = ((q.x * q.x + q.y * q.y) + q.z * q.z) + qw * qw, scale = 1 / floored(weight) + bad;
    const vec3<T> turned = plus_cross(plus(vec3<T>{qw * n.x, qw * n.y, qw * n.z}, -nt, q), q, n);
    return {scale * turned.x, scale * turned.y, scale * turned.z};
}

template <class T>
status multiply_all(const conformal_view<const T>& a, const conformal_view<const T>& b,
                    const conformal_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(a, b), std::tuple(out),
                       [&](std::size_t i) { write(out, i, product(read(a, i), read(b, i))); });
}

template <class T>
status reverse_all(const conformal_view<const T>& c, const conformal_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(c), std::tuple(out),
                       [&](std::size_t i) { write(out, i, reversed(read(c, i))); });
}

template <class T>
status from_motor_all(const motor_view<const T>& m, const conformal_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(m), std::tuple(out),
                       [&](std::size_t i) { write(out, i, from_motor_of(read(m, i))); });
}

template <class T>
status from_rotation_all(const quat_view<const T>& q, const conformal_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(q), std::tuple(out),
                       [&](std::size_t i) { write(out, i, from_rotation_of(read(q, i))); });
}

template <class T>
status from_translation_all(const vec3_view<const T>& t, const conformal_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(t), std::tuple(out),
                       [&](std::size_t i) { write(out, i, from_translation_of(read(t, i))); });
}

template <class T>
status from_dilation_all(const scalar_view<const T>& factor, const conformal_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(factor), std::tuple(out),
                       [&](std::size_t i) { write(out, i, from_dilation_of(read(factor, i))); });
}

template <class T>
status transform_all(const conformal_view<const T>& r, const vec3_view<const T>& points,
                     const vec3_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(r, points), std::tuple(out),
                       [&](std::size_t i) { write(out, i, transformed(read(r, i), read(points, i))); });
}

}  // namespace

status multiply(const conformal_view<const float>& a, const conformal_view<const float>& b,
                const conformal_view<float>& out, options o) noexcept {
    return multiply_all<float>(a, b, out, o);
}
status multiply(const conformal_view<const double>& a, const conformal_view<const double>& b,
                const conformal_view<double>& out, options o) noexcept {
    return multiply_all<double>(a, b, out, o);
}
status reverse(const conformal_view<const float>& c, const conformal_view<float>& out, options o) noexcept {
    return reverse_all<float>(c, out, o);
}
status reverse(const conformal_view<const double>& c, const conformal_view<double>& out, options o) noexcept {
    return reverse_all<double>(c, out, o);
}
status from_motor(const motor_view<const float>& m, const conformal_view<float>& out, options o) noexcept {
    return from_motor_all<float>(m, out, o);
}
status from_motor(const motor_view<const double>& m, const conformal_view<double>& out, options o) noexcept {
    return from_motor_all<double>(m, out, o);
}
status from_rotation(const quat_view<const float>& q, const conformal_view<float>& out, options o) noexcept {
    return from_rotation_all<float>(q, out, o);
}
status from_rotation(const quat_view<const double>& q, const conformal_view<double>& out,
                     options o) noexcept {
    return from_rotation_all<double>(q, out, o);
}
status from_translation(const vec3_view<const float>& t, const conformal_view<float>& out,
                        options o) noexcept {
    return from_translation_all<float>(t, out, o);
}
status from_translation(const vec3_view<const double>& t, const conformal_view<double>& out,
                        options o) noexcept {
    return from_translation_all<double>(t, out, o);
}
status from_dilation(const scalar_view<const float>& factor, const conformal_view<float>& out,
                     options o) noexcept {
    return from_dilation_all<float>(factor, out, o);
}
status from_dilation(const scalar_view<const double>& factor, const conformal_view<double>& out,
                     options o) noexcept {
    return from_dilation_all<double>(factor, out, o);
}
status transform(const conformal_view<const float>& r, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options o) noexcept {
    return transform_all<float>(r, points, out, o);
}
status transform(const conformal_view<const double>& r, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options o) noexcept {
    return transform_all<double>(r, points, out, o);
}

}  // namespace swivel::reference
