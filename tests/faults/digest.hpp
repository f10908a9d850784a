// One number for many: FNV-1a of the bytes of arrays.
#pragma once

#include "cleft/cleft.h"

#include <cstddef>
#include <cstdint>

namespace faults
{

inline uint64_t digest_of_bytes(const void* data, size_t bytes, uint64_t so_far = 14695981039346656037u)
{
    for (size_t i = 0; i < bytes; ++i)
        so_far = (so_far ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211u;
    return so_far;
}

template <class T>
uint64_t digest(const T* values, int64_t count)
{
    return digest_of_bytes(values, sizeof(T) * static_cast<size_t>(count));
}

inline uint64_t digest_of(const cleft_mesh* mesh)
{
    return digest(cleft_mesh_points(mesh), 3 * cleft_mesh_point_count(mesh)) ^
           digest(cleft_mesh_tets(mesh), 4 * cleft_mesh_tet_count(mesh)) ^
           digest(cleft_mesh_tet_labels(mesh), cleft_mesh_tet_count(mesh));
}

}  // namespace faults
