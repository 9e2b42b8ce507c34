// No operation raises a floating-point exception but inexact on ordinary and on still data, or takes the slow way
// through subnormal numbers there.

#include <gtest/gtest.h>

#include <cfenv>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "support/conformal.hpp"
#include "support/operations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class Exceptions : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Exceptions, testing::ValuesIn(usable_isas()), isa_name);

// On x86 also that of an operand that is subnormal, which fetestexcept does not know.
std::string raised() {
    std::string names;
    if (std::fetestexcept(FE_INVALID) != 0) names += " invalid";
    if (std::fetestexcept(FE_DIVBYZERO) != 0) names += " division by zero";
    if (std::fetestexcept(FE_OVERFLOW) != 0) names += " overflow";
    if (std::fetestexcept(FE_UNDERFLOW) != 0) names += " underflow";
#if defined(__SSE2__)
    if ((_mm_getcsr() & _MM_EXCEPT_DENORM) != 0) names += " subnormal operand";
#endif
    return names;
}

void clear() {
    std::feclearexcept(FE_ALL_EXCEPT);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() & ~static_cast<unsigned>(_MM_EXCEPT_MASK));
#endif
}

template <class T>
using motion = dual_quaternion<T>;

// The conformal rotor of a motor.
template <class T>
void set_rotor(conformal_buffer<T>& b, std::size_t i, const motion<T>& m) {
    for (int c = 0; c < 16; ++c) b.at(c, i) = 0;
    b.at(0, i) = m.r.w;
    b.at(1, i) = -m.r.z;
    b.at(2, i) = m.r.y;
    b.at(5, i) = -m.r.x;
    b.at(3, i) = b.at(4, i) = -m.d.x;
    b.at(6, i) = b.at(7, i) = -m.d.y;
    b.at(8, i) = b.at(9, i) = -m.d.z;
    b.at(11, i) = b.at(12, i) = -m.d.w;
}

template <class T>
vec3<T> random_vector(generator& g, double size) {
    return {static_cast<T>(uniform(g, -size, size)), static_cast<T>(uniform(g, -size, size)),
            static_cast<T>(uniform(g, -size, size))};
}

template <class T>
void set_rotation_matrix(matrix_buffer<T>& b, std::size_t i, const quat<T>& r) {
    const T m[9] = {
        1 - 2 * (r.y * r.y + r.z * r.z), 2 * (r.x * r.y - r.w * r.z),     2 * (r.x * r.z + r.w * r.y),
        2 * (r.x * r.y + r.w * r.z),     1 - 2 * (r.x * r.x + r.z * r.z), 2 * (r.y * r.z - r.w * r.x),
        2 * (r.x * r.z - r.w * r.y),     2 * (r.y * r.z + r.w * r.x),     1 - 2 * (r.x * r.x + r.y * r.y)};
    for (int c = 0; c < 9; ++c) b.at(c, i) = m[c];
}

enum class data { ordinary, same, moved, turned, nothing };
constexpr data all_data[] = {data::ordinary, data::same, data::moved, data::turned, data::nothing};

const char* name_of(data d) {
    switch (d) {
        case data::ordinary:
            return "ordinary";
        case data::same:
            return "b = a";
        case data::moved:
            return "translations alone";
        case data::turned:
            return "rotations alone";
        case data::nothing:
            return "no motion";
    }
    return "unknown";
}

