#include "support/operations.hpp"

namespace swivel::tests {

template <class T>
void add_exponentials(std::vector<operation<T>>& all) {
    all.push_back({"square_root",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.q}; },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::square_root(w.q.view(), w.out.view(), set)
                                        : square_root(w.q.view(), w.out.view(), set);
                   }});
    all.push_back({"exp",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.vectors}; },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::exp(w.vectors.view(), w.out.view(), set)
                                        : exp(w.vectors.view(), w.out.view(), set);
                   }});
    all.push_back({"log",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.q}; },
                   [](workspace<T>& w) { return buffers<T>{&w.vectors_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::log(w.q.view(), w.vectors_out.view(), set)
                                        : log(w.q.view(), w.vectors_out.view(), set);
                   }});
    all.push_back({"power/for_all",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.q}; },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::power(w.q.view(), T(0.3), w.out.view(), set)
                                        : power(w.q.view(), T(0.3), w.out.view(), set);
                   }});
    all.push_back({"power/per_element",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.q, &w.parameters_in};
                   },
                   [](workspace<T>& w) { return buffers<T>{&w.out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::power(w.q.view(), w.parameters_in.view(), w.out.view(), set)
                                  : power(w.q.view(), w.parameters_in.view(), w.out.view(), set);
                   }});
}

template void add_exponentials(std::vector<operation<float>>&);
template void add_exponentials(std::vector<operation<double>>&);

}  // namespace swivel::tests
