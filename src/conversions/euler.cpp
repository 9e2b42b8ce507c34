#include "swivel/euler.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

// The places of x, y, z and w among i, j, k and w, and whether i j = -k.
struct euler_axes {
    component_order order;
    bool is_odd;
};

constexpr euler_axes axes_of_orders[] = {{{coordinate_index, {0, 1, 2, 3}}, false},  // xyz, xyx
                                         {{coordinate_index, {0, 2, 1, 3}}, true},   // xzy, xzx
                                         {{coordinate_index, {1, 0, 2, 3}}, true},   // yxz, yxy
                                         {{coordinate_index, {2, 0, 1, 3}}, false},  // yzx, yzy
                                         {{coordinate_index, {1, 2, 0, 3}}, false},  // zxy, zxz
                                         {{coordinate_index, {2, 1, 0, 3}}, true}};  // zyx, zyz

const euler_axes& axes_of(euler_order order) noexcept { return axes_of_orders[static_cast<int>(order) % 6]; }

bool is_proper(euler_order order) noexcept { return order >= euler_order::xyx; }

// Of the angles: by axis, in the proper orders one after the other.
const component_order& order_of_angles(euler_order order) noexcept {
    return is_proper(order) ? axes_of_orders[0].order : axes_of(order).order;
}

template <class T>
status set_numbers(batch<T>& b, euler_order order, const options& o) noexcept {
    if (const status bad = check(o); bad != status::ok) return bad;
    b.uniform[0] = axes_of(order).is_odd ? T(-1) : T(1);
    b.uniform[1] = is_proper(order) ? T(-1) : T(1);
    return check(order);
}

template <class T>
status from_any(const vec3_view<const T>& radians, euler_order order, const quat_view<T>& q,
                const options& o) noexcept {
    return run(
        active_operations<T>().from_euler[index_of(o.accuracy)],
        [&](batch<T>& b) { return set_numbers(b, order, o); },
        std::tuple(group_of(radians, order_of_angles(order))), std::tuple(group_of(q, axes_of(order).order)));
}

template <class T>
status to_any(const quat_view<const T>& q, euler_order order, const vec3_view<T>& radians,
              const options& o) noexcept {
    return run(
        active_operations<T>().to_euler[index_of(o.accuracy)],
        [&](batch<T>& b) { return set_numbers(b, order, o); }, std::tuple(group_of(q, axes_of(order).order)),
        std::tuple(group_of(radians, order_of_angles(order))));
}

}  // namespace

status from_euler(const vec3_view<const float>& radians, euler_order order, const quat_view<float>& q,
                  options o) noexcept {
    return from_any<float>(radians, order, q, o);
}
status from_euler(const vec3_view<const double>& radians, euler_order order, const quat_view<double>& q,
                  options o) noexcept {
    return from_any<double>(radians, order, q, o);
}
status to_euler(const quat_view<const float>& q, euler_order order, const vec3_view<float>& radians,
                options o) noexcept {
    return to_any<float>(q, order, radians, o);
}
status to_euler(const quat_view<const double>& q, euler_order order, const vec3_view<double>& radians,
                options o) noexcept {
    return to_any<double>(q, order, radians, o);
}

}  // namespace swivel
