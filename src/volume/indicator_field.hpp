// Indicator functions given by their values at voxel centres.
//
// Between the centres they are interpolated by cubic convolution, which is C1, takes the given values at the centres
// and reproduces quadratic functions. Past the outermost centres they go on linearly, so that a signed distance stays
// one up to the walls of the box, half a voxel away.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "volume/volume.hpp"

namespace cleft
{

struct IndicatorField {
    Grid grid;
    // K fields, or for a signed function one: then material 0 is -f and material 1 is +f.
    Array<Array<float>> field;
    // The field that is everywhere the greatest of the others with its sign changed, as distances from what is outside
    // of several parts are; -1 if there is none. It has a crease in the gap between two parts, which interpolation
    // would round off and so fill the gap: it is taken from the others where they are interpolated.
    int32_t rest = -1;
    // For blocks of kBlock^3 voxels: how many blocks around it hold one material, plus one; 0: perhaps more than one.
    Grid blocks;
    Array<uint8_t> depth;

    bool is_signed() const { return field.size() == 1; }
    Material material_count() const { return is_signed() ? 2 : static_cast<Material>(field.size()); }
};

// Copies the fields, of grid.size() values each, x fastest. Throws what bounded_values() and check_claims() refuse.
template <class Value>
IndicatorField make_indicators(const Array<const Value*>& fields, const Grid& grid, const Run& run);

// As the functions of Volume with the same names.
Material voxel_material(const IndicatorField& field, int64_t voxel);
Material material_at(const IndicatorField& field, const Vec3& x);
void sample(const IndicatorField& field, const Vec3& x, Samples& out);
void sample_gradient(const IndicatorField& field, const Vec3& x, Samples& out);
bool single_material_near(const IndicatorField& field, const Vec3& x, double reach);

}  // namespace cleft
