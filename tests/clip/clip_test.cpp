#include "swivel/clip/clip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "sample_clip.hpp"
#include "swivel/clip/write.hpp"

namespace swivel::clip {
namespace {

using enum channel;
using matrix = std::array<std::array<long double, 3>, 3>;

struct quaternion {
    double x, y, z, w;

    friend bool operator==(const quaternion&, const quaternion&) = default;
};

// One joint with these channels, one frame.
quaternion rotation(const std::vector<channel>& channels, const std::vector<double>& values) {
    clip c;
    c.skeleton.joints.resize(1);
    for (const channel kind : channels) c.skeleton.joints[0].channels.add(kind);
    number_channels(c.skeleton);
    c.frames = 1;
    c.values = values;
    quaternion q{};
    EXPECT_EQ(joint_rotations(c, 0, soa(&q.x, &q.y, &q.z, &q.w, 1)), status::ok);
    return q;
}

matrix identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

matrix product(const matrix& a, const matrix& b) {
    matrix m{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) m[i][j] += a[i][k] * b[k][j];
    return m;
}

matrix turn(channel axis, long double degrees) {
    const long double angle = std::fmod(degrees, 360.0L) * std::numbers::pi_v<long double> / 180;
    const auto i = static_cast<std::size_t>(axis) - static_cast<std::size_t>(x_rotation);
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    matrix m = identity();
    m[j][j] = m[k][k] = std::cos(angle);
    m[k][j] = std::sin(angle);
    m[j][k] = -m[k][j];
    return m;
}

matrix to_matrix(const quaternion& q) {
    const long double x = q.x, y = q.y, z = q.z, w = q.w;
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

long double largest_difference(const matrix& a, const matrix& b) {
    long double largest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) largest = std::max(largest, std::fabs(a[i][j] - b[i][j]));
    return largest;
}

std::vector<double> random_angles(std::mt19937_64& engine, std::size_t count, double limit) {
    std::vector<double> angles;
    for (; count > 0; --count) angles.push_back((static_cast<double>(engine() >> 11) * 0x1p-52 - 1) * limit);
    return angles;
}

TEST(ClipRotation, ComposesChannelsLeftToRightInEveryOrder) {
    std::vector<channel> order = {x_rotation, y_rotation, z_rotation};
    std::mt19937_64 engine(1);
    do {
        for (int i = 0; i < 2000; ++i) {
            const std::vector<double> angles = random_angles(engine, 3, i % 2 == 0 ? 180 : 1e6);
            matrix expected = identity();
            for (std::size_t k = 0; k < 3; ++k) expected = product(expected, turn(order[k], angles[k]));
            ASSERT_LT(largest_difference(to_matrix(rotation(order, angles)), expected), 2e-15L);
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(ClipRotation, LastChannelActsFirst) {
    EXPECT_LT(largest_difference(to_matrix(rotation({z_rotation, x_rotation}, {90, 90})),
                                 {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}),
              1e-15L);
}

TEST(ClipRotation, IgnoresPositionsBetweenRotations) {
    EXPECT_EQ(rotation({z_rotation, x_position, x_rotation, y_position, z_position, y_rotation},
                       {10, 7, 20, 8, 9, 30}),
              rotation({z_rotation, x_rotation, y_rotation}, {10, 20, 30}));
}

TEST(ClipRotation, JointWithoutRotationIsIdentity) {
    EXPECT_EQ(rotation({}, {}), (quaternion{0, 0, 0, 1}));
    EXPECT_EQ(rotation({x_position}, {5}), (quaternion{0, 0, 0, 1}));
}

TEST(ClipRotation, MultiplesOfQuarterTurnsAreExact) {
    const double half = std::sqrt(0.5);
    EXPECT_EQ(rotation({y_rotation}, {0}), (quaternion{0, 0, 0, 1}));
    EXPECT_EQ(rotation({y_rotation}, {90}), (quaternion{0, half, 0, half}));
    EXPECT_EQ(rotation({y_rotation}, {180}), (quaternion{0, 1, 0, 0}));
    EXPECT_EQ(rotation({y_rotation}, {270}), (quaternion{0, half, 0, -half}));
    EXPECT_EQ(rotation({y_rotation}, {360}), (quaternion{0, 0, 0, -1}));
    EXPECT_EQ(rotation({y_rotation}, {720}), (quaternion{0, 0, 0, 1}));
    EXPECT_EQ(rotation({y_rotation}, {-90}), (quaternion{0, -half, 0, half}));
    EXPECT_EQ(rotation({y_rotation}, {-180}), (quaternion{0, -1, 0, 0}));
    EXPECT_EQ(rotation({y_rotation}, {-540}), (quaternion{0, 1, 0, 0}));
    EXPECT_EQ(rotation({x_rotation, y_rotation}, {180, 180}), (quaternion{0, 0, 1, 0}));
}

TEST(ClipRotation, HalfTurnsHavePositiveZeroScalar) {
    for (const double degrees : {180.0, -180.0, 540.0, -540.0})
        EXPECT_FALSE(std::signbit(rotation({x_rotation}, {degrees}).w)) << degrees;
}

TEST(ClipRotation, MultiplesOfSixtyDegreesAreCorrectlyRounded) {
    EXPECT_EQ(rotation({z_rotation}, {60}), (quaternion{0, 0, 0.5, std::sqrt(0.75)}));
    EXPECT_EQ(rotation({z_rotation}, {120}), (quaternion{0, 0, std::sqrt(0.75), 0.5}));
    EXPECT_EQ(rotation({z_rotation}, {-240}), (quaternion{0, 0, -std::sqrt(0.75), -0.5}));
}

TEST(ClipRotation, LargeAnglesAreAsAccurateAsSmallOnes) {
    EXPECT_EQ(rotation({x_rotation}, {36000000030}), rotation({x_rotation}, {30}));
    EXPECT_EQ(rotation({x_rotation}, {-36000000030}), rotation({x_rotation}, {-30}));
    EXPECT_EQ(rotation({x_rotation}, {1e300}), rotation({x_rotation}, {std::fmod(1e300, 720)}));
}

TEST(ClipRotation, SignFollowsTheAngle) {
    quaternion last = rotation({x_rotation}, {-2000});
    for (double degrees = -1990; degrees <= 2000; degrees += 10) {
        const quaternion q = rotation({x_rotation}, {degrees});
        EXPECT_GT(last.x * q.x + last.w * q.w, 0.9) << degrees;
        last = q;
    }
}

TEST(ClipRotation, WritesAnyLayout) {
    const clip c = make_sample_clip();
    std::vector<double> x(c.frames), y(c.frames), z(c.frames), w(c.frames), wxyz(4 * c.frames);
    ASSERT_EQ(joint_rotations(c, 3, soa(x.data(), y.data(), z.data(), w.data(), c.frames)), status::ok);
    ASSERT_EQ(joint_rotations(c, 3, aos_wxyz(wxyz.data(), c.frames)), status::ok);
    for (std::size_t frame = 0; frame < c.frames; ++frame) {
        const double* const q = wxyz.data() + 4 * frame;
        EXPECT_EQ((quaternion{q[1], q[2], q[3], q[0]}), (quaternion{x[frame], y[frame], z[frame], w[frame]}));
    }
}

TEST(ClipRotation, RefusesWhatDoesNotFitTheClipAndWritesNothing) {
    const clip good = make_sample_clip();
    std::vector<double> out(4 * good.frames, 7);
    const auto refused = [&](const auto& spoil) {
        clip c = good;
        std::size_t joint_index = 0;
        quat_view<double> q = aos_xyzw(out.data(), c.frames);
        spoil(c, joint_index, q);
        return joint_rotations(c, joint_index, q);
    };
    using index = std::size_t;
    using view = quat_view<double>;
    EXPECT_EQ(refused([](clip&, index& j, view&) { j = 21; }), status::bad_argument);
    EXPECT_EQ(refused([](clip& c, index& j, view&) { c.skeleton.joints[j].first_channel = 61; }),
              status::bad_argument);
    EXPECT_EQ(refused([](clip& c, index&, view&) { c.skeleton.channel_count = 5; }), status::bad_argument);
    EXPECT_EQ(refused([](clip&, index&, view& q) { q.stride = 0; }), status::bad_argument);
    EXPECT_EQ(refused([](clip&, index&, view& q) { --q.size; }), status::size_mismatch);
    EXPECT_EQ(refused([](clip& c, index&, view&) { c.values.pop_back(); }), status::size_mismatch);
    EXPECT_EQ(refused([](clip& c, index&, view&) { c.values.clear(); }), status::size_mismatch);
    EXPECT_EQ(refused([](clip&, index&, view& q) { q.w = nullptr; }), status::null_stream);
    EXPECT_EQ(out, std::vector<double>(out.size(), 7));
    const auto rest_pose = [](clip& c, index&, view& q) {
        c.frames = 0;
        c.values.clear();
        q = {};
    };
    EXPECT_EQ(refused(rest_pose), status::ok);
}

TEST(ClipRotation, IsUnit) {
    std::mt19937_64 engine(2);
    for (int i = 0; i < 200'000; ++i) {
        const quaternion q = rotation({z_rotation, x_rotation, y_rotation}, random_angles(engine, 3, 400));
        const long double x = q.x, y = q.y, z = q.z, w = q.w;
        ASSERT_LT(std::fabs(std::sqrt(x * x + y * y + z * z + w * w) - 1), 1e-15L);
    }
}

TEST(ClipRotation, TakesEachFrameFromTheColumnsOfTheJoint) {
    const clip c = make_sample_clip();
    const std::size_t hand = *find_joint(c.skeleton, "RightHand");
    const joint& j = c.skeleton.joints[hand];
    std::vector<double> x(c.frames), y(c.frames), z(c.frames), w(c.frames);
    ASSERT_EQ(joint_rotations(c, hand, soa(x.data(), y.data(), z.data(), w.data(), c.frames)), status::ok);
    for (std::size_t frame = 0; frame < c.frames; ++frame) {
        const auto first = c.values.begin() +
                           static_cast<std::ptrdiff_t>(frame * c.skeleton.channel_count + j.first_channel);
        EXPECT_EQ((quaternion{x[frame], y[frame], z[frame], w[frame]}),
                  rotation({j.channels.begin(), j.channels.end()}, {first, first + 3}));
    }
}

joint bone(std::int32_t parent, vec3 offset, std::optional<vec3> tip = std::nullopt) {
    joint j;
    j.parent = parent;
    j.offset = offset;
    if (tip) j.end = end_site{*tip, {}};
    return j;
}

std::vector<bone_direction> directions(std::vector<joint> joints) {
    return bone_directions({std::move(joints), 0});
}

TEST(BoneDirection, OnlyChild) {
    const auto d = directions({bone(-1, {9, 9, 9}), bone(0, {0, -3, 0})});
    EXPECT_EQ(d[0], (bone_direction{{0, -1, 0}, direction_rule::child}));
}

TEST(BoneDirection, ChildGoesBeforeEndSite) {
    const auto d = directions({bone(-1, {}, vec3{1, 0, 0}), bone(0, {0, 0, 2})});
    EXPECT_EQ(d[0], (bone_direction{{0, 0, 1}, direction_rule::child}));
}

TEST(BoneDirection, MeanOfSeveralChildren) {
    const auto d = directions({bone(-1, {}), bone(0, {3, 2, 0}), bone(0, {-3, 2, 0}), bone(0, {0, 2, 0})});
    EXPECT_EQ(d[0], (bone_direction{{0, 1, 0}, direction_rule::mean_of_children}));
}

TEST(BoneDirection, EndSiteWithoutChild) {
    const auto d = directions({bone(-1, {}, vec3{-4, 0, 0})});
    EXPECT_EQ(d[0], (bone_direction{{-1, 0, 0}, direction_rule::end_site}));
}

TEST(BoneDirection, ParentWithoutChildAndEndSite) {
    const auto d = directions({bone(-1, {}), bone(0, {0, 0, 5}), bone(1, {0, 0, 0}, vec3{0, 0, 0})});
    EXPECT_EQ(d[1], (bone_direction{{0, 0, 1}, direction_rule::parent}));
    EXPECT_EQ(d[2], (bone_direction{{0, 0, 1}, direction_rule::parent}));
}

TEST(BoneDirection, NothingKnownIsYAndSaysSo) {
    const auto d = directions({bone(-1, {5, 0, 0}), bone(0, {0, 0, 0}), bone(-1, {1, 0, 0})});
    for (const bone_direction& each : d) EXPECT_EQ(each, (bone_direction{{0, 1, 0}, direction_rule::none}));
}

TEST(BoneDirection, ZeroLengthChildIsLookedThrough) {
    const auto chain = directions({bone(-1, {}), bone(0, {}), bone(1, {}), bone(2, {7, 0, 0})});
    for (std::size_t j = 0; j < 3; ++j)
        EXPECT_EQ(chain[j], (bone_direction{{1, 0, 0}, direction_rule::child})) << j;
    const auto tip = directions({bone(-1, {}), bone(0, {}, vec3{0, 0, -2})});
    EXPECT_EQ(tip[0], (bone_direction{{0, 0, -1}, direction_rule::child}));
    const auto hips =
        directions({bone(-1, {}), bone(0, {}), bone(1, {2, -2, 0}), bone(0, {}), bone(3, {-2, -2, 0})});
    EXPECT_EQ(hips[0], (bone_direction{{0, -1, 0}, direction_rule::mean_of_children}));
}

TEST(BoneDirection, ZeroLengthChildBesideALongOneDoesNotCount) {
    const auto d = directions({bone(-1, {}), bone(0, {}), bone(0, {0, 0, 3})});
    EXPECT_EQ(d[0], (bone_direction{{0, 0, 1}, direction_rule::child}));
}

TEST(BoneDirection, ChildrenThatCancelGiveNoDirection) {
    const auto d = directions(
        {bone(-1, {}, vec3{0, 1, 0}), bone(0, {0.1, 0, 0}), bone(0, {0.2, 0, 0}), bone(0, {-0.3, 0, 0})});
    EXPECT_EQ(d[0], (bone_direction{{0, 1, 0}, direction_rule::end_site}));
}

TEST(BoneDirection, ExtremeOffsetsGiveUnitDirections) {
    const double huge = 1.7e308;
    const auto d = directions({bone(-1, {}), bone(0, {huge, huge, huge}), bone(0, {huge, huge, huge}),
                               bone(1, {0, 1e-280, 0}), bone(2, {0, 4.9e-324, 0})});
    EXPECT_DOUBLE_EQ(d[0].direction.x, 1 / std::sqrt(3.0));
    EXPECT_EQ(d[1], (bone_direction{{0, 1, 0}, direction_rule::child}));
    EXPECT_EQ(d[2].rule, direction_rule::parent);
}

TEST(Clip, FindsJointsByExactName) {
    const skeleton s = make_sample_clip().skeleton;
    EXPECT_EQ(find_joint(s, "Hips"), 0u);
    EXPECT_EQ(find_joint(s, "hips"), std::nullopt);
    EXPECT_EQ(find_joint(s, ""), std::nullopt);
}

TEST(Clip, ChannelListHoldsEachChannelOnce) {
    channel_list list;
    EXPECT_TRUE(list.empty());
    EXPECT_TRUE(list.add(y_rotation));
    EXPECT_FALSE(list.add(y_rotation));
    EXPECT_TRUE(list.contains(y_rotation));
    EXPECT_FALSE(list.contains(x_rotation));
    EXPECT_EQ(list.size(), 1u);
}

TEST(SampleClip, HasNoFaultAndAPlausibleShape) {
    const clip c = make_sample_clip();
    EXPECT_EQ(bvh_fault(c), "");
    EXPECT_EQ(c.skeleton.joints.size(), 21u);
    EXPECT_EQ(c.frames, 240u);
    EXPECT_EQ(c.frame_time, 1.0 / 60);
    for (const bone_direction& d : bone_directions(c.skeleton)) EXPECT_NE(d.rule, direction_rule::none);
}

TEST(SampleClip, UsesAllSixRotationOrders) {
    std::vector<std::string> orders;
    for (const joint& j : make_sample_clip().skeleton.joints) {
        std::string order;
        for (const channel kind : j.channels)
            if (is_rotation(kind)) order += "XYZ"[static_cast<std::size_t>(kind) - 3];
        if (order.size() == 3) orders.push_back(order);
    }
    std::sort(orders.begin(), orders.end());
    orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
    EXPECT_EQ(orders.size(), 6u);
}

TEST(SampleClip, ValuesAreRoundedToFourDecimalsAndMoveSmoothly) {
    const clip c = make_sample_clip();
    const std::size_t width = c.skeleton.channel_count;
    for (std::size_t i = 0; i < c.values.size(); ++i) {
        EXPECT_EQ(c.values[i], std::round(c.values[i] * 10000) / 10000);
        if (i >= width) {
            EXPECT_LT(std::fabs(c.values[i] - c.values[i - width]), 6) << "column " << i % width;
        }
    }
}

TEST(SampleClip, IsTheSameTextOnEveryMachine) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char byte : write_bvh(make_sample_clip()))
        hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    EXPECT_EQ(hash, 2672134003534778343u);
}

}  // namespace
}  // namespace swivel::clip
