#include "swivel/compose.hpp"

#include "arguments.hpp"

namespace swivel {

namespace {

template <class T>
status full(quat_view<const T> swing, quat_view<const T> twist, const scalar_view<const T>* signs,
            quat_view<T> q, const options& o) noexcept {
    streams<T> s = composition(swing, twist, signs, q, o);
    if (const status bad = check(s, o); bad != status::ok || s.size == 0) return bad;
    const operations<T>& table = active_operations<T>();
    batch<T> b;
    run(table.compose[signs != nullptr][index_of(o.accuracy)], table, s, b);
    return status::ok;
}

template <class T>
status compact(factor_view<const T> factors, axis a, const scalar_view<const T>* signs, quat_view<T> q,
               const options& o) noexcept {
    streams<T> s = composition(factors, a, signs, q, o);
    if (const status bad = check(s, o, a); bad != status::ok || s.size == 0) return bad;
    const operations<T>& table = active_operations<T>();
    batch<T> b;
    run(table.compose_compact[signs != nullptr][index_of(o.accuracy)], table, s, b);
    return status::ok;
}

}  // namespace

status compose(quat_view<const float> swing, quat_view<const float> twist, quat_view<float> q,
               options o) noexcept {
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
status compose(factor_view<const double> factors, axis a, scalar_view<const double> signs,
               quat_view<double> q, options o) noexcept {
    return compact<double>(factors, a, &signs, q, o);
}

}  // namespace swivel
