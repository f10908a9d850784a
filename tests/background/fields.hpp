// Sizing fields for the tests of particles.
#pragma once

#include "sizing/sizing_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleft::test
{

// Small around a ball in a corner region of the box, growing away from its surface: `least` voxels there.
inline SizingField ball_field(const std::array<int32_t, 3>& dims, const Vec3& spacing, double least, double greatest,
                              double gradation)
{
    SizingField field;
    field.grid.dims = dims;
    field.grid.spacing = spacing;
    const Vec3 extent = field.grid.extent(), centre = 0.4 * extent;
    const double radius = 0.25 * extent.minCoeff(), unit = spacing.minCoeff();
    for (int32_t k = 0; k < dims[2]; ++k)
        for (int32_t j = 0; j < dims[1]; ++j)
            for (int32_t i = 0; i < dims[0]; ++i) {
                const double distance = std::abs((field.grid.centre(i, j, k) - centre).norm() - radius);
                field.h.push_back(static_cast<float>(std::min(least * unit + gradation * distance, greatest * unit)));
            }
    return field;
}

inline SizingField scaled(SizingField field, double factor)
{
    field.grid.spacing *= factor;
    for (float& h : field.h)
        h = static_cast<float>(static_cast<double>(h) * factor);
    return field;
}

}  // namespace cleft::test
