#include "swivel/twist_angle.hpp"

#include "kernels/swing_twist/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const twist_axis<T>& a, const scalar_view<T>& out,
                const options& o) noexcept {
    const component_order& order = order_for(a, o.order);
    call<T> c(q.size, o);
    c.read(q, order.places);
    c.write(out);
    c.about(a, order);
    c.number(5, o.positive_twist ? T(-0.0) : T(0));
    return c.template run<twist_angle_kernels>(order.form, index_of(o.accuracy));
}

}  // namespace

status twist_angle(const quat_view<const float>& q, const twist_axis<float>& a,
                   const scalar_view<float>& radians, options o) noexcept {
    return any_type<float>(q, a, radians, o);
}
status twist_angle(const quat_view<const double>& q, const twist_axis<double>& a,
                   const scalar_view<double>& radians, options o) noexcept {
    return any_type<double>(q, a, radians, o);
}

}  // namespace swivel
