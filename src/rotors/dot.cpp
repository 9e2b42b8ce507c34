#include "swivel/dot.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const scalar_view<T>& out,
                const options& o) noexcept {
    return run(
        active_operations<T>().dot[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(a), group_of(b)), std::tuple(group_of(out)));
}

}  // namespace

status dot(const quat_view<const float>& a, const quat_view<const float>& b, const scalar_view<float>& out,
           options o) noexcept {
    return any_type<float>(a, b, out, o);
}
status dot(const quat_view<const double>& a, const quat_view<const double>& b, const scalar_view<double>& out,
           options o) noexcept {
    return any_type<double>(a, b, out, o);
}

}  // namespace swivel
