#include "operations/operation.hpp"

#include <string_view>

namespace swivel::operations {

const std::vector<const operation*>& all() {
    static const std::vector<const operation*> every = [] {
        std::vector<const operation*> operations;
        for (const auto family :
             {swing_twist, interpolation, angles, rotors, exponentials, arcs, conversions, motors, conformal})
            for (const operation& o : family()) operations.push_back(&o);
        return operations;
    }();
    return every;
}

const operation* find(std::string_view name) {
    for (const operation* const o : all())
        if (name == o->name) return o;
    return nullptr;
}

}  // namespace swivel::operations
