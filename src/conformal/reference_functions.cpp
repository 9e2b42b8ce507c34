#include "src/conformal/reference.hpp"
#include "swivel/reference.hpp"

// square_root, exp, log, power, interpolate and split of conformal rotors and bivectors. Each bivector is the
// sum of two that commute, a A + b B with unit squares: planes of rotation, or for B of a boost or null.

namespace swivel::reference {

namespace {

// What the functions need of a bivector r and a part f of four vectors that commutes with it.
template <class T>
struct parts {
    T bivector_squared, four_squared;  // scalar parts
    T bivector_size, four_size;        // sums of the squares of the components
    std::array<T, 10> mixed;           // the bivector part of r f
};

template <class T>
T larger(T a, T b) {
    return a > b ? a : b;
}

// The scalar part of the square of the bivector.
template <class T>
T bivector_square(const even<T>& r) {
    // Of what is null nothing is left, as e4 and e5 come in differences.
    const auto null_pair = [](T a4, T a5) { return (a5 - a4) * (a5 + a4); };
    T s = null_pair(r[e14], r[e15]);
    s = s + null_pair(r[e24], r[e25]);
    s = s + null_pair(r[e34], r[e35]);
    s = r[e45] * r[e45] + s;
    s = s - r[e12] * r[e12];
    s = s - r[e13] * r[e13];
    return s - r[e23] * r[e23];
}

template <class T>
parts<T> parts_of(const even<T>& r) {
    parts<T> p;
    p.bivector_squared = bivector_square(r);
    T g = (r[e1234] - r[e1235]) * (r[e1234] + r[e1235]);
    g = g - r[e1245] * r[e1245];
    g = g - r[e1345] * r[e1345];
    p.four_squared = g - r[e2345] * r[e2345];
    p.bivector_size = 0;
    for (std::size_t k = bivectors; k < four_vectors; ++k) p.bivector_size = r[k] * r[k] + p.bivector_size;
    p.four_size = 0;
    for (std::size_t k = four_vectors; k < end_of_blades; ++k) p.four_size = r[k] * r[k] + p.four_size;
    for (int k = 0; k < 10; ++k)
        p.mixed[static_cast<std::size_t>(k)] =
            product_component(k + bivectors, r, bivectors, four_vectors, r, four_vectors, end_of_blades);
    return p;
}

// The bivector with the part of four vectors of half of its square.
template <class T>
even<T> with_half_square(const bivector<T>& b) {
    even<T> r{};
    for (std::size_t k = 0; k < 10; ++k) r[k + bivectors] = b[k];
    for (int k = four_vectors; k < end_of_blades; ++k)
        r[static_cast<std::size_t>(k)] =
            T(0.5) * product_component(k, r, bivectors, four_vectors, r, bivectors, four_vectors);
    return r;
}

// p >= q with p + q = sum, p q = product; p >= 0.
template <class T>
struct roots {
    T p, q;
};

template <class T>
roots<T> roots_of(T sum, T product) {
    const T size = std::fabs(sum);
    // Its square would be subnormal.
    const bool tiny = size < constants<T>::root_of_smallest_normal;
    const T part = tiny ? T(0) : sum, square_root = std::sqrt(larger(part * part - T(4) * product, T(0)));
    const T root = tiny ? larger(size, square_root) : square_root;
    const T big = T(0.5) * (size + root), other = product / larger(big, constants<T>::pole_floor);
    if (!(sum >= 0)) return {larger(-other, T(0)), -big};
    return {big, other > big ? big : other};
}

// a / b, or `limit` where b is as good as 0.
template <class T>
T ratio(T a, T b, T limit) {
    const T least = constants<T>::pole_floor;
    return b > least ? a / b : limit;
}

// k = 2 cos(a/2) cos(b/2) and n = cos a + cos b of the rotor with that scalar part, squared; those of a rotor
// without a root are 0.
template <class T>
struct halves {
    T k_squared, n_squared;
    bool regular;
};

// How large the bivector and the rest are for the purpose of what rounding may have done to the terms whose
// difference counts: but for rotations about an axis through the origin, which are exact in relation to their
// size, the components have the rounding of 1.
template <class T>
struct sizes {
    T bivector, four;
};

template <class T>
sizes<T> sizes_of(const parts<T>& p) {
    const T noise = constants<T>::noise;
    const bool origin = p.bivector_size + p.bivector_squared <= noise * p.bivector_size && p.four_size == 0;
    if (origin) return {p.bivector_size, p.four_size};
    return {p.bivector_size + std::sqrt(p.bivector_size), p.four_size + (std::sqrt(p.four_size) + noise)};
}

template <class T>
halves<T> halves_of(T scalar, const parts<T>& p, const sizes<T>& s) {
    const T noise = constants<T>::noise, less = 1 - scalar;
    const bool positive = scalar >= 0;
    const T above = positive ? 1 + scalar : (p.four_squared - p.bivector_squared) / less;
    const T share = positive ? T(0) : s.bivector / less;
    // Nothing where its square counts for nothing, and would with the noise be subnormal.
    const T large = std::fabs(above) < constants<T>::root_of_pole_floor ? T(0) : above;
    const T n_squared = large * large - p.four_squared, n = std::sqrt(larger(n_squared, T(0)));
    const T k_squared = above >= 0 ? above + n : -p.four_squared / (n - above);
    const T size = std::fabs(large);
    const bool regular = n_squared > noise * ((size + share) * size + s.four) + constants<T>::pole_floor &&
                         k_squared > noise * (positive ? T(0) : s.bivector);
    return {k_squared, n_squared, regular};
}

template <class T>
struct choice {
    T sign, unique;
    halves<T> of;
    bool none;
};

template <class T>
choice<T> choose(T scalar, const parts<T>& p) {
    using C = constants<T>;
    const sizes<T> s = sizes_of(p);
    const halves<T> own = halves_of(scalar, p, s), other = halves_of(-scalar, p, s);
    const T size = p.bivector_size + p.four_size, largest = C::largest_blade;
    const bool outside = !(scalar * scalar + size <= largest * largest);
    const bool minus_one = !(size > T(16) * C::pole_threshold),
               lost = !own.regular && (minus_one || !other.regular);
    return {own.regular ? T(1) : T(-1), own.regular && !outside ? T(1) : T(0), own.regular ? own : other,
            outside || lost};
}

template <class T>
T square_root_of(const even<T>& r, even<T>& out) {
    const T bad = zero_or_nan(r);
    const parts<T> p = parts_of(r);
    const choice<T> c = choose(r[0], p);
    const T k = std::sqrt(c.of.k_squared), n = std::sqrt(c.of.n_squared), twice = k + k;
    const T mixed = T(1) / (n * twice), four = c.sign / twice, plane = c.sign * (c.of.k_squared * mixed);
    out[0] = c.none ? T(0) : T(0.5) * k;
    for (std::size_t i = 0; i < 10; ++i)
        out[i + bivectors] = c.none ? T(0) : r[i + bivectors] * plane - mixed * p.mixed[i];
    if (c.none) out[e23] = T(-1);
    for (std::size_t i = four_vectors; i < end_of_blades; ++i) out[i] = c.none ? T(0) : four * r[i];
    for (T& o : out) o = o + bad;
    return c.unique + bad;
}

// The angles a and b of a rotor, or where these are alike a + b and a - b, and their sines; b of a boost is its
// length. s.p and s.q are the squares of the sines of a and b, root is the product of the sines.
template <class T>
struct rotor_angles {
    choice<T> of;
    roots<T> s;
    T scalar, root, cos_a, cos_b, sine_1, sine_2, angle_1, angle_2;
    bool hyperbolic, alike;
};

template <class T>
rotor_angles<T> angles_of(T r0, const parts<T>& p) {
    const T g = p.four_squared;
    rotor_angles<T> a;
    a.of = choose(r0, p);
    a.scalar = a.of.sign * r0;
    a.s = roots_of((g + g) - p.bivector_squared, g);
    a.hyperbolic = a.s.q < 0;
    a.alike = T(4) * a.s.q > a.s.p;
    a.root = std::sqrt(larger(g, T(0)));
    a.cos_b = std::sqrt(larger(1 - a.s.q, T(0)));
    a.cos_a = a.scalar / larger(a.cos_b, T(0.5));
    const T cross = (a.scalar + a.scalar) * a.root;
    a.sine_1 = std::sqrt(larger(a.alike ? cross - p.bivector_squared : a.s.p, T(0)));
    a.sine_2 = std::sqrt(larger(a.alike ? -p.bivector_squared - cross : std::fabs(a.s.q), T(0)));
    a.angle_1 = atan2_of(a.sine_1, a.alike ? a.scalar - a.root : a.cos_a);
    a.angle_2 = a.hyperbolic ? asinh_of(a.sine_2) : atan2_of(a.sine_2, a.alike ? a.scalar + a.root : a.cos_b);
    return a;
}

// What the bivector of a rotor and `mixed` count in one with the same planes, whose coefficients of A and B are
// `first` and `second` times those sines. `limit` is that of both where the planes vanish, `series` what `mixed`
// counts where they are `tiny`.
template <class T>
struct coefficients {
    T plane, mixed;
};

template <class T>
coefficients<T> coefficients_of(const rotor_angles<T>& a, T first, T second, T limit, bool tiny, T series) {
    const T apart = a.s.p - a.s.q;
    const T plane = a.alike ? T(0.5) * (first + second)
                            : ratio((a.s.p * a.cos_b) * first - (a.s.q * a.cos_a) * second, apart, limit);
    const T mixed = tiny ? series
                         : ratio(a.alike ? second - first : a.cos_a * first - a.cos_b * second,
                                 a.alike ? a.root + a.root : apart, T(0));
    return {a.of.sign * plane, mixed};
}

template <class T>
T log_of(const even<T>& r, bivector<T>& out) {
    using C = constants<T>;
    const T bad = zero_or_nan(r);
    const parts<T> p = parts_of(r);
    const rotor_angles<T> a = angles_of(r[0], p);
    const bool tiny = a.scalar > 0 && larger(a.s.p, -a.s.q) < C::small_square;
    const coefficients<T> c =
        coefficients_of(a, ratio(a.angle_1, a.sine_1, T(1)), ratio(a.angle_2, a.sine_2, T(1)), T(1), tiny,
                        T(-1) / T(3) - (T(2) / T(15)) * (a.s.p + a.s.q));
    for (std::size_t i = 0; i < 10; ++i)
        out[i] = (a.of.none ? T(0) : c.mixed * p.mixed[i] + r[i + bivectors] * c.plane) + bad;
    if (a.of.none) out[e23 - bivectors] = -C::pi + bad;
    return a.of.unique + bad;
}

// With a NaN in place of 0 where the element is to be NaN.
template <class T>
even<T> exp_of(const bivector<T>& b, T bad) {
    using C = constants<T>;
    const even<T> r = with_half_square(b);
    const parts<T> p = parts_of(r);
    const T g = p.four_squared, sum = -p.bivector_squared;
    const roots<T> s = roots_of(sum, g);
    const T half = T(0.5) * C::largest_angle, largest = C::largest_blade, boost = C::largest_boost;
    const bool outside = !(p.bivector_size <= largest * largest) || s.p > half * half || -s.q > boost * boost;
    const bool hyperbolic = s.q<0, alike = T(4) * s.q> s.p, small = larger(s.p, -s.q) < C::small_square;

    // No larger than half of the sum, as of two squares.
    const T half_sum = T(0.5) * sum, product_root = std::sqrt(larger(g, T(0)));
    const T root = product_root > half_sum ? half_sum : product_root, twice = root + root;
    const T a = outside ? T(0) : std::sqrt(alike ? sum + twice : s.p);
    const T b2 = outside ? T(0) : std::sqrt(alike ? larger(sum - twice, T(0)) : std::fabs(s.q));
    const sine_cosine<T> first = sincos_of(a);
    sine_cosine<T> second = sincos_of(b2);
    if (hyperbolic) {
        const reference::hyperbolic<T> h = sinhcosh_of(b2);
        second = {h.sinh, h.cosh};
    }
    const T z1 = ratio(first.sine, a, T(1)), z2 = ratio(second.sine, b2, T(1));

    const T apart = s.p - s.q, x = z1 * second.cosine, y = first.cosine * z2, step = alike ? twice : apart;
    const T plane = alike ? T(0.5) * (z1 + z2) : ratio(s.p * x - s.q * y, apart, T(1));
    const T mixed =
        small ? T(1) / T(3) - (T(1) / T(30)) * (s.p + s.q) : ratio(alike ? z2 - z1 : x - y, step, T(0));
    const T scalar = alike ? T(0.5) * (first.cosine + second.cosine) : first.cosine * second.cosine;
    const T four = small   ? T(1) - (T(1) / T(6)) * (s.p + s.q)
                   : alike ? ratio(second.cosine - first.cosine, step, T(0))
                           : z1 * z2;
    even<T> out;
    out[0] = (outside ? T(1) : scalar) + bad;
    for (std::size_t i = 0; i < 10; ++i)
        out[i + bivectors] = (outside ? T(0) : mixed * p.mixed[i] + r[i + bivectors] * plane) + bad;
    for (std::size_t i = four_vectors; i < end_of_blades; ++i) out[i] = (outside ? T(0) : four * r[i]) + bad;
    return out;
}

// exp(t log r), without the logarithm: that of a motion about a far place is large and its rounding too.
template <class T>
T motion_power(const even<T>& r, T t, T bad, even<T>& out) {
    using C = constants<T>;
    const parts<T> p = parts_of(r);
    const rotor_angles<T> a = angles_of(r[0], p);
    const bool none = a.of.none;
    T x1 = t * (none ? C::pi : a.angle_1), x2 = t * (none ? T(0) : a.angle_2);
    const T largest = C::largest_angle;
    const bool outside = std::fabs(x1) > largest || std::fabs(x2) > largest ||
                         (a.hyperbolic && std::fabs(x2) > C::largest_boost);
    if (outside) x1 = x2 = 0;
    const sine_cosine<T> first = sincos_of(x1);
    sine_cosine<T> second = sincos_of(x2);
    if (a.hyperbolic) {
        const reference::hyperbolic<T> h = sinhcosh_of(std::fabs(x2));
        second = {std::signbit(x2) ? -h.sinh : h.sinh, h.cosh};
    }

    const T square = t * t, sum = a.s.p + a.s.q;
    const bool tiny = a.scalar > 0 && larger(a.s.p, -a.s.q) * larger(T(1), square) < C::small_square;
    const T series = (t * (square - 1)) * (sum * ((4 - square) * (T(1) / T(30))) + T(1) / T(3));
    const T z1 = ratio(first.sine, a.sine_1, t), z2 = ratio(second.sine, a.sine_2, t);
    const coefficients<T> c = coefficients_of(a, a.alike ? z1 : z1 * second.cosine,
                                              a.alike ? z2 : first.cosine * z2, t, tiny, series);
    const T scalar = a.alike ? T(0.5) * (first.cosine + second.cosine) : first.cosine * second.cosine;
    const T regular = a.alike ? ratio(T(0.5) * (second.cosine - first.cosine), a.root, T(0)) : z1 * z2;
    const T four = a.of.sign * (tiny ? square * (((1 - square) * sum) * (T(1) / T(6)) + 1) : regular);
    out.fill(bad);
    out[0] = (outside ? T(1) : none ? first.cosine : scalar) + bad;
    if (outside) return a.of.unique + bad;
    if (none) {
        out[e23] = -first.sine + bad;
        return a.of.unique + bad;
    }
    for (std::size_t i = 0; i < 10; ++i)
        out[i + bivectors] = (c.mixed * p.mixed[i] + r[i + bivectors] * c.plane) + bad;
    for (std::size_t i = four_vectors; i < end_of_blades; ++i) out[i] = four * r[i] + bad;
    return a.of.unique + bad;
}

template <class T>
T power_of(const even<T>& r, T t, even<T>& out) {
    const T bad = zero_or_nan(r) + T(0) * t, unique = motion_power(r, t, bad, out);
    if (bad + t == 1) out = r;
    return unique;
}

template <class T>
T interpolate_of(const even<T>& a, const even<T>& b, T t, even<T>& out) {
    const T bad = (zero_or_nan(a) + zero_or_nan(b)) + T(0) * t;
    even<T> part;
    const T unique = motion_power(product(b, reversed(a)), t, bad, part);
    out = product(part, a);
    if (bad + t == 0) out = a;
    if (bad + t == 1) out = b;
    return unique;
}

// Of any length: the largest component is brought to 2..4. Of angles that are alike, from (a + b)(A + B) and
// (a - b)(A - B): the difference of the squares is lost in their rounding long before a - b is.
template <class T>
T split_of(const bivector<T>& b, bivector<T>& first, bivector<T>& second) {
    using C = constants<T>;
    const T bad = zero_or_nan(b);
    T largest = 0;
    for (const T component : b) largest = larger(largest, std::fabs(component));
    const T scale = scale_for({largest});
    bivector<T> scaled = b;
    for (T& component : scaled) component = component * scale;
    const even<T> r = with_half_square(scaled);
    const parts<T> p = parts_of(r);
    const roots<T> s = roots_of(-p.bivector_squared, p.four_squared);

    const bool alike = T(4) * s.q > s.p;
    const T over_root = ratio(T(1), std::sqrt(larger(p.four_squared, T(0))), T(0));
    even<T> sums{}, differences{};
    for (std::size_t i = 0; i < 10; ++i) {
        sums[i + bivectors] = r[i + bivectors] - over_root * p.mixed[i];
        differences[i + bivectors] = over_root * p.mixed[i] + r[i + bivectors];
    }
    const T sum = std::sqrt(larger(bivector_square(sums) * T(-0.5), T(0)));
    const T difference = std::sqrt(larger(bivector_square(differences) * T(-0.5), T(0)));
    const T a = T(0.5) * (sum + difference), half_a = T(0.5) * a;
    const T of_sums = ratio(half_a, sum, T(0)), of_differences = ratio(half_a, difference, T(0));

    const T apart = alike ? sum * difference : s.p - s.q;
    const bool unique = apart > C::noise * p.bivector_size;
    for (std::size_t i = 0; i < 10; ++i) {
        const T part = alike ? of_sums * sums[i + bivectors] + of_differences * differences[i + bivectors]
                             : (s.p * r[i + bivectors] + p.mixed[i]) / apart;
        first[i] = (unique ? part * (T(1) / scale) : b[i]) + bad;
        second[i] = b[i] - first[i];
    }
    return (unique ? T(1) : T(0)) + bad;
}

template <class T>
status square_root_all(const conformal_view<const T>& r, const conformal_view<T>& out,
                       const scalar_view<T>& unique, const options& o) {
    return for_each<T>(o, std::tuple(r), std::tuple(out, unique), [&](std::size_t i) {
        even<T> root;
        write(unique, i, square_root_of(read(r, i), root));
        write(out, i, root);
    });
}

template <class T>
status exp_all(const bivector_view<const T>& b, const conformal_view<T>& out, const options& o) {
    return for_each<T>(o, std::tuple(b), std::tuple(out), [&](std::size_t i) {
        const bivector<T> element = read(b, i);
        write(out, i, exp_of(element, zero_or_nan(element)));
    });
}

template <class T>
status log_all(const conformal_view<const T>& r, const bivector_view<T>& out, const scalar_view<T>& unique,
               const options& o) {
    return for_each<T>(o, std::tuple(r), std::tuple(out, unique), [&](std::size_t i) {
        bivector<T> l;
        write(unique, i, log_of(read(r, i), l));
        write(out, i, l);
    });
}

template <class T>
status power_all(const conformal_view<const T>& r, const parameter<T>& t, const conformal_view<T>& out,
                 const scalar_view<T>& unique, const options& o) {
    return for_each<T>(o, std::tuple(r, t), std::tuple(out, unique), [&](std::size_t i) {
        even<T> p;
        write(unique, i, power_of(read(r, i), read(t, i), p));
        write(out, i, p);
    });
}

template <class T>
status interpolate_all(const conformal_view<const T>& a, const conformal_view<const T>& b,
                       const parameter<T>& t, const conformal_view<T>& out, const scalar_view<T>& unique,
                       const options& o) {
    return for_each<T>(o, std::tuple(a, b, t), std::tuple(out, unique), [&](std::size_t i) {
        even<T> p;
        write(unique, i, interpolate_of(read(a, i), read(b, i), read(t, i), p));
        write(out, i, p);
    });
}

template <class T>
status split_all(const bivector_view<const T>& b, const bivector_view<T>& first,
                 const bivector_view<T>& second, const scalar_view<T>& unique, const options& o) {
    return for_each<T>(o, std::tuple(b), std::tuple(first, second, unique), [&](std::size_t i) {
        bivector<T> one, other;
        write(unique, i, split_of(read(b, i), one, other));
        write(first, i, one);
        write(second, i, other);
    });
}

}  // namespace

status square_root(const conformal_view<const float>& r, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options o) noexcept {
    return square_root_all<float>(r, out, unique, o);
}
status square_root(const conformal_view<const double>& r, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options o) noexcept {
    return square_root_all<double>(r, out, unique, o);
}
status exp(const bivector_view<const float>& b, const conformal_view<float>& out, options o) noexcept {
    return exp_all<float>(b, out, o);
}
status exp(const bivector_view<const double>& b, const conformal_view<double>& out, options o) noexcept {
    return exp_all<double>(b, out, o);
}
status log(const conformal_view<const float>& r, const bivector_view<float>& out,
           const scalar_view<float>& unique, options o) noexcept {
    return log_all<float>(r, out, unique, o);
}
status log(const conformal_view<const double>& r, const bivector_view<double>& out,
           const scalar_view<double>& unique, options o) noexcept {
    return log_all<double>(r, out, unique, o);
}
status power(const conformal_view<const float>& r, const parameter<float>& t,
             const conformal_view<float>& out, const scalar_view<float>& unique, options o) noexcept {
    return power_all<float>(r, t, out, unique, o);
}
status power(const conformal_view<const double>& r, const parameter<double>& t,
             const conformal_view<double>& out, const scalar_view<double>& unique, options o) noexcept {
    return power_all<double>(r, t, out, unique, o);
}
status interpolate(const conformal_view<const float>& a, const conformal_view<const float>& b,
                   const parameter<float>& t, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options o) noexcept {
    return interpolate_all<float>(a, b, t, out, unique, o);
}
status interpolate(const conformal_view<const double>& a, const conformal_view<const double>& b,
                   const parameter<double>& t, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options o) noexcept {
    return interpolate_all<double>(a, b, t, out, unique, o);
}
status split(const bivector_view<const float>& b, const bivector_view<float>& first,
             const bivector_view<float>& second, const scalar_view<float>& unique, options o) noexcept {
    return split_all<float>(b, first, second, unique, o);
}
status split(const bivector_view<const double>& b, const bivector_view<double>& first,
             const bivector_view<double>& second, const scalar_view<double>& unique, options o) noexcept {
    return split_all<double>(b, first, second, unique, o);
}

}  // namespace swivel::reference
