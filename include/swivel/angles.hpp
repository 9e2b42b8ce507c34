#ifndef SWIVEL_ANGLES_HPP
#define SWIVEL_ANGLES_HPP

// Sines and cosines of angles, and angles of points.

#include "swivel/atan2.hpp"
#include "swivel/sincos.hpp"

#endif
