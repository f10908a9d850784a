// The command `cleft`. It uses the public headers of libcleft and libcleft_io and nothing else of the project.
#include "command_line.hpp"
#include "commands.hpp"
#include "exit_code.hpp"
#include "last_words.hpp"
#include "standard_output.hpp"

#include "cleft/cleft.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <vector>

namespace
{

using cleft_cli::Command;

constexpr char kExamples[] =
    "  cleft mesh atlas.nii.gz -o atlas.vtu           mesh all labels, sizes from the features\n"
    "  cleft mesh head.nrrd -o head.msh --strip 0     leave the background label out\n"
    "  cleft info head.nrrd                           what is in a volume or a mesh\n"
    "  cleft check head.msh && cleft convert head.msh head.inp\n"
    "  cleft render head.msh -o head.png --cut x=0.5  a picture, cut open\n"
    "  cleft view head.msh -o head.html               look at it in a browser\n";

int parse_and_run(int argc, char** argv)
{
    CLI::App app;
    const std::vector<Command> commands = {
        cleft_cli::add_mesh_command(app),    cleft_cli::add_info_command(app),   cleft_cli::add_check_command(app),
        cleft_cli::add_convert_command(app), cleft_cli::add_sizing_command(app), cleft_cli::add_render_command(app),
        cleft_cli::add_view_command(app),
    };
    cleft_cli::describe(app, "Makes conforming multi-material tetrahedral meshes from labelled volumes.", kExamples,
                        cleft_has_tetgen() != 0 ? "" : " (built without TetGen)");
    if (const auto said = cleft_cli::parse_words(app, argc, argv)) {
        if (said->is_complaint) {
            std::fputs(said->text.c_str(), stderr);
            return cleft_cli::EXIT_USAGE;
        }
        // Help goes through the same function as summaries, so that a full disk behind standard output is noticed.
        cleft_cli::print_summary_text(said->text);
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
