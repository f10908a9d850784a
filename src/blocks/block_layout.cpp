// Which planes of voxels work on tetrahedra may sample.
#include "blocks/block_layout.hpp"

namespace cleft
{

namespace
{

double longest_edge(const Array<Vec3>& points, const Array<Tet>& tets)
{
    double squared = 0;
    for (const Tet& tet : tets)
        for (size_t i = 0; i < 4; ++i)
            for (size_t j = 0; j < i; ++j)
                squared = std::max(squared, (points[tet[i]] - points[tet[j]]).squaredNorm());
    return std::sqrt(squared);
}

}  // namespace

std::shared_ptr<const Volume> VolumeParts::around(const Array<Vec3>& points, const Array<Tet>& tets) const
{
    // A vertex snaps by half an edge at most, and a search for a tie goes no farther than an edge from its point.
    constexpr double kSpareEdges = 1.5;
    constexpr double kSparePlanes = 4;
    const BoundingBox box = box_of(points);
    const double spare = kSpareEdges * longest_edge(points, tets) / grid.spacing[2] + kSparePlanes;
    const auto plane = [&](double place) {
        return static_cast<int32_t>(std::clamp(std::floor(place), 0.0, grid.dims[2] - 1.0));
    };
    const int32_t first = plane(box.lo[2] / grid.spacing[2] - spare);
    return planes({first, plane(box.hi[2] / grid.spacing[2] + spare) + 1 - first});
}

}  // namespace cleft