template <class T>
void fill(workspace<T>& w, generator& g, data d) {
    const bool turns = d != data::moved && d != data::nothing,
               moves = d != data::turned && d != data::nothing;
    const double size = moves ? 4 : 0;
    const quat<T> one{0, 0, 0, 1};
    const auto rotation = [&] { return turns ? random_rotation<T>(g) : one; };
    // Rigid, which a random motor of tests is to its rounding only.
    const auto motor = [&] {
        const quat<T> r = rotation();
        const vec3<T> t = random_vector<T>(g, size);
        return motion<T>{r,
                         {(t.x * r.w + t.y * r.z - t.z * r.y) / 2, (t.y * r.w + t.z * r.x - t.x * r.z) / 2,
                          (t.z * r.w + t.x * r.y - t.y * r.x) / 2, -(t.x * r.x + t.y * r.y + t.z * r.z) / 2}};
    };
    for (std::size_t i = 0; i < w.size(); ++i) {
        const quat<T> a = rotation(), b = d == data::same ? a : rotation();
        w.q.set(i, a);
        w.swing_in.set(i, a);
        w.twist_in.set(i, b);
        const vec3<T> v = random_vector<T>(g, d == data::nothing ? 0 : 4);
        w.vectors.set(i, v);
        w.axes.set(i, d == data::same || d == data::nothing ? v : random_vector<T>(g, 4));
        w.factors_in.set(i, turns ? factors<T>{a.x, a.y, a.w, b.z, b.w} : factors<T>{0, 0, 1, 0, 1});
        set_rotation_matrix(w.matrices_in, i, a);
        const motion<T> m = motor(), n = d == data::same ? m : motor();
        w.motors_in.set(i, m);
        w.other_motors_in.set(i, n);
        set_rotor(w.rotors_in, i, m);
        set_rotor(w.other_rotors_in, i, n);
        // The bivectors of motions, as exp takes them: a turn, and a part of infinity.
        const vec3<T> turn = random_vector<T>(g, turns ? 1.5 : 0), way = random_vector<T>(g, size);
        const T blades[10] = {-turn.z, turn.y, -way.x, -way.x, -turn.x, -way.y, -way.y, -way.z, -way.z, 0};
        for (int c = 0; c < 10; ++c) w.bivectors_in.at(c, i) = blades[c];
        w.signs_in[i] = g() % 2 != 0 ? T(1) : T(-1);
        w.angles_in[i] = d == data::nothing ? T(0) : static_cast<T>(uniform(g, -20, 20));
        w.parameters_in[i] = static_cast<T>(uniform(g, -0.25, 1.25));
        w.other_parameters_in[i] = static_cast<T>(uniform(g, -0.25, 1.25));
        // The ends and the middle, too.
        if (i % 5 == 0) w.parameters_in[i] = T(0.5) * static_cast<T>(g() % 3);
    }
}

// Interpolation and root with dilations.
template <class T>
void dilate(workspace<T>& w, generator& g, bool same) {
    const auto dilated = [&](conformal_buffer<T>& b, std::size_t i, double by) {
        even<double> m{}, d{};
        for (std::size_t c = 0; c < 16; ++c) m[c] = b.at(static_cast<int>(c), i);
        d[0] = std::cosh(by);
        d[10] = std::sinh(by);
        const even<double> p = times(m, d);
        for (std::size_t c = 0; c < 16; ++c) b.at(static_cast<int>(c), i) = static_cast<T>(p[c]);
    };
    for (std::size_t i = 0; i < w.size(); ++i) {
        const double by = uniform(g, -1, 1);
        dilated(w.rotors_in, i, by);
        dilated(w.other_rotors_in, i, same ? by : uniform(g, -1, 1));
        for (int c = 0; c < 10; ++c) w.bivectors_in.at(c, i) = static_cast<T>(uniform(g, -1, 1));
    }
}

template <class T>
void raises_none(workspace<T>& w, const std::string& what) {
    for (const operation<T>& op : all_operations<T>()) {
        for (const precision p : both_precisions) {
            clear();
            ASSERT_EQ(op.run(w, p), status::ok) << op.name;
            EXPECT_EQ(raised(), "") << op.name << ' ' << name(p) << " on " << what << ", " << w.size()
                                    << " elements of " << sizeof(T) << " bytes";
        }
    }
}

template <class T>
void raises_none_on_any() {
    // With and without a tail.
    for (const std::size_t n : {std::size_t{512}, std::size_t{509}, std::size_t{3}})
        for (const layout l : {layout::soa, layout::aos_xyzw})
            for (const data d : all_data) {
                workspace<T> w(n, l);
                generator g(n);
                fill(w, g, d);
                raises_none(w, name_of(d));
                if (d != data::ordinary && d != data::same) continue;
                dilate(w, g, d == data::same);
                raises_none(w, std::string(name_of(d)) + ", with dilations");
            }
}

TEST_P(Exceptions, NoneButInexactIsRaisedOnOrdinaryAndStillDataFloat) { raises_none_on_any<float>(); }
TEST_P(Exceptions, NoneButInexactIsRaisedOnOrdinaryAndStillDataDouble) { raises_none_on_any<double>(); }

}  // namespace
}  // namespace swivel::tests
