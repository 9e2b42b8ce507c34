#ifndef SWIVEL_SRC_CALL_ARGUMENTS_HPP
#define SWIVEL_SRC_CALL_ARGUMENTS_HPP

// From the arguments of a public call to the streams and numbers that a kernel takes.

#include "kernels/constants.hpp"
#include "src/call/checks.hpp"
#include "src/call/run.hpp"
#include "src/call/unit_axis.hpp"

namespace swivel {

// The form of the axis, and the place that each of x y z w has among the components that the kernel takes.
// Exchanging the first two turns a kernel for q = S T into one for q = T R.
struct component_order {
    axis_form_index form;
    std::uint8_t place[4];
};

// B C A w of the axes x, y and z, for q = S T; and with B and C exchanged.
inline constexpr component_order coordinate_orders[3][2] = {
    {{coordinate_index, {2, 0, 1, 3}}, {coordinate_index, {2, 1, 0, 3}}},
    {{coordinate_index, {1, 2, 0, 3}}, {coordinate_index, {0, 2, 1, 3}}},
    {{coordinate_index, {0, 1, 2, 3}}, {coordinate_index, {1, 0, 2, 3}}}};
inline constexpr component_order uniform_orders[2] = {{uniform_index, {0, 1, 2, 3}},
                                                      {uniform_index, {1, 0, 2, 3}}};
inline constexpr component_order per_element_orders[2] = {{per_element_index, {0, 1, 2, 3}},
                                                          {per_element_index, {1, 0, 2, 3}}};
inline constexpr component_order as_it_is{uniform_index, {0, 1, 2, 3}};
inline constexpr std::uint8_t in_order[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
inline constexpr std::uint8_t spinor_places[] = {3, 2, 0, 1};
// s1 and s2 are exchanged with B and C.
inline constexpr std::uint8_t factor_places[2][5] = {{0, 1, 2, 3, 4}, {1, 0, 2, 3, 4}};

inline const component_order& order_for(axis a, product p) noexcept {
    return coordinate_orders[static_cast<int>(a) % 3][p != product::swing_twist];
}

template <class T>
const component_order& order_for(const twist_axis<T>& a, product p) noexcept {
    if (a.kind == twist_axis<T>::form::coordinate) return order_for(a.coordinate, p);
    const bool exchanged = p != product::swing_twist;
    return a.kind == twist_axis<T>::form::uniform ? uniform_orders[exchanged] : per_element_orders[exchanged];
}

template <class T>
stream_group<T, 4> group_of(const quat_view<T>& v, const component_order& order = as_it_is) noexcept {
    return {{v.x, v.y, v.z, v.w}, v.size, v.stride, order.place};
}

template <class T>
stream_group<T, 3> group_of(const vec3_view<T>& v, const component_order& order = as_it_is) noexcept {
    return {{v.x, v.y, v.z}, v.size, v.stride, order.place};
}

template <class T>
stream_group<T, 1> group_of(const scalar_view<T>& v) noexcept {
    return {{v.data}, v.size, v.stride, in_order};
}

// As x y z w, but for the signs.
template <class T>
stream_group<T, 4> group_of(const spinor_view<T>& s) noexcept {
    return {{s.a, s.b, s.c, s.d}, s.size, s.stride, spinor_places};
}

template <class T>
stream_group<T, 9> group_of(const matrix_view<T>& m) noexcept {
    return {{m.xx, m.xy, m.xz, m.yx, m.yy, m.yz, m.zx, m.zy, m.zz}, m.size, m.stride, in_order};
}

template <class T>
stream_group<T, 8> group_of(const motor_view<T>& m) noexcept {
    return {{m.x, m.y, m.z, m.w, m.dx, m.dy, m.dz, m.dw}, m.size, m.stride, in_order};
}

template <class T>
stream_group<T, 16> group_of(const conformal_view<T>& c) noexcept {
    stream_group<T, 16> g{{}, c.size, c.stride, in_order};
    for (int k = 0; k < 16; ++k) g.stream[k] = c.blade[k];
    return g;
}

template <class T>
stream_group<T, 10> group_of(const bivector_view<T>& b) noexcept {
    stream_group<T, 10> g{{}, b.size, b.stride, in_order};
    for (int k = 0; k < 10; ++k) g.stream[k] = b.blade[k];
    return g;
}

// One number for all is read over and over. The parameter must outlive the group.
template <class T>
stream_group<const T, 1> group_of(const parameter<T>& t, std::size_t size) noexcept {
    if (t.is_per_element) return group_of(t.per_element);
    return {{&t.for_all}, size, 0, in_order};
}

template <class T>
stream_group<T, 5> group_of(const factor_view<T>& v, product p) noexcept {
    return {{v.s1, v.s2, v.sc, v.ts, v.tc}, v.size, 1, factor_places[p != product::swing_twist]};
}

inline status check(const options& o) noexcept {
    if (o.order != product::swing_twist && o.order != product::twist_swing) return status::bad_argument;
    if (o.accuracy != precision::fast && o.accuracy != precision::reproducible) return status::bad_argument;
    if (o.axis_frame > frame::body || o.motion > flavour::nlerp) return status::bad_argument;
    if (o.pole_threshold == default_pole_threshold) return status::ok;
    return o.pole_threshold >= 0 && o.pole_threshold <= 1 ? status::ok : status::bad_argument;
}

inline status check(axis a) noexcept { return a <= axis::z ? status::ok : status::bad_argument; }
inline status check(euler_order order) noexcept {
    return order <= euler_order::zyz ? status::ok : status::bad_argument;
}

inline precision_index index_of(precision p) noexcept {
    return p == precision::fast ? fast_index : reproducible_index;
}

template <class T>
T threshold_of(const options& o) noexcept {
    if (o.pole_threshold == default_pole_threshold) return constants<T>::pole_threshold;
    return static_cast<T>(o.pole_threshold);
}

// A coordinate axis as a vector, for operations whose cost is elsewhere.
template <class T>
twist_axis<T> as_vector(const twist_axis<T>& a) noexcept {
    if (a.kind != twist_axis<T>::form::coordinate) return a;
    const auto is = [&](axis c) { return a.coordinate == c ? T(1) : T(0); };
    return vec3<T>{is(axis::x), is(axis::y), is(axis::z)};
}

// Checks the numbers of an operation that projects on an axis, and puts them where its kernel takes them.
template <class T>
status set_numbers(batch<T>& b, const component_order& order, const twist_axis<T>& a,
                   const options& o) noexcept {
    if (const status bad = check(o); bad != status::ok) return bad;
    b.uniform[0] = threshold_of<T>(o);
    if (a.kind == twist_axis<T>::form::coordinate) return check(a.coordinate);
    if (a.kind == twist_axis<T>::form::uniform) {
        unit_axis<T> unit;
        if (!make_unit(a.uniform, unit)) return status::bad_argument;
        b.uniform[1 + order.place[0]] = unit.x;
        b.uniform[1 + order.place[1]] = unit.y;
        b.uniform[1 + order.place[2]] = unit.z;
        b.uniform[4] = unit.excess;
    }
    return status::ok;
}

// The streams that an operation reads that projects q on an axis. Calls body(tuple of groups).
template <class T, class Body>
[[gnu::always_inline]] inline status with_projected(const quat_view<const T>& q, const twist_axis<T>& a,
                                                    const component_order& order, const Body& body) noexcept {
    if (order.form == per_element_index)
        return body(std::tuple(group_of(q, order), group_of(a.per_element, order)));
    return body(std::tuple(group_of(q, order)));
}

// Runs an operation that projects q on an axis and writes the groups.
template <class T, class... Out>
[[gnu::always_inline]] inline status project(kernel<T> run_kernel, const quat_view<const T>& q,
                                             const twist_axis<T>& a, const component_order& order,
                                             const options& o, const Out&... out) noexcept {
    return with_projected(
        q, a, order, [&](const auto& reads) __attribute__((always_inline)) {
            return run(
                run_kernel, [&](batch<T>& b) { return set_numbers(b, order, a, o); }, reads,
                std::tuple(out...));
        });
}

}  // namespace swivel

#endif
