#include "support/operations.hpp"

namespace swivel::tests {

namespace {

template <class T>
buffers<T> one_rotation(workspace<T>& w) {
    return {&w.q};
}
template <class T>
buffers<T> two_rotations(workspace<T>& w) {
    return {&w.q, &w.twist_in};
}
template <class T>
buffers<T> rotation_and_vector(workspace<T>& w) {
    return {&w.q, &w.vectors};
}
template <class T>
buffers<T> one_vector(workspace<T>& w) {
    return {&w.vectors};
}
template <class T>
buffers<T> rotation_out(workspace<T>& w) {
    return {&w.out};
}
template <class T>
buffers<T> vector_out(workspace<T>& w) {
    return {&w.vectors_out};
}
template <class T>
buffers<T> scalar_out(workspace<T>& w) {
    return {&w.scalars};
}

}  // namespace

// align_signs along a sequence is not here: its elements depend on one another (align_signs_test.cpp).
template <class T>
void add_rotors(std::vector<operation<T>>& all) {
    all.push_back({"multiply",
                   {},
                   two_rotations<T>,
                   rotation_out<T>,
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::multiply(w.q.view(), w.twist_in.view(), w.out.view(), set)
                                  : multiply(w.q.view(), w.twist_in.view(), w.out.view(), set);
                   }});
    operation<T> moves = {"conjugate",
                          {},
                          one_rotation<T>,
                          rotation_out<T>,
                          [](workspace<T>& w, const options& set, bool reference) {
                              return reference ? reference::conjugate(w.q.view(), w.out.view(), set)
                                               : conjugate(w.q.view(), w.out.view(), set);
                          }};
    moves.moves = true;
    all.push_back(moves);
    all.push_back({"normalize",
                   {},
                   one_rotation<T>,
                   rotation_out<T>,
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::normalize(w.q.view(), w.out.view(), set)
                                        : normalize(w.q.view(), w.out.view(), set);
                   }});
    all.push_back({"rotate",
                   {},
                   rotation_and_vector<T>,
                   vector_out<T>,
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::rotate(w.q.view(), w.vectors.view(), w.vectors_out.view(), set)
                                  : rotate(w.q.view(), w.vectors.view(), w.vectors_out.view(), set);
                   }});
    all.push_back({"rotate/one_for_all",
                   {},
                   one_vector<T>,
                   vector_out<T>,
                   [](workspace<T>& w, const options& set, bool reference) {
                       const quat<T> q{T(0.36), T(-0.48), T(0.64), T(0.48)};
                       return reference ? reference::rotate(q, w.vectors.view(), w.vectors_out.view(), set)
                                        : rotate(q, w.vectors.view(), w.vectors_out.view(), set);
                   }});
    all.push_back(
        {"dot", {}, two_rotations<T>, scalar_out<T>, [](workspace<T>& w, const options& set, bool reference) {
             return reference ? reference::dot(w.q.view(), w.twist_in.view(), w.scalars.view(), set)
                              : dot(w.q.view(), w.twist_in.view(), w.scalars.view(), set);
         }});
    all.push_back({"align_signs",
                   {},
                   two_rotations<T>,
                   rotation_out<T>,
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::align_signs(w.q.view(), w.twist_in.view(), w.out.view(), set)
                                  : align_signs(w.q.view(), w.twist_in.view(), w.out.view(), set);
                   }});
}

template void add_rotors(std::vector<operation<float>>&);
template void add_rotors(std::vector<operation<double>>&);

}  // namespace swivel::tests
