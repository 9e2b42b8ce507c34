#include "swivel/isa.hpp"

#include <cstdlib>
#include <cstring>

#include "src/call/active_kernels.hpp"
#include "src/call/cpu.hpp"

namespace swivel {

namespace {

bool always() noexcept { return true; }

struct row {
    isa which;
    const char* name;
    const kernel_table* table;  // null where the build has none
    bool (*usable)() noexcept;
};

#ifdef SWIVEL_HAS_SSE2
constexpr const kernel_table* sse2_table = &sse2_kernels;
#else
constexpr const kernel_table* sse2_table = nullptr;
#endif
#ifdef SWIVEL_HAS_SSE4
constexpr const kernel_table* sse4_table = &sse4_kernels;
#else
constexpr const kernel_table* sse4_table = nullptr;
#endif
#ifdef SWIVEL_HAS_AVX2
constexpr const kernel_table* avx2_table = &avx2_kernels;
#else
constexpr const kernel_table* avx2_table = nullptr;
#endif
#ifdef SWIVEL_HAS_AVX512
constexpr const kernel_table* avx512_table = &avx512_kernels;
#else
constexpr const kernel_table* avx512_table = nullptr;
#endif
#ifdef SWIVEL_HAS_NEON64
constexpr const kernel_table* neon64_table = &neon64_kernels;
#else
constexpr const kernel_table* neon64_table = nullptr;
#endif

// Best first.
constexpr row rows[] = {
    {isa::avx512, "avx512", avx512_table, cpu_has_avx512}, {isa::avx2, "avx2", avx2_table, cpu_has_avx2_fma},
    {isa::sse4, "sse4", sse4_table, cpu_has_sse4_1},       {isa::sse2, "sse2", sse2_table, always},
    {isa::neon64, "neon64", neon64_table, always},
};

const row* find(isa which) noexcept {
    for (const row& r : rows)
        if (r.which == which) return &r;
    return nullptr;
}

bool usable(const row& r) noexcept { return r.table != nullptr && r.usable(); }

}  // namespace

constinit std::atomic<const kernel_table*> chosen_kernels{nullptr};

const kernel_table& choose_kernels() noexcept {
    const kernel_table* best = nullptr;
    const char* wanted = std::getenv("SWIVEL_ISA");
    for (const row& r : rows) {
        if (!usable(r)) continue;
        if (best == nullptr) best = r.table;
        if (wanted != nullptr && std::strcmp(wanted, r.name) == 0) best = r.table;
    }
    // A call of set_active_isa on another thread goes before.
    const kernel_table* none = nullptr;
    if (!chosen_kernels.compare_exchange_strong(none, best, std::memory_order_acq_rel)) best = none;
    return *best;
}

const char* name(isa which) noexcept {
    const row* r = find(which);
    return r != nullptr ? r->name : "unknown";
}

bool is_compiled(isa which) noexcept {
    const row* r = find(which);
    return r != nullptr && r->table != nullptr;
}

bool is_usable(isa which) noexcept {
    const row* r = find(which);
    return r != nullptr && usable(*r);
}

isa active_isa() noexcept {
    const kernel_table* active = &active_kernels();
    isa which = rows[0].which;
    for (const row& r : rows)
        if (r.table == active) which = r.which;
    return which;
}

status set_active_isa(isa which) noexcept {
    if (!is_usable(which)) return status::isa_unavailable;
    chosen_kernels.store(find(which)->table, std::memory_order_release);
    return status::ok;
}

}  // namespace swivel
