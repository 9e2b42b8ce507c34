#ifndef SWIVEL_OPERATIONS_DESCRIBE_HPP
#define SWIVEL_OPERATIONS_DESCRIBE_HPP

// Words for the descriptions of the families.

#include "operations/operation.hpp"

namespace swivel::operations {

inline group quaternion(std::string prefix) { return {group_kind::quaternion, std::move(prefix)}; }
inline group vector(std::string prefix, meaning m = meaning::any) {
    return {group_kind::vector, std::move(prefix), m};
}
inline group motor(std::string prefix) { return {group_kind::motor, std::move(prefix)}; }
inline group conformal(std::string prefix) { return {group_kind::conformal, std::move(prefix)}; }
inline group bivector(std::string prefix) { return {group_kind::bivector, std::move(prefix)}; }
inline group matrix(std::string prefix) { return {group_kind::matrix, std::move(prefix)}; }
inline group scalar(std::string name, meaning m = meaning::any) {
    return {group_kind::scalar, std::move(name), m};
}
inline group factors() { return {group_kind::factors, ""}; }
inline group spinor() { return {group_kind::spinor, ""}; }

// call(function, settings, in, out) calls the function, which is the library's or the reference's.
template <class Function, class Call, class T>
status run(const settings& s, const block<const T>& in, const block<T>& out) {
    return Call{}(Function{}, s, in, out);
}

template <class Function, class Call>
constexpr calls calls_of() {
    return {run<Function, Call, float>, run<Function, Call, double>};
}

template <class Library, class Reference, class Call>
operation describe(const char* name, const char* description, const char* help, std::vector<option> options,
                   groups (*groups_of)(const settings&), Library, Reference, Call) {
    return {name,
            description,
            help,
            std::move(options),
            groups_of,
            calls_of<Library, Call>(),
            calls_of<Reference, Call>()};
}

inline bool is_column(const axis_setting& a) { return std::holds_alternative<column>(a); }
inline bool is_column(const parameter_setting& p) { return std::holds_alternative<column>(p); }

// With --axis columns, the axes too.
inline groups with_axis(groups g, const settings& s) {
    if (is_column(s.axis)) g.in.push_back(vector("a", meaning::axis));
    return g;
}

// With --t column, the column t too.
inline groups with_t(groups g, const settings& s) {
    if (is_column(s.t)) g.in.push_back(scalar("t"));
    return g;
}

// The axis, or where it is in columns the vectors of the group.
template <class T>
twist_axis<T> axis_of(const settings& s, const block<const T>& in, std::size_t group) {
    if (const auto* const v = std::get_if<axis_vector>(&s.axis)) {
        if constexpr (std::is_same_v<T, float>)
            return v->f32;
        else
            return v->f64;
    }
    if (const auto* const coordinate = std::get_if<swivel::axis>(&s.axis)) return *coordinate;
    return in.vector(group);
}

// The parameter, or where it is a column the scalars of the group.
template <class T>
parameter<T> parameter_of(const parameter_setting& p, const block<const T>& in, std::size_t group) {
    if (const number* const n = std::get_if<number>(&p)) return n->as<T>();
    return in.scalar(group);
}

}  // namespace swivel::operations

#endif
