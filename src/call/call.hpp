#ifndef SWIVEL_SRC_CALL_CALL_HPP
#define SWIVEL_SRC_CALL_CALL_HPP

// One call of an operation: what it reads and writes, in the order that its kernel takes, then `run`.
//
//   call<T> c(q.size, o);
//   c.read(q);
//   c.write(out);
//   return c.template run<conjugate_kernels>();
//
// Everything is checked before the kernel runs, at a cost that does not depend on the size: first, as views are
// named, the extents of their memory; and only where these leave something open, element for element.

#include "src/call/active.hpp"
#include "src/call/axes.hpp"
#include "src/call/memory.hpp"
#include "src/call/unit_axis.hpp"

namespace swivel {

inline precision_index index_of(precision p) noexcept {
    return p == precision::fast ? fast_index : reproducible_index;
}

inline status check(const options& o) noexcept {
    if (o.order != product::swing_twist && o.order != product::twist_swing) return status::bad_argument;
    if (o.accuracy != precision::fast && o.accuracy != precision::reproducible) return status::bad_argument;
    if (o.axis_frame > frame::body || o.motion > flavour::nlerp) return status::bad_argument;
    if (o.pole_threshold == default_pole_threshold) return status::ok;
    return o.pole_threshold >= 0 && o.pole_threshold <= 1 ? status::ok : status::bad_argument;
}

// As x y z w, but for the signs.
inline constexpr std::uint8_t spinor_places[] = {3, 2, 0, 1};

template <class T>
class call {
public:
    // Every view of the call has that size.
    call(std::size_t size, const options& o) noexcept
        : bytes_(static_cast<std::ptrdiff_t>(size * sizeof(T))),
          // Neither 0 nor too many.
          extents_suffice_(size - 1 < static_cast<std::size_t>(PTRDIFF_MAX) / (4 * sizeof(T))),
          options_(o),
          argument_(check(o)) {
        batch_.size = size;
    }

    // `places` says where each component goes among those that the kernel takes.
    [[gnu::always_inline]] void read(const quat_view<const T>& v,
                                     const std::uint8_t* places = in_order) noexcept {
        add_input({v.x, v.y, v.z, v.w}, v.size, v.stride, places);
    }
    [[gnu::always_inline]] void read(const vec3_view<const T>& v,
                                     const std::uint8_t* places = in_order) noexcept {
        add_input({v.x, v.y, v.z}, v.size, v.stride, places);
    }
    [[gnu::always_inline]] void read(const scalar_view<const T>& v) noexcept {
        add_input({v.data}, v.size, v.stride, in_order);
    }
    [[gnu::always_inline]] void read(const factor_view<const T>& v,
                                     product p = product::swing_twist) noexcept {
        add_input({v.s1, v.s2, v.sc, v.ts, v.tc}, v.size, 1, factor_places[p != product::swing_twist]);
    }
    void read(const spinor_view<const T>& v) noexcept {
        add_input({v.a, v.b, v.c, v.d}, v.size, v.stride, spinor_places);
    }
    void read(const matrix_view<const T>& m) noexcept {
        add_input({m.xx, m.xy, m.xz, m.yx, m.yy, m.yz, m.zx, m.zy, m.zz}, m.size, m.stride, in_order);
    }
    void read(const motor_view<const T>& m) noexcept {
        add_input({m.x, m.y, m.z, m.w, m.dx, m.dy, m.dz, m.dw}, m.size, m.stride, in_order);
    }
    void read(const conformal_view<const T>& c) noexcept { add_input(c.blade, c.size, c.stride, in_order); }
    void read(const bivector_view<const T>& b) noexcept { add_input(b.blade, b.size, b.stride, in_order); }
    // One number for all is read over and over. It must outlive the call.
    [[gnu::always_inline]] void read(const parameter<T>& t) noexcept {
        const scalar_view<const T> one{&t.for_all, batch_.size, 0};
        const scalar_view<const T>& v = t.is_per_element ? t.per_element : one;
        add_input({v.data}, v.size, v.stride, in_order);
    }

