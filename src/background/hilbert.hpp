// Walks along Hilbert curves over cubes, squares and segments that are divided as deep as the caller wants.
#pragma once

#include "base/vec.hpp"

#include <array>

namespace cleft
{

// A D-cube that the curve enters at `corner` and leaves at the far end of the last of its edges.
template <size_t D>
struct CurveCell {
    Vec3 corner;
    std::array<Vec3, D> edge;

    Vec3 centre() const
    {
        Vec3 c = corner;
        for (const Vec3& e : edge)
            c += 0.5 * e;
        return c;
    }
    double side() const { return edge[0].cwiseAbs().maxCoeff(); }
};

// The parts in the order of the curve: each is entered where the one before it was left.
inline std::array<CurveCell<1>, 2> divided(const CurveCell<1>& cell)
{
    const Vec3 x = 0.5 * cell.edge[0], &o = cell.corner;
    return {{{o, {x}}, {o + x, {x}}}};
}

inline std::array<CurveCell<2>, 4> divided(const CurveCell<2>& cell)
{
    const Vec3 x = 0.5 * cell.edge[0], y = 0.5 * cell.edge[1], &o = cell.corner;
    return {{{o, {y, x}}, {o + x, {x, y}}, {o + x + y, {x, y}}, {o + x + 2 * y, {-y, -x}}}};
}

// The edges of each part say how the curve turns in it, so no table of states is needed.
inline std::array<CurveCell<3>, 8> divided(const CurveCell<3>& cell)
{
    const Vec3 x = 0.5 * cell.edge[0], y = 0.5 * cell.edge[1], z = 0.5 * cell.edge[2], &o = cell.corner;
    return {{{o, {y, z, x}},
             {o + x, {z, x, y}},
             {o + x + y, {z, x, y}},
             {o + x + 2 * y, {-x, -y, z}},
             {o + x + 2 * y + z, {-x, -y, z}},
             {o + x + 2 * y + 2 * z, {-z, x, -y}},
             {o + x + y + 2 * z, {-z, x, -y}},
             {o + x + 2 * z, {y, -z, -x}}}};
}

// visit(cell) is true where the cell shall be divided further.
template <size_t D, class Visit>
void walk_curve(const CurveCell<D>& cell, const Visit& visit)
{
    if (!visit(cell))
        return;
    for (const CurveCell<D>& part : divided(cell))
        walk_curve(part, visit);
}

}  // namespace cleft
