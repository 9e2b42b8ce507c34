#include "swivel/sincos.hpp"

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const scalar_view<const T>& radians, const scalar_view<T>& sine, const scalar_view<T>& cosine,
                const options& o) noexcept {
    return run(
        active_operations<T>().sincos[index_of(o.accuracy)], [&](batch<T>&) { return check(o); },
        std::tuple(group_of(radians)), std::tuple(group_of(sine), group_of(cosine)));
}

}  // namespace

status sincos(const scalar_view<const float>& radians, const scalar_view<float>& sine,
              const scalar_view<float>& cosine, options o) noexcept {
    return any_type<float>(radians, sine, cosine, o);
}
status sincos(const scalar_view<const double>& radians, const scalar_view<double>& sine,
              const scalar_view<double>& cosine, options o) noexcept {
    return any_type<double>(radians, sine, cosine, o);
}

}  // namespace swivel
