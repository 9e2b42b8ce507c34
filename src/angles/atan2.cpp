#include "swivel/atan2.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const scalar_view<const T>& y, const scalar_view<const T>& x, const scalar_view<T>& radians,
                const options& o) noexcept {
    return run(
        active_operations<T>().atan2[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(y), group_of(x)), std::tuple(group_of(radians)));
}

}  // namespace

status atan2(const scalar_view<const float>& y, const scalar_view<const float>& x,
             const scalar_view<float>& radians, options o) noexcept {
    return any_type<float>(y, x, radians, o);
}
status atan2(const scalar_view<const double>& y, const scalar_view<const double>& x,
             const scalar_view<double>& radians, options o) noexcept {
    return any_type<double>(y, x, radians, o);
}

}  // namespace swivel
