// Flips around an edge and at a face. They keep all points, so only the shapes and the diagonals of interfaces can
// change.
#include "remeshing/flips.hpp"

#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{
namespace
{

// Longer rings hardly ever have a good triangulation.
// The work grows with the third power of the ring's length, and the table below lies on the stack.
constexpr size_t kLongestRing = 9;

// The part of a ring between two boundary faces: its points, all its tetrahedra of one material. A ring within one
// material is one arc too.
struct Arc {
    std::array<int32_t, kLongestRing> points{};
    size_t size = 0;
    Material material = 0;

    void add(int32_t v) { points[size++] = v; }
};

// Best triangulation of the polygon of an arc, seen from both ends of the edge.
class ArcTriangulation
{
public:
    // Least quality of the best triangulation; anything up to `floor` is as bad as none.
    double solve(const LocalMesh& mesh, int32_t a, int32_t b, const Arc& arc, double floor)
    {
        for (size_t i = 0; i + 1 < arc.size; ++i)
            best_[i][i + 1] = 1;
        for (size_t length = 2; length < arc.size; ++length)
            for (size_t i = 0; i + length < arc.size; ++i)
                solve_part(mesh, a, b, arc, i, i + length, floor);
        return best_[0][arc.size - 1];
    }

    void add_tets(int32_t a, int32_t b, const Arc& arc, size_t i, size_t j, Cavity& cavity) const
    {
        if (j - i < 2)
            return;
        const size_t k = middle_[i][j];
        cavity.add({arc.points[i], arc.points[k], arc.points[j], b}, arc.material);
        cavity.add({arc.points[i], arc.points[j], arc.points[k], a}, arc.material);
        add_tets(a, b, arc, i, k, cavity);
        add_tets(a, b, arc, k, j, cavity);
    }

private:
    // A part is the best triangulation of the points i to j (Klincsek). Each middle point is tried in order, and only a
    // better one replaces another, so that ties are decided alike in every run.
    void solve_part(const LocalMesh& mesh, int32_t a, int32_t b, const Arc& arc, size_t i, size_t j, double floor)
    {
        best_[i][j] = floor;
        middle_[i][j] = i + 1;
        for (size_t k = i + 1; k < j; ++k) {
            double q = std::min(best_[i][k], best_[k][j]);
            // The two qualities come last, since they cost far more than looking up both parts.
            if (q > best_[i][j])
                q = std::min(q, mesh.quality(Tet{arc.points[i], arc.points[k], arc.points[j], b}));
            if (q > best_[i][j])
                q = std::min(q, mesh.quality(Tet{arc.points[i], arc.points[j], arc.points[k], a}));
            if (q > best_[i][j]) {
                best_[i][j] = q;
                middle_[i][j] = k;
            }
        }
    }

    double best_[kLongestRing][kLongestRing];
    size_t middle_[kLongestRing][kLongestRing];
};

// Cuts a ring at its boundary faces into one arc (no boundary, or the hull at both ends) or two (an interface). False
// if more boundaries meet at the edge.
bool cut_into_arcs(const LocalMesh& mesh, const EdgeRing& ring, std::array<Arc, 2>& arcs, size_t& arc_count)
{
    const size_t n = ring.size();
    size_t cuts[2] = {0, 0}, cut_count = 0;
    for (size_t i = ring.closed ? 0 : 1; i < ring.tets.size(); ++i) {
        const int32_t before = ring.tets[i > 0 ? i - 1 : ring.tets.size() - 1];
        if (mesh.material(before) == mesh.material(ring.tets[i]))
            continue;
        if (cut_count == 2 || !ring.closed)
            return false;
        cuts[cut_count++] = i;
    }
    arc_count = cut_count == 2 ? 2 : 1;
    for (size_t k = 0; k < arc_count; ++k) {
        const size_t begin = cuts[k];
        const size_t count = arc_count == 1 ? n : (cuts[1 - k] + n - begin) % n + 1;
        arcs[k].material = mesh.material(ring.tets[begin]);
        arcs[k].size = 0;
        for (size_t i = 0; i < count; ++i)
            arcs[k].add(ring.points[(begin + i) % n]);
    }
    return true;
}

// How far the boundary moves in its middle when the diagonal a b of the two boundary triangles becomes the diagonal c
// d, in the frame of the metric.
double bend_of(const LocalMesh& mesh, int32_t a, int32_t b, int32_t c, int32_t d)
{
    const auto way = [&](int32_t from, int32_t to) {
        return mesh.measured_on_edge(a, b, mesh.point(to) - mesh.point(from));
    };
    const Vec3 normal = way(a, b).cross(way(c, d));
    return std::abs(normal.dot(way(a, c))) / std::max(normal.norm(), 1e-300);
}

// The hull must stay to the last bit, or the box of the volume is not filled any more. An interface may move by `bend`.
bool boundary_stays(const LocalMesh& mesh, const EdgeRing& ring, const std::array<Arc, 2>& arcs, size_t arc_count,
                    double bend)
{
    const int32_t c = arcs[0].points[0], d = arcs[0].points[arcs[0].size - 1];
    if (!ring.closed)  // the hull stays exactly what it is
        return orient_sign(mesh.point(ring.a), mesh.point(ring.b), mesh.point(c), mesh.point(d)) == 0;
    return arc_count == 1 || bend_of(mesh, ring.a, ring.b, c, d) <= bend;
}

// An arc of one tetrahedron leaves nothing behind. Its outer edge must lie inside its material, or a part of the
// material one tetrahedron thick would vanish and two pieces of boundary would touch.
bool lone_tets_are_backed(const LocalMesh& mesh, const EdgeRing& ring, const std::array<Arc, 2>& arcs, size_t arc_count,
                          EdgeRing& scratch)
{
    if (ring.closed && arc_count == 1)
        return true;
    for (size_t k = 0; k < arc_count; ++k) {
        CLEFT_ASSERT(arcs[k].size >= 2);
        if (arcs[k].size > 2)
            continue;
        const auto first = std::find(ring.points.begin(), ring.points.end(), arcs[k].points[0]) - ring.points.begin();
        const int32_t t = ring.tets[first];
        mesh.ring(t, mesh.corner_of(t, arcs[k].points[0]), mesh.corner_of(t, arcs[k].points[1]), scratch);
        if (!scratch.closed)
            return false;
        for (const int32_t s : scratch.tets)
            if (mesh.material(s) != arcs[k].material)
                return false;
    }
    return true;
}

}  // namespace

