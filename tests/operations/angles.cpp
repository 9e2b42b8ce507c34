#include "support/operations.hpp"

namespace swivel::tests {

template <class T>
void add_angles(std::vector<operation<T>>& all) {
    all.push_back({"sincos",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.angles_in}; },
                   [](workspace<T>& w) {
                       return buffers<T>{&w.scalars, &w.other_scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::sincos(w.angles_in.view(), w.scalars.view(),
                                                      w.other_scalars.view(), set)
                                  : sincos(w.angles_in.view(), w.scalars.view(), w.other_scalars.view(), set);
                   }});
    all.push_back({"atan2",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.parameters_in, &w.other_parameters_in};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.scalars}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::atan2(w.parameters_in.view(), w.other_parameters_in.view(),
                                                     w.scalars.view(), set)
                                  : atan2(w.parameters_in.view(), w.other_parameters_in.view(),
                                          w.scalars.view(), set);
                   }});
}

template void add_angles(std::vector<operation<float>>&);
template void add_angles(std::vector<operation<double>>&);

}  // namespace swivel::tests
