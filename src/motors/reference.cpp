#include "src/exponentials/reference.hpp"

#include "src/reference/elements.hpp"
#include "src/swing_twist/reference.hpp"
#include "swivel/reference.hpp"

// The operations on motors.

namespace swivel::reference {

namespace {

template <class T>
quat<T> plus(const quat<T>& a, const quat<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class T>
quat<T> each(T a) {
    return {a, a, a, a};
}
// NaN in all where poison is not 0.
template <class T>
motor<T> poisoned(const motor<T>& m, T poison) {
    return {plus(m.r, each(poison)), plus(m.d, each(poison))};
}

template <class T>
motor<T> product_of(const motor<T>& a, const motor<T>& b) {
    return {hamilton(a.r, b.r), plus(hamilton(a.r, b.d), hamilton(a.d, b.r))};
}

template <class T>
motor<T> multiply_of(const motor<T>& a, const motor<T>& b) {
    const motor<T> p = product_of(a, b);
    return poisoned(p, T(0) * p.d.x);
}

template <class T>
motor<T> normalized_motor(const motor<T>& m) {
    const bool nothing = m.r == quat<T>{0, 0, 0, 0};
    const T scale =
        nothing ? T(0) : scale_for({std::fabs(m.r.x), std::fabs(m.r.y), std::fabs(m.r.z), std::fabs(m.r.w)});
    const auto times = [](const quat<T>& q, T by) { return quat<T>{q.x * by, q.y * by, q.z * by, q.w * by}; };
    quat<T> r = times(m.r, scale), d = times(m.d, scale);
    if (nothing) r.w = 1;
    const T length = std::sqrt(dot(r, r));
    r = {r.x / length, r.y / length, r.z / length, r.w / length};
    d = {d.x / length, d.y / length, d.z / length, d.w / length};
    const T along = dot(r, d);
    d = {d.x - along * r.x, d.y - along * r.y, d.z - along * r.z, d.w - along * r.w};
    return poisoned(motor<T>{r, d}, zero_or_nan(std::array{m.d.x, m.d.y, m.d.z, m.d.w}));
}

// t q / 2
template <class T>
quat<T> moved(const quat<T>& q, const vec3<T>& t) {
    const T x = T(0.5) * t.x, y = T(0.5) * t.y, z = T(0.5) * t.z;
    return {(x * q.w + y * q.z) - z * q.y, (y * q.w + z * q.x) - x * q.z, (z * q.w + x * q.y) - y * q.x,
            ((0 - x * q.x) - y * q.y) - z * q.z};
}

template <class T>
motor<T> from_rotation_translation_of(const quat<T>& q, const vec3<T>& t) {
    const motor<T> m{q, moved(q, t)};
    const T poison = T(0) * m.d.y + T(0) * m.d.x;
    return poison == 0 ? m : motor<T>{each(poison), each(poison)};
}

// 2 d r* / |r|^2
template <class T>
vec3<T> translation_of(const motor<T>& m) {
    const quat<T>&r = m.r, &d = m.d;
    const T scale = 2 / floored(dot(r, r));
    return {scale * (((r.w * d.x - d.w * r.x) + r.y * d.z) - r.z * d.y),
            scale * (((r.w * d.y - d.w * r.y) + r.z * d.x) - r.x * d.z),
            scale * (((r.w * d.z - d.w * r.z) + r.x * d.y) - r.y * d.x)};
}

template <class T>
vec3<T> transformed(const motor<T>& m, const vec3<T>& p) {
    const vec3<T> v = vector_part(m.r), turned = cross(v, p);
    const vec3<T> c{turned.x + m.d.x, turned.y + m.d.y, turned.z + m.d.z}, across = cross(v, c);
    const auto component = [&](T at, T along, T aside, T part) {
        const T half = (m.r.w * along + aside) - m.d.w * part;
        return finite_or_nan(at + (half + half));
    };
    return {component(p.x, c.x, across.x, v.x), component(p.y, c.y, across.y, v.y),
            component(p.z, c.z, across.z, v.z)};
}

// Whether r is -1 to rounding: the axis is then that of the translation.
template <class T>
bool is_minus_one(const quat<T>& r) {
    const T limit = constants<T>::rounding;
    return r.w < 0 && std::fabs(r.x) <= limit && std::fabs(r.y) <= limit && std::fabs(r.z) <= limit;
}

template <class T>
polar_form<T> polar_of(const motor<T>& a, bool minus_one) {
    return polar(minus_one ? joined(vector_part(a.d), a.r.w) : a.r, T(1));
}

// half of the motion: s s = r and s e + e s = d
template <class T>
motor<T> square_root_of(const motor<T>& a) {
    const bool minus_one = is_minus_one(a.r);
    const polar_form<T> q = polar_of(a, minus_one);
    const sine_cosine<T> h = half_of(minus_one ? T(0) : q.m, q.w);
    const quat<T> r = joined(q.along(h.sine), h.cosine);
    quat<T> d{0, 0, 0, T(0.5) * q.m};
    if (!minus_one) {
        const T inverse = T(0.5) / h.cosine, p = a.d.w * inverse;
        d = {inverse * (a.d.x - p * r.x), inverse * (a.d.y - p * r.y), inverse * (a.d.z - p * r.z),
             T(0.5) * p};
    }
    return poisoned(motor<T>{r, d}, zero_or_nan(std::array{a.d.x, a.d.y, a.d.z, a.d.w}));
}

// m, w: sine and cosine of half the angle; u: the direction of the axis; p: half of the way along it; across:
// m times the moment of the axis.
template <class T>
struct screw {
    T m, w, angle, p;
    vec3<T> u, across;

    T over_m(T part, T limit) const { return m < constants<T>::smallest_normal ? limit : part / m; }
};

template <class T>
screw<T> screw_of(const motor<T>& a, bool near_minus_one) {
    screw<T> s;
    bool nothing = false;
    const vec3<T> v = vector_part(a.r), e = vector_part(a.d);
    if (near_minus_one) {
        const bool minus_one = is_minus_one(a.r);
        const polar_form<T> q = polar_of(a, minus_one);
        s.u = q.along(T(1));
        s.m = minus_one ? T(0) : q.m;
        s.w = q.w;
    } else {
        const T squared = dot(v, v);
        nothing = squared < constants<T>::pole_floor;
        s.m = std::sqrt(floored(squared));
        s.u = {v.x / s.m, v.y / s.m, v.z / s.m};
        s.w = a.r.w;
    }
    s.angle = atan2_of(s.m, s.w);
    s.p = s.w * dot(s.u, e) - (nothing ? T(0) : s.m) * a.d.w;
    const T back = s.p * s.w;
    s.across = {e.x - back * s.u.x, e.y - back * s.u.y, e.z - back * s.u.z};
    return s;
}

template <class T>
motor<T> power_of(const screw<T>& s, T t) {
    const T product = t * s.angle;
    const bool beyond = std::fabs(product) > constants<T>::largest_angle;
    const sine_cosine<T> f = sincos_of(beyond ? T(0) * t : product);
    const T ratio = s.over_m(f.sine, t), along = t * s.p, on_u = along * f.cosine;
    return {{f.sine * s.u.x, f.sine * s.u.y, f.sine * s.u.z, f.cosine},
            {ratio * s.across.x + on_u * s.u.x, ratio * s.across.y + on_u * s.u.y,
             ratio * s.across.z + on_u * s.u.z, 0 - along * f.sine}};
}

template <class T>
motor<T> power_of(const motor<T>& m, T t) {
    const screw<T> s = screw_of(m, true);
    const T poison = T(0) * s.p + T(0) * t;
    return poison == 0 && t == 1 ? m : poisoned(power_of(s, t), poison);
}

template <class T>
struct motor_bivector {
    vec3<T> b, n;
};

template <class T>
motor_bivector<T> log_of(const motor<T>& m) {
    const screw<T> s = screw_of(m, true);
    const T ratio = s.over_m(s.angle, T(1)), poison = T(0) * s.p;
    return {{s.angle * s.u.x + poison, s.angle * s.u.y + poison, s.angle * s.u.z + poison},
            {(ratio * s.across.x + s.p * s.u.x) + poison, (ratio * s.across.y + s.p * s.u.y) + poison,
             (ratio * s.across.z + s.p * s.u.z) + poison}};
}

template <class T>
motor<T> exp_of(vec3<T> b, const vec3<T>& n) {
    using C = constants<T>;
    const T nothing = zero_or_nan(std::array{b.x, b.y, b.z});
    const T poison = zero_or_nan(std::array{b.x, b.y, b.z, n.x, n.y, n.z});
    T squared = dot(b, b);
    if (squared > C::largest_angle * C::largest_angle) {
        b = {nothing, nothing, nothing};
        squared = nothing;
    }
    const T angle = std::sqrt(floored(squared));
    const sine_cosine<T> f = sincos_of(angle);
    const T shape = f.sine / angle;
    const vec3<T> u{b.x / angle, b.y / angle, b.z / angle};
    const T along = dot(u, n), on_u = along * (f.cosine - shape);
    return poisoned(motor<T>{{shape * b.x, shape * b.y, shape * b.z, f.cosine},
                             {shape * n.x + on_u * u.x, shape * n.y + on_u * u.y, shape * n.z + on_u * u.z,
                              0 - along * f.sine}},
                    poison);
}

template <class T>
motor<T> sclerp_of(const motor<T>& a, const motor<T>& b, T t, bool long_way) {
    const motor<T> way = product_of(motor<T>{reversed(a.r), reversed(a.d)}, b);
    const bool flip = (way.r.w < 0) != long_way;
    const auto turned = [&](const motor<T>& m) { return flip ? motor<T>{minus(m.r), minus(m.d)} : m; };
    const screw<T> s = screw_of(turned(way), long_way);
    const T poison = T(0) * s.p + T(0) * t;
    if (poison == 0 && t == 0) return a;
    if (poison == 0 && t == 1) return turned(b);
    return poisoned(product_of(a, power_of(s, t)), poison);
}

template <class T>
motor<T> blend_of(std::span<const motor_view<const T>> motors, std::span<const parameter<T>> weights,
                  std::size_t i) {
    const quat<T> first = read(real_part(motors[0]), i);
    motor<T> sum{each(T(0)), each(T(0))};
    for (std::size_t k = 0; k < motors.size(); ++k) {
        const motor<T> m = read(motors[k], i);
        const T given = read(weights[k], i), weight = dot(first, m.r) < 0 ? -given : given;
        const auto times = [&](const quat<T>& q) {
            return quat<T>{weight * q.x, weight * q.y, weight * q.z, weight * q.w};
        };
        sum = {plus(times(m.r), sum.r), plus(times(m.d), sum.d)};
    }
    return normalized_motor(sum);
}

// Calls body(i) for every element.
template <class T, class... In, class... Out, class Body>
status plain(const options& o, const std::tuple<In...>& reads, const std::tuple<Out...>& writes, Body body) {
    return for_each<T>(o, reads, writes, body);
}

template <class T>
status blend_all(std::span<const motor_view<const T>> motors, std::span<const parameter<T>> weights,
                 const motor_view<T>& out, const options& o) {
    if (motors.size() != weights.size()) return status::size_mismatch;
    if (motors.empty()) return status::bad_argument;
    for (std::size_t k = 0; k < motors.size(); ++k) {
        const status bad =
            plain<T>(o, std::tuple(motors[k], weights[k]), std::tuple(out), [](std::size_t) {});
        if (bad != status::ok) return bad;
    }
    for (std::size_t i = 0; i < out.size; ++i) write(out, i, blend_of(motors, weights, i));
    return status::ok;
}

template <class T>
twist_axis<T> axis_at(const twist_axis<T>& a, std::size_t i) {
    if (a.kind != twist_axis<T>::form::per_element) return a;
    const vec3_view<const T>& v = a.per_element;
    return vec3_view<const T>{element(v.x, i, v.stride), element(v.y, i, v.stride), element(v.z, i, v.stride),
                              1};
}

template <class T>
status decompose_all(const motor_view<const T>& m, const twist_axis<T>& a, const quat_view<T>& swing,
                     const quat_view<T>& twist, const vec3_view<T>& translation, const options& o) {
    return for_each<T>(o, std::tuple(m, a), std::tuple(swing, twist, translation), [&](std::size_t i) {
        const motor<T> in = read(m, i);
        quat<T> s{}, t{};
        (void)decompose(quat_view<const T>{&in.r.x, &in.r.y, &in.r.z, &in.r.w, 1}, axis_at(a, i),
                        quat_view<T>{&s.x, &s.y, &s.z, &s.w, 1}, quat_view<T>{&t.x, &t.y, &t.z, &t.w, 1}, o);
        const vec3<T> moves = translation_of(in);
        const T poison = T(0) * s.w + T(0) * moves.x;
        write(swing, i, plus(s, each(poison)));
        write(twist, i, plus(t, each(poison)));
        write(translation, i, vec3<T>{moves.x + poison, moves.y + poison, moves.z + poison});
    });
}

template <class T>
status compose_all(const quat_view<const T>& swing, const quat_view<const T>& twist,
                   const vec3_view<const T>& translation, const motor_view<T>& out, const options& o) {
    const bool swing_left = o.order == product::swing_twist;
    const quat_view<const T>&left = swing_left ? swing : twist, &right = swing_left ? twist : swing;
    return plain<T>(o, std::tuple(left, right, translation), std::tuple(out), [&](std::size_t i) {
        const quat<T> q = hamilton(read(left, i), read(right, i));
        const quat<T> d = moved(q, read(translation, i));
        write(out, i, poisoned(motor<T>{q, d}, T(0) * d.y + T(0) * d.x));
    });
}

}  // namespace

status multiply(const motor_view<const float>& a, const motor_view<const float>& b,
                const motor_view<float>& out, options o) noexcept {
    return plain<float>(o, std::tuple(a, b), std::tuple(out),
                        [&](std::size_t i) { write(out, i, multiply_of(read(a, i), read(b, i))); });
}
status multiply(const motor_view<const double>& a, const motor_view<const double>& b,
                const motor_view<double>& out, options o) noexcept {
    return plain<double>(o, std::tuple(a, b), std::tuple(out),
                         [&](std::size_t i) { write(out, i, multiply_of(read(a, i), read(b, i))); });
}
status conjugate(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return plain<float>(o, std::tuple(m), std::tuple(out), [&](std::size_t i) {
        const motor<float> in = read(m, i);
        write(out, i, motor<float>{reversed(in.r), reversed(in.d)});
    });
}
status conjugate(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return plain<double>(o, std::tuple(m), std::tuple(out), [&](std::size_t i) {
        const motor<double> in = read(m, i);
        write(out, i, motor<double>{reversed(in.r), reversed(in.d)});
    });
}
status normalize(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return plain<float>(o, std::tuple(m), std::tuple(out),
                        [&](std::size_t i) { write(out, i, normalized_motor(read(m, i))); });
}
status normalize(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return plain<double>(o, std::tuple(m), std::tuple(out),
                         [&](std::size_t i) { write(out, i, normalized_motor(read(m, i))); });
}
status from_rotation_translation(const quat_view<const float>& q, const vec3_view<const float>& t,
                                 const motor_view<float>& out, options o) noexcept {
    return plain<float>(o, std::tuple(q, t), std::tuple(out), [&](std::size_t i) {
        write(out, i, from_rotation_translation_of(read(q, i), read(t, i)));
    });
}
status from_rotation_translation(const quat_view<const double>& q, const vec3_view<const double>& t,
                                 const motor_view<double>& out, options o) noexcept {
    return plain<double>(o, std::tuple(q, t), std::tuple(out), [&](std::size_t i) {
        write(out, i, from_rotation_translation_of(read(q, i), read(t, i)));
    });
}
status to_rotation_translation(const motor_view<const float>& m, const quat_view<float>& q,
                               const vec3_view<float>& t, options o) noexcept {
    return plain<float>(o, std::tuple(m), std::tuple(q, t), [&](std::size_t i) {
        const motor<float> in = read(m, i);
        const vec3<float> moves = translation_of(in);
        const float poison = 0 * moves.x;
        write(q, i, poison == 0 ? in.r : each(poison));
        write(t, i, vec3<float>{moves.x + poison, moves.y + poison, moves.z + poison});
    });
}
status to_rotation_translation(const motor_view<const double>& m, const quat_view<double>& q,
                               const vec3_view<double>& t, options o) noexcept {
    return plain<double>(o, std::tuple(m), std::tuple(q, t), [&](std::size_t i) {
        const motor<double> in = read(m, i);
        const vec3<double> moves = translation_of(in);
        const double poison = 0 * moves.x;
        write(q, i, poison == 0 ? in.r : each(poison));
        write(t, i, vec3<double>{moves.x + poison, moves.y + poison, moves.z + poison});
    });
}
status transform(const motor_view<const float>& m, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options o) noexcept {
    return plain<float>(o, std::tuple(m, points), std::tuple(out),
                        [&](std::size_t i) { write(out, i, transformed(read(m, i), read(points, i))); });
}
status transform(const motor_view<const double>& m, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options o) noexcept {
    return plain<double>(o, std::tuple(m, points), std::tuple(out),
                         [&](std::size_t i) { write(out, i, transformed(read(m, i), read(points, i))); });
}
status square_root(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return plain<float>(o, std::tuple(m), std::tuple(out),
                        [&](std::size_t i) { write(out, i, square_root_of(read(m, i))); });
}
status square_root(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return plain<double>(o, std::tuple(m), std::tuple(out),
                         [&](std::size_t i) { write(out, i, square_root_of(read(m, i))); });
}
status log(const motor_view<const float>& m, const vec3_view<float>& b, const vec3_view<float>& n,
           options o) noexcept {
    return plain<float>(o, std::tuple(m), std::tuple(b, n), [&](std::size_t i) {
        const motor_bivector<float> r = log_of(read(m, i));
        write(b, i, r.b);
        write(n, i, r.n);
    });
}
status log(const motor_view<const double>& m, const vec3_view<double>& b, const vec3_view<double>& n,
           options o) noexcept {
    return plain<double>(o, std::tuple(m), std::tuple(b, n), [&](std::size_t i) {
        const motor_bivector<double> r = log_of(read(m, i));
        write(b, i, r.b);
        write(n, i, r.n);
    });
}
status exp(const vec3_view<const float>& b, const vec3_view<const float>& n, const motor_view<float>& out,
           options o) noexcept {
    return plain<float>(o, std::tuple(b, n), std::tuple(out),
                        [&](std::size_t i) { write(out, i, exp_of(read(b, i), read(n, i))); });
}
status exp(const vec3_view<const double>& b, const vec3_view<const double>& n, const motor_view<double>& out,
           options o) noexcept {
    return plain<double>(o, std::tuple(b, n), std::tuple(out),
                         [&](std::size_t i) { write(out, i, exp_of(read(b, i), read(n, i))); });
}
status power(const motor_view<const float>& m, const parameter<float>& t, const motor_view<float>& out,
             options o) noexcept {
    return plain<float>(o, std::tuple(m, t), std::tuple(out),
                        [&](std::size_t i) { write(out, i, power_of(read(m, i), read(t, i))); });
}
status power(const motor_view<const double>& m, const parameter<double>& t, const motor_view<double>& out,
             options o) noexcept {
    return plain<double>(o, std::tuple(m, t), std::tuple(out),
                         [&](std::size_t i) { write(out, i, power_of(read(m, i), read(t, i))); });
}
status sclerp(const motor_view<const float>& a, const motor_view<const float>& b, const parameter<float>& t,
              const motor_view<float>& out, options o) noexcept {
    return plain<float>(o, std::tuple(a, b, t), std::tuple(out), [&](std::size_t i) {
        write(out, i, sclerp_of(read(a, i), read(b, i), read(t, i), o.long_way));
    });
}
status sclerp(const motor_view<const double>& a, const motor_view<const double>& b,
              const parameter<double>& t, const motor_view<double>& out, options o) noexcept {
    return plain<double>(o, std::tuple(a, b, t), std::tuple(out), [&](std::size_t i) {
        write(out, i, sclerp_of(read(a, i), read(b, i), read(t, i), o.long_way));
    });
}
status blend(std::span<const motor_view<const float>> motors, std::span<const parameter<float>> weights,
             const motor_view<float>& out, options o) noexcept {
    return blend_all<float>(motors, weights, out, o);
}
status blend(std::span<const motor_view<const double>> motors, std::span<const parameter<double>> weights,
             const motor_view<double>& out, options o) noexcept {
    return blend_all<double>(motors, weights, out, o);
}
status decompose(const motor_view<const float>& m, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const vec3_view<float>& translation, options o) noexcept {
    return decompose_all<float>(m, a, swing, twist, translation, o);
}
status decompose(const motor_view<const double>& m, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const vec3_view<double>& translation, options o) noexcept {
    return decompose_all<double>(m, a, swing, twist, translation, o);
}
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const vec3_view<const float>& translation, const motor_view<float>& out, options o) noexcept {
    return compose_all<float>(swing, twist, translation, out, o);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const vec3_view<const double>& translation, const motor_view<double>& out,
               options o) noexcept {
    return compose_all<double>(swing, twist, translation, out, o);
}

}  // namespace swivel::reference
