#include "swivel/power.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const parameter<T>& t, const quat_view<T>& out,
                const options& o) noexcept {
    return run(
        active_operations<T>().power[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(q), group_of(t, q.size)), std::tuple(group_of(out)));
}

}  // namespace

status power(const quat_view<const float>& q, const parameter<float>& t, const quat_view<float>& out,
             options o) noexcept {
    return any_type<float>(q, t, out, o);
}
status power(const quat_view<const double>& q, const parameter<double>& t, const quat_view<double>& out,
             options o) noexcept {
    return any_type<double>(q, t, out, o);
}

}  // namespace swivel
