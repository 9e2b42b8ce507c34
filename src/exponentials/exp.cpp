#include "swivel/exp.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const vec3_view<const T>& b, const quat_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().exp[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(b)), std::tuple(group_of(out)));
}

}  // namespace

status exp(const vec3_view<const float>& b, const quat_view<float>& out, options o) noexcept {
    return any_type<float>(b, out, o);
}
status exp(const vec3_view<const double>& b, const quat_view<double>& out, options o) noexcept {
    return any_type<double>(b, out, o);
}

}  // namespace swivel
