#include "support/operations.hpp"

namespace swivel::tests {

namespace {

// The four streams of a buffer as those of spinors.
template <class T>
spinor_view<T> spinors(quat_buffer<T>& b) {
    return {b.first(0), b.first(1), b.first(2), b.first(3), b.size(), b.stride()};
}

template <class T>
buffers<T> angle_in(workspace<T>& w) {
    return {&w.angles_in};
}
template <class T>
buffers<T> angle_and_axis_in(workspace<T>& w) {
    return {&w.angles_in, &w.axes};
}
template <class T>
buffers<T> rotation(workspace<T>& w) {
    return {&w.q};
}
template <class T>
buffers<T> result(workspace<T>& w) {
    return {&w.out};
}

}  // namespace

template <class T>
void add_conversions(std::vector<operation<T>>& all) {
    struct axis_case {
        const char* name;
        std::function<twist_axis<T>(workspace<T>&)> make;
        std::function<buffers<T>(workspace<T>&)> reads;
    };
    const axis_case axes[] = {
        {"x", [](workspace<T>&) { return twist_axis<T>(axis::x); }, angle_in<T>},
        {"y", [](workspace<T>&) { return twist_axis<T>(axis::y); }, angle_in<T>},
        {"z", [](workspace<T>&) { return twist_axis<T>(axis::z); }, angle_in<T>},
        {"uniform", [](workspace<T>& w) { return twist_axis<T>(w.axis_for_all); }, angle_in<T>},
        {"per_element", [](workspace<T>& w) { return twist_axis<T>(w.axes.view()); }, angle_and_axis_in<T>},
    };
    for (const axis_case& a : axes) {
        const auto make = a.make;
        all.push_back({std::string("from_axis_angle/") + a.name,
                       {},
                       a.reads,
                       result<T>,
                       [make](workspace<T>& w, const options& set, bool reference) {
                           return reference ? reference::from_axis_angle(make(w), w.angles_in.view(),
                                                                         w.out.view(), set)
                                            : from_axis_angle(make(w), w.angles_in.view(), w.out.view(), set);
                       }});
    }
    all.push_back({"to_axis_angle",
                   {},
                   rotation<T>,
                   [](workspace<T>& w) {
                       return buffers<T>{&w.vectors_out, &w.scalars};
                   },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference
                                  ? reference::to_axis_angle(w.q.view(), w.vectors_out.view(),
                                                             w.scalars.view(), set)
                                  : to_axis_angle(w.q.view(), w.vectors_out.view(), w.scalars.view(), set);
                   }});

    operation<T> spinor = {
        "from_spinor", {}, rotation<T>, result<T>, [](workspace<T>& w, const options& set, bool reference) {
            return reference ? reference::from_spinor(spinors(w.q), w.out.view(), set)
                             : from_spinor(spinors(w.q), w.out.view(), set);
        }};
    spinor.moves = true;
    all.push_back(spinor);
    spinor.name = "to_spinor";
    spinor.call = [](workspace<T>& w, const options& set, bool reference) {
        return reference ? reference::to_spinor(w.q.view(), spinors(w.out), set)
                         : to_spinor(w.q.view(), spinors(w.out), set);
    };
    all.push_back(spinor);

    all.push_back({"from_matrix",
                   {},
                   [](workspace<T>& w) { return buffers<T>{&w.matrices_in}; },
                   result<T>,
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::from_matrix(w.matrices_in.view(), w.out.view(), set)
                                        : from_matrix(w.matrices_in.view(), w.out.view(), set);
                   }});
    all.push_back({"to_matrix",
                   {},
                   rotation<T>,
                   [](workspace<T>& w) { return buffers<T>{&w.matrices_out}; },
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::to_matrix(w.q.view(), w.matrices_out.view(), set)
                                        : to_matrix(w.q.view(), w.matrices_out.view(), set);
                   }});

    const std::pair<const char*, euler_order> orders[] = {
        {"/xyz", euler_order::xyz}, {"/xzy", euler_order::xzy}, {"/yxz", euler_order::yxz},
        {"/yzx", euler_order::yzx}, {"/zxy", euler_order::zxy}, {"/zyx", euler_order::zyx},
        {"/xyx", euler_order::xyx}, {"/xzx", euler_order::xzx}, {"/yxy", euler_order::yxy},
        {"/yzy", euler_order::yzy}, {"/zxz", euler_order::zxz}, {"/zyz", euler_order::zyz}};
    for (const auto& [name, order] : orders) {
        const euler_order by = order;
        all.push_back({std::string("from_euler") + name,
                       {},
                       [](workspace<T>& w) { return buffers<T>{&w.vectors}; },
                       result<T>,
                       [by](workspace<T>& w, const options& set, bool reference) {
                           return reference ? reference::from_euler(w.vectors.view(), by, w.out.view(), set)
                                            : from_euler(w.vectors.view(), by, w.out.view(), set);
                       }});
        all.push_back({std::string("to_euler") + name,
                       {},
                       rotation<T>,
                       [](workspace<T>& w) { return buffers<T>{&w.vectors_out}; },
                       [by](workspace<T>& w, const options& set, bool reference) {
                           return reference ? reference::to_euler(w.q.view(), by, w.vectors_out.view(), set)
                                            : to_euler(w.q.view(), by, w.vectors_out.view(), set);
                       }});
    }
}

template void add_conversions(std::vector<operation<float>>&);
template void add_conversions(std::vector<operation<double>>&);

}  // namespace swivel::tests
