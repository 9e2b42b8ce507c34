#include "swivel/sterp.hpp"

#include "kernels/interpolation/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const twist_axis<T>& axis,
                const parameter<T>& swing, const parameter<T>& twist, const quat_view<T>& out,
                const options& o) noexcept {
    const twist_axis<T> vector = as_vector(axis);
    const component_order& order = order_for(vector, product::swing_twist);
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.about(vector, order);
    c.read(swing);
    c.read(twist);
    c.write(out);
    c.number(5, o.long_way ? T(-0.0) : T(0));
    c.number(6, o.axis_frame == frame::body ? T(1) : T(0));
    c.require(check(axis.coordinate));
    return c.template run<sterp_kernels>(order.form == per_element_index, o.motion == flavour::nlerp,
                                         index_of(o.accuracy));
}

}  // namespace

status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& t, const quat_view<float>& out, options o) noexcept {
    return any_type<float>(a, b, axis, t, t, out, o);
}
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& t, const quat_view<double>& out,
             options o) noexcept {
    return any_type<double>(a, b, axis, t, t, out, o);
}
status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& swing, const parameter<float>& twist, const quat_view<float>& out,
             options o) noexcept {
    return any_type<float>(a, b, axis, swing, twist, out, o);
}
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& swing, const parameter<double>& twist,
             const quat_view<double>& out, options o) noexcept {
    return any_type<double>(a, b, axis, swing, twist, out, o);
}

}  // namespace swivel
