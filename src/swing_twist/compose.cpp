#include "swivel/compose.hpp"

#include "kernels/swing_twist/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

// The kernels give the signs to the factor on the right; to the product it makes no difference which one has
// them.
template <class T>
status full(const quat_view<const T>& swing, const quat_view<const T>& twist,
            const scalar_view<const T>* signs, const quat_view<T>& q, const options& o) noexcept {
    const bool swing_left = o.order == product::swing_twist;
    call<T> c(swing.size, o);
    c.read(swing_left ? swing : twist);
    c.read(swing_left ? twist : swing);
    if (signs != nullptr) c.read(*signs);
    c.write(q);
    return c.template run<compose_kernels>(signs != nullptr, index_of(o.accuracy));
}

template <class T>
status compact(const factor_view<const T>& factors, axis a, const scalar_view<const T>* signs,
               const quat_view<T>& q, const options& o) noexcept {
    call<T> c(factors.size, o);
    c.read(factors, o.order);
    if (signs != nullptr) c.read(*signs);
    c.write(q, order_for(a, o.order).places);
    c.require(check(a));
    return c.template run<compose_compact_kernels>(signs != nullptr, index_of(o.accuracy));
}

}  // namespace

status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const quat_view<float>& q, options o) noexcept {
    return full<float>(swing, twist, nullptr, q, o);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const quat_view<double>& q, options o) noexcept {
    return full<double>(swing, twist, nullptr, q, o);
}
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const scalar_view<const float>& signs, const quat_view<float>& q, options o) noexcept {
    return full<float>(swing, twist, &signs, q, o);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const scalar_view<const double>& signs, const quat_view<double>& q, options o) noexcept {
    return full<double>(swing, twist, &signs, q, o);
}

status compose(const factor_view<const float>& factors, axis a, const quat_view<float>& q,
               options o) noexcept {
    return compact<float>(factors, a, nullptr, q, o);
}
status compose(const factor_view<const double>& factors, axis a, const quat_view<double>& q,
               options o) noexcept {
    return compact<double>(factors, a, nullptr, q, o);
}
status compose(const factor_view<const float>& factors, axis a, const scalar_view<const float>& signs,
               const quat_view<float>& q, options o) noexcept {
    return compact<float>(factors, a, &signs, q, o);
}
status compose(const factor_view<const double>& factors, axis a, const scalar_view<const double>& signs,
               const quat_view<double>& q, options o) noexcept {
    return compact<double>(factors, a, &signs, q, o);
}

}  // namespace swivel
