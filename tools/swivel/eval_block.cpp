#include "eval_block.hpp"

namespace swivel::command {

template <class T>
eval_block<T>::eval_block(std::span<const operations::group> groups, memory_layout layout,
                          std::size_t capacity) {
    values_.resize(operations::stream_names(groups).size() * capacity);
    T* base = values_.data();
    for (const operations::group& group : groups) {
        const std::size_t width = operations::stream_names(group).size();
        // The compact form has no stride.
        const bool interleaved =
            layout == memory_layout::aos && group.kind != operations::group_kind::factors;
        const std::ptrdiff_t stride = interleaved ? static_cast<std::ptrdiff_t>(width) : 1;
        std::vector<T*> streams;
        for (std::size_t k = 0; k < width; ++k) {
            streams.push_back(base + (interleaved ? k : k * capacity));
            columns_.push_back({streams.back(), stride});
        }
        block_.add(streams, stride);
        base += width * capacity;
    }
}

template class eval_block<float>;
template class eval_block<double>;

}  // namespace swivel::command
