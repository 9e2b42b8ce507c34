#ifndef SWIVEL_COMMAND_FAILURE_HPP
#define SWIVEL_COMMAND_FAILURE_HPP

// What ends a command early. The exit codes are part of the command's interface.

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace swivel::command {

inline constexpr int exit_ok = 0;
inline constexpr int exit_bad_data = 1;
inline constexpr int exit_bad_usage = 2;

// The command line asks for something that cannot be done.
class bad_usage : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The data, or the files they come from and go to.
class bad_data : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;

    bad_data(std::string_view file, std::size_t line, std::size_t column, std::string_view what,
             std::string_view expected)
        : std::runtime_error(std::string(file) + ":" + std::to_string(line) + ":" + std::to_string(column) +
                             ": " + std::string(what) + ", expected " + std::string(expected)) {}
};

// The reader of a pipe has had enough. Nobody needs to be told.
class closed_pipe : public std::exception {
public:
    [[nodiscard]] const char* what() const noexcept override { return "the pipe is closed"; }
};

}  // namespace swivel::command

#endif
