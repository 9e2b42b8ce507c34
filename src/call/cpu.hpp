#ifndef SWIVEL_SRC_CALL_CPU_HPP
#define SWIVEL_SRC_CALL_CPU_HPP

namespace swivel {

// What processor and operating system together can run.
bool cpu_has_avx2_fma() noexcept;
bool cpu_has_avx512() noexcept;  // F, CD, DQ, BW, VL and FMA

}  // namespace swivel

#endif
