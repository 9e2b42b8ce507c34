#include "swivel/decompose.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

twist_sign sign_of(const options& o) noexcept { return o.positive_twist ? sign_positive : sign_left; }

template <class T, class... Signs>
status full(const quat_view<const T>& q, const twist_axis<T>& a, const quat_view<T>& swing,
            const quat_view<T>& twist, const options& o, twist_sign sign, const Signs&... signs) noexcept {
    const component_order& order = order_for(a, o.order);
    return project(active_operations<T>().decompose[order.form][sign][index_of(o.accuracy)], q, a, order, o,
                   group_of(swing, order), group_of(twist, order), group_of(signs)...);
}

template <class T, class... Signs>
status compact(const quat_view<const T>& q, axis a, const factor_view<T>& out, const options& o,
               twist_sign sign, const Signs&... signs) noexcept {
    const component_order& order = order_for(a, o.order);
    const twist_axis<T> along(a);
    return run(
        active_operations<T>().decompose_compact[sign][index_of(o.accuracy)],
        [&](batch<T>& b) { return set_numbers(b, order, along, o); }, std::tuple(group_of(q, order)),
        std::tuple(group_of(out, o.order), group_of(signs)...));
}

}  // namespace

status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, options o) noexcept {
    return full<float>(q, a, swing, twist, o, sign_of(o));
}
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist, options o) noexcept {
    return full<double>(q, a, swing, twist, o, sign_of(o));
}
status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const scalar_view<float>& signs, options o) noexcept {
    return full<float>(q, a, swing, twist, o, sign_kept, signs);
}
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const scalar_view<double>& signs, options o) noexcept {
    return full<double>(q, a, swing, twist, o, sign_kept, signs);
}

status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out, options o) noexcept {
    return compact<float>(q, a, out, o, sign_of(o));
}
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 options o) noexcept {
    return compact<double>(q, a, out, o, sign_of(o));
}
status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out,
                 const scalar_view<float>& signs, options o) noexcept {
    return compact<float>(q, a, out, o, sign_kept, signs);
}
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 const scalar_view<double>& signs, options o) noexcept {
    return compact<double>(q, a, out, o, sign_kept, signs);
}

}  // namespace swivel
