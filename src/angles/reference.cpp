#include "swivel/reference.hpp"

#include "src/reference/elements.hpp"
#include "src/reference/scalar.hpp"

// sincos and atan2.

namespace swivel::reference {

namespace {

template <class T>
status sincos_all(const scalar_view<const T>& radians, const scalar_view<T>& sine,
                  const scalar_view<T>& cosine, const options& o) {
    return for_each<T>(o, std::tuple(radians), std::tuple(sine, cosine), [&](std::size_t i) {
        const sine_cosine<T> h = sincos_of(read(radians, i));
        write(sine, i, h.sine);
        write(cosine, i, h.cosine);
    });
}

template <class T>
status atan2_all(const scalar_view<const T>& y, const scalar_view<const T>& x, const scalar_view<T>& radians,
                 const options& o) {
    return for_each<T>(o, std::tuple(y, x), std::tuple(radians), [&](std::size_t i) {
        const T poison = T(0) * read(y, i) + T(0) * read(x, i);
        write(radians, i, poison == 0 ? atan2_of(read(y, i), read(x, i)) : poison);
    });
}

}  // namespace

status sincos(const scalar_view<const float>& radians, const scalar_view<float>& sine,
              const scalar_view<float>& cosine, options o) noexcept {
    return sincos_all<float>(radians, sine, cosine, o);
}
status sincos(const scalar_view<const double>& radians, const scalar_view<double>& sine,
              const scalar_view<double>& cosine, options o) noexcept {
    return sincos_all<double>(radians, sine, cosine, o);
}
status atan2(const scalar_view<const float>& y, const scalar_view<const float>& x,
             const scalar_view<float>& radians, options o) noexcept {
    return atan2_all<float>(y, x, radians, o);
}
status atan2(const scalar_view<const double>& y, const scalar_view<const double>& x,
             const scalar_view<double>& radians, options o) noexcept {
    return atan2_all<double>(y, x, radians, o);
}

}  // namespace swivel::reference
