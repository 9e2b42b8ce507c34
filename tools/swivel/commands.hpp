#ifndef SWIVEL_COMMAND_COMMANDS_HPP
#define SWIVEL_COMMAND_COMMANDS_HPP

// The subcommands. Each adds itself to the program and runs when it has been chosen; it throws bad_usage,
// bad_data or closed_pipe.

#include <CLI/CLI.hpp>

namespace swivel::command {

void add_info(CLI::App& program);
void add_decompose(CLI::App& program);
void add_eval(CLI::App& program);

}  // namespace swivel::command

#endif
