#ifndef SWIVEL_BENCH_PEERS_PEERS_HPP
#define SWIVEL_BENCH_PEERS_PEERS_HPP

// What the library is compared with. Each peer has a file of its own, built with -O3 -march=native; each
// function does n elements. Axes are unit vectors. Defined for float and double.

#include <cstddef>

#include "swivel/types.hpp"

namespace swivel_bench {

// Loops over arrays of the quaternion types of two libraries, twist by projection and swing by product. Both
// store x y z w, as swivel::quat does.
namespace eigen {
template <class T>
void decompose(const T* q, swivel::vec3<T> a, T* swing, T* twist, std::size_t n) noexcept;
template <class T>
void twist(const T* q, swivel::vec3<T> a, T* out, std::size_t n) noexcept;
template <class T>
void swing(const T* q, swivel::vec3<T> a, T* out, std::size_t n) noexcept;
template <class T>
void twist_angle(const T* q, swivel::vec3<T> a, T* radians, std::size_t n) noexcept;
template <class T>
void angle_between(const T* a, const T* b, T* radians, std::size_t n) noexcept;
template <class T>
void compose(const T* swing, const T* twist, T* q, std::size_t n) noexcept;
template <class T>
void normalize(const T* q, T* out, std::size_t n) noexcept;
template <class T>
void rotate(const T* q, const T* v, T* out, std::size_t n) noexcept;
template <class T>
void rotate_by_one(swivel::quat<T> q, const T* v, T* out, std::size_t n) noexcept;
// Between two rotations, a parameter for each: slerp and normalised lerp of the library, the short way; sterp
// by the factors' angles with std::atan2, std::sin and std::cos.
template <class T>
void slerp(const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept;
template <class T>
void nlerp(const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept;
template <class T>
void sterp(const T* a, const T* b, swivel::vec3<T> axis, const T* t, T* out, std::size_t n) noexcept;
template <class T>
void square_root(const T* q, T* out, std::size_t n) noexcept;
template <class T>
void exp(const T* b, T* out, std::size_t n) noexcept;
template <class T>
void log(const T* q, T* out, std::size_t n) noexcept;
template <class T>
void power(const T* q, T t, T* out, std::size_t n) noexcept;
template <class T>
void shortest_arc(const T* v, const T* w, T* out, std::size_t n) noexcept;
template <class T>
void arc_with_twist(const T* v, const T* w, T radians, T* out, std::size_t n) noexcept;
// Conversions by the library's own functions: matrices as it stores them, Euler angles in one order.
template <class T>
void from_matrix(const T* m, T* q, std::size_t n) noexcept;
template <class T>
void to_matrix(const T* q, T* m, std::size_t n) noexcept;
template <class T>
void from_euler(const T* radians, T* q, std::size_t n) noexcept;
template <class T>
void to_euler(const T* q, T* radians, std::size_t n) noexcept;
template <class T>
void from_axis_angle(swivel::vec3<T> a, const T* radians, T* q, std::size_t n) noexcept;
// Dual quaternions of its quaternions, x y z w dx dy dz dw one after the other: ScLERP by the parameters of
// the screw, after Kavan; the blend of four, with weights in four streams.
template <class T>
void sclerp(const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept;
template <class T>
void transform(const T* m, const T* p, T* out, std::size_t n) noexcept;
template <class T>
void motor_multiply(const T* a, const T* b, T* out, std::size_t n) noexcept;
template <class T>
void blend_4(const T* const (&motors)[4], const T* const (&weights)[4], T* out, std::size_t n) noexcept;
}  // namespace eigen

namespace glm_peer {
template <class T>
void decompose(const T* q, swivel::vec3<T> a, T* swing, T* twist, std::size_t n) noexcept;
template <class T>
void twist(const T* q, swivel::vec3<T> a, T* out, std::size_t n) noexcept;
template <class T>
void swing(const T* q, swivel::vec3<T> a, T* out, std::size_t n) noexcept;
template <class T>
void twist_angle(const T* q, swivel::vec3<T> a, T* radians, std::size_t n) noexcept;
template <class T>
void compose(const T* swing, const T* twist, T* q, std::size_t n) noexcept;
template <class T>
void normalize(const T* q, T* out, std::size_t n) noexcept;
template <class T>
void rotate(const T* q, const T* v, T* out, std::size_t n) noexcept;
template <class T>
void rotate_by_one(swivel::quat<T> q, const T* v, T* out, std::size_t n) noexcept;
template <class T>
void slerp(const T* a, const T* b, const T* t, T* out, std::size_t n) noexcept;
template <class T>
void square_root(const T* q, T* out, std::size_t n) noexcept;
template <class T>
void exp(const T* b, T* out, std::size_t n) noexcept;
template <class T>
void log(const T* q, T* out, std::size_t n) noexcept;
template <class T>
void power(const T* q, T t, T* out, std::size_t n) noexcept;
template <class T>
void shortest_arc(const T* v, const T* w, T* out, std::size_t n) noexcept;
template <class T>
void arc_with_twist(const T* v, const T* w, T radians, T* out, std::size_t n) noexcept;
// As above.
template <class T>
void from_matrix(const T* m, T* q, std::size_t n) noexcept;
template <class T>
void to_matrix(const T* q, T* m, std::size_t n) noexcept;
template <class T>
void from_euler(const T* radians, T* q, std::size_t n) noexcept;
template <class T>
void to_euler(const T* q, T* radians, std::size_t n) noexcept;
template <class T>
void from_axis_angle(swivel::vec3<T> a, const T* radians, T* q, std::size_t n) noexcept;
}  // namespace glm_peer

// The compact form about z after Reynolds' article: one record of five numbers for each quaternion, with his
// threshold on w^2 + z^2.
namespace reynolds {
template <class T>
void decompose_compact(const swivel::quat<T>* q, swivel::factors<T>* out, std::size_t n) noexcept;
}

// Both factors about x in the way of PhysX' joints: the twist is the normalised pair (x, w) unless x is 0,
// the swing a full product.
namespace physx {
template <class T>
void decompose_x(const swivel::quat<T>* q, swivel::quat<T>* swing, swivel::quat<T>* twist,
                 std::size_t n) noexcept;
}

// The floor: reads `inputs` streams and writes `outputs`, each of n elements, in one pass or by memcpy. More
// inputs than outputs are added up.
template <class T, int inputs, int outputs>
void copy(const T* const (&in)[inputs], T* const (&out)[outputs], std::size_t n) noexcept;
template <class T, int inputs, int outputs>
void copy_by_memcpy(const T* const (&in)[inputs], T* const (&out)[outputs], std::size_t n) noexcept;

// What a caller would write without the library: loops over streams, left to the compiler to vectorise with
// -ffast-math. No pole, no NaN.
struct preferred_width;  // the vector width that the compiler prefers for the processor
struct widest;

template <class T, class Width>
struct plain {
    static void decompose(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                          const T* __restrict w, T ax, T ay, T az, T* __restrict sx, T* __restrict sy,
                          T* __restrict sz, T* __restrict sw, T* __restrict tx, T* __restrict ty,
                          T* __restrict tz, T* __restrict tw, std::size_t n) noexcept;
    static void decompose_z(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                            const T* __restrict w, T* __restrict sx, T* __restrict sy, T* __restrict sz,
                            T* __restrict sw, T* __restrict tx, T* __restrict ty, T* __restrict tz,
                            T* __restrict tw, std::size_t n) noexcept;
    static void decompose_compact(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                                  const T* __restrict w, T* __restrict s1, T* __restrict s2, T* __restrict sc,
                                  T* __restrict ts, T* __restrict tc, std::size_t n) noexcept;
    static void twist(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                      const T* __restrict w, T ax, T ay, T az, T* __restrict tx, T* __restrict ty,
                      T* __restrict tz, T* __restrict tw, std::size_t n) noexcept;
    static void swing(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                      const T* __restrict w, T ax, T ay, T az, T* __restrict sx, T* __restrict sy,
                      T* __restrict sz, T* __restrict sw, std::size_t n) noexcept;
    static void twist_angle(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                            const T* __restrict w, T ax, T ay, T az, T* __restrict radians,
                            std::size_t n) noexcept;
    static void compose(const T* __restrict sx, const T* __restrict sy, const T* __restrict sz,
                        const T* __restrict sw, const T* __restrict tx, const T* __restrict ty,
                        const T* __restrict tz, const T* __restrict tw, T* __restrict x, T* __restrict y,
                        T* __restrict z, T* __restrict w, std::size_t n) noexcept;
    static void compose_compact(const T* __restrict s1, const T* __restrict s2, const T* __restrict sc,
                                const T* __restrict ts, const T* __restrict tc, T* __restrict x,
                                T* __restrict y, T* __restrict z, T* __restrict w, std::size_t n) noexcept;
    static void normalize(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                          const T* __restrict w, T* __restrict ox, T* __restrict oy, T* __restrict oz,
                          T* __restrict ow, std::size_t n) noexcept;
    static void rotate(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                       const T* __restrict w, const T* __restrict vx, const T* __restrict vy,
                       const T* __restrict vz, T* __restrict ox, T* __restrict oy, T* __restrict oz,
                       std::size_t n) noexcept;
    // Along a sequence.
    static void align_signs(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                            const T* __restrict w, T* __restrict ox, T* __restrict oy, T* __restrict oz,
                            T* __restrict ow, std::size_t n) noexcept;
};

}  // namespace swivel_bench

#endif
