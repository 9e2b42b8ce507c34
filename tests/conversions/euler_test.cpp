#include "swivel/euler.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/buffers.hpp"
#include "support/bvh_text.hpp"
#include "support/exact.hpp"
#include "support/rotations.hpp"
#include "support/usable_isas.hpp"
#include "swivel/clip/read.hpp"
#include "swivel/reference.hpp"

namespace swivel::tests {
namespace {

class Euler : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Euler, testing::ValuesIn(usable_isas()), isa_name);

constexpr double pi = std::numbers::pi;

struct named_order {
    euler_order order;
    const char* axes;
};
constexpr named_order all_orders[] = {
    {euler_order::xyz, "xyz"}, {euler_order::xzy, "xzy"}, {euler_order::yxz, "yxz"},
    {euler_order::yzx, "yzx"}, {euler_order::zxy, "zxy"}, {euler_order::zyx, "zyx"},
    {euler_order::xyx, "xyx"}, {euler_order::xzx, "xzx"}, {euler_order::yxy, "yxy"},
    {euler_order::yzy, "yzy"}, {euler_order::zxz, "zxz"}, {euler_order::zyz, "zyz"}};

// The bounds of euler.hpp.
constexpr double from_bound = 4.5, back_bound = 8, angle_bound = 7;
template <class T>
constexpr double lock = sizeof(T) == 4 ? 0x1p-23 : 0x1p-52;

template <class V>
auto& component(V& v, char c) {
    return c == 'x' ? v.x : c == 'y' ? v.y : v.z;
}

bool is_proper(const char* axes) { return axes[0] == axes[2]; }

// The axis of the third rotation, or the one that is left.
char last_axis(const char* axes) {
    return is_proper(axes) ? static_cast<char>('x' + 'y' + 'z' - axes[0] - axes[1]) : axes[2];
}

// By axis, or one after the other.
template <class V>
auto& angle(V& v, const char* axes, int k) {
    return component(v, is_proper(axes) ? "xyz"[k] : axes[k]);
}

// The definition: the rotation named first is the outermost.
template <class W>
quat<W> product_of_turns(const vec3<W>& radians, const char* axes) {
    quat<W> q{0, 0, 0, 1};
    for (int k = 0; k < 3; ++k) {
        const W half = angle(radians, axes, k) / 2;
        quat<W> turn{0, 0, 0, cosine(half)};
        component(turn, axes[k]) = sine(half);
        q = times(q, turn);
    }
    return q;
}

template <class T>
double distance_but_for_sign(const quat<T>& got, const quat<wide<T>>& want) {
    using W = wide<T>;
    const quat<W> a = widen<W>(got), other{-want.x, -want.y, -want.z, -want.w};
    return double(dot(a, want) > 0 ? norm(minus(a, want)) : norm(minus(a, other)));
}

template <class T>
void from_is_the_product() {
    using W = wide<T>;
    constexpr std::size_t n = 10007;
    generator g(1);
    vec3_buffer<T> radians(n, layout::soa);
    quat_buffer<T> q(n, layout::soa);
    const T corners[] = {0,
                         T(-0.0),
                         T(pi),
                         T(-pi),
                         T(pi / 2),
                         T(-pi / 2),
                         std::numeric_limits<T>::denorm_min(),
                         sizeof(T) == 4 ? T(0x1p14) : T(0x1p21)};
    for (std::size_t i = 0; i < n; ++i) {
        const auto angle = [&] {
            return i % 4 == 0 ? corners[g() % std::size(corners)] : static_cast<T>(uniform(g, -10, 10));
        };
        radians.set(i, {angle(), angle(), angle()});
    }
    for (const precision p : both_precisions)
        for (const named_order& o : all_orders) {
            ASSERT_EQ(from_euler(radians.view(), o.order, q.view(), {.accuracy = p}), status::ok);
            double worst = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const quat<W> want = product_of_turns(widen<W>(radians.get(i)), o.axes);
                worst = std::max(worst, double(norm(minus(widen<W>(q.get(i)), want))));
            }
            EXPECT_LE(worst / rounding_unit<T>, from_bound) << o.axes << ' ' << name(p);
        }
}

TEST_P(Euler, FromIsTheProductOfThreeTurnsFloat) { from_is_the_product<float>(); }
TEST_P(Euler, FromIsTheProductOfThreeTurnsDouble) { from_is_the_product<double>(); }

