// Delaunay tetrahedra by the insertion of points, one by one: Bowyer and Watson's algorithm in exact arithmetic.
#pragma once

#include "base/array.hpp"
#include "delaunay/cell.hpp"
#include "delaunay/perturbed.hpp"
#include "delaunay/sphere.hpp"

#include <cstdint>

namespace cleft
{

// The tetrahedra do not depend on the order of insertion. Points must differ: else TwoAtOnePlace is thrown.
class DelaunayKernel
{
public:
    // Forgets all, and keeps the memory. The frame has its origin at `origin`; the nearer the points, the fewer tests
    // need more than one distance. `reach` bounds the coordinates in it.
    void clear(const Vec3& origin, double reach);
    // The vertices are numbered from 1. `number`, which is no other's, decides ties. Nothing is inserted yet.
    int32_t add_vertex(const Vec3& x, int32_t number);
    // The first tetrahedron, of vertices that are not in one plane.
    void begin(const FixedArray<int32_t, 4>& vertices);
    void insert(int32_t vertex) { insert(vertex, locate(seen(vertex))); }
    // Where a cell is known whose sphere has the vertex inside.
    void insert(int32_t vertex, int32_t cell);

    const Array<Cell>& cells() const { return cells_; }
    // The cells that the last insertion made.
    const Array<int32_t>& made() const { return made_; }
    int32_t number(int32_t vertex) const { return numbers_[vertex]; }
    const Vec3& place(int32_t vertex) const { return vertices_[vertex].x; }
    void certify(int32_t cell) { cells_[cell].certified = 1; }
    // Of the cell's sphere; for a point that is no corner.
    bool has_inside(const Cell& cell, const NumberedPoint& point) const;
    const Vec3& origin() const { return origin_; }
    // What a coordinate in the frame may be off by.
    double rounding() const { return rounding_; }

private:
    struct Vertex {
        Vec3 x;
        uint32_t stamp;  // of the insertion for which `slot` holds
        int32_t slot;
    };
    // What is tested against cells.
    struct Seen {
        NumberedPoint point;
        Vec3 x, in_frame;
    };
    // A face of the cavity, as Cell::behind has it, and what is behind it.
    struct BorderFace {
        int32_t face, behind;
    };

    Seen seen(int32_t vertex) const;
    static double square_from(const Cell& cell, const Seen& p)
    {
        const Pair xy = Pair{p.in_frame[0], p.in_frame[1]} -
                        Pair{static_cast<double>(cell.centre[0]), static_cast<double>(cell.centre[1])};
        const double z = p.in_frame[2] - static_cast<double>(cell.centre[2]);
        const Pair squares = xy * xy;
        return squares[0] + squares[1] + z * z;
    }
    bool in_conflict(const Cell& cell, const Seen& p) const
    {
        const double square = square_from(cell, p);
        if (square > static_cast<double>(cell.outer))
            return false;
        return square < static_cast<double>(cell.inner) || doubtful_in_conflict(cell, p);
    }
    // Of a ghost, or of a real cell near whose sphere p is.
    bool doubtful_in_conflict(const Cell& cell, const Seen& p) const
    {
        return cell.is_real() ? has_inside(cell, p.point) : ghost_in_conflict(cell, p);
    }
    bool ghost_in_conflict(const Cell& cell, const Seen& p) const;
    template <bool kExact>
    int exit_face(const Cell& cell, const Vec3& p, int entry) const;
    template <bool kExact>
    int32_t walk(const Seen& p) const;
    int32_t locate(const Seen& p) const;
    void find_cavity(const Seen& p, int32_t first);
    void make_room(size_t count);
    void see_corners(const Vec3& p);
    void take_cells();
    void fill_cells(int32_t vertex);
    void link_cells();
    void link_many_cells();
    void set_spheres(const Seen& p);

    Vec3 origin_;
    double rounding_ = 0;
    Array<Vertex> vertices_;
    Array<int32_t> numbers_;
    Array<Cell> cells_;
    Array<int32_t> free_;
    int32_t last_ = 0;  // a real cell
    uint32_t insertion_ = 0;
    // Of one insertion. Arrays do not shrink; the counts tell how much of them is used.
    Array<int32_t> cavity_, made_;
    Array<BorderFace> border_;
    Array<FixedArray<int32_t, 3>> faces_;  // the corners of the border, wound so that it looks outward
    Array<FixedArray<int32_t, 3>> slots_;  // and their places in corners_
    Array<int32_t> seen_;                  // the vertices of the border
    Array<SeenCorner> corners_;
    size_t cavity_size_ = 0, border_size_ = 0, corner_count_ = 0;
    Array<uint16_t> edges_;
};

}  // namespace cleft
