#include "swivel/shortest_arc.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const vec3_view<const T>& v, const vec3_view<const T>& w, const quat_view<T>& out,
                const options& o) noexcept {
    return run(
        active_operations<T>().shortest_arc[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(v), group_of(w)), std::tuple(group_of(out)));
}

}  // namespace

status shortest_arc(const vec3_view<const float>& v, const vec3_view<const float>& w,
                    const quat_view<float>& out, options o) noexcept {
    return any_type<float>(v, w, out, o);
}
status shortest_arc(const vec3_view<const double>& v, const vec3_view<const double>& w,
                    const quat_view<double>& out, options o) noexcept {
    return any_type<double>(v, w, out, o);
}

}  // namespace swivel