bool find_edge_removal(const LocalMesh& mesh, int32_t t, int corner_a, int corner_b, double bend, Cavity& cavity,
                       double share)
{
    EdgeRing& ring = cavity.ring;
    mesh.ring(t, corner_a, corner_b, ring);
    std::array<Arc, 2> arcs;
    size_t arc_count = 0;
    if (!ring.whole || ring.size() > kLongestRing || !cut_into_arcs(mesh, ring, arcs, arc_count) ||
        !boundary_stays(mesh, ring, arcs, arc_count, bend) ||
        !lone_tets_are_backed(mesh, ring, arcs, arc_count, cavity.other_ring))
        return false;
    // Triangulations that are no better than the ring are cut off inside the search.
    const double floor = std::max(share * mesh.worst(ring.tets), kLeastSine);
    std::array<ArcTriangulation, 2> triangulations;
    for (size_t k = 0; k < arc_count; ++k)
        if (triangulations[k].solve(mesh, ring.a, ring.b, arcs[k], floor) <= floor)
            return false;
    cavity.clear();
    cavity.old_tets = ring.tets;
    for (size_t k = 0; k < arc_count; ++k)
        triangulations[k].add_tets(ring.a, ring.b, arcs[k], 0, arcs[k].size - 1, cavity);
    return true;
}

std::array<size_t, 6> most_obtuse_first(const LocalMesh& mesh, int32_t t)
{
    const auto x = mesh.measured_corners(mesh.tet(t));
    const auto angles = dihedral_angles(x[0], x[1], x[2], x[3]);
    std::array<size_t, 6> edges{0, 1, 2, 3, 4, 5};
    // Equal angles keep the order of their edges, which std::sort does not promise.
    std::stable_sort(edges.begin(), edges.end(), [&](size_t e, size_t f) { return angles[e] > angles[f]; });
    return edges;
}

bool find_face_removal(const LocalMesh& mesh, int32_t t, int corner, Cavity& cavity, double share)
{
    if (mesh.is_boundary(t, corner))
        return false;
    const int32_t n = mesh.neighbour(t, corner);
    CLEFT_ASSERT(n >= 0);
    const Tet& v = mesh.tet(t);
    const int32_t a = v[corner];
    const int32_t x = v[kFaceCorners[corner][0]], y = v[kFaceCorners[corner][1]], z = v[kFaceCorners[corner][2]];
    const Tet& w = mesh.tet(n);
    // The exclusive or leaves the one corner of the neighbour that is not in the face.
    const int32_t b = w[0] ^ w[1] ^ w[2] ^ w[3] ^ x ^ y ^ z;
    CLEFT_ASSERT(b != a && has_corner(w, b));
    const double old_worst = std::max(share * std::min(mesh.quality(t), mesh.quality(n)), kLeastSine);
    const std::array<Tet, 3> made{Tet{a, b, x, y}, Tet{a, b, y, z}, Tet{a, b, z, x}};
    for (const Tet& tet : made)
        if (mesh.quality(tet) <= old_worst)
            return false;
    cavity.clear();
    cavity.old_tets.assign({t, n});
    for (const Tet& tet : made)
        cavity.add(tet, mesh.material(t));
    return true;
}

}  // namespace cleft
