#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <sstream>

#include "output.hpp"

namespace swivel::command {

command_line command_line::add_command(const std::string& name, const std::string& description) {
    return command_line(*app_->add_subcommand(name, description));
}

void command_line::require_subcommand() {
    // What CLI::App::require_subcommand(1) does, but an unknown subcommand is named before one is asked for.
    app_->require_subcommand(0, 1);
    app_->final_callback([app = app_] {
        if (app->get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
    });
}

void command_line::set_footer(const std::string& text) { app_->footer(text); }

void command_line::set_action(std::function<void()> action) { app_->callback(std::move(action)); }

void command_line::add_flag(const std::string& name, bool& value, const std::string& description) {
    app_->add_flag(name, value, description);
}

void command_line::add_operand(const std::string& name, std::string& value, const std::string& description,
                               bool is_required) {
    app_->add_option(name, value, description)->required(is_required);
}

void command_line::add_text(const std::string& name, const std::string& type, std::string& value,
                            const std::string& description) {
    app_->add_option(name, value, description)->type_name(type);
}

void command_line::add_texts(const std::string& name, const std::string& type,
                             std::vector<std::string>& values, const std::string& description) {
    // One with each name of the option, not all words that follow.
    app_->add_option(name, values, description)
        ->type_name(type)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void command_line::add_value(const std::string& name, const std::string& type,
                             const std::function<void(const std::string&)>& read,
                             const std::string& description) {
    app_->add_option_function<std::string>(name, read, description)->type_name(type);
}

int run_command_line(int argc, char** argv, const std::string& description, const std::string& version,
                     const std::function<void(command_line)>& add_commands) {
    CLI::App program(description, "swivel");
    program.set_version_flag("--version", version);
    add_commands(command_line(program));
    try {
        program.parse(argc, argv);
        return exit_ok;
    } catch (const CLI::ParseError& e) {
        // Help and version come as exceptions too.
        std::ostringstream asked_for, complaint;
        const bool is_fine = program.exit(e, asked_for, complaint) == 0;
        output out("-");
        out.write(asked_for.str());
        out.commit();
        std::cerr << complaint.str();
        // The codes of CLI11 tell more kinds of bad usage apart than anyone needs.
        return is_fine ? exit_ok : exit_bad_usage;
    }
}

}  // namespace swivel::command
