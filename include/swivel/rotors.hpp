#ifndef SWIVEL_ROTORS_HPP
#define SWIVEL_ROTORS_HPP

// The algebra of rotations.

#include "swivel/align_signs.hpp"
#include "swivel/angle_between.hpp"
#include "swivel/conjugate.hpp"
#include "swivel/dot.hpp"
#include "swivel/multiply.hpp"
#include "swivel/normalize.hpp"
#include "swivel/rotate.hpp"

#endif
