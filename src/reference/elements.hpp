#ifndef SWIVEL_SRC_REFERENCE_ELEMENTS_HPP
#define SWIVEL_SRC_REFERENCE_ELEMENTS_HPP

// Elements of views, and what is common to the calls of swivel::reference.

#include <tuple>

#include "src/call/call.hpp"

namespace swivel::reference {

template <class T>
T* element(T* first, std::size_t i, std::ptrdiff_t stride) {
    return first + static_cast<std::ptrdiff_t>(i) * stride;
}

template <class T>
quat<T> read(const quat_view<const T>& v, std::size_t i) {
    return {*element(v.x, i, v.stride), *element(v.y, i, v.stride), *element(v.z, i, v.stride),
            *element(v.w, i, v.stride)};
}

template <class T>
void write(const quat_view<T>& v, std::size_t i, const quat<T>& q) {
    *element(v.x, i, v.stride) = q.x;
    *element(v.y, i, v.stride) = q.y;
    *element(v.z, i, v.stride) = q.z;
    *element(v.w, i, v.stride) = q.w;
}

template <class T>
vec3<T> read(const vec3_view<const T>& v, std::size_t i) {
    return {*element(v.x, i, v.stride), *element(v.y, i, v.stride), *element(v.z, i, v.stride)};
}

template <class T>
void write(const vec3_view<T>& v, std::size_t i, const vec3<T>& a) {
    *element(v.x, i, v.stride) = a.x;
    *element(v.y, i, v.stride) = a.y;
    *element(v.z, i, v.stride) = a.z;
}

template <class T>
struct motor {
    quat<T> r, d;
};

template <class T>
quat_view<T> real_part(const motor_view<T>& m) {
    return {m.x, m.y, m.z, m.w, m.size, m.stride};
}
template <class T>
quat_view<T> dual_part(const motor_view<T>& m) {
    return {m.dx, m.dy, m.dz, m.dw, m.size, m.stride};
}

template <class T>
motor<T> read(const motor_view<const T>& m, std::size_t i) {
    return {read(real_part(m), i), read(dual_part(m), i)};
}
template <class T>
void write(const motor_view<T>& out, std::size_t i, const motor<T>& m) {
    write(real_part(out), i, m.r);
    write(dual_part(out), i, m.d);
}

template <class T>
T read(const scalar_view<const T>& v, std::size_t i) {
    return *element(v.data, i, v.stride);
}

template <class T>
T read(const parameter<T>& t, std::size_t i) {
    return t.is_per_element ? read(t.per_element, i) : t.for_all;
}

template <class T>
void write(const scalar_view<T>& v, std::size_t i, T a) {
    *element(v.data, i, v.stride) = a;
}

template <class T>
factors<T> read(const factor_view<const T>& v, std::size_t i) {
    return {v.s1[i], v.s2[i], v.sc[i], v.ts[i], v.tc[i]};
}

template <class T>
struct matrix3 {
    T xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

template <class T>
matrix3<T> read(const matrix_view<const T>& v, std::size_t i) {
    const auto at = [&](const T* first) { return *element(first, i, v.stride); };
    return {at(v.xx), at(v.xy), at(v.xz), at(v.yx), at(v.yy), at(v.yz), at(v.zx), at(v.zy), at(v.zz)};
}

template <class T>
void write(const matrix_view<T>& v, std::size_t i, const matrix3<T>& m) {
    const auto put = [&](T* first, T a) { *element(first, i, v.stride) = a; };
    put(v.xx, m.xx);
    put(v.xy, m.xy);
    put(v.xz, m.xz);
    put(v.yx, m.yx);
    put(v.yy, m.yy);
    put(v.yz, m.yz);
    put(v.zx, m.zx);
    put(v.zy, m.zy);
    put(v.zz, m.zz);
}

// Checks, as the operation itself does, the views and an argument that is right or wrong in itself; then calls
// body(i) for every element in order.
template <class T, class... In, class... Out, class Body>
status for_each(const options& o, const std::tuple<In...>& reads, const std::tuple<Out...>& writes, Body body,
                status argument = status::ok) {
    const std::size_t size = std::get<0>(reads).size;
    call<T> c(size, o);
    std::apply([&](const auto&... v) { (c.read(v), ...); }, reads);
    std::apply([&](const auto&... v) { (c.write(v), ...); }, writes);
    c.require(argument);
    if (const status bad = c.check_all(); bad != status::ok) return bad;
    for (std::size_t i = 0; i < size; ++i) body(i);
    return status::ok;
}

}  // namespace swivel::reference

#endif
