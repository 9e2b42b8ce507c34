#include "support/row.hpp"
#include "swivel/reference.hpp"

namespace swivel_bench {

namespace {

template <class T>
void add_all() {
    add_library_rows<T>("conformal_square_root", [](workload<T>& streams, swivel::options o) {
        const auto r = streams.rotors();
        const auto out = streams.written_rotors();
        const auto unique = streams.scalars();
        return [=] { return swivel::square_root(r, out, unique, o); };
    });
    add_library_rows<T>("conformal_multiply", [](workload<T>& streams, swivel::options o) {
        const auto a = streams.rotors(), b = streams.rotors();
        const auto out = streams.written_rotors();
        return [=] { return swivel::multiply(a, b, out, o); };
    });
    add_library_rows<T>("conformal_power", [](workload<T>& streams, swivel::options o) {
        const auto r = streams.rotors();
        const auto out = streams.written_rotors();
        const auto unique = streams.scalars();
        return [=] { return swivel::power(r, T(0.3), out, unique, o); };
    });
    // Scalar code written from the formulas; there is no other library in C++ to compare with here.
    add_rows<T>("conformal_square_root", "reference", layout::soa, [](workload<T>& streams) {
        const auto r = streams.rotors();
        const auto out = streams.written_rotors();
        const auto unique = streams.scalars();
        return [=] { (void)swivel::reference::square_root(r, out, unique); };
    });
}

}  // namespace

void add_conformal_rows() {
    add_all<float>();
    add_all<double>();
}

}  // namespace swivel_bench
