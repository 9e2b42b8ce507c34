#include "support/operations.hpp"

namespace swivel::tests {

template <class T>
void add_conformal(std::vector<operation<T>>& all) {
    all.push_back({"conformal_multiply",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_in, &w.other_rotors_in};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::multiply(w.rotors_in.view(), w.other_rotors_in.view(),
                                                              w.rotors_out.view(), set)
                                        : multiply(w.rotors_in.view(), w.other_rotors_in.view(),
                                                   w.rotors_out.view(), set);
                   }});
    all.push_back({"conformal_reverse",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_in}; },
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::reverse(w.rotors_in.view(), w.rotors_out.view(), set)
                                        : reverse(w.rotors_in.view(), w.rotors_out.view(), set);
                   }});
    all.back().moves = true;
    all.push_back({"conformal_from_motor",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.motors_in}; },
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::from_motor(w.motors_in.view(), w.rotors_out.view(), set)
                                        : from_motor(w.motors_in.view(), w.rotors_out.view(), set);
                   }});
    all.push_back({"conformal_from_rotation",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.q}; },
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::from_rotation(w.q.view(), w.rotors_out.view(), set)
                                        : from_rotation(w.q.view(), w.rotors_out.view(), set);
                   }});
    all.push_back({"conformal_from_translation",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.vectors}; },
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::from_translation(w.vectors.view(), w.rotors_out.view(), set)
                                  : from_translation(w.vectors.view(), w.rotors_out.view(), set);
                   }});
    all.push_back({"conformal_from_dilation",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.angles_in}; },
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::from_dilation(w.angles_in.view(), w.rotors_out.view(), set)
                                  : from_dilation(w.angles_in.view(), w.rotors_out.view(), set);
                   }});
    all.push_back({"conformal_transform",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_in, &w.vectors};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.vectors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::transform(w.rotors_in.view(), w.vectors.view(),
                                                               w.vectors_out.view(), set)
                                        : transform(w.rotors_in.view(), w.vectors.view(),
                                                    w.vectors_out.view(), set);
                   }});
    all.push_back({"conformal_square_root",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_in}; },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::square_root(w.rotors_in.view(), w.rotors_out.view(),
                                                                 w.scalars.view(), set)
                                        : square_root(w.rotors_in.view(), w.rotors_out.view(),
                                                      w.scalars.view(), set);
                   }});
    all.push_back({"conformal_exp",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.bivectors_in}; },
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::exp(w.bivectors_in.view(), w.rotors_out.view(), set)
                                        : exp(w.bivectors_in.view(), w.rotors_out.view(), set);
                   }});
    all.push_back({"conformal_log",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_in}; },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.bivectors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::log(w.rotors_in.view(), w.bivectors_out.view(),
                                                   w.scalars.view(), set)
                                  : log(w.rotors_in.view(), w.bivectors_out.view(), w.scalars.view(), set);
                   }});
    all.push_back({"conformal_power/for_all",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.rotors_in}; },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::power(w.rotors_in.view(), T(0.3), w.rotors_out.view(),
                                                           w.scalars.view(), set)
                                        : power(w.rotors_in.view(), T(0.3), w.rotors_out.view(),
                                                w.scalars.view(), set);
                   }});
    all.push_back({"conformal_power/per_element",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_in, &w.parameters_in};
                   },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::power(w.rotors_in.view(), w.parameters_in.view(),
                                                           w.rotors_out.view(), w.scalars.view(), set)
                                        : power(w.rotors_in.view(), w.parameters_in.view(),
                                                w.rotors_out.view(), w.scalars.view(), set);
                   }});
    all.push_back({"conformal_interpolate/for_all",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_in, &w.other_rotors_in};
                   },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::interpolate(w.rotors_in.view(), w.other_rotors_in.view(),
                                                           T(0.3), w.rotors_out.view(), w.scalars.view(), set)
                                  : interpolate(w.rotors_in.view(), w.other_rotors_in.view(), T(0.3),
                                                w.rotors_out.view(), w.scalars.view(), set);
                   }});
    all.push_back({"conformal_interpolate/per_element",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_in, &w.other_rotors_in, &w.parameters_in};
                   },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.rotors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::interpolate(w.rotors_in.view(), w.other_rotors_in.view(),
                                                                 w.parameters_in.view(), w.rotors_out.view(),
                                                                 w.scalars.view(), set)
                                        : interpolate(w.rotors_in.view(), w.other_rotors_in.view(),
                                                      w.parameters_in.view(), w.rotors_out.view(),
                                                      w.scalars.view(), set);
                   }});
    all.push_back({"conformal_split",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.bivectors_in}; },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.bivectors_out, &w.other_bivectors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::split(w.bivectors_in.view(), w.bivectors_out.view(),
                                                     w.other_bivectors_out.view(), w.scalars.view(), set)
                                  : split(w.bivectors_in.view(), w.bivectors_out.view(),
                                          w.other_bivectors_out.view(), w.scalars.view(), set);
                   }});
}

template void add_conformal(std::vector<operation<float>>&);
template void add_conformal(std::vector<operation<double>>&);

}  // namespace swivel::tests
