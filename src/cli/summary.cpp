// Lays out what a person reads: lines and tables of fixed width. Numbers are rounded here and
// nowhere else; the JSON report has all digits.
#include "summary.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cleft_cli
{
namespace
{

// The longest heading, "Estimate" or "Memory", and a gap.
constexpr std::size_t kFirstColumn = 11;

std::string triple(const std::array<double, 3>& numbers, const char* between = " x ")
{
    return significant(numbers[0]) + between + significant(numbers[1]) + between + significant(numbers[2]);
}

std::string box_text(const std::array<double, 3>& low, const std::array<double, 3>& high)
{
    return "(" + triple(low, ", ") + ") to (" + triple(high, ", ") + ")";
}

std::string row_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths)
{
    std::string row;
    for (std::size_t i = 0; i < cells.size(); ++i)
        row += right(cells[i], widths[i]) + (i + 1 < cells.size() ? "  " : "\n");
    return row;
}

// A row, and behind it the name of the label if it has one.
std::string named(const std::string& row, const std::string& name)
{
    return name.empty() ? row : row.substr(0, row.size() - 1) + "  " + name + "\n";
}

// "-" where there is no whole, such as an empty mesh.
std::string share_text(double part, double whole) { return whole > 0 ? decimals(100 * part / whole, 2) + " %" : "-"; }

}  // namespace

std::string summary_line(const std::string& heading, const std::string& text)
{
    return left(heading, kFirstColumn) + text + "\n";
}

std::string volume_line(const VolumeFindings& volume)
{
    std::array<double, 3> low{}, high{};
    volume.bounds(low, high);
    const std::string dims =
        grouped(volume.dims[0]) + " x " + grouped(volume.dims[1]) + " x " + grouped(volume.dims[2]);
    return summary_line("Volume", dims + " voxels of " + triple(volume.spacing) + ", " +
                                      plural(static_cast<int64_t>(volume.voxels.size()), "label")) +
           summary_line("Box", box_text(low, high));
}

std::string labels_table(const VolumeFindings& volume)
{
    // A label of 32 bits has at most 11 characters. Thirteen hold billions with commas, or six
    // digits with an exponent.
    const std::vector<std::size_t> widths = {11, 13, 13, 9};
    std::string table = row_of({"label", "voxels", "volume", "share"}, widths);
    for (const auto& [label, voxels] : volume.voxels)
        table += named(row_of({std::to_string(label), grouped(voxels),
                               significant(static_cast<double>(voxels) * volume.voxel_volume(), 6),
                               share_text(static_cast<double>(voxels), static_cast<double>(volume.voxel_count()))},
                              widths),
                       volume.names.at(label));
    return table;
}

std::string labels_table(const MeshFindings& mesh)
{
    const std::vector<std::size_t> widths = {11, 13, 13, 9};
    std::string table = row_of({"label", "tetrahedra", "volume", "share"}, widths);
    for (const auto& [label, totals] : mesh.labels)
        table += named(row_of({std::to_string(label), grouped(totals.tets), significant(totals.volume, 6),
                               share_text(totals.volume, mesh.quality.total_volume)},
                              widths),
                       mesh.names.at(label));
    return table;
}

std::string angles_line(const cleft_quality& q)
{
    return summary_line(
        "Angles", decimals(q.min_dihedral, 2) + " to " + decimals(q.max_dihedral, 2) +
                      " degrees between faces; tetrahedra below 5, 10, 15, 20: " + grouped(q.tets_below_5) + ", " +
                      grouped(q.tets_below_10) + ", " + grouped(q.tets_below_15) + ", " + grouped(q.tets_below_20));
}

std::string mesh_lines(const MeshFindings& mesh)
{
    const cleft_quality& q = mesh.quality;
    std::string counts = plural(mesh.tets, "tetrahedron", "tetrahedra") + ", " + plural(mesh.points, "point") + ", " +
                         plural(static_cast<int64_t>(mesh.labels.size()), "label");
    if (mesh.interface_triangles)
        counts += ", " + plural(*mesh.interface_triangles, "interface triangle");
    std::string text = summary_line("Mesh", counts);
    // Angles and edges of no tetrahedra have no meaning.
    if (mesh.tets == 0)
        return text;
    text += summary_line("Box", box_text(mesh.low, mesh.high));
    text += angles_line(q);
    text += summary_line("Shapes", "radius ratio " + decimals(q.radius_ratio_median, 2) + " (median), " +
                                       decimals(q.radius_ratio_95, 2) + " (95 %), " + decimals(q.radius_ratio_max, 2) +
                                       " (greatest); 1 is the regular tetrahedron");
    text += summary_line(
        "Edges", significant(q.min_edge) + " to " + significant(q.max_edge) + ", mean " + significant(q.mean_edge));
    return text;
}

