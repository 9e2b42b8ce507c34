#ifndef SWIVEL_SRC_ARGUMENTS_HPP
#define SWIVEL_SRC_ARGUMENTS_HPP

// From the arguments of a public call to the streams and numbers that a kernel takes.

#include "../kernels/constants.hpp"
#include "checks.hpp"
#include "run.hpp"
#include "unit_axis.hpp"

namespace swivel {

// The index into x y z w of each component that the kernel takes, and the form of the axis. Exchanging the
// first two turns a kernel for q = S T into one for q = T R.
struct component_order {
    axis_form_index form;
    int component[4];
};

inline component_order order_for(axis a, product order) noexcept {
    const int along = static_cast<int>(a) % 3, b = (along + 1) % 3, c = (along + 2) % 3;
    if (order == product::swing_twist) return {coordinate_index, {b, c, along, 3}};
    return {coordinate_index, {c, b, along, 3}};
}

template <class T>
component_order order_for(const twist_axis<T>& a, product order) noexcept {
    if (a.kind == twist_axis<T>::form::coordinate) return order_for(a.coordinate, order);
    const axis_form_index form = a.kind == twist_axis<T>::form::uniform ? uniform_index : per_element_index;
    if (order == product::swing_twist) return {form, {0, 1, 2, 3}};
    return {form, {1, 0, 2, 3}};
}

template <class T>
stream_group<T> group_of(const quat_view<T>& v, const component_order& order) noexcept {
    T* const component[4] = {v.x, v.y, v.z, v.w};
    const int* at = order.component;
    return {{component[at[0]], component[at[1]], component[at[2]], component[at[3]]}, 4, v.size, v.stride};
}

template <class T>
stream_group<T> group_of(const vec3_view<T>& v, const component_order& order) noexcept {
    T* const component[3] = {v.x, v.y, v.z};
    const int* at = order.component;
    return {{component[at[0]], component[at[1]], component[at[2]]}, 3, v.size, v.stride};
}

template <class T>
stream_group<T> group_of(const scalar_view<T>& v) noexcept {
    return {{v.data}, 1, v.size, v.stride};
}

// The components of the swing follow the kernel's order, so that an exchange reaches them too.
template <class T>
stream_group<T> group_of(const factor_view<T>& v, product order) noexcept {
    if (order == product::swing_twist) return {{v.s1, v.s2, v.sc, v.ts, v.tc}, 5, v.size, 1};
    return {{v.s2, v.s1, v.sc, v.ts, v.tc}, 5, v.size, 1};
}

inline status check(const options& o) noexcept {
    if (o.order != product::swing_twist && o.order != product::twist_swing) return status::bad_argument;
    if (o.accuracy != precision::fast && o.accuracy != precision::reproducible) return status::bad_argument;
    if (o.pole_threshold == default_pole_threshold) return status::ok;
    return o.pole_threshold >= 0 && o.pole_threshold <= 1 ? status::ok : status::bad_argument;
}

inline status check(axis a) noexcept { return a <= axis::z ? status::ok : status::bad_argument; }

inline precision_index index_of(precision p) noexcept {
    return p == precision::fast ? fast_index : reproducible_index;
}

template <class T>
T threshold_of(const options& o) noexcept {
    if (o.pole_threshold == default_pole_threshold) return constants<T>::pole_threshold;
    return static_cast<T>(o.pole_threshold);
}

// Streams and numbers of an operation that projects q on an axis.
template <class T>
struct projection {
    component_order order;
    streams<T> s;
    batch<T> b;

    projection(const quat_view<const T>& q, const twist_axis<T>& a, const options& o) noexcept
        : order(order_for(a, o.order)) {
        s.in[s.inputs++] = group_of(q, order);
        if (a.kind == twist_axis<T>::form::per_element) s.in[s.inputs++] = group_of(a.per_element, order);
    }

    void write(const quat_view<T>& v) noexcept { s.out[s.outputs++] = group_of(v, order); }
    void write(const scalar_view<T>& v) noexcept { s.out[s.outputs++] = group_of(v); }
    void write(const factor_view<T>& v, product p) noexcept { s.out[s.outputs++] = group_of(v, p); }

    // All checks; `ok` with a size of 0 means that there is nothing to do.
    status check_all(const twist_axis<T>& a, const options& o) noexcept {
        if (const status bad = check(s); bad != status::ok || s.size == 0) return bad;
        if (const status bad = swivel::check(o); bad != status::ok) return bad;
        b.uniform[0] = threshold_of<T>(o);
        if (a.kind == twist_axis<T>::form::coordinate) return swivel::check(a.coordinate);
        if (a.kind == twist_axis<T>::form::uniform) {
            unit_axis<T> unit;
            if (!normalize(a.uniform, unit)) return status::bad_argument;
            const T component[3] = {unit.x, unit.y, unit.z};
            for (int k = 0; k < 3; ++k) b.uniform[1 + k] = component[order.component[k]];
            b.uniform[4] = unit.excess;
        }
        return status::ok;
    }
};

// Streams of an operation that multiplies factors. The kernels give the signs to the factor on the right; to
// the product it makes no difference which one has them.
template <class T>
streams<T> composition(const quat_view<const T>& swing, const quat_view<const T>& twist,
                       const scalar_view<const T>* signs, const quat_view<T>& q, const options& o) noexcept {
    constexpr component_order xyzw{uniform_index, {0, 1, 2, 3}};
    const bool swing_left = o.order == product::swing_twist;
    streams<T> s;
    s.in[s.inputs++] = group_of(swing_left ? swing : twist, xyzw);
    s.in[s.inputs++] = group_of(swing_left ? twist : swing, xyzw);
    if (signs != nullptr) s.in[s.inputs++] = group_of(*signs);
    s.out[s.outputs++] = group_of(q, xyzw);
    return s;
}

template <class T>
streams<T> composition(const factor_view<const T>& factors, axis a, const scalar_view<const T>* signs,
                       const quat_view<T>& q, const options& o) noexcept {
    streams<T> s;
    s.in[s.inputs++] = group_of(factors, o.order);
    if (signs != nullptr) s.in[s.inputs++] = group_of(*signs);
    s.out[s.outputs++] = group_of(q, order_for(a, o.order));
    return s;
}

// All checks; `ok` with a size of 0 means that there is nothing to do.
template <class T>
status check(streams<T>& s, const options& o, axis a = axis::x) noexcept {
    if (const status bad = check(s); bad != status::ok || s.size == 0) return bad;
    if (const status bad = check(o); bad != status::ok) return bad;
    return check(a);
}

}  // namespace swivel

#endif
