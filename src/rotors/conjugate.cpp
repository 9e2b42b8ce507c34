#include "swivel/conjugate.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const quat_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().conjugate, [&](batch<T>&) { return check(o); }, std::tuple(group_of(q)),
        std::tuple(group_of(out)));
}

}  // namespace

status conjugate(const quat_view<const float>& q, const quat_view<float>& out, options o) noexcept {
    return any_type<float>(q, out, o);
}
status conjugate(const quat_view<const double>& q, const quat_view<double>& out, options o) noexcept {
    return any_type<double>(q, out, o);
}

}  // namespace swivel
