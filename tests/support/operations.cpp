#include "support/operations.hpp"

#include <algorithm>

#include "support/conformal.hpp"

namespace swivel::tests {

namespace {

constexpr operations::axis_vector axis_for_all{{0.36F, -0.48F, 1.6F}, {0.36, -0.48, 1.6}};

}  // namespace

template <class T>
workspace<T>::workspace(std::size_t n, layout l)
    : q(n, l),
      swing_in(n, l),
      twist_in(n, l),
      axes(n, l),
      vectors(n, l),
      factors_in(n),
      matrices_in(n, l),
      motors_in(n, l),
      other_motors_in(n, l),
      rotors_in(n, l),
      other_rotors_in(n, l),
      bivectors_in(n, l),
      signs_in(n, l),
      angles_in(n, l),
      parameters_in(n, l),
      other_parameters_in(n, l),
      swing(n, l),
      twist(n, l),
      vectors_out(n, l),
      other_vectors_out(n, l),
      factors_out(n),
      matrices_out(n, l),
      motors_out(n, l),
      rotors_out(n, l),
      bivectors_out(n, l),
      other_bivectors_out(n, l),
      scalars(n, l),
      other_scalars(n, l) {}

template <class T>
void workspace<T>::fill(generator& g) {
    const std::vector<quat<T>> corners = corner_rotations<T>();
    const T parameters[] = {0,        1,       T(0.5), T(-0.0),
                            T(-0.25), T(1.25), 2,      std::numeric_limits<T>::denorm_min()};
    const T angles[] = {0,
                        T(-0.0),
                        T(1.5707963267948966),
                        T(3.1415926535897932),
                        std::numeric_limits<T>::denorm_min(),
                        std::numeric_limits<T>::min(),
                        T(8192),
                        T(-8192),
                        T(1e9),
                        std::numeric_limits<T>::max()};
    const auto any_of = [&](const auto& values) { return values[g() % std::size(values)]; };
    const auto any_length = [&] { return static_cast<T>(std::ldexp(1.0, static_cast<int>(g() % 60) - 30)); };
    for (std::size_t i = 0; i < size(); ++i) {
        const bool corner = i % 3 == 2;
        q.set(i, corner ? any_of(corners) : random_rotation<T>(g));
        for (vec3_buffer<T>* b : {&axes, &vectors}) {
            const T length = any_length();
            const vec3<T> a = random_direction<T>(g);
            b->set(i, {a.x * length, a.y * length, a.z * length});
        }
        swing_in.set(i, corner ? any_of(corners) : random_rotation<T>(g));
        twist_in.set(i, corner ? any_of(corners) : random_rotation<T>(g));
        const quat<T> f = random_rotation<T>(g);
        const double half = uniform(g, -3.2, 3.2);
        factors_in.set(i, {f.x, f.y, f.w, static_cast<T>(std::sin(half)), static_cast<T>(std::cos(half))});
        signs_in[i] = g() % 2 != 0 ? T(1) : T(-1);
        angles_in[i] = corner ? any_of(angles) : static_cast<T>(uniform(g, -20, 20));
        parameters_in[i] = corner ? any_of(parameters) : static_cast<T>(uniform(g, -0.5, 1.5));
        other_parameters_in[i] = corner ? any_of(parameters) : static_cast<T>(uniform(g, -0.5, 1.5));
        for (motor_buffer<T>* b : {&motors_in, &other_motors_in})
            b->set(i, corner ? corner_motor<T>(g, q.get(i)) : random_motor<T>(g, uniform(g, 0, 10)));
        const quat<T> r = random_rotation<T>(g);
        const T two(2);
        const T m[9] = {1 - two * (r.y * r.y + r.z * r.z), two * (r.x * r.y - r.w * r.z),
                        two * (r.x * r.z + r.w * r.y),     two * (r.x * r.y + r.w * r.z),
                        1 - two * (r.x * r.x + r.z * r.z), two * (r.y * r.z - r.w * r.x),
                        two * (r.x * r.z - r.w * r.y),     two * (r.y * r.z + r.w * r.x),
                        1 - two * (r.x * r.x + r.y * r.y)};
        for (int c = 0; c < 9; ++c) matrices_in.at(c, i) = m[c];
    }
    fill_conformal(g);
}

// From a generator of their own, so that the other numbers stay as they are.
template <class T>
void workspace<T>::fill_conformal(generator g) {
    struct sample {
        bivector<double> b;
        even<double> r;
    };
    // Made once: the series take long.
    static constexpr auto motions_of = [](const std::vector<bivector<double>>& all) {
        std::vector<sample> made;
        for (const bivector<double>& b : all) made.push_back({b, exact_exp(b)});
        return made;
    };
    static const std::vector<sample> corners = motions_of(corner_bivectors());
    static const std::vector<sample> regular = [] {
        generator own(31);
        std::vector<bivector<double>> all(211);
        for (bivector<double>& b : all) b = random_bivector(own);
        return motions_of(all);
    }();
    for (std::size_t i = 0; i < size(); ++i) {
        const sample& m = i % 3 == 2 ? corners[g() % corners.size()] : regular[g() % regular.size()];
        const sample& other = regular[g() % regular.size()];
        for (int c = 0; c < 10; ++c) bivectors_in.at(c, i) = static_cast<T>(m.b[static_cast<std::size_t>(c)]);
        for (int c = 0; c < 16; ++c) {
            rotors_in.at(c, i) = static_cast<T>(m.r[static_cast<std::size_t>(c)]);
            other_rotors_in.at(c, i) = static_cast<T>(other.r[static_cast<std::size_t>(c)]);
        }
    }
}

namespace {

using operations::group;
using operations::group_kind;
using operations::meaning;
using operations::option;
using operations::settings;

template <class T, auto member>
any_buffer<T>* buffer(workspace<T>& w) {
    return &(w.*member);
}

// The buffers of each kind, in the order in which groups take them.
template <class T>
struct buffers_by_kind {
    using those = std::vector<buffer_of<T>>;
    those rotations, vectors, axes, factors, matrices, motors, rotors, bivectors, scalars, angles, signs;

