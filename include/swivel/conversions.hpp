#ifndef SWIVEL_CONVERSIONS_HPP
#define SWIVEL_CONVERSIONS_HPP

// Rotations in other forms, from and to quaternions.

#include "swivel/axis_angle.hpp"
#include "swivel/euler.hpp"
#include "swivel/matrix.hpp"
#include "swivel/spinor.hpp"

#endif
