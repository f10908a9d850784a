/*
 * libcleft_io: the file component of libcleft. It reads volumes, and writes and reads meshes.
 *
 * The component builds on cleft.h alone and keeps its conventions: every fallible function returns a cleft_status, the
 * sentence about a failure is in cleft_context_last_error(), outputs come last and are NULL or untouched on failure.
 * docs/formats.md tells what each format holds.
 *
 * Writing is all or nothing: a file is written under a temporary name in the folder of its target, flushed to the disk
 * and then renamed. When that fails, what was there before is still there, and the temporary is removed.
 *
 * Paths are in the encoding of the file system. Lengths are in the unit of the file, for medical formats millimetres.
 */
#ifndef CLEFT_IO_H
#define CLEFT_IO_H

#include "cleft/cleft.h"

#if defined(_WIN32) && !defined(CLEFT_STATIC)
#ifdef CLEFT_IO_BUILDING_LIBRARY
#define CLEFT_IO_API __declspec(dllexport)
#else
#define CLEFT_IO_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define CLEFT_IO_API __attribute__((visibility("default")))
#else
#define CLEFT_IO_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------- formats -- */

/** Formats of meshes; the numbers never change. \since 0.1 */
typedef int32_t cleft_io_format;
enum {
    CLEFT_FORMAT_BY_NAME = 0, /**< by the extension of the path; ".msh" is written as 4.1 */
    CLEFT_FORMAT_VTU = 1,     /**< VTK XML, tetrahedra, binary, compressed */
    CLEFT_FORMAT_VTP = 2,     /**< VTK XML, interface triangles, binary, compressed */
    CLEFT_FORMAT_VTK = 3,     /**< VTK legacy, tetrahedra, text */
    CLEFT_FORMAT_MEDIT = 4,   /**< MEDIT .mesh, tetrahedra and triangles, text */
    CLEFT_FORMAT_MSH41 = 5,   /**< Gmsh 4.1, with physical groups, binary */
    CLEFT_FORMAT_MSH22 = 6,   /**< Gmsh 2.2, with physical groups, text */
    CLEFT_FORMAT_ABAQUS = 7,  /**< Abaqus and CalculiX .inp, with sets and surfaces, text */
    CLEFT_FORMAT_TETGEN = 8,  /**< TetGen .node, .ele and .face, text */
    CLEFT_FORMAT_STL = 9,     /**< STL of the interface triangles, binary, single precision by its nature */
    CLEFT_FORMAT_PLY = 10     /**< PLY of the interface triangles, binary, double precision */
};

/** What the component does with a format; bits. \since 0.1 */
enum { CLEFT_IO_READS_MESH = 1, CLEFT_IO_WRITES_MESH = 2, CLEFT_IO_READS_VOLUME = 4, CLEFT_IO_WRITES_SIZING = 8 };

/** One row of the table of formats. The caller sets struct_size to sizeof(cleft_io_format_description). All texts are
 *  static. \since 0.1 */
typedef struct cleft_io_format_description {
    uint32_t struct_size;
    cleft_io_format format; /**< CLEFT_FORMAT_..., 0 for formats of volumes */
    int32_t directions;     /**< CLEFT_IO_READS_... and CLEFT_IO_WRITES_... */
    int32_t reserved;
    const char* name;       /**< "msh22" */
    const char* extensions; /**< ".nii .nii.gz", separated by blanks */
    const char* text;       /**< what it holds */
} cleft_io_format_description;

/** Number of rows of the table. \since 0.1 */
CLEFT_IO_API int32_t cleft_io_format_count(void) CLEFT_NOEXCEPT;
/** Row `index` (0 ..) of the table. CLEFT_ERROR_ARGUMENT if there is no such row. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_format_info(int32_t index,
                                                               cleft_io_format_description* out) CLEFT_NOEXCEPT;

/** What a file most likely holds, by its name (and, where the name leaves it open, its first bytes). \since 0.1 */
enum {
    CLEFT_IO_UNKNOWN = 0, /**< neither a volume nor a mesh, as far as one can tell */
    CLEFT_IO_VOLUME = 1,  /**< a volume */
    CLEFT_IO_MESH = 2     /**< a mesh */
};
/** CLEFT_IO_VOLUME, CLEFT_IO_MESH or CLEFT_IO_UNKNOWN; never fails. A folder is a volume (a DICOM series). \since 0.1
 */
