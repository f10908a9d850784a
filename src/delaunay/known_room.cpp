// Looks up the cells that a box or a ball meets.
#include "delaunay/known_room.hpp"

#include <algorithm>
#include <array>

namespace cleft
{

namespace
{

constexpr int kRoomCells = 32;  // along each axis: about one mean distance of points each
constexpr double kWider = 0.1;  // the grid goes beyond the box by this much of its longest side

}  // namespace

void KnownRoom::clear(const BoundingBox& own)
{
    own_ = own;
    const Vec3 margin = Vec3::Constant(kWider * own.longest());
    corner_ = own.lo - margin;
    cells_per_length_ = kRoomCells * (own.hi - own.lo + 2 * margin).cwiseMax(1e-300).cwiseInverse();
    least_.assign(kRoomCells * kRoomCells * kRoomCells, std::numeric_limits<double>::infinity());
}

template <class Visit>
void KnownRoom::for_cells(const BoundingBox& box, const Visit& visit) const
{
    std::array<std::array<int, 2>, 3> range{};
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<Eigen::Index>(axis);
        const auto cell = [&](double x) {
            return static_cast<int>(std::clamp((x - corner_[a]) * cells_per_length_[a], 0.0, kRoomCells - 0.5));
        };
        range[axis] = {cell(box.lo[a]), cell(box.hi[a])};
    }
    for (int k = range[2][0]; k <= range[2][1]; ++k)
        for (int j = range[1][0]; j <= range[1][1]; ++j)
            for (int i = range[0][0]; i <= range[0][1]; ++i)
                visit((k * kRoomCells + j) * kRoomCells + i);
}

void KnownRoom::leave_out(const BoundingBox& box)
{
    const double distance = own_.distance(box);
    for_cells(box, [&](int cell) { least_[cell] = std::min(least_[cell], distance); });
}

bool KnownRoom::holds_ball(const Vec3& centre, double radius) const
{
    // In the box are the points of the brick alone.
    if ((centre - own_.lo).minCoeff() > radius && (own_.hi - centre).minCoeff() > radius)
        return true;
    // No point of the ball is farther from the brick's box.
    const double farthest = own_.distance(centre) + radius;
    if (!(farthest < std::numeric_limits<double>::infinity()))
        return false;
    const Vec3 reach = Vec3::Constant(radius);
    bool holds = true;
    for_cells({centre - reach, centre + reach}, [&](int cell) { holds = holds && farthest < least_[cell]; });
    return holds;
}

}  // namespace cleft
