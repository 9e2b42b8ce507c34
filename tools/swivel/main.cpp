// swivel: the command line of the library. The work is in the subcommands; here are the exit codes.

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "arguments.hpp"
#include "commands.hpp"
#include "failure.hpp"
#include "output.hpp"
#include "swivel/version.hpp"

namespace swivel::command {
namespace {

int failed(const std::string& message, int exit_code) {
    std::cout.flush();
    std::cerr << message << "\n";
    return exit_code;
}

void parse_and_run(CLI::App& program, int argc, char** argv, int& exit_code) {
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        // The codes of CLI11 tell more kinds of bad usage apart than anyone needs.
        exit_code = program.exit(e) == 0 ? exit_ok : exit_bad_usage;
    }
    if (exit_code == exit_ok) finish_standard_output();
}

int run(int argc, char** argv) {
    CLI::App program("Factors rotations into swing and twist.", "swivel");
    program.set_version_flag("--version", std::string("swivel ") + swivel::version());
    require_one_subcommand(program);
    program.footer(
        "Examples:\n"
        "  swivel decompose walk.bvh\n"
        "  swivel decompose walk.bvh --joint LeftHand --out left_hand.csv\n"
        "  printf 'qx qy qz qw\\n0 0 1 0\\n' | swivel eval decompose --axis z\n\n"
        "Exit codes: 0 done, 1 bad data or files, 2 bad usage.");
    add_info(program);
    add_decompose(program);
    add_eval(program);

    int exit_code = exit_ok;
    try {
        parse_and_run(program, argc, argv, exit_code);
        return exit_code;
    } catch (const bad_usage& e) {
        return failed(std::string(e.what()) + "\nRun with --help for more information.", exit_bad_usage);
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
