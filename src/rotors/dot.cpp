#include "swivel/dot.hpp"

#include "kernels/rotors/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& a, const quat_view<const T>& b, const scalar_view<T>& out,
                const options& o) noexcept {
    call<T> c(a.size, o);
    c.read(a);
    c.read(b);
    c.write(out);
    return c.template run<dot_kernels>(index_of(o.accuracy));
}

}  // namespace

status dot(const quat_view<const float>& a, const quat_view<const float>& b, const scalar_view<float>& out,
           options o) noexcept {
    return any_type<float>(a, b, out, o);
}
status dot(const quat_view<const double>& a, const quat_view<const double>& b, const scalar_view<double>& out,
           options o) noexcept {
    return any_type<double>(a, b, out, o);
}

}  // namespace swivel
