// Writes the page: its parts, and between them the meshes. Numbers and texts are JSON in an element that no browser
// runs; arrays are base64 in others. docs/formats.md says what the page promises.
#include "io/view/write_page.hpp"

#include "base/number_text.hpp"
#include "base/stage.hpp"
#include "base/utf8.hpp"
#include "io/atomic_file.hpp"
#include "io/label_colours.hpp"
#include "io/view/json_text.hpp"
#include "io/view/mesh_figures.hpp"
#include "io/view/packed_numbers.hpp"
#include "io/view/page_parts.hpp"
#include "io/view/page_tets.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

// Coordinates are whole numbers of steps, so many along the longest side of the box: as fine as the numbers of 32 bits
// that a graphics card takes.
constexpr double kSteps = 1 << 24;

struct Arrays {
    std::string points, tets, materials, numbers;
};

// The grid of coordinates of one mesh.
struct Grid {
    Vector3 low{};
    double step = 1;

    explicit Grid(const MeshFigures& figures) : low(figures.low)
    {
        double longest = 0;
        for (size_t axis = 0; axis < 3; ++axis)
            longest = std::max(longest, figures.high[axis] - figures.low[axis]);
        if (longest > 0)
            step = longest / kSteps;
    }
};

std::string packed_points(const MeshView& mesh, const PageTets& shown, const Grid& grid, const Run& run)
{
    std::vector<int32_t> steps;
    steps.reserve(3 * shown.points.size());
    for (const int32_t p : shown.points)
        for (size_t axis = 0; axis < 3; ++axis) {
            const double coordinate = mesh.points[3 * static_cast<size_t>(p) + axis];
            steps.push_back(static_cast<int32_t>(std::lround((coordinate - grid.low[axis]) / grid.step)));
        }
    return pack(steps, 3, Differences::kColumn, run);
}

// Corners as positions in the list of points. Tetrahedra of the other orientation are turned, as the page draws the
// outer side of faces.
std::string packed_tets(const MeshView& mesh, const PageTets& shown, const Run& run)
{
    std::vector<int32_t> place(static_cast<size_t>(mesh.point_count), -1);
    for (size_t i = 0; i < shown.points.size(); ++i)
        place[static_cast<size_t>(shown.points[i])] = static_cast<int32_t>(i);
    std::vector<int32_t> corners;
    corners.reserve(4 * shown.tets.size());
    for (const int64_t t : shown.tets) {
        run.check_at(t);
        for (int64_t c = 0; c < 4; ++c)
            corners.push_back(place[static_cast<size_t>(mesh.tets[4 * t + c])]);
        if (signed_volume(corners_of(mesh, t)) < 0)
            std::swap(corners[corners.size() - 1], corners[corners.size() - 2]);
    }
    return pack(corners, 4, Differences::kRow, run);
}

Arrays arrays_of(const MeshView& mesh, const PageTets& shown, const Grid& grid, const Run& run)
{
    std::vector<int32_t> materials;
    std::vector<int32_t> numbers;  // of the tetrahedra in the mesh
    for (const int64_t t : shown.tets) {
        run.check_at(t);
        materials.push_back(static_cast<int32_t>(mesh.label_index(mesh.tet_labels[t])));
        numbers.push_back(static_cast<int32_t>(t));
    }
    // What the arrays of a large mesh take.
    constexpr const char* kPacking = "page: packing";
    Steps steps(run, {{kPacking, 3}, {kPacking, 6}, {kPacking, 1}});
    Arrays arrays;
    arrays.points = packed_points(mesh, shown, grid, steps.next());
    arrays.tets = packed_tets(mesh, shown, steps.next());
    const Run last = steps.next();
    arrays.materials = pack(materials, 1, Differences::kColumn, last);
    // Otherwise they are 0, 1, 2, ...
    if (shown.reduction != Reduction::kNone)
        arrays.numbers = pack(numbers, 1, Differences::kColumn, last);
    return arrays;
}

