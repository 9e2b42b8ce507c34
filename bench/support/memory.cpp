#include "bench/support/memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <random>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace swivel_bench {

namespace {

constexpr std::size_t page = 4096, cache_line = 64;

// Larger sizes repeat the numbers: what branches there are in the peers cannot be learnt over so many
// elements.
constexpr std::size_t distinct = 16384;

struct sample {
    double x, y, z, w;
};

const std::vector<sample>& samples() {
    static const std::vector<sample> made = [] {
        std::vector<sample> all(distinct);
        std::mt19937_64 bits(20240229);
        std::normal_distribution<double> normal;
        for (sample& s : all) {
            s = {normal(bits), normal(bits), normal(bits), normal(bits)};
            const double scale = 1 / std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z + s.w * s.w);
            s = {s.x * scale, s.y * scale, s.z * scale, s.w * scale};
        }
        return all;
    }();
    return made;
}

const sample& sample_at(data d, std::size_t i) {
    static constexpr sample identity{0, 0, 0, 1};
    return d == data::still ? identity : samples()[i % distinct];
}

}  // namespace

void memory::restart() noexcept { used_ = read_ = written_ = 0; }

void* memory::take(std::size_t bytes, role r) {
    if (size_ == 0) reserve(std::size_t{3} << 29);
    const std::size_t at = r == role::read ? read_++ * cache_line : page / 2 + written_++ * cache_line;
    const std::size_t begin = (used_ + page - 1) / page * page + at;
    used_ = begin + bytes;
    if (used_ > size_) throw std::bad_alloc();
    return begin_ + begin;
}

void memory::reserve(std::size_t bytes) {
    constexpr std::size_t huge_page = std::size_t{2} << 20;
    begin_ = static_cast<std::byte*>(std::aligned_alloc(huge_page, bytes));
    if (begin_ == nullptr) throw std::bad_alloc();
    size_ = bytes;
#if defined(__linux__)
    // At 4194304 elements the page tables would be measured otherwise. Advice only.
    (void)madvise(begin_, bytes, MADV_HUGEPAGE);
#endif
}

memory& shared_memory() {
    static memory shared;
    return shared;
}

template <class T>
workload<T>::workload(std::size_t n, layout l, data d) : n_(n), layout_(l), data_(d) {
    shared_memory().restart();
}

template <class T>
T* workload<T>::take(std::size_t count, memory::role r) {
    T* stream = static_cast<T*>(shared_memory().take(count * sizeof(T), r));
    if (r == memory::role::written) std::memset(stream, 0, count * sizeof(T));
    return stream;
}

template <class T>
swivel::quat_view<const T> workload<T>::rotations() {
    return rotations_from(0);
}

template <class T>
swivel::quat_view<const T> workload<T>::other_rotations() {
    return rotations_from(distinct / 3);
}

template <class T>
swivel::quat_view<const T> workload<T>::rotations_from(std::size_t first) {
    swivel::quat_view<T> q{};
    if (layout_ == layout::aos) {
        q = swivel::aos_xyzw(take(4 * n_, memory::role::read), n_);
    } else {
        T* stream[4];
        for (T*& s : stream) s = take(n_, memory::role::read);
        q = swivel::soa(stream[0], stream[1], stream[2], stream[3], n_);
    }
    for (std::size_t i = 0; i < n_; ++i) {
        const sample& s = sample_at(data_, i + first);
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * q.stride;
        q.x[at] = static_cast<T>(s.x);
        q.y[at] = static_cast<T>(s.y);
        q.z[at] = static_cast<T>(s.z);
        q.w[at] = static_cast<T>(s.w);
    }
    return q;
}

template <class T>
swivel::vec3_view<const T> workload<T>::axes_from(std::size_t first) {
    swivel::vec3_view<T> a{};
    if (layout_ == layout::aos) {
        a = swivel::aos_xyz(take(3 * n_, memory::role::read), n_);
    } else {
        T* stream[3];
        for (T*& s : stream) s = take(n_, memory::role::read);
        a = swivel::soa(stream[0], stream[1], stream[2], n_);
    }
    for (std::size_t i = 0; i < n_; ++i) {
        const sample& s = samples()[(i + first) % distinct];
        const double scale = 1 / std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * a.stride;
        a.x[at] = static_cast<T>(s.x * scale);
        a.y[at] = static_cast<T>(s.y * scale);
        a.z[at] = static_cast<T>(s.z * scale);
    }
    return a;
}

template <class T>
swivel::vec3_view<const T> workload<T>::axes() {
    return axes_from(distinct / 2);
}

