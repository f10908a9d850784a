// How the materials around a point hang together.
#pragma once

#include "base/array.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// The link of a point is the surface of its star, a sphere (on the hull: a disk) of one triangle a tetrahedron, in the
// colour of its material. The star is the cone over it. So along the edge to a vertex of the link, the interface of two
// materials is a surface if the colour changes twice around that vertex (in the hull: once); and where no third is
// near, it is a surface at the point itself if each of the two is one piece, which reaches the hull if there is one.
class Link
{
public:
    // One object for all points of a mesh, used again and again; not for several threads.
    explicit Link(size_t point_count) : place_(point_count, -1) {}

    // Of all tetrahedra at the point.
    void load(const LabelledMesh& mesh, int32_t point, const int32_t* first, const int32_t* last);

    // Edges at the point that have two materials and are pinched, and, of two materials, pieces too many.
    int defects() const { return pinched_edges_ + extra_pieces_; }
    // At the point are two materials alone, and it is pinched.
    bool is_pinched() const { return extra_pieces_ > 0; }
    // The other ends of the pinched edges.
    Array<int32_t> pinched_edges() const;

private:
    struct Vertex {
        int32_t point;
        int32_t parent;                    // in the forest of the pattern
        Material first = -1, second = -1;  // around it
        bool has_third = false, is_on_rim = false, is_in_pattern = false;
        int changes = 0;     // of colour, around it
        int32_t edges = -1;  // the last met of those to vertices of greater number

        bool is_mixed() const { return second >= 0; }
        bool is_pinched() const { return !has_third && changes > (is_on_rim ? 1 : 2); }
        void see(Material m);
    };
    struct Triangle {
        std::array<int32_t, 3> corners;
        Material material;
    };
    struct Edge {
        int32_t low, high;
        Material material;  // of the triangle that it was met in first; kMet after the second
        int32_t next;       // of the same low vertex
    };
    static constexpr Material kMet = -1;

    int32_t number(int32_t point);
    void add(const Tet& tet, int32_t point, Material material);
    void meet(const Triangle& triangle, size_t side);
    void find_defects(bool is_sphere, bool has_third);
    void add_to_pattern(int32_t a, int32_t b);
    void find_rim(Vertex& rim);
    int pieces() const;
    int32_t root(int32_t vertex);

    Array<int32_t> place_;  // of a point in the link that it was met in last: below base_, an earlier one
    int32_t base_ = 0;
    Array<Vertex> vertices_;
    Array<Triangle> triangles_;
    Array<Edge> edges_;
    // The pattern: edges where the colour changes, and those of the rim.
    int pattern_edges_ = 0;
    int pinched_edges_ = 0, extra_pieces_ = 0;
};

}  // namespace cleft
