#include "swivel/align_signs.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "kernels/rotors/tables.hpp"
#include "src/call/call.hpp"
#include "src/reference/elements.hpp"
#include "swivel/dot.hpp"

namespace swivel {

namespace {

using reference::element;
using reference::read;
using reference::write;

template <class T>
status with_neighbour(const quat_view<const T>& q, const quat_view<const T>& neighbour,
                      const quat_view<T>& out, const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.read(neighbour);
    c.write(out);
    return c.template run<align_signs_kernels>(index_of(o.accuracy));
}

template <class T>
quat_view<const T> part(const quat_view<const T>& q, std::size_t first, std::size_t size) noexcept {
    return {element(q.x, first, q.stride),
            element(q.y, first, q.stride),
            element(q.z, first, q.stride),
            element(q.w, first, q.stride),
            size,
            q.stride};
}

// Signs as bits: which of them change is as good as random, and a branch would often be guessed wrong.
template <class T>
using bits_of = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

template <class T>
bits_of<T> sign_bit(T a) noexcept {
    return std::bit_cast<bits_of<T>>(a) & std::bit_cast<bits_of<T>>(T(-0.0));
}

template <class T>
T exchange_sign(T a, bits_of<T> sign) noexcept {
    return std::bit_cast<T>(std::bit_cast<bits_of<T>>(a) ^ sign);
}

template <class T>
bool is_finite(const quat<T>& q) noexcept {
    return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w);
}

template <class T>
bool is_opposite(const quat<T>& a, const quat<T>& b, const options& o) noexcept {
    T product;
    (void)dot(quat_view<const T>{&a.x, &a.y, &a.z, &a.w, 1}, quat_view<const T>{&b.x, &b.y, &b.z, &b.w, 1},
              scalar_view<T>{&product, 1}, o);
    return product < 0;
}

// What depends on the element before is one bit, turned over or not; the products of neighbours as they came
// in do not, and are made in batches.
template <class T>
status along_sequence(const quat_view<const T>& q, const quat_view<T>& out, const options& o) noexcept {
    call<T> c(q.size, o);
    c.read(q);
    c.write(out);
    if (const status bad = c.check_all(); bad != status::ok || q.size == 0) return bad;

    constexpr std::size_t block = 256;
    T products[block];  // of each element of a block and the one before it
    quat<T> before{}, last_finite{};
    bits_of<T> turned = 0;
    for (std::size_t done = 0; done < q.size; done += block) {
        const std::size_t count = q.size - done < block ? q.size - done : block;
        // In place, the one before the block is no longer as it came in. A product of 0 has it looked at by
        // itself.
        products[0] = 0;
        if (count > 1)
            (void)dot(part(q, done + 1, count - 1), part(q, done, count - 1),
                      scalar_view<T>{products + 1, count - 1}, o);
        for (std::size_t k = 0; k < count; ++k) {
            const quat<T> e = read(q, done + k);
            if (products[k] > 0 || products[k] < 0) [[likely]] {
                turned ^= sign_bit(products[k]);
            } else {
                if (is_finite(before)) last_finite = before;
                turned = is_opposite(e, last_finite, o) ? sign_bit(T(-0.0)) : 0;
            }
            before = {exchange_sign(e.x, turned), exchange_sign(e.y, turned), exchange_sign(e.z, turned),
                      exchange_sign(e.w, turned)};
            write(out, done + k, before);
        }
    }
    return status::ok;
}

}  // namespace

status align_signs(const quat_view<const float>& q, const quat_view<const float>& neighbour,
                   const quat_view<float>& out, options o) noexcept {
    return with_neighbour<float>(q, neighbour, out, o);
}
status align_signs(const quat_view<const double>& q, const quat_view<const double>& neighbour,
                   const quat_view<double>& out, options o) noexcept {
    return with_neighbour<double>(q, neighbour, out, o);
}
status align_signs(const quat_view<const float>& q, const quat_view<float>& out, options o) noexcept {
    return along_sequence<float>(q, out, o);
}
status align_signs(const quat_view<const double>& q, const quat_view<double>& out, options o) noexcept {
    return along_sequence<double>(q, out, o);
}

}  // namespace swivel
