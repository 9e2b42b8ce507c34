#include "swivel/rotate.hpp"

#include "kernels/rotors/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status by_each(const quat_view<const T>& q, const vec3_view<const T>& v, const vec3_view<T>& out,
               const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.read(v);
    c.write(out);
    return c.template run<rotate_kernels>(index_of(o.accuracy));
}

template <class T>
status by_one(const quat<T>& q, const vec3_view<const T>& v, const vec3_view<T>& out,
              const options& o) noexcept {
    call<T> c(v.size, o);
    c.read(v);
    c.write(out);
    c.number(0, q.x);
    c.number(1, q.y);
    c.number(2, q.z);
    c.number(3, q.w);
    return c.template run<rotate_by_one_kernels>(index_of(o.accuracy));
}

}  // namespace

status rotate(const quat_view<const float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options o) noexcept {
    return by_each<float>(q, v, out, o);
}
status rotate(const quat_view<const double>& q, const vec3_view<const double>& v,
              const vec3_view<double>& out, options o) noexcept {
    return by_each<double>(q, v, out, o);
}
status rotate(const quat<float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options o) noexcept {
    return by_one<float>(q, v, out, o);
}
status rotate(const quat<double>& q, const vec3_view<const double>& v, const vec3_view<double>& out,
              options o) noexcept {
    return by_one<double>(q, v, out, o);
}

}  // namespace swivel
