#include "support/operations.hpp"

namespace swivel::tests {

namespace {

template <class T>
buffers<T> one(workspace<T>& w) {
    return {&w.motors_in};
}
template <class T>
buffers<T> two(workspace<T>& w) {
    return {&w.motors_in, &w.other_motors_in};
}
template <class T>
buffers<T> motor_out(workspace<T>& w) {
    return {&w.motors_out};
}

}  // namespace

template <class T>
void add_motors(std::vector<operation<T>>& all) {
    using W = workspace<T>;
    using O = const options&;
    all.push_back({"motor multiply", {}, two<T>, motor_out<T>, [](W& w, O o, bool reference) {
                       const auto a = w.motors_in.view(), b = w.other_motors_in.view(),
                                  out = w.motors_out.view();
                       return reference ? reference::multiply(a, b, out, o) : multiply(a, b, out, o);
                   }});
    operation<T> conjugated{"motor conjugate", {}, one<T>, motor_out<T>, [](W& w, O o, bool reference) {
                                const auto m = w.motors_in.view(), out = w.motors_out.view();
                                return reference ? reference::conjugate(m, out, o) : conjugate(m, out, o);
                            }};
    conjugated.moves = true;
    all.push_back(conjugated);
    all.push_back({"motor normalize", {}, one<T>, motor_out<T>, [](W& w, O o, bool reference) {
                       const auto m = w.motors_in.view(), out = w.motors_out.view();
                       return reference ? reference::normalize(m, out, o) : normalize(m, out, o);
                   }});
    all.push_back({"from_rotation_translation",
                   {},
                   [](W& w) {
                       return buffers<T>{&w.q, &w.vectors};
                   },
                   motor_out<T>,
                   [](W& w, O o, bool reference) {
                       const auto q = w.q.view();
                       const auto t = w.vectors.view();
                       const auto out = w.motors_out.view();
                       return reference ? reference::from_rotation_translation(q, t, out, o)
                                        : from_rotation_translation(q, t, out, o);
                   }});
    all.push_back({"to_rotation_translation",
                   {},
                   one<T>,
                   [](W& w) {
                       return buffers<T>{&w.out, &w.vectors_out};
                   },
                   [](W& w, O o, bool reference) {
                       const auto m = w.motors_in.view();
                       const auto q = w.out.view();
                       const auto t = w.vectors_out.view();
                       return reference ? reference::to_rotation_translation(m, q, t, o)
                                        : to_rotation_translation(m, q, t, o);
                   }});
    all.push_back({"motor transform",
                   {},
                   [](W& w) {
                       return buffers<T>{&w.motors_in, &w.vectors};
                   },
                   [](W& w) { return buffers<T>{&w.vectors_out}; },
                   [](W& w, O o, bool reference) {
                       const auto m = w.motors_in.view();
                       const auto p = w.vectors.view(), out = w.vectors_out.view();
                       return reference ? reference::transform(m, p, out, o) : transform(m, p, out, o);
                   }});
    all.push_back({"motor square_root", {}, one<T>, motor_out<T>, [](W& w, O o, bool reference) {
                       const auto m = w.motors_in.view(), out = w.motors_out.view();
                       return reference ? reference::square_root(m, out, o) : square_root(m, out, o);
                   }});
    all.push_back({"motor log",
                   {},
                   one<T>,
                   [](W& w) {
                       return buffers<T>{&w.vectors_out, &w.other_vectors_out};
                   },
                   [](W& w, O o, bool reference) {
                       const auto m = w.motors_in.view();
                       const auto b = w.vectors_out.view(), n = w.other_vectors_out.view();
                       return reference ? reference::log(m, b, n, o) : log(m, b, n, o);
                   }});
    all.push_back({"motor exp",
                   {},
                   [](W& w) {
                       return buffers<T>{&w.vectors, &w.axes};
                   },
                   motor_out<T>,
                   [](W& w, O o, bool reference) {
                       const auto b = w.vectors.view(), n = w.axes.view();
                       const auto out = w.motors_out.view();
                       return reference ? reference::exp(b, n, out, o) : exp(b, n, out, o);
                   }});
    all.push_back({"motor power",
                   {},
                   [](W& w) {
                       return buffers<T>{&w.motors_in, &w.parameters_in};
                   },
                   motor_out<T>,
                   [](W& w, O o, bool reference) {
                       const auto m = w.motors_in.view(), out = w.motors_out.view();
                       const auto t = w.parameters_in.view();
                       return reference ? reference::power(m, t, out, o) : power(m, t, out, o);
                   }});
    for (const bool long_way : {false, true})
        all.push_back({long_way ? "sclerp/long_way" : "sclerp",
                       {.long_way = long_way},
                       [](W& w) {
                           return buffers<T>{&w.motors_in, &w.other_motors_in, &w.parameters_in};
                       },
                       motor_out<T>,
                       [](W& w, O o, bool reference) {
                           const auto a = w.motors_in.view(), b = w.other_motors_in.view(),
                                      out = w.motors_out.view();
                           const auto t = w.parameters_in.view();
                           return reference ? reference::sclerp(a, b, t, out, o) : sclerp(a, b, t, out, o);
                       }});
    all.push_back({"sclerp/for_all", {}, two<T>, motor_out<T>, [](W& w, O o, bool reference) {
                       const auto a = w.motors_in.view(), b = w.other_motors_in.view(),
                                  out = w.motors_out.view();
                       return reference ? reference::sclerp(a, b, T(0.3), out, o)
                                        : sclerp(a, b, T(0.3), out, o);
                   }});
    all.push_back(
        {"blend",
         {},
         [](W& w) {
             return buffers<T>{&w.motors_in, &w.other_motors_in, &w.parameters_in, &w.other_parameters_in};
         },
         motor_out<T>,
         [](W& w, O o, bool reference) {
             const motor_view<const T> motors[] = {w.motors_in.view(), w.other_motors_in.view(),
                                                   w.motors_in.view()};
             const parameter<T> weights[] = {w.parameters_in.view(), w.other_parameters_in.view(), T(0.25)};
             const auto out = w.motors_out.view();
             return reference ? reference::blend(motors, weights, out, o) : blend(motors, weights, out, o);
         }});
    const std::pair<const char*, std::function<twist_axis<T>(W&)>> axes[] = {
        {"/x", [](W&) { return twist_axis<T>(axis::x); }},
        {"/y", [](W&) { return twist_axis<T>(axis::y); }},
        {"/uniform", [](W& w) { return twist_axis<T>(w.axis_for_all); }},
        {"/per_element", [](W& w) { return twist_axis<T>(w.axes.view()); }}};
    for (const auto& [name, make_axis] : axes)
        for (const product order : {product::swing_twist, product::twist_swing}) {
            const auto make = make_axis;
            const bool per_element = std::string(name) == "/per_element";
            all.push_back(
                {std::string("motor decompose") + name + (order == product::swing_twist ? " S T" : " T R"),
                 {.order = order, .positive_twist = order == product::twist_swing},
                 [per_element](W& w) {
                     buffers<T> reads{&w.motors_in};
                     if (per_element) reads.push_back(&w.axes);
                     return reads;
                 },
                 [](W& w) {
                     return buffers<T>{&w.swing, &w.twist, &w.vectors_out};
                 },
                 [make](W& w, O o, bool reference) {
                     const auto m = w.motors_in.view();
                     const auto s = w.swing.view(), t = w.twist.view();
                     const auto moves = w.vectors_out.view();
                     return reference ? reference::decompose(m, make(w), s, t, moves, o)
                                      : decompose(m, make(w), s, t, moves, o);
                 }});
        }
    for (const product order : {product::swing_twist, product::twist_swing})
        all.push_back({"motor compose",
                       {.order = order},
                       [](W& w) {
                           return buffers<T>{&w.swing_in, &w.twist_in, &w.vectors};
                       },
                       motor_out<T>,
                       [](W& w, O o, bool reference) {
                           const auto s = w.swing_in.view(), t = w.twist_in.view();
                           const auto moves = w.vectors.view();
                           const auto out = w.motors_out.view();
                           return reference ? reference::compose(s, t, moves, out, o)
                                            : compose(s, t, moves, out, o);
                       }});
}

template void add_motors(std::vector<operation<float>>&);
template void add_motors(std::vector<operation<double>>&);

}  // namespace swivel::tests
