#include "support/operations.hpp"

namespace swivel::tests {

template <class T>
void add_arcs(std::vector<operation<T>>& all) {
    all.push_back({"shortest_arc",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.vectors, &w.axes};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::shortest_arc(w.vectors.view(), w.axes.view(),
                                                                  w.out.view(), set)
                                        : shortest_arc(w.vectors.view(), w.axes.view(), w.out.view(), set);
                   }});
    all.push_back({"arc_with_twist/for_all/swing_twist",
                   {.order = product::swing_twist},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.vectors, &w.axes};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::arc_with_twist(w.vectors.view(), w.axes.view(), T(0.7),
                                                                    w.out.view(), set)
                                        : arc_with_twist(w.vectors.view(), w.axes.view(), T(0.7),
                                                         w.out.view(), set);
                   }});
    all.push_back({"arc_with_twist/per_element/swing_twist",
                   {.order = product::swing_twist},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.vectors, &w.axes, &w.angles_in};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::arc_with_twist(w.vectors.view(), w.axes.view(),
                                                                    w.angles_in.view(), w.out.view(), set)
                                        : arc_with_twist(w.vectors.view(), w.axes.view(), w.angles_in.view(),
                                                         w.out.view(), set);
                   }});
    all.push_back({"arc_with_twist/for_all/twist_swing",
                   {.order = product::twist_swing},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.vectors, &w.axes};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::arc_with_twist(w.vectors.view(), w.axes.view(), T(0.7),
                                                                    w.out.view(), set)
                                        : arc_with_twist(w.vectors.view(), w.axes.view(), T(0.7),
                                                         w.out.view(), set);
                   }});
    all.push_back({"arc_with_twist/per_element/twist_swing",
                   {.order = product::twist_swing},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.vectors, &w.axes, &w.angles_in};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::arc_with_twist(w.vectors.view(), w.axes.view(),
                                                                    w.angles_in.view(), w.out.view(), set)
                                        : arc_with_twist(w.vectors.view(), w.axes.view(), w.angles_in.view(),
                                                         w.out.view(), set);
                   }});
}

template void add_arcs(std::vector<operation<float>>&);
template void add_arcs(std::vector<operation<double>>&);

}  // namespace swivel::tests
