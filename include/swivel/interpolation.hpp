#ifndef SWIVEL_INTERPOLATION_HPP
#define SWIVEL_INTERPOLATION_HPP

// Rotations between two others.

#include "swivel/nlerp.hpp"
#include "swivel/slerp.hpp"
#include "swivel/sterp.hpp"

#endif
