#include "swivel/atan2.hpp"

#include "kernels/angles/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const scalar_view<const T>& y, const scalar_view<const T>& x, const scalar_view<T>& radians,
                const options& o) noexcept {
    call<T> c(y.size, o);
    c.read(y);
    c.read(x);
    c.write(radians);
    return c.template run<atan2_kernels>(index_of(o.accuracy));
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
