#include "row.hpp"

namespace swivel_bench {

std::string row_name(std::string_view op, std::string_view who, layout l, bool is_double, std::size_t n) {
    std::string name(op);
    name += '/';
    name += who;
    name += l == layout::soa ? "/soa/" : "/aos/";
    name += is_double ? "f64/" : "f32/";
    name += std::to_string(n);
    return name;
}

const std::vector<swivel::isa>& usable_isas() {
    static const std::vector<swivel::isa> usable = [] {
        std::vector<swivel::isa> all;
        for (const swivel::isa which : swivel::all_isas)
            if (swivel::is_usable(which)) all.push_back(which);
        return all;
    }();
    return usable;
}

}  // namespace swivel_bench
