// swivel: the command line of the library. The work is in the subcommands; here are the exit codes.

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands.hpp"
#include "failure.hpp"
#include "output.hpp"
#include "swivel/version.hpp"

namespace swivel::command {
namespace {

int failed(const char* message, int exit_code) noexcept {
    std::fputs(message, stderr);
    std::fputs("\n", stderr);
    if (exit_code == exit_bad_usage) std::fputs("Run with --help for more information.\n", stderr);
    return exit_code;
}

int parse_and_run(int argc, char** argv) {
    return run_command_line(argc, argv, "Factors rotations into swing and twist.",
                            std::string("swivel ") + swivel::version(), [](command_line program) {
                                program.require_subcommand();
                                program.set_footer(
                                    "Examples:\n"
                                    "  swivel decompose walk.bvh\n"
                                    "  swivel decompose walk.bvh --joint LeftHand --out left_hand.csv\n"
                                    "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval decompose --axis z\n\n"
                                    "Exit codes: 0 done, 1 bad data or files, 2 bad usage.");
                                add_info(program);
                                add_decompose(program);
                                add_eval(program);
                            });
}

int run(int argc, char** argv) noexcept {
    try {
        return parse_and_run(argc, argv);
    } catch (const bad_usage& e) {
        return failed(e.what(), exit_bad_usage);
    } catch (const closed_pipe&) {
        return exit_bad_data;
    } catch (const std::bad_alloc&) {
        return failed("out of memory", exit_bad_data);
    } catch (const std::exception& e) {
        return failed(e.what(), exit_bad_data);
    }
}

}  // namespace
}  // namespace swivel::command

int main(int argc, char** argv) {
    swivel::command::prepare_standard_streams();
    return swivel::command::run(argc, argv);
}
