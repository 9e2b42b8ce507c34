#ifndef SWIVEL_TYPES_HPP
#define SWIVEL_TYPES_HPP

// Conventions of the whole library
//
//   Quaternions   Hamilton, ij = k. Fields and streams in the order x, y, z, w; w is the scalar part.
//   Rotations     active, v' = q v q*. Angles in radians. A quaternion holds the cosine and sine of half its
//                 angle, so q and -q rotate alike.
//   Products      read right to left: in q = S T the twist T is applied first, then the swing S.
//                   product::swing_twist   q = S T   swing after twist
//                   product::twist_swing   q = T R   twist after swing
//                 The twist T is the same in both; S = T R T* are different rotations.
//   Twist         about the axis `a` given by the caller, never about the rotated axis q a q*.
//   Swing         about an axis perpendicular to `a`, through [0, pi]; its w is never negative.
//   Pole          w = 0 and a.v = 0, where q turns `a` into -a (a half-turn swing) and every twist would do.
//                 decompose.hpp says what comes out there.
//   Spinor        a + b e12 + c e23 + d e31 of Dobrowolski's paper is (w, x, y, z) = (a, -c, -d, -b).
//
// Contract shared by every operation that takes views
//
//   Never throws, never allocates, takes no lock, and may be called from any thread at any time; a call takes at
//   most 16 KiB of stack, whatever the sizes and strides (stack_test.cpp). The floating
//   point environment (rounding mode, flush to zero) is used as found; the stated figures are for the default.
//   Of the exception flags inexact alone is raised on ordinary data and on still data (no motion, b = a, vectors of
//   zeros where they are allowed), which is as quick as any other; beside poles and other singular places, and where
//   squares and products of what is given overflow or underflow, any flag may be raised (exceptions_test.cpp).
//   All checks are made before the first write and cost the same for every size. On any status but `ok` nothing
//   has been written. A size of 0 is `ok`, whatever the pointers. Values are not inspected.
//   An output stream may be exactly an input stream (same pointer, stride and size: in place). Any other overlap
//   of an output with an input or with another output is refused.

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace swivel {

enum class axis : std::uint8_t { x, y, z };

enum class product : std::uint8_t {
    swing_twist,  // q = S T
    twist_swing   // q = T R
};

// The order of three rotations about coordinate axes. xyz is the quaternion qx qy qz: about x, then about the
// y that this has turned, then about the z that both have turned; or about the axes as they stand, z first.
// It is what the channels "Xrotation Yrotation Zrotation" of a BVH file mean. xyx is qx qy qx with angles of their own:
// the third rotation is about the axis of the first again, as it then lies (the proper Euler angles).
enum class euler_order : std::uint8_t { xyz, xzy, yxz, yzx, zxy, zyx, xyx, xzx, yxy, yzy, zxz, zyz };

enum class precision : std::uint8_t {
    // The quickest arithmetic of the ISA: fused multiply-add, estimate of the reciprocal root, Newton steps.
    fast,
    // Only correctly rounded + - * / and square root, in one order: the same bits on every ISA, compiler and
    // in swivel::reference.
    reproducible
};

enum class [[nodiscard]] status : std::uint8_t{
    ok,
    null_stream,      // a pointer is null and the size is not 0
    size_mismatch,    // the views differ in size
    partial_overlap,  // an output overlaps an input or another output without being exactly an input
    bad_argument,     // zero or non-finite axis, an enumerator out of range, a threshold outside [0, 1], an
                      // output of stride 0, a view that is larger than memory
    isa_unavailable   // set_active_isa: this ISA is not compiled in or not usable on this machine
};

// The English words for a status, for messages; never null.
const char* name(status) noexcept;

template <class T>
struct vec3 {
    T x, y, z;
    friend constexpr bool operator==(const vec3&, const vec3&) = default;
};

template <class T>
struct quat {
    T x, y, z, w;
    friend constexpr bool operator==(const quat&, const quat&) = default;
};

// The compact form of a decomposition about a coordinate axis: five numbers. With (A; B, C) the cyclic names
// (x; y, z), (y; z, x) or (z; x, y) for the axes x, y and z
//   twist = tc + ts A,   swing = sc + s1 B + s2 C.
template <class T>
struct factors {
    T s1, s2, sc, ts, tc;
    friend constexpr bool operator==(const factors&, const factors&) = default;
};

// Views: pointers to the first element of each component, the number of elements, and the distance between
// elements in units of T. They own nothing. stride 1 is structure of arrays; 4 with adjacent pointers is an
// array of quaternions; any other stride (every other joint, a field of a larger record, backwards) is valid
// too, and stride 0 reads one element over and over. T is float or double, const where the view is only read.

template <class T>
struct quat_view {
    T *x, *y, *z, *w;
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator quat_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        return {x, y, z, w, size, stride};
    }
};

