#include "swivel/matrix.hpp"

#include "kernels/conversions/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status from_any(const matrix_view<const T>& m, const quat_view<T>& q, const options& o) noexcept {
    call<T> c(m.size, o);
    c.read(m);
    c.write(q);
    return c.template run<from_matrix_kernels>(index_of(o.accuracy));
}

template <class T>
status to_any(const quat_view<const T>& q, const matrix_view<T>& m, const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.write(m);
    return c.template run<to_matrix_kernels>(index_of(o.accuracy));
}

}  // namespace

status from_matrix(const matrix_view<const float>& m, const quat_view<float>& q, options o) noexcept {
    return from_any<float>(m, q, o);
}
status from_matrix(const matrix_view<const double>& m, const quat_view<double>& q, options o) noexcept {
    return from_any<double>(m, q, o);
}
status to_matrix(const quat_view<const float>& q, const matrix_view<float>& m, options o) noexcept {
    return to_any<float>(q, m, o);
}
status to_matrix(const quat_view<const double>& q, const matrix_view<double>& m, options o) noexcept {
    return to_any<double>(q, m, o);
}

}  // namespace swivel
