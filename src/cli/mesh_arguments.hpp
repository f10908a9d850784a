// What `cleft mesh` is asked to do.
#pragma once

#include "metric_arguments.hpp"
#include "option_arguments.hpp"
#include "session.hpp"
#include "view_page.hpp"
#include "volume_arguments.hpp"

#include <string>
#include <vector>

namespace cleft_cli
{

// It must outlive the CLI::App, which writes into it while it parses.
struct MeshArguments {
    VolumeArguments input;
    OptionArguments options;
    RunArguments run;
    std::vector<std::string> outputs;
    std::string msh_version = "4.1";
    std::string sizing_file;
    MetricArguments metric;
    std::string background_file;
    std::string names;  // path of a table, or ""
    PageArguments view;
    bool combine = false;
    bool check = false;
    bool estimate = false;
    bool distances = false;

    bool left_out(int32_t label) const { return options.leaves_out(label); }
    // With --quiet and no report nobody sees the figures, so they are not computed.
    bool has_report() const { return run.prints() || !run.json.empty() || !view.output.empty(); }
    // What the run consists of.
    std::vector<Part> parts() const;

    void add_to(CLI::App& parser);
};

}  // namespace cleft_cli
