#ifndef SWIVEL_KERNELS_QUATERNION_ARRAY_HPP
#define SWIVEL_KERNELS_QUATERNION_ARRAY_HPP

// Arrays of quaternions to streams and back, so that the kernels only ever see streams.

#include "ops.hpp"

namespace swivel {
namespace {

template <class V>
void split_quaternions(const scalar_of<V>* array, scalar_of<V>* const streams[4], std::size_t size) noexcept {
    using T = scalar_of<V>;
    T *const s0 = streams[0], *const s1 = streams[1], *const s2 = streams[2], *const s3 = streams[3];
    std::size_t i = 0;
    for (; i + V::size <= size; i += V::size) {
        V c[4];
        load_quaternions(array + 4 * i, c);
        c[0].store_unaligned(s0 + i);
        c[1].store_unaligned(s1 + i);
        c[2].store_unaligned(s2 + i);
        c[3].store_unaligned(s3 + i);
    }
    for (; i < size; ++i) {
        s0[i] = array[4 * i];
        s1[i] = array[4 * i + 1];
        s2[i] = array[4 * i + 2];
        s3[i] = array[4 * i + 3];
    }
}

template <class V>
void join_quaternions(const scalar_of<V>* const streams[4], scalar_of<V>* array, std::size_t size) noexcept {
    using T = scalar_of<V>;
    const T *const s0 = streams[0], *const s1 = streams[1], *const s2 = streams[2], *const s3 = streams[3];
    std::size_t i = 0;
    for (; i + V::size <= size; i += V::size) {
        const V c[4] = {V::load_unaligned(s0 + i), V::load_unaligned(s1 + i), V::load_unaligned(s2 + i),
                        V::load_unaligned(s3 + i)};
        store_quaternions(c, array + 4 * i);
    }
    for (; i < size; ++i) {
        array[4 * i] = s0[i];
        array[4 * i + 1] = s1[i];
        array[4 * i + 2] = s2[i];
        array[4 * i + 3] = s3[i];
    }
}

}  // namespace
}  // namespace swivel

#endif
