#ifndef SWIVEL_TESTS_SUPPORT_OPERATIONS_HPP
#define SWIVEL_TESTS_SUPPORT_OPERATIONS_HPP

// Every public operation in every form, for the tests of what the contract promises of all: those of operations/, with
// all combinations of what their options may be.

#include <functional>
#include <string>
#include <vector>

#include "operations/operation.hpp"
#include "support/buffers.hpp"
#include "support/motors.hpp"
#include "support/rotations.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {

// Everything that any operation reads or writes.
template <class T>
struct workspace {
    quat_buffer<T> q;                   // where one is read
    quat_buffer<T> swing_in, twist_in;  // where two are
    vec3_buffer<T> axes, vectors;
    factor_buffer<T> factors_in;
    matrix_buffer<T> matrices_in;
    motor_buffer<T> motors_in, other_motors_in;
    conformal_buffer<T> rotors_in, other_rotors_in;
    bivector_buffer<T> bivectors_in;
    scalar_buffer<T> signs_in, angles_in, parameters_in, other_parameters_in;

    quat_buffer<T> swing, twist;
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
using buffer_of = any_buffer<T>* (*)(workspace<T>&);

template <class T>
buffers<T> all_of(const std::vector<buffer_of<T>>& each, workspace<T>& w) {
    buffers<T> all;
    for (const buffer_of<T> b : each) all.push_back(b(w));
    return all;
}

template <class T>
struct operation {
    std::string name;  // and after each '/' what is set
    const operations::operation* what;
    operations::settings set;
    operations::groups groups;
    std::vector<buffer_of<T>> read, written;  // of each group

    buffers<T> reads(workspace<T>& w) const { return all_of(read, w); }
    buffers<T> writes(workspace<T>& w) const { return all_of(written, w); }

    status run(workspace<T>& w, precision p) const;
    status run_reference(workspace<T>& w) const;

    // Of an output that is 1 or -1 whatever the element holds.
    bool is_kept_sign(std::size_t output) const;
    bool moves() const { return what->moves; }

    // Every output component of element i.
    std::vector<T> outputs(workspace<T>& w, std::size_t i) const {
        std::vector<T> all;
        for (any_buffer<T>* b : writes(w))
            for (int c = 0; c < b->components(); ++c) all.push_back(b->at(c, i));
        return all;
    }
};

template <class T>
const std::vector<operation<T>>& all_operations();

extern template struct operation<float>;
extern template struct operation<double>;
extern template const std::vector<operation<float>>& all_operations();
extern template const std::vector<operation<double>>& all_operations();
extern template struct workspace<float>;
extern template struct workspace<double>;

}  // namespace swivel::tests

#endif
