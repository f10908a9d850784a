// Edge contraction: takes out a point by moving it onto a neighbour.
#pragma once

#include "base/array.hpp"
#include "remeshing/cavity.hpp"

namespace cleft
{

// Finds contractions that change nothing but shapes: the hull, which materials meet where, and the topology
// of every material and interface stay. Keeps its memory between calls.
class Contraction
{
public:
    // To move the first corner of t onto the second and take out the tetrahedra between, if that is allowed and makes
    // the worst tetrahedron at the first corner better (than `share` of its quality). True if `cavity` has it to apply.
    // A `share` below 1 lets shapes get worse, for operations that pay only later.
    // Shapes that are better than `enough` are never refused.
    bool find(const LocalMesh& mesh, int32_t t, int corner_gone, int corner_kept, Cavity& cavity, double share = 1,
              double enough = 1);

private:
    // A boundary triangle (of an interface or the hull) at a point, by its two other points in ascending order.
    using Opposite = std::array<int32_t, 2>;
    // What the boundary triangles at a point look like from an edge of the point.
    struct BoundaryEdge {
        int32_t other;  // end of the edge
        int triangles;  // at the edge
    };
    struct BoundaryStar {
        Array<Opposite> triangles;  // ascending
        Array<BoundaryEdge> edges;  // ascending by `other`

        int triangles_at(int32_t other) const;
        bool has(const Opposite& triangle) const;
    };

    // The conditions, from cheap to expensive except for shapes_get_better, which refuses most. Some use what those
    // before have found.
    bool hull_allows(const LocalMesh& mesh) const;
    bool shapes_get_better(const LocalMesh& mesh, Cavity& cavity, double floor) const;
    bool same_stratum(const LocalMesh& mesh);
    bool materials_are_connected(const LocalMesh& mesh);
    bool links_allow(const LocalMesh& mesh);
    void load_boundary(const LocalMesh& mesh, int32_t v, const Array<int32_t>& star, BoundaryStar& out) const;

    int32_t gone_ = -1, kept_ = -1;
    Array<int32_t> star_gone_, star_kept_;
    BoundaryStar boundary_gone_, boundary_kept_;
    Array<Material> at_point_, at_edge_;
    Array<int32_t> part_;
};

}  // namespace cleft
