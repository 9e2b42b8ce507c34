#include "swivel/decompose.hpp"

#include "arguments.hpp"

namespace swivel {

namespace {

twist_sign sign_of(const options& o) noexcept { return o.positive_twist ? sign_positive : sign_left; }

template <class T>
status full(quat_view<const T> q, const twist_axis<T>& a, quat_view<T> swing, quat_view<T> twist,
            const scalar_view<T>* signs, const options& o) noexcept {
    projection<T> p(q, a, o);
    p.write(swing);
    p.write(twist);
    if (signs != nullptr) p.write(*signs);
    if (const status bad = p.check_all(a, o); bad != status::ok || p.s.size == 0) return bad;
    const operations<T>& table = active_operations<T>();
    const twist_sign sign = signs != nullptr ? sign_kept : sign_of(o);
    run(table.decompose[p.order.form][sign][index_of(o.accuracy)], table, p.s, p.b);
    return status::ok;
}

template <class T>
status compact(quat_view<const T> q, axis a, factor_view<T> out, const scalar_view<T>* signs,
               const options& o) noexcept {
    projection<T> p(q, a, o);
    p.write(out, o.order);
    if (signs != nullptr) p.write(*signs);
    if (const status bad = p.check_all(a, o); bad != status::ok || p.s.size == 0) return bad;
    const operations<T>& table = active_operations<T>();
    const twist_sign sign = signs != nullptr ? sign_kept : sign_of(o);
    run(table.decompose_compact[sign][index_of(o.accuracy)], table, p.s, p.b);
    return status::ok;
}

}  // namespace

status decompose(quat_view<const float> q, twist_axis<float> a, quat_view<float> swing,
                 quat_view<float> twist, options o) noexcept {
    return full<float>(q, a, swing, twist, nullptr, o);
}
status decompose(quat_view<const double> q, twist_axis<double> a, quat_view<double> swing,
                 quat_view<double> twist, options o) noexcept {
    return full<double>(q, a, swing, twist, nullptr, o);
}
status decompose(quat_view<const float> q, twist_axis<float> a, quat_view<float> swing,
                 quat_view<float> twist, scalar_view<float> signs, options o) noexcept {
    return full<float>(q, a, swing, twist, &signs, o);
}
status decompose(quat_view<const double> q, twist_axis<double> a, quat_view<double> swing,
                 quat_view<double> twist, scalar_view<double> signs, options o) noexcept {
    return full<double>(q, a, swing, twist, &signs, o);
}

status decompose(quat_view<const float> q, axis a, factor_view<float> out, options o) noexcept {
    return compact<float>(q, a, out, nullptr, o);
}
status decompose(quat_view<const double> q, axis a, factor_view<double> out, options o) noexcept {
    return compact<double>(q, a, out, nullptr, o);
}
status decompose(quat_view<const float> q, axis a, factor_view<float> out, scalar_view<float> signs,
                 options o) noexcept {
    return compact<float>(q, a, out, &signs, o);
}
status decompose(quat_view<const double> q, axis a, factor_view<double> out, scalar_view<double> signs,
                 options o) noexcept {
    return compact<double>(q, a, out, &signs, o);
}

}  // namespace swivel
