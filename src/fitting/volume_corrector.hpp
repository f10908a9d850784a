// Moves the points of interfaces by what is left of the heights around them.
#pragma once

#include "base/array.hpp"
#include "fitting/residuals.hpp"
#include "fitting/volume_deficits.hpp"
#include "remeshing/smoothing.hpp"

namespace cleft
{

// Where a point is to go, and along which directions it may slide and keep its heights.
struct FitMove {
    Vec3 shift{0, 0, 0};
    Mat3 along = Mat3::Zero();
};

class VolumeCorrector
{
public:
    VolumeCorrector(LocalMesh& mesh, double floor) : mesh_(mesh), floor_(floor) {}

    // Moves points one after the other, as far as the shapes around allow. Returns the number that could not move.
    // What materials gain is taken off their deficits, if there are any.
    int64_t apply(const Array<Residual>& residuals, Array<FitPoint>& points, VolumeDeficits& deficits, const Run& run);

private:
    // A place for a point, and the share of its move that it has there.
    struct Applied {
        Vec3 x;
        double share;
    };

    Applied place_for(int32_t v, const FitMove& move);
    void count_gains(const Vec3& shift, VolumeDeficits& deficits) const;

    LocalMesh& mesh_;
    const double floor_;
    TetStar star_;
    Smoother smoother_;
};

}  // namespace cleft
