/*
 * Meshes in parts: several processes make one mesh together, and each keeps a part of it. The mesh is the same whatever
 * their number, and is the one that cleft_mesh_volume() makes.
 *
 * This header knows no library of messages. A caller describes its own by cleft_exchange; cleft_mpi.h does that for
 * MPI. A rank is a process, or a thread with a context of its own.
 *
 * Conventions are those of cleft.h, and:
 *  - Calls. All ranks call a function that takes a cleft_exchange, with the same arguments but for what is said below.
 *  - Failures. If a rank fails, all ranks return its status, with a sentence that begins with its number: "rank 2:
 * ...". The rank of the least number speaks if several fail; what all say in the same words has no number. A cancel on
 * one rank cancels all. A rank that ends without a word is for the exchange to notice; MPI ends the others then.
 *  - Numbers. Points and tetrahedra have two numbers: a local one of 32 bits, which counts those of this rank from 0,
 * and one of 64 bits in the whole mesh. The latter is that of cleft_mesh_points() and cleft_mesh_tets().
 */
#ifndef CLEFT_PARTS_H
#define CLEFT_PARTS_H

#include "cleft/cleft.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Sends one number to each rank: receive[r] becomes what rank r has in send[rank]. MPI_Alltoall() does that. Returns
 * 0, or any other number if the ranks cannot reach each other. \since 0.1 */
typedef int (*cleft_exchange_numbers)(const int64_t* send, int64_t* receive, void* user);
/** Sends bytes to each rank. Those for rank 0 come first in `send`, then those for rank 1, and so on. What arrives is
 * to lie in `receive` in the same way. Both sides know the sizes. A size may be 0, or greater than 2^31. Returns 0, or
 * any other number if the ranks cannot reach each other. \since 0.1 */
typedef int (*cleft_exchange_bytes)(const void* send, const int64_t* send_sizes, void* receive,
                                    const int64_t* receive_sizes, void* user);

/** How the ranks of a run send each other bytes. The caller sets struct_size to sizeof(cleft_exchange). All ranks call
 *  both functions in the same order, on the thread that called the library. If one of them fails, the call ends with
 *  CLEFT_ERROR_EXCHANGE and uses the exchange no more. \since 0.1 */
typedef struct cleft_exchange {
    uint32_t struct_size;
    int32_t rank;                   /**< the number of this rank, from 0 */
    int32_t ranks;                  /**< how many there are */
    void* user;                     /**< given to the functions */
    cleft_exchange_numbers numbers; /**< sends a number to each rank */
    cleft_exchange_bytes bytes;     /**< sends bytes to each rank */
    const char* scratch;            /**< a folder for files without names, or NULL: see cleft_part_create() */
} cleft_exchange;

/** Reads the voxels first[i] to first[i] + count[i] - 1 along each axis i into `voxels`, x fastest, and returns 0. If
 * it cannot, it returns another number, and writes a sentence of at most `room` bytes to `sentence`, the terminating
 * zero included. The library calls it on one thread at a time. \since 0.1 */
typedef int (*cleft_voxels_read)(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence,
                                 int64_t room, void* user);

/** A label map whose voxels are read when they are needed. The caller sets struct_size to sizeof(cleft_voxels).
 *  cleft_io_voxels_open() makes one of a file. All ranks give the same volume. \since 0.1 */
typedef struct cleft_voxels {
    uint32_t struct_size;
    cleft_type type;        /**< one of the five integer types */
    int64_t dims[3];        /**< the number of voxels along each axis, each less than 2^29; see cleft_part_create() */
    double affine[12];      /**< as in cleft_volume_create_labels() */
    void* user;             /**< given to the function */
    cleft_voxels_read read; /**< reads a box of voxels */
} cleft_voxels;

typedef struct cleft_part cleft_part; /**< the part of a mesh that a rank has; immutable */

/** Makes the mesh of a volume, and gives each rank a part.
 *
 *  Points are numbered along a Hilbert curve, and the curve is cut into as many pieces as there are ranks: each owns
 *  equally many points, the neighbours in space. A tetrahedron belongs to the owner of its point of least number. A
 *  part also has the points of its tetrahedra that others own. If `ghosts` is not 0, it has the tetrahedra of others at
 *  the points that it owns as well: all that there are around these points.
 *
 *  A triangle of the hull is in the part that owns its tetrahedron. A triangle of an interface is in the part that owns
 *  one of its two tetrahedra: that of lower number in the whole mesh. So each triangle bounds a tetrahedron that its
 *  part owns, with ghosts and without. The other tetrahedron of an interface can be in another part.
 *
 *  With the option `block`, all ranks make the mesh, and none holds the whole volume. In blocks that are thinner than
 *  two sizes, the first rank alone makes a background of particles, and holds all sizes then. Without `block`, or with
 *  `tets`, `strict` or an `anisotropy` above 1, the first rank makes the whole mesh; a warning says why.
 *
 *  If ranks make it and `scratch` of the exchange is not NULL, a rank holds two of its blocks at a time. It keeps the
 * others, sizes, weights of voxels, and tetrahedra on their way to their parts in files of that folder without names,
 * which take about eight bytes a voxel and 170 a tetrahedron. The part itself is in memory, with 40 bytes for each
 * tetrahedron. The mesh is the same. Ranks may have folders of their own. A file that cannot be written is
 * CLEFT_ERROR_FILE.
 *
 *  A volume that ranks share may have more than 2^31 voxels. A rank holds the planes of a block and those around it
 * that have a say. If these are more than 2^31 voxels, the error is CLEFT_ERROR_TOO_LARGE; a smaller `block` helps.
 * A part has at most 1,073,741,823 tetrahedra, counted with ghosts. More are the same error; more ranks help.
 *
 *  `options` may be NULL. Options read: all.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_part_create(cleft_context* context, const cleft_voxels* voxels,
                                                         const cleft_options* options, const cleft_exchange* exchange,
                                                         int32_t ghosts, cleft_part** out) CLEFT_NOEXCEPT;
/** Destroys a part and the arrays borrowed from it; NULL is allowed. It needs no other rank. \since 0.1 */
CLEFT_API void cleft_part_destroy(cleft_part* part) CLEFT_NOEXCEPT;

