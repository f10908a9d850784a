// Writes the output mesh: numbers the points that are in use, and splits every background tetrahedron by its fan.
#include "cleaving/assemble.hpp"

#include "base/shared_access.hpp"
#include "base/touched_array.hpp"
#include "cleaving/choose_material.hpp"
#include "cleaving/split_tet.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

#include <limits>

namespace cleft
{

namespace
{

// Background tetrahedra per chunk. Places in the output are counted first, so this number changes the time alone.
constexpr int64_t kTetsWritten = 2048;

Array<uint8_t> vertices_in_use(const Centres& c, const Run& run)
{
    Array<uint8_t> in_use(c.points.size(), 0);
    parallel_for(run, c.tets.count(), kTetsWritten, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            for (const int32_t v : c.tets[t])
                store_shared<uint8_t>(in_use[v], 1);
    });
    return in_use;
}

// Numbers in the output of the points that are in use, in the order vertices, cuts, triple and quadruple points.
struct Numbering {
    Array<int32_t> vertex, cut, triple, quadruple;
    Array<Vec3> points;

    Numbering(const Centres& c, const Run& run)
    {
        reserve_large(points, c.points.size() + c.edges.size() + c.faces.size());
        const Array<uint8_t> in_use = vertices_in_use(c, run);
        number(
            vertex, c.points, [&](size_t i) { return in_use[i] != 0; }, [&](size_t i) { return c.points[i]; });
        number(
            cut, c.edges, [&](size_t i) { return c.edges[i].is_cut; },
            [&](size_t i) { return c.cut_point(c.edges[i]); });
        number(
            triple, c.faces, [&](size_t i) { return c.has_triple(c.faces[i]); },
            [&](size_t i) { return c.triple_point(c.faces[i]); });
        number(
            quadruple, c.mixed, [&](size_t i) { return c.has_quadruple(c.mixed[i]); },
            [&](size_t i) { return c.quadruple_point(c.mixed[i]); });
    }

    // Output points of a mixed tetrahedron; those that are not there are never asked for.
    FixedArray<int32_t, kStencilPoints> of(const Centres& c, const MixedTet& m) const
    {
        FixedArray<int32_t, kStencilPoints> id;
        const auto take = [](const Array<int32_t>& from, int32_t i) { return i < 0 ? -1 : from[i]; };
        for (size_t i = 0; i < 4; ++i) {
            id[i] = take(vertex, c.corners(m.tet)[i]);
            id[kTriplePoint + i] = take(triple, m.faces[i]);
        }
        for (size_t e = 0; e < 6; ++e)
            id[kCutPoint + e] = take(cut, m.edges[e]);
        id[kQuadruplePoint] = take(quadruple, c.mixed_of[m.tet]);
        return id;
    }

private:
    template <class Items, class InUse, class Position>
    void number(Array<int32_t>& numbers, const Items& items, const InUse& in_use, const Position& position)
    {
        numbers.assign(items.size(), -1);
        for (size_t i = 0; i < items.size(); ++i) {
            if (!in_use(i))
                continue;
            // Refused here rather than by wrong numbers later (decision 2).
            if (points.count() >= std::numeric_limits<int32_t>::max())
                throw Error(CLEFT_ERROR_TOO_LARGE, "the mesh would have more points than 32-bit numbers can name");
            numbers[i] = static_cast<int32_t>(points.size());
            points.push_back(position(i));
        }
    }
};

void note_points(const Numbering& numbering, const Run& run)
{
    const auto note = [&](const char* name, const Array<int32_t>& numbers) {
        const auto unused = std::count(numbers.begin(), numbers.end(), -1);
        run.note(name, static_cast<double>(numbers.size()) - static_cast<double>(unused));
    };
    note("cleaving.cuts", numbering.cut);
    note("cleaving.triples", numbering.triple);
    note("cleaving.quads", numbering.quadruple);
    run.note("cleaving.steiner", 0);  // lemma 2 of stencil.hpp: none is ever needed
}

// Where the output tetrahedra of each chunk of background tetrahedra go.
// Counting before writing lets threads write into one array, in an order that does not depend on them.
struct Plan {
    Array<int64_t> begin;
    int64_t tets = 0;
};

Plan plan_output(const Centres& c, const Run& run)
{
    const auto n = c.tets.count();
    Plan plan;
    plan.begin.resize(chunk_count(n, kTetsWritten));
    parallel_chunks(run, n, kTetsWritten, [&](int64_t chunk, int64_t begin, int64_t end) {
        int64_t count = 0;
        for (int64_t t = begin; t < end; ++t) {
            const int32_t m = c.mixed_of[t];
            count += m < 0 ? 1 : c.stencils.tets(c.fans[m].stencil).size();
        }
        plan.begin[chunk] = count;
    });
    for (int64_t& begin : plan.begin) {
        const int64_t count = begin;
        begin = plan.tets;
        plan.tets += count;
    }
    if (plan.tets > std::numeric_limits<int32_t>::max())
        throw Error(CLEFT_ERROR_TOO_LARGE, "the mesh would have more tetrahedra than 32-bit numbers can name");
    return plan;
}

// Writes the output tetrahedra of one background tetrahedron from `out` on; returns their number.
class TetWriter
{
public:
    TetWriter(const Centres& c, const Numbering& numbering, LabelledMesh& mesh)
        : c_(c), numbering_(numbering), mesh_(mesh)
    {
    }

