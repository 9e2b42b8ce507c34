#include "swivel/compose.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

// The kernels give the signs to the factor on the right; to the product it makes no difference which one has
// them.
template <class T, class... Signs>
status full(const quat_view<const T>& swing, const quat_view<const T>& twist, const quat_view<T>& q,
            const options& o, const Signs&... signs) noexcept {
    const bool swing_left = o.order == product::swing_twist;
    return run(
        active_operations<T>().compose[sizeof...(signs)][index_of(o.accuracy)],
        [&](batch<T>&) { return check(o); },
        std::tuple(group_of(swing_left ? swing : twist), group_of(swing_left ? twist : swing),
                   group_of(signs)...),
        std::tuple(group_of(q)));
}

template <class T, class... Signs>
status compact(const factor_view<const T>& factors, axis a, const quat_view<T>& q, const options& o,
               const Signs&... signs) noexcept {
    const auto check_numbers = [&](batch<T>&) {
        const status bad = check(o);
        return bad != status::ok ? bad : check(a);
    };
    return run(active_operations<T>().compose_compact[sizeof...(signs)][index_of(o.accuracy)], check_numbers,
               std::tuple(group_of(factors, o.order), group_of(signs)...),
               std::tuple(group_of(q, order_for(a, o.order))));
}

}  // namespace

status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const quat_view<float>& q, options o) noexcept {
    return full<float>(swing, twist, q, o);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const quat_view<double>& q, options o) noexcept {
    return full<double>(swing, twist, q, o);
}
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const scalar_view<const float>& signs, const quat_view<float>& q, options o) noexcept {
    return full<float>(swing, twist, q, o, signs);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const scalar_view<const double>& signs, const quat_view<double>& q, options o) noexcept {
    return full<double>(swing, twist, q, o, signs);
}

status compose(const factor_view<const float>& factors, axis a, const quat_view<float>& q,
               options o) noexcept {
    return compact<float>(factors, a, q, o);
}
status compose(const factor_view<const double>& factors, axis a, const quat_view<double>& q,
               options o) noexcept {
    return compact<double>(factors, a, q, o);
}
status compose(const factor_view<const float>& factors, axis a, const scalar_view<const float>& signs,
               const quat_view<float>& q, options o) noexcept {
    return compact<float>(factors, a, q, o, signs);
}
status compose(const factor_view<const double>& factors, axis a, const scalar_view<const double>& signs,
               const quat_view<double>& q, options o) noexcept {
    return compact<double>(factors, a, q, o, signs);
}

}  // namespace swivel
