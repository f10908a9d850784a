/*
 * libcleft_mpi is the optional component of libcleft for MPI. It describes a communicator to cleft_parts.h, and reads
 * and writes files that all ranks share. It makes no mesh itself.
 *
 * Conventions are those of cleft_parts.h, and:
 *  - MPI. The program calls MPI_Init() or MPI_Init_thread() before, and MPI_Finalize() after. A function sends messages
 *    on the thread that called it alone, so MPI_THREAD_FUNNELED suffices.
 *  - Communicators. A function works on a copy of the caller's one, so that its messages meet no others.
 *  - HDF5. Debian's HDF5 is not made for several threads. Calls that read or write such files must not overlap with
 *    other calls of that library.
 */
#ifndef CLEFT_MPI_H
#define CLEFT_MPI_H

#include "cleft/cleft_parts.h"

#include <mpi.h>

#if defined(_WIN32) && !defined(CLEFT_STATIC)
#ifdef CLEFT_MPI_BUILDING_LIBRARY
#define CLEFT_MPI_API __declspec(dllexport)
#else
#define CLEFT_MPI_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define CLEFT_MPI_API __attribute__((visibility("default")))
#else
#define CLEFT_MPI_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Describes a communicator to functions that take a cleft_exchange. All ranks of `comm` call it. The caller sets
 *  out->struct_size, and gives `out` to cleft_mpi_exchange_close(). On failure `out` is unchanged.
 *
 *  Errors: CLEFT_ERROR_ARGUMENT if MPI has not begun or has ended, CLEFT_ERROR_EXCHANGE if MPI cannot copy `comm`.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_MPI_API cleft_status cleft_mpi_exchange_open(MPI_Comm comm, cleft_exchange* out) CLEFT_NOEXCEPT;
/** Frees what cleft_mpi_exchange_open() made, and sets `numbers`, `bytes` and `user` to NULL. All ranks call it before
 *  MPI_Finalize(). NULL and a struct of zeros are allowed. \since 0.1 */
CLEFT_MPI_API void cleft_mpi_exchange_close(cleft_exchange* exchange) CLEFT_NOEXCEPT;

/** Makes the mesh of a volume, and gives each rank of `comm` a part: cleft_part_create() over this communicator. All
 *  ranks call it. For a scratch folder, call cleft_mpi_exchange_open(), set `scratch`, and call cleft_part_create()
 *  instead. The caller owns *out, and gives it to cleft_part_destroy(). \since 0.1 */
CLEFT_NODISCARD CLEFT_MPI_API cleft_status cleft_mpi_mesh(cleft_context* context, MPI_Comm comm,
                                                          const cleft_voxels* voxels, const cleft_options* options,
                                                          int32_t ghosts, cleft_part** out) CLEFT_NOEXCEPT;

/** Measures the mesh of which each rank of `comm` has a part: cleft_part_quality() over this communicator. All ranks
 *  call it, and all get the same. \since 0.1 */
CLEFT_NODISCARD CLEFT_MPI_API cleft_status cleft_mpi_quality(cleft_context* context, MPI_Comm comm,
                                                             const cleft_part* part, cleft_quality* out) CLEFT_NOEXCEPT;

/** Writes the mesh of which each rank of `comm` has a part. All ranks call it, and all see the same folders. The
 *  extension of `path` says what is written:
 *
 *  - ".vtkhdf" or ".hdf": one file, VTKHDF for unstructured grids. Its bytes are the same for every number of ranks.
 *  - ".pvtu": the list of the pieces, and for each rank a piece beside it: "mesh_0003.vtu" for "mesh.pvtu" and rank 3.
 *  - ".mfem": a part of a parallel mesh of MFEM for each rank: "mesh.mfem.000003" for "mesh.mfem" and rank 3.
 *
 *  docs/scale.md describes them. The files take their names when all ranks have written all. If a rank fails, there
 *  is no file, and what was there before stays. The path of rank 0 counts; others may give NULL.
 *
 *  Errors: CLEFT_ERROR_UNSUPPORTED for another extension, CLEFT_ERROR_FILE if a file cannot be written,
 *  CLEFT_ERROR_ARGUMENT if the part is of another rank or of another number of ranks. \since 0.1 */
CLEFT_NODISCARD CLEFT_MPI_API cleft_status cleft_mpi_write(cleft_context* context, MPI_Comm comm,
                                                           const cleft_part* part, const char* path) CLEFT_NOEXCEPT;
/** Writes `count` files, or none if one of them fails: what was there before stays. Each is what cleft_mpi_write()
 *  writes to its path. The paths and the count of rank 0 count; others may give NULL and 0.
 *
 *  Errors: those of cleft_mpi_write(), and CLEFT_ERROR_ARGUMENT if rank 0 gives no path. \since 0.1 */
CLEFT_NODISCARD CLEFT_MPI_API cleft_status cleft_mpi_write_all(cleft_context* context, MPI_Comm comm,
                                                               const cleft_part* part, const char* const* paths,
                                                               int64_t count) CLEFT_NOEXCEPT;

/** Opens a label map in an HDF5 file, and fills `out`, whose struct_size the caller sets. Each rank reads by itself, so
 *  the function needs no communicator. `dataset` is the path of the data set in the file. NULL: the only one with three
 *  dimensions and integers in the root group. The last dimension is x.
 *
 *  The size of a voxel is `spacing`, x first, if that is not NULL. Otherwise it is the attribute "spacing" of the data
 *  set, and the place of the first voxel is the attribute "origin": three numbers each, x first. Without them voxels
 *  are unit cubes, voxel 0 lies at the origin, and a warning tells so.
 *
 *  Integers of 8 to 32 bits keep their type; signed ones of 8 bits become int16. Those of 64 bits become int32;
 *  out->read() refuses a label beyond.
 *
 *  The caller gives `out` to cleft_mpi_voxels_close(). On failure `out` is unchanged. Errors: CLEFT_ERROR_FILE for a
 *  file that cannot be read, CLEFT_ERROR_FORMAT for a data set that is not there or is of another kind. \since 0.1 */
CLEFT_NODISCARD CLEFT_MPI_API cleft_status cleft_mpi_voxels_open(cleft_context* context, const char* path,
                                                                 const char* dataset, const double* spacing,
                                                                 cleft_voxels* out) CLEFT_NOEXCEPT;
/** Closes what cleft_mpi_voxels_open() opened, and sets `read` and `user` to NULL. A struct of any other origin is left
 *  as it is, also one of zeros; NULL is allowed. \since 0.1 */
CLEFT_MPI_API void cleft_mpi_voxels_close(cleft_voxels* voxels) CLEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
