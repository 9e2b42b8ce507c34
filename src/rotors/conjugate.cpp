#include "swivel/conjugate.hpp"

#include "kernels/rotors/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const quat_view<T>& out, const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.write(out);
    return c.template run<conjugate_kernels>(0);
}

}  // namespace

status conjugate(const quat_view<const float>& q, const quat_view<float>& out, options o) noexcept {
    return any_type<float>(q, out, o);
}
status conjugate(const quat_view<const double>& q, const quat_view<double>& out, options o) noexcept {
    return any_type<double>(q, out, o);
}

}  // namespace swivel
