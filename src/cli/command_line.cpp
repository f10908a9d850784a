// CLI11 does the work; its exit codes, above 100, are not those of these programs.
#include "command_line.hpp"

#include "exit_code.hpp"
#include "label_lists.hpp"
#include "program.hpp"

#include "cleft/cleft.h"

#include <CLI/CLI.hpp>

#include <sstream>
#include <vector>

namespace cleft_cli
{
namespace
{

// As in other errors: "cleft view".
std::string name_of_command(const CLI::App& app)
{
    const auto commands = app.get_subcommands();
    return commands.empty() ? kProgram : std::string(kProgram) + " " + commands.front()->get_name();
}

}  // namespace

void describe(CLI::App& app, const std::string& what_it_does, const std::string& examples,
              const std::string& beside_version)
{
    const std::string name = kProgram;
    app.name(name);
    app.description(what_it_does);
    app.footer("Examples:\n" + examples + "`" + name + " COMMAND --help` tells all options of a command.\n\n" +
               exit_code_help());
    app.set_version_flag("--version", name + " " + cleft_version(nullptr, nullptr, nullptr) + beside_version);
    // The name alone prints an error and not the help of nothing.
    app.require_subcommand(1);
    for (CLI::App* command : app.get_subcommands({}))
        // Texts of options are wrapped at 66 characters, so that lines end before column 100.
        command->get_formatter()->column_width(32);
}

std::optional<Said> parse_words(CLI::App& app, int argc, char** argv)
{
    std::vector<std::string> words(argv + 1, argv + argc);
    join_label_lists(words);
    try {
        // CLI11 takes the words in reverse order.
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        std::ostringstream text, complaint;
        // --help and --version come here, too, with 0.
        if (app.exit(error, text, complaint) == 0)
            return Said{text.str(), false};
        return Said{name_of_command(app) + ": " + complaint.str(), true};
    }
}

}  // namespace cleft_cli
