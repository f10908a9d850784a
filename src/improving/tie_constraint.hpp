// Where a point of a multi-material mesh may move: points of interfaces on the tie of their materials (a surface, a
// triple line, a quadruple point), points of the hull within its planes.
#pragma once

#include "base/array.hpp"
#include "remeshing/smoothing.hpp"
#include "volume/material_set.hpp"
#include "volume/volume.hpp"

namespace cleft
{

class TieConstraint
{
public:
    explicit TieConstraint(const Volume& volume) : volume_(volume) {}

    // For a point at x where the materials of `tets` meet. `reach` is the length of its edges; trial positions up to
    // `tolerance` off the tie are taken as they are. Where there is no tie (more materials meet than equations can be
    // met, or the walls leave too few free axes), `home` stands for it: the place that cleaving gave the point.
    void set(const LocalMesh& mesh, const Array<int32_t>& tets, const Vec3& x, const Vec3& home, uint8_t frozen,
             double reach, double tolerance);

    // The point has nowhere to go.
    bool fixed() const { return tangent_.isZero(); }
    // Projects on the directions that the point may move along, to first order.
    const Mat3& tangent() const { return tangent_; }
    // False for a position too far from the tie.
    // Samples the volume, which is most of the cost of a trial; not for several threads.
    bool project(Vec3& x);

private:
    void find_tangent(const Vec3& x);
    bool is_at_interface() const { return too_many_ || materials_.size() > 1; }

    const Volume& volume_;
    MaterialSet materials_;
    bool too_many_ = false;  // materials for a tie
    unsigned frozen_ = 0;
    double reach_ = 0, tolerance_ = 0;
    Vec3 home_;
    Mat3 tangent_;
    Samples samples_;
};

}  // namespace cleft