    int64_t write_whole(int64_t tet, int64_t out)
    {
        const Tet& corners = c_.tets[tet];
        FixedArray<Vec3, 4> x;
        for (size_t i = 0; i < 4; ++i) {
            mesh_.tets[out][i] = numbering_.vertex[corners[i]];
            x[i] = c_.point(corners[i]);
        }
        CLEFT_ASSERT(orient_sign(x[0], x[1], x[2], x[3]) > 0);
        mesh_.material[out] = MaterialChooser(c_, corners).choose_whole(c_.kept[tet], x, scratch_);
        return 1;
    }

    int64_t write_fan(const MixedTet& m, const StencilTable::Tets& tets, int64_t out)
    {
        const MaterialChooser chooser(c_, c_.corners(m.tet));
        const auto id = numbering_.of(c_, m);
        for (const StencilTet& t : tets) {
            FixedArray<Vec3, 4> x;
            for (size_t k = 0; k < 4; ++k) {
                mesh_.tets[out][k] = id[t[k]];
                x[k] = mesh_.points[id[t[k]]];
            }
            CLEFT_ASSERT(orient_sign(x[0], x[1], x[2], x[3]) > 0);
            // A mixed tetrahedron whose cuts have all vanished is whole again, and follows the rule for whole ones.
            mesh_.material[out++] =
                tets.size() == 1 ? chooser.choose_whole(c_.kept[m.tet], x, scratch_) : chooser.choose(t, x, scratch_);
        }
        return tets.size();
    }

private:
    const Centres& c_;
    const Numbering& numbering_;
    LabelledMesh& mesh_;
    Samples scratch_;
};

}  // namespace

LabelledMesh assemble(const Centres& c, const Run& run)
{
    const Plan plan = plan_output(c, run);
    Numbering numbering(c, run);
    note_points(numbering, run);
    LabelledMesh mesh;
    mesh.points = std::move(numbering.points);
    // Improving adds some.
    mesh.tets = array_with_room<Tet>(run, plan.tets);
    mesh.material = array_with_room<Material>(run, mesh.tets.size());
    parallel_chunks(run, c.tets.count(), kTetsWritten, [&](int64_t chunk, int64_t begin, int64_t end) {
        TetWriter writer(c, numbering, mesh);
        int64_t out = plan.begin[chunk];
        for (int64_t t = begin; t < end; ++t) {
            const int32_t m = c.mixed_of[t];
            out += m < 0 ? writer.write_whole(t, out)
                         : writer.write_fan(c.mixed[m], c.stencils.tets(c.fans[m].stencil), out);
        }
    });
    return mesh;
}

Array<int32_t> points_in_doubt(const Centres& c, const Run& run)
{
    constexpr uint8_t kUsed = 1, kInDoubt = 2;
    Array<uint8_t> state = vertices_in_use(c, run);
    for (size_t v = 0; v < state.size(); ++v)
        // A vertex of one material has no interface through it, so nothing is pinched there.
        if (c.doubtful[v] && c.materials[v].size() > 1)
            state[v] |= kInDoubt;
    for (const CutEdge& e : c.edges)
        // Neither end has snapped, so flat_cuts.cpp has given this cut up.
        if (!e.is_cut && c.materials_of(e.lower).size() == 1 && c.materials_of(e.upper).size() == 1)
            for (const int32_t v : {e.lower, e.upper})
                state[v] |= kInDoubt;
    Array<int32_t> points;
    int32_t number = 0;
    for (const uint8_t s : state) {
        if (s == (kUsed | kInDoubt))
            points.push_back(number);
        number += s & kUsed;
    }
    return points;
}

}  // namespace cleft
