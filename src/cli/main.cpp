// The command `cleft`. It uses the public headers of libcleft and libcleft_io and nothing else of the project.
#include "commands.hpp"
#include "exit_code.hpp"
#include "label_lists.hpp"
#include "last_words.hpp"
#include "standard_output.hpp"

#include "cleft/cleft.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using cleft_cli::Command;

// The first screen that a new user sees: one line a command, and a path through them.
void describe(CLI::App& app)
{
    app.name("cleft");
    app.description("Makes conforming multi-material tetrahedral meshes from labelled volumes.");
    app.footer(std::string("Examples:\n"
                           "  cleft mesh atlas.nii.gz -o atlas.vtu           mesh all labels, sizes from the features\n"
                           "  cleft mesh head.nrrd -o head.msh --strip 0     leave the background label out\n"
                           "  cleft info head.nrrd                           what is in a volume or a mesh\n"
                           "  cleft check head.msh && cleft convert head.msh head.inp\n"
                           "  cleft render head.msh -o head.png --cut x=0.5  a picture, cut open\n"
                           "  cleft view head.msh -o head.html               look at it in a browser\n"
                           "`cleft COMMAND --help` tells all options of a command.\n\n") +
               cleft_cli::exit_code_help());
    app.set_version_flag("--version", std::string("cleft ") + cleft_version(nullptr, nullptr, nullptr) +
                                          (cleft_has_tetgen() != 0 ? "" : " (built without TetGen)"));
    // `cleft` alone prints an error and not the help of nothing.
    app.require_subcommand(1);
}

// As in other errors: "cleft view".
std::string name_of_command(const CLI::App& app)
{
    const auto commands = app.get_subcommands();
    return commands.empty() ? "cleft" : "cleft " + commands.front()->get_name();
}

int parse_and_run(int argc, char** argv)
{
    CLI::App app;
    describe(app);
    const std::vector<Command> commands = {
        cleft_cli::add_mesh_command(app),    cleft_cli::add_info_command(app),   cleft_cli::add_check_command(app),
        cleft_cli::add_convert_command(app), cleft_cli::add_sizing_command(app), cleft_cli::add_render_command(app),
        cleft_cli::add_view_command(app),
    };
    for (const Command& command : commands)
        // Texts of options are wrapped at 66 characters, so that lines end before column 100.
        command.parser->get_formatter()->column_width(32);
    std::vector<std::string> arguments(argv + 1, argv + argc);
    cleft_cli::join_label_lists(arguments);
    try {
        // CLI11 takes the arguments in reverse order.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        std::ostringstream text, complaint;
        // CLI11 has exit codes of its own, above 100. --help and --version come here, too, with 0.
        if (app.exit(error, text, complaint) != 0) {
            std::fprintf(stderr, "%s: %s", name_of_command(app).c_str(), complaint.str().c_str());
            return cleft_cli::EXIT_USAGE;
        }
        // Help goes through the same function as summaries, so that a full disk behind standard
        // output is noticed.
        cleft_cli::print_summary_text(text.str());
        return cleft_cli::EXIT_OK;
    }
    for (const Command& command : commands)
        if (command.parser->parsed())
            return command.run();
    return cleft_cli::EXIT_USAGE;
}

}  // namespace

int main(int argc, char** argv)
{
    cleft_cli::make_streams_safe();
    cleft_cli::tell_of_want_of_memory();
    try {
        return parse_and_run(argc, argv);
    } catch (const cleft_cli::Failure& failure) {
        std::fprintf(stderr, "cleft: %s\n", failure.what());
        return failure.exit_code;
        // Commands catch their failures in guarded(). What arrives here was thrown while arguments were
        // parsed.
    } catch (const std::bad_alloc&) {
        std::fputs("cleft: out of memory\n", stderr);
        return cleft_cli::EXIT_OUT_OF_MEMORY;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cleft: %s\n", error.what());
        return cleft_cli::EXIT_USAGE;
    }
}
