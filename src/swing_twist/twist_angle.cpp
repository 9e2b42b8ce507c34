#include "swivel/twist_angle.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const twist_axis<T>& a, const scalar_view<T>& out,
                const options& o) noexcept {
    const component_order& order = order_for(a, o.order);
    return project(active_operations<T>().twist_angle[order.form][o.positive_twist][index_of(o.accuracy)], q,
                   a, order, o, group_of(out));
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
