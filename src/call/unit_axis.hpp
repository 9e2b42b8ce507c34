#ifndef SWIVEL_SRC_CALL_UNIT_AXIS_HPP
#define SWIVEL_SRC_CALL_UNIT_AXIS_HPP

#include <cmath>

#include "swivel/types.hpp"

namespace swivel {

// A vector of length 1 to rounding, and what the rounding left over.
template <class T>
struct unit_axis {
    T x, y, z;
    T excess;  // x^2 + y^2 + z^2 - 1
};

// The unit vector along v, from any length; false where v is zero or not finite. An error of its length goes
// into every norm, so it is right to half a unit in the last place, and the rest is known. swivel::reference
// uses this too: the axis is an argument, not a result.

inline bool make_unit(const vec3<float>& v, unit_axis<float>& unit) noexcept {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
    double x = v.x, y = v.y, z = v.z;
    const double squared = (x * x + y * y) + z * z;
    if (squared == 0) return false;
    const double scale = 1 / std::sqrt(squared);
    unit.x = static_cast<float>(x * scale);
    unit.y = static_cast<float>(y * scale);
    unit.z = static_cast<float>(z * scale);
    x = unit.x;
    y = unit.y;
    z = unit.z;
    unit.excess = static_cast<float>(((x * x - 1) + y * y) + z * z);
    return true;
}

// The upper half of the bits, whose square is exact (Veltkamp).
inline double upper_half(double a) noexcept {
    const double c = 134217729.0 * a;
    return c - (c - a);
}

// x^2 + y^2 + z^2 - 1 of a vector of length near 1, from squares without rounding.
inline double excess_over_unit(double x, double y, double z) noexcept {
    const double xh = upper_half(x), yh = upper_half(y), zh = upper_half(z);
    const double rest = ((x + xh) * (x - xh) + (y + yh) * (y - yh)) + (z + zh) * (z - zh);
    return (((xh * xh - 1) + yh * yh) + zh * zh) + rest;
}

inline bool make_unit(const vec3<double>& v, unit_axis<double>& unit) noexcept {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
    double x = v.x, y = v.y, z = v.z;
    const double largest = std::fmax(std::fmax(std::fabs(x), std::fabs(y)), std::fabs(z));
    if (largest == 0) return false;
    if (largest < 0x1p-400 || largest > 0x1p400) {
        const double scale = largest < 1 ? 0x1p600 : 0x1p-600;
        x *= scale;
        y *= scale;
        z *= scale;
    }
    const double scale = 1 / std::sqrt((x * x + y * y) + z * z);
    x *= scale;
    y *= scale;
    z *= scale;
    const double correction = -0.5 * excess_over_unit(x, y, z);
    unit.x = x + x * correction;
    unit.y = y + y * correction;
    unit.z = z + z * correction;
    unit.excess = excess_over_unit(unit.x, unit.y, unit.z);
    return true;
}

}  // namespace swivel

#endif
