#include "swivel/spinor.hpp"

#include "kernels/rotors/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

// With the components in the places of those that they become, a change of three signs is all there is to it.
template <class T>
status from_any(const spinor_view<const T>& s, const quat_view<T>& q, const options& o) noexcept {
    call<T> c(s.size, o);
    c.read(s);
    c.write(q);
    return c.template run<conjugate_kernels>(0);
}

template <class T>
status to_any(const quat_view<const T>& q, const spinor_view<T>& s, const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.write(s);
    return c.template run<conjugate_kernels>(0);
}

}  // namespace

status from_spinor(const spinor_view<const float>& s, const quat_view<float>& q, options o) noexcept {
    return from_any<float>(s, q, o);
}
status from_spinor(const spinor_view<const double>& s, const quat_view<double>& q, options o) noexcept {
    return from_any<double>(s, q, o);
}
status to_spinor(const quat_view<const float>& q, const spinor_view<float>& s, options o) noexcept {
    return to_any<float>(q, s, o);
}
status to_spinor(const quat_view<const double>& q, const spinor_view<double>& s, options o) noexcept {
    return to_any<double>(q, s, o);
}

}  // namespace swivel
