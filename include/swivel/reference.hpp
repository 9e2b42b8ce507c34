#ifndef SWIVEL_REFERENCE_HPP
#define SWIVEL_REFERENCE_HPP

#include <span>

#include "swivel/types.hpp"

// reference: the same calls, one element after the other, in plain scalar code written from the formulas
//
// Checks, status and results are those of the operation of the same name; options::accuracy is not looked at:
// the arithmetic is that of precision::reproducible, equal to the kernels of every ISA in every bit. (Which
// NaN a NaN is may differ.) It is not dispatched, needs no particular instructions, and is slow. Its use is
// to check the kernels, and to read.

namespace swivel::reference {

status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, options = {}) noexcept;
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist, options = {}) noexcept;
status decompose(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const scalar_view<float>& signs, options) noexcept;
status decompose(const quat_view<const double>& q, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const scalar_view<double>& signs, options) noexcept;

status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out,
                 options = {}) noexcept;
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 options = {}) noexcept;
status decompose(const quat_view<const float>& q, axis a, const factor_view<float>& out,
                 const scalar_view<float>& signs, options) noexcept;
status decompose(const quat_view<const double>& q, axis a, const factor_view<double>& out,
                 const scalar_view<double>& signs, options) noexcept;

status twist(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& out,
             options = {}) noexcept;
status twist(const quat_view<const double>& q, const twist_axis<double>& a, const quat_view<double>& out,
             options = {}) noexcept;

status swing(const quat_view<const float>& q, const twist_axis<float>& a, const quat_view<float>& out,
             options = {}) noexcept;
status swing(const quat_view<const double>& q, const twist_axis<double>& a, const quat_view<double>& out,
             options = {}) noexcept;

status twist_angle(const quat_view<const float>& q, const twist_axis<float>& a,
                   const scalar_view<float>& radians, options = {}) noexcept;
status twist_angle(const quat_view<const double>& q, const twist_axis<double>& a,
                   const scalar_view<double>& radians, options = {}) noexcept;

status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const quat_view<float>& q, options = {}) noexcept;
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const quat_view<double>& q, options = {}) noexcept;
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const scalar_view<const float>& signs, const quat_view<float>& q, options = {}) noexcept;
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const scalar_view<const double>& signs, const quat_view<double>& q, options = {}) noexcept;

status compose(const factor_view<const float>& factors, axis a, const quat_view<float>& q,
               options = {}) noexcept;
status compose(const factor_view<const double>& factors, axis a, const quat_view<double>& q,
               options = {}) noexcept;
status compose(const factor_view<const float>& factors, axis a, const scalar_view<const float>& signs,
               const quat_view<float>& q, options = {}) noexcept;
status compose(const factor_view<const double>& factors, axis a, const scalar_view<const double>& signs,
               const quat_view<double>& q, options = {}) noexcept;

status sincos(const scalar_view<const float>& radians, const scalar_view<float>& sine,
              const scalar_view<float>& cosine, options = {}) noexcept;
status sincos(const scalar_view<const double>& radians, const scalar_view<double>& sine,
              const scalar_view<double>& cosine, options = {}) noexcept;
status atan2(const scalar_view<const float>& y, const scalar_view<const float>& x,
             const scalar_view<float>& radians, options = {}) noexcept;
status atan2(const scalar_view<const double>& y, const scalar_view<const double>& x,
             const scalar_view<double>& radians, options = {}) noexcept;

status slerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options = {}) noexcept;
status slerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options = {}) noexcept;
status nlerp(const quat_view<const float>& a, const quat_view<const float>& b, const parameter<float>& t,
             const quat_view<float>& out, options = {}) noexcept;
status nlerp(const quat_view<const double>& a, const quat_view<const double>& b, const parameter<double>& t,
             const quat_view<double>& out, options = {}) noexcept;
status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& t, const quat_view<float>& out, options = {}) noexcept;
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& t, const quat_view<double>& out,
             options = {}) noexcept;
status sterp(const quat_view<const float>& a, const quat_view<const float>& b, const twist_axis<float>& axis,
             const parameter<float>& swing, const parameter<float>& twist, const quat_view<float>& out,
             options = {}) noexcept;
