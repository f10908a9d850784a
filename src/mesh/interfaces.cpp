// Extracts the triangles between regions and those of the hull, in an order that depends on the mesh alone.
#include "mesh/interfaces.hpp"

#include "base/ordinal.hpp"
#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/surface_points.hpp"

#include <tuple>

namespace cleft
{

namespace
{

struct InterfaceFace {
    std::array<int32_t, 2> pair;
    Triangle corners;
    std::array<int32_t, 2> tets;
    bool operator<(const InterfaceFace& o) const { return std::tie(pair, corners) < std::tie(o.pair, o.corners); }
};

struct HullFace {
    Side side;
    int32_t region;
    Triangle corners;
    int32_t tet;
    bool operator<(const HullFace& o) const
    {
        return std::tie(side, region, corners) < std::tie(o.side, o.region, o.corners);
    }
};

struct Faces {
    Array<InterfaceFace> interfaces;
    Array<HullFace> hull;
};

// The corners of a face, wound outward from its tetrahedron, the least corner first.
// So a triangle has one form, whichever of its tetrahedra names it and with whatever corner first.
Triangle outward(const RegionMesh& mesh, const HalfFace& face)
{
    Triangle t = face_points(mesh.tets, face.id);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

// The first side that all three corners lie in.
Side side_of(const RegionMesh& mesh, const Triangle& t, const BoundingBox& box)
{
    unsigned sides = 63;
    for (const int32_t p : t)
        sides &= box.sides(mesh.points[p], 0);
    int side = 0;
    while (side < static_cast<int>(Side::other) && !(sides >> side & 1))
        ++side;
    return static_cast<Side>(side);
}

void add_face(const RegionMesh& mesh, const HalfFace* face, size_t count, const BoundingBox& box, Faces& out)
{
    const auto region = [&](const HalfFace& f) { return mesh.region[f.tet()]; };
    if (count > 2)
        throw Error(CLEFT_ERROR_INVALID_MESH, std::to_string(count) +
                                                  " tetrahedra share one face, the first of them the " +
                                                  ordinal(face[0].tet()) + " tetrahedron: interfaces are not defined");
    if (count == 1) {
        const Triangle corners = outward(mesh, face[0]);
        out.hull.push_back({side_of(mesh, corners, box), region(face[0]), corners, face[0].tet()});
    } else if (region(face[0]) != region(face[1])) {
        const bool in_order = region(face[0]) < region(face[1]);
        const HalfFace& first = face[in_order ? 0 : 1];
        const HalfFace& second = face[in_order ? 1 : 0];
        out.interfaces.push_back({{region(first), region(second)}, outward(mesh, first), {first.tet(), second.tet()}});
    }
}

// Empties the parts while it joins them, so that no face is held twice for long.
template <class Face>
Array<Face> sorted_union(Array<Faces>& parts, Array<Face> Faces::*member)
{
    size_t total = 0;
    for (const Faces& part : parts)
        total += (part.*member).size();
    Array<Face> all;
    all.reserve(total);
    for (Faces& part : parts) {
        const Array<Face> faces = std::move(part.*member);
        all.insert(all.end(), faces.begin(), faces.end());
    }
    // No two faces have the same triangle on the same side. So none are equal, and the sort has one result.
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

Interfaces extract_interfaces(const RegionMesh& mesh, const Vec3& lo, const Vec3& hi, const Run& run)
{
    Steps steps(run, {{"extracting interfaces", 3}, {nullptr, 4}, {nullptr, 3}});
    const Run of_points = steps.next();
    const auto point_count = mesh.points.count();
    const BoundingBox box{lo, hi};
    // Only faces whose three corners are on the surface can be wanted. Without this, all faces inside would be sorted
    // as well.
    const Array<uint8_t> surface = surface_points(mesh, of_points);
    const FaceBuckets buckets(mesh.tets, point_count, of_points, &surface);
    Array<Faces> parts(chunk_count(point_count, FaceBuckets::kPointsAtOnce));
    parallel_chunks(
        steps.next(), point_count, FaceBuckets::kPointsAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
            Faces& part = parts[chunk];
            buckets.for_each_face(begin, end,
                                  [&](const HalfFace* face, size_t count) { add_face(mesh, face, count, box, part); });
        });
    steps.next();

    Interfaces out;
    const Array<InterfaceFace> interfaces = sorted_union(parts, &Faces::interfaces);
    out.triangles.reserve(interfaces.size());
    out.pairs.reserve(interfaces.size());
    out.tets.reserve(interfaces.size());
    for (const InterfaceFace& face : interfaces) {
        out.triangles.push_back(face.corners);
        out.pairs.push_back(face.pair);
        out.tets.push_back(face.tets);
    }
    const Array<HullFace> hull = sorted_union(parts, &Faces::hull);
    out.hull.reserve(hull.size());
    out.hull_region.reserve(hull.size());
    out.hull_side.reserve(hull.size());
    out.hull_tet.reserve(hull.size());
    for (const HullFace& face : hull) {
        out.hull.push_back(face.corners);
        out.hull_region.push_back(face.region);
        out.hull_side.push_back(face.side);
        out.hull_tet.push_back(face.tet);
    }
    return out;
}

}  // namespace cleft
