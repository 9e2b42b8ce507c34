#ifndef SWIVEL_KERNELS_KERNEL_TABLE_HPP
#define SWIVEL_KERNELS_KERNEL_TABLE_HPP

// The interface between src/ (baseline flags) and the kernels of one ISA: plain data and function pointers,
// no inline function that could be emitted with the wrong instructions.

#include <cstddef>

namespace swivel {

// A view that lies in memory as an array of quaternions, and the place of each component among the four
// streams that the kernel takes. first is null where the view is not one.
template <class T>
struct quaternion_array {
    T* first;
    int place[4];
};

// One call of a kernel: contiguous streams of equal size, and a few numbers that are the same for all
// elements. Which stream is which, and which numbers, is said where the kernel is defined. The streams of
// leading quaternions may be in arrays instead.
inline constexpr int most_inputs = 33, most_outputs = 21, most_groups = 5, most_in_group = 16;

template <class T>
struct batch {
    const T* in[most_inputs];
    T* out[most_outputs];
    T uniform[6];
    std::size_t size;
    bool has_arrays = false;
    quaternion_array<const T> in_array[most_groups];
    quaternion_array<T> out_array[most_groups];
};

template <class T>
using kernel = void (*)(const batch<T>&) noexcept;

enum precision_index { fast_index, reproducible_index, precisions };
enum axis_form_index { coordinate_index, uniform_index, per_element_index, axis_forms };

// What happens to the sign of the twist: left, made positive, made positive and the flips kept in a stream.
enum twist_sign { sign_left, sign_positive, sign_kept, twist_signs };

template <class T>
struct operations {
    kernel<T> decompose[axis_forms][twist_signs][precisions];
    kernel<T> decompose_compact[twist_signs][precisions];
    kernel<T> twist[axis_forms][2][precisions];  // sign_left, sign_positive
    kernel<T> swing[axis_forms][precisions];
    kernel<T> twist_angle[axis_forms][2][precisions];
    kernel<T> compose[2][precisions];  // without, with signs; without is multiply too
    kernel<T> compose_compact[2][precisions];
    kernel<T> slerp[2][precisions];  // the short, the long way
    kernel<T> nlerp[2][precisions];
    kernel<T> sterp[2][2][2][precisions];  // axis for each element, chord, body
    kernel<T> sincos[precisions];
    kernel<T> atan2[precisions];
    kernel<T> conjugate;
    kernel<T> normalize[precisions];
    kernel<T> rotate[2][precisions];  // a rotation for each element, one for all
    kernel<T> dot[precisions];
    kernel<T> align_signs[precisions];
    kernel<T> square_root[precisions];
    kernel<T> exp[precisions];
    kernel<T> log[precisions];
    kernel<T> power[precisions];
    kernel<T> shortest_arc[precisions];
    kernel<T> arc_with_twist[2][precisions];  // the twist after, before the arc
    kernel<T> from_axis_angle[axis_forms][precisions];
    kernel<T> to_axis_angle[precisions];
    kernel<T> from_euler[precisions];
    kernel<T> to_euler[precisions];
    kernel<T> from_matrix[precisions];
    kernel<T> to_matrix[precisions];
    kernel<T> motor_multiply[precisions];
    kernel<T> motor_conjugate;
    kernel<T> motor_normalize[precisions];
    kernel<T> from_rotation_translation[precisions];
    kernel<T> to_rotation_translation[precisions];
    kernel<T> motor_transform[precisions];
    kernel<T> motor_square_root[precisions];
    kernel<T> motor_log[precisions];
    kernel<T> motor_exp[precisions];
    kernel<T> motor_power[precisions];
    kernel<T> sclerp[2][precisions];  // the short, the long way
    kernel<T> motor_blend[precisions];
    kernel<T> motor_decompose[axis_forms][2][precisions];  // sign_left, sign_positive
    kernel<T> motor_compose[precisions];
    kernel<T> conformal_multiply[precisions];
    kernel<T> conformal_reverse;
    kernel<T> conformal_from_motor, conformal_from_rotation, conformal_from_translation,
        conformal_from_dilation;
    kernel<T> conformal_transform[precisions];
    kernel<T> conformal_square_root[precisions];
    kernel<T> conformal_exp[precisions];
    kernel<T> conformal_log[precisions];
    kernel<T> conformal_power[precisions];
    kernel<T> conformal_interpolate[precisions];
    kernel<T> conformal_split[precisions];
};

struct kernel_table {
    operations<float> f32;
    operations<double> f64;
};

// One table for each ISA that the build contains; defined in isa/<isa>.cpp, listed in src/isa.cpp.
extern const kernel_table sse2_kernels;
extern const kernel_table sse4_kernels;
extern const kernel_table avx2_kernels;
extern const kernel_table avx512_kernels;
extern const kernel_table neon64_kernels;

}  // namespace swivel

#endif
