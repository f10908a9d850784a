#include "mesh/local_mesh.hpp"

#include "mesh/adjacency.hpp"
#include "mesh/quality.hpp"

#include <algorithm>

namespace cleft
{
namespace
{

size_t at(int32_t i) { return static_cast<size_t>(i); }

}  // namespace

LocalMesh::LocalMesh(std::vector<Vec3> points, std::vector<Tet> tets, std::vector<Material> material)
    : points_(std::move(points)), tets_(std::move(tets)), materials_(std::move(material))
{
    neighbours_ = tet_neighbours(tets_, static_cast<int64_t>(points_.size()));
    frozen_ = frozen_axes(points_, tets_, neighbours_);
    stamps_.assign(tets_.size(), 0);
    tet_of_point_.assign(points_.size(), -1);
    for (int32_t t = 0; t < slot_count(); ++t)
        for (const int32_t v : tet(t))
            tet_of_point_[at(v)] = t;
}

bool LocalMesh::is_boundary(int32_t t, int corner) const
{
    const int32_t n = neighbour(t, corner);
    return n < 0 || material(n) != material(t);
}

int LocalMesh::corner_of(int32_t t, int32_t v) const
{
    const Tet& corners = tet(t);
    return static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
}

uint32_t LocalMesh::next_stamp()
{
    if (++stamp_ == 0) {
        std::fill(stamps_.begin(), stamps_.end(), 0);
        stamp_ = 1;
    }
    return stamp_;
}

void LocalMesh::star(int32_t v, std::vector<int32_t>& out)
{
    out.clear();
    if (tet_of_point_[at(v)] < 0)
        return;
    const uint32_t stamp = next_stamp();
    out.push_back(tet_of_point_[at(v)]);
    stamps_[at(out[0])] = stamp;
    for (size_t i = 0; i < out.size(); ++i) {
        const int32_t t = out[i];
        for (int corner = 0; corner < 4; ++corner) {
            const int32_t n = neighbour(t, corner);
            if (n >= 0 && stamps_[at(n)] != stamp && tet(t)[at(corner)] != v) {
                stamps_[at(n)] = stamp;
                out.push_back(n);
            }
        }
    }
}

void LocalMesh::ring(int32_t t, int corner_a, int corner_b, EdgeRing& out) const
{
    out.a = tet(t)[at(corner_a)];
    out.b = tet(t)[at(corner_b)];
    const Hinge start = hinge(t, out.a, out.b);
    out.closed = walk_ring(start, out);
    if (out.closed)
        return;
    Hinge first = start;
    for (Hinge h = start; h.tet >= 0; h = backward(h, out))
        first = h;
    walk_ring(first, out);
}

// Forward until the start comes back (true) or the hull is met (false).
bool LocalMesh::walk_ring(const Hinge& first, EdgeRing& out) const
{
    out.points.clear();
    out.tets.clear();
    Hinge h = first;
    while (true) {
        out.points.push_back(h.c);
        out.tets.push_back(h.tet);
        const Hinge next = forward(h, out);
        if (next.tet == first.tet)
            return true;
        if (next.tet < 0) {
            out.points.push_back(h.d);
            return false;
        }
        h = next;
    }
}

// The corners c, d of t beside a and b, so that a, b, c, d are positively oriented.
LocalMesh::Hinge LocalMesh::hinge(int32_t t, int32_t a, int32_t b) const
{
    const int ca = corner_of(t, a), cb = corner_of(t, b);
    for (size_t e = 0; e < 6; ++e) {
        const auto& edge = kEdgeCorners[e];
        const auto& opposite = kEdgeOpposite[e];
        const Tet& v = tet(t);
        // (edge, opposite) is an even permutation of the corners for every edge but (0, 2) and (1, 3).
        const bool even = e != 1 && e != 4;
        const int32_t c = v[at(opposite[even ? 0 : 1])], d = v[at(opposite[even ? 1 : 0])];
        if (edge[0] == ca && edge[1] == cb)
            return {t, c, d};
        if (edge[0] == cb && edge[1] == ca)
            return {t, d, c};
    }
    return {-1, -1, -1};
}

LocalMesh::Hinge LocalMesh::forward(const Hinge& h, const EdgeRing& edge) const
{
    const int32_t n = neighbour(h.tet, corner_of(h.tet, h.c));
    return n < 0 ? Hinge{-1, -1, -1} : Hinge{n, h.d, apex(n, edge.a, edge.b, h.d)};
}

LocalMesh::Hinge LocalMesh::backward(const Hinge& h, const EdgeRing& edge) const
{
    const int32_t n = neighbour(h.tet, corner_of(h.tet, h.d));
    return n < 0 ? Hinge{-1, -1, -1} : Hinge{n, apex(n, edge.a, edge.b, h.c), h.c};
}

// The corner of t beside the face a, b, c.
int32_t LocalMesh::apex(int32_t t, int32_t a, int32_t b, int32_t c) const
{
    const Tet& v = tet(t);
    return v[0] ^ v[1] ^ v[2] ^ v[3] ^ a ^ b ^ c;
}

int32_t LocalMesh::add_point(const Vec3& x, uint8_t frozen)
{
    points_.push_back(x);
    frozen_.push_back(frozen);
    tet_of_point_.push_back(-1);
    return point_count() - 1;
}

void LocalMesh::replace(const std::vector<int32_t>& old_tets, const std::vector<Tet>& new_tets,
                        const std::vector<Material>& new_materials, std::vector<int32_t>& created)
{
    collect_cavity_faces(old_tets);
    for (const int32_t t : old_tets) {
        tets_[at(t)][0] = -1;
        free_slots_.push_back(t);
    }
    created.clear();
    for (size_t i = 0; i < new_tets.size(); ++i) {
        const int32_t t = take_slot();
        tets_[at(t)] = new_tets[i];
        neighbours_[at(t)] = {-1, -1, -1, -1};
        if (!materials_.empty())
            materials_[at(t)] = new_materials[i];
        created.push_back(t);
        for (int face = 0; face < 4; ++face)
            add_face_slot(t, face);
        for (const int32_t v : new_tets[i])
            tet_of_point_[at(v)] = t;
    }
    match_faces();
}

// The faces of the cavity as its outer neighbours see them. Its points are given a tetrahedron outside, if there is
// one.
void LocalMesh::collect_cavity_faces(const std::vector<int32_t>& old_tets)
{
    faces_.clear();
    const uint32_t stamp = next_stamp();
    for (const int32_t t : old_tets) {
        stamps_[at(t)] = stamp;
        for (const int32_t v : tet(t))
            tet_of_point_[at(v)] = -1;
    }
    for (const int32_t t : old_tets)
        for (int corner = 0; corner < 4; ++corner) {
            const int32_t n = neighbour(t, corner);
            if (n < 0 || stamps_[at(n)] == stamp)
                continue;
            const auto& around = neighbours_[at(n)];
            const int face = static_cast<int>(std::find(around.begin(), around.end(), t) - around.begin());
            neighbours_[at(n)][at(face)] = -1;
            add_face_slot(n, face);
            for (const int32_t v : faces_.back().corners)
                tet_of_point_[at(v)] = n;
        }
}

int32_t LocalMesh::take_slot()
{
    if (!free_slots_.empty()) {
        const int32_t t = free_slots_.back();
        free_slots_.pop_back();
        return t;
    }
    tets_.emplace_back();
    neighbours_.emplace_back();
    stamps_.push_back(0);
    if (!materials_.empty())
        materials_.push_back(0);
    return slot_count() - 1;
}

void LocalMesh::add_face_slot(int32_t t, int face)
{
    FaceSlot slot{{}, t, face};
    for (size_t k = 0; k < 3; ++k)
        slot.corners[k] = tet(t)[at(kFaceCorners[face][k])];
    std::sort(slot.corners.begin(), slot.corners.end());
    faces_.push_back(slot);
}

void LocalMesh::match_faces()
{
    std::sort(faces_.begin(), faces_.end(), [](const FaceSlot& p, const FaceSlot& q) { return p.corners < q.corners; });
    for (size_t i = 0; i + 1 < faces_.size(); ++i) {
        const FaceSlot &p = faces_[i], &q = faces_[i + 1];
        if (p.corners == q.corners) {
            neighbours_[at(p.tet)][at(p.face)] = q.tet;
            neighbours_[at(q.tet)][at(q.face)] = p.tet;
            ++i;
        }
    }
}

double LocalMesh::quality(const Tet& corners) const
{
    return least_sine(point(corners[0]), point(corners[1]), point(corners[2]), point(corners[3]));
}

double LocalMesh::quality(int32_t t) const { return quality(tet(t)); }

double LocalMesh::worst(const std::vector<int32_t>& tets) const
{
    double least = 1;
    for (const int32_t t : tets)
        least = std::min(least, quality(t));
    return least;
}

LabelledMesh LocalMesh::take()
{
    LabelledMesh mesh;
    std::vector<int32_t> number(points_.size(), -1);
    for (size_t v = 0; v < points_.size(); ++v)
        if (tet_of_point_[v] >= 0) {
            number[v] = static_cast<int32_t>(mesh.points.size());
            mesh.points.push_back(points_[v]);
        }
    size_t kept = 0;
    for (int32_t t = 0; t < slot_count(); ++t)
        if (alive(t)) {
            for (int32_t& v : tets_[at(t)])
                v = number[at(v)];
            tets_[kept] = tets_[at(t)];
            if (!materials_.empty())
                materials_[kept] = materials_[at(t)];
            ++kept;
        }
    tets_.resize(kept);
    if (!materials_.empty())
        materials_.resize(kept);
    mesh.tets = std::move(tets_);
    mesh.material = std::move(materials_);
    return mesh;
}

}  // namespace cleft
