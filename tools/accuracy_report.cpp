// accuracy_report [SAMPLES]: the largest errors of every operation on every usable ISA, in both types and
// precisions, against long double. The figures of the headers and of README come from here.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "swivel/swivel.hpp"

namespace {

using namespace swivel;
using wide = long double;

constexpr wide pi = 3.14159265358979323846264338327950288L;

// The same samples on every machine, whatever its standard library.
class random_numbers {
public:
    double uniform(double low, double high) {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        z ^= z >> 31;
        return low + (high - low) * (static_cast<double>(z >> 11) * 0x1p-53);
    }

private:
    std::uint64_t state_ = 1;
};

constexpr std::size_t chunk = 8192;

template <class T>
struct quats {
    std::vector<T> x, y, z, w;
    quats() : x(chunk), y(chunk), z(chunk), w(chunk) {}
    quat_view<T> view() { return soa(x.data(), y.data(), z.data(), w.data(), chunk); }
    quat<wide> at(std::size_t i) const { return {x[i], y[i], z[i], w[i]}; }
};

template <class T>
struct vectors {
    std::vector<T> x, y, z;
    vectors() : x(chunk), y(chunk), z(chunk) {}
    vec3_view<T> view() { return soa(x.data(), y.data(), z.data(), chunk); }
};

quat<wide> times(const quat<wide>& l, const quat<wide>& r) {
    return {l.w * r.x + l.x * r.w + l.y * r.z - l.z * r.y, l.w * r.y + l.y * r.w + l.z * r.x - l.x * r.z,
            l.w * r.z + l.z * r.w + l.x * r.y - l.y * r.x, l.w * r.w - l.x * r.x - l.y * r.y - l.z * r.z};
}

wide norm(const quat<wide>& q) { return std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w); }

wide distance(const quat<wide>& a, const quat<wide>& b) {
    return norm({a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w});
}

vec3<wide> unit(const vec3<wide>& v) {
    const wide n = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return {v.x / n, v.y / n, v.z / n};
}

vec3<double> random_direction(random_numbers& r) {
    for (;;) {
        const vec3<double> v{r.uniform(-1, 1), r.uniform(-1, 1), r.uniform(-1, 1)};
        const double n = v.x * v.x + v.y * v.y + v.z * v.z;
        if (n > 0.01 && n < 1) return v;
    }
}

// Half of the samples uniform over the rotations, half spread evenly over the powers of two of the distance
// from the pole of the axis, down to the default threshold and a little below.
template <class T>
quat<T> sample(random_numbers& r, const vec3<double>& axis, bool near_pole) {
    constexpr double two_pi = 6.283185307179586;
    quat<double> q;
    if (near_pole) {
        const double depth = sizeof(T) == 4 ? 26 : 55;
        const double distance = std::exp2(-r.uniform(0, depth)), angle = r.uniform(0, two_pi);
        const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
        const vec3<double> a{axis.x / length, axis.y / length, axis.z / length};
        vec3<double> p = random_direction(r);
        const double along = p.x * a.x + p.y * a.y + p.z * a.z;
        p = {p.x - along * a.x, p.y - along * a.y, p.z - along * a.z};
        const double scale =
            std::sqrt(1 - distance * distance) / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        const double u = distance * std::sin(angle);
        q = {p.x * scale + u * a.x, p.y * scale + u * a.y, p.z * scale + u * a.z, distance * std::cos(angle)};
    } else {
        const double s = r.uniform(0, 1), a = r.uniform(0, two_pi), b = r.uniform(0, two_pi);
        q = {std::sqrt(1 - s) * std::sin(a), std::sqrt(1 - s) * std::cos(a), std::sqrt(s) * std::sin(b),
             std::sqrt(s) * std::cos(b)};
    }
    return {static_cast<T>(q.x), static_cast<T>(q.y), static_cast<T>(q.z), static_cast<T>(q.w)};
}

enum form { coordinate, uniform, per_element, forms };
constexpr const char* form_names[] = {"coordinate axis", "one axis", "axis per element"};

// In units of 2^-24 or 2^-53. Twist and swing about an axis that is no coordinate axis are ill conditioned as
// 1/r near the pole, r = sqrt(w^2 + (a.v)^2) / |q|; their errors are given times r.
struct errors {
    double twist_norm = 0, swing_norm = 0, recomposition = 0, axial = 0, twist = 0, swing = 0, angle = 0;
};

