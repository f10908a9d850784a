// A tetrahedral mesh of a box for tests that need a background and no particles: body-centred cubic with jitter.
#pragma once

#include "mesh/quality.hpp"
#include "mesh/tet_mesh.hpp"
#include "support/random.hpp"

#include <algorithm>

namespace cleft_test
{

// Cells of extent / cells, each with its corners and its centre as points. Two centres and an edge of the square
// between their cells make a tetrahedron; squares on the hull are cut in two under the centre next to them.
// Points move by up to `jitter` cells along each axis (0.1 keeps all tetrahedra positive); points of the hull stay in
// their sides, whose coordinates are exactly 0 or the extent.
class BccBox
{
public:
    BccBox(const cleft::Vec3& extent, const std::array<int32_t, 3>& cells, double jitter, uint64_t seed)
        : extent_(extent), cells_(cells)
    {
        Random random(seed);
        for (int32_t k = 0; k <= cells_[2]; ++k)
            for (int32_t j = 0; j <= cells_[1]; ++j)
                for (int32_t i = 0; i <= cells_[0]; ++i)
                    add_point({i, j, k}, 0.0, jitter, random);
        for (int32_t k = 0; k < cells_[2]; ++k)
            for (int32_t j = 0; j < cells_[1]; ++j)
                for (int32_t i = 0; i < cells_[0]; ++i)
                    add_point({i, j, k}, 0.5, jitter, random);
        for (size_t axis = 0; axis < 3; ++axis)
            add_squares(axis);
    }

    cleft::TetMesh mesh;

private:
    using Place = std::array<int32_t, 3>;

    void add_point(const Place& place, double shift, double jitter, Random& random)
    {
        cleft::Vec3 x;
        for (size_t axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<Eigen::Index>(axis);
            const double moved = place[axis] + shift + random.between(-jitter, jitter);
            const bool at_start = shift == 0 && place[axis] == 0;
            const bool at_end = shift == 0 && place[axis] == cells_[axis];
            x[a] = at_start ? 0 : at_end ? extent_[a] : moved * extent_[a] / cells_[axis];
        }
        mesh.points.push_back(x);
    }

    int32_t corner(const Place& p) const { return p[0] + (cells_[0] + 1) * (p[1] + (cells_[1] + 1) * p[2]); }
    int32_t centre(const Place& p) const
    {
        return (cells_[0] + 1) * (cells_[1] + 1) * (cells_[2] + 1) + p[0] + cells_[0] * (p[1] + cells_[1] * p[2]);
    }

    // The squares across an axis.
    void add_squares(size_t axis)
    {
        const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        Place p{};
        for (p[axis] = 0; p[axis] <= cells_[axis]; ++p[axis])
            for (p[v] = 0; p[v] < cells_[v]; ++p[v])
                for (p[u] = 0; p[u] < cells_[u]; ++p[u])
                    add_square(p, axis, u, v);
    }

    void add_square(const Place& p, size_t axis, size_t u, size_t v)
    {
        Place before = p, pu = p, pv = p, puv = p;
        --before[axis];
        ++pu[u], ++puv[u];
        ++pv[v], ++puv[v];
        const std::array<int32_t, 4> square = {corner(p), corner(pu), corner(puv), corner(pv)};
        if (p[axis] == 0 || p[axis] == cells_[axis]) {
            const int32_t apex = centre(p[axis] == 0 ? p : before);
            add_tet({apex, square[0], square[1], square[2]});
            add_tet({apex, square[0], square[2], square[3]});
        } else {
            for (size_t e = 0; e < 4; ++e)
                add_tet({centre(before), centre(p), square[e], square[(e + 1) % 4]});
        }
    }

    void add_tet(cleft::Tet t)
    {
        const auto at = [&](size_t i) { return mesh.points[static_cast<size_t>(t[i])]; };
        if (cleft::orient(at(0), at(1), at(2), at(3)) < 0)
            std::swap(t[2], t[3]);
        mesh.tets.push_back(t);
    }

    cleft::Vec3 extent_;
    std::array<int32_t, 3> cells_;
};

inline cleft::TetMesh jittered_bcc(const cleft::Vec3& extent, const std::array<int32_t, 3>& cells, double jitter = 0.1,
                                   uint64_t seed = 1)
{
    return BccBox(extent, cells, jitter, seed).mesh;
}

}  // namespace cleft_test
