// Finds the tetrahedra that a picture shows.
#include "io/render/shown_tets.hpp"

#include "base/fixed_array.hpp"
#include "base/parallel.hpp"

namespace cleft::io
{

namespace
{

constexpr int64_t kTetsTested = 1 << 14;  // a chunk: enough that handing it out takes no time

// A plane across an axis, and the side of it that is taken away.
struct Cut {
    int axis;
    double place;
    bool takes_upper;

    bool takes(const MeshView& mesh, const int32_t* corners) const
    {
        double centre = 0;
        for (int c = 0; c < 4; ++c)
            // A quarter of each: the sum of coordinates near the end of the range would overflow.
            centre += mesh.points[3 * int64_t{corners[c]} + axis] / 4;
        return takes_upper ? centre > place : centre < place;
    }
};

std::array<double, 2> extent(const MeshView& mesh, int axis, const Run& run)
{
    constexpr int64_t kPoints = 1 << 16;
    Array<std::array<double, 2>> parts(chunk_count(mesh.point_count, kPoints));
    parallel_chunks(run, mesh.point_count, kPoints, [&](int64_t chunk, int64_t begin, int64_t end) {
        std::array<double, 2> part{mesh.points[3 * begin + axis], mesh.points[3 * begin + axis]};
        for (int64_t p = begin; p < end; ++p) {
            part[0] = std::min(part[0], mesh.points[3 * p + axis]);
            part[1] = std::max(part[1], mesh.points[3 * p + axis]);
        }
        parts[chunk] = part;
    });
    std::array<double, 2> whole = parts[0];
    for (const auto& part : parts)
        whole = {std::min(whole[0], part[0]), std::max(whole[1], part[1])};
    return whole;
}

std::vector<Cut> cuts_of(const MeshView& mesh, const PictureRequest& request, const Run& run)
{
    std::vector<Cut> cuts;
    for (int axis = 0; axis < 3; ++axis) {
        const double share = request.cut[to_size(axis)];
        if (share == 0)
            continue;
        const std::array<double, 2> ends = extent(mesh, axis, run);
        cuts.push_back({axis, ends[0] * (1 - share) + ends[1] * share, request.to_eye[to_size(axis)] >= 0});
    }
    return cuts;
}

}  // namespace

Array<char> shown_tets(const MeshView& mesh, const PictureRequest& request, const Run& run)
{
    const std::vector<Cut> cuts = cuts_of(mesh, request, run);
    Array<char> is_left_out, is_whole;
    for (const int32_t label : mesh.labels) {
        is_left_out.push_back(request.leaves_out(label) ? 1 : 0);
        is_whole.push_back(cuts.empty() || request.keeps_whole(label) ? 1 : 0);
    }
    Array<char> shown(mesh.tet_count);
    parallel_for(run, mesh.tet_count, kTetsTested, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t) {
            const size_t label = mesh.label_index(mesh.tet_labels[t]);
            const auto takes = [&](const Cut& cut) { return cut.takes(mesh, mesh.tets + 4 * t); };
            const bool is_cut = !is_whole[label] && std::all_of(cuts.begin(), cuts.end(), takes);
            shown[t] = is_left_out[label] || is_cut ? 0 : 1;
        }
    });
    return shown;
}

}  // namespace cleft::io
