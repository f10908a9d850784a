// Places the particles before relaxation: seeds in proportion to the charge need few steps, as section 3 of the paper
// says.
#include "background/seeding.hpp"

#include "background/bcc_patches.hpp"
#include "background/charge_cells.hpp"
#include "base/number_text.hpp"
#include "base/parallel.hpp"
#include "delaunay/delaunay.hpp"
#include "sizing/sizing_charge.hpp"

#include <cmath>
#include <string>

namespace cleft
{

namespace
{

// Gathers charge along the curve and drops a particle at the centroid of each unit of it.
class ErrorDiffusion
{
public:
    // `phase` of the first unit is already there.
    ErrorDiffusion(double phase, Array<Vec3>& out) : charge_(phase), out_(out) {}

    void add(const Vec3& x, double charge, double h)
    {
        // The curve may come from the far side of a place that is none of ours: do not drop the particle half-way.
        if (!started_ || (charge_ > 0 && (x - moment_ / charge_).squaredNorm() > 4 * h * h))
            moment_ = charge_ * x;
        started_ = true;
        while (charge_ + charge >= 1) {
            const double taken = 1 - charge_;
            out_.push_back(moment_ + taken * x);
            charge -= taken;
            charge_ = 0;
            moment_ = Vec3::Zero();
        }
        charge_ += charge;
        CLEFT_ASSERT(charge_ >= 0 && charge_ < 1);
        moment_ += charge * x;
    }

private:
    double charge_;
    bool started_ = false;
    Vec3 moment_ = Vec3::Zero();  // first moment of the charge gathered
    Array<Vec3>& out_;
};

// The number of particles to come. A particle of a wall takes half of its charge from the box: the other half is
// counted here, for in a thin box most particles lie on walls. Edges never have enough to matter.
// Counted before any is made: a field of a wrong unit would otherwise fill the memory first.
double expected_particles(const SizingField& field)
{
    double expected = 8 + kParticleDensity[3] * sizing_charge(field);
    const Grid& grid = field.grid;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double du = grid.spacing[static_cast<int>(u)], dv = grid.spacing[static_cast<int>(v)];
        FixedArray<int32_t, 3> at{};
        for (const int32_t side : {0, grid.dims[axis] - 1}) {
            at[axis] = side;
            for (at[v] = 0; at[v] < grid.dims[v]; ++at[v])
                for (at[u] = 0; at[u] < grid.dims[u]; ++at[u]) {
                    const double h = field.h[grid.index(at[0], at[1], at[2])];
                    expected += 0.5 * kParticleDensity[2] * du * dv / (h * h);
                }
        }
    }
    return expected;
}

void refuse_too_many(double particles)
{
    // For the sentence only: with it, the bound of 60 million particles becomes 360 million tetrahedra.
    constexpr double kTetsPerParticle = 6.1;
    if (particles <= static_cast<double>(kMostDelaunayPoints))
        return;
    const double millions = kTetsPerParticle * particles / 1e6;
    throw Error(CLEFT_ERROR_TOO_LARGE,
                "the sizes ask for a background of about " + count_text(millions) +
                    " million tetrahedra, but particles can make 360 million at most: set a greater size or size_min, "
                    "or a number of tetrahedra by tets");
}

template <size_t D>
void seed_part(const BoxPart<D>& part, const SizeSampler& size, const BccPatches& patches, uint64_t variation,
               const Run& run, ParticleSet& out)
{
    // Each run of the curve has a phase of its own: at worst one particle more or less in hundreds.
    constexpr int64_t kTasksAtOnce = 8;
    const Array<CurveCell<D>> tasks = curve_tasks(part, size, variation);
    const auto count = tasks.count();
    const uint64_t stream = hashed(variation + 1, part.number);
    Array<Array<Vec3>> found(chunk_count(count, kTasksAtOnce));
    parallel_chunks(run, count, kTasksAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
        ErrorDiffusion diffusion(unit_random(stream, static_cast<uint64_t>(chunk)), found[chunk]);
        for (int64_t t = begin; t < end; ++t)
            walk_charge(part, size, tasks[t], border_layer(D), [&](const Vec3& x, double charge, double h) {
                if (!patches.owns(x, part.walls))
                    diffusion.add(x, charge, h);
            });
    });
    // Chunks in their order, so that the numbers of the particles do not depend on threads.
    for (const auto& points : found) {
        for (Vec3 x : points) {
            for (int axis = 0; axis < 3; ++axis)
                if (held(part.walls, axis))  // a centroid of points in a wall may miss it by a rounding error
                    x[axis] = part.origin[axis];
            out.add(x, part.walls);
        }
    }
}

void add_corners(const Vec3& extent, ParticleSet& out)
{
    for (int corner = 0; corner < 8; ++corner)
        out.add(extent.cwiseProduct(Vec3(corner & 1, corner >> 1 & 1, corner >> 2)), 7);
}

// The border of the box: for each axis the four edges along it and the two faces across it.
void seed_border(const SizeSampler& size, const BccPatches& patches, uint64_t variation, const Run& run,
                 ParticleSet& out)
{
    const Vec3 extent = size.extent();
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto number = static_cast<uint64_t>(8 * axis);
        for (uint64_t side = 0; side < 4; ++side) {
            BoxPart<1> edge{{axis}, Vec3::Zero(), static_cast<Walls>(7 ^ 1 << axis), number + side};
            edge.origin[u] = side & 1 ? extent[u] : 0;
            edge.origin[v] = side & 2 ? extent[v] : 0;
            seed_part(edge, size, patches, variation, run, out);
        }
        for (uint64_t side = 0; side < 2; ++side) {
            BoxPart<2> face{{u, v}, Vec3::Zero(), static_cast<Walls>(1 << axis), number + 4 + side};
            face.origin[axis] = side ? extent[axis] : 0;
            seed_part(face, size, patches, variation, run, out);
        }
    }
}

}  // namespace

Seeds seed_particles(const SizingField& field, const SizeSampler& size, uint64_t variation, const Run& run)
{
    refuse_too_many(expected_particles(field));
    const BccPatches patches = constant_size_patches(field, size, run);
    Seeds seeds;
    add_corners(size.extent(), seeds.particles);
    patches.add_particles(seeds.particles);
    seeds.at_rest = patches.fill_the_box();
    if (!seeds.at_rest) {
        seed_border(size, patches, variation, run, seeds.particles);
        seed_part(inside_of_box(), size, patches, variation, run, seeds.particles);
    }
    return seeds;
}

}  // namespace cleft
