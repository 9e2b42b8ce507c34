#ifndef SWIVEL_BENCH_SUPPORT_MEMORY_HPP
#define SWIVEL_BENCH_SUPPORT_MEMORY_HPP

// The streams that a row reads and writes.

#include <cstddef>

#include "swivel/types.hpp"

namespace swivel_bench {

enum class layout { soa, aos };

// Still: rotations and motors are the identity, and b is a.
enum class data { ordinary, still };

// A block of memory that all rows share, one after the other: it grows to the size of the largest row, and
// its pages stay mapped, so that no row pays for them.
class memory {
public:
    enum class role { read, written };

    // Streams taken before are given up.
    void restart() noexcept;

    // Every stream begins in a cache line of its own within the 4 KiB page: a load whose address has the same
    // lower 12 bits as an earlier store waits for it, so what is read lies half a page from what is written.
    void* take(std::size_t bytes, role r);

private:
    void reserve(std::size_t bytes);

    std::byte* begin_ = nullptr;
    std::size_t size_ = 0, used_ = 0, read_ = 0, written_ = 0;
};

memory& shared_memory();

// Takes streams of n elements and fills those that are read, always with the same numbers: unit quaternions
// distributed evenly over all rotations, axes evenly over all directions.
template <class T>
class workload {
public:
    workload(std::size_t n, layout l, data d = data::ordinary);

    swivel::quat_view<const T> rotations();
    // Others than those, at all distances from them.
    swivel::quat_view<const T> other_rotations();
    swivel::vec3_view<const T> axes();
    swivel::vec3_view<const T> other_axes();
    // Of the rotations, row by row where they are in arrays.
    swivel::matrix_view<const T> matrices();
    // Those of a decomposition about z.
    swivel::factor_view<const T> factors();
    // Of the rotations, each with a translation along its vector part.
    swivel::conformal_view<const T> rotors();
    // Their logarithms; and of the motors, or the rotations alone.
    swivel::bivector_view<const T> bivectors();
    swivel::vec3_view<const T> logarithms();
    swivel::spinor_view<const T> spinors();
    swivel::quat_view<T> quaternions();
    swivel::conformal_view<T> written_rotors();
    swivel::bivector_view<T> written_bivectors();
    swivel::spinor_view<T> written_spinors();
    swivel::vec3_view<T> vectors();
    swivel::matrix_view<T> written_matrices();
    swivel::scalar_view<T> scalars();
    // From 0 to 1.
    swivel::scalar_view<const T> parameters();
    swivel::factor_view<T> written_factors();

    // Those of one number are turned by other rotations and moved by other unit vectors than those of
    // another.
    swivel::motor_view<const T> motors(std::size_t number = 0);
    swivel::motor_view<T> written_motors();

    // Plain streams of so many numbers for each element.
    const T* copied(std::size_t per_element);
    T* written(std::size_t per_element);

    std::size_t size() const noexcept { return n_; }

private:
    swivel::quat_view<const T> rotations_from(std::size_t first);
    swivel::bivector_view<T> take_bivectors(memory::role r);
    swivel::vec3_view<const T> axes_from(std::size_t first);
    swivel::matrix_view<T> take_matrices(memory::role r);
    swivel::motor_view<T> take_motors(memory::role r);
    swivel::conformal_view<T> take_rotors(memory::role r);
    T* take(std::size_t count, memory::role r);

    std::size_t n_;
    layout layout_;
    data data_;
};

extern template class workload<float>;
extern template class workload<double>;

}  // namespace swivel_bench

#endif