namespace
{

std::string angle_histogram(const char* heading, const int64_t* counts)
{
    // 36 bins of 5 degrees, as cleft_quality has them. 1 guards the division for an empty mesh.
    const int64_t most = std::max<int64_t>(1, *std::max_element(counts, counts + 36));
    int64_t total = 0;
    for (int bin = 0; bin < 36; ++bin)
        total += counts[bin];
    std::string text = std::string(heading) + ", six a tetrahedron\n";
    for (int bin = 0; bin < 36; ++bin) {
        // Meshes have no angles near 0 and 180 degrees; empty bins would only push the table off
        // the screen.
        if (counts[bin] == 0)
            continue;
        const double share = static_cast<double>(counts[bin]) / static_cast<double>(most);
        text += right(std::to_string(5 * bin), 5) + " -" + right(std::to_string(5 * bin + 5), 4) +
                right(grouped(counts[bin]), 14) +
                right(share_text(static_cast<double>(counts[bin]), static_cast<double>(total)), 10) + "  " +
                // Rounded up, so that a bin with one angle has a mark.
                std::string(static_cast<std::size_t>(std::ceil(40 * share)), '#') + "\n";
    }
    return text;
}

}  // namespace

std::string dihedral_histogram(const cleft_quality& quality)
{
    return angle_histogram("Dihedral angles", quality.dihedral_histogram);
}

std::string dihedral_histogram(const cleft_metric_quality& quality)
{
    return angle_histogram("Dihedral angles in the metric", quality.dihedral_histogram);
}

std::string metric_lines(const cleft_metric_quality& q)
{
    if (q.tet_count == 0)
        return "";
    return summary_line("Metric", share_text(static_cast<double>(q.edges_in_range), static_cast<double>(q.edge_count)) +
                                      " of " + plural(q.edge_count, "edge") +
                                      " are 1/sqrt(2) to sqrt(2) long; lengths " + decimals(q.edge_least, 2) + " to " +
                                      decimals(q.edge_greatest, 2) + ", median " + decimals(q.edge_median, 2) +
                                      ", 1 % and 99 % " + decimals(q.edge_01, 2) + " and " + decimals(q.edge_99, 2)) +
           summary_line("", "mean ratio " + decimals(q.mean_ratio_least, 3) + " (least), " +
                                decimals(q.mean_ratio_01, 3) + " (1 %), " + decimals(q.mean_ratio_median, 3) +
                                " (median); 1 is the regular tetrahedron") +
           summary_line("", "angles " + decimals(q.min_dihedral, 2) + " to " + decimals(q.max_dihedral, 2) +
                                " degrees between faces, in the metric");
}

namespace
{

// Empty if all large pieces are as they were.
std::string pieces_line(const std::vector<LabelFindings>& rows)
{
    int64_t all = 0, lost = 0, broken = 0, joined = 0;
    for (const LabelFindings& row : rows) {
        all += row.large_components;
        lost += row.large_components_lost;
        broken += row.large_components_broken;
        joined += row.large_components_joined;
    }
    // The usual case needs no line.
    if (lost + broken + joined == 0)
        return "";
    return "of " + plural(all, "piece") + " of more than 30 voxels " + plural(lost, "is", "are") + " lost, " +
           grouped(broken) + " broke, and " + grouped(joined) + " grew together with others of their label\n";
}

}  // namespace

std::string label_report_table(const std::vector<LabelFindings>& rows, const std::function<bool(int32_t)>& left_out,
                               std::size_t limit)
{
    std::vector<LabelFindings> kept;
    for (const LabelFindings& row : rows)
        if (!left_out(row.label))
            kept.push_back(row);
    // Before the table is cut: it counts all labels that are kept.
    const std::string pieces_of_all = pieces_line(kept);
    std::string text = "Labels";
    if (rows.size() > kept.size())
        text += ", " + grouped(static_cast<int64_t>(rows.size() - kept.size())) + " left out as asked";
    if (kept.size() > limit) {
        // Of many labels those that differ most are of interest. Equal ones stay in the order of
        // their numbers.
        std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) {
            return std::fabs(difference_percent(a)) > std::fabs(difference_percent(b));
        });
        text += ", the " + std::to_string(limit) + " of " + std::to_string(kept.size()) +
                " whose volumes differ most (all of them: --verbose, --json)";
        kept.resize(limit);
    }
    text += "\n";
    const std::vector<std::size_t> widths = {11, 12, 13, 13, 8, 12, 11};
    text += row_of({"label", "voxels", "voxel volume", "mesh volume", "differ", "tetrahedra", "pieces"}, widths);
    for (const LabelFindings& row : kept) {
        const std::string pieces = std::to_string(row.voxel_components) + " -> " + std::to_string(row.mesh_components);
        text += named(row_of({std::to_string(row.label), grouped(row.voxels), significant(row.voxel_volume, 6),
                              significant(row.mesh_volume, 6), decimals(difference_percent(row), 2) + " %",
                              grouped(row.tets), row.lost != 0 ? "LOST" : pieces},
                             widths),
                      row.name);
    }
    return text + pieces_of_all;
}

