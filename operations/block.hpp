#ifndef SWIVEL_OPERATIONS_BLOCK_HPP
#define SWIVEL_OPERATIONS_BLOCK_HPP

// What an operation reads or writes: groups of streams, whatever memory they lie in, as the views that the library
// takes.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "swivel/types.hpp"

namespace swivel::operations {

enum class group_kind {
    quaternion,  // prefix + x, y, z, w
    vector,      // prefix + x, y, z
    factors,     // s1 s2 sc ts tc
    matrix,      // prefix + xx, xy, xz, yx ... zz: row x first
    motor,       // prefix + x, y, z, w, dx, dy, dz, dw
    conformal,   // prefix + s, 12, 13, 14, 15, 23 ... 2345
    bivector,    // prefix + 12, 13, 14, 15, 23 ... 45
    spinor,      // a b c d
    scalar       // one stream, of the name itself
};

// What the numbers of a group are, where its kind leaves that open.
enum class meaning {
    any,
    angle,
    axis,
    sign,
    logarithm  // of a rotation or motion: 0 where nothing moves
};

struct group {
    group_kind kind;
    std::string prefix;
    operations::meaning meaning = operations::meaning::any;
};

// The names of a group's streams, in the order that the views of the library have.
[[nodiscard]] std::vector<std::string> stream_names(const group& g);
[[nodiscard]] std::vector<std::string> stream_names(std::span<const group> groups);

// A number of elements of every group, in the order of the groups. T may be const.
template <class T>
class block {
public:
    block() = default;
    // That of the same elements to be read alone.
    template <class U>
    requires std::is_same_v<const U, T>
    explicit block(const block<U>& b) : size_(b.size()) {
        for (std::size_t g = 0; g < b.groups(); ++g) {
            const std::span<U* const> streams = b.streams(g);
            add(std::vector<T*>(streams.begin(), streams.end()), b.stride(g));
        }
    }

    void add(std::span<T* const> streams, std::ptrdiff_t stride) {
        first_.push_back({streams_.size(), streams.size(), stride});
        streams_.insert(streams_.end(), streams.begin(), streams.end());
    }

    // How many elements the views show.
    void resize(std::size_t size) noexcept { size_ = size; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    [[nodiscard]] std::size_t groups() const noexcept { return first_.size(); }
    [[nodiscard]] std::ptrdiff_t stride(std::size_t g) const noexcept { return first_[g].stride; }
    [[nodiscard]] std::span<T* const> streams(std::size_t g) const noexcept {
        return {streams_.data() + first_[g].begin, first_[g].count};
    }

    // The group of that index, which must be of the kind.
    [[nodiscard]] quat_view<T> quaternion(std::size_t g) const noexcept {
        T* const* const s = streams(g).data();
        return {s[0], s[1], s[2], s[3], size_, stride(g)};
    }
    [[nodiscard]] vec3_view<T> vector(std::size_t g) const noexcept {
        T* const* const s = streams(g).data();
        return {s[0], s[1], s[2], size_, stride(g)};
    }
    [[nodiscard]] factor_view<T> factors(std::size_t g) const noexcept {
        T* const* const s = streams(g).data();
        return {s[0], s[1], s[2], s[3], s[4], size_};
    }
    [[nodiscard]] matrix_view<T> matrix(std::size_t g) const noexcept {
        T* const* const s = streams(g).data();
        return {s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], size_, stride(g)};
    }
    [[nodiscard]] motor_view<T> motor(std::size_t g) const noexcept {
        T* const* const s = streams(g).data();
        return {s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], size_, stride(g)};
    }
    [[nodiscard]] conformal_view<T> conformal(std::size_t g) const noexcept {
        conformal_view<T> v{{}, size_, stride(g)};
        for (std::size_t k = 0; k < 16; ++k) v.blade[k] = streams(g)[k];
        return v;
    }
    [[nodiscard]] bivector_view<T> bivector(std::size_t g) const noexcept {
        bivector_view<T> v{{}, size_, stride(g)};
        for (std::size_t k = 0; k < 10; ++k) v.blade[k] = streams(g)[k];
        return v;
    }
    [[nodiscard]] spinor_view<T> spinor(std::size_t g) const noexcept {
        T* const* const s = streams(g).data();
        return {s[0], s[1], s[2], s[3], size_, stride(g)};
    }
    [[nodiscard]] scalar_view<T> scalar(std::size_t g) const noexcept {
        return {streams(g)[0], size_, stride(g)};
    }

private:
    struct place {
        std::size_t begin, count;
        std::ptrdiff_t stride;
    };

    std::vector<T*> streams_;
    std::vector<place> first_;
    std::size_t size_ = 0;
};

}  // namespace swivel::operations

#endif
