#include "swivel/matrix.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status from_any(const matrix_view<const T>& m, const quat_view<T>& q, const options& o) noexcept {
    return run(
        active_operations<T>().from_matrix[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(m)), std::tuple(group_of(q)));
}

template <class T>
status to_any(const quat_view<const T>& q, const matrix_view<T>& m, const options& o) noexcept {
    return run(
        active_operations<T>().to_matrix[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(q)), std::tuple(group_of(m)));
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
