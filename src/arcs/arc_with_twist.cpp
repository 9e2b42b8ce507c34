#include "swivel/arc_with_twist.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const vec3_view<const T>& v, const vec3_view<const T>& w, const parameter<T>& radians,
                const quat_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().arc_with_twist[o.order == product::swing_twist][index_of(o.accuracy)],
        [&](batch<T>&) { return check(o); }, std::tuple(group_of(v), group_of(w), group_of(radians, v.size)),
        std::tuple(group_of(out)));
}

}  // namespace

status arc_with_twist(const vec3_view<const float>& v, const vec3_view<const float>& w,
                      const parameter<float>& radians, const quat_view<float>& out, options o) noexcept {
    return any_type<float>(v, w, radians, out, o);
}
status arc_with_twist(const vec3_view<const double>& v, const vec3_view<const double>& w,
                      const parameter<double>& radians, const quat_view<double>& out, options o) noexcept {
    return any_type<double>(v, w, radians, out, o);
}

}  // namespace swivel
