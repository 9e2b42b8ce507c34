#ifndef SWIVEL_COMMAND_EVAL_OPTIONS_HPP
#define SWIVEL_COMMAND_EVAL_OPTIONS_HPP

// The options of the operations as those of the command line.

#include "command_line.hpp"
#include "operations/operation.hpp"

namespace swivel::command {

// `settings` must stay where they are until the command line has been read.
void add_option(command_line line, operations::option which, operations::settings& settings);

}  // namespace swivel::command

#endif
