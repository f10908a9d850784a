// Sizing fields that are given, what can be asked of any, and scaling it.
#include "sizing/sizing_field.hpp"

#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "sizing/gradient_limit.hpp"
#include "sizing/sizing_charge.hpp"
#include "volume/limits.hpp"

#include <cmath>
#include <string>

namespace cleft
{
namespace
{

// Particles per unit of charge at which relaxed particles have a mean distance of h, and tetrahedra per particle of
// their Delaunay mesh. Particles on the walls count for the half, quarter or eighth of their surroundings that is in
// the box, so that the charge of the box is that of its particles, and their share of tetrahedra likewise.
constexpr double kParticlesPerCharge = 1.75;
// Numbers that are reported before a run, and the memory for them, rest on this product.
constexpr double kTetsPerParticle = 5.9;

}  // namespace

Error bad_sizing_value(double value, int64_t voxel, const Grid& grid)
{
    const std::string place = "the sizing value of " + voxel_in_words(voxel, grid.dims) + " is ";
    if (!std::isfinite(value))
        return {CLEFT_ERROR_NOT_FINITE, place + "NaN or infinite"};
    return {CLEFT_ERROR_ARGUMENT,
            place + text_of(value) + "; it must be within " + text_of(kLeastSize) + " to " + text_of(kGreatestSize)};
}

SizingField constant_sizing(const Grid& grid, double size)
{
    if (!is_size(size))
        throw Error(CLEFT_ERROR_ARGUMENT, "the size is " + number_text(size) + "; it must be within " +
                                              number_text(kLeastSize) + " to " + number_text(kGreatestSize));
    return {grid, Array<float>(grid.size(), static_cast<float>(size)), 0.3};
}

template <class Value>
SizingField sizing_from_values(const Grid& grid, const Value* values)
{
    SizingField field{grid, Array<float>(grid.size()), 0.3};
    for (int64_t v = 0; v < field.h.count(); ++v) {
        // As it is given: as a float, a value beyond 3e38 would be infinite, and the sentence would not name it.
        const double value = values[v];
        if (!is_size(value))
            throw bad_sizing_value(value, v, grid);
        field.h[v] = static_cast<float>(value);
    }
    return field;
}
template SizingField sizing_from_values(const Grid& grid, const float* values);
template SizingField sizing_from_values(const Grid& grid, const double* values);

// One pass over the memory. Several values are kept at a time: one alone would wait for each comparison.
SizeRange SizingField::range() const
{
    constexpr int64_t kLanesKept = 16;
    FixedArray<float, kLanesKept> least, greatest;
    least.fill(h.front());
    greatest.fill(h.front());
    const auto take = [&](int64_t lane, float value) {
        least[lane] = value < least[lane] ? value : least[lane];
        greatest[lane] = value > greatest[lane] ? value : greatest[lane];
    };
    int64_t v = 0;
    for (; v + kLanesKept <= h.count(); v += kLanesKept)
        for (int64_t lane = 0; lane < kLanesKept; ++lane)
            take(lane, h[v + lane]);
    for (; v < h.count(); ++v)
        take(0, h[v]);
    return {*std::min_element(least.begin(), least.end()), *std::max_element(greatest.begin(), greatest.end())};
}

double expected_particle_tets(const SizingField& field)
{
    return kTetsPerParticle * kParticlesPerCharge * sizing_charge(field);
}

double expected_particle_tets(const SizingField& field, const Volume& volume, const KeptMaterials& kept)
{
    return kTetsPerParticle * kParticlesPerCharge *
           sizing_charge(field, [&](int64_t voxel) { return kept.has(volume.voxel_material(voxel)); });
}

void scale_sizing(SizingField& field, double factor, const Run& run)
{
    if (!(factor > 0) || !std::isfinite(factor))
        throw Error(CLEFT_ERROR_ARGUMENT, "the factor of a sizing field must be positive and finite");
    for (float& value : field.h)
        value = static_cast<float>(value * factor);
    if (field.metric) {
        MetricField scaled = *field.metric;
        const auto shift = static_cast<float>(-2 * std::log(factor));
        for (auto& log : scaled.log)
            for (const size_t diagonal : {0u, 3u, 5u})
                log[diagonal] += shift;
        field.metric = std::make_shared<const MetricField>(std::move(scaled));
        return;
    }
    if (factor > 1)  // a smaller field grows the more slowly
        limit_gradient(field.grid, field.gradation, field.h, run);
}

}  // namespace cleft
