// Work on blocks of a mesh and on the seams between two of them: pure functions of these and of the volume around them.
#pragma once

#include "blocks/block_layout.hpp"
#include "cleaving/snapped.hpp"
#include "finishing/improve_and_fit.hpp"

#include <utility>

namespace cleft
{

struct Block {
    TetMesh background;
    Array<int32_t> held;  // vertices where it was cut out of the whole background
    Snapped snapped;
    LabelledMesh mesh;
};

// A part of a background, with its points in the order of their places: cuts run from the lower end of an edge to the
// higher one, and so are the same in all parts.
Block block_of(const TetMesh& background, const BoundingBox& box, const Run& run);

// Snaps the vertices that are not held.
void snap_block(const VolumeParts& volume, Block& block, const PipelineOptions& options, const Run& run);

// Makes the mesh of a block in which all vertices have snapped. It is the same on both sides of a seam.
void mesh_block(const VolumeParts& volume, Block& block, const PipelineOptions& options, const Run& run);

// Where a block of a background, or its mesh, may meet another block.
Array<Vec3> places_of_cut(const Block& block);
Array<Vec3> places_of_cut(const LabelledMesh& mesh, const BoundingBox& box, const Run& run);

// What a block has of its background near a seam.
struct SnapSide {
    TetMesh background;
    Snapped snapped;
};
struct NearSnapped {
    SnapSide side;
    Array<int32_t> vertices, tets;  // of the side, in the block
};
NearSnapped near_snapped(const Block& block, const Array<Vec3>& places_of_other);

// Snaps the vertices that two blocks share, and once more those near them. Returns what each side has then.
std::pair<Snapped, Snapped> snap_seam(const VolumeParts& volume, const SnapSide& lower, const SnapSide& upper,
                                      const PipelineOptions& options, const Run& run);
// What the seam says of a side takes the place of what the block had there.
void take_back(Block& block, const NearSnapped& near, const Snapped& of_side);

// Takes out of the mesh of a block what is near another one.
LabelledMesh taken_near(LabelledMesh& mesh, const Array<Vec3>& places_of_other, const BoundingBox& box, const Run& run);
// Improves where two blocks meet, from what was taken out of both. Returns what belongs to the lower and to the upper
// one: tetrahedra with their middle at `seam` or above go to the upper one.
std::pair<LabelledMesh, LabelledMesh> improve_seam(const VolumeParts& volume, LabelledMesh lower,
                                                   const LabelledMesh& upper, double seam,
                                                   const PipelineOptions& options, const Run& run);

}  // namespace cleft
