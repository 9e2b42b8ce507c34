#include "support/operations.hpp"

namespace swivel::tests {

namespace {

template <class T>
parameter<T> one_for_all() {
    return T(0.3);
}

template <class T>
buffers<T> result(workspace<T>& w) {
    return {&w.out};
}

// What the parameters are made from; `reads` is what that adds to what is read.
template <class T>
struct parameter_case {
    const char* name;
    std::function<parameter<T>(workspace<T>&)> swing, twist;
    buffers<T> (*reads)(workspace<T>&);
};

template <class T>
std::vector<parameter_case<T>> parameter_cases() {
    return {{"", [](workspace<T>&) { return one_for_all<T>(); },
             [](workspace<T>&) { return one_for_all<T>(); }, [](workspace<T>&) { return buffers<T>{}; }},
            {"/t", [](workspace<T>& w) { return parameter<T>(w.parameters_in.view()); },
             [](workspace<T>& w) { return parameter<T>(w.other_parameters_in.view()); },
             [](workspace<T>& w) {
                 return buffers<T>{&w.parameters_in, &w.other_parameters_in};
             }}};
}

}  // namespace

template <class T>
void add_interpolation(std::vector<operation<T>>& all) {
    for (const bool long_way : {false, true})
        for (const parameter_case<T>& t : parameter_cases<T>()) {
            const std::string suffix = (long_way ? "/long_way" : "") + std::string(t.name);
            const auto reads = [t](workspace<T>& w) {
                buffers<T> r{&w.swing_in, &w.twist_in};
                const buffers<T> parameters = t.reads(w);
                if (!parameters.empty()) r.push_back(parameters[0]);
                return r;
            };
            all.push_back({"slerp" + suffix,
                           {.long_way = long_way},
                           reads,
                           result<T>,
                           [t](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::slerp(w.swing_in.view(), w.twist_in.view(),
                                                                   t.swing(w), w.out.view(), set)
                                                : slerp(w.swing_in.view(), w.twist_in.view(), t.swing(w),
                                                        w.out.view(), set);
                           }});
            all.push_back({"nlerp" + suffix,
                           {.long_way = long_way},
                           reads,
                           result<T>,
                           [t](workspace<T>& w, const options& set, bool reference) {
                               return reference ? reference::nlerp(w.swing_in.view(), w.twist_in.view(),
                                                                   t.swing(w), w.out.view(), set)
                                                : nlerp(w.swing_in.view(), w.twist_in.view(), t.swing(w),
                                                        w.out.view(), set);
                           }});
            for (const frame in : {frame::world, frame::body})
                for (const flavour motion : {flavour::slerp, flavour::nlerp})
                    for (const bool own_axis : {false, true}) {
                        const auto axis = [own_axis](workspace<T>& w) {
                            return own_axis ? twist_axis<T>(w.axes.view()) : twist_axis<T>(w.axis_for_all);
                        };
                        const auto reads_all = [t, own_axis](workspace<T>& w) {
                            buffers<T> r{&w.swing_in, &w.twist_in};
                            if (own_axis) r.push_back(&w.axes);
                            for (any_buffer<T>* b : t.reads(w)) r.push_back(b);
                            return r;
                        };
                        all.push_back(
                            {"sterp" + suffix + (in == frame::body ? "/body" : "") +
                                 (motion == flavour::nlerp ? "/nlerp" : "") + (own_axis ? "/own_axis" : ""),
                             {.long_way = long_way, .axis_frame = in, .motion = motion},
                             reads_all,
                             result<T>,
                             [t, axis](workspace<T>& w, const options& set, bool reference) {
                                 return reference
                                            ? reference::sterp(w.swing_in.view(), w.twist_in.view(), axis(w),
                                                               t.swing(w), t.twist(w), w.out.view(), set)
                                            : sterp(w.swing_in.view(), w.twist_in.view(), axis(w), t.swing(w),
                                                    t.twist(w), w.out.view(), set);
                             }});
                    }
        }
    all.push_back({"sterp/x",
                   {},
                   [](workspace<T>& w) {
                       return buffers<T>{&w.swing_in, &w.twist_in};
                   },
                   result<T>,
                   [](workspace<T>& w, const options& set, bool reference) {
                       return reference ? reference::sterp(w.swing_in.view(), w.twist_in.view(), axis::x,
                                                           parameter<T>(T(0.7)), w.out.view(), set)
                                        : sterp(w.swing_in.view(), w.twist_in.view(), axis::x,
                                                parameter<T>(T(0.7)), w.out.view(), set);
                   }});
}

template void add_interpolation(std::vector<operation<float>>&);
template void add_interpolation(std::vector<operation<double>>&);

}  // namespace swivel::tests
