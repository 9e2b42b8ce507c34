#ifndef SWIVEL_TESTS_SUPPORT_OPERATIONS_HPP
#define SWIVEL_TESTS_SUPPORT_OPERATIONS_HPP

// Every public operation in every form, for the tests of what the contract promises of all. Each family is
// listed in a file of tests/operations/.

#include <functional>
#include <string>
#include <vector>

#include "support/buffers.hpp"
#include "support/motors.hpp"
#include "support/rotations.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {

// Everything that any operation reads or writes.
template <class T>
struct workspace {
    quat_buffer<T> q, swing_in, twist_in;
    vec3_buffer<T> axes, vectors;
    factor_buffer<T> factors_in;
    matrix_buffer<T> matrices_in;
    motor_buffer<T> motors_in, other_motors_in;
    conformal_buffer<T> rotors_in, other_rotors_in;
    bivector_buffer<T> bivectors_in;
    scalar_buffer<T> signs_in, angles_in, parameters_in, other_parameters_in;

    quat_buffer<T> out, swing, twist;
    vec3_buffer<T> vectors_out, other_vectors_out;
    factor_buffer<T> factors_out;
    matrix_buffer<T> matrices_out;
    motor_buffer<T> motors_out;
    conformal_buffer<T> rotors_out;
    bivector_buffer<T> bivectors_out, other_bivectors_out;
    scalar_buffer<T> scalars, other_scalars;

    vec3<T> axis_for_all{T(0.36), T(-0.48), T(1.6)};

    workspace(std::size_t n, layout l);

    std::size_t size() const { return q.size(); }

    // Every third element a corner, the others random: rotations, factors that belong to them, directions of
    // any length, angles of a few turns, parameters in and a little out of [0, 1], motors with translations
    // of any length.
    void fill(generator& g);

private:
    void fill_conformal(generator g);
};

template <class T>
using buffers = std::vector<any_buffer<T>*>;

template <class T>
struct operation {
    std::string name;
    options set;
    std::function<buffers<T>(workspace<T>&)> reads, writes;
    std::function<status(workspace<T>&, const options&, bool reference)> call;
    // The last output is a kept sign, 1 or -1 whatever the element holds.
    bool keeps_sign = false;
    // Components are moved, not computed with: a NaN or an infinity comes out as it is, in one component.
    bool moves = false;

    status run(workspace<T>& w, precision p) const {
        options o = set;
        o.accuracy = p;
        return call(w, o, false);
    }
    status run_reference(workspace<T>& w) const { return call(w, set, true); }

    // Every output component of element i.
    std::vector<T> outputs(workspace<T>& w, std::size_t i) const {
        std::vector<T> all;
        for (any_buffer<T>* b : writes(w))
            for (int c = 0; c < b->components(); ++c) all.push_back(b->at(c, i));
        return all;
    }
};

template <class T>
void add_swing_twist(std::vector<operation<T>>& all);
template <class T>
void add_angles(std::vector<operation<T>>& all);
template <class T>
void add_rotors(std::vector<operation<T>>& all);
template <class T>
void add_exponentials(std::vector<operation<T>>& all);
template <class T>
void add_arcs(std::vector<operation<T>>& all);

template <class T>
void add_conversions(std::vector<operation<T>>& all);
template <class T>
void add_conformal(std::vector<operation<T>>& all);
template <class T>
void add_interpolation(std::vector<operation<T>>& all);
template <class T>
void add_motors(std::vector<operation<T>>& all);

template <class T>
std::vector<operation<T>> all_operations() {
    std::vector<operation<T>> all;
    add_swing_twist(all);
    add_angles(all);
    add_interpolation(all);
    add_rotors(all);
    add_exponentials(all);
    add_arcs(all);
    add_conversions(all);
    add_motors(all);
    add_conformal(all);
    return all;
}

extern template struct workspace<float>;
extern template struct workspace<double>;

}  // namespace swivel::tests

#endif
