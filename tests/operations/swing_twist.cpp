#include "support/operations.hpp"

namespace swivel::tests {

namespace {

template <class T>
buffers<T> rotation(workspace<T>& w) {
    return {&w.q};
}
template <class T>
buffers<T> rotation_and_axis(workspace<T>& w) {
    return {&w.q, &w.axes};
}
template <class T>
buffers<T> compact_in(workspace<T>& w) {
    return {&w.factors_in};
}
template <class T>
buffers<T> compact_and_sign_in(workspace<T>& w) {
    return {&w.factors_in, &w.signs_in};
}
template <class T>
buffers<T> both_factors(workspace<T>& w) {
    return {&w.swing_in, &w.twist_in};
}
template <class T>
buffers<T> both_factors_and_sign(workspace<T>& w) {
    return {&w.swing_in, &w.twist_in, &w.signs_in};
}

template <class T>
buffers<T> factors(workspace<T>& w) {
    return {&w.swing, &w.twist};
}
template <class T>
buffers<T> factors_and_sign(workspace<T>& w) {
    return {&w.swing, &w.twist, &w.scalars};
}
template <class T>
buffers<T> compact(workspace<T>& w) {
    return {&w.factors_out};
}
template <class T>
buffers<T> compact_and_sign(workspace<T>& w) {
    return {&w.factors_out, &w.scalars};
}
template <class T>
buffers<T> result(workspace<T>& w) {
    return {&w.out};
}
template <class T>
buffers<T> angle(workspace<T>& w) {
    return {&w.scalars};
}

}  // namespace

template <class T>
void add_swing_twist(std::vector<operation<T>>& all) {
    struct axis_case {
        const char* name;
        std::function<twist_axis<T>(workspace<T>&)> make;
        std::function<buffers<T>(workspace<T>&)> reads;
    };
    const axis_case axes[] = {
        {"x", [](workspace<T>&) { return twist_axis<T>(axis::x); }, rotation<T>},
        {"y", [](workspace<T>&) { return twist_axis<T>(axis::y); }, rotation<T>},
        {"z", [](workspace<T>&) { return twist_axis<T>(axis::z); }, rotation<T>},
        {"uniform", [](workspace<T>& w) { return twist_axis<T>(w.axis_for_all); }, rotation<T>},
        {"per_element", [](workspace<T>& w) { return twist_axis<T>(w.axes.view()); }, rotation_and_axis<T>},
    };
    for (product order : {product::swing_twist, product::twist_swing}) {
        const std::string in_order = order == product::swing_twist ? "/swing_twist" : "/twist_swing";
        for (const axis_case& a : axes) {
            const auto make = a.make;
            const std::string suffix = std::string("/") + a.name + in_order;
            for (bool positive : {false, true}) {
                const options o{.order = order, .positive_twist = positive};
                const std::string sign = positive ? "/positive" : "";
                all.push_back({"decompose" + suffix + sign, o, a.reads, factors<T>,
                               [make](workspace<T>& w, const options& set, bool reference) {
                                   return reference
                                              ? reference::decompose(w.q.view(), make(w), w.swing.view(),
                                                                     w.twist.view(), set)
                                              : decompose(w.q.view(), make(w), w.swing.view(), w.twist.view(),
                                                          set);
                               }});
                all.push_back({"twist" + suffix + sign, o, a.reads, result<T>,
                               [make](workspace<T>& w, const options& set, bool reference) {
                                   return reference ? reference::twist(w.q.view(), make(w), w.out.view(), set)
                                                    : twist(w.q.view(), make(w), w.out.view(), set);
                               }});
                all.push_back({"twist_angle" + suffix + sign, o, a.reads, angle<T>,
                               [make](workspace<T>& w, const options& set, bool reference) {
                                   return reference ? reference::twist_angle(w.q.view(), make(w),
                                                                             w.scalars.view(), set)
                                                    : twist_angle(w.q.view(), make(w), w.scalars.view(), set);
                               }});
            }
            const options o{.order = order};
            all.push_back({"decompose" + suffix + "/signs", o, a.reads, factors_and_sign<T>,
                           [make](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::decompose(w.q.view(), make(w), w.swing.view(),
                                                                       w.twist.view(), w.scalars.view(), set)
                                                : decompose(w.q.view(), make(w), w.swing.view(),
                                                            w.twist.view(), w.scalars.view(), set);
                           },
                           true});
            all.push_back({"swing" + suffix, o, a.reads, result<T>,
                           [make](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::swing(w.q.view(), make(w), w.out.view(), set)
                                                : swing(w.q.view(), make(w), w.out.view(), set);
                           }});
        }
        for (axis a : {axis::x, axis::y, axis::z}) {
            const std::string suffix = std::string("/") + "xyz"[static_cast<int>(a)] + in_order;
            for (bool positive : {false, true}) {
                all.push_back({"decompose_compact" + suffix + (positive ? "/positive" : ""),
                               {.order = order, .positive_twist = positive},
                               rotation<T>,
                               compact<T>,
                               [a](workspace<T>& w, const options& set, bool reference) {
                                   return reference
                                              ? reference::decompose(w.q.view(), a, w.factors_out.view(), set)
                                              : decompose(w.q.view(), a, w.factors_out.view(), set);
                               }});
            }
            all.push_back({"decompose_compact" + suffix + "/signs",
                           {.order = order},
                           rotation<T>,
                           compact_and_sign<T>,
                           [a](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::decompose(w.q.view(), a, w.factors_out.view(),
                                                                       w.scalars.view(), set)
                                                : decompose(w.q.view(), a, w.factors_out.view(),
                                                            w.scalars.view(), set);
                           },
                           true});
            all.push_back({"compose_compact" + suffix,
                           {.order = order},
                           compact_in<T>,
                           result<T>,
                           [a](workspace<T>& w, const options& set, bool reference) {
                               return reference
                                          ? reference::compose(w.factors_in.view(), a, w.out.view(), set)
                                          : compose(w.factors_in.view(), a, w.out.view(), set);
                           }});
            all.push_back({"compose_compact" + suffix + "/signs",
                           {.order = order},
                           compact_and_sign_in<T>,
                           result<T>,
                           [a](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::compose(w.factors_in.view(), a,
                                                                     w.signs_in.view(), w.out.view(), set)
                                                : compose(w.factors_in.view(), a, w.signs_in.view(),
                                                          w.out.view(), set);
                           }});
        }
        all.push_back({"compose" + in_order,
                       {.order = order},
                       both_factors<T>,
                       result<T>,
                       [](workspace<T>& w, const options& set, bool reference) {
                           return reference
                                      ? reference::compose(w.swing_in.view(), w.twist_in.view(), w.out.view(),
                                                           set)
                                      : compose(w.swing_in.view(), w.twist_in.view(), w.out.view(), set);
                       }});
        all.push_back({"compose" + in_order + "/signs",
                       {.order = order},
                       both_factors_and_sign<T>,
                       result<T>,
                       [](workspace<T>& w, const options& set, bool reference) {
                           return reference ? reference::compose(w.swing_in.view(), w.twist_in.view(),
                                                                 w.signs_in.view(), w.out.view(), set)
                                            : compose(w.swing_in.view(), w.twist_in.view(), w.signs_in.view(),
                                                      w.out.view(), set);
                       }});
    }
}

template void add_swing_twist(std::vector<operation<float>>&);
template void add_swing_twist(std::vector<operation<double>>&);

}  // namespace swivel::tests
