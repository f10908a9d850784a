// Chooses the one size of a lattice for a field of sizes.
#include "background/field_lattice.hpp"

#include "background/lattice.hpp"
#include "base/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// Cells are no longer than the box is thin, whatever their size is to be: a plate can have many more of them than that
// size asks for.
void refuse_flat_lattice(const Grid& grid, double size, double most)
{
    constexpr double kRounded = 2;  // numbers of cells are whole
    const double tets = lattice_tets(grid, size), asked = lattice_tets_for(grid, size);
    if (most > 0 && tets > kRounded * std::max(most, asked))
        throw Error(CLEFT_ERROR_TOO_LARGE, "the box is so thin that a lattice has about " + count_text(tets) +
                                               " tetrahedra, more than max_tets, " + count_text(most) +
                                               ": set a greater max_tets or another background");
}

void warn_of_raised_size(double least, double size, double most, const Run& run)
{
    if (size <= least)
        return;
    const double asked = most * std::pow(size / least, 3);
    run.warn("a lattice of the least size, " + number_text(least) + ", has about " + count_text(asked) +
             " tetrahedra: its size was raised to " + number_text(size) + " to keep to max_tets, " + count_text(most));
}

}  // namespace

double field_lattice_size(const Grid& grid, const SizeRange& sizes, const LatticeOptions& options)
{
    const bool is_asked_for = options.is_size_given || sizes.is_one_size();
    if (options.max_tets <= 0 || is_asked_for)
        return sizes.least;
    return std::max(sizes.least, lattice_size_for(grid, options.max_tets));
}

void check_lattice(const Grid& grid, const SizeRange& sizes, const LatticeOptions& options, const Run& run)
{
    const double size = field_lattice_size(grid, sizes, options);
    warn_of_raised_size(sizes.least, size, options.max_tets, run);
    refuse_flat_lattice(grid, size, options.max_tets);
}

TetMesh field_lattice(const SizingField& field, const LatticeOptions& options, const Run& run)
{
    const SizeRange sizes = field.range();
    check_lattice(field.grid, sizes, options, run);
    return lattice_background(field.grid, field_lattice_size(field.grid, sizes, options), run);
}

// Scaled for a wanted number of tetrahedra, the one size of a lattice can come out coarser than the thinnest parts ask
// for, which is half of their thickness. A field that is constant asks for nothing of the kind.
void warn_of_coarse_lattice(const SizingField& field, double scale, const Run& run)
{
    // A lattice that is less than a tenth coarser resolves nearly the same, and needs no warning.
    constexpr double kCoarse = 1.1;
    const SizeRange sizes = field.range();
    if (scale > kCoarse && !sizes.is_one_size())
        run.warn("the lattice has one size, " + number_text(sizes.least) +
                 ", which may lose the thinnest parts: a size of " + number_text(sizes.least / scale) +
                 " resolves them, or a graded background with fewer tetrahedra");
}

}  // namespace cleft
