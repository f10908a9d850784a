// Checks the faces of a mesh: how many tetrahedra share each, on which sides they lie, and where hull and interfaces
// end.
#include "checking/check_faces.hpp"

#include "base/parallel.hpp"
#include "mesh/face_buckets.hpp"

#include <initializer_list>

namespace cleft
{

namespace
{

// Rounding to single precision, as in many files, moves a coordinate by up to 6e-8 of its size. A greater tolerance
// would take a face just inside the box for one of its sides.
constexpr double kSideTolerance = 1e-6;  // of the longest side of the box

// A mesh with what the checks of its faces need.
struct Subject {
    const RegionMesh& mesh;
    const BoundingBox& box;
    const Array<Sign>& sign;
    const Placement& world;
    double tolerance;

    const Vec3& point(int32_t p) const { return mesh.points[p]; }
    // Without a region for each tetrahedron the mesh counts as one region; validate() reports a wrong number of them.
    bool same_region(const HalfFace& a, const HalfFace& b) const
    {
        return mesh.region.size() != mesh.tets.size() || mesh.region[a.tet()] == mesh.region[b.tet()];
    }
    bool in_one_side(std::initializer_list<int32_t> points) const
    {
        unsigned sides = ~0u;
        for (const int32_t p : points)
            sides &= box.sides(point(p), tolerance);
        return sides != 0;
    }
};

struct FacesPart {
    FaceChecks checks;
    // The faces of both kinds are kept, since open edges can only be found when all faces are known.
    Array<uint32_t> ragged;      // faces of one tetrahedron or of more than two
    Array<uint32_t> interfaces;  // faces between two materials
};

// The side of a face, seen with its points in ascending order, on which its tetrahedron lies: 1, -1, or 0 if unknown.
int side_of_face(const Subject& s, const HalfFace& face)
{
    const Sign sign = s.sign[face.tet()];
    if (sign == Sign::unknown)
        return 0;
    const auto [a, b, c] = face_points(s.mesh.tets, face.id);
    // Each swap of two points turns the normal of the triangle around.
    const bool odd = ((a > b) + (a > c) + (b > c)) % 2 == 1;
    return odd ? -static_cast<int>(sign) : static_cast<int>(sign);
}

void check_hull_face(const Subject& s, const HalfFace& face, FacesPart& part)
{
    part.checks.hull.add(face.id);
    part.ragged.push_back(face.id);
    if (s.sign[face.tet()] == Sign::unknown)
        return;
    const auto [a, b, c] = face_points(s.mesh.tets, face.id);
    part.checks.hull_area += s.world.area(s.point(b) - s.point(a), s.point(c) - s.point(a)) / 2;
    if (!s.in_one_side({a, b, c}))
        part.checks.off_box.add(face.id);
}

void check_shared_face(const Subject& s, const HalfFace& first, const HalfFace& second, FacesPart& part)
{
    part.checks.shared.add(first.id);
    // A flat or unknown tetrahedron gives 0 and is no fault here, since it has a count of its own.
    if (side_of_face(s, first) * side_of_face(s, second) > 0)
        part.checks.folded.add(first.id);
    if (!s.same_region(first, second)) {
        part.checks.interfaces.add(first.id);
        part.interfaces.push_back(first.id);
    }
}

void check_face(const Subject& s, const HalfFace* face, size_t count, FacesPart& part)
{
    if (count == 1) {
        check_hull_face(s, face[0], part);
    } else if (count == 2) {
        check_shared_face(s, face[0], face[1], part);
    } else {
        part.checks.crowded.add(face[0].id);
        part.ragged.push_back(face[0].id);
    }
}

void append(FacesPart& whole, FacesPart&& part)
{
    whole.checks.hull.append(part.checks.hull);
    whole.checks.shared.append(part.checks.shared);
    whole.checks.crowded.append(part.checks.crowded);
    whole.checks.folded.append(part.checks.folded);
    whole.checks.off_box.append(part.checks.off_box);
    whole.checks.interfaces.append(part.checks.interfaces);
    whole.checks.hull_area += part.checks.hull_area;
    whole.ragged.insert(whole.ragged.end(), part.ragged.begin(), part.ragged.end());
    whole.interfaces.insert(whole.interfaces.end(), part.interfaces.begin(), part.interfaces.end());
    part = FacesPart();
}

FacesPart check_all_faces(const Subject& s, const Run& run)
{
    const auto point_count = s.mesh.points.count();
    const FaceBuckets buckets(s.mesh.tets, point_count, run);
    Array<FacesPart> parts(chunk_count(point_count, FaceBuckets::kPointsAtOnce));
    parallel_chunks(run, point_count, FaceBuckets::kPointsAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
        FacesPart& part = parts[chunk];
        buckets.for_each_face(begin, end,
                              [&](const HalfFace* face, size_t count) { check_face(s, face, count, part); });
    });
    // In the order of the chunks, so that the first place and the sum of areas do not depend on the number of threads.
    FacesPart whole;
    for (FacesPart& part : parts)
        append(whole, std::move(part));
    return whole;
}

// Around an edge whose faces all have two tetrahedra the material changes never or at least twice. So only edges
// between points of other faces, or of a tetrahedron that names a point twice, can have a single interface face.
Array<char> points_of_open_edges(const Subject& s, const Array<uint32_t>& ragged)
{
    const auto point_count = s.mesh.points.count();
    Array<char> marked(s.mesh.points.size(), 0);
    for (const uint32_t id : ragged)
        for (const int32_t p : face_points(s.mesh.tets, id))
            marked[p] = 1;
    for (const Tet& tet : s.mesh.tets)
        if (has_repeated_corner(tet) && !has_bad_index(tet, point_count))
            for (const int32_t p : tet)
                marked[p] = 1;
    return marked;
}

Tally find_open_edges(const Subject& s, const FacesPart& faces)
{
    const Array<char> marked = points_of_open_edges(s, faces.ragged);
    Array<int64_t> edges;
    for (const uint32_t id : faces.interfaces) {
        const std::array<int32_t, 3> face = face_points(s.mesh.tets, id);
        for (size_t k = 0; k < 3; ++k) {
            const int32_t a = std::min(face[k], face[(k + 1) % 3]);
            const int32_t b = std::max(face[k], face[(k + 1) % 3]);
            // In a side of the box an interface ends by right.
            if (marked[a] && marked[b] && !s.in_one_side({a, b}))
                edges.push_back(int64_t{a} << 32 | b);
        }
    }
    // Sorting puts equal edges together and finds the least open one first, in whatever order the faces came.
    std::sort(edges.begin(), edges.end());
    Tally open;
    for (size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last] == edges[first])
            ++last;
        if (last - first == 1)
            open.add(edges[first]);
    }
    return open;
}

}  // namespace

FaceChecks check_faces(const RegionMesh& mesh, const BoundingBox& box, const Array<Sign>& sign, const Placement& world,
                       const Run& run)
{
    const Subject subject{mesh, box, sign, world, kSideTolerance * box.longest()};
    const FacesPart faces = check_all_faces(subject, run);
    FaceChecks out = faces.checks;
    out.open_edges = find_open_edges(subject, faces);
    return out;
}

}  // namespace cleft
