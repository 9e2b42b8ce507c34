#include <string>

#include "arguments.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace swivel::command {

namespace {

#if defined(__clang__)
constexpr const char* compiler = "clang++ " __clang_version__;
#elif defined(__GNUC__)
constexpr const char* compiler = "g++ " __VERSION__;
#else
constexpr const char* compiler = "unknown";
#endif

}  // namespace

void add_info(command_line program) {
    command_line line = program.add_command("info", "Version, instruction sets and compiler of this build");
    line.set_footer(
        "The environment variable SWIVEL_ISA names another instruction set than the best usable one.\n\n"
        "Examples:\n"
        "  swivel info\n"
        "  SWIVEL_ISA=sse2 swivel info");
    line.set_action([] {
        select_isa(std::nullopt);
        output out("-");
        out.write(std::string("version:       ") + swivel::version() + "\nisa in use:    " +
                  swivel::name(swivel::active_isa()) + "\nisas compiled: " + isa_names(swivel::is_compiled) +
                  "\nisas usable:   " + isa_names(swivel::is_usable) + "\ncompiler:      " + compiler + "\n");
        out.commit();
    });
}

}  // namespace swivel::command
