// The charge of a part of the box, cell by cell along a Hilbert curve, in cells small enough that h is as good as
// constant in each.
#pragma once

#include "background/charge.hpp"
#include "background/hilbert.hpp"
#include "background/particle_set.hpp"
#include "base/array.hpp"
#include "base/random.hpp"

namespace cleft
{

// A face (D = 2) or an edge (D = 1) of the box, or its inside (D = 3).
template <size_t D>
struct BoxPart {
    std::array<int, D> axes;     // that are free
    Vec3 origin = Vec3::Zero();  // has the coordinates of the axes that are held
    Walls walls = 0;
    uint64_t number = 0;  // its own, for random numbers
};

inline BoxPart<3> inside_of_box() { return {{0, 1, 2}, Vec3::Zero(), 0, 24}; }

// One cube, square or segment around the part, at a random place, so that its cells are not aligned with the walls
// (aligned cells of equal size would make a simple cubic lattice, the worst for Delaunay).
template <size_t D>
CurveCell<D> root_cell(const BoxPart<D>& part, const Vec3& extent, uint64_t variation)
{
    double longest = 0;
    for (const int axis : part.axes)
        longest = std::max(longest, extent[axis]);
    const uint64_t stream = hashed(variation, part.number);
    const double slack = longest * (0.05 + 0.3 * unit_random(stream, 0));
    CurveCell<D> cell;
    cell.corner = part.origin;
    for (size_t i = 0; i < D; ++i) {
        cell.edge[i] = (longest + slack) * Vec3::Unit(part.axes[i]);
        cell.corner[part.axes[i]] = -slack * (0.1 + 0.8 * unit_random(stream, 1 + i));
    }
    return cell;
}

// The measure of a cell without what lies outside the box or within `layer` of the border of the part; `centre`
// becomes the centre of what is left.
template <size_t D>
double clip(const BoxPart<D>& part, const Vec3& extent, double side, double layer, Vec3& centre)
{
    double measure = 1;
    for (const int axis : part.axes) {
        const double low = std::max(centre[axis] - side / 2, layer);
        const double high = std::min(centre[axis] + side / 2, extent[axis] - layer);
        if (high <= low)
            return 0;
        measure *= high - low;
        centre[axis] = (low + high) / 2;
    }
    return measure;
}

// visit(cell, h) for the cells that meet the part and are not wider than `widest` h, in the order of the curve.
template <size_t D, class Visit>
void walk_cells(const BoxPart<D>& part, const SizeSampler& size, const CurveCell<D>& root, double widest,
                const Visit& visit)
{
    walk_curve(root, [&](const CurveCell<D>& cell) {
        Vec3 centre = cell.centre();
        const double side = cell.side();
        if (clip(part, size.extent(), side, 0, centre) == 0)
            return false;
        const double h = size(cell.centre());
        if (side > widest * h)
            return true;
        visit(cell, h);
        return false;
    });
}

// Runs of the curve for parallel work.
template <size_t D>
Array<CurveCell<D>> curve_tasks(const BoxPart<D>& part, const SizeSampler& size, uint64_t variation)
{
    // In h: some 100 to 900 particles in a task, which depends on the field alone and not on the threads.
    constexpr double kTaskSize = 8;
    Array<CurveCell<D>> tasks;
    walk_cells(part, size, root_cell(part, size.extent(), variation), kTaskSize,
               [&](const CurveCell<D>& cell, double) { tasks.push_back(cell); });
    return tasks;
}

// The widest cell of charge, in h. It holds a third of a particle, so that the centroid of a unit of charge is taken
// from a few cells and h changes little in each; smaller cells give no better angles and cost more.
inline constexpr double kCellSize = 0.6;

// visit(centre, charge, h) along the curve. The charge within `layer` h of the border of the part is left out.
template <size_t D, class Visit>
void walk_charge(const BoxPart<D>& part, const SizeSampler& size, const CurveCell<D>& task, double layer,
                 const Visit& visit)
{
    walk_cells(part, size, task, kCellSize, [&](const CurveCell<D>& cell, double h) {
        Vec3 centre = cell.centre();
        const double measure = clip(part, size.extent(), cell.side(), layer * h, centre);
        double charge = kParticleDensity[D] * measure;
        for (size_t i = 0; i < D; ++i)
            charge /= h;
        if (measure > 0)
            visit(centre, charge, h);
    });
}

}  // namespace cleft
