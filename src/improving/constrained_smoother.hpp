// Finds better places for points of a multi-material mesh, where their ties and the box let them go.
#pragma once

#include "base/array.hpp"
#include "improving/tie_constraint.hpp"
#include "remeshing/cavity.hpp"

namespace cleft
{

class ConstrainedSmoother
{
public:
    // `home`: of each point, see TieConstraint.
    ConstrainedSmoother(const LocalMesh& mesh, const Volume& volume, const Array<Vec3>& home);

    // Places of quality `target` (of shape_quality) are good enough. For `tolerance` see Search.
    void aim_at(double target, double tolerance);

    // Where the worst tetrahedron around a point is better; false if the point stays. After that, star() is the star of
    // the point.
    bool find(int32_t v, bool thorough, Vec3& better);
    const TetStar& star() const { return star_; }

    // Loads the tetrahedra around an edge, and finds its middle on the tie of their materials; false if there is none.
    bool load_middle(const EdgeRing& ring, Vec3& middle);
    // A better place for a point in the tetrahedra that are loaded, from one on the tie.
    Place climb(const Vec3& from);

    // See Smoother.
    int64_t places() const { return smoother_.places(); }

private:
    Place better_place(int32_t v, bool thorough);
    void constrain(const Array<int32_t>& tets, const Vec3& x, const Vec3& home, uint8_t frozen);

    const LocalMesh& mesh_;
    // The least spacing: tolerances are in it, as it is what users see of the accuracy of a label map.
    const double voxel_;
    double target_ = 0, tolerance_ = 0;
    const Array<Vec3>& home_;
    TieConstraint constraint_;
    Smoother smoother_;
    TetStar star_;
};

}  // namespace cleft
