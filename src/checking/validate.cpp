// Puts the checks of points, tetrahedra and faces together, and words the first fault for the user.
#include "checking/validate.hpp"

#include "base/counted.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "base/stage.hpp"
#include "checking/check_faces.hpp"
#include "checking/check_points.hpp"
#include "mesh/face_buckets.hpp"

namespace cleft
{

namespace
{

// Rounding stays below it in sums over millions of tetrahedra. A hole too small to show here still has faces off the
// box.
constexpr double kSameMeasure = 1e-9;  // relative, of volumes and areas

std::string text(const Vec3& x) { return "(" + text_of(x[0]) + ", " + text_of(x[1]) + ", " + text_of(x[2]) + ")"; }

// Names the parts of a mesh with their places.
class Naming
{
public:
    Naming(const RegionMesh& mesh, const Placement& world) : mesh_(mesh), world_(world) {}

    std::string tet(int64_t t) const
    {
        const Tet& c = mesh_.tets[t];
        // Divided before the sum, which may overflow for finite points.
        return "the " + ordinal(t) + " tetrahedron at " +
               text(at(c[0]) / 4 + at(c[1]) / 4 + at(c[2]) / 4 + at(c[3]) / 4);
    }
    std::string face(int64_t half_face) const
    {
        const auto [a, b, c] = face_points(mesh_.tets, static_cast<uint32_t>(half_face));
        return "the face of the " + ordinal(a) + ", the " + ordinal(b) + " and the " + ordinal(c) + " point at " +
               text(at(a) / 3 + at(b) / 3 + at(c) / 3) + " of the " + ordinal(half_face >> 2) + " tetrahedron";
    }
    std::string edge(int64_t points) const
    {
        const auto a = static_cast<int32_t>(points >> 32);
        const auto b = static_cast<int32_t>(points & INT32_MAX);
        return "the edge of the " + ordinal(a) + " and the " + ordinal(b) + " point at " + text(at(a) / 2 + at(b) / 2);
    }
    std::string point(int64_t p) const { return "the " + ordinal(p) + " point at " + text(at(p)); }

private:
    Vec3 at(int64_t p) const { return world_.to_world(mesh_.points[p]); }
    const RegionMesh& mesh_;
    const Placement& world_;
};

// Causes before their effects: a bad index explains a hole, a repeated point explains a crack.
std::string first_fault(const RegionMesh& mesh, const Placement& world, const PointChecks& points,
                        const TetChecks& tets, const FaceChecks& faces)
{
    const Naming name(mesh, world);
    if (mesh.tets.empty())
        return "the mesh has no tetrahedra";
    if (!mesh.region.empty() && mesh.region.size() != mesh.tets.size())
        return "the mesh has " + counted(static_cast<int64_t>(mesh.tets.size()), "tetrahedron", "tetrahedra") +
               ", but a material for " + std::to_string(mesh.region.size());
    if (tets.bad_index.count)
        return "the " + ordinal(tets.bad_index.first) + " tetrahedron names a point that is not among the " +
               counted(static_cast<int64_t>(mesh.points.size()), "point") + " of the mesh";
    if (tets.repeated_corner.count)
        return name.tet(tets.repeated_corner.first) + " names a point twice";
    if (points.non_finite.count)
        return name.point(points.non_finite.first) + " is not finite";
    if (points.repeated.count)
        return name.point(points.repeated.first) + " is at the place of the " + ordinal(points.repeated_of);
    if (tets.negative.count)
        return name.tet(tets.negative.first) + " is inverted";
    if (tets.flat.count)
        return name.tet(tets.flat.first) + " is flat";
    if (faces.crowded.count)
        return name.face(faces.crowded.first) + " belongs to more than two tetrahedra";
    if (faces.folded.count)
        return name.face(faces.folded.first) + " has both its tetrahedra on one side";
    if (points.unused.count)
        return name.point(points.unused.first) + " is in no tetrahedron";
    return "";
}

// Negated, so that a measure that is no number differs too.
bool differ(double a, double b) { return !(std::abs(a - b) <= kSameMeasure * std::abs(b)); }

std::string first_box_fault(const RegionMesh& mesh, const Placement& world, const FaceChecks& faces,
                            const Validation& v)
{
    const Naming name(mesh, world);
    // Faces first: they have a place, which a wrong volume has not.
    if (faces.off_box.count)
        return name.face(faces.off_box.first) + " has nothing behind it and is in no side of the bounding box";
    if (faces.open_edges.count)
        return "an interface ends inside the box at " + name.edge(faces.open_edges.first);
    if (differ(v.volume, v.box_volume))
        return "the tetrahedra have a volume of " + text_of(v.volume) + ", but their bounding box has " +
               text_of(v.box_volume);
    if (differ(v.hull_area, v.box_area))
        return "the hull has an area of " + text_of(v.hull_area) + ", but the bounding box has " + text_of(v.box_area);
    return "";
}

}  // namespace

Validation validate(const RegionMesh& mesh, bool fills_box, const Run& run, const Placement& world)
{
    Steps steps(run, {{"validating", 2}, {nullptr, 2}, {nullptr, 6}});
    steps.next();
    const PointChecks points = check_points(mesh);
    const TetChecks tets = check_tets(mesh, steps.next());
    const FaceChecks faces = check_faces(mesh, points.box, tets.sign, world, steps.next());

    Validation out;
    out.bad_index = tets.bad_index.count;
    out.repeated_corner = tets.repeated_corner.count;
    out.negative = tets.negative.count;
    out.flat = tets.flat.count;
    out.hull_faces = faces.hull.count;
    out.shared_faces = faces.shared.count;
    out.crowded_faces = faces.crowded.count;
    out.folded_faces = faces.folded.count;
    out.hull_off_box = faces.off_box.count;
    out.interface_faces = faces.interfaces.count;
    out.open_interface_edges = faces.open_edges.count;
    out.non_finite = points.non_finite.count;
    out.unused_points = points.unused.count;
    out.repeated_points = points.repeated.count;
    out.volume = world.volume(tets.volume);
    out.box_volume = world.volume(points.box.volume());
    out.hull_area = faces.hull_area;
    out.box_area = points.box.area(world);
    out.first_fault = first_fault(mesh, world, points, tets, faces);
    // A fault of the mesh itself comes first, since it often makes the mesh miss its box as well.
    if (out.first_fault.empty() && fills_box)
        out.first_fault = first_box_fault(mesh, world, faces, out);
    return out;
}

}  // namespace cleft