    those& of(const group& g) {
        switch (g.kind) {
            case group_kind::quaternion:
            case group_kind::spinor:
                return rotations;
            case group_kind::vector:
                return g.meaning == meaning::axis ? axes : vectors;
            case group_kind::factors:
                return factors;
            case group_kind::matrix:
                return matrices;
            case group_kind::motor:
                return motors;
            case group_kind::conformal:
                return rotors;
            case group_kind::bivector:
                return bivectors;
            case group_kind::scalar:
                break;
        }
        if (g.meaning == meaning::sign) return signs;
        return g.meaning == meaning::angle ? angles : scalars;
    }
};

template <class T>
std::vector<buffer_of<T>> taken(buffers_by_kind<T> from, const std::vector<group>& groups) {
    std::vector<buffer_of<T>> all;
    for (const group& g : groups) {
        std::vector<buffer_of<T>>& left = from.of(g);
        all.push_back(left.at(0));
        left.erase(left.begin());
    }
    return all;
}

template <class T>
std::vector<buffer_of<T>> buffers_read(const std::vector<group>& groups) {
    using W = workspace<T>;
    const auto rotations = std::count_if(groups.begin(), groups.end(), [](const group& g) {
        return g.kind == group_kind::quaternion || g.kind == group_kind::spinor;
    });
    buffers_by_kind<T> from{
        .rotations = {buffer<T, &W::swing_in>, buffer<T, &W::twist_in>},
        .vectors = {buffer<T, &W::vectors>, buffer<T, &W::axes>},
        .axes = {buffer<T, &W::axes>},
        .factors = {buffer<T, &W::factors_in>},
        .matrices = {buffer<T, &W::matrices_in>},
        .motors = {buffer<T, &W::motors_in>, buffer<T, &W::other_motors_in>, buffer<T, &W::motors_in>},
        .rotors = {buffer<T, &W::rotors_in>, buffer<T, &W::other_rotors_in>},
        .bivectors = {buffer<T, &W::bivectors_in>},
        .scalars = {buffer<T, &W::parameters_in>, buffer<T, &W::other_parameters_in>},
        .angles = {buffer<T, &W::angles_in>},
        .signs = {buffer<T, &W::signs_in>}};
    if (rotations == 1) from.rotations = {buffer<T, &W::q>};
    // The factor of a dilation is a number of any size, as an angle is.
    if (groups.size() == 1 && groups[0].prefix == "factor") from.scalars = from.angles;
    return taken(from, groups);
}

template <class T>
std::vector<buffer_of<T>> buffers_written(const std::vector<group>& groups) {
    using W = workspace<T>;
    return taken<T>({.rotations = {buffer<T, &W::swing>, buffer<T, &W::twist>},
                     .vectors = {buffer<T, &W::vectors_out>, buffer<T, &W::other_vectors_out>},
                     .axes = {},
                     .factors = {buffer<T, &W::factors_out>},
                     .matrices = {buffer<T, &W::matrices_out>},
                     .motors = {buffer<T, &W::motors_out>},
                     .rotors = {buffer<T, &W::rotors_out>},
                     .bivectors = {buffer<T, &W::bivectors_out>, buffer<T, &W::other_bivectors_out>},
                     .scalars = {buffer<T, &W::scalars>, buffer<T, &W::other_scalars>},
                     .angles = {buffer<T, &W::scalars>},
                     .signs = {buffer<T, &W::scalars>}},
                    groups);
}

template <class T>
operations::block<T> block_of(const buffers<T>& all, std::size_t size) {
    operations::block<T> block;
    for (any_buffer<T>* const b : all) {
        std::vector<T*> streams;
        for (int c = 0; c < b->components(); ++c) streams.push_back(b->first(c));
        block.add(streams, b->stride());
    }
    block.resize(size);
    return block;
}

template <class T>
status call(const operation<T>& op, const operations::calls& calls, const settings& set, workspace<T>& w) {
    const operations::block<T> in = block_of(op.reads(w), w.size());
    return calls.as<T>()(set, operations::block<const T>(in), block_of(op.writes(w), w.size()));
}

struct choice {
    const char* name;  // "" for what is not said
    void (*set)(settings&);
};

void nothing(settings&) {}

std::vector<choice> choices_of(option which) {
    switch (which) {
        case option::axis:
            return {{"", nothing},
                    {"x", [](settings& s) { s.axis = axis::x; }},
                    {"y", [](settings& s) { s.axis = axis::y; }},
                    {"uniform", [](settings& s) { s.axis = axis_for_all; }},
                    {"per_element", [](settings& s) { s.axis = operations::column{}; }}};
        case option::axis_of_compact:
            return {{"", nothing}, {"x", [](settings& s) { s.axis = axis::x; }}, {"y", [](settings& s) {
                                                                                      s.axis = axis::y;
                                                                                  }}};
        case option::axis_of_ends:
            return {{"x", [](settings& s) { s.axis = axis::x; }},
                    {"uniform", [](settings& s) { s.axis = axis_for_all; }},
                    {"per_element", [](settings& s) { s.axis = operations::column{}; }}};
        case option::product:
            return {{"", nothing},
                    {"twist_swing", [](settings& s) { s.options.order = product::twist_swing; }}};
        case option::form:
        case option::form_read:
            return {{"", nothing},
                    {"compact", [](settings& s) { s.form = operations::factor_form::compact; }}};
        case option::positive_twist:
            return {{"", nothing}, {"positive", [](settings& s) { s.options.positive_twist = true; }}};
        case option::signs:
        case option::signs_read:
            return {{"", nothing}, {"signs", [](settings& s) { s.signs = true; }}};
        case option::exponent:
        case option::t:
            return {{"",
                     [](settings& s) {
                         s.t = operations::number{0.3F, 0.3};
                     }},
                    {"t", [](settings& s) { s.t = operations::column{}; }}};
        case option::t_twist:
            return {{"", [](settings& s) {
                         if (std::holds_alternative<operations::column>(s.t))
                             s.t_twist = operations::column{};
                         else
                             s.t_twist = operations::number{0.7F, 0.7};
                     }}};
        case option::way:
            return {{"", nothing}, {"long_way", [](settings& s) { s.options.long_way = true; }}};
        case option::frame:
            return {{"", nothing}, {"body", [](settings& s) { s.options.axis_frame = frame::body; }}};
        case option::motion:
            return {{"", nothing}, {"nlerp", [](settings& s) { s.options.motion = flavour::nlerp; }}};
        case option::angle:
            return {{"",
                     [](settings& s) {
                         s.angle = operations::number{0.7F, 0.7};
                     }},
                    {"per_element", [](settings& s) { s.angle = operations::column{}; }}};
        case option::euler_order:
            return {{"", nothing},
                    {"xzy", [](settings& s) { s.euler = euler_order::xzy; }},
                    {"yxz", [](settings& s) { s.euler = euler_order::yxz; }},
                    {"yzx", [](settings& s) { s.euler = euler_order::yzx; }},
                    {"zxy", [](settings& s) { s.euler = euler_order::zxy; }},
                    {"zyx", [](settings& s) { s.euler = euler_order::zyx; }},
                    {"xyx", [](settings& s) { s.euler = euler_order::xyx; }},
                    {"xzx", [](settings& s) { s.euler = euler_order::xzx; }},
                    {"yxy", [](settings& s) { s.euler = euler_order::yxy; }},
                    {"yzy", [](settings& s) { s.euler = euler_order::yzy; }},
                    {"zxz", [](settings& s) { s.euler = euler_order::zxz; }},
                    {"zyz", [](settings& s) { s.euler = euler_order::zyz; }}};
        case option::weights:
            return {{"", nothing}, {"three", [](settings& s) {
                                        s.motors = 3;
                                        s.weights = {{0.5F, 0.5}, {0.3F, 0.3}, {0.25F, 0.25}};
                                    }}};
        case option::by:
            return {{"", nothing}, {"one_for_all", [](settings& s) {
                                        s.by = {{0.36F, -0.48F, 0.64F, 0.48F}, {0.36, -0.48, 0.64, 0.48}};
                                    }}};
        // The elements of a sequence depend on one another (align_signs_test.cpp), and a tip is no matter of the
        // library.
        case option::sequence:
        case option::tip:
        case option::tip_about:
        case option::motors:
        case option::pole_threshold:
            break;
    }
    return {{"", nothing}};
}

struct form {
    std::string name;
    settings set;
};

// All combinations of the choices.
std::vector<form> forms_of(const operations::operation& o) {
    std::vector<form> forms{{o.name, {}}};
    for (const option which : o.options) {
        std::vector<form> longer;
        for (const form& f : forms)
            for (const choice& c : choices_of(which)) {
                form next = f;
                if (*c.name != 0) next.name += std::string("/") + c.name;
                c.set(next.set);
                // Signs make the twist positive anyway.
                if (next.set.signs && next.set.options.positive_twist) continue;
                longer.push_back(std::move(next));
            }
        forms = std::move(longer);
    }
    std::erase_if(forms, [&](const form& f) { return !o.groups(f.set).fault.empty(); });
    return forms;
}

}  // namespace

template <class T>
status operation<T>::run(workspace<T>& w, precision p) const {
    settings with = set;
    with.options.accuracy = p;
    return call(*this, what->library, with, w);
}

template <class T>
status operation<T>::run_reference(workspace<T>& w) const {
    return call(*this, what->reference, set, w);
}

template <class T>
bool operation<T>::is_kept_sign(std::size_t output) const {
    for (const group& g : groups.out) {
        const std::size_t count = operations::stream_names(g).size();
        if (output < count) return g.meaning == meaning::sign;
        output -= count;
    }
    return false;
}

template <class T>
const std::vector<operation<T>>& all_operations() {
    static const std::vector<operation<T>> every = [] {
        std::vector<operation<T>> all;
        for (const operations::operation* const o : operations::all())
            for (const form& f : forms_of(*o)) {
                const operations::groups g = o->groups(f.set);
                all.push_back({f.name, o, f.set, g, buffers_read<T>(g.in), buffers_written<T>(g.out)});
            }
        return all;
    }();
    return every;
}

template struct workspace<float>;
template struct workspace<double>;
template struct operation<float>;
template struct operation<double>;
template const std::vector<operation<float>>& all_operations();
template const std::vector<operation<double>>& all_operations();

}  // namespace swivel::tests
