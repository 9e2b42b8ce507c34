// What the contract in types.hpp promises of every operation, on every ISA.

#include <gtest/gtest.h>

#include <thread>

#include "support/operations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class EveryOperation : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, EveryOperation, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t widest_register = 16;

template <class T>
void expect_equal_outputs(workspace<T>& got, workspace<T>& want, const std::string& what) {
    for (std::size_t i = 0; i < got.size(); ++i) {
        const std::vector<T> a = got.outputs(i), b = want.outputs(i);
        for (std::size_t k = 0; k < a.size(); ++k)
            ASSERT_TRUE(same_bits(a[k], b[k]))
                << what << ", element " << i << " of " << got.size() << ", output " << k << ": " << a[k]
                << ", reference " << b[k] << "; q = " << got.q.get(i).x << ' ' << got.q.get(i).y << ' '
                << got.q.get(i).z << ' ' << got.q.get(i).w;
    }
}

template <class T>
void same_bits_as_reference() {
    for (const operation<T>& op : all_operations<T>())
        for (layout l : all_layouts)
            for (std::size_t n = 0; n <= 4 * widest_register + 1; ++n) {
                // The layouts that are staged differ only in how elements are fetched; an emulator is slow.
                if (l != layout::soa && l != layout::aos_xyzw && n % 9 != 0) continue;
                workspace<T> kernel(n, l), scalar(n, l);
                generator g(n * 7 + 1), again(n * 7 + 1);
                kernel.fill(g);
                scalar.fill(again);
                ASSERT_EQ(op.run(kernel, precision::reproducible), status::ok) << op.name;
                ASSERT_EQ(op.run_reference(scalar), status::ok) << op.name;
                expect_equal_outputs(kernel, scalar, op.name + ' ' + name(l));
                if (testing::Test::HasFatalFailure()) return;
            }
}

TEST_P(EveryOperation, ReproducibleHasTheBitsOfReferenceFloat) { same_bits_as_reference<float>(); }
TEST_P(EveryOperation, ReproducibleHasTheBitsOfReferenceDouble) { same_bits_as_reference<double>(); }

// Long runs cross the blocks through which strided views are staged.
template <class T>
void same_bits_over_many_blocks() {
    constexpr std::size_t n = 1031;
    for (const operation<T>& op : all_operations<T>())
        for (layout l : all_layouts) {
            workspace<T> kernel(n, l), scalar(n, l);
            generator g(5), again(5);
            kernel.fill(g);
            scalar.fill(again);
            ASSERT_EQ(op.run(kernel, precision::reproducible), status::ok) << op.name;
            ASSERT_EQ(op.run_reference(scalar), status::ok) << op.name;
            expect_equal_outputs(kernel, scalar, op.name + ' ' + name(l));
            if (testing::Test::HasFatalFailure()) return;
        }
}

TEST_P(EveryOperation, ReproducibleHasTheBitsOfReferenceOverManyBlocks) {
    same_bits_over_many_blocks<float>();
    same_bits_over_many_blocks<double>();
}

