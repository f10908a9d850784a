// Contracts edges, if all conditions are met. They are checked from cheap to expensive.
#include "remeshing/contraction.hpp"

#include "mesh/adjacency.hpp"

#include <algorithm>
#include <numeric>

namespace cleft
{

namespace
{

// It is less than every material, so it stands first in a sorted list.
constexpr Material kOutside = -1;

void keep_different(Array<Material>& materials)
{
    std::sort(materials.begin(), materials.end());
    materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
}

}  // namespace

int Contraction::BoundaryStar::triangles_at(int32_t other) const
{
    const auto e = std::lower_bound(edges.begin(), edges.end(), other,
                                    [](const BoundaryEdge& edge, int32_t v) { return edge.other < v; });
    return e != edges.end() && e->other == other ? e->triangles : 0;
}

bool Contraction::BoundaryStar::has(const Opposite& triangle) const
{
    return std::binary_search(triangles.begin(), triangles.end(), triangle);
}

bool Contraction::find(const LocalMesh& mesh, int32_t t, int corner_gone, int corner_kept, Cavity& cavity, double share,
                       double enough)
{
    gone_ = mesh.tet(t)[corner_gone];
    kept_ = mesh.tet(t)[corner_kept];
    if (!hull_allows(mesh))
        return false;
    star_gone_.assign(mesh.star(gone_).begin(), mesh.star(gone_).end());
    // The tetrahedra that vanish count too: they are often those that the contraction is made for.
    const double floor = std::max(std::min(share * mesh.worst(star_gone_), enough), kLeastSine);
    // The shapes first: they rule out nearly all, and at the lowest price.
    if (!shapes_get_better(mesh, cavity, floor) || !same_stratum(mesh) || !materials_are_connected(mesh) ||
        !links_allow(mesh))
        return false;
    return true;
}

// The point that goes may only slide within the planes of the hull that it lies in.
bool Contraction::hull_allows(const LocalMesh& mesh) const
{
    const unsigned gone = mesh.frozen(gone_), kept = mesh.frozen(kept_);
    if (gone == 7 || (gone & ~kept) != 0)
        return false;
    for (int axis = 0; axis < 3; ++axis)
        if ((gone >> axis & 1u) && mesh.point(gone_)[axis] != mesh.point(kept_)[axis])
            return false;
    return true;
}

bool Contraction::shapes_get_better(const LocalMesh& mesh, Cavity& cavity, double floor) const
{
    cavity.clear();
    for (const int32_t t : star_gone_) {
        Tet tet = mesh.tet(t);
        if (has_corner(tet, kept_))
            continue;
        tet[mesh.corner_of(t, gone_)] = kept_;
        if (mesh.quality(tet) <= floor)
            return false;
        cavity.add(tet, mesh.material(t));
    }
    cavity.old_tets = star_gone_;
    return true;
}

// The materials that meet at the point, the outside counted as one, must be those that meet along the edge: then the
// edge runs in the interface or line that the point lies in.
bool Contraction::same_stratum(const LocalMesh& mesh)
{
    at_point_.clear();
    at_edge_.clear();
    const bool is_inside = mesh.frozen(gone_) == 0;
    for (const int32_t t : star_gone_) {
        const Tet& tet = mesh.tet(t);
        const bool at_edge = has_corner(tet, kept_);
        at_point_.push_back(mesh.material(t));
        if (at_edge)
            at_edge_.push_back(mesh.material(t));
        if (is_inside)  // no face of the hull is at the point
            continue;
        for (int corner = 0; corner < 4; ++corner)
            if (tet[corner] != gone_ && mesh.neighbour(t, corner) < 0) {
                at_point_.push_back(kOutside);
                if (at_edge && tet[corner] != kept_)
                    at_edge_.push_back(kOutside);
            }
    }
    keep_different(at_point_);
    keep_different(at_edge_);
    return at_point_ == at_edge_;
}

// Each material is in one piece around the point: no two parts of it touch in the point or an edge only.
bool Contraction::materials_are_connected(const LocalMesh& mesh)
{
    if (at_point_.size() == 1)
        return true;
    // Union by smallest index, over faces at the point between tetrahedra of one material.
    const auto index_of = [&](int32_t t) {
        return static_cast<int32_t>(std::find(star_gone_.begin(), star_gone_.end(), t) - star_gone_.begin());
    };
    part_.resize(star_gone_.size());
    std::iota(part_.begin(), part_.end(), 0);
    const auto root = [&](int32_t i) {
        while (part_[i] != i)
            i = part_[i];
        return i;
    };
    for (int32_t i = 0; i < star_gone_.count(); ++i) {
        const int32_t t = star_gone_[i];
        for (int corner = 0; corner < 4; ++corner) {
            if (mesh.tet(t)[corner] == gone_ || mesh.is_boundary(t, corner))
                continue;
            const int32_t a = root(i), b = root(index_of(mesh.neighbour(t, corner)));
            part_[std::max(a, b)] = std::min(a, b);
        }
    }
    size_t parts = 0;
    for (int32_t i = 0; i < part_.count(); ++i)
        parts += root(i) == i;
    // The outside has no tetrahedra here, so it makes no part.
    return parts == at_point_.size() - (at_point_[0] == kOutside);
}

void Contraction::load_boundary(const LocalMesh& mesh, int32_t v, const Array<int32_t>& star, BoundaryStar& out) const
{
    out.triangles.clear();
    for (const int32_t t : star)
        for (int corner = 0; corner < 4; ++corner) {
            const Tet& tet = mesh.tet(t);
            if (tet[corner] == v || !mesh.is_boundary(t, corner))
                continue;
            Opposite pair{-1, -1};
            for (const int k : kFaceCorners[corner])
                if (tet[k] != v)
                    (pair[0] < 0 ? pair[0] : pair[1]) = tet[k];
            CLEFT_ASSERT(pair[0] >= 0 && pair[1] >= 0);
            std::sort(pair.begin(), pair.end());
            out.triangles.push_back(pair);
        }
    std::sort(out.triangles.begin(), out.triangles.end());
    out.triangles.erase(std::unique(out.triangles.begin(), out.triangles.end()), out.triangles.end());
    Array<int32_t> ends;
    for (const Opposite& triangle : out.triangles)
        ends.insert(ends.end(), triangle.begin(), triangle.end());
    std::sort(ends.begin(), ends.end());
    out.edges.clear();
    for (const int32_t end : ends)
        if (out.edges.empty() || out.edges.back().other != end)
            out.edges.push_back({end, 1});
        else
            ++out.edges.back().triangles;
}

// The link condition (Dey, Edelsbrunner, Guha and Nekhayev), for the boundary triangles and for the lines where more
// than two of them meet: what the two ends have in common, the edge has. For the tetrahedra it holds by itself, since
// the new ones are positive and fill the same cavity.
bool Contraction::links_allow(const LocalMesh& mesh)
{
    if (at_point_.size() == 1)
        return true;
    star_kept_.assign(mesh.star(kept_).begin(), mesh.star(kept_).end());
    load_boundary(mesh, gone_, star_gone_, boundary_gone_);
    load_boundary(mesh, kept_, star_kept_, boundary_kept_);
    int lines = 0;
    for (const BoundaryEdge& edge : boundary_gone_.edges) {
        lines += edge.triangles != 2;
        if (edge.other == kept_)
            continue;
        const int kept_triangles = boundary_kept_.triangles_at(edge.other);
        const Opposite triangle{std::min(kept_, edge.other), std::max(kept_, edge.other)};
        // Both ends have a boundary edge to this point, but no triangle spans the three. Two sheets would become one.
        if (kept_triangles > 0 && !boundary_gone_.has(triangle))
            return false;
        // Lines run from both ends to this point. The contraction would lay one on the other.
        if (kept_triangles > 0 && kept_triangles != 2 && edge.triangles != 2)
            return false;
    }
    // A point on a line may only go along the line, and not if it is a corner of lines.
    const int along = boundary_gone_.triangles_at(kept_);
    if (lines != 0 && (lines != 2 || along == 2))
        return false;
    // A triangle over the same edge at both ends: the two would coincide, and the material between them would be gone.
    for (const Opposite& triangle : boundary_gone_.triangles)
        if (boundary_kept_.has(triangle))
            return false;
    return true;
}

}  // namespace cleft