template <class T>
struct vec3_view {
    T *x, *y, *z;
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator vec3_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        return {x, y, z, size, stride};
    }
};

template <class T>
struct scalar_view {
    T* data;
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator scalar_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        return {data, size, stride};
    }
};

// Matrices of 3 rows and 3 columns that turn column vectors, v' = M v; xy is row x, column y. An array of
// matrices stored by rows has adjacent pointers and stride 9; stored by columns, the pointers are exchanged.
template <class T>
struct matrix_view {
    T *xx, *xy, *xz, *yx, *yy, *yz, *zx, *zy, *zz;
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator matrix_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        return {xx, xy, xz, yx, yy, yz, zx, zy, zz, size, stride};
    }
};

// The spinors a + b e12 + c e23 + d e31 of Dobrowolski's paper.
template <class T>
struct spinor_view {
    T *a, *b, *c, *d;
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator spinor_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        return {a, b, c, d, size, stride};
    }
};

// Rigid motions as dual quaternions r + eps d: r = (x, y, z, w) is the rotation and d = (dx, dy, dz, dw) half
// of the translation t times it, d = t r / 2. A point goes to r p r* + t. M and -M move alike. Motors are
// expected to be of unit length, |r| = 1 and r.d = 0, to rounding; `normalize` brings them there.
template <class T>
struct motor_view {
    T *x, *y, *z, *w, *dx, *dy, *dz, *dw;
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator motor_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        return {x, y, z, w, dx, dy, dz, dw, size, stride};
    }
};

// Even elements of the conformal algebra of space, e1 e2 e3 e4 = +1, e5 = -1 squared. In this order:
// 1, e12 e13 e14 e15 e23 e24 e25 e34 e35 e45, e1234 e1235 e1245 e1345 e2345.
template <class T>
struct conformal_view {
    T* blade[16];
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator conformal_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        conformal_view<const T> v{{}, size, stride};
        for (int k = 0; k < 16; ++k) v.blade[k] = blade[k];
        return v;
    }
};

// Bivectors of that algebra: e12 e13 e14 e15 e23 e24 e25 e34 e35 e45.
template <class T>
struct bivector_view {
    T* blade[10];
    std::size_t size;
    std::ptrdiff_t stride = 1;

    constexpr operator bivector_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        bivector_view<const T> v{{}, size, stride};
        for (int k = 0; k < 10; ++k) v.blade[k] = blade[k];
        return v;
    }
};

template <class T>
struct factor_view {
    T *s1, *s2, *sc, *ts, *tc;
    std::size_t size;

    constexpr operator factor_view<const T>() const noexcept requires(!std::is_const_v<T>) {
        return {s1, s2, sc, ts, tc, size};
    }
};

// Builders for the usual layouts.

template <class T>
constexpr quat_view<T> soa(T* x, T* y, T* z, T* w, std::size_t n) noexcept {
    return {x, y, z, w, n, 1};
}

template <class T>
constexpr vec3_view<T> soa(T* x, T* y, T* z, std::size_t n) noexcept {
    return {x, y, z, n, 1};
}

// n quaternions one after the other, x first (glTF, Unity, Unreal, Jolt, PhysX, three.js, Godot).
template <class T>
constexpr quat_view<T> aos_xyzw(T* first, std::size_t n) noexcept {
    if (first == nullptr) return {nullptr, nullptr, nullptr, nullptr, n, 4};
    return {first, first + 1, first + 2, first + 3, n, 4};
}

// n quaternions one after the other, w first (Blender, Eigen's constructor, most papers).
template <class T>
constexpr quat_view<T> aos_wxyz(T* first, std::size_t n) noexcept {
    if (first == nullptr) return {nullptr, nullptr, nullptr, nullptr, n, 4};
    return {first + 1, first + 2, first + 3, first, n, 4};
}

