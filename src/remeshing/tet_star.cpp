// Copies a star into blocks of four tetrahedra, whose qualities are found with vector instructions.
#include "remeshing/tet_star.hpp"

#include "base/wide_vectors.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/shape_quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{
void TetStar::load(const LocalMesh& mesh, int32_t v)
{
    begin(mesh.star(v).size());
    if (mesh.is_measured()) {
        origin_ = mesh.point(v);
        measure_by(mesh.log_metric(v));
        measured_ = &mesh;
        point_ = v;
    }
    tets_.assign(mesh.star(v).begin(), mesh.star(v).end());
    for (const int32_t t : tets_)
        add(mesh, mesh.tet(t), mesh.corner_of(t, v));
    fill_last();
}

// Each tetrahedron of the ring is split in two: the new point takes the place of either end.
void TetStar::load(const LocalMesh& mesh, const EdgeRing& ring)
{
    begin(2 * ring.tets.count());
    if (mesh.is_measured()) {
        origin_ = 0.5 * (mesh.point(ring.a) + mesh.point(ring.b));
        measure_by(0.5 * (mesh.log_metric(ring.a) + mesh.log_metric(ring.b)));
    }
    tets_ = ring.tets;
    for (const int32_t t : tets_) {
        add(mesh, mesh.tet(t), mesh.corner_of(t, ring.a));
        add(mesh, mesh.tet(t), mesh.corner_of(t, ring.b));
    }
    fill_last();
}

void TetStar::begin(int64_t capacity)
{
    lanes_.resize((to_size(capacity) + kLanes - 1) / kLanes);
    size_ = 0;
    maps_ = false;
    measured_ = nullptr;
}

void TetStar::measure_by(const Tensor& log_metric)
{
    maps_ = true;
    to_frame_ = unit_exp(0.5 * log_metric);
    from_frame_ = unit_exp(-0.5 * log_metric);
}

// A plane goes to a plane, and a line to a line.
Mat3 TetStar::tangent_in_frame(const Mat3& tangent) const
{
    const double rank = tangent.trace();
    if (!maps_ || rank < 0.5 || rank > 2.5)
        return tangent;
    const Mat3 rest = rank > 1.5 ? Mat3(Mat3::Identity() - tangent) : tangent;
    int greatest;
    rest.colwise().squaredNorm().maxCoeff(&greatest);
    const Vec3 along = rest.col(greatest);
    const Vec3 mapped = (rank > 1.5 ? from_frame_ * along : to_frame_ * along).normalized();
    const Mat3 onto = mapped * mapped.transpose();
    return rank > 1.5 ? Mat3(Mat3::Identity() - onto) : onto;
}

void TetStar::add(const LocalMesh& mesh, const Tet& tet, int corner)
{
    CLEFT_ASSERT(corner < 4);  // the point, or the end of the edge, is a corner
    Lanes& lanes = lanes_[size_ / kLanes];
    for (size_t c = 0; c < 3; ++c) {
        const Vec3 x = in_frame(mesh.point(tet[kFaceCorners[corner][c]]));
        for (size_t axis = 0; axis < 3; ++axis)
            lanes.corner[c][axis][size_ % kLanes] = x[static_cast<int>(axis)];
    }
    ++size_;
}

// The block is filled up with copies of one of its tetrahedra, which do not change the worst quality.
void TetStar::fill_last()
{
    for (size_t lane = size_ % kLanes; lane != 0 && lane < kLanes; ++lane)
        for (auto& corner : lanes_.back().corner)
            for (auto& axis : corner)
                axis[lane] = axis[0];
}

double TetStar::reach(const Vec3& x) const
{
    // One corner of each tetrahedron is enough for a typical length.
    double sum = 0;
    const Vec3 centre = in_frame(x);
    for (size_t i = 0; i < size_; ++i)
        sum += (opposite(i, 0) - centre).norm();
    return sum / static_cast<double>(size_);
}