CLEFT_IO_API int32_t cleft_io_guess(const char* path) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------- volumes -- */

/** Directions of the world axes. Files keep one of the two; a mesh comes out in the one asked for. \since 0.1 */
typedef int32_t cleft_io_world;
enum {
    CLEFT_IO_WORLD_LPS = 0, /**< left, posterior, superior: ITK's, 3D Slicer's files, DICOM's; the default */
    CLEFT_IO_WORLD_RAS = 1  /**< right, anterior, superior: NIfTI's; the first two coordinates change their sign */
};

/** What the voxels of files mean. docs/formats.md tells how CLEFT_IO_KIND_AUTO decides, and what it refuses. \since 0.1
 */
typedef int32_t cleft_io_kind;
enum {
    /** By the values. One file: whole numbers are labels, also where they are up to 1/50 off; fractions on both sides
     * of 0 that change from voxel to voxel are a signed function. Several files or frames: 0 and one other whole number
     * each are masks; fractions are indicator functions. Anything else is refused. */
    CLEFT_IO_KIND_AUTO = 0,
    CLEFT_IO_KIND_LABELS = 1,    /**< labels: fractions are rounded to the nearest; or several masks */
    CLEFT_IO_KIND_INDICATORS = 2 /**< indicator functions, of any type of voxels */
};

/** How to read a volume. The caller sets struct_size to sizeof(cleft_io_reading) and the rest to 0 for the defaults.
 *  \since 0.1 */
typedef struct cleft_io_reading {
    uint32_t struct_size;
    cleft_io_world world;
    cleft_io_kind kind;
    int32_t reserved;  /**< 0 */
    double spacing[3]; /**< > 0: taken instead of the file's spacing along that axis of the voxels; 0: the file's. It is
                        *   not multiplied by `scale`. The origin stays as the file has it */
    double scale;      /**< > 0: the origin and the spacing of the file are multiplied by it, so that 0.001 makes metres
                        *   of millimetres; 0: 1. Anything else is CLEFT_ERROR_ARGUMENT */
} cleft_io_reading;

/** Reads a volume. `options` (may be NULL) are those of cleft_volume_create_labels(); `reading` may be NULL for the
 *  defaults.
 *
 *  One path: a label map, or a signed function (inside where > 0). Several paths, or the frames of a file with four
 *  dimensions: masks or indicator functions, in the order of their labels 0, 1, 2, ...; all must lie on the same grid.
 * Of masks a label map is made: a voxel of several goes to the first, and voxels of none become a label of their own,
 * the number of the masks. Which of these: see cleft_io_kind.
 *
 *  What was noticed about the files goes to the log callback as warnings, each a sentence: voxels that were rounded,
 * that no mask or several claim, that are equal in all functions, an origin that does not follow a new spacing. Names
 * that a file gives to its labels are set by cleft_volume_set_label_name().
 *
 *  A path may also be a folder with a DICOM series, or a series of slices with '*' and '?' (in the order of
 *  the numbers in their names) or one %d, %03d ... (counted from 0 or 1; none may be missing). A folder with several
 *  series is refused with the names of them all.
 *
 *  Spacing, origin and direction of the file are kept. Images of two dimensions become one voxel thick. TIFF, PNG,
 *  JPEG and BMP know nothing of the third dimension: their voxels are unit cubes unless `reading` tells the spacing.
 *  Refused with CLEFT_ERROR_FORMAT: more than one number a voxel (colours, vectors), labels outside int32_t, values
 * that may mean several things, spacings that are zero or not finite, direction axes that lie in a plane.
 *  CLEFT_ERROR_NOT_FINITE: a voxel that is not finite, with its place. CLEFT_ERROR_FILE: files that are not there,
 * cannot be read, or are in no known format. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_volume(cleft_context* context, const cleft_options* options,
                                                               const char* const* paths, int64_t count,
                                                               const cleft_io_reading* reading,
                                                               cleft_volume** out) CLEFT_NOEXCEPT;

/** How raw voxels lie in a file, x fastest. The caller sets struct_size to sizeof(cleft_io_raw). \since 0.1 */
typedef struct cleft_io_raw {
    uint32_t struct_size;
    cleft_type type;
    int32_t big_endian; /**< nonzero: most significant byte first */
    cleft_io_kind kind; /**< what the voxels mean */
    int64_t skip;       /**< bytes before the first voxel; what follows must be exactly the voxels */
    int64_t dims[3];    /**< voxels along x, y, z */
    double spacing[3];  /**< lengths of a voxel, all > 0; or all 0 for unit cubes */
} cleft_io_raw;

