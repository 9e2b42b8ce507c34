#ifndef SWIVEL_COMMAND_COMMANDS_HPP
#define SWIVEL_COMMAND_COMMANDS_HPP

// The subcommands. Each adds itself to the program and runs when it has been chosen; it throws bad_usage,
// bad_data or closed_pipe.

#include "command_line.hpp"

namespace swivel::command {

void add_info(command_line program);
void add_decompose(command_line program);
void add_eval(command_line program);

}  // namespace swivel::command

#endif
