// Vertices near a seam snap in a background of their own, and what they have become goes back to both blocks.
#include "blocks/block_job.hpp"

#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "mesh/piece.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// A visit looks at the tetrahedra around its vertex. With two rings, vertices next to the seam can follow.
constexpr int kSnapRings = 3;

// By vertex or tetrahedron of one background, its number in another; -1: not there.
struct Numbers {
    Array<int32_t> vertex, tet;
};

// Where the vertices of two sides are in one background, which has each place once.
struct Joined {
    TetMesh background;
    Numbers lower, upper;
};

struct SideVertex {
    Vec3 x;
    int32_t vertex;
    bool is_upper;
};

void add_vertices(const TetMesh& side, bool is_upper, Array<SideVertex>& vertices)
{
    for (int32_t v = 0; v < side.points.count(); ++v)
        vertices.push_back({side.points[v], v, is_upper});
}

void add_tets(const TetMesh& side, Numbers& numbers, Array<Tet>& tets)
{
    for (Tet tet : side.tets) {
        for (int32_t& v : tet)
            v = numbers.vertex[v];
        numbers.tet.push_back(static_cast<int32_t>(tets.size()));
        tets.push_back(tet);
    }
}

Joined joined_sides(const TetMesh& lower, const TetMesh& upper)
{
    Array<SideVertex> vertices;
    add_vertices(lower, false, vertices);
    add_vertices(upper, true, vertices);
    std::sort(vertices.begin(), vertices.end(), [](const SideVertex& p, const SideVertex& q) {
        return p.x != q.x ? is_lower_place(p.x, q.x) : p.is_upper < q.is_upper;
    });
    Joined out;
    out.lower.vertex.resize(lower.points.size());
    out.upper.vertex.resize(upper.points.size());
    for (const SideVertex& v : vertices) {
        if (out.background.points.empty() || out.background.points.back() != v.x)
            out.background.points.push_back(v.x);
        (v.is_upper ? out.upper : out.lower).vertex[v.vertex] = static_cast<int32_t>(out.background.points.size() - 1);
    }
    add_tets(lower, out.lower, out.background.tets);
    add_tets(upper, out.upper, out.background.tets);
    return out;
}

void sort(Snapped& snapped)
{
    std::sort(snapped.vertices.begin(), snapped.vertices.end(),
              [](const SnappedVertex& a, const SnappedVertex& b) { return a.vertex < b.vertex; });
    snapped.vertices.erase(
        std::unique(snapped.vertices.begin(), snapped.vertices.end(),
                    [](const SnappedVertex& a, const SnappedVertex& b) { return a.vertex == b.vertex; }),
        snapped.vertices.end());
    std::sort(snapped.kept.begin(), snapped.kept.end(),
              [](const Snapped::Kept& a, const Snapped::Kept& b) { return a.tet < b.tet; });
}

// Adds what a list says of things that have a number elsewhere, under that number.
void add_renumbered(const Snapped& from, const Numbers& numbers, Snapped& to)
{
    for (SnappedVertex v : from.vertices)
        if (numbers.vertex[v.vertex] >= 0) {
            v.vertex = numbers.vertex[v.vertex];
            to.vertices.push_back(v);
        }
    for (const Snapped::Kept& k : from.kept)
        if (numbers.tet[k.tet] >= 0)
            to.kept.push_back({numbers.tet[k.tet], k.material});
}

Array<int32_t> inverse(const Array<int32_t>& numbers, size_t count)
{
    Array<int32_t> out(count, -1);
    for (int32_t i = 0; i < numbers.count(); ++i)
        if (numbers[i] >= 0)
            out[numbers[i]] = i;
    return out;
}

// The vertices and tetrahedra of which `numbers` has no -1, as they are in another background.
Snapped renumbered(const Snapped& from, const Numbers& numbers)
{
    Snapped out;
    add_renumbered(from, numbers, out);
    sort(out);
    return out;
}

}  // namespace

NearSnapped near_snapped(const Block& block, const Array<Vec3>& places_of_other)
{
    const TetMesh& all = block.background;
    const Array<int32_t> on_seam = points_at(all.points, block.held, places_of_other);
    const Array<uint8_t> is_near = near_points(all.tets, all.points.size(), on_seam, kSnapRings);
    NearSnapped near;
    Array<uint8_t> is_used(all.points.size(), 0);
    for (int32_t t = 0; t < all.tets.count(); ++t)
        if (is_near[t]) {
            near.tets.push_back(t);
            for (const int32_t v : all.tets[t])
                is_used[v] = 1;
        }
    for (int32_t v = 0; v < all.points.count(); ++v)
        if (is_used[v])
            near.vertices.push_back(v);
    near.side.background = piece_of(all, [&](int64_t t) { return is_near[t] != 0; });
    near.side.snapped =
        renumbered(block.snapped, {inverse(near.vertices, all.points.size()), inverse(near.tets, all.tets.size())});
    return near;
}

std::pair<Snapped, Snapped> snap_seam(const VolumeParts& volume, const SnapSide& lower, const SnapSide& upper,
                                      const PipelineOptions& options, const Run& run)
{
    if (lower.background.tets.empty() || upper.background.tets.empty())
        return {lower.snapped, upper.snapped};
    const Run of_part = quiet(run);
    const Joined both = joined_sides(lower.background, upper.background);
    Snapped before;
    add_renumbered(lower.snapped, both.lower, before);
    add_renumbered(upper.snapped, both.upper, before);
    sort(before);
    const auto around = volume.around(both.background.points, both.background.tets);
    CleaveOptions snapping = options.cleave;
    snapping.held = points_of_cut(both.background, {Vec3::Zero(), volume.grid.extent()}, of_part);
    const Snapped after = snap_background(*around, both.background, snapping, before, of_part);
    const auto of_side = [&](const Numbers& numbers) {
        return renumbered(after, {inverse(numbers.vertex, both.background.points.size()),
                                  inverse(numbers.tet, both.background.tets.size())});
    };
    return {of_side(both.lower), of_side(both.upper)};
}

void take_back(Block& block, const NearSnapped& near, const Snapped& of_side)
{
    const Array<int32_t> vertex = inverse(near.vertices, block.background.points.size()),
                         tet = inverse(near.tets, block.background.tets.size());
    Snapped out;
    for (const SnappedVertex& v : block.snapped.vertices)
        if (vertex[v.vertex] < 0)
            out.vertices.push_back(v);
    for (const Snapped::Kept& k : block.snapped.kept)
        if (tet[k.tet] < 0)
            out.kept.push_back(k);
    add_renumbered(of_side, {near.vertices, near.tets}, out);
    sort(out);
    block.snapped = std::move(out);
}

}  // namespace cleft
