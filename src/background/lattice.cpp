// Cells of a body-centred cubic lattice between the walls of a box, as tetrahedra.
#include "background/lattice.hpp"

#include "background/bcc_cell.hpp"
#include "base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cleft
{

namespace
{

class Lattice
{
public:
    // `layers`: those of the cells across the last axis that are there.
    Lattice(const Vec3& extent, const FixedArray<int32_t, 3>& cells, Planes layers)
        : extent_(extent), n_(cells), layers_(layers)
    {
        CLEFT_ASSERT(corner_count() + cell_count() <= INT32_MAX);
    }

    int64_t corner_count() const { return int64_t{n_[0] + 1} * (n_[1] + 1) * (layers_.count + 1); }
    int64_t cell_count() const { return int64_t{n_[0]} * n_[1] * layers_.count; }

    int32_t corner(const FixedArray<int32_t, 3>& at) const
    {
        return static_cast<int32_t>(at[0] +
                                    int64_t{n_[0] + 1} * (at[1] + int64_t{n_[1] + 1} * (at[2] - layers_.first)));
    }
    int32_t centre(const FixedArray<int32_t, 3>& at) const
    {
        return static_cast<int32_t>(corner_count() + at[0] +
                                    int64_t{n_[0]} * (at[1] + int64_t{n_[1]} * (at[2] - layers_.first)));
    }

    Array<Vec3> points() const
    {
        Array<Vec3> out;
        out.reserve(corner_count() + cell_count());
        for (int half = 0; half < 2; ++half)  // corners, then centres
            for (int32_t k = layers_.first; k < layers_.end() + 1 - half; ++k)
                for (int32_t j = 0; j < n_[1] + 1 - half; ++j)
                    for (int32_t i = 0; i < n_[0] + 1 - half; ++i)
                        out.emplace_back(coordinate(0, i, half), coordinate(1, j, half), coordinate(2, k, half));
        return out;
    }

    // The corners of the face of cell `at` across `axis` (side 0: low, 1: high), wound so that the normal looks along
    // the axis.
    FixedArray<int32_t, 4> face(FixedArray<int32_t, 3> at, int axis, int side) const
    {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        at[axis] += side;
        FixedArray<int32_t, 4> out{};
        for (size_t c = 0; c < 4; ++c) {
            auto p = at;
            p[u] += c == 1 || c == 2;
            p[v] += c >= 2;
            out[c] = corner(p);
        }
        return out;
    }

private:
    // Exactly 0 and exactly the extent at the walls.
    double coordinate(int axis, int32_t i, int half) const
    {
        const double extent = extent_[axis];
        return half == 0 && i == n_[axis] ? extent : (i + 0.5 * half) * (extent / n_[axis]);
    }

    Vec3 extent_;
    FixedArray<int32_t, 3> n_;
    Planes layers_;
};

// Between two cells: the four tetrahedra around the line from the lower centre to the upper one.
void emit_octahedron(int32_t low, int32_t high, const FixedArray<int32_t, 4>& face, Array<Tet>& tets)
{
    for (size_t c = 0; c < 4; ++c)
        tets.push_back({low, face[c], face[(c + 1) % 4], high});
}

// At a wall: the pyramid over the face, cut along a diagonal whose direction alternates from cell to cell. `face` is
// wound so that the apex lies behind it.
// The alternation leaves the wall without a preferred direction.
void emit_pyramid(int32_t apex, const FixedArray<int32_t, 4>& face, bool odd, Array<Tet>& tets)
{
    const size_t s = odd ? 1 : 0;
    tets.push_back({apex, face[s], face[s + 1], face[s + 2]});
    tets.push_back({apex, face[s], face[s + 2], face[(s + 3) % 4]});
}

FixedArray<int32_t, 3> cell_counts(const Vec3& extent, double size)
{
    // A cell longer than the thinnest side of the box would be flattened by it.
    const double side = std::min(size / kMeanEdge, extent.minCoeff());
    FixedArray<int32_t, 3> cells{};
    double points = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double n = std::max(1.0, std::round(extent[axis] / side));
        points *= 2 * (n + 1);
        cells[axis] = static_cast<int32_t>(std::min(n, 1e9));
    }
    // The product is eight times the number of corners; corners and centres together are a quarter of it.
    if (points > 4.0 * INT32_MAX)
        throw Error(CLEFT_ERROR_TOO_LARGE,
                    "a lattice of size " + number_text(size) + " would have more than 2147483647 points");
    return cells;
}

}  // namespace

double lattice_size_for(const Grid& grid, double tets)
{
    return kMeanEdge * std::cbrt(kTetsOfBccCell * grid.extent().prod() / tets);
}

double lattice_tets_for(const Grid& grid, double size) { return std::pow(lattice_size_for(grid, 1) / size, 3); }

double lattice_tets(const Grid& grid, double size)
{
    double tets = kTetsOfBccCell;
    for (const int32_t n : cell_counts(grid.extent(), size))
        tets *= n;
    return tets;
}

namespace
{

TetMesh mesh_of_layers(const Vec3& extent, const FixedArray<int32_t, 3>& n, Planes layers, const Run& run)
{
    const Lattice lattice(extent, n, layers);
    TetMesh mesh;
    mesh.points = lattice.points();
    mesh.tets.reserve(12 * lattice.cell_count());
    FixedArray<int32_t, 3> at{};
    for (at[2] = layers.first; at[2] < layers.end(); ++at[2]) {
        run.report((at[2] - layers.first) / static_cast<double>(layers.count), "background: lattice");
        for (at[1] = 0; at[1] < n[1]; ++at[1])
            for (at[0] = 0; at[0] < n[0]; ++at[0]) {
                const int32_t centre = lattice.centre(at);
                const bool odd = (at[0] + at[1] + at[2]) & 1;
                for (int axis = 0; axis < 3; ++axis) {
                    if (at[axis] == 0) {
                        auto face = lattice.face(at, axis, 0);
                        std::swap(face[1], face[3]);  // outward is against the axis
                        emit_pyramid(centre, face, odd, mesh.tets);
                    }
                    auto next = at;
                    ++next[axis];
                    if (next[axis] == n[axis])
                        emit_pyramid(centre, lattice.face(at, axis, 1), odd, mesh.tets);
                    else if (axis < 2 || layers.has(next[2]))
                        emit_octahedron(centre, lattice.centre(next), lattice.face(at, axis, 1), mesh.tets);
                }
            }
    }
    return mesh;
}

}  // namespace

TetMesh lattice_background(const Grid& grid, double size, const Run& run)
{
    const Vec3 extent = grid.extent();
    const FixedArray<int32_t, 3> n = cell_counts(extent, size);
    return mesh_of_layers(extent, n, {0, n[2]}, run);
}

TetMesh lattice_slab(const Grid& grid, double size, double low, double high, const Run& run)
{
    const Vec3 extent = grid.extent();
    const FixedArray<int32_t, 3> n = cell_counts(extent, size);
    // A tetrahedron is in two layers at most. One more is for the rounding.
    constexpr int32_t kLayersBeside = 2;
    const double side = extent[2] / n[2];
    const auto layer_of = [&](double z) { return std::clamp(static_cast<int32_t>(z / side), 0, n[2] - 1); };
    const int32_t first = std::max(0, layer_of(low) - kLayersBeside);
    return mesh_of_layers(extent, n, {first, std::min(n[2], layer_of(high) + 1 + kLayersBeside) - first}, run);
}

}  // namespace cleft
