// The numbers of points in a whole mesh that ranks have in pieces.
#pragma once

#include "mesh/bounding_box.hpp"
#include "parts/exchange.hpp"
#include "parts/mesh_pieces.hpp"

namespace cleft
{

struct NumberedPoints {
    Array<int64_t> of_points;  // of this rank's pieces, one after the other
    Array<int64_t> start;      // by piece: where its points begin
    int64_t all = 0;           // points of the whole mesh

    const int64_t* of_piece(int32_t piece) const { return of_points.data() + start[piece]; }
};

// Numbers points along the Hilbert curve through `box`, as order_spatially() does. Points with the same coordinates are
// one point, on one rank or on several.
NumberedPoints number_points(const MeshPieces& pieces, const BoundingBox& box, Exchange& exchange);

// Which rank owns which numbers: each the same share of them, one after the other.
class OwnedNumbers
{
public:
    OwnedNumbers(int64_t all, int32_t ranks) : all_(all), ranks_(ranks) {}

    int64_t first(int32_t rank) const { return all_ / ranks_ * rank + std::min<int64_t>(all_ % ranks_, rank); }
    int32_t owner(int64_t number) const
    {
        // The first all % ranks ranks have one number more than the others.
        const int64_t less = all_ / ranks_, longer = all_ % ranks_, of_longer = longer * (less + 1);
        return static_cast<int32_t>(number < of_longer ? number / (less + 1) : longer + (number - of_longer) / less);
    }

private:
    int64_t all_;
    int32_t ranks_;
};

}  // namespace cleft
