// Everything around a vertex that moves with it.
#pragma once

#include "base/array.hpp"
#include "cleaving/centres.hpp"

namespace cleft
{

// Which tetrahedra have a vertex as a corner, for vertices at edges that were cut at the start.
class VertexTets
{
public:
    VertexTets(const Centres& c, const Run& run);

    struct Range {
        const int32_t *first, *last;
        const int32_t* begin() const { return first; }
        const int32_t* end() const { return last; }
    };
    Range at(int32_t v) const { return {tets_.data() + first_[v], tets_.data() + first_[int64_t{v} + 1]}; }

private:
    Array<int64_t> first_;
    Array<int32_t> tets_;
};

// The tetrahedra around a vertex and its edges with a cut: all other centres around it follow from these.
class CutStar
{
public:
    CutStar(const Centres& c, const VertexTets& tets_of) : c_(c), tets_of_(tets_of), seen_(c.points.size(), -1) {}

    // Replaces what was gathered before.
    // Parts come by number of tetrahedron, so sums over them are the same in every run.
    void gather(int32_t v);

    struct Part {
        int32_t tet;
        int32_t mixed;  // in Centres::mixed, or -1
    };

    int32_t vertex() const { return vertex_; }
    const Array<Part>& parts() const { return parts_; }
    const Array<int32_t>& link() const { return link_; }    // the other vertices
    const Array<int32_t>& edges() const { return edges_; }  // still cut
    // These lengths are in the metric at the vertex, if there is one.
    double shortest_edge() const { return shortest_edge_; }
    // The altitude of the vertex in one of its tetrahedra that is least.
    double least_altitude() const;
    // How far along a unit direction an edge at the vertex would meet the opposite edge of its tetrahedron, at least.
    double width_along(const Vec3& direction) const;
    // Places in the frame in which that metric is the identity, for the two.
    Vec3 in_frame(int32_t v) const { return c_.metrics.in_frame(vertex_, c_.point(v)); }

    // Axes along which the vertex must not move, as frozen_axes of mesh/adjacency.hpp has them, from the star alone.
    unsigned frozen_axes() const;

private:
    bool is_inside() const;

    const Centres& c_;
    const VertexTets& tets_of_;
    int32_t vertex_ = -1;
    Array<Part> parts_;
    Array<int32_t> link_, edges_;
    double shortest_edge_ = 0;
    Array<int32_t> seen_;  // by vertex: the last one whose link it was found in
};

// How well shaped the star is, and how its mixed tetrahedra split.
struct StarShape {
    double cost = 0;              // of the tetrahedra that it splits into, see shape_cost
    double least_background = 1;  // least angle_quality of the background tetrahedra themselves
    Array<Fan> fans;              // by part; of mixed ones only
};

// The part of the state that a change of the vertex touches, to go back to.
// Fans are not part of it: trials keep theirs in a StarShape, and take_best() of snap.cpp writes them.
struct StarState {
    Vec3 x;
    MaterialSet materials;
    SampleSpan samples;
    Array<CutEdge> edges;

    void save(const Centres& c, const CutStar& star);
    void restore(Centres& c, const CutStar& star) const;
};

// Gives the vertex a place and materials; its cuts are still those of before.
void change_vertex(Centres& c, const CutStar& star, const Vec3& x, const MaterialSet& materials);

// Finds the cuts around the vertex anew.
void place_cuts(Centres& c, const CutStar& star, Samples& scratch);

// The shape of the star with the fans as they are listed: of a star that has not changed.
void measure_star(const Centres& c, const CutStar& star, StarShape& shape);

// After a change of the vertex, first its tetrahedra that have no cuts and those of the background, then the others.
// The second stops early, with the cost so far, once that is above `limit`.
void measure_background(const Centres& c, const CutStar& star, StarShape& shape);
void measure_fans(const Centres& c, const CutStar& star, double limit, StarShape& shape);

}  // namespace cleft