    [[gnu::always_inline]] void write(const quat_view<T>& v, const std::uint8_t* places = in_order) noexcept {
        add_output({v.x, v.y, v.z, v.w}, v.size, v.stride, places);
    }
    [[gnu::always_inline]] void write(const vec3_view<T>& v, const std::uint8_t* places = in_order) noexcept {
        add_output({v.x, v.y, v.z}, v.size, v.stride, places);
    }
    [[gnu::always_inline]] void write(const scalar_view<T>& v) noexcept {
        add_output({v.data}, v.size, v.stride, in_order);
    }
    [[gnu::always_inline]] void write(const factor_view<T>& v, product p = product::swing_twist) noexcept {
        add_output({v.s1, v.s2, v.sc, v.ts, v.tc}, v.size, 1, factor_places[p != product::swing_twist]);
    }
    void write(const spinor_view<T>& v) noexcept {
        add_output({v.a, v.b, v.c, v.d}, v.size, v.stride, spinor_places);
    }
    void write(const matrix_view<T>& m) noexcept {
        add_output({m.xx, m.xy, m.xz, m.yx, m.yy, m.yz, m.zx, m.zy, m.zz}, m.size, m.stride, in_order);
    }
    void write(const motor_view<T>& m) noexcept {
        add_output({m.x, m.y, m.z, m.w, m.dx, m.dy, m.dz, m.dw}, m.size, m.stride, in_order);
    }
    void write(const conformal_view<T>& c) noexcept { add_output(c.blade, c.size, c.stride, in_order); }
    void write(const bivector_view<T>& b) noexcept { add_output(b.blade, b.size, b.stride, in_order); }

    // As an operation does that looks at the options' product.
    void read(const twist_axis<T>& a) noexcept { about(a, order_for(a, options_.order)); }

    // The number that the kernel takes in that place.
    void number(int place, T value) noexcept { batch_.uniform[place] = value; }

    // An argument that is right or wrong in itself.
    void require(status argument) noexcept {
        if (argument_ == status::ok) argument_ = argument;
    }

    // The axis on which rotations are projected, and the threshold of its pole: as numbers, or as a stream.
    [[gnu::always_inline]] void about(const twist_axis<T>& a, const component_order& order) noexcept {
        batch_.uniform[0] = threshold_of<T>(options_);
        switch (order.form) {
            case coordinate_index:
                return require(check(a.coordinate));
            case uniform_index:
                return about_one(a.uniform, order);
            default:
                return read(a.per_element, order.places);
        }
    }

    // What is wrong with the call, if anything; the size may be 0.
    status check_all() noexcept {
        if (!extents_suffice_) [[unlikely]] {
            const status bad = check_elements(batch_, batch_.size, in_, inputs_, out_, outputs_);
            if (bad != status::ok || batch_.size == 0) return bad;
        }
        return argument_;
    }

    // Runs the kernel of those variants, unless something is wrong.
    template <template <class> class Kernels, class... Which>
    [[gnu::always_inline]] status run(Which... which) noexcept {
        if (const status bad = check_all(); bad != status::ok || batch_.size == 0) return bad;
        const loops<T>& kernel = active<Kernels, T>(which...);
        if (repeats_) repeat_scalars(batch_, in_, inputs_, repeated_);
        (contiguous_ ? kernel.contiguous : kernel.any)(batch_);
        return status::ok;
    }

private:
    template <class U>
    static std::uintptr_t address(U* p) noexcept {
        return reinterpret_cast<std::uintptr_t>(p);
    }

