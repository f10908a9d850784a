// One visit of snapping: a vertex is given the best of a few changes that would snap it.
#pragma once

#include "cleaving/cleave.hpp"
#include "cleaving/pinch.hpp"
#include "cleaving/safe_reach.hpp"
#include "cleaving/snap.hpp"
#include "cleaving/star.hpp"

namespace cleft
{

// What all visits share. A visit changes it at its vertex and at the edges and tetrahedra there, and looks at no more
// than the vertices next to it: visits of vertices that share no edge may go side by side.
struct SnapState {
    SnapState(Centres& centres, Snap snap_rule, const Array<int32_t>& held_vertices, const Run& run);

    // Tetrahedra at a vertex of one material alone are of that material: a label that keeps such a vertex is not lost.
    bool is_last_of_material(int32_t v) const
    {
        const MaterialSet& own = c.materials_of(v);
        return own.size() == 1 && vertices_of[own[0]] == 1;
    }

    Centres& c;
    const Snap rule;
    const Array<int32_t>& held;  // vertices that are not visited
    const VertexTets tets_of;
    Array<uint8_t> touched;                   // by vertex: something in its star changed since its last visit
    Array<std::atomic<int64_t>> vertices_of;  // by material: how many carry it alone
    SafeReach safe_reach;                     // of Snap::safe
};

// Makes the visits of one thread.
class SnapVisitor
{
public:
    explicit SnapVisitor(SnapState& state)
        : state_(state), c_(state.c), arena_(c_.samples.new_arena()), star_(c_, state.tets_of), pinch_(c_)
    {
    }

    void visit(int32_t v);
    const SnapCounts& counts() const { return counts_; }

private:
    struct NearCut {
        double distance;
        Vec3 x;
        int32_t edge, other;  // the end that is not the vertex
    };
    // A choice among the near cuts: the one at `last` alone, or all from the nearest up to it.
    // One cut leads to an interface; several lead to the line or the point where their interfaces meet.
    struct Choice {
        size_t first, last;
    };

    void gather(int32_t v);
    double reach(int32_t edge) const;
    bool find_best();
    bool attempt(const Choice& choice);
    bool improves(const Vec3& x, const MaterialSet& materials);
    bool keeps_walls(const Vec3& x) const;
    void take_best();
    void keep_materials();
    void mark_around();

    SnapState& state_;
    Centres& c_;
    SampleArena& arena_;
    CutStar star_;
    PinchCheck pinch_;
    SnapCounts counts_;

    // Of the vertex being visited.
    unsigned frozen_ = 0;
    Array<NearCut> near_;
    Array<MaterialSet> tried_;
    StarState before_, best_;
    StarShape shape_before_, best_shape_, shape_;
    bool best_is_sound_ = false;
    Samples scratch_;
};

}  // namespace cleft
