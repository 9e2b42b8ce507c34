#include "swivel/twist.hpp"

#include "kernels/swing_twist/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const twist_axis<T>& a, const quat_view<T>& out,
                const options& o) noexcept {
    const component_order& order = order_for(a, o.order);
    call<T> c(q.size, o);
    c.read(q, order.places);
    c.write(out, order.places);
    c.about(a, order);
    c.number(5, o.positive_twist ? T(-0.0) : T(0));
    return c.template run<twist_kernels>(order.form, index_of(o.accuracy));
}

}  // namespace

status twist(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& out,
             options o) noexcept {
    return any_type<float>(q, a, out, o);
}
status twist(const quat_view<const double>& q, const twist_axis<double>& a, const quat_view<double>& out,
             options o) noexcept {
    return any_type<double>(q, a, out, o);
}

}  // namespace swivel
