// Motors as motions: products, conversions, points, blends, swing and twist.

#include "swivel/motor.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support/motors.hpp"
#include "support/usable_isas.hpp"
#include "swivel/decompose.hpp"

namespace swivel::tests {
namespace {

class Motor : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Motor, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 10007;

template <class T>
struct sampled {
    motor_buffer<T> a{n, layout::soa}, b{n, layout::soa}, out{n, layout::soa};
    vec3_buffer<T> points{n, layout::soa}, points_out{n, layout::soa};
    quat_buffer<T> q{n, layout::soa}, s{n, layout::soa}, t{n, layout::soa};

    explicit sampled(std::uint64_t seed) {
        generator g(seed);
        for (std::size_t i = 0; i < n; ++i) {
            a.set(i, rounded<T>(any_motion(g)));
            b.set(i, rounded<T>(any_motion(g)));
            q.set(i, random_rotation<T>(g));
            const vec3<T> d = random_direction<T>(g);
            const T length = static_cast<T>(uniform(g, 0, 4));
            points.set(i, {d.x * length, d.y * length, d.z * length});
        }
    }
};

template <class T>
double apart(const vec3<T>& got, const exact_vec3& want, long double size) {
    return static_cast<double>(norm(sum(widen<long double>(got), -1, want)) / std::max(1.0L, size)) /
           rounding_unit<T>;
}

long double size_of(const motion& m) { return norm(m.t); }

struct largest {
    double real = 0, dual = 0;
    void add(const motor_error& e) {
        real = std::max(real, e.real);
        dual = std::max(dual, e.dual);
    }
};

template <class T>
void multiply_is_one_after_the_other() {
    sampled<T> w(1);
    for (const precision p : both_precisions) {
        ASSERT_EQ(multiply(w.a.view(), w.b.view(), w.out.view(), {.accuracy = p}), status::ok);
        largest worst;
        for (std::size_t i = 0; i < n; ++i) {
            const exact_quat ar = widen<long double>(w.a.get(i).r), ad = widen<long double>(w.a.get(i).d),
                             br = widen<long double>(w.b.get(i).r), bd = widen<long double>(w.b.get(i).d);
            const exact_quat r = times(ar, br), d = sum(1, times(ar, bd), 1, times(ad, br));
            const long double size = std::max(norm(ad), norm(bd)) * 2;
            worst.real = std::max(
                worst.real, double(norm(minus(widen<long double>(w.out.get(i).r), r))) / rounding_unit<T>);
            worst.dual = std::max(worst.dual, double(norm(minus(widen<long double>(w.out.get(i).d), d)) /
                                                     std::max(1.0L, size)) /
                                                  rounding_unit<T>);
            const motion both = after(motion_of(w.a.get(i)), motion_of(w.b.get(i)));
            const motor_error e = distance(w.out.get(i), both, size);
            ASSERT_LE(e.real, 8) << i;
            ASSERT_LE(e.dual, 10) << i;
        }
        EXPECT_LE(worst.real, 3);
        EXPECT_LE(worst.dual, 2.5);
    }
}

TEST_P(Motor, MultiplyMovesOneAfterTheOther) {
    multiply_is_one_after_the_other<float>();
    multiply_is_one_after_the_other<double>();
}

TEST_P(Motor, ConjugateGoesBackExactly) {
    sampled<float> w(2);
    ASSERT_EQ(conjugate(w.a.view(), w.out.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        const dual_quaternion<float> m = w.a.get(i), c = w.out.get(i);
        ASSERT_EQ(c,
                  (dual_quaternion<float>{{-m.r.x, -m.r.y, -m.r.z, m.r.w}, {-m.d.x, -m.d.y, -m.d.z, m.d.w}}));
    }
    ASSERT_EQ(multiply(w.a.view(), w.out.view(), w.out.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        const motor_error e = distance(w.out.get(i), {{0, 0, 0, 1}, {0, 0, 0}}, 4);
        ASSERT_LE(e.real, 8);
        ASSERT_LE(e.dual, 10);
    }
}

// Off the manifold by a length and by a dual part along r.
template <class T>
void normalize_projects(int exponents) {
    sampled<T> w(3);
    generator g(4);
    for (std::size_t i = 0; i < n; ++i) {
        const T length =
            static_cast<T>(std::ldexp(uniform(g, 1, 2), static_cast<int>(uniform(g, -exponents, exponents))));
        const T along = static_cast<T>(uniform(g, -2, 2));
        const dual_quaternion<T> m = w.a.get(i);
        const auto off = [&](T r, T d) { return length * (d + along * r); };
        w.a.set(i, {{length * m.r.x, length * m.r.y, length * m.r.z, length * m.r.w},
                    {off(m.r.x, m.d.x), off(m.r.y, m.d.y), off(m.r.z, m.d.z), off(m.r.w, m.d.w)}});
    }
    for (const precision p : both_precisions) {
        ASSERT_EQ(normalize(w.a.view(), w.out.view(), {.accuracy = p}), status::ok);
        largest worst;
        for (std::size_t i = 0; i < n; ++i) {
            const exact_quat r = widen<long double>(w.a.get(i).r), d = widen<long double>(w.a.get(i).d);
            const long double length = norm(r), along = dot(r, d) / (length * length);
            const exact_quat want_r = sum(1 / length, r, 0, r),
                             want_d = sum(1 / length, d, -along / length, r);
            const long double size = std::max(1.0L, norm(d) / length);
            worst.add(
                {double(norm(minus(widen<long double>(w.out.get(i).r), want_r))) / rounding_unit<T>,
                 double(norm(minus(widen<long double>(w.out.get(i).d), want_d)) / size) / rounding_unit<T>});
        }
        EXPECT_LE(worst.real, p == precision::fast ? 4.5 : 3);
        EXPECT_LE(worst.dual, p == precision::fast ? 8 : 6);
    }
}

TEST_P(Motor, NormalizeProjectsOnTheManifoldFromAnyLength) {
    normalize_projects<float>(50);
    normalize_projects<double>(400);
}

TEST_P(Motor, NormalizeGivesTheIdentityForNothing) {
    motor_buffer<float> m(2, layout::soa);
    m.set(0, {{0, 0, 0, 0}, {1, 2, 3, 4}});
    m.set(1, {{0, -0.0F, 0, 0}, {0, 0, 0, 0}});
    for (const precision p : both_precisions) {
        motor_buffer<float> out(2, layout::soa);
        ASSERT_EQ(normalize(m.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_LE(distance(out.get(i), {{0, 0, 0, 1}, {0, 0, 0}}, 0).real, p == precision::fast ? 3 : 0);
        for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(out.get(i).d, (quat<float>{0, 0, 0, 0}));
    }
}

template <class T>
void rotation_and_translation() {
    sampled<T> w(5);
    for (const precision p : both_precisions) {
        ASSERT_EQ(from_rotation_translation(w.q.view(), w.points.view(), w.out.view(), {.accuracy = p}),
                  status::ok);
        double from = 0, to = 0;
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(w.out.get(i).r, w.q.get(i));
            const exact_vec3 t = widen<long double>(w.points.get(i));
            const exact_quat q = widen<long double>(w.q.get(i)), d = times(exact_quat{t.x, t.y, t.z, 0}, q);
            from = std::max(from, double(norm(minus(widen<long double>(w.out.get(i).d), sum(0.5L, d, 0, d))) /
                                         std::max(1.0L, norm(t))) /
                                      rounding_unit<T>);
        }
        EXPECT_LE(from, 1.5);
        ASSERT_EQ(to_rotation_translation(w.out.view(), w.s.view(), w.points_out.view(), {.accuracy = p}),
                  status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(w.s.get(i), w.q.get(i));
            const exact_vec3 t = widen<long double>(w.points.get(i));
            to = std::max(to, apart(w.points_out.get(i), t, norm(t)));
        }
        EXPECT_LE(to, 6);
    }
}

TEST_P(Motor, FromAndToRotationAndTranslationKeepTheRotationInBits) {
    rotation_and_translation<float>();
    rotation_and_translation<double>();
}

template <class T>
void transform_moves_points() {
    sampled<T> w(6);
    for (const precision p : both_precisions) {
        ASSERT_EQ(transform(w.a.view(), w.points.view(), w.points_out.view(), {.accuracy = p}), status::ok);
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const motion m = motion_of(w.a.get(i));
            const exact_vec3 point = widen<long double>(w.points.get(i));
            worst = std::max(worst,
                             apart(w.points_out.get(i), moved(m, point), std::max(norm(point), size_of(m))));
        }
        EXPECT_LE(worst, 10);
    }
    // One motor for all.
    const dual_quaternion<T> m = w.a.get(3);
    motor_buffer<T> each(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) each.set(i, m);
    vec3_buffer<T> want(n, layout::soa);
    ASSERT_EQ(transform(each.view(), w.points.view(), want.view()), status::ok);
    motor_view<const T> one = w.a.view();
    const T values[] = {m.r.x, m.r.y, m.r.z, m.r.w, m.d.x, m.d.y, m.d.z, m.d.w};
    one = {values, values + 1, values + 2, values + 3, values + 4, values + 5, values + 6, values + 7, n, 0};
    ASSERT_EQ(transform(one, w.points.view(), w.points.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(w.points.get(i), want.get(i));
}

TEST_P(Motor, TransformMovesPointsByOneMotorForAllAndInPlaceToo) {
    transform_moves_points<float>();
    transform_moves_points<double>();
}

template <class T>
void blend_is_the_normalised_sum() {
    sampled<T> w(7);
    generator g(8);
    motor_buffer<T> c(n, layout::aos_xyzw);
    scalar_buffer<T> weight(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        c.set(i, random_motor<T>(g, 3));
        weight[i] = static_cast<T>(uniform(g, 0, 1));
    }
    const motor_view<const T> motors[] = {w.a.view(), w.b.view(), c.view()};
    const parameter<T> weights[] = {T(0.25), weight.view(), T(0.5)};
    for (const precision p : both_precisions) {
        ASSERT_EQ(blend(motors, weights, w.out.view(), {.accuracy = p}), status::ok);
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            exact_quat r{0, 0, 0, 0}, d = r;
            long double magnitudes = 0, size = 1;
            const exact_quat first = widen<long double>(w.a.get(i).r);
            const dual_quaternion<T> parts[] = {w.a.get(i), w.b.get(i), c.get(i)};
            const long double by[] = {0.25L, weight[i], 0.5L};
            for (int k = 0; k < 3; ++k) {
                const exact_quat mr = widen<long double>(parts[k].r), md = widen<long double>(parts[k].d);
                const long double s = dot(first, mr) < 0 ? -by[k] : by[k];
                r = sum(1, r, s, mr);
                d = sum(1, d, s, md);
                magnitudes += by[k];
                size = std::max(size, 2 * norm(md));
            }
            const long double length = norm(r), along = dot(r, d) / (length * length);
            const double scale = double(length / magnitudes) / rounding_unit<T>;
            const exact_quat got_r = widen<long double>(w.out.get(i).r),
                             got_d = widen<long double>(w.out.get(i).d);
            worst = std::max(worst, double(norm(minus(got_r, sum(1 / length, r, 0, r)))) * scale);
            worst =
                std::max(worst, double(norm(minus(got_d, sum(1 / length, d, -along / length, r))) / size) *
                                    scale * std::min(1.0, double(length / magnitudes)));
        }
        EXPECT_LE(worst, 5);
    }
}

TEST_P(Motor, BlendIsTheNormalisedSumAlignedInSign) {
    blend_is_the_normalised_sum<float>();
    blend_is_the_normalised_sum<double>();
}

TEST_P(Motor, BlendChecksEverythingBeforeItWrites) {
    motor_buffer<float> a(5, layout::soa), b(5, layout::soa), out(5, layout::soa);
    const motor_view<const float> motors[] = {a.view(), b.view()};
    const parameter<float> weights[] = {0.5F, 0.5F};
    const auto both = [&](const motor_view<float>& to) { return blend(motors, weights, to); };
    EXPECT_EQ(blend(motors, std::span(weights, 1), out.view()), status::size_mismatch);
    EXPECT_EQ(blend(std::span(motors, 0), std::span(weights, 0), out.view()), status::bad_argument);
    motor_view<float> view = out.view();
    view.size = 4;
    EXPECT_EQ(both(view), status::size_mismatch);
    view = out.view();
    view.dy = nullptr;
    EXPECT_EQ(both(view), status::null_stream);
    view = b.view();
    ++view.x;
    EXPECT_EQ(both(view), status::partial_overlap);
    EXPECT_EQ(blend(motors, weights, out.view(), {.accuracy = static_cast<precision>(9)}),
              status::bad_argument);
    for (float v : out.memory()) EXPECT_EQ(v, untouched<float>);
    for (std::size_t i = 0; i < 5; ++i) a.set(i, {{0, 0, 0, 1}, {1, 0, 0, 0}});
    for (std::size_t i = 0; i < 5; ++i) b.set(i, {{0, 0, 0, -1}, {-3, 0, 0, 0}});
    // In place of the second one, whose sign is turned.
    ASSERT_EQ(blend(motors, weights, b.view(), {.accuracy = precision::reproducible}), status::ok);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(b.get(i), (dual_quaternion<float>{{0, 0, 0, 1}, {2, 0, 0, 0}}));
}

template <class T>
void swing_and_twist() {
    sampled<T> w(9);
    generator g(10);
    const vec3<T> axis{T(0.36), T(-0.48), T(0.8)};
    for (const precision p : both_precisions)
        for (const product order : {product::swing_twist, product::twist_swing}) {
            const options o{.order = order, .accuracy = p};
            ASSERT_EQ(decompose(w.a.view(), axis, w.s.view(), w.t.view(), w.points_out.view(), o),
                      status::ok);
            double translation = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const motion m = motion_of(w.a.get(i));
                translation = std::max(translation, apart(w.points_out.get(i), m.t, size_of(m)));
            }
            EXPECT_LE(translation, 6);
            // The rotation's factors, in bits.
            const motor_view<const T> m = w.a.view();
            quat_buffer<T> swing(n, layout::soa), twist(n, layout::soa);
            ASSERT_EQ(decompose(quat_view<const T>{m.x, m.y, m.z, m.w, n}, twist_axis<T>(axis), swing.view(),
                                twist.view(), o),
                      status::ok);
            for (std::size_t i = 0; i < n; ++i) {
                ASSERT_EQ(swing.get(i), w.s.get(i));
                ASSERT_EQ(twist.get(i), w.t.get(i));
            }
            ASSERT_EQ(compose(w.s.view(), w.t.view(), w.points_out.view(), w.out.view(), o), status::ok);
            largest worst;
            for (std::size_t i = 0; i < n; ++i) {
                const motion in = motion_of(w.a.get(i));
                worst.add(distance(w.out.get(i), in, size_of(in)));
            }
            EXPECT_LE(worst.real, 9);
            EXPECT_LE(worst.dual, 7);
        }
}

TEST_P(Motor, SwingAndTwistOfTheRotationAndTheTranslationMakeTheMotorAgain) {
    swing_and_twist<float>();
    swing_and_twist<double>();
}

TEST_P(Motor, SwingAndTwistWithAPureTranslation) {
    motor_buffer<double> m(1, layout::soa), out(1, layout::soa);
    quat_buffer<double> s(1, layout::soa), t(1, layout::soa);
    vec3_buffer<double> moves(1, layout::soa);
    m.set(0, {{0, 0, 0, 1}, {0.5, 1, -1.5, 0}});
    const options o{.accuracy = precision::reproducible};
    ASSERT_EQ(decompose(m.view(), axis::y, s.view(), t.view(), moves.view(), o), status::ok);
    EXPECT_EQ(s.get(0), (quat<double>{0, 0, 0, 1}));
    EXPECT_EQ(t.get(0), (quat<double>{0, 0, 0, 1}));
    EXPECT_EQ(moves.get(0), (vec3<double>{1, 2, -3}));
    ASSERT_EQ(compose(s.view(), t.view(), moves.view(), out.view(), o), status::ok);
    EXPECT_EQ(out.get(0), m.get(0));
}

TEST_P(Motor, ArraysOfMotorsAreTakenAsTheyLie) {
    std::array<float, 8 * 9> memory{}, want{};
    generator g(11);
    motor_buffer<float> soa(9, layout::soa);
    for (std::size_t i = 0; i < 9; ++i) {
        soa.set(i, random_motor<float>(g, 2));
        for (int c = 0; c < 8; ++c) memory[8 * i + static_cast<std::size_t>(c)] = soa.at(c, i);
    }
    const motor_view<float> array = aos_motors(memory.data(), 9);
    ASSERT_EQ(square_root(soa.view(), soa.view()), status::ok);
    ASSERT_EQ(square_root(array, array), status::ok);
    for (std::size_t i = 0; i < 9; ++i)
        for (int c = 0; c < 8; ++c) want[8 * i + static_cast<std::size_t>(c)] = soa.at(c, i);
    EXPECT_EQ(memory, want);
    EXPECT_EQ(multiply(aos_motors<float>(nullptr, 3), array, array), status::size_mismatch);
    EXPECT_EQ(conjugate(aos_motors<float>(nullptr, 9), array), status::null_stream);
}

}  // namespace
}  // namespace swivel::tests
