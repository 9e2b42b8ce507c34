#ifndef SWIVEL_COMMAND_EVAL_BLOCK_HPP
#define SWIVEL_COMMAND_EVAL_BLOCK_HPP

// The memory of a number of rows: the columns of all groups, each number by its row and column.

#include <cstddef>
#include <span>
#include <vector>

#include "operations/block.hpp"

namespace swivel::command {

enum class memory_layout {
    soa,  // every column on its own
    aos   // the columns of a group interleaved
};

template <class T>
class eval_block {
public:
    eval_block(std::span<const operations::group> groups, memory_layout layout, std::size_t capacity);

    [[nodiscard]] std::size_t columns() const noexcept { return columns_.size(); }
    [[nodiscard]] T& at(std::size_t row, std::size_t column) noexcept {
        const strided& c = columns_[column];
        return c.first[static_cast<std::ptrdiff_t>(row) * c.stride];
    }

    // Of the first rows, at most the capacity.
    [[nodiscard]] const operations::block<T>& view(std::size_t rows) noexcept {
        block_.resize(rows);
        return block_;
    }

private:
    struct strided {
        T* first;
        std::ptrdiff_t stride;
    };

    std::vector<T> values_;
    std::vector<strided> columns_;
    operations::block<T> block_;
};

extern template class eval_block<float>;
extern template class eval_block<double>;

}  // namespace swivel::command

#endif
