// What the contract in types.hpp promises of every operation, on every ISA.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "support/operations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class EveryOperation : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, EveryOperation, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t widest_register = 16;

template <class T>
std::string hexadecimal(T a) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", static_cast<double>(a));
    return text;
}

template <class T>
void expect_equal_outputs(const operation<T>& op, workspace<T>& got, workspace<T>& want,
                          const std::string& what) {
    for (std::size_t i = 0; i < got.size(); ++i) {
        const std::vector<T> a = op.outputs(got, i), b = op.outputs(want, i);
        for (std::size_t k = 0; k < a.size(); ++k)
            if (!same_bits(a[k], b[k])) {
                std::string inputs;
                for (any_buffer<T>* input : op.reads(got))
                    for (int c = 0; c < input->components(); ++c)
                        inputs += ' ' + hexadecimal(input->at(c, i));
                FAIL() << op.name << ' ' << what << ", element " << i << " of " << got.size() << ", output "
                       << k << ": " << hexadecimal(a[k]) << ", expected " << hexadecimal(b[k]) << "; inputs"
                       << inputs;
            }
    }
}

// n elements of a layout through every operation.
template <class T>
void same_bits_as_reference(std::size_t n, layout l) {
    workspace<T> kernel(n, l), scalar(n, l);
    generator g(n * 7 + 1), again(n * 7 + 1);
    kernel.fill(g);
    scalar.fill(again);
    for (const operation<T>& op : all_operations<T>()) {
        ASSERT_EQ(op.run(kernel, precision::reproducible), status::ok) << op.name;
        ASSERT_EQ(op.run_reference(scalar), status::ok) << op.name;
        expect_equal_outputs(op, kernel, scalar, name(l));
        if (testing::Test::HasFatalFailure()) return;
    }
}

template <class T>
void same_bits_as_reference() {
    for (const layout l : all_layouts)
        for (std::size_t n = 0; n <= 4 * widest_register + 1; ++n) {
            // The layouts that are staged differ only in how elements are fetched; an emulator is slow.
            if (l != layout::soa && l != layout::aos_xyzw && n % 9 != 0) continue;
            same_bits_as_reference<T>(n, l);
            if (testing::Test::HasFatalFailure()) return;
        }
}

TEST_P(EveryOperation, ReproducibleHasTheBitsOfReferenceFloat) { same_bits_as_reference<float>(); }
TEST_P(EveryOperation, ReproducibleHasTheBitsOfReferenceDouble) { same_bits_as_reference<double>(); }

// Long runs cross the blocks through which strided views are staged, of 128 elements at most.
TEST_P(EveryOperation, ReproducibleHasTheBitsOfReferenceOverManyBlocks) {
    for (const layout l : all_layouts) {
        same_bits_as_reference<float>(2 * 128 + 43, l);
        same_bits_as_reference<double>(2 * 128 + 43, l);
    }
}

template <class T>
void copy_element(const operation<T>& op, workspace<T>& from, std::size_t i, workspace<T>& to,
                  std::size_t place) {
    const buffers<T> source = op.reads(from), target = op.reads(to);
    for (std::size_t b = 0; b < source.size(); ++b)
        for (int c = 0; c < source[b]->components(); ++c) target[b]->at(c, place) = source[b]->at(c, i);
}

// One corner among regular elements, at every place of a register and of the tail, in both precisions: its
// result does not depend on the place, nor its neighbours' on it.
template <class T>
void same_bits_at_every_lane() {
    constexpr std::size_t n = 2 * widest_register + 3;
    workspace<T> corners(3 * 60, layout::soa), regular(n, layout::soa), w(n, layout::soa);
    generator g(3), other(4);
    corners.fill(g);
    {
        // All but every third element of a filled workspace are regular.
        workspace<T> filled(2 * n, layout::soa);
        filled.fill(other);
        for (const operation<T>& op : all_operations<T>())
            for (std::size_t i = 0; i < n; ++i) copy_element(op, filled, i + i / 2, regular, i);
    }
    for (const operation<T>& op : all_operations<T>())
        for (precision p : {precision::fast, precision::reproducible}) {
            ASSERT_EQ(op.run(regular, p), status::ok);
            std::vector<std::vector<T>> alone;
            for (std::size_t i = 0; i < n; ++i) {
                alone.push_back(op.outputs(regular, i));
                copy_element(op, regular, i, w, i);
            }
            for (std::size_t corner = 2; corner < corners.size(); corner += 3) {
                std::vector<T> first;
                for (std::size_t place = 0; place < n; ++place) {
                    copy_element(op, corners, corner, w, place);
                    ASSERT_EQ(op.run(w, p), status::ok);
                    copy_element(op, regular, place, w, place);
                    for (std::size_t i = 0; i < n; ++i) {
                        const std::vector<T> got = op.outputs(w, i);
                        if (i == place && first.empty()) first = got;
                        const std::vector<T>& want = i == place ? first : alone[i];
                        for (std::size_t k = 0; k < got.size(); ++k)
                            ASSERT_TRUE(same_bits(got[k], want[k]))
                                << op.name << (i == place ? " at " : " beside ") << place;
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
                expect_equal_outputs(op, strided, contiguous, name(l));
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
    workspace<T> clean(n, layout::soa), w(n, layout::soa);
    generator g(17), again(17);
    clean.fill(g);
    w.fill(again);
    for (const operation<T>& op : all_operations<T>())
        for (precision p : {precision::fast, precision::reproducible}) {
            ASSERT_EQ(op.run(clean, p), status::ok);
            std::vector<std::vector<T>> wanted;
            for (std::size_t i = 0; i < n; ++i) wanted.push_back(op.outputs(clean, i));
            for (T bad : bad_values)
                for (any_buffer<T>* input : op.reads(w)) {
                    // Only its sign bit counts.
                    if (input == &w.signs_in) continue;
                    for (int c = 0; c < input->components(); ++c)
                        for (std::size_t place : {std::size_t{0}, std::size_t{7}, 2 * widest_register + 1}) {
                            const T before = input->at(c, place);
                            input->at(c, place) = bad;
                            ASSERT_EQ(op.run(w, p), status::ok);
                            input->at(c, place) = before;
                            for (std::size_t i = 0; i < n; ++i) {
                                const std::vector<T> got = op.outputs(w, i), &want = wanted[i];
                                if (i == place && op.moves()) {
                                    ASSERT_TRUE(std::any_of(got.begin(), got.end(),
                                                            [](T v) { return !std::isfinite(v); }))
                                        << op.name << " component " << c << " = " << bad;
                                    continue;
                                }
                                for (std::size_t k = 0; k < got.size(); ++k) {
                                    const bool sign = op.is_kept_sign(k);
                                    if (i != place)
                                        ASSERT_TRUE(same_bits(got[k], want[k]))
                                            << op.name << " element " << i;
                                    else if (sign)
                                        ASSERT_EQ(std::fabs(got[k]), T(1)) << op.name;
                                    else
                                        ASSERT_TRUE(std::isnan(got[k]))
                                            << op.name << " component " << c << " = " << bad << ", output "
                                            << k << " is " << got[k];
                                }
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
                for (T v : op.outputs(w, i)) ASSERT_TRUE(std::isfinite(v)) << op.name;
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
        for (auto& w : got) expect_equal_outputs(op, *w, want, "");
    }
}

}  // namespace
}  // namespace swivel::tests
