// A tetrahedral mesh that is changed in place by local operations: each takes out a few tetrahedra and fills the cavity
// with others. Repair (one material) and improving (many) work on it.
#pragma once

#include "base/array.hpp"
#include "mesh/point_stars.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/metric_field.hpp"

namespace cleft
{

// A tetrahedron at an edge a b: a, b, c, d are its corners, positively oriented.
struct Hinge {
    int32_t tet, c, d;
};

// The tetrahedra around an edge, in order: tets[i] has the corners a, b, points[i], points[i + 1], positively oriented.
// A ring around an edge of the hull is open: its first and last point lie on the two hull faces at the edge.
struct EdgeRing {
    int32_t a = -1, b = -1;
    bool closed = true;
    // False if the edge may not be changed: where parts of the mesh touch in it alone, and these are the tetrahedra of
    // one part; or where the mesh is held (LocalMesh::hold()).
    bool whole = true;
    Array<int32_t> points;
    Array<int32_t> tets;
    Array<Hinge> unordered;  // room to work in

    size_t size() const { return points.size(); }
};

class LocalMesh
{
public:
    // `material` may be empty: then every tetrahedron has material 0.
    LocalMesh(Array<Vec3> points, Array<Tet> tets, Array<Material> material, const Run& run);

    LocalMesh(LabelledMesh&& mesh, const Run& run)
        : LocalMesh(std::move(mesh.points), std::move(mesh.tets), std::move(mesh.material), run)
    {
    }

    int32_t point_count() const { return static_cast<int32_t>(points_.size()); }
    // Slots of tetrahedra, dead ones included.
    int32_t slot_count() const { return static_cast<int32_t>(tets_.size()); }
    bool alive(int32_t t) const { return tet(t)[0] >= 0; }

    const Vec3& point(int32_t v) const { return points_[v]; }
    const Tet& tet(int32_t t) const { return tets_[t]; }
    Material material(int32_t t) const { return materials_.empty() ? 0 : materials_[t]; }
    // By number, those of dead slots included.
    const Array<Vec3>& points() const { return points_; }
    const Array<Tet>& tets() const { return tets_; }
    const Array<Material>& materials() const { return materials_; }
    // Axes that the point must not move along (see frozen_axes in adjacency.hpp).
    uint8_t frozen(int32_t v) const { return frozen_[v] & kAllAxes; }
    // The points of a hull face where the mesh was cut out of a larger one, whose other part has the face too: they do
    // not move, and hull edges between them are not changed. `until_whole`: searches for better shapes leave the
    // tetrahedra at them to one in the larger mesh, since they would mostly fail here.
    void hold(const Array<int32_t>& points, bool until_whole);
    // Searches leave it for later.
    bool waits(int32_t t) const;
    // The corners of these have the places that they are to have. Searches for better shapes may still move them.
    void settle(const Array<int32_t>& tets);
    bool is_settled(int32_t v) const { return (frozen_[v] & kSettled) != 0; }

    // From here on shapes are measured by a field, which must outlive the mesh.
    void measure_by(const Measure& measure, const Run& run);
    // If not, lengths and angles are those of the frame.
    bool is_measured() const { return measure_.field != nullptr; }
    // The metric at a point, if the mesh is measured.
    const Tensor& metric(int32_t v) const { return metrics_[v].metric; }
    const Tensor& log_metric(int32_t v) const { return metrics_[v].log; }
    // A part of an edge in the frame in which its metric is the identity, up to a factor that keeps volumes; the part
    // itself if the mesh is not measured.
    Vec3 measured_on_edge(int32_t a, int32_t b, const Vec3& part) const
    {
        return is_measured() ? unit_exp(0.25 * (log_metric(a) + log_metric(b))) * part : part;
    }

    // The tetrahedra at a point. Valid until the mesh changes.
    PointStars::Range star(int32_t v) const { return stars_.at(v); }
    // A tetrahedron at both points; -1 if there is none.
    int32_t tet_at(int32_t v, int32_t w) const;
    // Behind the face opposite `corner`; -1 on the hull.
    int32_t neighbour(int32_t t, int corner) const;
    // The tetrahedron behind the face is of another material, or there is none.
    bool is_boundary(int32_t t, int corner) const;
    // The corner of t that is v; 4 if none is.
    int corner_of(int32_t t, int32_t v) const
    {
        const Tet& c = tet(t);
        return c[0] == v ? 0 : c[1] == v ? 1 : c[2] == v ? 2 : c[3] == v ? 3 : 4;
    }
    // The ring around the edge between two corners of t.
    void ring(int32_t t, int corner_a, int corner_b, EdgeRing& out) const;

    // All tetrahedra at the point must stay positive, and frozen axes unchanged. The caller checks both.
    void move(int32_t v, const Vec3& to);
    // Returns its number. The point has no tetrahedra until replace() gives it some.
    int32_t add_point(const Vec3& x, uint8_t frozen);
    // Takes out `old_tets` and puts in `new_tets`, which must fill the same cavity. The numbers of the new ones go to
    // `created`.
    void replace(const Array<int32_t>& old_tets, const Array<Tet>& new_tets, const Array<Material>& new_materials,
                 Array<int32_t>& created);
    // Its three steps. The second may be taken by several threads at once for changes that have no point in common.
    // `worker`: of the threads of the run that the mesh was made with. The other two are for one thread.
    void reserve(const Array<int32_t>& old_tets, size_t new_count, Array<int32_t>& created);
    void refill(const Array<int32_t>& old_tets, const Array<Tet>& new_tets, const Array<Material>& new_materials,
                const Array<int32_t>& created, int worker);
    void release(const Array<int32_t>& old_tets, size_t new_count);

    // See shape_quality: of a tetrahedron, and the least of several. What was found is kept, so that asking again costs
    // nothing. For several threads as long as none changes the tetrahedron.
    double quality(int32_t t) const;
    double quality(const Tet& corners) const;
    // With the point elsewhere: of each tetrahedron around it, in the order of the star, and the least of these.
    void qualities_with(int32_t v, const Vec3& place, Array<double>& quality) const;
    double worst_with(int32_t v, const Vec3& place) const;
    // Where the metric of the tetrahedron is the identity, up to a factor; the corners themselves if the mesh is not
    // measured.
    std::array<Vec3, 4> measured_corners(const Tet& corners) const;
    // Finds all that are not known, at a lower price than one by one.
    void find_qualities(const Run& run) const;
    double worst(const Array<int32_t>& tets) const;

    // Gives the mesh back without dead tetrahedra and points that a removal left unused; numbering keeps its order.
    LabelledMesh take(const Run& run);

private:
    struct PointMetric {
        Tensor log, metric;
    };

    PointMetric metric_at(const Vec3& x) const;
    double quality_with(int32_t t, int32_t v, const Vec3& place, const Tensor& log_there) const;
    void freeze_hull(const Run& run);
    int32_t take_slot();
    void remove_dead_slots();

    Array<Vec3> points_;
    Array<Tet> tets_;
    Array<Material> materials_;
    PointStars stars_;
    static constexpr uint8_t kAllAxes = 7, kHeld = 8, kWaits = 16, kSettled = 32;
    Array<uint8_t> frozen_;  // by point: axes, and whether it is held, waited for, settled
    Measure measure_;
    Array<PointMetric> metrics_;  // by point, if the mesh is measured
    Array<int32_t> free_slots_;
    mutable Array<double> quality_;  // of each tetrahedron since it was last asked for; kUnknown after a change
};

}  // namespace cleft
