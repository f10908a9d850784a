// Whether a vertex that takes a second material over pinches one of the two.
//
// Without snapped vertices the interface of two materials is a manifold. A vertex that snaps pulls all of the interface
// around it onto itself. Where it stood between two sheets of interface, as inside a part that is thin, these touch
// then, and the part gets a hole, falls apart or grows together with the next.
//
// The star of the vertex is a ball, and after the change each material in it is the cone from the vertex over its share
// of the ball's surface. Lemma: if both shares are one piece, they are disks, the ball is halved as it was before, and
// nothing outside can tell the difference. On the hull, where the surface of the star ends at a rim, both must reach
// it.
#pragma once

#include "base/array.hpp"
#include "cleaving/star.hpp"

namespace cleft
{

class PinchCheck
{
public:
    explicit PinchCheck(const Centres& c) : c_(c), place_(c.points.size(), -1) {}

    enum class Finding { sound, pinched, unknown };

    // The vertex of the star has taken materials over, `before` it had those. Unknown where there are more than two
    // materials, which meet in lines and points of many shapes.
    // The vertex already has its new materials, but the cuts around it need not be placed: only sets are looked at.
    Finding look(const CutStar& star, const MaterialSet& before);

private:
    using Triangle = std::array<int32_t, 3>;  // vertices by their places in the link
    enum class Side : int8_t { second = -1, interface = 0, first = 1 };
    struct InterfaceEdge {
        int32_t low, high;
        int32_t node;  // of the triangle that has the edge
    };

    bool load(const CutStar& star, const MaterialSet& before);
    void join_sides();
    void join_triangle(size_t triangle);
    void join_along_interface();
    bool are_one_piece_each();
    bool reach_the_rim();
    void find_rim();
    int32_t root(int32_t node);
    void join(int32_t a, int32_t b);

    const Centres& c_;
    Array<int32_t> place_;  // of a vertex in the link it was seen in last

    // The surface of the star. Nodes: vertices of the link, then triangles, which count where all corners are at the
    // interface.
    Array<Triangle> triangles_;
    Array<Side> side_;
    Array<int32_t> parent_;
    Array<InterfaceEdge> along_;
    Array<std::array<int32_t, 2>> rim_;
};

}  // namespace cleft
