// One after the other in the order of the tetrahedra, since each split changes those around.
#include "fitting/split_far_edges.hpp"

#include "fitting/meetings.hpp"
#include "mesh/adjacency.hpp"
#include "remeshing/edge_split.hpp"
#include "remeshing/tet_star.hpp"
#include "volume/tie.hpp"

#include <algorithm>
#include <optional>

namespace cleft
{

namespace
{

// Of the least spacing. Where an interface is more curved than this, it has features, and the sizes follow them:
// shorter edges need no look.
constexpr double kLeastRadius = 2;

class FarEdges
{
public:
    FarEdges(LocalMesh& mesh, const Volume& volume, double error, double floor)
        : mesh_(mesh),
          volume_(volume),
          error_(error),
          floor_(floor),
          least_square_(8 * error * kLeastRadius * volume.grid().spacing.minCoeff())
    {
    }

    bool is_long(int32_t a, int32_t b) const { return (mesh_.point(a) - mesh_.point(b)).squaredNorm() > least_square_; }

    // The edge between two corners of t, as the first of its tetrahedra sees it.
    bool split(int32_t t, int corner_a, int corner_b)
    {
        EdgeRing& ring = cavity_.ring;
        mesh_.ring(t, corner_a, corner_b, ring);
        if (!ring.whole || *std::min_element(ring.tets.begin(), ring.tets.end()) != t)
            return false;
        const auto on_tie = place_in(ring);
        if (!on_tie)
            return false;
        star_.load(mesh_, ring);
        const Vec3 middle = 0.5 * (mesh_.point(ring.a) + mesh_.point(ring.b));
        // Where the tie is too near to a point beside the edge, half of the way leaves half of the error.
        for (const double share : {1.0, 0.5}) {
            const Vec3 x = middle + share * (*on_tie - middle);
            if (star_.worst_at(x, floor_) > floor_) {
                find_split(mesh_, cavity_);
                apply_split(mesh_, x, cavity_);
                return true;
            }
        }
        return false;
    }

private:
    // The point of the tie next to the middle, if that is too far from it.
    std::optional<Vec3> place_in(const EdgeRing& ring)
    {
        const auto materials = materials_of(ring.tets, mesh_.materials());
        if (!materials || materials->size() < 2)
            return std::nullopt;
        const Vec3 &a = mesh_.point(ring.a), &b = mesh_.point(ring.b), middle = 0.5 * (a + b);
        const auto on_tie = project_to_tie(volume_, middle, middle, *materials, frozen_on_edge(mesh_, ring),
                                           0.5 * (a - b).norm(), samples_);
        return on_tie && (*on_tie - middle).norm() > error_ ? on_tie : std::nullopt;
    }

    LocalMesh& mesh_;
    const Volume& volume_;
    const double error_, floor_, least_square_;
    Cavity cavity_;
    TetStar star_;
    Samples samples_;
};

}  // namespace

int64_t split_far_edges(LocalMesh& mesh, const Volume& volume, double error, double floor, const Run& run)
{
    const Meetings meetings = find_meetings(mesh, run);
    FarEdges edges(mesh, volume, error, floor);
    // New points and tetrahedra are left alone: they come after these.
    const int32_t tets = mesh.slot_count();
    const int32_t points = mesh.point_count();
    const auto is_at_interface = [&](int32_t v) { return v < points && meetings[v] >= Meeting::interface; };
    int64_t count = 0;
    for (int32_t t = 0; t < tets; ++t) {
        run.check_at(t);
        for (int e = 0; e < 6 && mesh.alive(t); ++e) {
            const auto& ends = kEdgeCorners[e];
            const int32_t a = mesh.tet(t)[ends[0]], b = mesh.tet(t)[ends[1]];
            if (is_at_interface(a) && is_at_interface(b) && edges.is_long(a, b))
                count += edges.split(t, ends[0], ends[1]);
        }
    }
    return count;
}

}  // namespace cleft
