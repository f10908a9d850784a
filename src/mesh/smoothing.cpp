#include "mesh/smoothing.hpp"

#include "mesh/adjacency.hpp"
#include "mesh/cavity.hpp"
#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{
namespace
{

constexpr int kSteps = 4;         // directions tried for a point
constexpr int kHalvings = 4;      // trial lengths for a direction
constexpr double kActive = 0.03;  // tetrahedra this near to the worst are improved together
constexpr double kLeastGain = 1e-4;
constexpr double kExploredRadii[] = {0.25, 0.1, 0.04};
constexpr double kLeastSlope = 1e-3;  // gain of quality for a typical edge length

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

Mat3 free_axes(uint8_t frozen)
{
    Mat3 projector = Mat3::Identity();
    for (int axis = 0; axis < 3; ++axis)
        if (frozen >> axis & 1)
            projector(axis, axis) = 0;
    return projector;
}

void Star::load(const LocalMesh& mesh, int32_t v)
{
    tets_.assign(mesh.star(v).begin(), mesh.star(v).end());
    opposite_.clear();
    for (const int32_t t : tets_)
        add(mesh, mesh.tet(t), mesh.corner_of(t, v));
}

// Each tetrahedron of the ring is split in two: the new point takes the place of either end.
void Star::load(const LocalMesh& mesh, const EdgeRing& ring)
{
    tets_ = ring.tets;
    opposite_.clear();
    for (const int32_t t : tets_) {
        add(mesh, mesh.tet(t), mesh.corner_of(t, ring.a));
        add(mesh, mesh.tet(t), mesh.corner_of(t, ring.b));
    }
}

void Star::add(const LocalMesh& mesh, const Tet& tet, int corner)
{
    const auto& face = kFaceCorners[corner];
    opposite_.push_back({mesh.point(tet[at(face[0])]), mesh.point(tet[at(face[1])]), mesh.point(tet[at(face[2])])});
}

double Star::reach(const Vec3& x) const
{
    double sum = 0;
    for (const auto& o : opposite_)
        sum += (o[0] - x).norm();
    return sum / static_cast<double>(opposite_.size());
}

Vec3 Star::centroid(const Vec3& x) const
{
    Vec3 sum(0, 0, 0);
    for (const auto& o : opposite_)
        sum += o[0] + o[1] + o[2];
    return 0.25 * (x + sum / static_cast<double>(opposite_.size()));
}

double Star::worst_at(const Vec3& x, double floor) const
{
    double worst = 1;
    for (const auto& o : opposite_) {
        worst = std::min(worst, angle_quality(x, o[0], o[1], o[2]));
        if (worst <= floor)
            return worst;
    }
    return worst;
}

void Star::gradients_at(const Vec3& x, std::vector<double>& quality, std::vector<Vec3>& gradient) const
{
    quality.clear();
    gradient.clear();
    for (const auto& o : opposite_) {
        const QualityGradient q = quality_gradient(x, o[0], o[1], o[2]);
        quality.push_back(q.value);
        gradient.push_back(q.gradient);
    }
}

// The shortest vector in the convex hull of the active gradients improves all of them (Gilbert's iteration).
Vec3 Smoother::ascent_direction(double worst) const
{
    Vec3 shortest(0, 0, 0);
    bool any = false;
    for (size_t i = 0; i < quality_.size() && !any; ++i)
        if (quality_[i] <= worst) {
            shortest = gradient_[i];
            any = true;
        }
    for (int iteration = 0; iteration < 20; ++iteration) {
        size_t extreme = quality_.size();
        double least = shortest.squaredNorm() * (1 - 1e-2);
        for (size_t i = 0; i < quality_.size(); ++i)
            if (quality_[i] <= worst + kActive && gradient_[i].dot(shortest) < least) {
                least = gradient_[i].dot(shortest);
                extreme = i;
            }
        if (extreme == quality_.size())
            break;
        const Vec3 towards = gradient_[extreme] - shortest;
        const double t = -shortest.dot(towards) / towards.squaredNorm();
        shortest += std::clamp(t, 0.0, 1.0) * towards;
    }
    return shortest;
}

// The length at which, to first order, a tetrahedron that is now better becomes the worst.
double Smoother::first_step(const Vec3& direction, double worst, double reach) const
{
    const double rate = direction.squaredNorm();
    double length = 0.5 * reach / std::sqrt(rate);
    for (size_t i = 0; i < quality_.size(); ++i) {
        const double relative = rate - gradient_[i].dot(direction);
        if (quality_[i] > worst + kActive && relative > 0)
            length = std::min(length, (quality_[i] - worst) / relative);
    }
    return length;
}

bool Smoother::step(const Star& star, Place& place, const Mat3& tangent, const Projection& projection)
{
    star.gradients_at(place.x, quality_, gradient_);
    for (Vec3& g : gradient_)
        g = tangent * g;
    place.worst = *std::min_element(quality_.begin(), quality_.end());
    const Vec3 direction = ascent_direction(place.worst);
    const double reach = star.reach(place.x);
    if (!(direction.norm() * reach > kLeastSlope))
        return false;
    double length = first_step(direction, place.worst, reach);
    const double wanted = std::max(place.worst + kLeastGain, kLeastSine);
    for (int halving = 0; halving < kHalvings; ++halving, length *= 0.5) {
        Vec3 trial = place.x + length * direction;
        if (projection && !projection(trial))
            continue;
        const double worst = star.worst_at(trial, wanted);
        if (worst > wanted) {
            place = {trial, worst};
            return true;
        }
    }
    return false;
}

Place Smoother::explore(const Star& star, const Vec3& x, const Mat3& tangent, const Projection& projection) const
{
    Place best{x, std::max(star.worst_at(x, -1), kLeastSine)};
    const double reach = star.reach(x);
    for (const double radius : kExploredRadii)
        for (int code = 0; code < 27; ++code) {
            const Vec3 along(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
            const Vec3 shift = tangent * along;
            if (shift.norm() < 0.1 * along.norm() || code == 13)
                continue;
            Vec3 trial = x + radius * reach * shift.normalized();
            if (projection && !projection(trial))
                continue;
            const double worst = star.worst_at(trial, best.worst);
            if (worst > best.worst + kLeastGain)
                best = {trial, worst};
        }
    return best;
}

Place Smoother::climb(const Star& star, const Vec3& x, double target, const Mat3& tangent, const Projection& projection)
{
    Place place{x, -1};
    for (int i = 0; i < kSteps && place.worst < target; ++i)
        if (!step(star, place, tangent, projection))
            break;
    return place;
}

}  // namespace cleft
