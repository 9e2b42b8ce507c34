#ifndef SWIVEL_SRC_UNIT_AXIS_HPP
#define SWIVEL_SRC_UNIT_AXIS_HPP

#include <cmath>
#include <limits>

#include "swivel/types.hpp"

namespace swivel {

// The unit vector along v, from any length; false where v is zero or not finite. Computed in double, so that
// a unit axis in float is right to half a unit in the last place. swivel::reference uses it too: the axis is
// an argument, not a result.
inline bool unit_axis(const vec3<float>& v, float (&unit)[3]) noexcept {
    const double x = v.x, y = v.y, z = v.z;
    const double squared = (x * x + y * y) + z * z;
    // NaN fails both comparisons.
    if (!(squared > 0) || !(squared <= std::numeric_limits<double>::max())) return false;
    const double scale = 1 / std::sqrt(squared);
    unit[0] = static_cast<float>(x * scale);
    unit[1] = static_cast<float>(y * scale);
    unit[2] = static_cast<float>(z * scale);
    return true;
}

inline bool unit_axis(const vec3<double>& v, double (&unit)[3]) noexcept {
    double x = v.x, y = v.y, z = v.z;
    const double largest = std::fmax(std::fmax(std::fabs(x), std::fabs(y)), std::fabs(z));
    if (!(largest > 0) ||
        !(std::fabs(x) + std::fabs(y) + std::fabs(z) < std::numeric_limits<double>::infinity())) {
        // The sum may have overflowed for a finite vector.
        if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z)) || largest == 0) return false;
    }
    if (largest < 0x1p-400 || largest > 0x1p400) {
        const double scale = largest < 1 ? 0x1p600 : 0x1p-600;
        x *= scale;
        y *= scale;
        z *= scale;
    }
    const double length = std::sqrt((x * x + y * y) + z * z);
    unit[0] = x / length;
    unit[1] = y / length;
    unit[2] = z / length;
    return true;
}

}  // namespace swivel

#endif
