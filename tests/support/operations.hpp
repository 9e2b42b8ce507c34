#ifndef SWIVEL_TESTS_SUPPORT_OPERATIONS_HPP
#define SWIVEL_TESTS_SUPPORT_OPERATIONS_HPP

#include <functional>
#include <string>
#include <vector>

#include "support/buffers.hpp"
#include "support/rotations.hpp"
#include "swivel/swivel.hpp"

namespace swivel::tests {

// Everything that any operation reads or writes.
template <class T>
struct workspace {
    quat_buffer<T> q, swing_in, twist_in;
    vec3_buffer<T> axes;
    factor_buffer<T> factors_in;
    scalar_buffer<T> signs_in;

    quat_buffer<T> out, swing, twist;
    factor_buffer<T> factors_out;
    scalar_buffer<T> scalars;

    vec3<T> axis_for_all{T(0.36), T(-0.48), T(1.6)};

    workspace(std::size_t n, layout l)
        : q(n, l),
          swing_in(n, l),
          twist_in(n, l),
          axes(n, l),
          factors_in(n),
          signs_in(n, l),
          out(n, l),
          swing(n, l),
          twist(n, l),
          factors_out(n),
          scalars(n, l) {}

    std::size_t size() const { return q.size(); }

    // Random rotations, every third one a corner, and factors that belong to them.
    void fill(generator& g) {
        const std::vector<quat<T>> corners = corner_rotations<T>();
        for (std::size_t i = 0; i < size(); ++i) {
            q.set(i, i % 3 == 2 ? corners[g() % corners.size()] : random_rotation<T>(g));
            const T length = static_cast<T>(std::ldexp(1.0, static_cast<int>(g() % 60) - 30));
            const vec3<T> a = random_direction<T>(g);
            axes.set(i, {a.x * length, a.y * length, a.z * length});
            swing_in.set(i, random_rotation<T>(g));
            twist_in.set(i, i % 3 == 2 ? corners[g() % corners.size()] : random_rotation<T>(g));
            const quat<T> f = random_rotation<T>(g);
            const double half = uniform(g, -3.2, 3.2);
            factors_in.set(i,
                           {f.x, f.y, f.w, static_cast<T>(std::sin(half)), static_cast<T>(std::cos(half))});
            signs_in[i] = g() % 2 != 0 ? T(1) : T(-1);
        }
    }

    // Every output component of element i.
    std::vector<T> outputs(std::size_t i) {
        std::vector<T> r;
        for (quat_buffer<T>* b : {&out, &swing, &twist})
            for (int c = 0; c < 4; ++c) r.push_back(b->at(c, i));
        for (int c = 0; c < 5; ++c) r.push_back(factors_out.at(c, i));
        r.push_back(scalars[i]);
        return r;
    }
};

template <class T>
struct operation {
    std::string name;
    options set;
    bool reads_q;         // else factors
    bool reads_own_axis;  // one for each element
    std::function<status(workspace<T>&, const options&, bool reference)> call;

