#include "swivel/axis_angle.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status from_any(const twist_axis<T>& a, const scalar_view<const T>& radians, const quat_view<T>& q,
                const options& o) noexcept {
    const component_order& order = order_for(a, product::swing_twist);
    const kernel<T> run_kernel = active_operations<T>().from_axis_angle[order.form][index_of(o.accuracy)];
    const auto numbers = [&](batch<T>& b) { return set_numbers(b, order, a, o); };
    const std::tuple out(group_of(q, order));
    if (order.form == per_element_index)
        return run(run_kernel, numbers, std::tuple(group_of(radians), group_of(a.per_element)), out);
    return run(run_kernel, numbers, std::tuple(group_of(radians)), out);
}

template <class T>
status to_any(const quat_view<const T>& q, const vec3_view<T>& a, const scalar_view<T>& radians,
              const options& o) noexcept {
    return run(
        active_operations<T>().to_axis_angle[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(q)), std::tuple(group_of(a), group_of(radians)));
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