// One corner among regular elements, at every place of a register and of the tail, in both precisions: its
// result does not depend on the place, nor its neighbours' on it.
template <class T>
void same_bits_at_every_lane() {
    constexpr std::size_t n = 2 * widest_register + 3;
    const std::vector<quat<T>> corners = corner_rotations<T>();
    for (const operation<T>& op : all_operations<T>()) {
        if (!op.reads_q) continue;
        for (precision p : {precision::fast, precision::reproducible}) {
            workspace<T> regular(n, layout::soa);
            generator g(3);
            for (std::size_t i = 0; i < n; ++i) {
                regular.q.set(i, random_rotation<T>(g));
                regular.axes.set(i, random_direction<T>(g));
            }
            // The place must make no difference, so every element has the axis of the first.
            for (std::size_t i = 0; i < n; ++i) regular.axes.set(i, regular.axes.get(0));
            const auto refill = [&](workspace<T>& w) {
                for (std::size_t i = 0; i < n; ++i) {
                    w.q.set(i, regular.q.get(i));
                    w.axes.set(i, regular.axes.get(i));
                }
            };
            ASSERT_EQ(op.run(regular, p), status::ok);
            for (const quat<T>& corner : corners) {
                std::vector<T> first;
                workspace<T> w(n, layout::soa);
                for (std::size_t place = 0; place < n; ++place) {
                    refill(w);
                    w.q.set(place, corner);
                    ASSERT_EQ(op.run(w, p), status::ok);
                    for (std::size_t i = 0; i < n; ++i) {
                        const std::vector<T> got = w.outputs(i), want = regular.outputs(i);
                        if (i == place) {
                            if (first.empty()) first = got;
                            for (std::size_t k = 0; k < got.size(); ++k)
                                ASSERT_TRUE(same_bits(got[k], first[k])) << op.name << " at " << place;
                        } else {
                            for (std::size_t k = 0; k < got.size(); ++k)
                                ASSERT_TRUE(same_bits(got[k], want[k])) << op.name << " beside " << place;
                        }
                    }
                }
            }
        }
    }
}

TEST_P(EveryOperation, SameBitsAtEveryLanePositionFloat) { same_bits_at_every_lane<float>(); }
TEST_P(EveryOperation, SameBitsAtEveryLanePositionDouble) { same_bits_at_every_lane<double>(); }

template <class T>
void all_layouts_agree() {
    constexpr std::size_t n = 67;
    for (const operation<T>& op : all_operations<T>())
        for (precision p : {precision::fast, precision::reproducible}) {
            workspace<T> contiguous(n, layout::soa);
            generator g(11);
            contiguous.fill(g);
            ASSERT_EQ(op.run(contiguous, p), status::ok);
            for (layout l : all_layouts) {
                workspace<T> strided(n, l);
                generator again(11);
                strided.fill(again);
                ASSERT_EQ(op.run(strided, p), status::ok) << op.name;
                expect_equal_outputs(strided, contiguous, op.name + ' ' + name(l));
                if (testing::Test::HasFatalFailure()) return;
            }
        }
}

TEST_P(EveryOperation, GivesTheSameBitsInEveryLayout) {
    all_layouts_agree<float>();
    all_layouts_agree<double>();
}

// NaN and infinities, in each component of each input in turn.
template <class T>
void nan_stays() {
    constexpr std::size_t n = 2 * widest_register + 5;
    const T bad_values[] = {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(),
                            -std::numeric_limits<T>::infinity()};
    for (const operation<T>& op : all_operations<T>())
        for (precision p : {precision::fast, precision::reproducible}) {
            workspace<T> clean(n, layout::soa);
            generator g(17);
            clean.fill(g);
            ASSERT_EQ(op.run(clean, p), status::ok);
            const int components = op.reads_q ? (op.reads_own_axis ? 7 : 4)
                                   : op.name.find("compact") != std::string::npos ? 5
                                                                                  : 8;
            for (T bad : bad_values)
                for (int c = 0; c < components; ++c)
                    for (std::size_t place : {std::size_t{0}, std::size_t{7}, 2 * widest_register + 1}) {
                        workspace<T> w(n, layout::soa);
                        generator again(17);
                        w.fill(again);
                        if (op.reads_q)
                            (c < 4 ? w.q.at(c, place) : w.axes.at(c - 4, place)) = bad;
                        else if (components == 5)
                            w.factors_in.at(c, place) = bad;
                        else
                            (c < 4 ? w.swing_in.at(c, place) : w.twist_in.at(c - 4, place)) = bad;
                        ASSERT_EQ(op.run(w, p), status::ok);
                        for (std::size_t i = 0; i < n; ++i) {
                            const std::vector<T> got = w.outputs(i), want = clean.outputs(i);
                            for (std::size_t k = 0; k < got.size(); ++k) {
                                const bool written = want[k] != untouched<T>;
                                const bool sign = k + 1 == got.size() && op.name.ends_with("/signs");
                                if (i == place && written && !sign)
                                    ASSERT_TRUE(std::isnan(got[k]))
                                        << op.name << " component " << c << " = " << bad << ", output " << k
                                        << " is " << got[k];
                                else if (i == place && sign)
                                    ASSERT_EQ(std::fabs(got[k]), written ? T(1) : std::fabs(untouched<T>))
                                        << op.name;
                                else
                                    ASSERT_TRUE(same_bits(got[k], want[k])) << op.name << " element " << i;
                            }
                        }
                    }
        }
}