    status run(workspace<T>& w, precision p) const {
        options o = set;
        o.accuracy = p;
        return call(w, o, false);
    }
    status run_reference(workspace<T>& w) const { return call(w, set, true); }
};

// Every public operation with every axis form, product, sign handling; each writes its own outputs of a
// workspace.
template <class T>
std::vector<operation<T>> all_operations() {
    std::vector<operation<T>> all;
    struct axis_case {
        const char* name;
        bool own;
        std::function<twist_axis<T>(workspace<T>&)> make;
    };
    const axis_case axes[] = {
        {"x", false, [](workspace<T>&) { return twist_axis<T>(axis::x); }},
        {"y", false, [](workspace<T>&) { return twist_axis<T>(axis::y); }},
        {"z", false, [](workspace<T>&) { return twist_axis<T>(axis::z); }},
        {"uniform", false, [](workspace<T>& w) { return twist_axis<T>(w.axis_for_all); }},
        {"per_element", true, [](workspace<T>& w) { return twist_axis<T>(w.axes.view()); }},
    };
    for (product order : {product::swing_twist, product::twist_swing}) {
        const std::string in_order = order == product::swing_twist ? "/swing_twist" : "/twist_swing";
        for (const axis_case& a : axes) {
            const auto make = a.make;
            const std::string suffix = std::string("/") + a.name + in_order;
            for (bool positive : {false, true}) {
                const options o{.order = order, .positive_twist = positive};
                const std::string sign = positive ? "/positive" : "";
                all.push_back({"decompose" + suffix + sign, o, true, a.own,
                               [make](workspace<T>& w, const options& set, bool reference) {
                                   return reference
                                              ? reference::decompose(w.q.view(), make(w), w.swing.view(),
                                                                     w.twist.view(), set)
                                              : decompose(w.q.view(), make(w), w.swing.view(), w.twist.view(),
                                                          set);
                               }});
                all.push_back({"twist" + suffix + sign, o, true, a.own,
                               [make](workspace<T>& w, const options& set, bool reference) {
                                   return reference ? reference::twist(w.q.view(), make(w), w.out.view(), set)
                                                    : twist(w.q.view(), make(w), w.out.view(), set);
                               }});
                all.push_back({"twist_angle" + suffix + sign, o, true, a.own,
                               [make](workspace<T>& w, const options& set, bool reference) {
                                   return reference ? reference::twist_angle(w.q.view(), make(w),
                                                                             w.scalars.view(), set)
                                                    : twist_angle(w.q.view(), make(w), w.scalars.view(), set);
                               }});
            }
            const options o{.order = order};
            all.push_back({"decompose" + suffix + "/signs", o, true, a.own,
                           [make](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::decompose(w.q.view(), make(w), w.swing.view(),
                                                                       w.twist.view(), w.scalars.view(), set)
                                                : decompose(w.q.view(), make(w), w.swing.view(),
                                                            w.twist.view(), w.scalars.view(), set);
                           }});
            all.push_back({"swing" + suffix, o, true, a.own,
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
                               true,
                               false,
                               [a](workspace<T>& w, const options& set, bool reference) {
                                   return reference
                                              ? reference::decompose(w.q.view(), a, w.factors_out.view(), set)
                                              : decompose(w.q.view(), a, w.factors_out.view(), set);
                               }});
            }
            all.push_back({"decompose_compact" + suffix + "/signs",
                           {.order = order},
                           true,
                           false,
                           [a](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::decompose(w.q.view(), a, w.factors_out.view(),
                                                                       w.scalars.view(), set)
                                                : decompose(w.q.view(), a, w.factors_out.view(),
                                                            w.scalars.view(), set);
                           }});
            all.push_back({"compose_compact" + suffix,
                           {.order = order},
                           false,
                           false,
                           [a](workspace<T>& w, const options& set, bool reference) {
                               return reference
                                          ? reference::compose(w.factors_in.view(), a, w.out.view(), set)
                                          : compose(w.factors_in.view(), a, w.out.view(), set);
                           }});
            all.push_back({"compose_compact" + suffix + "/signs",
                           {.order = order},
                           false,
                           false,
                           [a](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::compose(w.factors_in.view(), a,
                                                                     w.signs_in.view(), w.out.view(), set)
                                                : compose(w.factors_in.view(), a, w.signs_in.view(),
                                                          w.out.view(), set);
                           }});
        }
        all.push_back({"compose" + in_order,
                       {.order = order},
                       false,
                       false,
                       [](workspace<T>& w, const options& set, bool reference) {
                           return reference
                                      ? reference::compose(w.swing_in.view(), w.twist_in.view(), w.out.view(),
                                                           set)
                                      : compose(w.swing_in.view(), w.twist_in.view(), w.out.view(), set);
                       }});
        all.push_back({"compose" + in_order + "/signs",
                       {.order = order},
                       false,
                       false,
                       [](workspace<T>& w, const options& set, bool reference) {
                           return reference ? reference::compose(w.swing_in.view(), w.twist_in.view(),
                                                                 w.signs_in.view(), w.out.view(), set)
                                            : compose(w.swing_in.view(), w.twist_in.view(), w.signs_in.view(),
                                                      w.out.view(), set);
                       }});
    }
    return all;
}

}  // namespace swivel::tests

#endif
