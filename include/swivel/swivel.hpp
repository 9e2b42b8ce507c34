#ifndef SWIVEL_SWIVEL_HPP
#define SWIVEL_SWIVEL_HPP

// Everything. Conventions and the contract that all operations share are in types.hpp.

#include "swivel/align_signs.hpp"
#include "swivel/arc_with_twist.hpp"
#include "swivel/atan2.hpp"
#include "swivel/axis_angle.hpp"
#include "swivel/compose.hpp"
#include "swivel/conformal.hpp"
#include "swivel/conjugate.hpp"
#include "swivel/decompose.hpp"
#include "swivel/dot.hpp"
#include "swivel/euler.hpp"
#include "swivel/exp.hpp"
#include "swivel/isa.hpp"
#include "swivel/log.hpp"
#include "swivel/matrix.hpp"
#include "swivel/multiply.hpp"
#include "swivel/nlerp.hpp"
#include "swivel/normalize.hpp"
#include "swivel/power.hpp"
#include "swivel/reference.hpp"
#include "swivel/rotate.hpp"
#include "swivel/shortest_arc.hpp"
#include "swivel/sincos.hpp"
#include "swivel/slerp.hpp"
#include "swivel/spinor.hpp"
#include "swivel/square_root.hpp"
#include "swivel/sterp.hpp"
#include "swivel/swing.hpp"
#include "swivel/twist.hpp"
#include "swivel/twist_angle.hpp"
#include "swivel/types.hpp"
#include "swivel/version.hpp"

#endif
