#include "swivel/twist_angle.hpp"

#include "arguments.hpp"

namespace swivel {

namespace {

template <class T>
status project(quat_view<const T> q, const twist_axis<T>& a, scalar_view<T> out, const options& o) noexcept {
    projection<T> p(q, a, o);
    p.write(out);
    if (const status bad = p.check_all(a, o); bad != status::ok || p.s.size == 0) return bad;
    const operations<T>& table = active_operations<T>();
    run(table.twist_angle[p.order.form][o.positive_twist][index_of(o.accuracy)], table, p.s, p.b);
    return status::ok;
}

}  // namespace

status twist_angle(quat_view<const float> q, twist_axis<float> a, scalar_view<float> radians,
                   options o) noexcept {
    return project<float>(q, a, radians, o);
}
status twist_angle(quat_view<const double> q, twist_axis<double> a, scalar_view<double> radians,
                   options o) noexcept {
    return project<double>(q, a, radians, o);
}

}  // namespace swivel
