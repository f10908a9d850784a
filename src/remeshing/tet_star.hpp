// The tetrahedra around a point, and how good they would be with the point elsewhere.
#pragma once

#include "base/array.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

// The tetrahedra around one point, copied together so that trial positions are judged without walking the mesh.
class TetStar
{
public:
    // The star of a point of the mesh.
    void load(const LocalMesh& mesh, int32_t v);
    // The star that a point put into an edge would have.
    void load(const LocalMesh& mesh, const EdgeRing& ring);

    // Shapes are measured in a frame of the star's own: the one in which the metric at its point is the identity, up to
    // a factor. Without a metric it is that of the mesh. Places are those of the mesh; reach and gradients are of the
    // star's frame.
    Vec3 to_mesh(const Vec3& shift, const Mat3& tangent) const
    {
        // What is not free stays to the last bit.
        return maps_ ? Vec3(tangent * (from_frame_ * shift)) : shift;
    }
    // Projects shifts of the star's frame on those that are free. `tangent` does so in the frame of the mesh.
    Mat3 tangent_in_frame(const Mat3& tangent) const;

    // Of the mesh, around the point or the edge.
    const Array<int32_t>& tets() const { return tets_; }
    bool empty() const { return size_ == 0; }
    // Length of a typical edge from x to the corners around.
    double reach(const Vec3& x) const;
    // Mean of the centroids of the tetrahedra with the point at x.
    Vec3 centroid(const Vec3& x) const;
    // By how much the volume of tets()[i], a star of a point, changes when the point moves by `shift`.
    double volume_change(size_t i, const Vec3& shift) const
    {
        const Vec3 b = opposite(i, 0);
        // The map keeps volumes.
        return -(opposite(i, 1) - b).cross(opposite(i, 2) - b).dot(maps_ ? to_frame_ * shift : shift) / 6;
    }
    // Least quality with the point at x; may stop early with any value once it is not above `floor`. With a metric,
    // each tetrahedron around a point is measured by its own.
    double worst_at(const Vec3& x, double floor) const;
    // Quality of each tetrahedron with the point at x, as above, and its gradient with respect to x in the star's
    // frame.
    void gradients_at(const Vec3& x, Array<double>& quality, Array<Vec3>& gradient) const;

private:
    void begin(int64_t capacity);
    void measure_by(const Tensor& log_metric);
    Vec3 in_frame(const Vec3& x) const { return maps_ ? to_frame_ * (x - origin_) : x; }
    void add(const LocalMesh& mesh, const Tet& tet, int corner);
    void fill_last();
    double worst_in_frame(const Vec3& x, double floor) const;

    // Four doubles fill a vector of 256 bits.
    static constexpr size_t kLanes = 4;
    // The three other corners of four tetrahedra side by side, so that (x, corners) is positively oriented.
    struct Lanes {
        double corner[3][3][kLanes];  // by corner and axis
    };
    struct Gradients {
        double quality[kLanes];
        double by_angle[kLanes];     // what the angles alone make of it
        double gradient[3][kLanes];  // by axis
    };
    static double worst_of(const Lanes& lanes, const Vec3& x);
    static void find_angle_gradients(const Lanes& lanes, const Vec3& x, Gradients& out);
    static void find_gradients(const Lanes& lanes, const Vec3& x, Gradients& out);

    Vec3 opposite(size_t i, size_t corner) const
    {
        const auto& c = lanes_[i / kLanes].corner[corner];
        return {c[0][i % kLanes], c[1][i % kLanes], c[2][i % kLanes]};
    }

    Array<Lanes> lanes_;  // the last filled up with copies
    size_t size_ = 0;
    Array<int32_t> tets_;
    const LocalMesh* measured_ = nullptr;  // the mesh, if it has a metric and the star is that of point_
    int32_t point_ = -1;
    bool maps_ = false;
    Tensor to_frame_, from_frame_;
    Vec3 origin_;  // of the star's frame
};

}  // namespace cleft