TEST_P(Euler, OrdersAreThoseOfTheChannelsOfABvhFile) {
    for (const named_order& o : all_orders) {
        if (is_proper(o.axes)) continue;
        std::string channels = "CHANNELS 3";
        for (int k = 0; k < 3; ++k)
            channels += ' ' + std::string(1, static_cast<char>(o.axes[k] - 'x' + 'X')) + "rotation";
        const clip::read_result read =
            clip::read_bvh(clip::with("CHANNELS 3 Xrotation Yrotation Zrotation", channels));
        ASSERT_TRUE(bool(read)) << o.axes;
        quat_buffer<double> of_clip(2, layout::soa);
        ASSERT_EQ(clip::joint_rotations(*read.value, 1, of_clip.view()), status::ok);
        vec3_buffer<double> radians(2, layout::soa);
        quat_buffer<double> q(2, layout::soa);
        // 4 5 6 and 10 11 12 degrees, in the order of the channels.
        for (std::size_t frame = 0; frame < 2; ++frame) {
            vec3<double> a{};
            for (int k = 0; k < 3; ++k)
                angle(a, o.axes, k) = (4 + k + 6 * static_cast<double>(frame)) * pi / 180;
            radians.set(frame, a);
        }
        ASSERT_EQ(from_euler(radians.view(), o.order, q.view()), status::ok);
        for (std::size_t frame = 0; frame < 2; ++frame)
            EXPECT_LE(norm(minus(q.get(frame), of_clip.get(frame))), 1e-15) << o.axes;
    }
}

// Random ones, some with the second angle at every distance from +-90 degrees, of proper orders from 0 and 180, some
// in the lock itself, of all lengths.
template <class T>
std::vector<quat<T>> all_rotations(generator& g, const char* axes, bool any_length) {
    std::vector<quat<T>> all;
    for (int i = 0; i < 2500; ++i) all.push_back(random_rotation<T>(g));
    const auto add = [&](double off, double first, double third) {
        vec3<double> a{};
        const bool one_side = g() % 2 == 0;
        angle(a, axes, 0) = first;
        if (is_proper(axes))
            angle(a, axes, 1) = one_side ? off : pi - off;
        else
            angle(a, axes, 1) = (one_side ? 1 : -1) * (pi / 2 - off);
        angle(a, axes, 2) = third;
        const quat<double> q = product_of_turns(a, axes);
        all.push_back(rounded<T>(q.x, q.y, q.z, q.w));
    };
    for (int e = -1; e >= -60; --e)
        for (int i = 0; i < 20; ++i)
            add(std::ldexp(uniform(g, 1, 2), e), uniform(g, -pi, pi), uniform(g, -pi, pi));
    for (int i = 0; i < 500; ++i) add(0, uniform(g, -pi, pi), uniform(g, -pi, pi));
    for (int i = -4; i <= 4; ++i)
        for (int k = -4; k <= 4; ++k)
            for (const double off : {0.0, 0.0, pi / 4, pi / 2, 3 * pi / 4}) add(off, i * pi / 4, k * pi / 4);
    // Exactly in the lock: the components are equal in pairs, or two of them are 0.
    for (int i = 0; i < 500; ++i) {
        const quat<T> r = random_rotation<T>(g);
        quat<T> q{};
        const T sign = g() % 2 == 0 ? T(1) : T(-1);
        const bool odd = (axes[1] - axes[0] + 3) % 3 == 2;
        if (is_proper(axes)) {
            (sign > 0 ? q.w : component(q, axes[1])) = r.w;
            component(q, sign > 0 ? axes[0] : last_axis(axes)) = r.x;
        } else {
            q.w = r.w;
            component(q, axes[1]) = sign * r.w;
            component(q, axes[0]) = r.x;
            component(q, axes[2]) = odd ? -sign * r.x : sign * r.x;
        }
        const T length = static_cast<T>(1 / norm(widen<double>(q)));
        all.push_back({q.x * length, q.y * length, q.z * length, q.w * length});
    }
    for (const quat<T>& q : corner_rotations<T>()) {
        const double n = norm(widen<double>(q));
        if (n > 0.1 && n < 10) all.push_back(q);
    }
    if (any_length)
        for (quat<T>& q : all) {
            const int range = sizeof(T) == 4 ? 80 : 900, least = sizeof(T) == 4 ? -23 : -399;
            const T by =
                static_cast<T>(std::ldexp(1.0, static_cast<int>(g() % static_cast<unsigned>(range)) + least));
            q = {q.x * by, q.y * by, q.z * by, q.w * by};
        }
    return all;
}

