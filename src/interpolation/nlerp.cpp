#include "swivel/nlerp.hpp"

#include "kernels/interpolation/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const parameter<T>& t,
                const quat_view<T>& out, const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.read(t);
    c.write(out);
    c.number(0, o.long_way ? T(-0.0) : T(0));
    return c.template run<nlerp_kernels>(index_of(o.accuracy));
}

}  // namespace

status nlerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options o) noexcept {
    return any_type<float>(a, b, t, out, o);
}
status nlerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options o) noexcept {
    return any_type<double>(a, b, t, out, o);
}

}  // namespace swivel
