#ifndef SWIVEL_OPERATIONS_OPERATION_HPP
#define SWIVEL_OPERATIONS_OPERATION_HPP

// Every operation of the library, described once: what it reads and writes, which options it looks at, how it and its
// reference are called, and what its help says. The command's `eval`, the tests of what all operations promise and the
// bench go through these.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "operations/block.hpp"
#include "swivel/reference.hpp"
#include "swivel/swivel.hpp"

namespace swivel::operations {

// In either type, so that neither is rounded twice.
struct number {
    float f32 = 0;
    double f64 = 0;

    template <class T>
    [[nodiscard]] T as() const noexcept {
        if constexpr (std::is_same_v<T, float>)
            return f32;
        else
            return f64;
    }
};
struct axis_vector {
    vec3<float> f32{};
    vec3<double> f64{};
};

struct rotation {
    quat<float> f32{};
    quat<double> f64{};
};

// One for each element, in a group of its own.
struct column {};

using axis_setting = std::variant<swivel::axis, axis_vector, column>;
using parameter_setting = std::variant<number, column>;

enum class factor_form { full, compact, twist, swing, angle };

// The options of eval that an operation has; each stands for what it sets below.
enum class option {
    axis,
    axis_of_compact,  // a coordinate axis, for the compact form alone
    axis_of_ends,     // in nx ny nz, where a and b are the ends
    product,
    form,
    form_read,  // full or compact
    positive_twist,
    signs,
    signs_read,
    pole_threshold,
    exponent,
    t,
    way,
    frame,
    tip,
    tip_about,  // --tip with an axis that is there for it alone
    t_twist,
    motion,
    angle,
    euler_order,
    motors,
    weights,
    by,
    sequence
};

struct settings {
    axis_setting axis = swivel::axis::z;
    factor_form form = factor_form::full;
    bool signs = false;
    parameter_setting t = number{0.5F, 0.5}, angle = number{};
    std::optional<parameter_setting> t_twist;
    bool tip = false;
    std::size_t motors = 2;
    std::vector<number> weights;  // of the motors, for all elements; none: columns
    std::optional<rotation> by;   // one for all elements; none: a group
    swivel::euler_order euler = swivel::euler_order::xyz;
    swivel::options options;
    // Each element goes on from the one before, over the blocks that one operation gets.
    bool sequence = false;
    mutable quat<double> last_of_sequence{};
};

struct groups {
    std::vector<group> in, out;
    std::string fault = {};  // of settings that contradict each other
};

template <class T>
using function = status (*)(const settings&, const block<const T>& in, const block<T>& out);

struct calls {
    function<float> f32;
    function<double> f64;

    template <class T>
    [[nodiscard]] function<T> as() const noexcept {
        if constexpr (std::is_same_v<T, float>)
            return f32;
        else
            return f64;
    }
};

struct operation {
    const char* name;
    const char* description;
    const char* help;  // which streams, with examples
    std::vector<option> options;
    operations::groups (*groups)(const settings&);
    operations::calls library, reference;
    // Components are moved, not computed with: a NaN or an infinity comes out as it is, in one component.
    bool moves = false;

    [[nodiscard]] operation that_moves() const {
        operation o = *this;
        o.moves = true;
        return o;
    }
};

[[nodiscard]] std::span<const operation> swing_twist();
[[nodiscard]] std::span<const operation> interpolation();
[[nodiscard]] std::span<const operation> angles();
[[nodiscard]] std::span<const operation> rotors();
[[nodiscard]] std::span<const operation> exponentials();
[[nodiscard]] std::span<const operation> arcs();
[[nodiscard]] std::span<const operation> conversions();
[[nodiscard]] std::span<const operation> motors();
[[nodiscard]] std::span<const operation> conformal();

// All of them, family by family.
[[nodiscard]] const std::vector<const operation*>& all();

}  // namespace swivel::operations

#endif
