// swivel: the command line of the library. The work is in the subcommands; here are the exit codes.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>

#include "arguments.hpp"
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

// Help and version come as exceptions too.
int exit_code_of(const CLI::App& program, const CLI::ParseError& e) {
    std::ostringstream asked_for, complaint;
    const bool is_fine = program.exit(e, asked_for, complaint) == 0;
    output out("-");
    out.write(asked_for.str());
    out.commit();
    std::cerr << complaint.str();
    // The codes of CLI11 tell more kinds of bad usage apart than anyone needs.
    return is_fine ? exit_ok : exit_bad_usage;
}

int parse_and_run(int argc, char** argv) {
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
    try {
        program.parse(argc, argv);
        return exit_ok;
    } catch (const CLI::ParseError& e) {
        return exit_code_of(program, e);
    }
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