void keep(double& most, wide error) {
    if (!(static_cast<double>(error) <= most)) most = static_cast<double>(error);
}

template <class T>
errors measure(form f, precision p, std::size_t samples) {
    constexpr wide u = sizeof(T) == 4 ? 0x1p-24L : 0x1p-53L;
    constexpr wide threshold = sizeof(T) == 4 ? 0x1p-24L : 0x1p-53L;
    errors e;
    random_numbers r;
    quats<T> q, s, t, s2, t2;
    vectors<T> axes;
    std::vector<T> angles(chunk);
    for (std::size_t done = 0; done < samples; done += chunk) {
        const product order = done / chunk % 2 == 0 ? product::swing_twist : product::twist_swing;
        const axis along = static_cast<axis>(done / chunk % 3);
        const vec3<double> shared = random_direction(r);
        const vec3<T> shared_axis{static_cast<T>(shared.x), static_cast<T>(shared.y),
                                  static_cast<T>(shared.z)};
        for (std::size_t i = 0; i < chunk; ++i) {
            const vec3<double> own = f == per_element ? random_direction(r)
                                     : f == coordinate
                                         ? vec3<double>{double(along == axis::x), double(along == axis::y),
                                                        double(along == axis::z)}
                                         : vec3<double>{shared_axis.x, shared_axis.y, shared_axis.z};
            axes.x[i] = static_cast<T>(own.x);
            axes.y[i] = static_cast<T>(own.y);
            axes.z[i] = static_cast<T>(own.z);
            const quat<T> v = sample<T>(r, own, i % 2 != 0);
            q.x[i] = v.x;
            q.y[i] = v.y;
            q.z[i] = v.z;
            q.w[i] = v.w;
        }
        const twist_axis<T> a = f == per_element  ? twist_axis<T>(axes.view())
                                : f == coordinate ? twist_axis<T>(along)
                                                  : twist_axis<T>(shared_axis);
        const options o{.order = order, .accuracy = p};
        const scalar_view<T> radians{angles.data(), chunk};
        if (decompose(q.view(), a, s.view(), t.view(), o) != status::ok ||
            swing(q.view(), a, s2.view(), o) != status::ok ||
            twist(q.view(), a, t2.view(), o) != status::ok ||
            twist_angle(q.view(), a, radians, o) != status::ok)
            std::abort();

        for (std::size_t i = 0; i < chunk; ++i) {
            const quat<wide> in = q.at(i), S = s.at(i), Tw = t.at(i);
            const vec3<wide> n = unit({axes.x[i], axes.y[i], axes.z[i]});
            const wide length = norm(in), v = n.x * in.x + n.y * in.y + n.z * in.z;
            const wide root = std::sqrt(in.w * in.w + v * v), closeness = root / length;
            // The single operations are the same kernels; what they give is measured as one.
            if (norm({S.x - s2.at(i).x, S.y - s2.at(i).y, S.z - s2.at(i).z, S.w - s2.at(i).w}) != 0 ||
                distance(Tw, t2.at(i)) != 0)
                keep(e.recomposition, 1e30L);
            keep(e.twist_norm, std::fabs(norm(Tw) - 1) / u);
            keep(e.swing_norm, std::fabs(norm(S) - length) / length / u);
            const quat<wide> back = order == product::swing_twist ? times(S, Tw) : times(Tw, S);
            keep(e.recomposition, distance(back, in) / length / u);
            keep(e.axial, std::fabs(n.x * S.x + n.y * S.y + n.z * S.z) / length / u);
            // Next to the threshold it is a matter of rounding on which side an element lies.
            if (closeness < 1.01L * threshold) continue;
            const quat<wide> exact_t{v / root * n.x, v / root * n.y, v / root * n.z, in.w / root};
            const quat<wide> inverse{-exact_t.x, -exact_t.y, -exact_t.z, exact_t.w};
            const quat<wide> exact_s =
                order == product::swing_twist ? times(in, inverse) : times(inverse, in);
            const wide scale = f == coordinate ? 1 : closeness;
            keep(e.twist, distance(Tw, exact_t) * scale / u);
            keep(e.swing, distance(S, exact_s) / length * scale / u);
            // 2 pi and -2 pi are neighbours: rounding of a.v may decide between them.
            const wide angle = 2 * std::atan2(v, in.w);
            const wide error = std::fabs(std::remainder(static_cast<wide>(angles[i]) - angle, 4 * pi));
            keep(e.angle, f == coordinate ? error / std::fabs(angle) / u : error * scale / u);
        }
    }
    return e;
}