template <class T>
void recomposes() {
    using W = wide<T>;
    for (const named_order& o : all_orders)
        for (const bool any_length : {false, true}) {
            generator g(2);
            const std::vector<quat<T>> all = all_rotations<T>(g, o.axes, any_length);
            const std::size_t n = all.size();
            quat_buffer<T> q(n, layout::soa), back(n, layout::soa);
            vec3_buffer<T> radians(n, layout::soa), scalar(n, layout::soa);
            for (std::size_t i = 0; i < n; ++i) q.set(i, all[i]);
            for (const precision p : both_precisions) {
                ASSERT_EQ(to_euler(q.view(), o.order, radians.view(), {.accuracy = p}), status::ok);
                ASSERT_EQ(from_euler(radians.view(), o.order, back.view(), {.accuracy = p}), status::ok);
                double worst = 0;
                for (std::size_t i = 0; i < n; ++i) {
                    const vec3<T> a = radians.get(i);
                    const T second = angle(a, o.axes, 1);
                    ASSERT_LE(std::fabs(angle(a, o.axes, 0)), T(pi)) << i;
                    if (is_proper(o.axes))
                        ASSERT_TRUE(second >= 0 && second <= T(pi)) << i << ": " << second;
                    else
                        ASSERT_LE(std::fabs(second), T(pi / 2)) << i;
                    ASSERT_LE(std::fabs(angle(a, o.axes, 2)), T(pi)) << i;
                    const quat<W> in = widen<W>(all[i]);
                    const W length = norm(in);
                    worst = std::max(worst,
                                     distance_but_for_sign<T>(back.get(i), {in.x / length, in.y / length,
                                                                            in.z / length, in.w / length}));
                }
                EXPECT_LE(worst / rounding_unit<T>, back_bound) << o.axes << ' ' << name(p);
            }
            ASSERT_EQ(reference::to_euler(q.view(), o.order, scalar.view()), status::ok);
            for (std::size_t i = 0; i < n; ++i)
                for (int c = 0; c < 3; ++c)
                    ASSERT_TRUE(same_bits(radians.at(c, i), scalar.at(c, i))) << o.axes << ' ' << i;
        }
}

TEST_P(Euler, FromOfToIsTheRotationInAndNearTheLockTooFloat) { recomposes<float>(); }
TEST_P(Euler, FromOfToIsTheRotationInAndNearTheLockTooDouble) { recomposes<double>(); }

template <class T>
void angles() {
    using W = wide<T>;
    const W whole = W(6.283185307179586476925286766559005768L);
    for (const named_order& o : all_orders) {
        generator g(3);
        const std::vector<quat<T>> all = all_rotations<T>(g, o.axes, true);
        const std::size_t n = all.size();
        quat_buffer<T> q(n, layout::soa);
        vec3_buffer<T> radians(n, layout::soa);
        for (std::size_t i = 0; i < n; ++i) q.set(i, all[i]);
        for (const precision p : both_precisions) {
            ASSERT_EQ(to_euler(q.view(), o.order, radians.view(), {.accuracy = p}), status::ok);
            double worst[3] = {0, 0, 0};
            std::size_t locked = 0;
            for (std::size_t i = 0; i < n; ++i) {
                // From the elements of the matrix of the rotation; of a proper order the points (w, a) and (b, c),
                // their product and quotient.
                const quat<W> in = widen<W>(all[i]);
                const W size = dot(in, in), odd = (o.axes[1] - o.axes[0] + 3) % 3 == 2 ? W(-1) : W(1);
                const W a = component(in, o.axes[0]), b = component(in, o.axes[1]),
                        c = odd * component(in, last_axis(o.axes)), w = in.w;
                const bool proper = is_proper(o.axes);
                const W product_of_lengths = 2 * root(w * w + a * a) * root(b * b + c * c) / size;
                const W cosine_of_tilted = root((w + b) * (w + b) + (a + c) * (a + c)) *
                                           root((w - b) * (w - b) + (a - c) * (a - c)) / size;
                // The lock is where this is 0.
                const W width = proper ? product_of_lengths : cosine_of_tilted;
                const W sine_of_second = proper ? product_of_lengths : 2 * (w * b + a * c) / size;
                const W cosine_of_second = proper ? (w * w + a * a - b * b - c * c) / size : cosine_of_tilted;
                const W sine_a = proper ? w * c + a * b : 2 * (w * a - b * c);
                const W cosine_a = proper ? w * b - a * c : w * w - a * a - b * b + c * c;
                const W sine_c = proper ? a * b - w * c : 2 * (w * c - a * b);
                const W cosine_c = proper ? w * b + a * c : w * w + a * a - b * b - c * c;
                const vec3<T> got = radians.get(i);
                const auto off = [&](int which, W want) {
                    W d = magnitude(W(angle(got, o.axes, which)) - want);
                    if (d > whole / 2) d = magnitude(d - whole);
                    return double(d);
                };
                worst[1] = std::max(worst[1], off(1, angle_of(sine_of_second, cosine_of_second)));
                if (double(width) < 0.9 * lock<T>) {
                    ASSERT_EQ(angle(got, o.axes, 2), T(0)) << i;
                    ++locked;
                } else if (double(width) > 1.1 * lock<T>) {
                    worst[0] = std::max(worst[0], off(0, angle_of(sine_a, cosine_a)));
                    worst[2] = std::max(worst[2], off(2, (proper ? W(1) : odd) * angle_of(sine_c, cosine_c)));
                }
            }
            ASSERT_GT(locked, 100U);
            for (const double one : worst)
                EXPECT_LE(one / rounding_unit<T>, angle_bound) << o.axes << ' ' << name(p);
        }
    }
}

