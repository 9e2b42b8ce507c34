#include "swivel/conformal.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_multiply(const conformal_view<const T>& a, const conformal_view<const T>& b,
                    const conformal_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().conformal_multiply[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(a), group_of(b)), std::tuple(group_of(out)));
}

template <class T>
status any_reverse(const conformal_view<const T>& c, const conformal_view<T>& out,
                   const options& o) noexcept {
    return run(
        active_operations<T>().conformal_reverse, [&](batch<T>&) { return check(o); },
        std::tuple(group_of(c)), std::tuple(group_of(out)));
}

template <class T>
status any_from_motor(const motor_view<const T>& m, const conformal_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().conformal_from_motor, [&](batch<T>&) { return check(o); },
        std::tuple(group_of(m)), std::tuple(group_of(out)));
}

template <class T>
status any_from_rotation(const quat_view<const T>& q, const conformal_view<T>& out,
                         const options& o) noexcept {
    return run(
        active_operations<T>().conformal_from_rotation, [&](batch<T>&) { return check(o); },
        std::tuple(group_of(q)), std::tuple(group_of(out)));
}

template <class T>
status any_from_translation(const vec3_view<const T>& t, const conformal_view<T>& out,
                            const options& o) noexcept {
    return run(
        active_operations<T>().conformal_from_translation, [&](batch<T>&) { return check(o); },
        std::tuple(group_of(t)), std::tuple(group_of(out)));
}

template <class T>
status any_from_dilation(const scalar_view<const T>& factor, const conformal_view<T>& out,
                         const options& o) noexcept {
    return run(
        active_operations<T>().conformal_from_dilation, [&](batch<T>&) { return check(o); },
        std::tuple(group_of(factor)), std::tuple(group_of(out)));
}

template <class T>
status any_transform(const conformal_view<const T>& r, const vec3_view<const T>& points,
                     const vec3_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().conformal_transform[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(r), group_of(points)), std::tuple(group_of(out)));
}

template <class T>
status any_square_root(const conformal_view<const T>& r, const conformal_view<T>& out,
                       const scalar_view<T>& unique, const options& o) noexcept {
    return run(
        active_operations<T>().conformal_square_root[index_of(o.accuracy)],
        [&](batch<T>&) { return check(o); }, std::tuple(group_of(r)),
        std::tuple(group_of(out), group_of(unique)));
}

template <class T>
status any_exp(const bivector_view<const T>& b, const conformal_view<T>& out, const options& o) noexcept {
    return run(
        active_operations<T>().conformal_exp[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(b)), std::tuple(group_of(out)));
}

template <class T>
status any_log(const conformal_view<const T>& r, const bivector_view<T>& out, const scalar_view<T>& unique,
               const options& o) noexcept {
    return run(
        active_operations<T>().conformal_log[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(r)), std::tuple(group_of(out), group_of(unique)));
}

template <class T>
status any_power(const conformal_view<const T>& r, const parameter<T>& t, const conformal_view<T>& out,
                 const scalar_view<T>& unique, const options& o) noexcept {
    return run(
        active_operations<T>().conformal_power[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(r), group_of(t, r.size)), std::tuple(group_of(out), group_of(unique)));
}

template <class T>
status any_interpolate(const conformal_view<const T>& a, const conformal_view<const T>& b,
                       const parameter<T>& t, const conformal_view<T>& out, const scalar_view<T>& unique,
                       const options& o) noexcept {
    return run(
        active_operations<T>().conformal_interpolate[index_of(o.accuracy)],
        [&](batch<T>&) { return check(o); }, std::tuple(group_of(a), group_of(b), group_of(t, a.size)),
        std::tuple(group_of(out), group_of(unique)));
}

template <class T>
status any_split(const bivector_view<const T>& b, const bivector_view<T>& first,
                 const bivector_view<T>& second, const scalar_view<T>& unique, const options& o) noexcept {
    return run(
        active_operations<T>().conformal_split[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(b)), std::tuple(group_of(first), group_of(second), group_of(unique)));
}

}  // namespace