    // The usual view is contiguous, and its streams lie one after the other in memory.
    template <class U, int N>
    [[gnu::always_inline]] extent look_at(U* const (&stream)[N], std::size_t size, std::ptrdiff_t stride,
                                          bool written) noexcept {
        extents_suffice_ = extents_suffice_ && size == batch_.size && stream[0] != nullptr;
        if (stride == 1 || size == 1) [[likely]] {
            for (int k = 1; k < N; ++k)
                extents_suffice_ =
                    extents_suffice_ &&
                    static_cast<std::ptrdiff_t>(address(stream[k]) - address(stream[k - 1])) >= bytes_;
            return {address(stream[0]), address(stream[N - 1]) + static_cast<std::uintptr_t>(bytes_)};
        }
        if (N == 1 && stride == 0) {
            repeats_ = true;
            return {address(stream[0]), address(stream[0]) + sizeof(T)};
        }
        contiguous_ = false;
        const extent e = extent_of_any<U>(stream, N, size, stride, written);
        extents_suffice_ = extents_suffice_ && e.end != 0;
        return e;
    }

    template <int N>
    [[gnu::always_inline]] void add_input(const T* const (&stream)[N], std::size_t size,
                                          std::ptrdiff_t stride, const std::uint8_t* places) noexcept {
        const group& g = in_[inputs_] = {streams_in_, N, size, stride};
        const extent where = in_where_[inputs_] = look_at(stream, size, stride, false);
        for (int k = 0; k < N; ++k) batch_.in[streams_in_ + places[k]] = stream[k];
        for (int k = 0; k < outputs_; ++k)
            extents_suffice_ =
                extents_suffice_ && (!where.overlaps(out_where_[k]) || is_in_place(out_[k], g));
        batch_.in_stride[inputs_++] = size == 1 ? 1 : stride;
        streams_in_ += N;
    }

    template <int N>
    [[gnu::always_inline]] void add_output(T* const (&stream)[N], std::size_t size, std::ptrdiff_t stride,
                                           const std::uint8_t* places) noexcept {
        const group& g = out_[outputs_] = {streams_out_, N, size, stride};
        const extent where = out_where_[outputs_] = look_at(stream, size, stride, true);
        if (N == 1 && stride == 0) extents_suffice_ = false;
        for (int k = 0; k < N; ++k) batch_.out[streams_out_ + places[k]] = stream[k];
        for (int k = 0; k < outputs_; ++k)
            extents_suffice_ = extents_suffice_ && !where.overlaps(out_where_[k]);
        for (int k = 0; k < inputs_; ++k)
            extents_suffice_ = extents_suffice_ && (!where.overlaps(in_where_[k]) || is_in_place(g, in_[k]));
        batch_.out_stride[outputs_++] = size == 1 ? 1 : stride;
        streams_out_ += N;
    }

    bool is_in_place(const group& out, const group& in) const noexcept {
        if (out.count != in.count || out.stride != in.stride) return false;
        for (int k = 0; k < out.count; ++k)
            if (batch_.out[out.first + k] != batch_.in[in.first + k]) return false;
        return true;
    }

    void about_one(const vec3<T>& v, const component_order& order) noexcept {
        unit_axis<T> unit;
        if (!make_unit(v, unit)) return require(status::bad_argument);
        batch_.uniform[1 + order.places[0]] = unit.x;
        batch_.uniform[1 + order.places[1]] = unit.y;
        batch_.uniform[1 + order.places[2]] = unit.z;
        batch_.uniform[4] = unit.excess;
    }

    batch<T> batch_;
    std::ptrdiff_t bytes_;
    bool extents_suffice_, contiguous_ = true, repeats_ = false;
    int inputs_ = 0, outputs_ = 0, streams_in_ = 0, streams_out_ = 0;
    const options& options_;
    status argument_;
    group in_[most_groups], out_[most_groups];
    extent in_where_[most_groups], out_where_[most_groups];
    alignas(64) T repeated_[most_scalars][repeated_bytes / sizeof(T)];
};

}  // namespace swivel

#endif
