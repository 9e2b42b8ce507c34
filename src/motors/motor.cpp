#include "swivel/motor.hpp"

#include <algorithm>

#include "src/call/arguments.hpp"

namespace swivel {

namespace {

// An operation without numbers of its own.
template <class T, class... In, class... Out>
status plain(kernel<T> run_kernel, const options& o, const std::tuple<In...>& reads,
             const std::tuple<Out...>& writes) noexcept {
    return run(
        run_kernel, [&](batch<T>&) { return check(o); }, reads, writes);
}

template <class T>
const operations<T>& kernels() noexcept {
    return active_operations<T>();
}

template <class T>
status split(const motor_view<const T>& m, const twist_axis<T>& a, const quat_view<T>& swing,
             const quat_view<T>& twist, const vec3_view<T>& translation, const options& o) noexcept {
    const component_order& order = order_for(a, o.order);
    const kernel<T> run_kernel =
        kernels<T>()
            .motor_decompose[order.form][o.positive_twist ? sign_positive : sign_left][index_of(o.accuracy)];
    const quat_view<const T> rotation{m.x, m.y, m.z, m.w, m.size, m.stride};
    return with_projected(rotation, a, order, [&](const auto& reads) {
        return run(
            run_kernel, [&](batch<T>& b) { return set_numbers(b, order, a, o); },
            std::tuple_cat(reads, std::tuple(group_of(m))),
            std::tuple(group_of(swing, order), group_of(twist, order), group_of(translation)));
    });
}

template <class T>
status join(const quat_view<const T>& swing, const quat_view<const T>& twist,
            const vec3_view<const T>& translation, const motor_view<T>& out, const options& o) noexcept {
    const bool swing_left = o.order == product::swing_twist;
    return plain<T>(kernels<T>().motor_compose[index_of(o.accuracy)], o,
                    std::tuple(group_of(swing_left ? swing : twist), group_of(swing_left ? twist : swing),
                               group_of(translation)),
                    std::tuple(group_of(out)));
}

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
status weighted_sum(std::span<const motor_view<const T>> motors, std::span<const parameter<T>> weights,
                    const motor_view<T>& out, const options& o) noexcept {
    if (motors.size() != weights.size()) return status::size_mismatch;
    if (motors.empty()) return status::bad_argument;
    if (const status bad = check(o); bad != status::ok) return bad;
    for (std::size_t k = 0; k < motors.size(); ++k) {
        call_streams<T> s(std::tuple(group_of(motors[k]), group_of(weights[k], out.size)),
                          std::tuple(group_of(out)));
        if (const status bad = check(s); bad != status::ok) return bad;
    }
    // So long that the calls for a block cost little beside it, and 8 KiB of stack.
    constexpr std::size_t block = 1024 / sizeof(T);
    alignas(64) T memory[8][block];
    const kernel<T> add = kernels<T>().motor_blend[index_of(o.accuracy)];
    for (std::size_t done = 0; done < out.size; done += block) {
        const std::size_t n = out.size - done < block ? out.size - done : block;
        for (T(&stream)[block] : memory) std::fill_n(stream, n, T(0));
        const motor_view<T> sum{memory[0], memory[1], memory[2], memory[3], memory[4],
                                memory[5], memory[6], memory[7], n};
        const motor_view<const T> so_far = sum, first = part_of(motors[0], done, n);
        const quat_view<const T> aligned{first.x, first.y, first.z, first.w, n, first.stride};
        for (std::size_t k = 0; k < motors.size(); ++k) {
            const parameter<T> weight = part_of(weights[k], done, n);
            // All of it has been checked.
            (void)plain<T>(add, o,
                           std::tuple(group_of(so_far), group_of(aligned),
                                      group_of(part_of(motors[k], done, n)), group_of(weight, n)),
                           std::tuple(group_of(sum)));
        }
        (void)plain<T>(kernels<T>().motor_normalize[index_of(o.accuracy)], o, std::tuple(group_of(so_far)),
                       std::tuple(group_of(part_of(out, done, n))));
    }
    return status::ok;
}

}  // namespace

status multiply(const motor_view<const float>& a, const motor_view<const float>& b,
                const motor_view<float>& out, options o) noexcept {
    return plain<float>(kernels<float>().motor_multiply[index_of(o.accuracy)], o,
                        std::tuple(group_of(a), group_of(b)), std::tuple(group_of(out)));
}
status multiply(const motor_view<const double>& a, const motor_view<const double>& b,
                const motor_view<double>& out, options o) noexcept {
    return plain<double>(kernels<double>().motor_multiply[index_of(o.accuracy)], o,
                         std::tuple(group_of(a), group_of(b)), std::tuple(group_of(out)));
}
status conjugate(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return plain<float>(kernels<float>().motor_conjugate, o, std::tuple(group_of(m)),
                        std::tuple(group_of(out)));
}
status conjugate(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return plain<double>(kernels<double>().motor_conjugate, o, std::tuple(group_of(m)),
                         std::tuple(group_of(out)));
}
status normalize(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return plain<float>(kernels<float>().motor_normalize[index_of(o.accuracy)], o, std::tuple(group_of(m)),
                        std::tuple(group_of(out)));
}
status normalize(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return plain<double>(kernels<double>().motor_normalize[index_of(o.accuracy)], o, std::tuple(group_of(m)),
                         std::tuple(group_of(out)));
}
status from_rotation_translation(const quat_view<const float>& q, const vec3_view<const float>& t,
                                 const motor_view<float>& out, options o) noexcept {
    return plain<float>(kernels<float>().from_rotation_translation[index_of(o.accuracy)], o,
                        std::tuple(group_of(q), group_of(t)), std::tuple(group_of(out)));
}
status from_rotation_translation(const quat_view<const double>& q, const vec3_view<const double>& t,
                                 const motor_view<double>& out, options o) noexcept {
    return plain<double>(kernels<double>().from_rotation_translation[index_of(o.accuracy)], o,
                         std::tuple(group_of(q), group_of(t)), std::tuple(group_of(out)));
}
status to_rotation_translation(const motor_view<const float>& m, const quat_view<float>& q,
                               const vec3_view<float>& t, options o) noexcept {
    return plain<float>(kernels<float>().to_rotation_translation[index_of(o.accuracy)], o,
                        std::tuple(group_of(m)), std::tuple(group_of(q), group_of(t)));
}
status to_rotation_translation(const motor_view<const double>& m, const quat_view<double>& q,
                               const vec3_view<double>& t, options o) noexcept {
    return plain<double>(kernels<double>().to_rotation_translation[index_of(o.accuracy)], o,
                         std::tuple(group_of(m)), std::tuple(group_of(q), group_of(t)));
}
status transform(const motor_view<const float>& m, const vec3_view<const float>& points,
                 const vec3_view<float>& out, options o) noexcept {
    return plain<float>(kernels<float>().motor_transform[index_of(o.accuracy)], o,
                        std::tuple(group_of(m), group_of(points)), std::tuple(group_of(out)));
}
status transform(const motor_view<const double>& m, const vec3_view<const double>& points,
                 const vec3_view<double>& out, options o) noexcept {
    return plain<double>(kernels<double>().motor_transform[index_of(o.accuracy)], o,
                         std::tuple(group_of(m), group_of(points)), std::tuple(group_of(out)));
}
status square_root(const motor_view<const float>& m, const motor_view<float>& out, options o) noexcept {
    return plain<float>(kernels<float>().motor_square_root[index_of(o.accuracy)], o, std::tuple(group_of(m)),
                        std::tuple(group_of(out)));
}
status square_root(const motor_view<const double>& m, const motor_view<double>& out, options o) noexcept {
    return plain<double>(kernels<double>().motor_square_root[index_of(o.accuracy)], o,
                         std::tuple(group_of(m)), std::tuple(group_of(out)));
}
status log(const motor_view<const float>& m, const vec3_view<float>& b, const vec3_view<float>& n,
           options o) noexcept {
    return plain<float>(kernels<float>().motor_log[index_of(o.accuracy)], o, std::tuple(group_of(m)),
                        std::tuple(group_of(b), group_of(n)));
}
status log(const motor_view<const double>& m, const vec3_view<double>& b, const vec3_view<double>& n,
           options o) noexcept {
    return plain<double>(kernels<double>().motor_log[index_of(o.accuracy)], o, std::tuple(group_of(m)),
                         std::tuple(group_of(b), group_of(n)));
}
status exp(const vec3_view<const float>& b, const vec3_view<const float>& n, const motor_view<float>& out,
           options o) noexcept {
    return plain<float>(kernels<float>().motor_exp[index_of(o.accuracy)], o,
                        std::tuple(group_of(b), group_of(n)), std::tuple(group_of(out)));
}
status exp(const vec3_view<const double>& b, const vec3_view<const double>& n, const motor_view<double>& out,
           options o) noexcept {
    return plain<double>(kernels<double>().motor_exp[index_of(o.accuracy)], o,
                         std::tuple(group_of(b), group_of(n)), std::tuple(group_of(out)));
}
status power(const motor_view<const float>& m, const parameter<float>& t, const motor_view<float>& out,
             options o) noexcept {
    return plain<float>(kernels<float>().motor_power[index_of(o.accuracy)], o,
                        std::tuple(group_of(m), group_of(t, m.size)), std::tuple(group_of(out)));
}
status power(const motor_view<const double>& m, const parameter<double>& t, const motor_view<double>& out,
             options o) noexcept {
    return plain<double>(kernels<double>().motor_power[index_of(o.accuracy)], o,
                         std::tuple(group_of(m), group_of(t, m.size)), std::tuple(group_of(out)));
}
status sclerp(const motor_view<const float>& a, const motor_view<const float>& b, const parameter<float>& t,
              const motor_view<float>& out, options o) noexcept {
    return plain<float>(kernels<float>().sclerp[o.long_way][index_of(o.accuracy)], o,
                        std::tuple(group_of(a), group_of(b), group_of(t, a.size)), std::tuple(group_of(out)));
}
status sclerp(const motor_view<const double>& a, const motor_view<const double>& b,
              const parameter<double>& t, const motor_view<double>& out, options o) noexcept {
    return plain<double>(kernels<double>().sclerp[o.long_way][index_of(o.accuracy)], o,
                         std::tuple(group_of(a), group_of(b), group_of(t, a.size)),
                         std::tuple(group_of(out)));
}
status blend(std::span<const motor_view<const float>> motors, std::span<const parameter<float>> weights,
             const motor_view<float>& out, options o) noexcept {
    return weighted_sum<float>(motors, weights, out, o);
}
status blend(std::span<const motor_view<const double>> motors, std::span<const parameter<double>> weights,
             const motor_view<double>& out, options o) noexcept {
    return weighted_sum<double>(motors, weights, out, o);
}
status decompose(const motor_view<const float>& m, const twist_axis<float>& a, const quat_view<float>& swing,
                 const quat_view<float>& twist, const vec3_view<float>& translation, options o) noexcept {
    return split<float>(m, a, swing, twist, translation, o);
}
status decompose(const motor_view<const double>& m, const twist_axis<double>& a,
                 const quat_view<double>& swing, const quat_view<double>& twist,
                 const vec3_view<double>& translation, options o) noexcept {
    return split<double>(m, a, swing, twist, translation, o);
}
status compose(const quat_view<const float>& swing, const quat_view<const float>& twist,
               const vec3_view<const float>& translation, const motor_view<float>& out, options o) noexcept {
    return join<float>(swing, twist, translation, out, o);
}
status compose(const quat_view<const double>& swing, const quat_view<const double>& twist,
               const vec3_view<const double>& translation, const motor_view<double>& out,
               options o) noexcept {
    return join<double>(swing, twist, translation, out, o);
}

}  // namespace swivel