status multiply(const conformal_view<const float>& a, const conformal_view<const float>& b,
                const conformal_view<float>& out, options o) noexcept {
    return any_multiply<float>(a, b, out, o);
}
status multiply(const conformal_view<const double>& a, const conformal_view<const double>& b,
                const conformal_view<double>& out, options o) noexcept {
    return any_multiply<double>(a, b, out, o);
}
status reverse(const conformal_view<const float>& c, const conformal_view<float>& out, options o) noexcept {
    return any_reverse<float>(c, out, o);
}
status reverse(const conformal_view<const double>& c, const conformal_view<double>& out, options o) noexcept {
    return any_reverse<double>(c, out, o);
}
status from_motor(const motor_view<const float>& m, const conformal_view<float>& out, options o) noexcept {
    return any_from_motor<float>(m, out, o);
}
status from_motor(const motor_view<const double>& m, const conformal_view<double>& out, options o) noexcept {
    return any_from_motor<double>(m, out, o);
}
status from_rotation(const quat_view<const float>& q, const conformal_view<float>& out, options o) noexcept {
    return any_from_rotation<float>(q, out, o);
}
status from_rotation(const quat_view<const double>& q, const conformal_view<double>& out,
                     options o) noexcept {
    return any_from_rotation<double>(q, out, o);
}
status from_translation(const vec3_view<const float>& t, const conformal_view<float>& out,
                        options o) noexcept {
    return any_from_translation<float>(t, out, o);
}
status from_translation(const vec3_view<const double>& t, const conformal_view<double>& out,
                        options o) noexcept {
    return any_from_translation<double>(t, out, o);
}
status from_dilation(const scalar_view<const float>& factor, const conformal_view<float>& out,
                     options o) noexcept {
    return any_from_dilation<float>(factor, out, o);
}
status from_dilation(const scalar_view<const double>& factor, const conformal_view<double>& out,
                     options o) noexcept {
    return any_from_dilation<double>(factor, out, o);
}
status transform(const conformal_view<const float>& r, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options o) noexcept {
    return any_transform<float>(r, points, out, o);
}
status transform(const conformal_view<const double>& r, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options o) noexcept {
    return any_transform<double>(r, points, out, o);
}
status square_root(const conformal_view<const float>& r, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options o) noexcept {
    return any_square_root<float>(r, out, unique, o);
}
status square_root(const conformal_view<const double>& r, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options o) noexcept {
    return any_square_root<double>(r, out, unique, o);
}
status exp(const bivector_view<const float>& b, const conformal_view<float>& out, options o) noexcept {
    return any_exp<float>(b, out, o);
}
status exp(const bivector_view<const double>& b, const conformal_view<double>& out, options o) noexcept {
    return any_exp<double>(b, out, o);
}
status log(const conformal_view<const float>& r, const bivector_view<float>& out,
           const scalar_view<float>& unique, options o) noexcept {
    return any_log<float>(r, out, unique, o);
}
status log(const conformal_view<const double>& r, const bivector_view<double>& out,
           const scalar_view<double>& unique, options o) noexcept {
    return any_log<double>(r, out, unique, o);
}
status power(const conformal_view<const float>& r, const parameter<float>& t,
             const conformal_view<float>& out, const scalar_view<float>& unique, options o) noexcept {
    return any_power<float>(r, t, out, unique, o);
}
status power(const conformal_view<const double>& r, const parameter<double>& t,
             const conformal_view<double>& out, const scalar_view<double>& unique, options o) noexcept {
    return any_power<double>(r, t, out, unique, o);
}
status interpolate(const conformal_view<const float>& a, const conformal_view<const float>& b,
                   const parameter<float>& t, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options o) noexcept {
    return any_interpolate<float>(a, b, t, out, unique, o);
}
status interpolate(const conformal_view<const double>& a, const conformal_view<const double>& b,
                   const parameter<double>& t, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options o) noexcept {
    return any_interpolate<double>(a, b, t, out, unique, o);
}
status split(const bivector_view<const float>& b, const bivector_view<float>& first,
             const bivector_view<float>& second, const scalar_view<float>& unique, options o) noexcept {
    return any_split<float>(b, first, second, unique, o);
}
status split(const bivector_view<const double>& b, const bivector_view<double>& first,
             const bivector_view<double>& second, const scalar_view<double>& unique, options o) noexcept {
    return any_split<double>(b, first, second, unique, o);
}

}  // namespace swivel