void add_labels(const MeshView& mesh, const MeshFigures& figures, JsonText& json)
{
    json.key("labels").open('[');
    for (size_t l = 0; l < mesh.labels.size(); ++l) {
        const Colour colour = colour_of_label(mesh.labels[l]);
        json.open('{').field("label", mesh.labels[l]).field("name", mesh.names[l]);
        json.field("tets", figures.labels[l].tets).field("volume", figures.labels[l].volume);
        json.list("colour", std::initializer_list<int>{colour.red, colour.green, colour.blue}).close('}');
    }
    json.close(']');
}

void add_quality(const cleft_quality& quality, JsonText& json)
{
    json.key("quality").open('{');
    json.field("min_dihedral", quality.min_dihedral).field("max_dihedral", quality.max_dihedral);
    json.field("radius_ratio_median", quality.radius_ratio_median).field("radius_ratio_max", quality.radius_ratio_max);
    json.field("min_edge", quality.min_edge).field("mean_edge", quality.mean_edge);
    json.field("max_edge", quality.max_edge).field("total_volume", quality.total_volume);
    json.list("dihedral_histogram", quality.dihedral_histogram).close('}');
}

void add_worst(const MeshView& mesh, const char* key, const std::vector<WorstTet>& tets, JsonText& json)
{
    json.key(key).open('[');
    for (const WorstTet& tet : tets) {
        json.open('{')
            .field("tet", tet.tet)
            .field("label", mesh.tet_labels[tet.tet])
            .field("least_angle", tet.shape.least_angle)
            .field("greatest_angle", tet.shape.greatest_angle)
            .field("radius_ratio", tet.shape.radius_ratio)
            .field("volume", tet.shape.volume);
        json.key("corners").open('[');
        for (const Vector3& corner : corners_of(mesh, tet.tet))
            for (const double coordinate : corner)
                json.value(coordinate);
        json.close(']').close('}');
    }
    json.close(']');
}

constexpr const char* name_of(Reduction reduction)
{
    return reduction == Reduction::kNone ? "" : reduction == Reduction::kInterfaces ? "interfaces" : "middle";
}

void add_mesh(const PageMesh& page, const MeshFigures& figures, const PageTets& shown, JsonText& json)
{
    const Grid grid(figures);
    json.open('{').field("title", page.title).field("points", page.view.point_count);
    json.field("tets", page.view.tet_count).field("shown_points", shown.points.size());
    json.field("shown_tets", shown.tets.size()).field("reduction", name_of(shown.reduction));
    json.list("low", figures.low).list("high", figures.high).field("step", grid.step);
    add_labels(page.view, figures, json);
    add_quality(page.quality, json);
    json.key("worst").open('{');
    add_worst(page.view, "angle", figures.by_angle, json);
    add_worst(page.view, "ratio", figures.by_ratio, json);
    json.close('}').close('}');
}

void print_element(AtomicFile& file, const std::string& id, const char* type, const std::string& text)
{
    file.print("<script type=\"", type, "\" id=\"", id, "\">", text, "</script>\n");
}

// The page tells it, too. Who makes it may not open it.
void warn_of_reduction(const PageMesh& page, const PageTets& shown, const Run& run)
{
    if (shown.reduction == Reduction::kNone)
        return;
    run.warn("'" + page.title + "' has " + std::to_string(page.view.tet_count) + " tetrahedra, and the page shows " +
             std::to_string(shown.tets.size()) + " of them, those " +
             (shown.reduction == Reduction::kInterfaces ? "at interfaces and at the hull" : "around the middle"));
}

// Of two meshes that are not to be seen well by one camera: a sentence on the axis where they are farthest apart.
std::string places_text(const std::vector<PageMesh>& meshes, const std::vector<MeshFigures>& figures)
{
    // With less in common, one of them is a speck, or lies outside the picture when the other one fills it.
    constexpr double kLeastShare = 0.1;
    double least = kLeastShare;
    std::string text;
    for (size_t axis = 0; meshes.size() == 2 && axis < 3; ++axis) {
        const auto low = [&](size_t i) { return figures[i].low[axis]; };
        const auto high = [&](size_t i) { return figures[i].high[axis]; };
        const double both = std::min(high(0), high(1)) - std::max(low(0), low(1));
        const double all = std::max(high(0), high(1)) - std::min(low(0), low(1));
        if (!(all > 0 && both / all < least))
            continue;
        least = both / all;
        const auto range = [&](size_t i) { return number_text(low(i)) + " to " + number_text(high(i)); };
        text = "'" + printable(meshes[0].title) + "' and '" + printable(meshes[1].title) +
               "' lie in different places or have different sizes, so one camera hardly shows both: along " +
               "xyz"[axis] + ", one reaches from " + range(0) + " and the other from " + range(1);
    }
    return text;
}

