#ifndef SWIVEL_TESTS_SUPPORT_BUFFERS_HPP
#define SWIVEL_TESTS_SUPPORT_BUFFERS_HPP

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "swivel/types.hpp"

namespace swivel::tests {

template <class T>
using bits_of = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

// The same bits, where any NaN is as good as any other.
template <class T>
bool same_bits(T a, T b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return std::bit_cast<bits_of<T>>(a) == std::bit_cast<bits_of<T>>(b);
}

enum class layout { soa, aos_xyzw, aos_wxyz, every_other, backwards };

inline constexpr layout all_layouts[] = {layout::soa, layout::aos_xyzw, layout::aos_wxyz, layout::every_other,
                                         layout::backwards};

inline std::string name(layout l) {
    switch (l) {
        case layout::soa:
            return "soa";
        case layout::aos_xyzw:
            return "aos_xyzw";
        case layout::aos_wxyz:
            return "aos_wxyz";
        case layout::every_other:
            return "every_other";
        case layout::backwards:
            return "backwards";
    }
    return "unknown";
}

// What untouched memory holds; no operation gives it.
template <class T>
constexpr T untouched = T(-123456.5);

// The elements of a buffer, whatever their kind.
template <class T>
class any_buffer {
public:
    virtual int components() const = 0;
    virtual T& at(int component, std::size_t i) = 0;
    virtual T* first(int component) = 0;
    virtual std::ptrdiff_t stride() const = 0;
    virtual std::vector<T>& memory() = 0;

protected:
    ~any_buffer() = default;
};

// N components of n elements in one of the layouts. The streams of soa begin at odd addresses, so that no
// kernel can rely on alignment.
template <class T, int N>
class stream_buffer : public any_buffer<T> {
public:
    stream_buffer(std::size_t n, layout l) : n_(n), data_(N * (2 * n + 2) + 1, untouched<T>) {
        const bool array = (l == layout::aos_xyzw || l == layout::aos_wxyz) && N > 1;
        stride_ = array ? N : l == layout::every_other ? 2 : l == layout::backwards ? -1 : 1;
        for (int c = 0; c < N; ++c) {
            const int rotated = l == layout::aos_wxyz ? (c + 1) % N : c;
            const std::size_t block = 2 * n + 2;
            std::size_t at = array ? static_cast<std::size_t>(rotated) : static_cast<std::size_t>(c) * block;
            if (l == layout::backwards && n > 0) at += n - 1;
            first_[c] = data_.data() + 1 + at;
        }
    }
    stream_buffer(const stream_buffer&) = delete;
    stream_buffer& operator=(const stream_buffer&) = delete;

    int components() const final { return N; }
    T& at(int component, std::size_t i) final {
        return first_[component][static_cast<std::ptrdiff_t>(i) * stride_];
    }
    T* first(int component) final { return first_[component]; }
    std::size_t size() const { return n_; }
    std::ptrdiff_t stride() const final { return stride_; }
    std::vector<T>& memory() final { return data_; }

private:
    std::size_t n_;
    std::vector<T> data_;
    T* first_[N];
    std::ptrdiff_t stride_;
};

template <class T>
struct quat_buffer : stream_buffer<T, 4> {
    using stream_buffer<T, 4>::stream_buffer;

    quat_view<T> view() {
        return {this->first(0), this->first(1), this->first(2), this->first(3), this->size(), this->stride()};
    }
    quat<T> get(std::size_t i) { return {this->at(0, i), this->at(1, i), this->at(2, i), this->at(3, i)}; }
    void set(std::size_t i, const quat<T>& q) {
        this->at(0, i) = q.x;
        this->at(1, i) = q.y;
        this->at(2, i) = q.z;
        this->at(3, i) = q.w;
    }
};

template <class T>
struct vec3_buffer : stream_buffer<T, 3> {
    using stream_buffer<T, 3>::stream_buffer;

    vec3_view<T> view() {
        return {this->first(0), this->first(1), this->first(2), this->size(), this->stride()};
    }
    vec3<T> get(std::size_t i) { return {this->at(0, i), this->at(1, i), this->at(2, i)}; }
    void set(std::size_t i, const vec3<T>& v) {
        this->at(0, i) = v.x;
        this->at(1, i) = v.y;
        this->at(2, i) = v.z;
    }
};

template <class T>
struct scalar_buffer : stream_buffer<T, 1> {
    using stream_buffer<T, 1>::stream_buffer;

    scalar_view<T> view() { return {this->first(0), this->size(), this->stride()}; }
    T& operator[](std::size_t i) { return this->at(0, i); }
};

// Element xx first, row by row.
template <class T>
struct matrix_buffer : stream_buffer<T, 9> {
    using stream_buffer<T, 9>::stream_buffer;

    matrix_view<T> view() {
        return {this->first(0), this->first(1), this->first(2), this->first(3),
                this->first(4), this->first(5), this->first(6), this->first(7),
                this->first(8), this->size(),   this->stride()};
    }
};

// One motor.
template <class T>
struct dual_quaternion {
    quat<T> r, d;
    friend bool operator==(const dual_quaternion&, const dual_quaternion&) = default;
};

// x y z w dx dy dz dw.
template <class T>
struct motor_buffer : stream_buffer<T, 8> {
    using stream_buffer<T, 8>::stream_buffer;

    motor_view<T> view() {
        return {this->first(0), this->first(1), this->first(2), this->first(3), this->first(4),
                this->first(5), this->first(6), this->first(7), this->size(),   this->stride()};
    }
    dual_quaternion<T> get(std::size_t i) {
        return {{this->at(0, i), this->at(1, i), this->at(2, i), this->at(3, i)},
                {this->at(4, i), this->at(5, i), this->at(6, i), this->at(7, i)}};
    }
    void set(std::size_t i, const dual_quaternion<T>& m) {
        const T values[] = {m.r.x, m.r.y, m.r.z, m.r.w, m.d.x, m.d.y, m.d.z, m.d.w};
        for (int c = 0; c < 8; ++c) this->at(c, i) = values[c];
    }
};

template <class T>
struct conformal_buffer : stream_buffer<T, 16> {
    using stream_buffer<T, 16>::stream_buffer;

    conformal_view<T> view() {
        conformal_view<T> v{{}, this->size(), this->stride()};
        for (int k = 0; k < 16; ++k) v.blade[k] = this->first(k);
        return v;
    }
};

template <class T>
struct bivector_buffer : stream_buffer<T, 10> {
    using stream_buffer<T, 10>::stream_buffer;

    bivector_view<T> view() {
        bivector_view<T> v{{}, this->size(), this->stride()};
        for (int k = 0; k < 10; ++k) v.blade[k] = this->first(k);
        return v;
    }
};

// Factor views have no stride: always structure of arrays.
template <class T>
struct factor_buffer : stream_buffer<T, 5> {
    explicit factor_buffer(std::size_t n) : stream_buffer<T, 5>(n, layout::soa) {}

    factor_view<T> view() {
        return {this->first(0), this->first(1), this->first(2), this->first(3), this->first(4), this->size()};
    }
    factors<T> get(std::size_t i) {
        return {this->at(0, i), this->at(1, i), this->at(2, i), this->at(3, i), this->at(4, i)};
    }
    void set(std::size_t i, const factors<T>& f) {
        this->at(0, i) = f.s1;
        this->at(1, i) = f.s2;
        this->at(2, i) = f.sc;
        this->at(3, i) = f.ts;
        this->at(4, i) = f.tc;
    }
};

}  // namespace swivel::tests

#endif
