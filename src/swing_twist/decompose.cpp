#include "swivel/decompose.hpp"

#include "kernels/swing_twist/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

// The signs are kept where there is a view for them; then, too, the twist is made positive.
template <class T>
status full(const quat_view<const T>& q, const twist_axis<T>& a, const quat_view<T>& swing,
            const quat_view<T>& twist, const scalar_view<T>* signs, const options& o) noexcept {
    const component_order& order = order_for(a, o.order);
    call<T> c(q.size, o);
    c.read(q, order.places);
    c.write(swing, order.places);
    c.write(twist, order.places);
    if (signs != nullptr) c.write(*signs);
    c.about(a, order);
    c.number(5, o.positive_twist || signs != nullptr ? T(-0.0) : T(0));
    return c.template run<decompose_kernels>(order.form, signs != nullptr, index_of(o.accuracy));
}

template <class T>
status compact(const quat_view<const T>& q, axis a, const factor_view<T>& out, const scalar_view<T>* signs,
               const options& o) noexcept {
    const component_order& order = order_for(a, o.order);
    call<T> c(q.size, o);
    c.read(q, order.places);
    c.write(out, o.order);
    if (signs != nullptr) c.write(*signs);
    c.about(a, order);
    c.number(5, o.positive_twist || signs != nullptr ? T(-0.0) : T(0));
    return c.template run<decompose_compact_kernels>(signs != nullptr, index_of(o.accuracy));
}

}  // namespace

status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, options o) noexcept {
    return full<float>(q, a, swing, twist, nullptr, o);
}
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist, options o) noexcept {
    return full<double>(q, a, swing, twist, nullptr, o);
}
status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const scalar_view<float>& signs, options o) noexcept {
    return full<float>(q, a, swing, twist, &signs, o);
}
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const scalar_view<double>& signs, options o) noexcept {
    return full<double>(q, a, swing, twist, &signs, o);
}

status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out, options o) noexcept {
    return compact<float>(q, a, out, nullptr, o);
}
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 options o) noexcept {
    return compact<double>(q, a, out, nullptr, o);
}
status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out,
                 const scalar_view<float>& signs, options o) noexcept {
    return compact<float>(q, a, out, &signs, o);
}
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 const scalar_view<double>& signs, options o) noexcept {
    return compact<double>(q, a, out, &signs, o);
}

}  // namespace swivel
