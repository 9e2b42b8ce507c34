#ifndef SWIVEL_REFERENCE_HPP
#define SWIVEL_REFERENCE_HPP

#include "swivel/types.hpp"

// reference: the same calls, one element after the other, in plain scalar code written from the formulas
//
// Checks, status and results are those of the operation of the same name; options::accuracy is not looked at:
// the arithmetic is that of precision::reproducible, equal to the kernels of every ISA in every bit. (Which
// NaN a NaN is may differ.) It is not dispatched, needs no particular instructions, and is slow. Its use is
// to check the kernels, and to read.

namespace swivel::reference {

status decompose(quat_view<const float> q, twist_axis<float> a, quat_view<float> swing,
                 quat_view<float> twist, options = {}) noexcept;
status decompose(quat_view<const double> q, twist_axis<double> a, quat_view<double> swing,
                 quat_view<double> twist, options = {}) noexcept;
status decompose(quat_view<const float> q, twist_axis<float> a, quat_view<float> swing,
                 quat_view<float> twist, scalar_view<float> signs, options) noexcept;
status decompose(quat_view<const double> q, twist_axis<double> a, quat_view<double> swing,
                 quat_view<double> twist, scalar_view<double> signs, options) noexcept;

status decompose(quat_view<const float> q, axis a, factor_view<float> out, options = {}) noexcept;
status decompose(quat_view<const double> q, axis a, factor_view<double> out, options = {}) noexcept;
status decompose(quat_view<const float> q, axis a, factor_view<float> out, scalar_view<float> signs,
                 options) noexcept;
status decompose(quat_view<const double> q, axis a, factor_view<double> out, scalar_view<double> signs,
                 options) noexcept;

status twist(quat_view<const float> q, twist_axis<float> a, quat_view<float> out, options = {}) noexcept;
status twist(quat_view<const double> q, twist_axis<double> a, quat_view<double> out, options = {}) noexcept;

status swing(quat_view<const float> q, twist_axis<float> a, quat_view<float> out, options = {}) noexcept;
status swing(quat_view<const double> q, twist_axis<double> a, quat_view<double> out, options = {}) noexcept;

status twist_angle(quat_view<const float> q, twist_axis<float> a, scalar_view<float> radians,
                   options = {}) noexcept;
status twist_angle(quat_view<const double> q, twist_axis<double> a, scalar_view<double> radians,
                   options = {}) noexcept;

status compose(quat_view<const float> swing, quat_view<const float> twist, quat_view<float> q,
               options = {}) noexcept;
status compose(quat_view<const double> swing, quat_view<const double> twist, quat_view<double> q,
               options = {}) noexcept;
status compose(quat_view<const float> swing, quat_view<const float> twist, scalar_view<const float> signs,
               quat_view<float> q, options = {}) noexcept;
status compose(quat_view<const double> swing, quat_view<const double> twist, scalar_view<const double> signs,
               quat_view<double> q, options = {}) noexcept;

status compose(factor_view<const float> factors, axis a, quat_view<float> q, options = {}) noexcept;
status compose(factor_view<const double> factors, axis a, quat_view<double> q, options = {}) noexcept;
status compose(factor_view<const float> factors, axis a, scalar_view<const float> signs, quat_view<float> q,
               options = {}) noexcept;
status compose(factor_view<const double> factors, axis a, scalar_view<const double> signs,
               quat_view<double> q, options = {}) noexcept;

}  // namespace swivel::reference

#endif
