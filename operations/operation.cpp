#include "operations/operation.hpp"

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

}  // namespace swivel::operations
