// Optimisation-based smoothing: moves a point so that the worst tetrahedron around it gets better.
#pragma once

#include "mesh/local_mesh.hpp"

#include <functional>

namespace cleft
{

// The tetrahedra around one point, copied together so that trial positions are judged without walking the mesh.
class Star
{
public:
    // The star of a point of the mesh.
    void load(const LocalMesh& mesh, int32_t v);
    // The star that a point put into an edge would have.
    void load(const LocalMesh& mesh, const EdgeRing& ring);

    // Of the mesh, around the point or the edge.
    const std::vector<int32_t>& tets() const { return tets_; }
    bool empty() const { return opposite_.empty(); }
    // Length of a typical edge from x to the corners around.
    double reach(const Vec3& x) const;
    // Mean of the centroids of the tetrahedra with the point at x.
    Vec3 centroid(const Vec3& x) const;
    // Least quality with the point at x; may stop early with any value once it is not above `floor`.
    double worst_at(const Vec3& x, double floor) const;
    // Quality of each tetrahedron with the point at x, and its gradient with respect to x.
    void gradients_at(const Vec3& x, std::vector<double>& quality, std::vector<Vec3>& gradient) const;

private:
    void add(const LocalMesh& mesh, const Tet& tet, int corner);

    // The three other corners, so that (x, corners) is positively oriented.
    std::vector<std::array<Vec3, 3>> opposite_;
    std::vector<int32_t> tets_;
};

// Moves a trial position back to where the point may be; false if there is no such place near.
using Projection = std::function<bool(Vec3&)>;

// A place for the centre of a star, and the worst quality there.
struct Place {
    Vec3 x;
    double worst;
};

class Smoother
{
public:
    // Climbs from x, in the plane or line that `tangent` projects on, until the worst tetrahedron is as good as
    // `target` or cannot be made better; every trial position goes through `projection` if there is one.
    Place climb(const Star& star, const Vec3& x, double target, const Mat3& tangent, const Projection& projection);

    // The best of a fixed set of places around x, up to half of the reach away: for stars where climbing ends on a
    // ridge.
    Place explore(const Star& star, const Vec3& x, const Mat3& tangent, const Projection& projection) const;

private:
    Vec3 ascent_direction(double worst) const;
    double first_step(const Vec3& direction, double worst, double reach) const;
    bool step(const Star& star, Place& place, const Mat3& tangent, const Projection& projection);

    std::vector<double> quality_;
    std::vector<Vec3> gradient_;
};

// Projects on the axes that are not frozen.
Mat3 free_axes(uint8_t frozen);

}  // namespace cleft
