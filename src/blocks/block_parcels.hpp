// What blocks are made of, as messages and as bytes on disk.
#pragma once

#include "blocks/block_job.hpp"
#include "parts/parcel.hpp"

namespace cleft
{

inline void pack(const Snapped& snapped, Parcel& parcel)
{
    parcel.put(snapped.vertices);
    parcel.put(snapped.kept);
}

inline void unpack(Parcel& parcel, Snapped& snapped)
{
    parcel.take(snapped.vertices);
    parcel.take(snapped.kept);
}

inline void pack(const TetMesh& mesh, Parcel& parcel)
{
    parcel.put(mesh.points);
    parcel.put(mesh.tets);
}

inline void unpack(Parcel& parcel, TetMesh& mesh)
{
    parcel.take(mesh.points);
    parcel.take(mesh.tets);
}

inline void pack(const LabelledMesh& mesh, Parcel& parcel)
{
    parcel.put(mesh.points);
    parcel.put(mesh.tets);
    parcel.put(mesh.material);
}

inline void unpack(Parcel& parcel, LabelledMesh& mesh)
{
    parcel.take(mesh.points);
    parcel.take(mesh.tets);
    parcel.take(mesh.material);
}

// Not where the side is in its block, which only that one needs.
inline void pack(const NearSnapped& near, Parcel& parcel)
{
    pack(near.side.background, parcel);
    pack(near.side.snapped, parcel);
}

inline void unpack(Parcel& parcel, NearSnapped& near)
{
    unpack(parcel, near.side.background);
    unpack(parcel, near.side.snapped);
}

inline void pack(const Block& block, Parcel& parcel)
{
    pack(block.background, parcel);
    parcel.put(block.held);
    pack(block.snapped, parcel);
    pack(block.mesh, parcel);
}

inline void unpack(Parcel& parcel, Block& block)
{
    unpack(parcel, block.background);
    parcel.take(block.held);
    unpack(parcel, block.snapped);
    unpack(parcel, block.mesh);
}

}  // namespace cleft
