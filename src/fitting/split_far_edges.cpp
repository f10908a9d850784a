// Finds the edges side by side. Splits them one after the other, since each split changes the tetrahedra around.
#include "fitting/split_far_edges.hpp"

#include "base/collect.hpp"
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
// Points of interfaces for each far edge, at least. Where sizes follow the error there are some hundred. Fewer are
// those of a mesh whose sizes somebody made for something else: there splits would not mend single edges, but make
// another mesh.
constexpr int64_t kPointsOfFar = 10;
// Tetrahedra that a thread looks at. The number changes the time alone.
constexpr int64_t kFarTetsAtOnce = 1 << 14;

bool is_at_interface(Meeting meeting) { return meeting >= Meeting::interface; }

struct Edge {
    int32_t a, b;
};

class FarEdges
{
public:
    FarEdges(const LocalMesh& mesh, const Volume& volume, double error)
        : mesh_(mesh),
          volume_(volume),
          error_(error),
          least_square_(8 * error * kLeastRadius * volume.grid().spacing.minCoeff())
    {
    }

    // The edges of t that are too far off and have no tetrahedron of a lesser number.
    void find(int32_t t, const Meetings& meetings, Array<Edge>& far)
    {
        for (const auto& [corner_a, corner_b] : kEdgeCorners) {
            const int32_t a = mesh_.tet(t)[corner_a], b = mesh_.tet(t)[corner_b];
            if (!is_at_interface(meetings[a]) || !is_at_interface(meetings[b]) || !is_long(a, b))
                continue;
            if (mesh_.is_settled(a) || mesh_.is_settled(b))
                continue;
            mesh_.ring(t, corner_a, corner_b, cavity_.ring);
            if (*std::min_element(cavity_.ring.tets.begin(), cavity_.ring.tets.end()) == t && place_on_tie())
                far.push_back({a, b});
        }
    }

    // Not for a mesh that others read.
    bool split(const Edge& edge, double floor, LocalMesh& mesh)
    {
        const int32_t t = mesh.tet_at(edge.a, edge.b);
        if (t < 0)
            return false;
        mesh.ring(t, mesh.corner_of(t, edge.a), mesh.corner_of(t, edge.b), cavity_.ring);
        return split_ring(floor, mesh);
    }

private:
    bool is_long(int32_t a, int32_t b) const { return (mesh_.point(a) - mesh_.point(b)).squaredNorm() > least_square_; }

    bool split_ring(double floor, LocalMesh& mesh)
    {
        const EdgeRing& ring = cavity_.ring;
        const auto on_tie = place_on_tie();
        if (!on_tie)
            return false;
        star_.load(mesh_, ring);
        const Vec3 middle = 0.5 * (mesh_.point(ring.a) + mesh_.point(ring.b));
        // Where the tie is too near to a point beside the edge, half of the way leaves half of the error.
        for (const double share : {1.0, 0.5}) {
            const Vec3 x = middle + share * (*on_tie - middle);
            if (star_.worst_at(x, floor) > floor) {
                find_split(mesh_, cavity_);
                apply_split(mesh, x, cavity_);
                return true;
            }
        }
        return false;
    }

    // The point of the tie next to the middle of the edge, if that is too far from it.
    std::optional<Vec3> place_on_tie()
    {
        const EdgeRing& ring = cavity_.ring;
        const auto materials = ring.whole ? materials_of(ring.tets, mesh_.materials()) : std::nullopt;
        if (!materials || materials->size() < 2)
            return std::nullopt;
        const Vec3 &a = mesh_.point(ring.a), &b = mesh_.point(ring.b), middle = 0.5 * (a + b);
        const auto on_tie = project_to_tie(volume_, middle, middle, *materials, frozen_on_edge(mesh_, ring),
                                           0.5 * (a - b).norm(), samples_);
        return on_tie && (*on_tie - middle).norm() > error_ ? on_tie : std::nullopt;
    }

    const LocalMesh& mesh_;
    const Volume& volume_;
    const double error_, least_square_;
    Cavity cavity_;
    TetStar star_;
    Samples samples_;
};

Array<Edge> find_far_edges(const LocalMesh& mesh, const Volume& volume, double error, const Meetings& meetings,
                           const Run& run)
{
    return collect<Edge>(run, mesh.slot_count(), kFarTetsAtOnce, [&](int64_t begin, int64_t end, Array<Edge>& list) {
        FarEdges edges(mesh, volume, error);
        for (auto t = static_cast<int32_t>(begin); t < end; ++t)
            if (mesh.alive(t))
                edges.find(t, meetings, list);
    });
}

}  // namespace

bool are_sizes_for(double error, const LocalMesh& mesh, const Volume& volume, const Meetings& meetings, const Run& run)
{
    return find_far_edges(mesh, volume, error, meetings, run).count() <=
           std::count_if(meetings.begin(), meetings.end(), is_at_interface) / kPointsOfFar;
}

int64_t split_far_edges(LocalMesh& mesh, const Volume& volume, double error, double floor, const Run& run)
{
    const Array<Edge> far = find_far_edges(mesh, volume, error, find_meetings(mesh, run), run);
    FarEdges edges(mesh, volume, error);
    int64_t count = 0;
    for (const Edge& edge : far) {
        run.check_at(&edge - far.data());
        count += edges.split(edge, floor, mesh);
    }
    return count;
}

}  // namespace cleft
