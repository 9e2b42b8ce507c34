#include "operations/block.hpp"

namespace swivel::operations {

std::vector<std::string> stream_names(const group& g) {
    const std::string& p = g.prefix;
    switch (g.kind) {
        case group_kind::quaternion:
            return {p + "x", p + "y", p + "z", p + "w"};
        case group_kind::vector:
            return {p + "x", p + "y", p + "z"};
        case group_kind::factors:
            return {"s1", "s2", "sc", "ts", "tc"};
        case group_kind::matrix:
            return {p + "xx", p + "xy", p + "xz", p + "yx", p + "yy", p + "yz", p + "zx", p + "zy", p + "zz"};
        case group_kind::motor:
            return {p + "x", p + "y", p + "z", p + "w", p + "dx", p + "dy", p + "dz", p + "dw"};
        case group_kind::conformal:
            return {p + "s",  p + "12", p + "13", p + "14",   p + "15",   p + "23",   p + "24",   p + "25",
                    p + "34", p + "35", p + "45", p + "1234", p + "1235", p + "1245", p + "1345", p + "2345"};
        case group_kind::bivector:
            return {p + "12", p + "13", p + "14", p + "15", p + "23",
                    p + "24", p + "25", p + "34", p + "35", p + "45"};
        case group_kind::spinor:
            return {"a", "b", "c", "d"};
        case group_kind::scalar:
            break;
    }
    return {p};
}

std::vector<std::string> stream_names(std::span<const group> groups) {
    std::vector<std::string> names;
    for (const group& g : groups)
        for (std::string& name : stream_names(g)) names.push_back(std::move(name));
    return names;
}

}  // namespace swivel::operations
