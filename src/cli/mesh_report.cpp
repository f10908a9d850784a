// Reads a report and compares what it counts with the mesh. Two meshes of the same counts in the same place are taken
// for one.
#include "mesh_report.hpp"

#include "text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace cleft_cli
{
namespace
{

// What a report counts of its mesh.
struct Counts {
    int64_t points = 0;
    int64_t tets = 0;
    std::map<int32_t, int64_t> labels;    // tetrahedra of each
    std::array<double, 3> low{}, high{};  // bounding box
};

[[noreturn]] void refuse(const std::string& path, const std::string& what)
{
    throw Failure(EXIT_CANNOT_READ, CLEFT_ERROR_FORMAT, "'" + path + "' is " + what);
}

Counts counts_of_report(const nlohmann::json& report, const std::string& path)
{
    try {
        const nlohmann::json& mesh = report.at("mesh");
        Counts counts;
        counts.points = mesh.at("points").get<int64_t>();
        counts.tets = mesh.at("tets").get<int64_t>();
        counts.low = mesh.at("low").get<std::array<double, 3>>();
        counts.high = mesh.at("high").get<std::array<double, 3>>();
        for (const nlohmann::json& row : mesh.at("labels"))
            counts.labels[row.at("label").get<int32_t>()] = row.at("tets").get<int64_t>();
        return counts;
    } catch (const nlohmann::json::exception&) {
        refuse(path, "no report of a mesh: it lacks \"mesh\" with points, tetrahedra, labels and box");
    }
}

Counts counts_of(const cleft_mesh* mesh)
{
    Counts counts;
    counts.points = cleft_mesh_point_count(mesh);
    counts.tets = cleft_mesh_tet_count(mesh);
    const double* points = cleft_mesh_points(mesh);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        counts.low[axis] = std::numeric_limits<double>::infinity();
        counts.high[axis] = -counts.low[axis];
    }
    for (int64_t i = 0; i < 3 * counts.points; ++i) {
        const auto axis = static_cast<std::size_t>(i % 3);
        counts.low[axis] = std::min(counts.low[axis], points[i]);
        counts.high[axis] = std::max(counts.high[axis], points[i]);
    }
    const int32_t* labels = cleft_mesh_tet_labels(mesh);
    for (int64_t t = 0; t < counts.tets; ++t)
        ++counts.labels[labels[t]];
    return counts;
}

// Within what formats of few digits leave of coordinates.
bool has_box(const Counts& mesh, const Counts& report)
{
    constexpr double kShare = 1e-4;  // of the longest side
    double longest = 0, off = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        longest = std::max(longest, mesh.high[axis] - mesh.low[axis]);
        off =
            std::max({off, std::abs(mesh.low[axis] - report.low[axis]), std::abs(mesh.high[axis] - report.high[axis])});
    }
    return off <= kShare * longest;
}

std::string box_text(const Counts& counts)
{
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis)
        text += (axis > 0 ? " x " : "") + significant(counts.low[axis]) + " to " + significant(counts.high[axis]);
    return text;
}

// "" if they are the same.
std::string difference(const Counts& report, const Counts& mesh, const std::string& mesh_path)
{
    const auto told = [&](const std::string& of, const std::string& here, const std::string& there) {
        return "it has " + here + of + ", and '" + mesh_path + "' has " + there;
    };
    if (report.tets != mesh.tets)
        return told(" tetrahedra", grouped(report.tets), grouped(mesh.tets));
    if (report.points != mesh.points)
        return told(" points", grouped(report.points), grouped(mesh.points));
    std::set<int32_t> labels;
    for (const Counts* counts : {&report, &mesh})
        for (const auto& [label, tets] : counts->labels)
            labels.insert(label);
    for (const int32_t label : labels) {
        const auto count = [&](const Counts& of) { return of.labels.count(label) != 0 ? of.labels.at(label) : 0; };
        if (count(report) != count(mesh))
            return told(" tetrahedra of label " + std::to_string(label), grouped(count(report)), grouped(count(mesh)));
    }
    return has_box(mesh, report) ? "" : told("", "the box " + box_text(report), box_text(mesh));
}

}  // namespace

std::string read_mesh_report(const std::string& path, const cleft_mesh* mesh, const std::string& mesh_path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    const nlohmann::json report = nlohmann::json::parse(text.str(), nullptr, false);
    if (!file || report.is_discarded())
        refuse(path, "no report: it is not JSON");
    const std::string differs = difference(counts_of_report(report, path), counts_of(mesh), mesh_path);
    if (!differs.empty())
        refuse(path, "the report of another mesh: " + differs);
    return text.str();
}

}  // namespace cleft_cli
