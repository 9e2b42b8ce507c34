#include "swivel/sterp.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const twist_axis<T>& axis,
                const parameter<T>& swing, const parameter<T>& twist, const quat_view<T>& out,
                const options& o) noexcept {
    const twist_axis<T> vector = as_vector(axis);
    const component_order& order = order_for(vector, product::swing_twist);
    const bool per_element = order.form == per_element_index;
    const kernel<T> run_kernel =
        active_operations<T>().sterp[per_element][o.motion == flavour::nlerp][o.axis_frame == frame::body]
                                    [index_of(o.accuracy)];
    const auto numbers = [&](batch<T>& batch) {
        if (const status bad = check(axis.coordinate); bad != status::ok) return bad;
        batch.uniform[5] = o.long_way ? T(-0.0) : T(0);
        return set_numbers(batch, order, vector, o);
    };
    const auto s = group_of(swing, a.size), t = group_of(twist, a.size);
    if (per_element)
        return run(run_kernel, numbers,
                   std::tuple(group_of(a), group_of(b), group_of(vector.per_element), s, t),
                   std::tuple(group_of(out)));
    return run(run_kernel, numbers, std::tuple(group_of(a), group_of(b), s, t), std::tuple(group_of(out)));
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
