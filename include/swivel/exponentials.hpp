#ifndef SWIVEL_EXPONENTIALS_HPP
#define SWIVEL_EXPONENTIALS_HPP

// Roots, powers, exponentials and logarithms of rotations.

#include "swivel/exp.hpp"
#include "swivel/log.hpp"
#include "swivel/power.hpp"
#include "swivel/square_root.hpp"

#endif
