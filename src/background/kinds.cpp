// What each kind of background is made by, and how many tetrahedra it will have.
#include "background/kinds.hpp"

#include "background/bcc_cell.hpp"
#include "background/bcc_patches.hpp"
#include "background/lattice.hpp"
#include "background/octree.hpp"

#include <iterator>

namespace cleft
{

namespace
{

// Particles of one size everywhere are seeded as a lattice that fits the box, so that their number is known.
double particle_tets(const SizingField& field)
{
    const SizeRange sizes = field.range();
    const double cells = sizes.is_one_size() ? cells_of_constant_size(field.grid, sizes.least) : 0;
    return cells > 0 ? kTetsOfBccCell * cells : expected_particle_tets(field);
}

// In the order of BackgroundKind.
constexpr BackgroundRow kRows[] = {
    {BackgroundKind::particles,
     [](const SizingField& field, const BackgroundOptions& options, const Run& run) {
         return particle_background(field, options.particles, run);
     },
     [](const SizingField& field, const BackgroundOptions&, const Run&) { return particle_tets(field); }, nullptr,
     [](const SizingField& field, double, const Run&) { return expected_particle_tets(field); }, 57, 165},
    {BackgroundKind::lattice,
     [](const SizingField& field, const BackgroundOptions& options, const Run& run) {
         return field_lattice(field, options.lattice, run);
     },
     [](const SizingField& field, const BackgroundOptions& options, const Run&) {
         return lattice_tets(field.grid, field_lattice_size(field.grid, field.range(), options.lattice));
     },
     [](const SizingField& field, const BackgroundOptions& options) {
         return field_lattice_size(field.grid, field.range(), options.lattice);
     },
     nullptr, 5, 112},
    {BackgroundKind::octree,
     [](const SizingField& field, const BackgroundOptions&, const Run& run) { return octree_background(field, run); },
     [](const SizingField& field, const BackgroundOptions&, const Run& run) {
         return static_cast<double>(octree_tets(field, run));
     },
     nullptr, octree_tets_near_limit, 10, 112},
};

// A kind is looked up by its number: one without a row would be read behind the table.
constexpr bool has_row_for_each_kind()
{
    for (size_t i = 0; i < std::size(kRows); ++i)
        if (kRows[i].kind != static_cast<BackgroundKind>(i))
            return false;
    return std::size(kRows) == kBackgroundKindCount;
}
static_assert(has_row_for_each_kind(), "the table needs a row for each BackgroundKind, in their order");

// The share of the voxels that are in kept materials.
double kept_share_of_voxels(const Volume& volume, const KeptMaterials& kept)
{
    const Array<int64_t>& voxels = volume.voxel_counts();
    double in_kept = 0;
    for (size_t m = 0; m < voxels.size(); ++m)
        in_kept += kept.has(static_cast<Material>(m)) ? static_cast<double>(voxels[m]) : 0;
    return in_kept / static_cast<double>(volume.grid().size());
}

}  // namespace

const BackgroundRow& row_of(BackgroundKind kind) { return kRows[static_cast<int>(kind)]; }

ExpectedBackground expected_background(const SizingField& field, const BackgroundOptions& options, const Volume& volume,
                                       const KeptMaterials& kept, const Run& run)
{
    const double all = row_of(options.kind).expected_tets(field, options, run);
    if (kept.all())
        return {all, all};
    // A graded background has more tetrahedra where h is small, a lattice the same number everywhere.
    const double share = is_graded(options.kind)
                             ? expected_particle_tets(field, volume, kept) / expected_particle_tets(field)
                             : kept_share_of_voxels(volume, kept);
    return {all, all * share};
}

}  // namespace cleft
