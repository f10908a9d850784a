// The subcommands of `cleft`: each adds its arguments to the parser and gives back how to run it.
#pragma once

#include <functional>

namespace CLI
{
class App;
}

namespace cleft_cli
{

struct Command {
    CLI::App* parser;
    std::function<int()> run;  // answers the exit code
};

Command add_mesh_command(CLI::App& app);
Command add_info_command(CLI::App& app);
Command add_check_command(CLI::App& app);
Command add_convert_command(CLI::App& app);
Command add_sizing_command(CLI::App& app);

}  // namespace cleft_cli
