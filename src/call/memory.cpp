#include "src/call/memory.hpp"

namespace swivel {

namespace {

std::uintptr_t address(const void* p) noexcept { return reinterpret_cast<std::uintptr_t>(p); }

std::size_t magnitude(std::ptrdiff_t stride) noexcept {
    return stride < 0 ? std::size_t{0} - static_cast<std::size_t>(stride) : static_cast<std::size_t>(stride);
}

// Whether the view is not larger than memory.
template <class T>
bool fits(std::size_t size, std::ptrdiff_t stride) noexcept {
    constexpr std::size_t most = static_cast<std::size_t>(PTRDIFF_MAX) / sizeof(T);
    std::size_t reach;
    return !__builtin_mul_overflow(size - 1, magnitude(stride), &reach) && reach < most;
}

template <class T>
extent extent_of(T* stream, std::size_t size, std::ptrdiff_t stride) noexcept {
    const std::uintptr_t first = address(stream);
    const auto reach =
        static_cast<std::uintptr_t>(static_cast<std::ptrdiff_t>(size - 1) * stride) * sizeof(T);
    return stride < 0 ? extent{first + reach, first + sizeof(T)} : extent{first, first + reach + sizeof(T)};
}

template <class T>
extent extent_of(T* const* stream, int count, std::size_t size, std::ptrdiff_t stride) noexcept {
    extent e = extent_of(stream[0], size, stride);
    for (int k = 1; k < count; ++k) {
        const extent o = extent_of(stream[k], size, stride);
        if (o.begin < e.begin) e.begin = o.begin;
        if (o.end > e.end) e.end = o.end;
    }
    return e;
}

// Whether any element of one stream shares a byte with any element of the other. Exact where the strides are
// equal in magnitude, as they are within an array of structures; else the extents decide.
template <class T>
bool elements_overlap(const T* a, std::ptrdiff_t a_stride, const T* b, std::ptrdiff_t b_stride,
                      std::size_t size) noexcept {
    if (!extent_of(a, size, a_stride).overlaps(extent_of(b, size, b_stride))) return false;
    if (a_stride != b_stride && a_stride != -b_stride) return true;
    const std::uintptr_t step = magnitude(a_stride) * sizeof(T);
    if (step == 0) return true;
    const std::uintptr_t pa = address(a), pb = address(b);
    const std::uintptr_t apart = (pa < pb ? pb - pa : pa - pb) % step;
    return apart < sizeof(T) || apart > step - sizeof(T);
}

// Of two outputs, or of one with itself.
template <class T>
bool outputs_overlap(T* const* a, const group& ga, T* const* b, const group& gb) noexcept {
    for (int i = 0; i < ga.count; ++i)
        for (int k = 0; k < (a == b ? i : gb.count); ++k)
            if (elements_overlap<T>(a[i], ga.stride, b[k], gb.stride, ga.size)) return true;
    return false;
}

// In place, stream for stream, is allowed; it is told from a partial overlap by pointer and stride.
template <class T>
bool partial_overlap(T* const* out, const group& to, const T* const* in, const group& from) noexcept {
    for (int i = 0; i < to.count; ++i)
        for (int k = 0; k < from.count; ++k) {
            if (out[i] == in[k] && to.stride == from.stride) continue;
            if (elements_overlap<T>(out[i], to.stride, in[k], from.stride, to.size)) return true;
        }
    return false;
}

template <class T>
status check_group(T* const* stream, group& g, extent& where, bool written) noexcept {
    for (int k = 0; k < g.count; ++k)
        if (stream[k] == nullptr) return status::null_stream;
    if (g.size == 1) g.stride = 1;
    if ((written && g.stride == 0) || !fits<T>(g.size, g.stride)) return status::bad_argument;
    where = extent_of(stream, g.count, g.size, g.stride);
    return status::ok;
}

}  // namespace

template <class T>
extent extent_of_any(T* const* stream, int count, std::size_t size, std::ptrdiff_t stride,
                     bool written) noexcept {
    constexpr extent unknown{0, 0};
    const T* lowest = stream[0];
    for (int k = 0; k < count; ++k) {
        if (stream[k] == nullptr) return unknown;
        if (address(stream[k]) < address(lowest)) lowest = stream[k];
    }
    if (size == 0 || !fits<T>(size, stride)) return unknown;
    const extent e = extent_of(stream, count, size, stride);
    if (!written) return e;
    // Each in a place of its own of a record: then no two elements of the view meet.
    const std::size_t record = magnitude(stride) < 64 ? magnitude(stride) : 64;
    std::uint64_t taken = 0;
    for (int k = 0; k < count; ++k) {
        const std::uintptr_t bytes = address(stream[k]) - address(lowest);
        const std::uintptr_t place = bytes / sizeof(T);
        if (bytes % sizeof(T) != 0 || place >= record) return unknown;
        const std::uint64_t bit = std::uint64_t{1} << place;
        if ((taken & bit) != 0) return unknown;
        taken |= bit;
    }
    return e;
}

template <class T>
status check_elements(const batch<T>& b, std::size_t size, group* in, int inputs, group* out,
                      int outputs) noexcept {
    for (int i = 0; i < inputs; ++i)
        if (in[i].size != size) return status::size_mismatch;
    for (int i = 0; i < outputs; ++i)
        if (out[i].size != size) return status::size_mismatch;
    if (size == 0) return status::ok;
    extent in_where[most_groups], out_where[most_groups];
    for (int i = 0; i < inputs; ++i)
        if (const status bad = check_group(b.in + in[i].first, in[i], in_where[i], false); bad != status::ok)
            return bad;
    for (int i = 0; i < outputs; ++i)
        if (const status bad = check_group(b.out + out[i].first, out[i], out_where[i], true);
            bad != status::ok)
            return bad;
    for (int i = 0; i < outputs; ++i) {
        T* const* const written = b.out + out[i].first;
        for (int k = 0; k <= i; ++k)
            if (out_where[i].overlaps(out_where[k]) &&
                outputs_overlap(written, out[i], b.out + out[k].first, out[k]))
                return status::partial_overlap;
        for (int k = 0; k < inputs; ++k)
            if (out_where[i].overlaps(in_where[k]) &&
                partial_overlap(written, out[i], b.in + in[k].first, in[k]))
                return status::partial_overlap;
    }
    return status::ok;
}

template <class T>
void repeat_scalars(batch<T>& b, const group* in, int inputs,
                    T (&blocks)[most_scalars][repeated_bytes / sizeof(T)]) noexcept {
    int used = 0;
    for (int g = 0; g < inputs; ++g) {
        if (in[g].count != 1 || b.in_stride[g] != 0) continue;
        T* const block = blocks[used++];
        const T value = *b.in[in[g].first];
        for (std::size_t k = 0; k < repeated_bytes / sizeof(T); ++k) block[k] = value;
        b.in[in[g].first] = block;
    }
}

template extent extent_of_any(float* const*, int, std::size_t, std::ptrdiff_t, bool) noexcept;
template extent extent_of_any(double* const*, int, std::size_t, std::ptrdiff_t, bool) noexcept;
template extent extent_of_any(const float* const*, int, std::size_t, std::ptrdiff_t, bool) noexcept;
template extent extent_of_any(const double* const*, int, std::size_t, std::ptrdiff_t, bool) noexcept;
template status check_elements(const batch<float>&, std::size_t, group*, int, group*, int) noexcept;
template status check_elements(const batch<double>&, std::size_t, group*, int, group*, int) noexcept;
template void repeat_scalars(batch<float>&, const group*, int,
                             float (&)[most_scalars][repeated_bytes / sizeof(float)]) noexcept;
template void repeat_scalars(batch<double>&, const group*, int,
                             double (&)[most_scalars][repeated_bytes / sizeof(double)]) noexcept;

}  // namespace swivel
