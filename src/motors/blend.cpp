#include <algorithm>

#include "kernels/motors/tables.hpp"
#include "src/call/call.hpp"
#include "swivel/motor.hpp"

namespace swivel {

namespace {

template <class T>
motor_view<T> part_of(const motor_view<T>& m, std::size_t first, std::size_t size) noexcept {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(first) * m.stride;
    return {m.x + at,  m.y + at,  m.z + at,  m.w + at, m.dx + at,
            m.dy + at, m.dz + at, m.dw + at, size,     m.stride};
}

template <class T>
parameter<T> part_of(const parameter<T>& t, std::size_t first, std::size_t size) noexcept {
    if (!t.is_per_element) return t;
    const scalar_view<const T>& v = t.per_element;
    return scalar_view<const T>{v.data + static_cast<std::ptrdiff_t>(first) * v.stride, size, v.stride};
}

template <class T>
status any_blend(std::span<const motor_view<const T>> motors, std::span<const parameter<T>> weights,
                 const motor_view<T>& out, const options& o) noexcept {
    if (motors.size() != weights.size()) return status::size_mismatch;
    if (motors.empty()) return status::bad_argument;
    if (const status bad = check(o); bad != status::ok) return bad;
    for (std::size_t k = 0; k < motors.size(); ++k) {
        call<T> c(motors[k].size, o);
        c.read(motors[k]);
        c.read(weights[k]);
        c.write(out);
        if (const status bad = c.check_all(); bad != status::ok) return bad;
    }
    // So long that the calls for a block cost little beside it, and 4 KiB of stack.
    constexpr std::size_t block = 512 / sizeof(T);
    alignas(64) T memory[8][block];
    for (std::size_t done = 0; done < out.size; done += block) {
        const std::size_t n = out.size - done < block ? out.size - done : block;
        for (T(&stream)[block] : memory) std::fill_n(stream, n, T(0));
        const motor_view<T> sum{memory[0], memory[1], memory[2], memory[3], memory[4],
                                memory[5], memory[6], memory[7], n};
        const motor_view<const T> so_far = sum, first = part_of(motors[0], done, n);
        // All of it has been checked.
        for (std::size_t k = 0; k < motors.size(); ++k) {
            const parameter<T> weight = part_of(weights[k], done, n);
            call<T> c(n, o);
            c.read(so_far);
            c.read(quat_view<const T>{first.x, first.y, first.z, first.w, n, first.stride});
            c.read(part_of(motors[k], done, n));
            c.read(weight);
            c.write(sum);
            (void)c.template run<motor_blend_kernels>(index_of(o.accuracy));
        }
        call<T> c(n, o);
        c.read(so_far);
        c.write(part_of(out, done, n));
        (void)c.template run<motor_normalize_kernels>(index_of(o.accuracy));
    }
    return status::ok;
}

}  // namespace

status blend(std::span<const motor_view<const float>> motors, std::span<const parameter<float>> weights,
             const motor_view<float>& out, options o) noexcept {
    return any_blend<float>(motors, weights, out, o);
}
status blend(std::span<const motor_view<const double>> motors, std::span<const parameter<double>> weights,
             const motor_view<double>& out, options o) noexcept {
    return any_blend<double>(motors, weights, out, o);
}

}  // namespace swivel