/** How much a part has, and where its own begin in the whole mesh. The caller sets struct_size to
 *  sizeof(cleft_part_counts). \since 0.1 */
typedef struct cleft_part_counts {
    uint32_t struct_size;
    int32_t rank;           /**< the rank of the part */
    int32_t ranks;          /**< how many there are */
    int64_t points;         /**< points of this part */
    int64_t owned_points;   /**< of these, its own: they come first, in the order of their numbers */
    int64_t first_point;    /**< the number of the first of them in the whole mesh; they follow one another */
    int64_t all_points;     /**< points of the whole mesh */
    int64_t tets;           /**< tetrahedra of this part */
    int64_t owned_tets;     /**< of these, its own: they come first, in the order of their numbers */
    int64_t first_tet;      /**< the number of the first of them in the whole mesh; they follow one another */
    int64_t all_tets;       /**< tetrahedra of the whole mesh */
    int64_t triangles;      /**< triangles of interfaces and of the hull, each in one part */
    int64_t first_triangle; /**< the number of the first of them among the triangles of all parts */
    int64_t all_triangles;  /**< triangles of all parts */
} cleft_part_counts;

/** Gets the counts of a part. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_part_count(const cleft_part* part, cleft_part_counts* out) CLEFT_NOEXCEPT;
/** Measures the whole mesh: all ranks get what cleft_mesh_quality() says of it. All ranks call it, with their parts of
 *  one mesh. Each tetrahedron counts in the part that owns it. Percentiles are exact. `mean_edge` and `total_volume`
 * are sums, which depend on the number of ranks in their last digits; the rest does not.
 *
 *  Errors: CLEFT_ERROR_ARGUMENT if the part is of another rank or of another number of ranks, or if the parts are not
 *  those of one mesh. Then nothing is written to `out` on any rank. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_part_quality(cleft_context* context, const cleft_part* part,
                                                          const cleft_exchange* exchange,
                                                          cleft_quality* out) CLEFT_NOEXCEPT;
/** Measures the tetrahedra that the part owns. It needs no other rank. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_part_own_quality(cleft_context* context, const cleft_part* part,
                                                              cleft_quality* out) CLEFT_NOEXCEPT;

/** Returns the number of labels of the volume, the same on all ranks; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_part_label_count(const cleft_part* part) CLEFT_NOEXCEPT;
/** Gets what became of a label in the whole mesh, the same on all ranks. It needs no other rank. `index` counts from 0,
 *  in the order of cleft_volume_labels(). The numbers are those of cleft_report_label(), but:
 *
 *  - Nobody counts pieces across ranks. The six counts of components are -1, and so is `reserved`.
 *  - A label that the options leave out has no tetrahedra, and is not lost.
 *  - `mesh_volume` is a sum, which depends on the number of ranks in its last digits.
 *
 *  Errors: CLEFT_ERROR_ARGUMENT if there is no such label. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_part_label(const cleft_part* part, int64_t index,
                                                        cleft_label_report* out) CLEFT_NOEXCEPT;

/** Returns the points: 3 * points world coordinates. Borrowed. \since 0.1 */
CLEFT_API const double* cleft_part_points(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the number of each point in the whole mesh, ascending among a part's own and among the others. Borrowed.
 *  \since 0.1 */
CLEFT_API const int64_t* cleft_part_point_numbers(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the rank that owns each point. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_part_point_owners(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the tetrahedra: 4 * tets local point numbers, positively oriented, ghosts last. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_part_tets(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the label of each tetrahedron. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_part_tet_labels(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the number of each tetrahedron in the whole mesh, ascending among a part's own and among the ghosts.
 * Borrowed. \since 0.1 */
CLEFT_API const int64_t* cleft_part_tet_numbers(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the rank that owns each tetrahedron. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_part_tet_owners(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the triangles: 3 * triangles local point numbers. The normal of a triangle of an interface points from its
 *  first label to its second, that of the hull points outward. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_part_triangles(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the two labels of each triangle, 2 * triangles: the lesser one first. A triangle of the hull has one label
 *  twice. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_part_triangle_labels(const cleft_part* part) CLEFT_NOEXCEPT;
/** Returns the side of the box that each triangle lies in, as cleft_surface_hull_sides() has them, and -1 for those of
 *  interfaces. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_part_triangle_sides(const cleft_part* part) CLEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
