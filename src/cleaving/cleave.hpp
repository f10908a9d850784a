// Cleaving: splits a background mesh once along the material interfaces of a volume (paper, section 3.1).
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/metric_field.hpp"
#include "volume/volume.hpp"

namespace cleft
{

/* <choice> Made by tools/generate.py from src/capi/options.toml. */
enum class Snap { quality, safe, none };
inline constexpr size_t kSnapCount = 3;
/* </choice> */

struct CleaveOptions {
    Snap snap = Snap::quality;
    const MetricField* metric = nullptr;  // that lengths and shapes are measured by; null: by none
    // Vertices that neither snap nor move, ascending: where the background was cut out of a larger one.
    Array<int32_t> held = {};
};

// Conforming and positively oriented for every positively oriented background, whatever its quality; covers exactly
// what the background covers. Notes cleaving.*.
// The points of `background` must be in the local frame, inside the box of the volume. Neither input changes.
LabelledMesh cleave(const Volume& volume, const TetMesh& background, const CleaveOptions& options, const Run& run);

struct Snapped;  // cleaving/snapped.hpp

// Its two halves, for a background that is cleaved in parts: vertices snap in one part after the other, from what
// earlier parts have left, and each part is cut when all have.
Snapped snap_background(const Volume& volume, const TetMesh& background, const CleaveOptions& options,
                        const Snapped& before, const Run& run);
LabelledMesh cleave_snapped(const Volume& volume, const TetMesh& background, const CleaveOptions& options,
                            const Snapped& snapped, const Run& run);

}  // namespace cleft