// n vectors one after the other.
template <class T>
constexpr vec3_view<T> aos_xyz(T* first, std::size_t n) noexcept {
    if (first == nullptr) return {nullptr, nullptr, nullptr, n, 3};
    return {first, first + 1, first + 2, n, 3};
}

// n motors one after the other, x y z w dx dy dz dw each.
template <class T>
constexpr motor_view<T> aos_motors(T* p, std::size_t n) noexcept {
    if (p == nullptr) return {nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, n, 8};
    return {p, p + 1, p + 2, p + 3, p + 4, p + 5, p + 6, p + 7, n, 8};
}

// n matrices one after the other, row by row or column by column (glTF, OpenGL, Unity).
template <class T>
constexpr matrix_view<T> aos_rows(T* p, std::size_t n) noexcept {
    if (p == nullptr)
        return {nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, n, 9};
    return {p, p + 1, p + 2, p + 3, p + 4, p + 5, p + 6, p + 7, p + 8, n, 9};
}
template <class T>
constexpr matrix_view<T> aos_columns(T* p, std::size_t n) noexcept {
    if (p == nullptr)
        return {nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, n, 9};
    return {p, p + 3, p + 6, p + 1, p + 4, p + 7, p + 2, p + 5, p + 8, n, 9};
}

// The parameter of an interpolation or a power: one number for all elements, or one for each.
template <class T>
struct parameter {
    constexpr parameter(T t) noexcept : for_all{t} {}
    constexpr parameter(const scalar_view<const T>& t) noexcept : is_per_element{true}, per_element(t) {}
    constexpr parameter(const scalar_view<T>& t) noexcept : is_per_element{true}, per_element(t) {}

    bool is_per_element = false;
    T for_all{};
    scalar_view<const T> per_element{};
};

// The axis of a twist: a coordinate axis, one vector for all elements, or one vector for each element.
// Vectors may have any length that is not zero; only their direction counts. A zero or non-finite vector for
// all elements is a bad_argument. Among vectors per element a zero one gives the twist (0, 0, 0, sgn w) and a
// non-finite one gives NaN, in its element alone.
template <class T>
struct twist_axis {
    enum class form : std::uint8_t { coordinate, uniform, per_element };

    constexpr twist_axis(axis a) noexcept : kind{form::coordinate}, coordinate{a} {}
    constexpr twist_axis(const vec3<T>& v) noexcept : kind{form::uniform}, uniform{v} {}
    constexpr twist_axis(const vec3_view<const T>& v) noexcept : kind{form::per_element}, per_element(v) {}
    constexpr twist_axis(const vec3_view<T>& v) noexcept : kind{form::per_element}, per_element(v) {}

    form kind;
    axis coordinate = axis::z;
    vec3<T> uniform{};
    vec3_view<const T> per_element{};
};

// options::pole_threshold: eps^2 of the element type, 2^-48 for float and 2^-106 for double.
inline constexpr double default_pole_threshold = -1.0;

// Where the twist axis of sterp is given: in the world at the first of the two rotations, or in the body that
// they turn.
enum class frame : std::uint8_t { world, body };

// How sterp moves swing and twist: at constant speed, or as the normalised mean of their ends, which is
// quicker to compute and slower to move at both ends.
enum class flavour : std::uint8_t { slerp, nlerp };

// Each operation looks at those that its header names.
struct options {
    product order = product::swing_twist;
    precision accuracy = precision::fast;

    // Flip the twist where needed so that the sign bit of its w is clear. It then belongs to sgn(w) q, the
    // same rotation, and its angle is in [-pi, pi]; the swing is the same either way.
    bool positive_twist = false;

    // An element is at the pole when w^2 + (a.v)^2 <= pole_threshold |q|^2, in [0, 1]. At the default the
    // replacement is equal to rounding. Larger values suppress the twist of noisy input: a threshold h^2
    // replaces twists whose angle is known only to about 2^-23 / h radians, and moves S T away from q by at
    // most h |q|.
    double pole_threshold = default_pole_threshold;

    // Of an interpolation: by way of the further of b and -b, the turn of more than 180 degrees.
    bool long_way = false;
    frame axis_frame = frame::world;
    flavour motion = flavour::slerp;
};

}  // namespace swivel

#endif
