#include "swivel/sincos.hpp"

#include "kernels/angles/tables.hpp"
#include "src/call/call.hpp"

namespace swivel {

namespace {

template <class T>
status any_type(const scalar_view<const T>& radians, const scalar_view<T>& sine, const scalar_view<T>& cosine,
                const options& o) noexcept {
    call<T> c(radians.size, o);
    c.read(radians);
    c.write(sine);
    c.write(cosine);
    return c.template run<sincos_kernels>(index_of(o.accuracy));
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
