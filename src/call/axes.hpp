#ifndef SWIVEL_SRC_CALL_AXES_HPP
#define SWIVEL_SRC_CALL_AXES_HPP

// How the axis of a twist is given to a kernel.

#include <cstdint>

#include "kernels/constants.hpp"
#include "kernels/kernel.hpp"
#include "swivel/types.hpp"

namespace swivel {

inline constexpr std::uint8_t in_order[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

// The form of the axis, and the place that each of x y z w has among the components that the kernel takes.
// Exchanging the first two turns a kernel for q = S T into one for q = T R.
struct component_order {
    axis_form_index form;
    std::uint8_t places[4];
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

inline status check(euler_order order) noexcept {
    return order <= euler_order::zyz ? status::ok : status::bad_argument;
}
inline status check(axis a) noexcept { return a <= axis::z ? status::ok : status::bad_argument; }

}  // namespace swivel

#endif
