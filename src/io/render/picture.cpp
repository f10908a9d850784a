// Draws a mesh: what is shown, where it lies, in which colours, and what is behind and beside it.
#include "io/render/picture.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "base/utf8.hpp"
#include "io/label_colours.hpp"
#include "io/render/camera.hpp"
#include "io/render/creases.hpp"
#include "io/render/drawn_faces.hpp"
#include "io/render/legend.hpp"
#include "io/render/outer_faces.hpp"
#include "io/render/rasteriser.hpp"
#include "io/render/shown_tets.hpp"
#include "io/render/stroke_font.hpp"

#include <algorithm>
#include <limits>

namespace cleft::io
{

namespace
{

constexpr Colour kLightBackdrop{255, 255, 255};
constexpr Colour kDarkBackdrop{20, 22, 27};
constexpr Colour kTextOnLight{38, 42, 50};
constexpr Colour kTextOnDark{222, 225, 230};

// The least and greatest of the measures that are numbers.
std::array<double, 2> range_of(const Array<double>& measures)
{
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double value : measures)
        if (std::isfinite(value))
            range = {std::min(range[0], value), std::max(range[1], value)};
    return range[0] <= range[1] ? range : std::array<double, 2>{0, 0};
}

// The ends of a scale of sizes. Those of a uniform mesh differ by rounding, which is nothing to show.
std::array<double, 2> range_to_show(const Array<double>& measures, const PictureRequest& request, const Run& run)
{
    constexpr double kRounding = 1e-6;
    const auto [low, high] = range_of(measures);
    const bool is_given = request.range[0] < request.range[1];
    if (request.by != CLEFT_IO_BY_SIZE || is_given || high - low > kRounding * high)
        return {low, high};
    run.warn("all tetrahedra of the picture have the same size, " + number_text(low) + ", and so one colour");
    return {low, low};
}

void warn_of_letters(const Legend& legend, const Run& run)
{
    constexpr size_t kLongest = 80;  // bytes of a name, so that the sentence can be read
    const auto is_drawn = [](const LegendEntry& entry) { return can_draw(entry.text); };
    const auto first = std::find_if_not(legend.entries.begin(), legend.entries.end(), is_drawn);
    if (first == legend.entries.end())
        return;
    const auto count = std::count_if(first, legend.entries.end(), [&](const auto& entry) { return !is_drawn(entry); });
    run.warn("the legend can draw Latin and Greek letters alone, and shows others as '?': in the names of " +
             std::to_string(count) + (count == 1 ? " label, '" : " labels, the first of which is '") +
             std::string(beginning_of(printable(first->text), kLongest)) + "'");
}

// The labels of the tetrahedra of the faces for which has(number) says so.
template <class Face, class Has>
std::vector<LegendEntry> label_entries(const MeshView& mesh, const Array<Face>& faces, const Has& has)
{
    Array<char> is_there(mesh.labels.size());
    for (int64_t i = 0; i < faces.count(); ++i)
        if (has(i))
            is_there[mesh.label_index(mesh.tet_labels[faces[i].tet])] = 1;
    std::vector<LegendEntry> entries;
    for (size_t i = 0; i < mesh.labels.size(); ++i)
        if (is_there[i])
            entries.push_back({colour_of_label(mesh.labels[i]),
                               std::to_string(mesh.labels[i]) + (mesh.names[i].empty() ? "" : "  " + mesh.names[i])});
    return entries;
}

PixelArea area_for_mesh(const PictureRequest& request, int beside)
{
    constexpr int kMarginShare = 24;  // of the shorter side
    const int margin = std::min(request.width, request.height) / kMarginShare;
    return {margin, margin, std::max(1, request.width - margin - std::max(margin, beside)),
            std::max(1, request.height - 2 * margin)};
}

// With so many columns at the right, which are empty.
Canvas widened(const Canvas& canvas, int width)
{
    Canvas wide(width, canvas.height);
    for (int y = 0; y < canvas.height; ++y) {
        std::copy_n(&canvas.pixels[canvas.at(0, y)], canvas.width, &wide.pixels[wide.at(0, y)]);
        std::copy_n(&canvas.depth[canvas.at(0, y)], canvas.width, &wide.depth[wide.at(0, y)]);
    }
    return wide;
}

void put_behind(cleft_io_backdrop backdrop, const Run& run, Canvas& canvas)
{
    if (backdrop == CLEFT_IO_BACKDROP_NONE)
        return;
    const Colour behind = backdrop == CLEFT_IO_BACKDROP_DARK ? kDarkBackdrop : kLightBackdrop;
    constexpr int64_t kPixels = 1 << 16;  // a chunk
    parallel_for(run, canvas.pixels.count(), kPixels, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            Pixel& pixel = canvas.pixels[i];
            pixel = {mixed(behind, pixel.colour, (pixel.cover * kWhole + 127) / 255), 255};
        }
    });
}

}  // namespace

Canvas draw_picture(const MeshView& mesh, const PictureRequest& request, const Run& run)
{
    // Microseconds on one thread, as in cleft_io_write_picture().
    const auto tets = static_cast<double>(mesh.tet_count);
    const double pixels = static_cast<double>(request.width) * request.height;
    Steps steps(run, {{"picture: faces", 0.15 * tets},
                      {"picture: colours", 0.01 * tets},
                      {"picture: drawing", 0.2 * pixels},
                      {"picture: creases", 0.17 * pixels}});
    const Run finding = steps.next();
    const Array<OuterFace> faces = outer_faces(mesh, shown_tets(mesh, request, finding), finding);
    if (faces.empty())
        throw Error(CLEFT_ERROR_ARGUMENT, "the picture would be empty: strip and cut leave no tetrahedron");
    const bool names_labels = request.has_legend && request.by == CLEFT_IO_BY_LABEL;
    Legend legend;
    // The legend has the labels that are seen. Its width is that for all, as it decides what is seen.
    if (names_labels)
        legend.entries = label_entries(mesh, faces, [](int64_t) { return true; });
    const int beside = request.has_legend ? legend_width(legend, request.width, request.height) : 0;
    const Run colouring = steps.next();
    const Camera camera(mesh, faces, request, area_for_mesh(request, beside), colouring);
    const Array<double> measures = face_measures(mesh, faces, camera, request, colouring);
    if (request.by != CLEFT_IO_BY_LABEL)
        legend.scale.emplace(request.by, request.range, range_to_show(measures, request, run));
    // A mesh that is larger than the picture ends at the legend.
    Canvas canvas(std::max(1, request.width - beside), request.height);
    const Array<DrawnFace> drawn = drawn_faces(mesh, faces, measures, legend.scale, camera, request, colouring);
    const Array<uint8_t> is_seen = rasterise(mesh, drawn, camera, request.line_width, steps.next(), canvas);
    const Run finishing = steps.next();
    canvas = widened(canvas, request.width);
    darken_creases(camera.pixels_per_unit(), finishing, canvas);
    put_behind(request.backdrop, finishing, canvas);
    if (names_labels)
        legend.entries = label_entries(mesh, drawn, [&](int64_t f) { return is_seen[f] != 0; });
    warn_of_letters(legend, run);
    if (request.has_legend)
        draw_legend(legend, beside, request.backdrop == CLEFT_IO_BACKDROP_DARK ? kTextOnDark : kTextOnLight, canvas);
    return canvas;
}

}  // namespace cleft::io
