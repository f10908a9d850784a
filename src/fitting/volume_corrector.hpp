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
    // No point moves further than `most_moved` in all.
    VolumeCorrector(LocalMesh& mesh, double floor, double most_moved)
        : mesh_(mesh), floor_(floor), most_moved_(most_moved)
    {
    }

    // Moves points one after the other, as far as the shapes around allow. Returns the number that could not move.
    // What materials gain is taken off their deficits, if there are any.
    int64_t apply(const Array<Residual>& residuals, Array<FitPoint>& points, VolumeDeficits& deficits, const Run& run);

private:
    // A place for a point, and the share of its move that it has there.
    struct Applied {
        Vec3 x;
        double share;
    };
    // What a material gains by the move of a point.
    struct Gain {
        Material material;
        double volume;
    };
    // Those of one visit, in the list of the thread that made it.
    struct GainsOfVisit {
        int worker = 0;
        int64_t begin = 0, end = 0;
    };

    // What one thread needs.
    struct Scratch {
        TetStar star;
        Smoother smoother;
        Array<Gain> gains;
        int64_t held = 0;
    };

    void visit(const Residual& residual, FitPoint& point, GainsOfVisit* gains, Scratch& scratch);
    Applied place_for(int32_t v, const FitMove& move, Scratch& scratch) const;
    GainsOfVisit count_gains(const Vec3& shift, Scratch& scratch) const;

    LocalMesh& mesh_;
    const double floor_, most_moved_;
};

}  // namespace cleft