TEST_P(EveryOperation, NanAndInfinityStayInTheirElementAndComeOutAsNanFloat) { nan_stays<float>(); }
TEST_P(EveryOperation, NanAndInfinityStayInTheirElementAndComeOutAsNanDouble) { nan_stays<double>(); }

template <class T>
void finite_stays_finite() {
    workspace<T> w(1200, layout::soa);
    generator g(23);
    w.fill(g);
    for (const operation<T>& op : all_operations<T>())
        for (precision p : {precision::fast, precision::reproducible}) {
            ASSERT_EQ(op.run(w, p), status::ok);
            for (std::size_t i = 0; i < w.size(); ++i)
                for (T v : w.outputs(i)) ASSERT_TRUE(std::isfinite(v)) << op.name;
        }
}

TEST_P(EveryOperation, GivesNoNanWithoutOneInTheInput) {
    finite_stays_finite<float>();
    finite_stays_finite<double>();
}

TEST_P(EveryOperation, AcceptsSizeZeroWithNullPointers) {
    const quat_view<const float> none{nullptr, nullptr, nullptr, nullptr, 0};
    const quat_view<float> out{nullptr, nullptr, nullptr, nullptr, 0};
    EXPECT_EQ(decompose(none, axis::z, out, out), status::ok);
    EXPECT_EQ(decompose(none, vec3<float>{0, 0, 0}, out, out), status::ok);
    EXPECT_EQ(twist(none, axis::x, out), status::ok);
    EXPECT_EQ(swing(none, axis::x, out), status::ok);
    EXPECT_EQ(twist_angle(none, axis::x, scalar_view<float>{nullptr, 0}), status::ok);
    EXPECT_EQ(compose(none, none, out), status::ok);
    EXPECT_EQ(compose(factor_view<const float>{nullptr, nullptr, nullptr, nullptr, nullptr, 0}, axis::y, out),
              status::ok);
    EXPECT_EQ(decompose(none, axis::z, factor_view<float>{nullptr, nullptr, nullptr, nullptr, nullptr, 0}),
              status::ok);
}

// Eight threads over the same input with outputs of their own.
TEST_P(EveryOperation, GivesTheSameBitsFromManyThreads) {
    constexpr std::size_t n = 257;
    for (const operation<float>& op : all_operations<float>()) {
        workspace<float> want(n, layout::aos_xyzw);
        generator g(29);
        want.fill(g);
        ASSERT_EQ(op.run(want, precision::fast), status::ok);
        std::vector<std::unique_ptr<workspace<float>>> got;
        for (int t = 0; t < 8; ++t) {
            got.push_back(std::make_unique<workspace<float>>(n, layout::aos_xyzw));
            generator again(29);
            got.back()->fill(again);
        }
        std::vector<std::thread> threads;
        for (auto& w : got)
            threads.emplace_back([&op, &w] {
                for (int repeat = 0; repeat < 4; ++repeat) (void)op.run(*w, precision::fast);
            });
        for (std::thread& t : threads) t.join();
        for (auto& w : got) expect_equal_outputs(*w, want, op.name);
    }
}

}  // namespace
}  // namespace swivel::tests
