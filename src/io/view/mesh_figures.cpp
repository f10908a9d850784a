// Measures all tetrahedra of a mesh and keeps the worst of them.
#include "io/view/mesh_figures.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cleft::io
{

namespace
{

// As many as somebody looks at one by one.
constexpr size_t kWorst = 50;
// Some milliseconds of work.
constexpr int64_t kGrain = 1 << 14;

TetShape shape_of(const Corners& corners)
{
    constexpr double kDegrees = 180 / 3.14159265358979323846;
    const AngleCosines cosines = angle_cosines(corners);
    return {kDegrees * std::acos(cosines.of_least), kDegrees * std::acos(cosines.of_greatest), radius_ratio(corners),
            signed_volume(corners)};
}

bool worse_angle(const WorstTet& a, const WorstTet& b)
{
    return std::tie(a.shape.least_angle, a.tet) < std::tie(b.shape.least_angle, b.tet);
}

bool worse_ratio(const WorstTet& a, const WorstTet& b)
{
    return std::tie(b.shape.radius_ratio, a.tet) < std::tie(a.shape.radius_ratio, b.tet);
}

template <class Worse>
void keep_worst(std::vector<WorstTet>& tets, const Worse& worse)
{
    const size_t kept = std::min(kWorst, tets.size());
    std::partial_sort(tets.begin(), tets.begin() + static_cast<std::ptrdiff_t>(kept), tets.end(), worse);
    tets.resize(kept);
}

void extend_box(MeshFigures& figures, const Vector3& low, const Vector3& high)
{
    for (size_t axis = 0; axis < 3; ++axis) {
        figures.low[axis] = std::min(figures.low[axis], low[axis]);
        figures.high[axis] = std::max(figures.high[axis], high[axis]);
    }
}

MeshFigures empty_figures(const MeshView& mesh, int64_t tet)
{
    MeshFigures figures;
    const Corners corners = corners_of(mesh, tet);
    figures.low = figures.high = corners[0];
    figures.labels.resize(mesh.labels.size());
    return figures;
}

MeshFigures figures_of_chunk(const MeshView& mesh, int64_t begin, int64_t end)
{
    MeshFigures figures = empty_figures(mesh, begin);
    for (int64_t t = begin; t < end; ++t) {
        const Corners corners = corners_of(mesh, t);
        const WorstTet tet{t, shape_of(corners)};
        for (const Vector3& corner : corners)
            extend_box(figures, corner, corner);
        LabelFigures& label = figures.labels[mesh.label_index(mesh.tet_labels[t])];
        ++label.tets;
        label.volume += tet.shape.volume;
        figures.by_angle.push_back(tet);
        figures.by_ratio.push_back(tet);
    }
    keep_worst(figures.by_angle, worse_angle);
    keep_worst(figures.by_ratio, worse_ratio);
    return figures;
}

void join(MeshFigures& all, const MeshFigures& part)
{
    extend_box(all, part.low, part.high);
    for (size_t l = 0; l < all.labels.size(); ++l) {
        all.labels[l].tets += part.labels[l].tets;
        all.labels[l].volume += part.labels[l].volume;
    }
    all.by_angle.insert(all.by_angle.end(), part.by_angle.begin(), part.by_angle.end());
    all.by_ratio.insert(all.by_ratio.end(), part.by_ratio.begin(), part.by_ratio.end());
    keep_worst(all.by_angle, worse_angle);
    keep_worst(all.by_ratio, worse_ratio);
}

}  // namespace

Corners corners_of(const MeshView& mesh, int64_t tet)
{
    Corners corners;
    for (size_t c = 0; c < 4; ++c) {
        const double* point = mesh.points + 3 * int64_t{mesh.tets[4 * tet + static_cast<int64_t>(c)]};
        corners[c] = {point[0], point[1], point[2]};
    }
    return corners;
}

MeshFigures figures_of(const MeshView& mesh, const Run& run)
{
    std::vector<MeshFigures> parts(static_cast<size_t>(chunk_count(mesh.tet_count, kGrain)));
    parallel_chunks(run, mesh.tet_count, kGrain, [&](int64_t chunk, int64_t begin, int64_t end) {
        parts[static_cast<size_t>(chunk)] = figures_of_chunk(mesh, begin, end);
    });
    MeshFigures all = empty_figures(mesh, 0);
    // In the order of the chunks, so that sums do not depend on threads.
    for (const MeshFigures& part : parts)
        join(all, part);
    return all;
}

}  // namespace cleft::io
