#ifndef SWIVEL_SWING_TWIST_HPP
#define SWIVEL_SWING_TWIST_HPP

// Rotations to swing and twist, and back.

#include "swivel/compose.hpp"
#include "swivel/decompose.hpp"
#include "swivel/swing.hpp"
#include "swivel/twist.hpp"
#include "swivel/twist_angle.hpp"

#endif
