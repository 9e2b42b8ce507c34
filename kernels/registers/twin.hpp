#ifndef SWIVEL_KERNELS_REGISTERS_TWIN_HPP
#define SWIVEL_KERNELS_REGISTERS_TWIN_HPP

#include "kernels/registers/ops.hpp"

// Two registers as one, twice as wide. An operation whose every step waits for the one before, such as a sine
// of an angle of a root, leaves the processor idle, since the next register's steps are too far behind to be
// seen; on a twin each step is done for two registers that do not wait for each other.

namespace swivel {
namespace {

template <class M>
struct twin_mask {
    M first, second;

    friend twin_mask operator&(const twin_mask& a, const twin_mask& b) noexcept {
        return {a.first & b.first, a.second & b.second};
    }
    friend twin_mask operator|(const twin_mask& a, const twin_mask& b) noexcept {
        return {a.first | b.first, a.second | b.second};
    }
};

template <class V>
struct twin {
    using value_type = scalar_of<V>;
    using batch_bool_type = twin_mask<mask_of<V>>;
    using half = V;
    static constexpr std::size_t size = 2 * V::size;

    V first, second;

    twin() noexcept = default;
    explicit twin(value_type a) noexcept : first(a), second(a) {}
    twin(const V& a, const V& b) noexcept : first(a), second(b) {}

    static twin load_unaligned(const value_type* from) noexcept {
        return {V::load_unaligned(from), V::load_unaligned(from + V::size)};
    }
    void store_unaligned(value_type* to) const noexcept {
        first.store_unaligned(to);
        second.store_unaligned(to + V::size);
    }

    friend twin operator+(const twin& a, const twin& b) noexcept {
        return {a.first + b.first, a.second + b.second};
    }
    friend twin operator-(const twin& a, const twin& b) noexcept {
        return {a.first - b.first, a.second - b.second};
    }
    friend twin operator*(const twin& a, const twin& b) noexcept {
        return {a.first * b.first, a.second * b.second};
    }
    friend twin operator&(const twin& a, const twin& b) noexcept {
        return {a.first & b.first, a.second & b.second};
    }
    friend twin operator|(const twin& a, const twin& b) noexcept {
        return {a.first | b.first, a.second | b.second};
    }
    friend twin operator^(const twin& a, const twin& b) noexcept {
        return {a.first ^ b.first, a.second ^ b.second};
    }
    friend batch_bool_type operator<(const twin& a, const twin& b) noexcept {
        return {a.first < b.first, a.second < b.second};
    }
    friend batch_bool_type operator<=(const twin& a, const twin& b) noexcept {
        return {a.first <= b.first, a.second <= b.second};
    }
    friend batch_bool_type operator>(const twin& a, const twin& b) noexcept {
        return {a.first > b.first, a.second > b.second};
    }
    friend batch_bool_type operator>=(const twin& a, const twin& b) noexcept {
        return {a.first >= b.first, a.second >= b.second};
    }
    friend batch_bool_type operator==(const twin& a, const twin& b) noexcept {
        return {a.first == b.first, a.second == b.second};
    }
};

// As for one register (ops.hpp); `count` may end in either of the two.
template <class V>
requires requires { typename V::half; }
inline V load_first(const scalar_of<V>* from, std::size_t count) noexcept {
    using half = typename V::half;
    if (count < half::size) return {load_first<half>(from, count), half(*from)};
    if (count == half::size) return {half::load_unaligned(from), half(*from)};
    return {half::load_unaligned(from), load_first<half>(from + half::size, count - half::size)};
}

template <class V>
inline void store_first(const twin<V>& a, scalar_of<V>* to, std::size_t count) noexcept {
    if (count < V::size) return store_first(a.first, to, count);
    a.first.store_unaligned(to);
    if (count > V::size) store_first(a.second, to + V::size, count - V::size);
}

template <class M, class V>
inline twin<V> select(const twin_mask<M>& m, const twin<V>& a, const twin<V>& b) noexcept {
    return {select(m.first, a.first, b.first), select(m.second, a.second, b.second)};
}

template <class V>
inline twin<V> fused(const twin<V>& a, const twin<V>& b, const twin<V>& c) noexcept {
    return {V(fused(a.first, b.first, c.first)), V(fused(a.second, b.second, c.second))};
}

template <class V>
inline twin<V> fused_negative(const twin<V>& a, const twin<V>& b, const twin<V>& c) noexcept {
    return {V(fused_negative(a.first, b.first, c.first)), V(fused_negative(a.second, b.second, c.second))};
}

template <class V>
inline twin<V> rsqrt_estimate(const twin<V>& a) noexcept {
    return {V(rsqrt_estimate(a.first)), V(rsqrt_estimate(a.second))};
}

template <class V>
inline twin<V> square_root_of(const twin<V>& a) noexcept {
    return {square_root_of(a.first), square_root_of(a.second)};
}

template <class V>
inline twin<V> quotient(const twin<V>& a, const twin<V>& b) noexcept {
    return {quotient(a.first, b.first), quotient(a.second, b.second)};
}

template <class V>
inline twin<V> magnitude(const twin<V>& a) noexcept {
    return {magnitude(a.first), magnitude(a.second)};
}

template <class V>
inline twin<V> larger(const twin<V>& a, const twin<V>& b) noexcept {
    return {larger(a.first, b.first), larger(a.second, b.second)};
}

template <class V>
inline twin<V> one_signed_like(const twin<V>& a) noexcept {
    return {one_signed_like(a.first), one_signed_like(a.second)};
}

template <class V>
inline mask_of<twin<V>> not_less_equal(const twin<V>& a, const twin<V>& b) noexcept {
    return {not_less_equal(a.first, b.first), not_less_equal(a.second, b.second)};
}

template <class M, class V>
inline twin<V> product_or(const twin_mask<M>& m, const twin<V>& a, const twin<V>& b,
                          const twin<V>& other) noexcept {
    return {product_or(m.first, a.first, b.first, other.first),
            product_or(m.second, a.second, b.second, other.second)};
}

template <class M, class V>
inline twin<V> product_or_zero(const twin_mask<M>& m, const twin<V>& a, const twin<V>& b) noexcept {
    return {product_or_zero(m.first, a.first, b.first), product_or_zero(m.second, a.second, b.second)};
}

template <int Bit, class V>
inline mask_of<twin<V>> has_bit(const twin<V>& a) noexcept {
    return {has_bit<Bit>(a.first), has_bit<Bit>(a.second)};
}

template <int Bit, class V>
inline twin<V> sign_from_bit(const twin<V>& a) noexcept {
    return {sign_from_bit<Bit>(a.first), sign_from_bit<Bit>(a.second)};
}

}  // namespace
}  // namespace swivel

#endif