// Largest error of compose relative to |S| |T|, full and compact.
template <class T>
std::pair<double, double> measure_compose(precision p, std::size_t samples) {
    constexpr wide u = sizeof(T) == 4 ? 0x1p-24L : 0x1p-53L;
    double full = 0, compact = 0;
    random_numbers r;
    quats<T> s, t, q, f, cq;
    std::vector<T> ts(chunk), tc(chunk);
    for (std::size_t done = 0; done < samples; done += chunk) {
        for (std::size_t i = 0; i < chunk; ++i) {
            const quat<T> a = sample<T>(r, {}, false), b = sample<T>(r, {}, false),
                          c = sample<T>(r, {}, false);
            const double half = r.uniform(-3.2, 3.2);
            s.x[i] = a.x, s.y[i] = a.y, s.z[i] = a.z, s.w[i] = a.w;
            t.x[i] = b.x, t.y[i] = b.y, t.z[i] = b.z, t.w[i] = b.w;
            f.x[i] = c.x, f.y[i] = c.y, f.z[i] = 0, f.w[i] = c.w;
            ts[i] = static_cast<T>(std::sin(half));
            tc[i] = static_cast<T>(std::cos(half));
        }
        const product order = done / chunk % 2 == 0 ? product::swing_twist : product::twist_swing;
        const options o{.order = order, .accuracy = p};
        const factor_view<const T> factors{f.x.data(), f.y.data(), f.w.data(), ts.data(), tc.data(), chunk};
        if (compose(s.view(), t.view(), q.view(), o) != status::ok ||
            compose(factors, axis::z, cq.view(), o) != status::ok)
            std::abort();
        for (std::size_t i = 0; i < chunk; ++i) {
            const bool swing_left = order == product::swing_twist;
            const quat<wide> a = s.at(i), b = t.at(i), c = f.at(i), d{0, 0, ts[i], tc[i]};
            keep(full, distance(q.at(i), swing_left ? times(a, b) : times(b, a)) / norm(a) / norm(b) / u);
            keep(compact, distance(cq.at(i), swing_left ? times(c, d) : times(d, c)) / norm(c) / norm(d) / u);
        }
    }
    return {full, compact};
}

template <class T>
void report(std::size_t samples) {
    const char* type = sizeof(T) == 4 ? "f32" : "f64";
    for (isa i : all_isas) {
        if (set_active_isa(i) != status::ok) continue;
        for (precision p : {precision::fast, precision::reproducible}) {
            const char* how = p == precision::fast ? "fast" : "reproducible";
            for (form f : {coordinate, uniform, per_element}) {
                const errors e = measure<T>(f, p, samples);
                std::printf(
                    "| decompose, %s | %s | %s | %s | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n",
                    form_names[f], name(i), type, how, e.twist_norm, e.swing_norm, e.recomposition, e.axial,
                    e.twist, e.swing, e.angle);
                std::fflush(stdout);
            }
            const auto [full, compact] = measure_compose<T>(p, samples);
            std::printf("| compose | %s | %s | %s | | | %.2f | | | | |\n", name(i), type, how, full);
            std::printf("| compose, compact | %s | %s | %s | | | %.2f | | | | |\n", name(i), type, how,
                        compact);
            std::fflush(stdout);
        }
    }
}

}  // namespace

int main(int count, char** arguments) {
    const std::size_t samples = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 10'000'000;
    if (samples == 0) {
        std::fprintf(stderr, "usage: accuracy_report [SAMPLES]\n");
        return 2;
    }
    std::printf(
        "Largest of %zu samples, in units of 2^-24 (f32) or 2^-53 (f64). Twist, swing and twist_angle: about "
        "a\n"
        "coordinate axis the error itself (twist_angle: relative), about another axis the error times\n"
        "r = sqrt(w^2 + (a.v)^2) / |q|.\n\n"
        "| operation | ISA | type | precision | norm of twist | norm of swing | recomposition | axial | "
        "twist | "
        "swing | twist_angle |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
        samples);
    report<float>(samples);
    report<double>(samples);
}
