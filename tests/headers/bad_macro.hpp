#ifndef SWIVEL_BAD_MACRO_HPP
#define SWIVEL_BAD_MACRO_HPP

#ifdef SWIVEL_FAST
inline constexpr bool fast = true;
#endif

#endif