// Shapes are quotients of products of up to six lengths, which overflow or vanish far beyond these bounds.
void check_extent(const PageMesh& page, const MeshFigures& figures)
{
    constexpr double kLeastExtent = 1e-30, kGreatestExtent = 1e30;
    double extent = 0;
    for (size_t axis = 0; axis < 3; ++axis)
        extent = std::max(extent, figures.high[axis] - figures.low[axis]);
    // A mesh of flat tetrahedra may have no extent at all.
    if (extent > kGreatestExtent || (extent > 0 && extent < kLeastExtent))
        throw Error(CLEFT_ERROR_ARGUMENT, "the longest side of the box of '" + page.title + "' is " +
                                              number_text(extent) + "; a page can show 1e-30 to 1e30");
}

// Prints the arrays and the report of a mesh, and adds the rest to `json`.
MeshFigures print_mesh(AtomicFile& file, const PageMesh& page, size_t number, const PageOptions& options,
                       const Run& run, JsonText& json)
{
    constexpr const char* kBytes = "application/octet-stream";
    Steps steps(run, {{"page: figures", 3}, {"page: tetrahedra", 0.2}, {nullptr, 6}});
    const MeshFigures figures = figures_of(page.view, steps.next());
    check_extent(page, figures);
    const PageTets shown = choose_tets(page.view, page.surface, figures, options.max_tets, steps.next());
    warn_of_reduction(page, shown, run);
    add_mesh(page, figures, shown, json);
    const Arrays arrays = arrays_of(page.view, shown, Grid(figures), steps.next());
    const std::string id = std::to_string(number);
    print_element(file, "points-" + id, kBytes, arrays.points);
    print_element(file, "tets-" + id, kBytes, arrays.tets);
    print_element(file, "materials-" + id, kBytes, arrays.materials);
    print_element(file, "numbers-" + id, kBytes, arrays.numbers);
    print_element(file, "report-" + id, "application/json", without_tags(page.report));
    return figures;
}

void print_data(AtomicFile& file, const std::vector<PageMesh>& meshes, const PageOptions& options, const Run& run)
{
    Array<Step> parts;
    for (const PageMesh& mesh : meshes)
        parts.push_back({nullptr, static_cast<double>(mesh.view.tet_count)});
    Steps steps(run, parts);
    JsonText json;
    json.open('{').field("version", cleft_version(nullptr, nullptr, nullptr)).field("goal", options.goal);
    json.key("meshes").open('[');
    std::vector<MeshFigures> figures;
    for (size_t i = 0; i < meshes.size(); ++i)
        figures.push_back(print_mesh(file, meshes[i], i, options, steps.next(), json));
    const std::string places = places_text(meshes, figures);
    if (!places.empty())
        run.warn(places);
    json.close(']').field("places", places).close('}');
    print_element(file, "data", "application/json", json.text());
}

}  // namespace

void write_page(const std::vector<PageMesh>& meshes, const PageOptions& options, const std::string& path,
                const Run& run)
{
    std::string title;
    for (const PageMesh& mesh : meshes)
        title += (title.empty() ? "" : " | ") + mesh.title;
    AtomicFile file(path);
    for (const std::string_view part : page_parts()) {
        if (part == kTitleMark)
            file.print(html_text(title));
        else if (part == kDataMark)
            print_data(file, meshes, options, run);
        else
            file.print(part);
    }
    // The last chance to cancel.
    run.report(1);
    file.commit();
}

}  // namespace cleft::io
