#include "swivel/shortest_arc.hpp"

#include "kernels/arcs/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const vec3_view<const T>& v, const vec3_view<const T>& w, const quat_view<T>& out,
                const options& o) noexcept {
    call<T> c(v.size, o);
    c.read(v);
    c.read(w);
    c.write(out);
    return c.template run<shortest_arc_kernels>(index_of(o.accuracy));
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
