#include "swivel/exp.hpp"

#include "kernels/exponentials/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const vec3_view<const T>& b, const quat_view<T>& out, const options& o) noexcept {
    call<T> c(b.size, o);
    c.read(b);
    c.write(out);
    return c.template run<exp_kernels>(index_of(o.accuracy));
}

}  // namespace

status exp(const vec3_view<const float>& b, const quat_view<float>& out, options o) noexcept {
    return any_type<float>(b, out, o);
}
status exp(const vec3_view<const double>& b, const quat_view<double>& out, options o) noexcept {
    return any_type<double>(b, out, o);
}

}  // namespace swivel
