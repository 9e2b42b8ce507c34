#include "swivel/isa.hpp"

#include <cstdlib>
#include <cstring>

#include "src/call/active.hpp"
#include "src/call/cpu.hpp"

namespace swivel {

namespace {

bool always() noexcept { return true; }

struct row {
    isa which;
    const char* name;
    bool (*usable)() noexcept;
};

template <class Isa>
constexpr row row_of{};
template <>
constexpr row row_of<avx512>{isa::avx512, "avx512", cpu_has_avx512};
template <>
constexpr row row_of<avx2>{isa::avx2, "avx2", cpu_has_avx2_fma};
template <>
constexpr row row_of<sse2>{isa::sse2, "sse2", always};
template <>
constexpr row row_of<neon64>{isa::neon64, "neon64", always};

constexpr row known[] = {row_of<avx512>, row_of<avx2>, row_of<sse2>, row_of<neon64>};

// Those of the build, best first, in the order of the tables.
template <class... Isas>
struct rows_of;
template <class... Isas>
struct rows_of<isa_list<Isas...>> {
    static constexpr row all[] = {row_of<Isas>...};
};
constexpr const auto& compiled = rows_of<compiled_isas>::all;
constexpr std::uint8_t compiled_count = sizeof compiled / sizeof compiled[0];

// The place of the ISA among those of the build, or no_isa.
std::uint8_t index_of(isa which) noexcept {
    for (std::uint8_t k = 0; k < compiled_count; ++k)
        if (compiled[k].which == which) return k;
    return no_isa;
}

}  // namespace

constinit std::atomic<std::uint8_t> chosen_isa{no_isa};

std::uint8_t choose_isa() noexcept {
    std::uint8_t best = no_isa;
    const char* wanted = std::getenv("SWIVEL_ISA");
    for (std::uint8_t k = 0; k < compiled_count; ++k) {
        if (!compiled[k].usable()) continue;
        if (best == no_isa || (wanted != nullptr && std::strcmp(wanted, compiled[k].name) == 0)) best = k;
    }
    // A call of set_active_isa on another thread goes before.
    std::uint8_t none = no_isa;
    return chosen_isa.compare_exchange_strong(none, best, std::memory_order_relaxed) ? best : none;
}

const char* name(isa which) noexcept {
    for (const row& r : known)
        if (r.which == which) return r.name;
    return "unknown";
}

bool is_compiled(isa which) noexcept { return index_of(which) != no_isa; }

bool is_usable(isa which) noexcept {
    const std::uint8_t k = index_of(which);
    return k != no_isa && compiled[k].usable();
}

isa active_isa() noexcept { return compiled[isa_in_use()].which; }

status set_active_isa(isa which) noexcept {
    if (!is_usable(which)) return status::isa_unavailable;
    chosen_isa.store(index_of(which), std::memory_order_relaxed);
    return status::ok;
}

}  // namespace swivel
