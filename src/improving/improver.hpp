// The local search of improving: for each bad tetrahedron, worst first, every operation that may help.
#pragma once

#include "improving/tie_constraint.hpp"
#include "remeshing/contraction.hpp"
#include "remeshing/worst_first.hpp"

#include <array>
#include <set>

namespace cleft
{

// One search: passes over the tetrahedra below the target.
struct Search {
    int passes;
    double tolerance = 0;   // how far points of interfaces may leave the tie, in least voxel spacings (or edge
                            // lengths, where those are shorter)
    double bend = 0.05;     // how far an interface may move when an edge in it is flipped, in lengths of the edge
    bool thorough = false;  // only for the worst, if there are many: also tries places far from where a point is
    bool compound = false;  // also tries operations that help only after the points around have moved
    bool wide = false;      // compound operations at the tetrahedra around, too
};

class Improver
{
public:
    struct Counts {
        int64_t moved = 0, edges_removed = 0, faces_removed = 0, contracted = 0, split = 0, compound = 0;
    };

    // `target`: of angle_quality.
    Improver(LocalMesh& mesh, const Volume& volume, double target, const Run& run);

    void work(const Search& search, const Run& run);
    // The next searches aim higher, around what the last one left: they take other ways there.
    void aim_higher(double target);
    // Tetrahedra that the last search left below the target.
    size_t left() const { return bad_.size(); }
    const Counts& counts() const { return counts_; }

private:
    bool improve_tet(int32_t t);

    // Smoothing.
    bool smooth_corners(int32_t t);
    bool smooth(int32_t v, bool thorough);
    Place better_place(int32_t v, bool thorough);
    void constrain(const std::vector<int32_t>& tets, const Vec3& x, const Vec3& home, uint8_t frozen);

    // Operations that make the worst tetrahedron better at once.
    bool change_connections(int32_t t);
    bool split(int32_t t, int corner_a, int corner_b);
    double bend(int32_t t, int corner_a, int corner_b) const;

    // Operations that make it better together with the moves of points that follow (rescue.cpp).
    bool rescue(int32_t t);
    bool rescue_at(const Tet& place, const Tet& bad, double before);
    void accept();
    int32_t find(const Tet& corners) const;
    std::vector<Tet> tets_around(const Tet& corners) const;
    bool attempt(int32_t t, int operation);
    bool split_in_middle(int32_t t, int corner_a, int corner_b);
    bool smooth_all(const Tet& bad, double before);
    bool pays(const Tet& bad, double wanted);
    void smooth_and_note(int32_t t);
    bool is_settled(int32_t v);
    void unsettle_around(int32_t v);
    void take_back();

    double target_;
    const double voxel_;
    LocalMesh& mesh_;
    std::vector<Vec3> home_;  // of each point: where cleaving, or the split that made it, put it
    TieConstraint constraint_;
    WorstFirst bad_;
    Search search_{};
    bool started_ = false;
    size_t attempts_left_ = 0;  // in a pass
    Cavity cavity_;
    Contraction contraction_;
    Smoother smoother_;
    TetStar star_;
    Counts counts_;
    // Of an attempt.
    struct Move {
        int32_t point;
        Vec3 from;
    };
    std::vector<Move> moves_;
    std::vector<uint64_t> settled_, unsettled_;  // by point: when it was smoothed, when something around it moved
    uint64_t clock_ = 0, attempt_began_ = 0;
    std::set<std::array<int32_t, 4>> tried_;  // what was tried for the bad tetrahedron, see subject_of
};

}  // namespace cleft
