#include "support/operations.hpp"

#include "support/conformal.hpp"

namespace swivel::tests {

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
      out(n, l),
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
        swing_in.set(i, random_rotation<T>(g));
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

template struct workspace<float>;
template struct workspace<double>;

}  // namespace swivel::tests
