// Finds the edges that a single drawn face has. Each edge is listed at the lesser of its points, as faces are in
// outer_faces.cpp.
#include "io/render/outline.hpp"

#include "base/counting_sort.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

struct DrawnEdge {
    int32_t farther;  // the greater of its points
    int64_t place;    // three times the face, and the number of the edge in it
};

int32_t corner_of(const DrawnFace& face, int64_t edge) { return face.corners[edge % 3]; }

void mark_single(Array<DrawnEdge>& edges, Array<char>& is_single)
{
    std::sort(edges.begin(), edges.end(), [](const DrawnEdge& a, const DrawnEdge& b) { return a.farther < b.farther; });
    for (int64_t i = 0; i < edges.count();) {
        int64_t next = i + 1;
        while (next < edges.count() && edges[next].farther == edges[i].farther)
            ++next;
        if (next - i == 1)
            is_single[edges[i].place] = 1;
        i = next;
    }
}

}  // namespace

Array<char> outline_edges(const Array<DrawnFace>& faces, int64_t point_count, const Run& run)
{
    constexpr int64_t kPoints = 1 << 14;
    const auto at_points =
        group_by_key<int64_t, int64_t>(run, faces.count(), point_count, [&](int64_t f, const auto& give) {
            for (int64_t e = 0; e < 3; ++e)
                give(std::min(corner_of(faces[f], e), corner_of(faces[f], e + 1)), 3 * f + e);
        });
    Array<char> is_single(3 * faces.count());
    parallel_for(run, point_count, kPoints, [&](int64_t begin, int64_t end) {
        Array<DrawnEdge> edges;
        for (int64_t point = begin; point < end; ++point) {
            edges.clear();
            for (int64_t i = at_points.start[point]; i < at_points.start[point + 1]; ++i) {
                const int64_t place = at_points.values[i];
                const DrawnFace& face = faces[place / 3];
                edges.push_back({std::max(corner_of(face, place % 3), corner_of(face, place % 3 + 1)), place});
            }
            mark_single(edges, is_single);
        }
    });
    return is_single;
}

}  // namespace cleft::io
