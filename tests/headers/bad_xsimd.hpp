#ifndef SWIVEL_BAD_XSIMD_HPP
#define SWIVEL_BAD_XSIMD_HPP

#include <xsimd/xsimd.hpp>

#endif