Vec3 TetStar::centroid(const Vec3& x) const
{
    Vec3 sum(0, 0, 0);
    for (size_t i = 0; i < size_; ++i)
        sum += opposite(i, 0) + opposite(i, 1) + opposite(i, 2);
    const Vec3 mean = sum / static_cast<double>(size_);
    return 0.25 * (x + (maps_ ? Vec3(3 * origin_ + from_frame_ * mean) : mean));
}

// Nearly all the time of smoothing is spent here.
CLEFT_WIDE_VECTORS double TetStar::worst_of(const Lanes& lanes, const Vec3& x)
{
    const auto& [b, c, d] = lanes.corner;
    const Triple a{x.x(), x.y(), x.z()};
    double quality[kLanes];
    for (size_t i = 0; i < kLanes; ++i)
        quality[i] =
            shape_quality(a, {b[0][i], b[1][i], b[2][i]}, {c[0][i], c[1][i], c[2][i]}, {d[0][i], d[1][i], d[2][i]});
    return *std::min_element(quality, quality + kLanes);
}

double TetStar::worst_at(const Vec3& x, double floor) const
{
    // The metric hardly changes from a tetrahedron to the next: what is far below the floor in the one frame is so in
    // any. A metric for each takes some ten times as long.
    constexpr double kFarBelow = 0.7;
    if (!measured_)
        return worst_in_frame(x, floor);
    const double rough = worst_in_frame(x, kFarBelow * floor);
    return rough <= kFarBelow * floor ? rough : measured_->worst_with(point_, x);
}

double TetStar::worst_in_frame(const Vec3& x, double floor) const
{
    double worst = 1;
    const Vec3 centre = in_frame(x);
    for (const Lanes& lanes : lanes_) {
        worst = std::min(worst, worst_of(lanes, centre));
        // Most trial places are refused, so stopping early saves the greater part of the work.
        if (worst <= floor)
            return worst;
    }
    return worst;
}

// The gradients are those of the angles.
CLEFT_WIDE_VECTORS void TetStar::find_angle_gradients(const Lanes& lanes, const Vec3& x, Gradients& out)
{
    const auto& [b, c, d] = lanes.corner;
    const Triple a{x.x(), x.y(), x.z()};
    for (size_t i = 0; i < kLanes; ++i) {
        const Triple others[3] = {
            {b[0][i], b[1][i], b[2][i]}, {c[0][i], c[1][i], c[2][i]}, {d[0][i], d[1][i], d[2][i]}};
        const ShapeQuality found = angle_quality_gradient(a, others[0], others[1], others[2]);
        out.quality[i] = shape_quality(a, others[0], others[1], others[2]);
        out.by_angle[i] = found.value;
        out.gradient[0][i] = found.gradient.x;
        out.gradient[1][i] = found.gradient.y;
        out.gradient[2][i] = found.gradient.z;
    }
}

void TetStar::find_gradients(const Lanes& lanes, const Vec3& x, Gradients& out)
{
    find_angle_gradients(lanes, x, out);
    const auto& [b, c, d] = lanes.corner;
    for (size_t i = 0; i < kLanes; ++i) {
        if (!(out.quality[i] < out.by_angle[i]))
            continue;
        const Triple gradient =
            ratio_quality_gradient({x.x(), x.y(), x.z()}, {b[0][i], b[1][i], b[2][i]}, {c[0][i], c[1][i], c[2][i]},
                                   {d[0][i], d[1][i], d[2][i]}, out.quality[i]);
        out.gradient[0][i] = gradient.x;
        out.gradient[1][i] = gradient.y;
        out.gradient[2][i] = gradient.z;
    }
}

void TetStar::gradients_at(const Vec3& x, Array<double>& quality, Array<Vec3>& gradient) const
{
    quality.resize(size_);
    gradient.resize(size_);
    Gradients found;
    const Vec3 centre = in_frame(x);
    for (size_t i = 0; i < size_; ++i) {
        if (i % kLanes == 0)
            find_gradients(lanes_[i / kLanes], centre, found);
        quality[i] = found.quality[i % kLanes];
        for (int axis = 0; axis < 3; ++axis)
            gradient[i][axis] = found.gradient[axis][i % kLanes];
    }
    if (measured_)
        measured_->qualities_with(point_, x, quality);
}

}  // namespace cleft
