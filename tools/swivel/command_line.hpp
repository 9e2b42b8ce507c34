#ifndef SWIVEL_COMMAND_COMMAND_LINE_HPP
#define SWIVEL_COMMAND_COMMAND_LINE_HPP

// The command line: subcommands, each with its options and what it does. CLI11 reads it; its header takes the compiler
// as long as all the rest of a file, so that command_line.cpp alone includes it.

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "failure.hpp"

namespace CLI {
class App;
}

namespace swivel::command {

// That of one command, the program or a word after it. A handle, to be copied.
class command_line {
public:
    explicit command_line(CLI::App& app) noexcept : app_(&app) {}

    command_line add_command(const std::string& name, const std::string& description);
    // One of its subcommands has to be named.
    void require_subcommand();
    // Below the options in its help.
    void set_footer(const std::string& text);
    // What it does, once all options have been read.
    void set_action(std::function<void()> action);

    void add_flag(const std::string& name, bool& value, const std::string& description);
    // The file that it reads, where it stands without a name of an option.
    void add_operand(const std::string& name, std::string& value, const std::string& description,
                     bool is_required = false);
    void add_text(const std::string& name, const std::string& type, std::string& value,
                  const std::string& description);
    // May be given many times.
    void add_texts(const std::string& name, const std::string& type, std::vector<std::string>& values,
                   const std::string& description);
    // `read` throws bad_usage.
    void add_value(const std::string& name, const std::string& type,
                   const std::function<void(const std::string&)>& read, const std::string& description);
    // One of a few words.
    template <class T>
    void add_choice(const std::string& name, T& value,
                    std::initializer_list<std::pair<const char*, T>> choices,
                    const std::string& description) {
        std::string words, preset;
        for (const auto& [word, meaning] : choices) {
            words += words.empty() ? "" : "|";
            words += word;
            if (meaning == value) preset = word;
        }
        const std::vector<std::pair<const char*, T>> known = choices;
        add_value(
            name, words,
            [&value, known, name, words](const std::string& given) {
                for (const auto& [word, meaning] : known)
                    if (given == word) {
                        value = meaning;
                        return;
                    }
                throw bad_usage(name + ": '" + given + "' is none of " + words);
            },
            description + " (default: " + preset + ")");
    }

private:
    CLI::App* app_;
};

// Reads the command line and does what it asks for, by the commands that `add_commands` adds; help and version go to
// standard output, a complaint to standard error. The exit code; or what the action throws.
int run_command_line(int argc, char** argv, const std::string& description, const std::string& version,
                     const std::function<void(command_line)>& add_commands);

}  // namespace swivel::command

#endif
