#ifndef SWIVEL_BAD_CLIP_HPP
#define SWIVEL_BAD_CLIP_HPP

#include "swivel/clip/clip.hpp"

#endif
