#ifndef SWIVEL_BAD_INTRINSIC_HPP
#define SWIVEL_BAD_INTRINSIC_HPP

inline float root(float a) { return _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(a))); }

#endif
