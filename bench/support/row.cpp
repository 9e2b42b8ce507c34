#include "bench/support/row.hpp"

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

}  // namespace swivel_bench
