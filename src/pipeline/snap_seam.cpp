// Vertices near a seam snap in a background of their own, and what they have become goes back to both blocks.
#include "pipeline/block_job.hpp"

#include "base/stage.hpp"
#include "mesh/piece.hpp"
#include "pipeline/quiet_run.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// A visit looks at the tetrahedra around its vertex. With two rings, vertices next to the seam can follow.
constexpr int kSnapRings = 3;

// How a block and the background of a seam number the same things.
struct Numbers {
    Array<int32_t> vertex;  // of the block's vertices in the seam; -1: not there
    Array<int32_t> tet;     // of the block's tetrahedra in the seam; -1: not there
};

struct Seam {
    TetMesh background;
    Numbers lower, upper;
};

struct SeamVertex {
    Vec3 x;
    int32_t lower, upper;  // in the blocks
};

void add_vertices(const Block& block, const Array<uint8_t>& is_near, int32_t SeamVertex::*side,
                  Array<SeamVertex>& vertices)
{
    Array<uint8_t> is_used(block.background.points.size(), 0);
    for (int64_t t = 0; t < block.background.tets.count(); ++t)
        if (is_near[t])
            for (const int32_t v : block.background.tets[t])
                is_used[v] = 1;
    for (int32_t v = 0; v < is_used.count(); ++v)
        if (is_used[v]) {
            vertices.push_back({block.background.points[v], -1, -1});
            vertices.back().*side = v;
        }
}

void add_tets(const Block& block, const Array<uint8_t>& is_near, Numbers& numbers, Array<Tet>& tets)
{
    numbers.tet.assign(block.background.tets.size(), -1);
    for (int64_t t = 0; t < block.background.tets.count(); ++t) {
        if (!is_near[t])
            continue;
        Tet tet = block.background.tets[t];
        for (int32_t& v : tet)
            v = numbers.vertex[v];
        numbers.tet[t] = static_cast<int32_t>(tets.size());
        tets.push_back(tet);
    }
}

Seam seam_between(const Block& lower, const Block& upper)
{
    const TetMesh &a = lower.background, &b = upper.background;
    const auto near_in_lower =
        near_points(a.tets, a.points.size(), shared_points(a.points, lower.held, b.points, upper.held), kSnapRings);
    const auto near_in_upper =
        near_points(b.tets, b.points.size(), shared_points(b.points, upper.held, a.points, lower.held), kSnapRings);
    Array<SeamVertex> vertices;
    add_vertices(lower, near_in_lower, &SeamVertex::lower, vertices);
    add_vertices(upper, near_in_upper, &SeamVertex::upper, vertices);
    std::sort(vertices.begin(), vertices.end(), [](const SeamVertex& p, const SeamVertex& q) {
        return p.x != q.x ? is_lower_place(p.x, q.x) : p.upper < q.upper;
    });
    Seam seam;
    seam.lower.vertex.assign(a.points.size(), -1);
    seam.upper.vertex.assign(b.points.size(), -1);
    for (const SeamVertex& v : vertices) {
        if (seam.background.points.empty() || seam.background.points.back() != v.x)
            seam.background.points.push_back(v.x);
        const auto number = static_cast<int32_t>(seam.background.points.size() - 1);
        (v.lower >= 0 ? seam.lower.vertex[v.lower] : seam.upper.vertex[v.upper]) = number;
    }
    add_tets(lower, near_in_lower, seam.lower, seam.background.tets);
    add_tets(upper, near_in_upper, seam.upper, seam.background.tets);
    return seam;
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

// What the seam says takes the place of what the block had there.
void take_back(const Seam& seam, const Numbers& numbers, const Snapped& of_seam, Snapped& of_block)
{
    Snapped out;
    for (const SnappedVertex& v : of_block.vertices)
        if (numbers.vertex[v.vertex] < 0)
            out.vertices.push_back(v);
    for (const Snapped::Kept& k : of_block.kept)
        if (numbers.tet[k.tet] < 0)
            out.kept.push_back(k);
    add_renumbered(
        of_seam,
        {inverse(numbers.vertex, seam.background.points.size()), inverse(numbers.tet, seam.background.tets.size())},
        out);
    sort(out);
    of_block = std::move(out);
}

}  // namespace

void snap_seam(const Volume& volume, Block& lower, Block& upper, const PipelineOptions& options, const Run& run)
{
    if (lower.background.tets.empty() || upper.background.tets.empty())
        return;
    const Run of_part = quiet(run);
    const Seam seam = seam_between(lower, upper);
    Snapped before;
    add_renumbered(lower.snapped, seam.lower, before);
    add_renumbered(upper.snapped, seam.upper, before);
    sort(before);
    CleaveOptions snapping = options.cleave;
    snapping.held = points_of_cut(seam.background, {Vec3::Zero(), volume.grid().extent()}, of_part);
    const Snapped after = snap_background(volume, seam.background, snapping, before, of_part);
    take_back(seam, seam.lower, after, lower.snapped);
    take_back(seam, seam.upper, after, upper.snapped);
}

}  // namespace cleft
