#include "swivel/log.hpp"

#include "kernels/exponentials/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const vec3_view<T>& out, const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.write(out);
    return c.template run<log_kernels>(index_of(o.accuracy));
}

}  // namespace

status log(const quat_view<const float>& q, const vec3_view<float>& out, options o) noexcept {
    return any_type<float>(q, out, o);
}
status log(const quat_view<const double>& q, const vec3_view<double>& out, options o) noexcept {
    return any_type<double>(q, out, o);
}

}  // namespace swivel