std::string distances_table(std::vector<cleft_distance> rows, const VolumeFindings& volume, std::size_t limit)
{
    if (rows.empty())
        return "";
    const std::size_t all = rows.size();
    const double voxel = *std::min_element(volume.spacing.begin(), volume.spacing.end());
    const auto greatest = [](const cleft_distance& d) { return std::max(d.mesh_greatest, d.volume_greatest); };
    std::string text = "Distances between interfaces of mesh and volume, in voxels";
    if (all > limit) {
        // Equal ones stay in the order of their labels.
        std::stable_sort(rows.begin(), rows.end(),
                         [&](const auto& a, const auto& b) { return greatest(a) > greatest(b); });
        rows.resize(limit);
        text += ", the " + std::to_string(limit) + " of " + std::to_string(all) +
                " with the greatest (all of them: --verbose, --json)";
    }
    const std::vector<std::size_t> widths = {20, 12, 10, 8, 10, 10, 8, 10};
    text += "\n" +
            row_of({"labels", "triangles", "from mesh", "99 %", "greatest", "from voxels", "99 %", "greatest"}, widths);
    const auto in_voxels = [&](double length) { return decimals(length / voxel, 2); };
    for (const cleft_distance& d : rows) {
        std::string labels = std::to_string(d.first) + " " + std::to_string(d.second);
        if (d.is_line != 0)
            labels += " " + std::to_string(d.third);
        text += row_of(
            {labels, grouped(d.elements), in_voxels(d.mesh_mean), in_voxels(d.mesh_99), in_voxels(d.mesh_greatest),
             in_voxels(d.volume_mean), in_voxels(d.volume_99), in_voxels(d.volume_greatest)},
            widths);
    }
    return text;
}

std::string time_line(const Session& session, int64_t tets)
{
    const StageFigures process = process_figures();
    std::string text = seconds_text(session.elapsed_seconds()) + ", " + seconds_text(process.cpu_seconds) + " of CPU";
    // A rate for each CPU second compares machines with different numbers of cores.
    if (process.cpu_seconds > 0)
        text +=
            ", " + grouped(std::llround(static_cast<double>(tets) / process.cpu_seconds)) + " tetrahedra a CPU second";
    return summary_line("Time", text) + summary_line("Memory", bytes_text(process.peak_bytes) + " at the peak");
}

namespace
{

std::string stage_row(const StageFigures& stage, double all_seconds)
{
    return left((stage.part_of.empty() ? "  " : "    ") + stage.name, 26) + right(seconds_text(stage.seconds), 12) +
           right(decimals(100 * stage.seconds / all_seconds, 1) + " %", 10) +
           right(seconds_text(stage.cpu_seconds), 12) + " of CPU" + right(bytes_text(stage.peak_bytes), 10) + "\n";
}

// Stages are noted in the order in which they end. Here each stands before its parts.
std::vector<StageFigures> wholes_first(const std::vector<StageFigures>& stages)
{
    std::vector<std::vector<StageFigures>> groups;  // of a stage and its parts
    for (const StageFigures& stage : stages) {
        const auto parts = std::stable_partition(
            groups.begin(), groups.end(), [&](const auto& group) { return group.front().part_of != stage.name; });
        std::vector<StageFigures> group{stage};
        for (auto part = parts; part != groups.end(); ++part)
            group.insert(group.end(), part->begin(), part->end());
        groups.erase(parts, groups.end());
        groups.push_back(group);
    }
    std::vector<StageFigures> all;
    for (const auto& group : groups)
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

}  // namespace

std::string stages_table(const Session& session)
{
    std::string text = "Stages\n";
    for (const StageFigures& stage : wholes_first(session.stages()))
        text += stage_row(stage, session.elapsed_seconds());
    return text;
}

std::string validation_lines(const cleft_validation& validation, const std::string& first_fault)
{
    if (validation.valid != 0)
        return summary_line("Valid", "yes");
    std::string text = summary_line("Valid", "NO: " + first_fault);
    // Only kinds of faults that were found are listed.
    const std::pair<const char*, int64_t> counts[] = {
        {"tetrahedra turned inside out", validation.negative_tets},
        {"flat tetrahedra", validation.flat_tets},
        {"tetrahedra that name a point twice", validation.repeated_corners},
        {"faces of more than two tetrahedra", validation.crowded_faces},
        {"faces whose two tetrahedra lie on one side", validation.folded_faces},
        {"hull triangles off the box", validation.hull_off_box},
        {"open edges of interfaces", validation.open_interface_edges},
        {"points of no tetrahedron", validation.unused_points},
        {"repeated points", validation.repeated_points},
    };
    for (const auto& [what, count] : counts)
        if (count > 0)
            text += std::string(kFirstColumn, ' ') + grouped(count) + " " + what + "\n";
    return text;
}

}  // namespace cleft_cli
