#ifndef SWIVEL_BAD_STRING_HPP
#define SWIVEL_BAD_STRING_HPP

#include <string>

#endif
