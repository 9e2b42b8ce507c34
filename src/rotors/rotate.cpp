#include "swivel/rotate.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status by_each(const quat_view<const T>& q, const vec3_view<const T>& v, const vec3_view<T>& out,
               const options& o) noexcept {
    return run(
        active_operations<T>().rotate[false][index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(q), group_of(v)), std::tuple(group_of(out)));
}

template <class T>
status by_one(const quat<T>& q, const vec3_view<const T>& v, const vec3_view<T>& out,
              const options& o) noexcept {
    const auto set_numbers = [&](batch<T>& b) {
        b.uniform[0] = q.x;
        b.uniform[1] = q.y;
        b.uniform[2] = q.z;
        b.uniform[3] = q.w;
        return check(o);
    };
    return run(active_operations<T>().rotate[true][index_of(o.accuracy)], set_numbers,
               std::tuple(group_of(v)), std::tuple(group_of(out)));
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
