#include "src/call/checks.hpp"

namespace swivel {

namespace {

template <class T>
extent extent_of(T* stream, std::size_t size, std::ptrdiff_t stride) noexcept {
    const auto first = reinterpret_cast<std::uintptr_t>(stream);
    const auto reach =
        static_cast<std::uintptr_t>(static_cast<std::ptrdiff_t>(size - 1) * stride) * sizeof(T);
    return stride < 0 ? extent{first + reach, first + sizeof(T)} : extent{first, first + reach + sizeof(T)};
}

template <class T>
extent extent_of(const any_group<T>& g) noexcept {
    extent e = extent_of(g.stream[0], g.size, g.stride);
    for (int k = 1; k < g.count; ++k) {
        const extent o = extent_of(g.stream[k], g.size, g.stride);
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
    const auto step = static_cast<std::uintptr_t>(a_stride < 0 ? -a_stride : a_stride) * sizeof(T);
    if (step == 0) return true;
    const auto pa = reinterpret_cast<std::uintptr_t>(a), pb = reinterpret_cast<std::uintptr_t>(b);
    const std::uintptr_t apart = (pa < pb ? pb - pa : pa - pb) % step;
    return apart < sizeof(T) || apart > step - sizeof(T);
}

template <class T>
bool within_group_overlap(const any_group<T>& g) noexcept {
    for (int i = 1; i < g.count; ++i)
        for (int k = 0; k < i; ++k)
            if (elements_overlap<T>(g.stream[i], g.stride, g.stream[k], g.stride, g.size)) return true;
    return false;
}

template <class T>
bool overlap(const any_group<T>& a, const any_group<T>& b) noexcept {
    for (int i = 0; i < a.count; ++i)
        for (int k = 0; k < b.count; ++k)
            if (elements_overlap<T>(a.stream[i], a.stride, b.stream[k], b.stride, a.size)) return true;
    return false;
}

// In place, stream for stream, is allowed; it is told from a partial overlap by pointer and stride.
template <class T>
bool partial_overlap(const any_group<T>& out, const any_group<const T>& in) noexcept {
    for (int i = 0; i < out.count; ++i)
        for (int k = 0; k < in.count; ++k) {
            if (out.stream[i] == in.stream[k] && out.stride == in.stride) continue;
            if (elements_overlap<T>(out.stream[i], out.stride, in.stream[k], in.stride, out.size))
                return true;
        }
    return false;
}

template <class T>
status check_group(any_group<T>& g, std::size_t size, bool written) noexcept {
    for (int k = 0; k < g.count; ++k)
        if (g.stream[k] == nullptr) return status::null_stream;
    if (size == 1) g.stride = 1;
    if (written && g.stride == 0) return status::bad_argument;
    if (g.stride != 1) {
        constexpr std::size_t most = static_cast<std::size_t>(PTRDIFF_MAX) / sizeof(T);
        const std::size_t step = g.stride < 0 ? std::size_t{0} - static_cast<std::size_t>(g.stride)
                                              : static_cast<std::size_t>(g.stride);
        if (step > most || (step != 0 && size - 1 > (most - 1) / step)) return status::bad_argument;
    } else if (size > static_cast<std::size_t>(PTRDIFF_MAX) / sizeof(T)) {
        return status::bad_argument;
    }
    return status::ok;
}

}  // namespace

template <class T>
status check(call_streams<T>& s) noexcept {
    s.size = s.in[0].size;
    for (int i = 1; i < s.inputs; ++i)
        if (s.in[i].size != s.size) return status::size_mismatch;
    for (int i = 0; i < s.outputs; ++i)
        if (s.out[i].size != s.size) return status::size_mismatch;
    if (s.size == 0) return status::ok;

    extent in[most_groups], out[most_groups];
    for (int i = 0; i < s.inputs; ++i) {
        if (const status bad = check_group(s.in[i], s.size, false); bad != status::ok) return bad;
        in[i] = extent_of(s.in[i]);
    }
    for (int i = 0; i < s.outputs; ++i) {
        if (const status bad = check_group(s.out[i], s.size, true); bad != status::ok) return bad;
        out[i] = extent_of(s.out[i]);
    }
    for (int i = 0; i < s.outputs; ++i) {
        if (within_group_overlap(s.out[i])) return status::partial_overlap;
        for (int k = 0; k < i; ++k)
            if (out[i].overlaps(out[k]) && overlap(s.out[i], s.out[k])) return status::partial_overlap;
        for (int k = 0; k < s.inputs; ++k)
            if (out[i].overlaps(in[k]) && partial_overlap(s.out[i], s.in[k])) return status::partial_overlap;
    }
    return status::ok;
}

template status check(call_streams<float>&) noexcept;
template status check(call_streams<double>&) noexcept;

}  // namespace swivel
