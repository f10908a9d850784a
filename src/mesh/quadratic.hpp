// Ten-node tetrahedra: a node in the middle of each edge.
#pragma once

#include "base/array.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Corners, then the middles of edges 01, 12, 02, 03, 13, 23 (the order of VTK, Abaqus C3D10).
using QuadraticTet = std::array<int32_t, 10>;

// The different edges of tetrahedra, and the nodes in their middles, which are numbered after the points.
class MiddleNodes
{
public:
    explicit MiddleNodes(const Array<Tet>& tets);

    size_t count() const { return edges_.size(); }
    // The middle of the straight edge: elements are not curved towards an interface.
    Vec3 place(size_t middle, const Array<Vec3>& points) const;
    // `tet` must be one of those given to the constructor; `point_count` is the number of the first middle node.
    QuadraticTet nodes(const Tet& tet, size_t point_count) const;

private:
    Array<uint64_t> edges_;  // two points each, the lesser one in the upper half; ascending
};

}  // namespace cleft
