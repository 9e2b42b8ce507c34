#include "line_reader.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "failure.hpp"

namespace swivel::command {

namespace {

constexpr std::size_t block_size = std::size_t{1} << 16;

std::uint64_t size_of_regular_file(std::FILE* file) noexcept {
    struct stat about {};
    if (fstat(fileno(file), &about) != 0 || !S_ISREG(about.st_mode) || about.st_size < 0) return 0;
    return static_cast<std::uint64_t>(about.st_size);
}

}  // namespace

line_reader::line_reader(const std::string& path) : name_(path == "-" ? "<stdin>" : path) {
    if (path == "-") {
        file_ = stdin;
    } else {
        opened_.reset(std::fopen(path.c_str(), "rb"));
        if (!opened_)
            throw bad_data(name_ + ": cannot open the file: " + std::generic_category().message(errno));
        file_ = opened_.get();
    }
    total_bytes_ = size_of_regular_file(file_);
    buffer_.resize(longest_line + 2 * block_size);
}

bool line_reader::fill() {
    if (buffer_.size() - end_ < block_size) {
        std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
                  buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
        end_ -= begin_;
        begin_ = 0;
    }
    errno = 0;
    const std::size_t count = std::fread(buffer_.data() + end_, 1, block_size, file_);
    if (count == 0 && std::ferror(file_))
        throw bad_data(name_ + ": cannot read the file: " + std::generic_category().message(errno));
    end_ += count;
    bytes_read_ += count;
    return count > 0;
}

void line_reader::skip_byte_order_mark() {
    while (end_ - begin_ < 3 && fill()) {
    }
    const std::string_view start(buffer_.data() + begin_, end_ - begin_);
    if (start.starts_with("\xef\xbb\xbf")) begin_ += 3;
    if (start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff"))
        throw bad_data(name_, 1, 1, "the text is UTF-16", "ASCII or UTF-8");
}

bool line_reader::next(std::string_view& line) {
    if (line_number_ == 0) skip_byte_order_mark();
    std::size_t length = 0;
    for (;;) {
        const char* const start = buffer_.data() + begin_;
        const std::size_t available = end_ - begin_;
        if (after_carriage_return_ && available > 0) {
            after_carriage_return_ = false;
            if (*start == '\n') {
                ++begin_;
                continue;
            }
        }
        while (length < available && start[length] != '\n' && start[length] != '\r') ++length;
        const bool is_ended = length < available;
        if (length > longest_line)
            throw bad_data(name_, line_number_ + 1, 1, "the line is too long",
                           "at most " + std::to_string(longest_line) + " bytes");
        if (is_ended || !fill()) {
            if (!is_ended && length == 0) return false;
            line = std::string_view(buffer_.data() + begin_, length);
            after_carriage_return_ = is_ended && buffer_[begin_ + length] == '\r';
            begin_ += length + (is_ended ? 1 : 0);
            ++line_number_;
            return true;
        }
    }
}

}  // namespace swivel::command
