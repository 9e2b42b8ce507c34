#include "swivel/slerp.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const parameter<T>& t,
                const quat_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().slerp[o.long_way][index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(a), group_of(b), group_of(t, a.size)), std::tuple(group_of(out)));
}

}  // namespace

status slerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options o) noexcept {
    return any_type<float>(a, b, t, out, o);
}
status slerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options o) noexcept {
    return any_type<double>(a, b, t, out, o);
}

}  // namespace swivel
