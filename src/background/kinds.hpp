// The kinds of background meshes that a sizing field can be given: one row each.
#pragma once

#include "background/field_lattice.hpp"
#include "background/particles.hpp"
#include "volume/kept_materials.hpp"

namespace cleft
{

/* <choice> Made by tools/generate.py from src/capi/options.toml. */
enum class BackgroundKind { particles, lattice, octree };
inline constexpr size_t kBackgroundKindCount = 3;
/* </choice> */

struct BackgroundOptions {
    BackgroundKind kind = BackgroundKind::particles;
    ParticleOptions particles;
    LatticeOptions lattice;
};

// All that the library knows of a kind.
struct BackgroundRow {
    BackgroundKind kind;
    // Throws CLEFT_ERROR_TOO_LARGE where the sizes ask for more than this kind can make.
    TetMesh (*make)(const SizingField& field, const BackgroundOptions& options, const Run& run);
    double (*expected_tets)(const SizingField& field, const BackgroundOptions& options, const Run& run);
    // The one size of its tetrahedra; null where they follow the field.
    double (*uniform_size)(const SizingField& field, const BackgroundOptions& options);
    // What the sizes are limited by, as SizingOptions::expected_tets; null where they need not be, since making the
    // background keeps to max_tets.
    double (*tets_near_limit)(const SizingField& field, double limit, const Run& run);
    // Of the time from here to the finished mesh, in percent, on volumes of some millions of tetrahedra.
    double share_of_time;
    // The peak of memory for each of its tetrahedra, of making it or of cleaving it where nothing is cut.
    double bytes_a_tet;
};

const BackgroundRow& row_of(BackgroundKind kind);

inline bool is_graded(BackgroundKind kind) { return !row_of(kind).uniform_size; }

// Of a background, of which some tetrahedra lie in kept materials.
struct ExpectedBackground {
    double all = 0, kept = 0;
};
// As exact as the estimate of each kind. For an octree its tree is built, which takes a while.
ExpectedBackground expected_background(const SizingField& field, const BackgroundOptions& options, const Volume& volume,
                                       const KeptMaterials& kept, const Run& run);

}  // namespace cleft
