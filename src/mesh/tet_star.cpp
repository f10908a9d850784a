#include "mesh/tet_star.hpp"

#include "base/wide_vectors.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/angle_quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{
namespace
{

size_t at(int32_t i) { return static_cast<size_t>(i); }

// The sine of the dihedral angle at the edge between two corners is
//   s = D |e| / (|n| |m|),  D = det[b-a, c-a, d-a], n and m the doubled normals of the two faces at the edge,
// so the quality and its gradient come from one edge, the worst.
struct QualityGradient {
    double value = 0;
    Vec3 gradient{0, 0, 0};  // with respect to corner 0
};

QualityGradient quality_gradient(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3)
{
    const Vec3* p[4] = {&p0, &p1, &p2, &p3};
    Vec3 normal[4];
    double normal2[4];
    for (size_t f = 0; f < 4; ++f) {
        const auto& k = kFaceCorners[f];
        normal[f] = (*p[k[1]] - *p[k[0]]).cross(*p[k[2]] - *p[k[0]]);
        normal2[f] = normal[f].squaredNorm();
    }
    const double det = orient(p0, p1, p2, p3);
    double least = 0;
    size_t worst = 6;
    for (size_t e = 0; e < 6; ++e) {
        const double length2 = (*p[kEdgeCorners[e][1]] - *p[kEdgeCorners[e][0]]).squaredNorm();
        const int* faces = kEdgeOpposite[e];
        const bool obtuse = normal[faces[0]].dot(normal[faces[1]]) > 0;
        const double weight = obtuse ? kObtuseWeight * kObtuseWeight : 1;
        const double square = weight * length2 / (normal2[faces[0]] * normal2[faces[1]]);
        if (worst == 6 || square < least) {
            least = square;
            worst = e;
        }
    }
    QualityGradient result;
    result.value = det * std::sqrt(least);
    // Logarithmic derivatives; only terms with corner 0 count.
    Vec3 log_gradient = -normal[0] / det;
    if (kEdgeCorners[worst][0] == 0) {
        const Vec3 e = p0 - *p[kEdgeCorners[worst][1]];
        log_gradient += e / e.squaredNorm();
    }
    for (const int face : kEdgeOpposite[worst]) {
        if (face == 0)
            continue;
        // Corners of the face after corner 0, in its winding: n = (b - p0) x (c - p0), d|n|^2 = 2 d . ((b - c) x n).
        const auto& k = kFaceCorners[face];
        const int first = k[0] == 0 ? 0 : k[1] == 0 ? 1 : 2;
        const Vec3& b = *p[k[(first + 1) % 3]];
        const Vec3& c = *p[k[(first + 2) % 3]];
        log_gradient -= (b - c).cross(normal[face]) / normal2[face];
    }
    result.gradient = result.value * log_gradient;
    return result;
}

}  // namespace

void TetStar::load(const LocalMesh& mesh, int32_t v)
{
    begin(mesh.star(v).size());
    tets_.assign(mesh.star(v).begin(), mesh.star(v).end());
    for (const int32_t t : tets_)
        add(mesh, mesh.tet(t), mesh.corner_of(t, v));
    fill_last();
}

// Each tetrahedron of the ring is split in two: the new point takes the place of either end.
void TetStar::load(const LocalMesh& mesh, const EdgeRing& ring)
{
    begin(2 * ring.tets.size());
    tets_ = ring.tets;
    for (const int32_t t : tets_) {
        add(mesh, mesh.tet(t), mesh.corner_of(t, ring.a));
        add(mesh, mesh.tet(t), mesh.corner_of(t, ring.b));
    }
    fill_last();
}

void TetStar::begin(size_t capacity)
{
    lanes_.resize((capacity + kLanes - 1) / kLanes);
    size_ = 0;
}

void TetStar::add(const LocalMesh& mesh, const Tet& tet, int corner)
{
    Lanes& lanes = lanes_[size_ / kLanes];
    for (size_t c = 0; c < 3; ++c) {
        const Vec3& x = mesh.point(tet[at(kFaceCorners[corner][c])]);
        for (size_t axis = 0; axis < 3; ++axis)
            lanes.corner[c][axis][size_ % kLanes] = x[static_cast<int>(axis)];
    }
    ++size_;
}

void TetStar::fill_last()
{
    for (size_t lane = size_ % kLanes; lane != 0 && lane < kLanes; ++lane)
        for (auto& corner : lanes_.back().corner)
            for (auto& axis : corner)
                axis[lane] = axis[0];
}

double TetStar::reach(const Vec3& x) const
{
    double sum = 0;
    for (size_t i = 0; i < size_; ++i)
        sum += (opposite(i, 0) - x).norm();
    return sum / static_cast<double>(size_);
}

Vec3 TetStar::centroid(const Vec3& x) const
{
    Vec3 sum(0, 0, 0);
    for (size_t i = 0; i < size_; ++i)
        sum += opposite(i, 0) + opposite(i, 1) + opposite(i, 2);
    return 0.25 * (x + sum / static_cast<double>(size_));
}

// Nearly all the time of smoothing is spent here.
CLEFT_WIDE_VECTORS double TetStar::worst_of(const Lanes& lanes, const Vec3& x)
{
    const auto& [b, c, d] = lanes.corner;
    const Triple a{x.x(), x.y(), x.z()};
    double quality[kLanes];
    for (size_t i = 0; i < kLanes; ++i)
        quality[i] =
            angle_quality(a, {b[0][i], b[1][i], b[2][i]}, {c[0][i], c[1][i], c[2][i]}, {d[0][i], d[1][i], d[2][i]});
    return *std::min_element(quality, quality + kLanes);
}

double TetStar::worst_at(const Vec3& x, double floor) const
{
    double worst = 1;
    for (const Lanes& lanes : lanes_) {
        worst = std::min(worst, worst_of(lanes, x));
        if (worst <= floor)
            return worst;
    }
    return worst;
}

void TetStar::gradients_at(const Vec3& x, std::vector<double>& quality, std::vector<Vec3>& gradient) const
{
    quality.clear();
    gradient.clear();
    for (size_t i = 0; i < size_; ++i) {
        const QualityGradient q = quality_gradient(x, opposite(i, 0), opposite(i, 1), opposite(i, 2));
        quality.push_back(q.value);
        gradient.push_back(q.gradient);
    }
}

}  // namespace cleft
