#include "swivel/swing.hpp"

#include "arguments.hpp"

namespace swivel {

namespace {

template <class T>
status project(quat_view<const T> q, const twist_axis<T>& a, quat_view<T> out, const options& o) noexcept {
    projection<T> p(q, a, o);
    p.write(out);
    if (const status bad = p.check_all(a, o); bad != status::ok || p.s.size == 0) return bad;
    const operations<T>& table = active_operations<T>();
    run(table.swing[p.order.form][index_of(o.accuracy)], table, p.s, p.b);
    return status::ok;
}

}  // namespace

status swing(quat_view<const float> q, twist_axis<float> a, quat_view<float> out, options o) noexcept {
    return project<float>(q, a, out, o);
}
status swing(quat_view<const double> q, twist_axis<double> a, quat_view<double> out, options o) noexcept {
    return project<double>(q, a, out, o);
}

}  // namespace swivel
