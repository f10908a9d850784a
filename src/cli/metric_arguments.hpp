// --metric: wanted lengths that depend on the direction, from a file or one tensor for all places.
#pragma once

#include "handles.hpp"
#include "session.hpp"

#include <cleft/cleft_io.h>

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace cleft_cli
{

// What `mesh` and `sizing` say of it.
inline constexpr const char* kMetricHelp =
    "Wanted lengths that depend on the direction: a volume on the same grid\n"
    "with a symmetric tensor M for each voxel, or one of six numbers\n"
    "everywhere. An edge v has the wanted length where v.M.v is 1";

// It must outlive the CLI::App, which writes into it while it parses.
struct MetricArguments {
    std::string metric;  // a path or six numbers; "": none
    std::string order = "file";

    bool given() const { return !metric.empty(); }
    // The path, or "" where it is no file.
    std::string file() const;

    void add_to(CLI::App& app, const std::string& text, const std::string& group);
    // Of a file without a volume, the field is on the grid of the file.
    Sizing read(const Session& session, const cleft_volume* volume, const cleft_io_reading& reading, bool combine,
                const cleft_options* options) const;
};

// None if the mesh is too broken to be measured.
std::optional<cleft_metric_quality> look_at_metric(const Session& session, const cleft_mesh* mesh,
                                                   const cleft_sizing* sizing);

}  // namespace cleft_cli
