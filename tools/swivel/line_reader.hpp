#ifndef SWIVEL_COMMAND_LINE_READER_HPP
#define SWIVEL_COMMAND_LINE_READER_HPP

// A text file line by line, in a bounded amount of memory.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace swivel::command {

inline constexpr std::size_t longest_line = std::size_t{1} << 20;

class line_reader {
public:
    // The file at `path`, or standard input when it is "-". Throws bad_data when it cannot be opened.
    explicit line_reader(const std::string& path);

    // The next line without its end (LF, CRLF or CR); the view holds until the next call. False at the end of
    // the file. A byte order mark is skipped. Throws bad_data when the file cannot be read, is UTF-16, or has
    // a line that is longer than longest_line.
    bool next(std::string_view& line);

    // Of the line handed out last, from 1.
    [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }
    [[nodiscard]] std::uint64_t bytes_read() const noexcept { return bytes_read_; }
    // 0 when it is not known, as with a pipe.
    [[nodiscard]] std::uint64_t total_bytes() const noexcept { return total_bytes_; }
    // For messages.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

private:
    bool fill();
    void skip_byte_order_mark();

    struct close_file {
        void operator()(std::FILE* f) const noexcept { std::fclose(f); }
    };

    std::string name_;
    std::unique_ptr<std::FILE, close_file> opened_;
    std::FILE* file_ = nullptr;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;  // of what has not been handed out
    std::size_t end_ = 0;
    std::size_t line_number_ = 0;
    std::uint64_t bytes_read_ = 0;
    std::uint64_t total_bytes_ = 0;
    bool after_carriage_return_ = false;
};

}  // namespace swivel::command

#endif