template <class T>
swivel::vec3_view<const T> workload<T>::other_axes() {
    return axes_from(data_ == data::still ? distinct / 2 : distinct / 4);
}

template <class T>
swivel::matrix_view<T> workload<T>::take_matrices(memory::role r) {
    if (layout_ == layout::aos) return swivel::aos_rows(take(9 * n_, r), n_);
    T* stream[9];
    for (T*& s : stream) s = take(n_, r);
    return {stream[0], stream[1], stream[2], stream[3], stream[4],
            stream[5], stream[6], stream[7], stream[8], n_};
}

template <class T>
swivel::matrix_view<const T> workload<T>::matrices() {
    const swivel::matrix_view<T> m = take_matrices(memory::role::read);
    for (std::size_t i = 0; i < n_; ++i) {
        const auto [x, y, z, w] = sample_at(data_, i);
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * m.stride;
        m.xx[at] = static_cast<T>(1 - 2 * (y * y + z * z));
        m.xy[at] = static_cast<T>(2 * (x * y - z * w));
        m.xz[at] = static_cast<T>(2 * (x * z + y * w));
        m.yx[at] = static_cast<T>(2 * (x * y + z * w));
        m.yy[at] = static_cast<T>(1 - 2 * (x * x + z * z));
        m.yz[at] = static_cast<T>(2 * (y * z - x * w));
        m.zx[at] = static_cast<T>(2 * (x * z - y * w));
        m.zy[at] = static_cast<T>(2 * (y * z + x * w));
        m.zz[at] = static_cast<T>(1 - 2 * (x * x + y * y));
    }
    return m;
}

template <class T>
swivel::matrix_view<T> workload<T>::written_matrices() {
    return take_matrices(memory::role::written);
}

template <class T>
swivel::motor_view<T> workload<T>::take_motors(memory::role r) {
    if (layout_ == layout::aos) return swivel::aos_motors(take(8 * n_, r), n_);
    T* stream[8];
    for (T*& s : stream) s = take(n_, r);
    return {stream[0], stream[1], stream[2], stream[3], stream[4], stream[5], stream[6], stream[7], n_};
}

template <class T>
swivel::motor_view<const T> workload<T>::motors(std::size_t number) {
    const swivel::motor_view<T> m = take_motors(memory::role::read);
    for (std::size_t i = 0; i < n_; ++i) {
        const std::size_t first = i + number * (distinct / 5);
        const auto [x, y, z, w] = sample_at(data_, first);
        const sample& s = samples()[(first + distinct / 2) % distinct];
        const double half = data_ == data::still ? 0 : 0.5 / std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
        const double tx = half * s.x, ty = half * s.y, tz = half * s.z;
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * m.stride;
        m.x[at] = static_cast<T>(x);
        m.y[at] = static_cast<T>(y);
        m.z[at] = static_cast<T>(z);
        m.w[at] = static_cast<T>(w);
        m.dx[at] = static_cast<T>(w * tx + ty * z - tz * y);
        m.dy[at] = static_cast<T>(w * ty + tz * x - tx * z);
        m.dz[at] = static_cast<T>(w * tz + tx * y - ty * x);
        m.dw[at] = static_cast<T>(-(tx * x + ty * y + tz * z));
    }
    return m;
}

template <class T>
swivel::motor_view<T> workload<T>::written_motors() {
    return take_motors(memory::role::written);
}

template <class T>
swivel::conformal_view<T> workload<T>::take_rotors(memory::role r) {
    swivel::conformal_view<T> v{{}, n_, layout_ == layout::aos ? 16 : 1};
    T* const array = layout_ == layout::aos ? take(16 * n_, r) : nullptr;
    for (int k = 0; k < 16; ++k) v.blade[k] = array != nullptr ? array + k : take(n_, r);
    return v;
}

template <class T>
swivel::conformal_view<const T> workload<T>::rotors() {
    const swivel::conformal_view<T> v = take_rotors(memory::role::read);
    for (std::size_t i = 0; i < n_; ++i) {
        const auto [x, y, z, w] = sample_at(data_, i);
        const double c[16] = {w,
                              -z,
                              y,
                              -w * x,
                              -w * x,
                              -x,
                              -w * y,
                              -w * y,
                              -w * z,
                              -w * z,
                              0,
                              x * x + y * y + z * z,
                              x * x + y * y + z * z,
                              0,
                              0,
                              0};
        for (int k = 0; k < 16; ++k)
            v.blade[k][static_cast<std::ptrdiff_t>(i) * v.stride] = static_cast<T>(c[k]);
    }
    return v;
}

template <class T>
swivel::conformal_view<T> workload<T>::written_rotors() {
    return take_rotors(memory::role::written);
}

