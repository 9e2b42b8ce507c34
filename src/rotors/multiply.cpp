#include "swivel/multiply.hpp"

#include "kernels/swing_twist/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const quat_view<T>& out,
                const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.write(out);
    return c.template run<compose_kernels>(0, index_of(o.accuracy));
}

}  // namespace

status multiply(const quat_view<const float>& a, const quat_view<const float>& b, const quat_view<float>& out,
                options o) noexcept {
    return any_type<float>(a, b, out, o);
}
status multiply(const quat_view<const double>& a, const quat_view<const double>& b,
                const quat_view<double>& out, options o) noexcept {
    return any_type<double>(a, b, out, o);
}

}  // namespace swivel
