#ifndef SWIVEL_ISA_HPP
#define SWIVEL_ISA_HPP

// Which instruction set runs the kernels.
//
// The best usable ISA is chosen the first time that it is needed. The environment variable SWIVEL_ISA, read
// at that moment, names another one (sse2, avx2, avx512, neon64); a name that is unknown or not usable
// is ignored.

#include <cstdint>

#include "swivel/types.hpp"

namespace swivel {

enum class isa : std::uint8_t {
    sse2,    // x86-64 baseline
    avx2,    // with FMA: Haswell and later, every Zen
    avx512,  // F, CD, DQ, BW and VL: Skylake-X and later, Zen 4 and later
    neon64   // AArch64 baseline
};

inline constexpr isa all_isas[] = {isa::sse2, isa::avx2, isa::avx512, isa::neon64};

// The name used by SWIVEL_ISA, the command and the test and bench rows; never null.
const char* name(isa) noexcept;

// Whether this build of the library has kernels for the ISA.
bool is_compiled(isa) noexcept;

// Whether it is compiled in and processor and operating system support it.
bool is_usable(isa) noexcept;

// The ISA of the next call. Safe from any thread.
isa active_isa() noexcept;

// Selects the ISA for all threads: ok, or isa_unavailable and no change. Calls under way finish on the ISA
// that they began with.
status set_active_isa(isa) noexcept;

}  // namespace swivel

#endif
