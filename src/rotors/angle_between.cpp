#include "swivel/angle_between.hpp"

#include "kernels/rotors/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const scalar_view<T>& radians,
                const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.write(radians);
    return c.template run<angle_between_kernels>(index_of(o.accuracy));
}

}  // namespace

status angle_between(const quat_view<const float>& a, const quat_view<const float>& b,
                     const scalar_view<float>& radians, options o) noexcept {
    return any_type<float>(a, b, radians, o);
}
status angle_between(const quat_view<const double>& a, const quat_view<const double>& b,
                     const scalar_view<double>& radians, options o) noexcept {
    return any_type<double>(a, b, radians, o);
}

}  // namespace swivel
