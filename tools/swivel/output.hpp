#ifndef SWIVEL_COMMAND_OUTPUT_HPP
#define SWIVEL_COMMAND_OUTPUT_HPP

// Where results go: standard output, or a file that is there as a whole or not at all.

#include <cstdio>
#include <string>
#include <string_view>

namespace swivel::command {

// A file is written under another name beside its target, .TARGET.swivel-XXXXXX, and renamed over it by commit(),
// once it is on the disk. Without commit(), or when a signal ends the program, nothing is left of it. The new file
// has mode and owner of the one that it replaces, as far as the system lets it; other hard links to that one keep
// the old text. A symbolic link is followed; what is no regular file (a device, a named pipe) is written to directly.
// Every fault is thrown as bad_data, but closed_pipe where that is the matter with standard output.
class output {
public:
    explicit output(const std::string& path);  // "-" is standard output
    output(const output&) = delete;
    output& operator=(const output&) = delete;
    ~output();

    void write(std::string_view text);
    void flush();
    // Nothing may be written afterwards, but to standard output.
    void commit();

    [[nodiscard]] bool is_standard_output() const noexcept { return file_ == stdout; }
    [[nodiscard]] bool is_terminal() const noexcept;

private:
    void follow_links();
    void open_temporary();
    [[noreturn]] void fail(std::string_view doing, int error_number) const;

    std::string name_;  // for messages
    std::string target_;
    std::string temporary_;  // empty when the target is written to directly
    std::FILE* file_ = nullptr;
};

// Throws bad_usage where the output would replace the file that is read, whatever the two are called.
void require_other_file(const std::string& read, const std::string& written);

// A write to a pipe that nobody reads, or beyond the size that files may have, is to be an error like any other, and the files that are opened are not
// to take the place of a standard stream that was closed when the program began.
void prepare_standard_streams();

}  // namespace swivel::command

#endif
