// The lattice of a sizing field: one size everywhere, the least that the field asks for.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "sizing/sizing_field.hpp"

namespace cleft
{

struct LatticeOptions {
    double max_tets = 0;  // where only features ask for the least size, it is raised to keep to these; 0: no limit
    bool is_size_given = false;  // the user asks for the least size, not features
};

// The size that the lattice gets for sizes of that range.
double field_lattice_size(const Grid& grid, const SizeRange& sizes, const LatticeOptions& options);

// Warns where the size is raised. Refuses the lattice of a plate that has more tetrahedra than max_tets although its
// size asks for no more: cells are no longer than the box is thin.
void check_lattice(const Grid& grid, const SizeRange& sizes, const LatticeOptions& options, const Run& run);
TetMesh field_lattice(const SizingField& field, const LatticeOptions& options, const Run& run);

// Warns if the one size of a lattice is coarser than the thinnest parts ask for, where the field was scaled.
void warn_of_coarse_lattice(const SizingField& field, double scale, const Run& run);

}  // namespace cleft
