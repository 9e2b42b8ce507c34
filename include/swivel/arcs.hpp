#ifndef SWIVEL_ARCS_HPP
#define SWIVEL_ARCS_HPP

// Rotations from one direction to another.

#include "swivel/arc_with_twist.hpp"
#include "swivel/shortest_arc.hpp"

#endif
