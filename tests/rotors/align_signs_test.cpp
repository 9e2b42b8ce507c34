// align_signs along a sequence, whose elements depend on one another.

#include "swivel/align_signs.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "support/buffers.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/reference.hpp"

namespace swivel::tests {
namespace {

class AlignSigns : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, AlignSigns, testing::ValuesIn(usable_isas()), isa_name);

template <class T>
quat<T> negative(const quat<T>& q) {
    return {-q.x, -q.y, -q.z, -q.w};
}

// A curve over time whose steps are small: half a degree and some of the half-angle.
template <class T>
quat<T> on_curve(std::size_t i) {
    const double t = 0.01 * static_cast<double>(i);
    const double x = std::sin(t), y = std::sin(0.7 * t + 1), z = std::cos(0.3 * t), w = std::cos(1.3 * t);
    const double s = 1 / std::sqrt(x * x + y * y + z * z + w * w + 1e-9);
    return rounded<T>(x * s, y * s, z * s, w * s);
}

template <class T>
void expect_same(quat_buffer<T>& got, quat_buffer<T>& want, const std::string& what) {
    for (std::size_t i = 0; i < got.size(); ++i)
        for (int c = 0; c < 4; ++c)
            ASSERT_TRUE(same_bits(got.at(c, i), want.at(c, i)))
                << what << ", element " << i << " of " << got.size();
}

template <class T>
void restores_a_curve() {
    generator g(1);
    for (std::size_t n : {1U, 2U, 15U, 255U, 256U, 257U, 511U, 512U, 513U, 5000U})
        for (layout l : all_layouts)
            for (precision p : both_precisions) {
                quat_buffer<T> curve(n, l), q(n, l), out(n, l);
                for (std::size_t i = 0; i < n; ++i) {
                    curve.set(i, on_curve<T>(i));
                    q.set(i, i != 0 && g() % 2 != 0 ? negative(on_curve<T>(i)) : on_curve<T>(i));
                }
                ASSERT_EQ(align_signs(q.view(), out.view(), {.accuracy = p}), status::ok);
                expect_same(out, curve, name(l));
                ASSERT_EQ(align_signs(q.view(), q.view(), {.accuracy = p}), status::ok);
                expect_same(q, curve, name(l) + " in place");
            }
}

TEST_P(AlignSigns, ACurveWhoseSignsFlipAtRandomIsContinuousAgain) {
    restores_a_curve<float>();
    restores_a_curve<double>();
}

TEST_P(AlignSigns, TheFirstElementStaysAsItIs) {
    quat_buffer<float> q(300, layout::soa), out(300, layout::soa);
    for (std::size_t i = 0; i < q.size(); ++i)
        q.set(i, i % 2 != 0 ? on_curve<float>(i) : negative(on_curve<float>(i)));
    ASSERT_EQ(align_signs(q.view(), out.view()), status::ok);
    for (std::size_t i = 0; i < q.size(); ++i) ASSERT_EQ(out.get(i), negative(on_curve<float>(i)));
}

// Rotations, corners (zeros and lengths of all sizes among them), NaN and infinities in any order.
template <class T>
void fill_with_anything(quat_buffer<T>& q, generator& g) {
    const std::vector<quat<T>> corners = corner_rotations<T>();
    const T bad[] = {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(),
                     -std::numeric_limits<T>::infinity()};
    for (std::size_t i = 0; i < q.size(); ++i) {
        q.set(i, g() % 3 == 0 ? corners[g() % corners.size()] : random_rotation<T>(g));
        if (g() % 5 == 0) q.at(static_cast<int>(g() % 4), i) = bad[g() % 3];
    }
}

template <class T>
void same_bits_as_reference() {
    generator g(2);
    for (std::size_t n = 0; n <= 1031; n += n < 70 ? 1 : 31)
        for (layout l : all_layouts) {
            quat_buffer<T> q(n, l), out(n, l), want(n, l);
            fill_with_anything(q, g);
            ASSERT_EQ(reference::align_signs(q.view(), want.view()), status::ok);
            ASSERT_EQ(align_signs(q.view(), out.view(), {.accuracy = precision::reproducible}), status::ok);
            expect_same(out, want, name(l));
            ASSERT_EQ(align_signs(q.view(), q.view(), {.accuracy = precision::reproducible}), status::ok);
            expect_same(q, want, name(l) + " in place");
            std::size_t written = 0;
            for (T v : out.memory()) written += !(v == untouched<T>);
            ASSERT_EQ(written, 4 * n);
        }
}

TEST_P(AlignSigns, ReproducibleHasTheBitsOfReferenceWhateverIsInTheSequence) {
    same_bits_as_reference<float>();
    same_bits_as_reference<double>();
}

// Each in turn, at the places where a block begins too.
template <class T>
void nan_is_passed_over() {
    constexpr std::size_t n = 600;
    generator g(3);
    for (precision p : both_precisions)
        for (std::size_t bad : {0U, 1U, 17U, 254U, 255U, 256U, 257U, 511U, 512U, 599U})
            for (std::size_t run : {1U, 2U, 300U}) {
                quat_buffer<T> q(n, layout::soa), out(n, layout::soa);
                for (std::size_t i = 0; i < n; ++i)
                    q.set(i, g() % 2 != 0 ? on_curve<T>(i) : negative(on_curve<T>(i)));
                const std::size_t end = std::min(bad + run, n);
                for (std::size_t i = bad; i < end; ++i)
                    q.at(static_cast<int>(g() % 4), i) = std::numeric_limits<T>::quiet_NaN();
                ASSERT_EQ(align_signs(q.view(), out.view(), {.accuracy = p}), status::ok);
                quat<wide<T>> last{};
                for (std::size_t i = 0; i < n; ++i) {
                    if (i >= bad && i < end) {
                        for (int c = 0; c < 4; ++c) ASSERT_TRUE(same_bits(out.at(c, i), q.at(c, i))) << i;
                        continue;
                    }
                    const quat<wide<T>> e = widen<wide<T>>(out.get(i));
                    ASSERT_GE(double(dot(e, last)), 0.0) << i << " after " << bad << ' ' << run;
                    last = e;
                }
            }
}

TEST_P(AlignSigns, AnElementWithANanStaysAsItIsAndTheNextOneGoesOnFromTheOneBefore) {
    nan_is_passed_over<float>();
    nan_is_passed_over<double>();
}

TEST_P(AlignSigns, AZeroProductLeavesTheElementAsItIs) {
    const quat<double> sequence[] = {{0, 0, 0, 1}, {0, 0, 0, -1}, {-1, 0, 0, 0}, {0.5, -0.5, 0.5, 0.5},
                                     {0, 0, 0, 0}, {0, 0, 0, -1}, {0, 0, 0, 1}};
    const quat<double> want[] = {{0, 0, 0, 1}, {0, 0, 0, 1},  {-1, 0, 0, 0}, {-0.5, 0.5, -0.5, -0.5},
                                 {0, 0, 0, 0}, {0, 0, 0, -1}, {0, 0, 0, -1}};
    quat_buffer<double> q(std::size(sequence), layout::soa), out(std::size(sequence), layout::soa);
    for (std::size_t i = 0; i < q.size(); ++i) q.set(i, sequence[i]);
    for (precision p : both_precisions) {
        ASSERT_EQ(align_signs(q.view(), out.view(), {.accuracy = p}), status::ok);
        for (std::size_t i = 0; i < q.size(); ++i) ASSERT_EQ(out.get(i), want[i]) << i;
    }
}

TEST_P(AlignSigns, DoneTwiceIsDoneOnce) {
    generator g(4);
    quat_buffer<float> q(1000, layout::soa), out(1000, layout::soa), twice(1000, layout::soa);
    fill_with_anything(q, g);
    for (precision p : both_precisions) {
        ASSERT_EQ(align_signs(q.view(), out.view(), {.accuracy = p}), status::ok);
        ASSERT_EQ(align_signs(out.view(), twice.view(), {.accuracy = p}), status::ok);
        expect_same(twice, out, "twice");
    }
}

TEST_P(AlignSigns, StreamsMayBePairedInAnyOrderInPlace) {
    constexpr std::size_t n = 700;
    generator g(5);
    quat_buffer<float> q(n, layout::soa), want(n, layout::soa);
    fill_with_anything(q, g);
    ASSERT_EQ(align_signs(q.view(), want.view()), status::ok);
    const quat_view<float> in = q.view(), rolled = soa(in.w, in.x, in.y, in.z, n);
    ASSERT_EQ(align_signs(in, rolled), status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        const float got[] = {rolled.x[i], rolled.y[i], rolled.z[i], rolled.w[i]};
        for (int c = 0; c < 4; ++c) ASSERT_TRUE(same_bits(got[c], want.at(c, i))) << i;
    }
}

TEST_P(AlignSigns, RefusesWhatEveryOperationRefusesWithNothingWritten) {
    constexpr std::size_t n = 40;
    quat_buffer<float> q(n, layout::soa), out(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) q.set(i, negative(on_curve<float>(i)));
    const quat_view<float> to = out.view();
    EXPECT_EQ(align_signs(soa<const float>(nullptr, q.first(1), q.first(2), q.first(3), n), to),
              status::null_stream);
    quat_view<float> shorter = to;
    shorter.size = n - 1;
    EXPECT_EQ(align_signs(q.view(), shorter), status::size_mismatch);
    EXPECT_EQ(align_signs(q.view(), soa(to.x, to.x, to.z, to.w, n)), status::partial_overlap);
    EXPECT_EQ(align_signs(q.view(), quat_view<float>{to.x, to.y, to.z, to.w, n, 0}), status::bad_argument);
    EXPECT_EQ(align_signs(q.view(), to, {.accuracy = static_cast<precision>(7)}), status::bad_argument);
    for (float v : out.memory()) ASSERT_EQ(v, untouched<float>);
    EXPECT_EQ(align_signs(quat_view<const float>{}, quat_view<float>{}), status::ok);
}

}  // namespace
}  // namespace swivel::tests
