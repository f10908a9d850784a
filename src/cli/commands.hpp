// The subcommands of `cleft`: each adds its arguments to the parser and gives back how to run it.
#pragma once

#include <functional>

namespace CLI
{
class App;
}

namespace cleft_cli
{

// `parser` is owned by the CLI::App. `run` is to be called once at most, and only if the parser was
// chosen.
struct Command {
    CLI::App* parser;
    std::function<int()> run;  // answers the exit code
};

// `app` must outlive the Command. No exception leaves run(): see guarded().
Command add_mesh_command(CLI::App& app);
Command add_info_command(CLI::App& app);
Command add_check_command(CLI::App& app);
Command add_convert_command(CLI::App& app);
Command add_sizing_command(CLI::App& app);
Command add_render_command(CLI::App& app);
Command add_view_command(CLI::App& app);

}  // namespace cleft_cli
