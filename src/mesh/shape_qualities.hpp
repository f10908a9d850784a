// The measure shape_quality() of many tetrahedra.
#pragma once

#include "base/wide_vectors.hpp"
#include "mesh/shape_quality.hpp"

namespace cleft
{

// Four tetrahedra side by side.
// The compiler turns the loop over them into vector instructions. They compute each lane as plain code does.
class Foursome
{
public:
    // True if it is full now. `number` is where measure() puts what it finds.
    bool add(int64_t number, const Tet& tet, const Array<Vec3>& points)
    {
        for (size_t c = 0; c < 4; ++c)
            for (int axis = 0; axis < 3; ++axis)
                corner_[c][axis][size_] = points[tet[c]][axis];
        number_[size_++] = number;
        return size_ == kLanes;
    }
    // For all that were added since the last call.
    void measure(Array<double>& quality)
    {
        double found[kLanes];
        find(found);
        for (size_t i = 0; i < size_; ++i)
            quality[number_[i]] = found[i];
        size_ = 0;
    }

private:
    static constexpr size_t kLanes = 4;

    CLEFT_WIDE_VECTORS void find(double* quality) const
    {
        const auto& [a, b, c, d] = corner_;
        for (size_t i = 0; i < kLanes; ++i)
            quality[i] = shape_quality(Triple{a[0][i], a[1][i], a[2][i]}, Triple{b[0][i], b[1][i], b[2][i]},
                                       Triple{c[0][i], c[1][i], c[2][i]}, Triple{d[0][i], d[1][i], d[2][i]});
    }

    double corner_[4][3][kLanes] = {};  // by corner and axis
    int64_t number_[kLanes] = {};
    size_t size_ = 0;
};

}  // namespace cleft
