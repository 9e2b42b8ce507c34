#include "swivel/axis_angle.hpp"

#include "kernels/conversions/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status from_any(const twist_axis<T>& a, const scalar_view<const T>& radians, const quat_view<T>& q,
                const options& o) noexcept {
    const component_order& order = order_for(a, product::swing_twist);
    call<T> c(radians.size, o);
    c.read(radians);
    c.about(a, order);
    c.write(q, order.places);
    return c.template run<from_axis_angle_kernels>(order.form, index_of(o.accuracy));
}

template <class T>
status to_any(const quat_view<const T>& q, const vec3_view<T>& a, const scalar_view<T>& radians,
              const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.write(a);
    c.write(radians);
    return c.template run<to_axis_angle_kernels>(index_of(o.accuracy));
}

}  // namespace

status from_axis_angle(const twist_axis<float>& a, const scalar_view<const float>& radians,
                       const quat_view<float>& q, options o) noexcept {
    return from_any<float>(a, radians, q, o);
}
status from_axis_angle(const twist_axis<double>& a, const scalar_view<const double>& radians,
                       const quat_view<double>& q, options o) noexcept {
    return from_any<double>(a, radians, q, o);
}
status to_axis_angle(const quat_view<const float>& q, const vec3_view<float>& a,
                     const scalar_view<float>& radians, options o) noexcept {
    return to_any<float>(q, a, radians, o);
}
status to_axis_angle(const quat_view<const double>& q, const vec3_view<double>& a,
                     const scalar_view<double>& radians, options o) noexcept {
    return to_any<double>(q, a, radians, o);
}

}  // namespace swivel
