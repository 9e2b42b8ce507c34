#include "swivel/euler.hpp"

#include "kernels/conversions/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

// The places of x, y, z and w among i, j, k and w, and whether i j = -k.
struct euler_axes {
    std::uint8_t places[4];
    bool is_odd;
};

constexpr euler_axes axes_of_orders[] = {
    {{0, 1, 2, 3}, false},  // xyz, xyx
    {{0, 2, 1, 3}, true},   // xzy, xzx
    {{1, 0, 2, 3}, true},   // yxz, yxy
    {{2, 0, 1, 3}, false},  // yzx, yzy
    {{1, 2, 0, 3}, false},  // zxy, zxz
    {{2, 1, 0, 3}, true},   // zyx, zyz
};

const euler_axes& axes_of(euler_order order) noexcept { return axes_of_orders[static_cast<int>(order) % 6]; }

bool is_proper(euler_order order) noexcept { return order >= euler_order::xyx; }

// Of the angles: by axis, in the proper orders one after the other.
const std::uint8_t* places_of_angles(euler_order order) noexcept {
    return is_proper(order) ? in_order : axes_of(order).places;
}

template <class T>
void set_order(call<T>& c, euler_order order) noexcept {
    c.number(0, axes_of(order).is_odd ? T(-1) : T(1));
    c.number(1, is_proper(order) ? T(-1) : T(1));
    c.require(check(order));
}

template <class T>
status from_any(const vec3_view<const T>& radians, euler_order order, const quat_view<T>& q,
                const options& o) noexcept {
    call<T> c(radians.size, o);
    c.read(radians, places_of_angles(order));
    c.write(q, axes_of(order).places);
    set_order(c, order);
    return c.template run<from_euler_kernels>(index_of(o.accuracy));
}

template <class T>
status to_any(const quat_view<const T>& q, euler_order order, const vec3_view<T>& radians,
              const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q, axes_of(order).places);
    c.write(radians, places_of_angles(order));
    set_order(c, order);
    return c.template run<to_euler_kernels>(index_of(o.accuracy));
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
