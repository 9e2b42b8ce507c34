#include "swivel/arc_with_twist.hpp"

#include "kernels/arcs/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const vec3_view<const T>& v, const vec3_view<const T>& w, const parameter<T>& radians,
                const quat_view<T>& out, const options& o) noexcept {
    call<T> c(v.size, o);
    c.read(v);
    c.read(w);
    c.read(radians);
    c.write(out);
    return c.template run<arc_with_twist_kernels>(o.order == product::swing_twist, index_of(o.accuracy));
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