template <class T>
swivel::bivector_view<T> workload<T>::take_bivectors(memory::role r) {
    swivel::bivector_view<T> v{{}, n_, layout_ == layout::aos ? 10 : 1};
    T* const array = layout_ == layout::aos ? take(10 * n_, r) : nullptr;
    for (int k = 0; k < 10; ++k) v.blade[k] = array != nullptr ? array + k : take(n_, r);
    return v;
}

template <class T>
swivel::bivector_view<const T> workload<T>::bivectors() {
    const swivel::bivector_view<T> v = take_bivectors(memory::role::read);
    for (std::size_t i = 0; i < n_; ++i) {
        const auto [x, y, z, w] = sample_at(data_, i);
        const double moved = 1 - w * w, b[10] = {-z,         y,          -moved * x, -moved * x, -x,
                                                 -moved * y, -moved * y, -moved * z, -moved * z, 0};
        for (int k = 0; k < 10; ++k)
            v.blade[k][static_cast<std::ptrdiff_t>(i) * v.stride] = static_cast<T>(b[k]);
    }
    return v;
}

template <class T>
swivel::bivector_view<T> workload<T>::written_bivectors() {
    return take_bivectors(memory::role::written);
}

// Of length 1, or 0.
template <class T>
swivel::vec3_view<const T> workload<T>::logarithms() {
    const swivel::vec3_view<const T> v = axes();
    if (data_ == data::ordinary) return v;
    const swivel::vec3_view<T> zero = vectors();
    return zero;
}

template <class T>
swivel::spinor_view<const T> workload<T>::spinors() {
    const swivel::quat_view<const T> q = rotations();
    return {q.x, q.y, q.z, q.w, q.size, q.stride};
}

template <class T>
swivel::spinor_view<T> workload<T>::written_spinors() {
    const swivel::quat_view<T> q = quaternions();
    return {q.x, q.y, q.z, q.w, q.size, q.stride};
}

template <class T>
swivel::factor_view<const T> workload<T>::factors() {
    T* stream[5];
    for (T*& s : stream) s = take(n_, memory::role::read);
    for (std::size_t i = 0; i < n_; ++i) {
        const sample& s = sample_at(data_, i);
        const double r = std::sqrt(s.w * s.w + s.z * s.z), tc = s.w / r, ts = s.z / r;
        stream[0][i] = static_cast<T>(tc * s.x - ts * s.y);
        stream[1][i] = static_cast<T>(tc * s.y + ts * s.x);
        stream[2][i] = static_cast<T>(r);
        stream[3][i] = static_cast<T>(ts);
        stream[4][i] = static_cast<T>(tc);
    }
    return {stream[0], stream[1], stream[2], stream[3], stream[4], n_};
}

template <class T>
swivel::quat_view<T> workload<T>::quaternions() {
    if (layout_ == layout::aos) return swivel::aos_xyzw(take(4 * n_, memory::role::written), n_);
    T* stream[4];
    for (T*& s : stream) s = take(n_, memory::role::written);
    return swivel::soa(stream[0], stream[1], stream[2], stream[3], n_);
}

template <class T>
swivel::vec3_view<T> workload<T>::vectors() {
    if (layout_ == layout::aos) return swivel::aos_xyz(take(3 * n_, memory::role::written), n_);
    T* stream[3];
    for (T*& s : stream) s = take(n_, memory::role::written);
    return swivel::soa(stream[0], stream[1], stream[2], n_);
}

template <class T>
swivel::scalar_view<T> workload<T>::scalars() {
    return {take(n_, memory::role::written), n_, 1};
}

template <class T>
swivel::scalar_view<const T> workload<T>::parameters() {
    T* stream = take(n_, memory::role::read);
    for (std::size_t i = 0; i < n_; ++i) stream[i] = static_cast<T>(i % distinct) / static_cast<T>(distinct);
    return {stream, n_, 1};
}

template <class T>
swivel::factor_view<T> workload<T>::written_factors() {
    T* stream[5];
    for (T*& s : stream) s = take(n_, memory::role::written);
    return {stream[0], stream[1], stream[2], stream[3], stream[4], n_};
}

template <class T>
const T* workload<T>::copied(std::size_t per_element) {
    T* stream = take(per_element * n_, memory::role::read);
    for (std::size_t i = 0; i < per_element * n_; ++i) stream[i] = static_cast<T>(samples()[i % distinct].x);
    return stream;
}

template <class T>
T* workload<T>::written(std::size_t per_element) {
    return take(per_element * n_, memory::role::written);
}

template class workload<float>;
template class workload<double>;

}  // namespace swivel_bench
