#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/support/row.hpp"
#include "operations/operation.hpp"

// Every operation of operations/ on each usable ISA, in both layouts, types and precisions, and its reference. One row
// is called as the operation; others, that differ in what one of its options says, are called after that too.

namespace swivel_bench {

namespace {

using swivel::operations::group;
using swivel::operations::group_kind;
using swivel::operations::meaning;
using swivel::operations::option;
using swivel::operations::settings;

// As the peers take it.
constexpr swivel::operations::axis_vector oblique_axis{{2.0F / 7, -3.0F / 7, 6.0F / 7},
                                                       {2.0 / 7, -3.0 / 7, 6.0 / 7}};
constexpr swivel::operations::number part{0.3F, 0.3}, radians{0.7F, 0.7};

void set_usual(settings& s, option which) {
    switch (which) {
        case option::axis:
        case option::axis_of_ends:
            s.axis = oblique_axis;
            break;
        case option::exponent:
            s.t = part;
            break;
        case option::t:
            s.t = swivel::operations::column{};
            break;
        case option::angle:
            s.angle = radians;
            break;
        case option::euler_order:
            s.euler = swivel::euler_order::zxy;
            break;
        default:
            break;
    }
}

struct form {
    const char* suffix;
    void (*set)(settings&);
};

std::vector<form> other_forms(option which) {
    switch (which) {
        case option::axis:
            return {{"_z", [](settings& s) { s.axis = swivel::axis::z; }},
                    {"_per_element", [](settings& s) { s.axis = swivel::operations::column{}; }}};
        case option::form:
        case option::form_read:
            return {{"_compact", [](settings& s) {
                         s.axis = swivel::axis::z;
                         s.form = swivel::operations::factor_form::compact;
                     }}};
        case option::t:
            return {{"_one", [](settings& s) { s.t = part; }}};
        case option::motion:
            return {{"_nlerp", [](settings& s) { s.options.motion = swivel::flavour::nlerp; }}};
        case option::motors:
            return {{"_4", [](settings& s) { s.motors = 4; }}};
        case option::by:
            // A half turn about an oblique axis.
            return {{"_by_one", [](settings& s) {
                         s.by = {{oblique_axis.f32.x, oblique_axis.f32.y, oblique_axis.f32.z, 0},
                                 {oblique_axis.f64.x, oblique_axis.f64.y, oblique_axis.f64.z, 0}};
                     }}};
        case option::sequence:
            return {{"_sequence", [](settings& s) { s.sequence = true; }}};
        default:
            return {};
    }
}

struct library_row {
    std::string name;
    const swivel::operations::operation* operation;
    settings set;
    data d = data::ordinary;
};

std::vector<library_row> rows_of(const swivel::operations::operation& o) {
    settings usual;
    for (const option which : o.options) set_usual(usual, which);
    std::vector<library_row> rows{{o.name, &o, usual},
                                  {std::string(o.name) + "/still", &o, usual, data::still}};
    for (const option which : o.options)
        for (const form& f : other_forms(which)) {
            rows.push_back({o.name + std::string(f.suffix), &o, usual});
            f.set(rows.back().set);
        }
    return rows;
}

template <class T>
using block = swivel::operations::block<T>;

template <class T>
void add(block<T>& to, const swivel::quat_view<T>& v) {
    to.add(std::vector{v.x, v.y, v.z, v.w}, v.stride);
}
template <class T>
void add(block<T>& to, const swivel::vec3_view<T>& v) {
    to.add(std::vector{v.x, v.y, v.z}, v.stride);
}
template <class T>
void add(block<T>& to, const swivel::factor_view<T>& v) {
    to.add(std::vector{v.s1, v.s2, v.sc, v.ts, v.tc}, 1);
}
template <class T>
void add(block<T>& to, const swivel::matrix_view<T>& v) {
    to.add(std::vector{v.xx, v.xy, v.xz, v.yx, v.yy, v.yz, v.zx, v.zy, v.zz}, v.stride);
}
template <class T>
void add(block<T>& to, const swivel::motor_view<T>& v) {
    to.add(std::vector{v.x, v.y, v.z, v.w, v.dx, v.dy, v.dz, v.dw}, v.stride);
}
template <class T>
void add(block<T>& to, const swivel::conformal_view<T>& v) {
    to.add(v.blade, v.stride);
}
template <class T>
void add(block<T>& to, const swivel::bivector_view<T>& v) {
    to.add(v.blade, v.stride);
}
template <class T>
void add(block<T>& to, const swivel::spinor_view<T>& v) {
    to.add(std::vector{v.a, v.b, v.c, v.d}, v.stride);
}
template <class T>
void add(block<T>& to, const swivel::scalar_view<T>& v) {
    to.add(std::vector{v.data}, v.stride);
}

// How many groups of a kind have been taken: those after the first are filled with other numbers.
struct taken {
    std::size_t rotations = 0, motors = 0, vectors = 0;
};

template <class T>
void take_input(workload<T>& streams, const group& g, taken& before, block<const T>& in) {
    switch (g.kind) {
        case group_kind::quaternion:
            return add(in, before.rotations++ == 0 ? streams.rotations() : streams.other_rotations());
        case group_kind::vector:
            if (g.meaning == meaning::logarithm) return add(in, streams.logarithms());
            return add(in, before.vectors++ == 0 ? streams.axes() : streams.other_axes());
        case group_kind::factors:
            return add(in, streams.factors());
        case group_kind::matrix:
            return add(in, streams.matrices());
        case group_kind::motor:
            return add(in, streams.motors(before.motors++));
        case group_kind::conformal:
            return add(in, streams.rotors());
        case group_kind::bivector:
            return add(in, streams.bivectors());
        case group_kind::spinor:
            return add(in, streams.spinors());
        case group_kind::scalar:
            return add(in, streams.parameters());
    }
}

template <class T>
void take_output(workload<T>& streams, const group& g, block<T>& out) {
    switch (g.kind) {
        case group_kind::quaternion:
            return add(out, streams.quaternions());
        case group_kind::vector:
            return add(out, streams.vectors());
        case group_kind::factors:
            return add(out, streams.written_factors());
        case group_kind::matrix:
            return add(out, streams.written_matrices());
        case group_kind::motor:
            return add(out, streams.written_motors());
        case group_kind::conformal:
            return add(out, streams.written_rotors());
        case group_kind::bivector:
            return add(out, streams.written_bivectors());
        case group_kind::spinor:
            return add(out, streams.written_spinors());
        case group_kind::scalar:
            return add(out, streams.scalars());
    }
}

// Those that fit in the memory of the rows.
constexpr std::size_t most_bytes = std::size_t{5} << 28;

template <class T>
void add_sizes(const library_row& row, std::string_view op, std::string_view who, layout l,
               swivel::operations::function<T> function, settings set, swivel::isa which) {
    const swivel::operations::groups groups = row.operation->groups(set);
    const std::size_t count = swivel::operations::stream_names(groups.in).size() +
                              swivel::operations::stream_names(groups.out).size();
    const auto prepare = [groups, function, set, which](workload<T>& streams) {
        if (swivel::set_active_isa(which) != swivel::status::ok) std::abort();
        block<const T> in;
        block<T> out;
        taken before;
        for (const group& g : groups.in) take_input(streams, g, before, in);
        for (const group& g : groups.out) take_output(streams, g, out);
        in.resize(streams.size());
        out.resize(streams.size());
        if (function(set, in, out) != swivel::status::ok) std::abort();
        return [=] {
            auto result = function(set, in, out);
            benchmark::DoNotOptimize(result);
        };
    };
    for (const std::size_t n : sizes)
        if (n * count * sizeof(T) <= most_bytes) add_row<T>(op, who, l, n, prepare, row.d);
}

template <class T>
void add_all(const library_row& row) {
    for (const swivel::isa which : swivel::all_isas) {
        if (!swivel::is_usable(which)) continue;
        for (const layout l : {layout::soa, layout::aos})
            for (const swivel::precision p : {swivel::precision::fast, swivel::precision::reproducible}) {
                settings set = row.set;
                set.options.accuracy = p;
                // The precision stands with the operation's name, in front of /still.
                std::string op = row.name;
                if (p == swivel::precision::reproducible)
                    op.insert(std::min(op.find('/'), op.size()), "_reproducible");
                add_sizes<T>(row, op, swivel::name(which), l, row.operation->library.as<T>(), set, which);
            }
    }
    // Plain code from the formulas, one element after the other.
    add_sizes<T>(row, row.name, "reference", layout::soa, row.operation->reference.as<T>(), row.set,
                 swivel::active_isa());
}

}  // namespace

void add_library_rows() {
    for (const swivel::operations::operation* const o : swivel::operations::all())
        for (const library_row& row : rows_of(*o)) {
            add_all<float>(row);
            add_all<double>(row);
        }
}

}  // namespace swivel_bench
