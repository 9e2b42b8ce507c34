#include "swivel/compose.hpp"

#include "arguments.hpp"

namespace swivel {

namespace {

template <class T>
status run_checked(kernel<T> (operations<T>::*op)[2][precisions], bool with_signs, streams<T>& s,
                   const options& o) noexcept {
    const operations<T>& table = active_operations<T>();
    batch<T> b;
    run((table.*op)[with_signs][index_of(o.accuracy)], table, s, b);
    return status::ok;
}

template <class T>
status full(quat_view<const T> swing, quat_view<const T> twist, const scalar_view<const T>* signs, quat_view<T> q,
            const options& o) noexcept {
    constexpr component_order xyzw{uniform_index, {0, 1, 2, 3}};
    const bool swing_first = o.order == product::swing_twist;
    streams<T> s;
    s.in[s.inputs++] = group_of(swing_first ? swing : twist, xyzw);
    s.in[s.inputs++] = group_of(swing_first ? twist : swing, xyzw);
    // The kernel gives the sign to the factor on the right; to the product it makes no difference which has it.
    if (signs != nullptr) s.in[s.inputs++] = group_of(*signs);
    s.out[s.outputs++] = group_of(q, xyzw);
    if (const status bad = check(s); bad != status::ok || s.size == 0) return bad;
    if (const status bad = check(o); bad != status::ok) return bad;
    return run_checked(&operations<T>::compose, signs != nullptr, s, o);
}

template <class T>
status compact(factor_view<const T> factors, axis a, const scalar_view<const T>* signs, quat_view<T> q,
               const options& o) noexcept {
    streams<T> s;
    s.in[s.inputs++] = group_of(factors, o.order);
    if (signs != nullptr) s.in[s.inputs++] = group_of(*signs);
    s.out[s.outputs++] = group_of(q, order_for(a, o.order));
    if (const status bad = check(s); bad != status::ok || s.size == 0) return bad;
    if (const status bad = check(o); bad != status::ok) return bad;
    if (const status bad = check(a); bad != status::ok) return bad;
    return run_checked(&operations<T>::compose_compact, signs != nullptr, s, o);
}

}  // namespace

status compose(quat_view<const float> swing, quat_view<const float> twist, quat_view<float> q, options o) noexcept {
    return full<float>(swing, twist, nullptr, q, o);
}
status compose(quat_view<const double> swing, quat_view<const double> twist, quat_view<double> q,
               options o) noexcept {
    return full<double>(swing, twist, nullptr, q, o);
}
status compose(quat_view<const float> swing, quat_view<const float> twist, scalar_view<const float> signs,
               quat_view<float> q, options o) noexcept {
    return full<float>(swing, twist, &signs, q, o);
}
status compose(quat_view<const double> swing, quat_view<const double> twist, scalar_view<const double> signs,
               quat_view<double> q, options o) noexcept {
    return full<double>(swing, twist, &signs, q, o);
}

status compose(factor_view<const float> factors, axis a, quat_view<float> q, options o) noexcept {
    return compact<float>(factors, a, nullptr, q, o);
}
status compose(factor_view<const double> factors, axis a, quat_view<double> q, options o) noexcept {
    return compact<double>(factors, a, nullptr, q, o);
}
status compose(factor_view<const float> factors, axis a, scalar_view<const float> signs, quat_view<float> q,
               options o) noexcept {
    return compact<float>(factors, a, &signs, q, o);
}
status compose(factor_view<const double> factors, axis a, scalar_view<const double> signs, quat_view<double> q,
               options o) noexcept {
    return compact<double>(factors, a, &signs, q, o);
}

}  // namespace swivel
