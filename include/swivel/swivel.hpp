#ifndef SWIVEL_SWIVEL_HPP
#define SWIVEL_SWIVEL_HPP

// Everything, by family. Conventions and the contract that all operations share are in types.hpp.

#include "swivel/angles.hpp"
#include "swivel/arcs.hpp"
#include "swivel/conformal.hpp"
#include "swivel/conversions.hpp"
#include "swivel/exponentials.hpp"
#include "swivel/interpolation.hpp"
#include "swivel/isa.hpp"
#include "swivel/motor.hpp"
#include "swivel/reference.hpp"
#include "swivel/rotors.hpp"
#include "swivel/swing_twist.hpp"
#include "swivel/types.hpp"
#include "swivel/version.hpp"
#include "swivel/versors.hpp"

#endif
