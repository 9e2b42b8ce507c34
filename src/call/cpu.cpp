#include "src/call/cpu.hpp"

#if defined(_MSC_VER) && !defined(__clang__)
#include <intrin.h>
#endif

// xsimd's own detection is not used: release 8.1.0 reads SSE2 from the XSAVE bit and ignores whether the
// operating system saves the AVX registers, and then dies of an illegal instruction where it does not.

namespace swivel {

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))

bool cpu_has_avx2_fma() noexcept {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

bool cpu_has_avx512() noexcept {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
}

#elif defined(_M_X64)

namespace {

struct leaf {
    unsigned a, b, c, d;
};

leaf cpuid(int number) noexcept {
    int r[4];
    __cpuidex(r, number, 0);
    return {static_cast<unsigned>(r[0]), static_cast<unsigned>(r[1]), static_cast<unsigned>(r[2]),
            static_cast<unsigned>(r[3])};
}

bool has(unsigned word, int bit) noexcept { return ((word >> bit) & 1U) != 0; }

// The registers that the operating system saves: bits 1 and 2 SSE and AVX, 5 to 7 AVX-512.
bool system_saves(unsigned mask) noexcept {
    return has(cpuid(1).c, 27) && (static_cast<unsigned>(_xgetbv(0)) & mask) == mask;
}

}  // namespace

bool cpu_has_avx2_fma() noexcept {
    if (cpuid(0).a < 7 || !system_saves(0x06)) return false;
    return has(cpuid(1).c, 12) && has(cpuid(7).b, 5);
}

bool cpu_has_avx512() noexcept {
    if (cpuid(0).a < 7 || !system_saves(0xe6)) return false;
    const unsigned b = cpuid(7).b;
    return has(cpuid(1).c, 12) && has(b, 16) && has(b, 17) && has(b, 28) && has(b, 30) && has(b, 31);
}

#else

bool cpu_has_avx2_fma() noexcept { return false; }
bool cpu_has_avx512() noexcept { return false; }

#endif

}  // namespace swivel