TEST_P(Euler, AnglesAreThoseOfTheMatrixAndTheThirdIsZeroInTheLockFloat) { angles<float>(); }
TEST_P(Euler, AnglesAreThoseOfTheMatrixAndTheThirdIsZeroInTheLockDouble) { angles<double>(); }

template <class T>
void either_sign() {
    for (const named_order& o : all_orders) {
        generator g(4);
        const std::vector<quat<T>> all = all_rotations<T>(g, o.axes, false);
        const std::size_t n = all.size();
        quat_buffer<T> q(n, layout::soa), minus_q(n, layout::soa);
        vec3_buffer<T> a(n, layout::soa), b(n, layout::soa);
        for (std::size_t i = 0; i < n; ++i) {
            q.set(i, all[i]);
            minus_q.set(i, {-all[i].x, -all[i].y, -all[i].z, -all[i].w});
        }
        for (const precision p : both_precisions) {
            ASSERT_EQ(to_euler(q.view(), o.order, a.view(), {.accuracy = p}), status::ok);
            ASSERT_EQ(to_euler(minus_q.view(), o.order, b.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(a.get(i), b.get(i)) << o.axes << ' ' << i;
        }
    }
}

TEST_P(Euler, BothSignsOfAQuaternionHaveTheSameAngles) {
    either_sign<float>();
    either_sign<double>();
}

template <class T>
void exact_corners() {
    const T minus_zero = T(-0.0);
    quat_buffer<T> q(4, layout::soa), back(4, layout::soa);
    vec3_buffer<T> a(4, layout::soa);
    const quat<T> in[] = {{0, 0, 0, 1}, {0, 0, 0, -1}, {0, 0, 0, 0}, {minus_zero, 0, minus_zero, minus_zero}};
    for (std::size_t i = 0; i < 4; ++i) q.set(i, in[i]);
    for (const named_order& o : all_orders)
        for (const precision p : both_precisions) {
            ASSERT_EQ(to_euler(q.view(), o.order, a.view(), {.accuracy = p}), status::ok);
            ASSERT_EQ(from_euler(a.view(), o.order, back.view(), {.accuracy = p}), status::ok);
            for (std::size_t i = 0; i < 4; ++i) {
                for (int c = 0; c < 3; ++c) EXPECT_EQ(a.at(c, i), T(0)) << o.axes << ' ' << i;
                EXPECT_EQ(back.get(i), (quat<T>{0, 0, 0, 1})) << o.axes << ' ' << i;
            }
        }
}

TEST_P(Euler, TheIdentityAndTheZeroQuaternionHaveNoAngles) {
    exact_corners<float>();
    exact_corners<double>();
}

TEST_P(Euler, RefusesAnOrderThatIsNone) {
    const auto none = static_cast<euler_order>(12);
    quat_buffer<float> q(1, layout::soa);
    vec3_buffer<float> a(1, layout::soa);
    q.set(0, {0, 0, 0, 1});
    EXPECT_EQ(to_euler(q.view(), none, a.view()), status::bad_argument);
    EXPECT_EQ(from_euler(a.view(), none, q.view()), status::bad_argument);
    EXPECT_EQ(reference::to_euler(q.view(), none, a.view()), status::bad_argument);
    EXPECT_EQ(a.at(0, 0), untouched<float>);
    EXPECT_EQ(q.get(0), (quat<float>{0, 0, 0, 1}));
}

// The angles where x, y, z were.
TEST_P(Euler, WorksInPlace) {
    constexpr std::size_t n = 301;
    generator g(5);
    quat_buffer<float> q(n, layout::soa), in_place(n, layout::soa);
    vec3_buffer<float> a(n, layout::soa);
    for (std::size_t i = 0; i < n; ++i) {
        q.set(i, random_rotation<float>(g));
        in_place.set(i, q.get(i));
    }
    const quat_view<float> v = in_place.view();
    const vec3_view<float> inside{v.y, v.z, v.x, n};
    for (const named_order& o : all_orders) {
        for (std::size_t i = 0; i < n; ++i) in_place.set(i, q.get(i));
        ASSERT_EQ(to_euler(q.view(), o.order, a.view()), status::ok);
        ASSERT_EQ(to_euler(v, o.order, inside), status::ok);
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_TRUE(same_bits(in_place.at(1, i), a.at(0, i)));
            ASSERT_TRUE(same_bits(in_place.at(2, i), a.at(1, i)));
            ASSERT_TRUE(same_bits(in_place.at(0, i), a.at(2, i)));
        }
    }
}

}  // namespace
}  // namespace swivel::tests