/** Reads files without a header. What they mean, by raw->kind, and what is told and refused, is as in
 *  cleft_io_read_volume(). The corner of the box is at the origin. The caller owns *out.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_raw(cleft_context* context, const cleft_options* options,
                                                            const char* const* paths, int64_t count,
                                                            const cleft_io_raw* raw, cleft_volume** out) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------- sizing fields -- */

/** Writes a sizing field as a volume of float, so that one can look at it: .nrrd, .nii, .nii.gz, .mha or .vtk, by the
 *  extension. `world` is the one in which the field's volume was read. NIfTI, MetaImage and VTK cannot hold a grid that
 *  is sheared (nor VTK one that is turned): CLEFT_ERROR_UNSUPPORTED. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_write_sizing(cleft_context* context, const cleft_sizing* sizing,
                                                                const char* path, cleft_io_world world) CLEFT_NOEXCEPT;

/** Reads a field of one number a voxel, of any type, from whatever cleft_io_read_volume() reads. `dims` and `affine`
 *  (index to world, as in cleft_volume_create_labels()) may be NULL. *values is x fastest, as in the file: a scale does
 *  not multiply the numbers. The caller gives it back to cleft_io_free(). \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_field(cleft_context* context, const char* path,
                                                              const cleft_io_reading* reading, int64_t dims[3],
                                                              double affine[12], double** values) CLEFT_NOEXCEPT;
/** Frees an array of cleft_io_read_field(); NULL is allowed. \since 0.1 */
CLEFT_IO_API void cleft_io_free(void* array) CLEFT_NOEXCEPT;

/** Reads the user's own sizing field from a file and makes a cleft_sizing of it by cleft_sizing_create_values(). The
 *  file must have as many voxels along each axis as the volume, at the same places within a hundredth of a voxel:
 *  CLEFT_ERROR_ARGUMENT if not. `reading` (may be NULL) must name the world in which the volume was read; its scale
 *  multiplies the edge lengths in the file, too. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_sizing(cleft_context* context, const cleft_volume* volume,
                                                               const char* path, const cleft_io_reading* reading,
                                                               int32_t combine, const cleft_options* options,
                                                               cleft_sizing** out) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- meshes -- */

/** Writes a mesh, in the format given or in that of the path's extension. Coordinates keep all their digits (but for
 *  STL). TetGen's format writes PREFIX.node, PREFIX.ele and PREFIX.face, PREFIX being the path without such an
 *  extension: all three or none. Formats of surfaces (VTP, STL, PLY) hold the triangles between labels and, for a mesh
 *  that does not fill its box, those of the hull inside the box.
 *  CLEFT_ERROR_FILE if the file cannot be written (the message names why: no such folder, no permission, disk full),
 *  CLEFT_ERROR_ARGUMENT if the format is not known. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_write_mesh(cleft_context* context, const cleft_mesh* mesh,
                                                              const char* path, cleft_io_format format) CLEFT_NOEXCEPT;

/** Reads a mesh of tetrahedra by the extension of its path: .vtu, .vtk (text), .mesh (text), .msh (2.2 and 4.1, text
 *  and binary), .node/.ele. The labels are the cell array "material" (else the first array of whole numbers), the
 *  reference, the physical group (else the entity) or the first attribute; 0 if there are none. Elements of lower
 *  dimension are passed over; other elements of three dimensions are CLEFT_ERROR_UNSUPPORTED. Malformed files are
 *  CLEFT_ERROR_FORMAT, with the line in the message where the file is text. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_mesh(cleft_context* context, const char* path,
                                                             cleft_mesh** out) CLEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
