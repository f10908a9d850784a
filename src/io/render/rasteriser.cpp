// Draws faces tile by tile with a depth buffer and 16 samples a pixel.
//
// A triangle has the samples on the inner side of its three edges. The sides are decided in whole numbers, and a sample
// on an edge belongs to one of the two triangles beside it, so there are neither gaps nor double samples between
// triangles. Tiles are independent of each other, so the picture does not depend on the number of threads.
#include "io/render/rasteriser.hpp"

#include "base/fixed_array.hpp"
#include "base/parallel.hpp"
#include "base/reported_loop.hpp"
#include "base/shared_access.hpp"
#include "io/render/outline.hpp"
#include "io/render/tile.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

// The rows of tiles that a face reaches.
struct Reach {
    int16_t first, last;  // none if the last is less

    bool has(int64_t row) const { return first <= row && row <= last; }
};

Array<ScreenPoint> points_on_screen(const MeshView& mesh, const Array<DrawnFace>& faces, const Camera& camera,
                                    const Run& run)
{
    Array<char> is_used(mesh.point_count);
    for (const DrawnFace& face : faces)
        for (const int32_t corner : face.corners)
            is_used[corner] = 1;
    Array<ScreenPoint> points(mesh.point_count);
    constexpr int64_t kPoints = 1 << 14;
    parallel_for(run, mesh.point_count, kPoints, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p)
            if (is_used[p])
                points[p] = camera.on_screen(static_cast<int32_t>(p));
    });
    return points;
}

// All that tiles need of the faces.
struct Scene {
    const Array<DrawnFace>& faces;
    const Array<ScreenPoint> points;
    const Array<char> is_outline;
    double half_line;  // in units of ScreenPoint

    TileTriangle triangle(int64_t f) const
    {
        const int32_t* c = faces[f].corners;
        const auto reach = [&](int64_t edge) { return is_outline[3 * f + edge] ? 2 * half_line : half_line; };
        return {points[c[0]], points[c[1]], points[c[2]], reach(0), reach(1), reach(2)};
    }
};

Array<Reach> reaches_of(const Scene& scene, int rows, const Run& run)
{
    constexpr int32_t kRowUnits = Tile::kPixels * ScreenPoint::kUnits;
    constexpr int64_t kFaces = 1 << 14;
    // Division rounds towards 0, which puts what is a little above the picture into the first row: no harm.
    const auto row_of = [&](int32_t y) { return static_cast<int16_t>(std::clamp(y / kRowUnits, -1, rows)); };
    Array<Reach> reaches(scene.faces.count());
    parallel_for(run, scene.faces.count(), kFaces, [&](int64_t begin, int64_t end) {
        for (int64_t f = begin; f < end; ++f) {
            const auto [low, high] = scene.triangle(f).extent_y();
            reaches[f] = {row_of(low), row_of(high)};
        }
    });
    return reaches;
}

// A row of tiles with the faces that reach it, which are numbered by their places in `faces`.
struct TileRow {
    Array<int64_t> faces;
    Array<FaceColours> colours;
    Array<char> is_seen;
};

TileRow faces_in_row(const Scene& scene, const Array<Reach>& reaches, int64_t row)
{
    TileRow found;
    for (int64_t f = 0; f < scene.faces.count(); ++f)
        if (reaches[f].has(row)) {
            found.faces.push_back(f);
            found.colours.push_back(scene.faces[f].colours);
        }
    found.is_seen.assign(found.faces.count(), 0);
    return found;
}

}  // namespace

Array<uint8_t> rasterise(const MeshView& mesh, const Array<DrawnFace>& faces, const Camera& camera, double line_width,
                         const Run& run, Canvas& canvas)
{
    const Scene scene{faces, points_on_screen(mesh, faces, camera, run), outline_edges(faces, mesh.point_count, run),
                      line_width / 2 * ScreenPoint::kUnits};
    const int rows = (canvas.height + Tile::kPixels - 1) / Tile::kPixels;
    const Array<Reach> reaches = reaches_of(scene, rows, run);
    Array<uint8_t> is_seen(faces.size(), 0);
    reported_for(run, rows, 1, [&](int64_t number, int64_t) {
        TileRow row = faces_in_row(scene, reaches, number);
        Tile tile;
        for (int left = 0; left < canvas.width; left += Tile::kPixels) {
            // A row of tiles may have all faces of a large mesh.
            run.check();
            tile.begin(left, static_cast<int>(number) * Tile::kPixels);
            for (int64_t i = 0; i < row.faces.count(); ++i)
                tile.draw(scene.triangle(row.faces[i]), static_cast<int32_t>(i));
            tile.end(row.colours, canvas, row.is_seen);
        }
        for (int64_t i = 0; i < row.faces.count(); ++i)
            if (row.is_seen[i])
                store_shared<uint8_t>(is_seen[row.faces[i]], 1);
    });
    return is_seen;
}

}  // namespace cleft::io
