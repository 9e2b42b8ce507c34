#ifndef SWIVEL_COMMAND_EVAL_BLOCK_HPP
#define SWIVEL_COMMAND_EVAL_BLOCK_HPP

// Columns of a table as the views that the library takes.

#include <cstddef>
#include <string>
#include <vector>

#include "swivel/types.hpp"

namespace swivel::command {

enum class group_kind {
    quaternion,  // prefix + x, y, z, w
    vector,      // prefix + x, y, z
    factors,     // s1 s2 sc ts tc
    matrix,      // prefix + xx, xy, xz, yx ... zz: row x first
    motor,       // prefix + x, y, z, w, dx, dy, dz, dw
    conformal,   // prefix + s, 12, 13, 14, 15, 23 ... 2345: 16 columns
    bivector,    // prefix + 12, 13, 14, 15, 23 ... 45: 10 columns
    scalar       // one column, of the name itself
};

// Columns that belong together.
struct column_group {
    group_kind kind;
    std::string prefix;
};

[[nodiscard]] std::vector<std::string> column_names(const column_group& group);
[[nodiscard]] std::vector<std::string> column_names(const std::vector<column_group>& groups);

enum class memory_layout {
    soa,  // every column on its own
    aos   // the columns of a quaternion or vector interleaved
};

// A number of rows, all columns of them.
template <class T>
class eval_block {
public:
    eval_block(const std::vector<column_group>& groups, memory_layout layout, std::size_t capacity);

    [[nodiscard]] std::size_t columns() const noexcept { return columns_.size(); }
    [[nodiscard]] T& at(std::size_t row, std::size_t column) noexcept {
        const strided& c = columns_[column];
        return c.first[static_cast<std::ptrdiff_t>(row) * c.stride];
    }

    // How many rows the views show; at most the capacity.
    void resize(std::size_t rows) noexcept { rows_ = rows; }
    [[nodiscard]] std::size_t size() const noexcept { return rows_; }

    // The group of that index, which must be of the kind.
    [[nodiscard]] swivel::quat_view<T> quaternion(std::size_t group) const noexcept;
    [[nodiscard]] swivel::vec3_view<T> vector(std::size_t group) const noexcept;
    [[nodiscard]] swivel::factor_view<T> factors(std::size_t group) const noexcept;
    [[nodiscard]] swivel::matrix_view<T> matrix(std::size_t group) const noexcept;
    [[nodiscard]] swivel::motor_view<T> motor(std::size_t group) const noexcept;
    [[nodiscard]] swivel::conformal_view<T> conformal(std::size_t group) const noexcept;
    [[nodiscard]] swivel::bivector_view<T> bivector(std::size_t group) const noexcept;
    [[nodiscard]] swivel::scalar_view<T> scalar(std::size_t group) const noexcept;

private:
    struct strided {
        T* first;
        std::ptrdiff_t stride;
    };

    [[nodiscard]] const strided* group_columns(std::size_t group) const noexcept {
        return columns_.data() + first_column_[group];
    }

    std::vector<T> values_;
    std::vector<strided> columns_;
    std::vector<std::size_t> first_column_;  // of each group
    std::size_t rows_ = 0;
};

extern template class eval_block<float>;
extern template class eval_block<double>;

}  // namespace swivel::command

#endif