status sterp(const quat_view<const double>& a, const quat_view<const double>& b,
             const twist_axis<double>& axis, const parameter<double>& swing, const parameter<double>& twist,
             const quat_view<double>& out, options = {}) noexcept;

status multiply(const quat_view<const float>& a, const quat_view<const float>& b, const quat_view<float>& out,
                options = {}) noexcept;
status multiply(const quat_view<const double>& a, const quat_view<const double>& b,
                const quat_view<double>& out, options = {}) noexcept;
status conjugate(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status conjugate(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;
status normalize(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status normalize(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;
status rotate(const quat_view<const float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options = {}) noexcept;
status rotate(const quat_view<const double>& q, const vec3_view<const double>& v,
              const vec3_view<double>& out, options = {}) noexcept;
status rotate(const quat<float>& q, const vec3_view<const float>& v, const vec3_view<float>& out,
              options = {}) noexcept;
status rotate(const quat<double>& q, const vec3_view<const double>& v, const vec3_view<double>& out,
              options = {}) noexcept;
status angle_between(const quat_view<const float>& a, const quat_view<const float>& b,
                     const scalar_view<float>& radians, options = {}) noexcept;
status angle_between(const quat_view<const double>& a, const quat_view<const double>& b,
                     const scalar_view<double>& radians, options = {}) noexcept;
status dot(const quat_view<const float>& a, const quat_view<const float>& b, const scalar_view<float>& out,
           options = {}) noexcept;
status dot(const quat_view<const double>& a, const quat_view<const double>& b, const scalar_view<double>& out,
           options = {}) noexcept;
status align_signs(const quat_view<const float>& q, const quat_view<const float>& neighbour,
                   const quat_view<float>& out, options = {}) noexcept;
status align_signs(const quat_view<const double>& q, const quat_view<const double>& neighbour,
                   const quat_view<double>& out, options = {}) noexcept;
status align_signs(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status align_signs(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;

status square_root(const quat_view<const float>& q, const quat_view<float>& out, options = {}) noexcept;
status square_root(const quat_view<const double>& q, const quat_view<double>& out, options = {}) noexcept;
status exp(const vec3_view<const float>& b, const quat_view<float>& out, options = {}) noexcept;
status exp(const vec3_view<const double>& b, const quat_view<double>& out, options = {}) noexcept;
status log(const quat_view<const float>& q, const vec3_view<float>& out, options = {}) noexcept;
status log(const quat_view<const double>& q, const vec3_view<double>& out, options = {}) noexcept;
status power(const quat_view<const float>& q, const parameter<float>& t, const quat_view<float>& out,
             options = {}) noexcept;
status power(const quat_view<const double>& q, const parameter<double>& t, const quat_view<double>& out,
             options = {}) noexcept;

status shortest_arc(const vec3_view<const float>& v, const vec3_view<const float>& w,
                    const quat_view<float>& out, options = {}) noexcept;
status shortest_arc(const vec3_view<const double>& v, const vec3_view<const double>& w,
                    const quat_view<double>& out, options = {}) noexcept;
status arc_with_twist(const vec3_view<const float>& v, const vec3_view<const float>& w,
                      const parameter<float>& radians, const quat_view<float>& out, options = {}) noexcept;
status arc_with_twist(const vec3_view<const double>& v, const vec3_view<const double>& w,
                      const parameter<double>& radians, const quat_view<double>& out, options = {}) noexcept;

status from_axis_angle(const twist_axis<float>& a, const scalar_view<const float>& radians,
                       const quat_view<float>& q, options = {}) noexcept;
status from_axis_angle(const twist_axis<double>& a, const scalar_view<const double>& radians,
                       const quat_view<double>& q, options = {}) noexcept;
status to_axis_angle(const quat_view<const float>& q, const vec3_view<float>& a,
                     const scalar_view<float>& radians, options = {}) noexcept;
status to_axis_angle(const quat_view<const double>& q, const vec3_view<double>& a,
                     const scalar_view<double>& radians, options = {}) noexcept;

status from_spinor(const spinor_view<const float>& s, const quat_view<float>& q, options = {}) noexcept;
status from_spinor(const spinor_view<const double>& s, const quat_view<double>& q, options = {}) noexcept;
status to_spinor(const quat_view<const float>& q, const spinor_view<float>& s, options = {}) noexcept;
status to_spinor(const quat_view<const double>& q, const spinor_view<double>& s, options = {}) noexcept;

status from_matrix(const matrix_view<const float>& m, const quat_view<float>& q, options = {}) noexcept;
status from_matrix(const matrix_view<const double>& m, const quat_view<double>& q, options = {}) noexcept;
status to_matrix(const quat_view<const float>& q, const matrix_view<float>& m, options = {}) noexcept;
status to_matrix(const quat_view<const double>& q, const matrix_view<double>& m, options = {}) noexcept;

status from_euler(const vec3_view<const float>& radians, euler_order order, const quat_view<float>& q,
                  options = {}) noexcept;
status from_euler(const vec3_view<const double>& radians, euler_order order, const quat_view<double>& q,
                  options = {}) noexcept;
status to_euler(const quat_view<const float>& q, euler_order order, const vec3_view<float>& radians,
                options = {}) noexcept;
status to_euler(const quat_view<const double>& q, euler_order order, const vec3_view<double>& radians,
                options = {}) noexcept;

// Motors.
status multiply(const motor_view<const float>& a, const motor_view<const float>& b,
                const motor_view<float>& out, options = {}) noexcept;
status multiply(const motor_view<const double>& a, const motor_view<const double>& b,
                const motor_view<double>& out, options = {}) noexcept;
status conjugate(const motor_view<const float>& m, const motor_view<float>& out, options = {}) noexcept;
status conjugate(const motor_view<const double>& m, const motor_view<double>& out, options = {}) noexcept;
status normalize(const motor_view<const float>& m, const motor_view<float>& out, options = {}) noexcept;
status normalize(const motor_view<const double>& m, const motor_view<double>& out, options = {}) noexcept;
status from_rotation_translation(const quat_view<const float>& q, const vec3_view<const float>& t,
                                 const motor_view<float>& out, options = {}) noexcept;
status from_rotation_translation(const quat_view<const double>& q, const vec3_view<const double>& t,
                                 const motor_view<double>& out, options = {}) noexcept;
status to_rotation_translation(const motor_view<const float>& m, const quat_view<float>& q,
                               const vec3_view<float>& t, options = {}) noexcept;
status to_rotation_translation(const motor_view<const double>& m, const quat_view<double>& q,
                               const vec3_view<double>& t, options = {}) noexcept;
status transform(const motor_view<const float>& m, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options = {}) noexcept;
status transform(const motor_view<const double>& m, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options = {}) noexcept;
status square_root(const motor_view<const float>& m, const motor_view<float>& out, options = {}) noexcept;
status square_root(const motor_view<const double>& m, const motor_view<double>& out, options = {}) noexcept;
status log(const motor_view<const float>& m, const vec3_view<float>& b, const vec3_view<float>& n,
           options = {}) noexcept;
status log(const motor_view<const double>& m, const vec3_view<double>& b, const vec3_view<double>& n,
           options = {}) noexcept;
status exp(const vec3_view<const float>& b, const vec3_view<const float>& n, const motor_view<float>& out,
           options = {}) noexcept;
status exp(const vec3_view<const double>& b, const vec3_view<const double>& n, const motor_view<double>& out,
           options = {}) noexcept;
status power(const motor_view<const float>& m, const parameter<float>& t, const motor_view<float>& out,
             options = {}) noexcept;
status power(const motor_view<const double>& m, const parameter<double>& t, const motor_view<double>& out,
             options = {}) noexcept;
status sclerp(const motor_view<const float>& a, const motor_view<const float>& b, const parameter<float>& t,
              const motor_view<float>& out, options = {}) noexcept;
status sclerp(const motor_view<const double>& a, const motor_view<const double>& b,
              const parameter<double>& t, const motor_view<double>& out, options = {}) noexcept;
status blend(std::span<const motor_view<const float>> motors, std::span<const parameter<float>> weights,
             const motor_view<float>& out, options = {}) noexcept;
status blend(std::span<const motor_view<const double>> motors, std::span<const parameter<double>> weights,
             const motor_view<double>& out, options = {}) noexcept;
status decompose(const motor_view<const float>& m, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const vec3_view<float>& translation, options = {}) noexcept;
status decompose(const motor_view<const double>& m, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const vec3_view<double>& translation, options = {}) noexcept;
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const vec3_view<const float>& translation, const motor_view<float>& out,
               options = {}) noexcept;
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const vec3_view<const double>& translation, const motor_view<double>& out,
               options = {}) noexcept;

// Conformal rotors.
status multiply(const conformal_view<const float>& a, const conformal_view<const float>& b,
                const conformal_view<float>& out, options = {}) noexcept;
status multiply(const conformal_view<const double>& a, const conformal_view<const double>& b,
                const conformal_view<double>& out, options = {}) noexcept;
status reverse(const conformal_view<const float>& c, const conformal_view<float>& out, options = {}) noexcept;
status reverse(const conformal_view<const double>& c, const conformal_view<double>& out,
               options = {}) noexcept;
status from_motor(const motor_view<const float>& m, const conformal_view<float>& out, options = {}) noexcept;
status from_motor(const motor_view<const double>& m, const conformal_view<double>& out,
                  options = {}) noexcept;
status from_rotation(const quat_view<const float>& q, const conformal_view<float>& out,
                     options = {}) noexcept;
status from_rotation(const quat_view<const double>& q, const conformal_view<double>& out,
                     options = {}) noexcept;
status from_translation(const vec3_view<const float>& t, const conformal_view<float>& out,
                        options = {}) noexcept;
status from_translation(const vec3_view<const double>& t, const conformal_view<double>& out,
                        options = {}) noexcept;
status from_dilation(const scalar_view<const float>& factor, const conformal_view<float>& out,
                     options = {}) noexcept;
status from_dilation(const scalar_view<const double>& factor, const conformal_view<double>& out,
                     options = {}) noexcept;
status transform(const conformal_view<const float>& r, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options = {}) noexcept;
status transform(const conformal_view<const double>& r, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options = {}) noexcept;
status square_root(const conformal_view<const float>& r, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options = {}) noexcept;
status square_root(const conformal_view<const double>& r, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options = {}) noexcept;
status exp(const bivector_view<const float>& b, const conformal_view<float>& out, options = {}) noexcept;
status exp(const bivector_view<const double>& b, const conformal_view<double>& out, options = {}) noexcept;
status log(const conformal_view<const float>& r, const bivector_view<float>& out,
           const scalar_view<float>& unique, options = {}) noexcept;
status log(const conformal_view<const double>& r, const bivector_view<double>& out,
           const scalar_view<double>& unique, options = {}) noexcept;
status power(const conformal_view<const float>& r, const parameter<float>& t,
             const conformal_view<float>& out, const scalar_view<float>& unique, options = {}) noexcept;
status power(const conformal_view<const double>& r, const parameter<double>& t,
             const conformal_view<double>& out, const scalar_view<double>& unique, options = {}) noexcept;
status interpolate(const conformal_view<const float>& a, const conformal_view<const float>& b,
                   const parameter<float>& t, const conformal_view<float>& out,
                   const scalar_view<float>& unique, options = {}) noexcept;
status interpolate(const conformal_view<const double>& a, const conformal_view<const double>& b,
                   const parameter<double>& t, const conformal_view<double>& out,
                   const scalar_view<double>& unique, options = {}) noexcept;
status split(const bivector_view<const float>& b, const bivector_view<float>& first,
             const bivector_view<float>& second, const scalar_view<float>& unique, options = {}) noexcept;
status split(const bivector_view<const double>& b, const bivector_view<double>& first,
             const bivector_view<double>& second, const scalar_view<double>& unique, options = {}) noexcept;

}  // namespace swivel::reference

#endif
