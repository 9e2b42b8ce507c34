#include "eval_block.hpp"

namespace swivel::command {

std::vector<std::string> column_names(const column_group& group) {
    const std::string& p = group.prefix;
    switch (group.kind) {
        case group_kind::quaternion:
            return {p + "x", p + "y", p + "z", p + "w"};
        case group_kind::vector:
            return {p + "x", p + "y", p + "z"};
        case group_kind::factors:
            return {"s1", "s2", "sc", "ts", "tc"};
        case group_kind::matrix:
            return {p + "xx", p + "xy", p + "xz", p + "yx", p + "yy", p + "yz", p + "zx", p + "zy", p + "zz"};
        case group_kind::motor:
            return {p + "x", p + "y", p + "z", p + "w", p + "dx", p + "dy", p + "dz", p + "dw"};
        case group_kind::conformal:
            return {p + "s",  p + "12", p + "13", p + "14",   p + "15",   p + "23",   p + "24",   p + "25",
                    p + "34", p + "35", p + "45", p + "1234", p + "1235", p + "1245", p + "1345", p + "2345"};
        case group_kind::bivector:
            return {p + "12", p + "13", p + "14", p + "15", p + "23",
                    p + "24", p + "25", p + "34", p + "35", p + "45"};
        case group_kind::scalar:
            break;
    }
    return {p};
}

std::vector<std::string> column_names(const std::vector<column_group>& groups) {
    std::vector<std::string> names;
    for (const column_group& group : groups)
        for (std::string& name : column_names(group)) names.push_back(std::move(name));
    return names;
}

template <class T>
eval_block<T>::eval_block(const std::vector<column_group>& groups, memory_layout layout,
                          std::size_t capacity) {
    values_.resize(column_names(groups).size() * capacity);
    T* base = values_.data();
    for (const column_group& group : groups) {
        const std::size_t width = column_names(group).size();
        const bool interleaved = layout == memory_layout::aos && group.kind != group_kind::factors;
        first_column_.push_back(columns_.size());
        for (std::size_t k = 0; k < width; ++k) {
            if (interleaved)
                columns_.push_back({base + k, static_cast<std::ptrdiff_t>(width)});
            else
                columns_.push_back({base + k * capacity, 1});
        }
        base += width * capacity;
    }
}

template <class T>
swivel::quat_view<T> eval_block<T>::quaternion(std::size_t group) const noexcept {
    const strided* const c = group_columns(group);
    return {c[0].first, c[1].first, c[2].first, c[3].first, rows_, c[0].stride};
}

template <class T>
swivel::vec3_view<T> eval_block<T>::vector(std::size_t group) const noexcept {
    const strided* const c = group_columns(group);
    return {c[0].first, c[1].first, c[2].first, rows_, c[0].stride};
}

template <class T>
swivel::factor_view<T> eval_block<T>::factors(std::size_t group) const noexcept {
    const strided* const c = group_columns(group);
    return {c[0].first, c[1].first, c[2].first, c[3].first, c[4].first, rows_};
}

template <class T>
swivel::matrix_view<T> eval_block<T>::matrix(std::size_t group) const noexcept {
    const strided* const c = group_columns(group);
    return {c[0].first, c[1].first, c[2].first, c[3].first, c[4].first, c[5].first,
            c[6].first, c[7].first, c[8].first, rows_,      c[0].stride};
}

template <class T>
swivel::motor_view<T> eval_block<T>::motor(std::size_t group) const noexcept {
    const strided* const c = group_columns(group);
    return {c[0].first, c[1].first, c[2].first, c[3].first, c[4].first,
            c[5].first, c[6].first, c[7].first, rows_,      c[0].stride};
}

template <class T>
swivel::conformal_view<T> eval_block<T>::conformal(std::size_t group) const noexcept {
    const strided* const c = group_columns(group);
    swivel::conformal_view<T> v{{}, rows_, c[0].stride};
    for (int k = 0; k < 16; ++k) v.blade[k] = c[k].first;
    return v;
}

template <class T>
swivel::bivector_view<T> eval_block<T>::bivector(std::size_t group) const noexcept {
    const strided* const c = group_columns(group);
    swivel::bivector_view<T> v{{}, rows_, c[0].stride};
    for (int k = 0; k < 10; ++k) v.blade[k] = c[k].first;
    return v;
}

template <class T>
swivel::scalar_view<T> eval_block<T>::scalar(std::size_t group) const noexcept {
    return {group_columns(group)[0].first, rows_};
}

template class eval_block<float>;
template class eval_block<double>;

}  // namespace swivel::command
