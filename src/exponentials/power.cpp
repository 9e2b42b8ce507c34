#include "swivel/power.hpp"

#include "kernels/exponentials/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const quat_view<const T>& q, const parameter<T>& t, const quat_view<T>& out,
                const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.read(t);
    c.write(out);
    return c.template run<power_kernels>(index_of(o.accuracy));
}

}  // namespace

status power(const quat_view<const float>& q, const parameter<float>& t, const quat_view<float>& out,
             options o) noexcept {
    return any_type<float>(q, t, out, o);
}
status power(const quat_view<const double>& q, const parameter<double>& t, const quat_view<double>& out,
             options o) noexcept {
    return any_type<double>(q, t, out, o);
}

}  // namespace swivel
