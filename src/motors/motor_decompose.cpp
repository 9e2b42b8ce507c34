#include "kernels/motors/tables.hpp"
#include "src/call/call.hpp"
#include "swivel/motor.hpp"

namespace swivel {

namespace {

template <class T>
status any_decompose(const motor_view<const T>& m, const twist_axis<T>& a, const quat_view<T>& swing,
                     const quat_view<T>& twist, const vec3_view<T>& translation, const options& o) noexcept {
    const component_order& order = order_for(a, o.order);
    call<T> c(m.size, o);
    c.read(quat_view<const T>{m.x, m.y, m.z, m.w, m.size, m.stride}, order.places);
    c.about(a, order);
    c.read(m);
    c.write(swing, order.places);
    c.write(twist, order.places);
    c.write(translation);
    c.number(5, o.positive_twist ? T(-0.0) : T(0));
    return c.template run<motor_decompose_kernels>(order.form, index_of(o.accuracy));
}

}  // namespace

status decompose(const motor_view<const float>& m, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const vec3_view<float>& translation, options o) noexcept {
    return any_decompose<float>(m, a, swing, twist, translation, o);
}
status decompose(const motor_view<const double>& m, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const vec3_view<double>& translation, options o) noexcept {
    return any_decompose<double>(m, a, swing, twist, translation, o);
}

}  // namespace swivel
