/*
 * libcleft_io is the file component of libcleft. It reads volumes, writes and reads meshes, and writes pages that show
 * them.
 *
 * The component uses cleft.h alone and keeps its conventions. Every function that can fail returns a cleft_status.
 * cleft_context_last_error() returns the sentence about a failure. Output arguments come last and are NULL or unchanged
 * on failure. docs/formats.md describes what each format contains.
 *
 * Writing is all or nothing. The component writes a temporary file in the folder of the target, flushes it to the disk
 * and renames it. If that fails, it removes the temporary file and leaves an existing target unchanged.
 *
 * Paths are in the encoding of the file system. Lengths are in the unit of the file; in medical formats that is the
 * millimetre.
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

/** Formats of meshes; their numbers never change. \since 0.1 */
typedef int32_t cleft_io_format;
enum {
    CLEFT_FORMAT_BY_NAME = 0, /**< by the extension of the path; ".msh" means Gmsh 4.1 */
    CLEFT_FORMAT_VTU = 1,     /**< VTK XML, tetrahedra, binary, compressed */
    CLEFT_FORMAT_VTP = 2,     /**< VTK XML, interface triangles, binary, compressed */
    CLEFT_FORMAT_VTK = 3,     /**< VTK legacy, tetrahedra, text */
    CLEFT_FORMAT_MEDIT = 4,   /**< MEDIT .mesh, tetrahedra and triangles, text */
    CLEFT_FORMAT_MSH41 = 5,   /**< Gmsh 4.1, with physical groups, binary */
    CLEFT_FORMAT_MSH22 = 6,   /**< Gmsh 2.2, with physical groups, text */
    CLEFT_FORMAT_ABAQUS = 7,  /**< Abaqus and CalculiX .inp, with sets and surfaces, text */
    CLEFT_FORMAT_TETGEN = 8,  /**< TetGen .node, .ele and .face, text */
    CLEFT_FORMAT_STL = 9,     /**< STL of the interface triangles, binary, always single precision */
    CLEFT_FORMAT_PLY = 10,    /**< PLY of the interface triangles, binary, double precision */
    CLEFT_FORMAT_VTKHDF = 11, /**< VTKHDF, tetrahedra; read only, cleft_mpi_write() writes it */
    CLEFT_FORMAT_PVTU = 12    /**< VTK XML in pieces, .pvtu; read only, cleft_mpi_write() writes it */
};

/** What the component can do with a format, as bits. \since 0.1 */
enum { CLEFT_IO_READS_MESH = 1, CLEFT_IO_WRITES_MESH = 2, CLEFT_IO_READS_VOLUME = 4, CLEFT_IO_WRITES_SIZING = 8 };

/** One row of the table of formats. The caller sets struct_size to sizeof(cleft_io_format_description). All texts are
 *  static. \since 0.1 */
typedef struct cleft_io_format_description {
    uint32_t struct_size;
    cleft_io_format format; /**< CLEFT_FORMAT_..., or 0 for a format of volumes */
    int32_t directions;     /**< bits CLEFT_IO_READS_... and CLEFT_IO_WRITES_... */
    int32_t reserved;
    const char* name;       /**< "msh22" */
    const char* extensions; /**< extensions, separated by blanks: ".nii .nii.gz" */
    const char* text;       /**< what the format contains */
} cleft_io_format_description;

/** Returns the number of rows of the table of formats. \since 0.1 */
CLEFT_IO_API int32_t cleft_io_format_count(void) CLEFT_NOEXCEPT;
/** Gets row `index` of the table of formats, from 0. CLEFT_ERROR_ARGUMENT if there is no such row. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_format_info(int32_t index,
                                                               cleft_io_format_description* out) CLEFT_NOEXCEPT;

/** What a file most likely contains. \since 0.1 */
enum {
    CLEFT_IO_UNKNOWN = 0, /**< neither a volume nor a mesh, as far as the name and first bytes show */
    CLEFT_IO_VOLUME = 1,  /**< a volume */
    CLEFT_IO_MESH = 2     /**< a mesh */
};
/** Returns CLEFT_IO_VOLUME, CLEFT_IO_MESH or CLEFT_IO_UNKNOWN, and never fails. It decides by the name, and by the
 *  first bytes if the name is not enough. A folder is a volume: a DICOM series. \since 0.1 */
CLEFT_IO_API int32_t cleft_io_guess(const char* path) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------- volumes -- */

/** Directions of the world axes. A file uses one of the two. A volume, and so its mesh, gets the one that the caller
 *  asks for. \since 0.1 */
typedef int32_t cleft_io_world;
enum {
    CLEFT_IO_WORLD_LPS = 0, /**< left, posterior, superior, as in ITK, DICOM and files of 3D Slicer; the default */
    CLEFT_IO_WORLD_RAS = 1  /**< right, anterior, superior, as in NIfTI: x and y have the opposite sign */
};

/** The meaning of the voxels of files. docs/formats.md describes how CLEFT_IO_KIND_AUTO decides, and what it refuses.
 *  \since 0.1 */
typedef int32_t cleft_io_kind;
enum {
    /** By the values. In one file, whole numbers (within 1/50) are labels. Fractions on both sides of 0 that change
     *  from voxel to voxel are a signed function. In several files or frames, 0 and one other whole number each are
     *  masks. Fractions are indicator functions. The component refuses anything else. */
    CLEFT_IO_KIND_AUTO = 0,
    CLEFT_IO_KIND_LABELS = 1,    /**< labels, fractions rounded to the nearest; or several masks */
    CLEFT_IO_KIND_INDICATORS = 2 /**< indicator functions, from any type of voxels */
};

/** How to read a volume. The caller sets struct_size to sizeof(cleft_io_reading) and the rest to 0 for the defaults.
 *  \since 0.1 */
typedef struct cleft_io_reading {
    uint32_t struct_size;
    cleft_io_world world;
    cleft_io_kind kind;
    int32_t reserved;  /**< 0 */
    double spacing[3]; /**< > 0: replaces the spacing of the file along that axis of the voxels; 0: that of the file.
                        *   `scale` does not multiply it. The origin stays that of the file */
    double scale;      /**< > 0: multiplies the origin and spacing of the file; 0.001 turns millimetres into metres.
                        *   0 means 1. Anything else is CLEFT_ERROR_ARGUMENT */
} cleft_io_reading;

/** Reads a volume. `options` are those of cleft_volume_create_labels(). `options` and `reading` may be NULL for the
 *  defaults.
 *
 *  One path gives a label map or a signed function, which is > 0 inside. Several paths, or the frames of one file
 *  with four dimensions, give masks or indicator functions. Their order is that of their labels 0, 1, 2, ..., and all
 *  must have the same grid. cleft_io_kind describes how the component tells these apart.
 *
 *  Masks become a label map. A voxel in several masks goes to the first one. Voxels in no mask get a label of their
 *  own: the number of masks.
 *
 *  A path may also name a series. A folder holds a DICOM series. A pattern with '*' and '?' names slices, in the
 *  order of the numbers in their names. A pattern with one %d, %03d, ... counts from 0 or 1, and no slice may be
 *  missing. The component refuses a folder with several series and names them all.
 *
 *  The volume has the spacing, origin and direction of the file. An image of two dimensions becomes one voxel thick.
 *  TIFF, PNG, JPEG and BMP have no third dimension: their voxels are unit cubes unless `reading` gives the spacing.
 *  If a file names its labels, the volume has these names; see cleft_volume_label_name().
 *
 *  The log callback gets one warning per finding about the files. Findings are voxels that were rounded, that are in
 *  no mask or in several, or that have the same value in all functions. Another is an origin that does not fit a new
 *  spacing.
 *
 *  Errors:
 *  - CLEFT_ERROR_FORMAT for more than one number per voxel (colours, vectors), labels outside int32_t, and values with
 *    more than one possible meaning. Also for spacings that are zero or not finite, and direction axes in one plane.
 *  - CLEFT_ERROR_NOT_FINITE for a voxel that is not finite; the message gives its place.
 *  - CLEFT_ERROR_FILE for files that do not exist, cannot be read, or are in no known format.
 *
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_volume(cleft_context* context, const cleft_options* options,
                                                               const char* const* paths, int64_t count,
                                                               const cleft_io_reading* reading,
                                                               cleft_volume** out) CLEFT_NOEXCEPT;

/** The layout of raw voxels in a file, x fastest. The caller sets struct_size to sizeof(cleft_io_raw). \since 0.1 */
typedef struct cleft_io_raw {
    uint32_t struct_size;
    cleft_type type;
    int32_t big_endian; /**< nonzero: most significant byte first */
    cleft_io_kind kind; /**< what the voxels mean */
    int64_t skip;       /**< bytes before the first voxel; the rest of the file must be exactly the voxels */
    int64_t dims[3];    /**< voxels along x, y, z */
    double spacing[3];  /**< spacings along x, y, z, all > 0; or all 0 for unit cubes */
} cleft_io_raw;

/** Reads a volume from files without a header. raw->kind gives the meaning of the voxels. Warnings and errors are
 *  those of cleft_io_read_volume(). The corner of the box is at the origin. `options` may be NULL. The caller owns
 *  *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_raw(cleft_context* context, const cleft_options* options,
                                                            const char* const* paths, int64_t count,
                                                            const cleft_io_raw* raw, cleft_volume** out) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------- sizing fields -- */

/** Writes a sizing field as a volume of float for viewers: .nrrd, .nii, .nii.gz, .mha or .vtk, by the extension.
 *  `world` must be the one in which the field's volume was read. CLEFT_ERROR_UNSUPPORTED if the grid is sheared and
 *  the format is NIfTI, MetaImage or VTK, or if it is rotated and the format is VTK.
 *
 *  Of a field with a metric, the file has the tensors: a 3D-symmetric-matrix in .nrrd, TENSORS in .vtk. They are in the
 *  coordinates of the file. CLEFT_ERROR_UNSUPPORTED for other formats. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_write_sizing(cleft_context* context, const cleft_sizing* sizing,
                                                                const char* path, cleft_io_world world) CLEFT_NOEXCEPT;

/** Reads a field of one number per voxel, of any type, from any file that cleft_io_read_volume() reads. `reading` may
 *  be NULL. `dims` gets the number of voxels along each axis, and `affine` the map from indices to world coordinates,
 *  as in cleft_volume_create_labels(). Both may be NULL.
 *
 *  *values gets the numbers of the file, x fastest; `scale` does not multiply them. The caller must pass *values to
 *  cleft_io_free(). \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_field(cleft_context* context, const char* path,
                                                              const cleft_io_reading* reading, int64_t dims[3],
                                                              double affine[12], double** values) CLEFT_NOEXCEPT;
/** Frees an array that cleft_io_read_field() returned; NULL is allowed. \since 0.1 */
CLEFT_IO_API void cleft_io_free(void* array) CLEFT_NOEXCEPT;

/** Reads a user-supplied sizing field from a file. It does the work of cleft_io_read_field() and
 *  cleft_sizing_create_values(); `combine` and `options` are those of the latter. CLEFT_ERROR_ARGUMENT if the file
 *  does not have the voxels of the volume: as many along each axis, at the same places within a hundredth of a voxel.
 *
 *  `reading` may be NULL. It must name the world in which the volume was read. Its scale multiplies the edge lengths
 *  in the file too. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_sizing(cleft_context* context, const cleft_volume* volume,
                                                               const char* path, const cleft_io_reading* reading,
                                                               int32_t combine, const cleft_options* options,
                                                               cleft_sizing** out) CLEFT_NOEXCEPT;

/** The order of the numbers of a symmetric tensor in a file. \since 0.1 */
typedef int32_t cleft_io_tensor_order;
enum {
    CLEFT_IO_ORDER_FILE = 0, /**< as the file says; six numbers of which it says nothing are refused */
    CLEFT_IO_ORDER_NRRD = 1, /**< that of NRRD and of this library: xx, xy, xz, yy, yz, zz */
    CLEFT_IO_ORDER_VTK = 2,  /**< that of VTK: xx, yy, zz, xy, yz, xz */
    CLEFT_IO_ORDER_NIFTI = 3 /**< that of NIfTI, MEDIT and mmg: xx, xy, yy, xz, yz, zz */
};

/** Reads a user-supplied metric from a file, and makes a sizing field of it as cleft_sizing_create_metric() does.
 *  `combine` and `options` are those of that function. The file has six numbers a voxel, seven with a mask before them
 *  (NRRD), or all nine. It is NRRD, NIfTI, or VTK (legacy or .vti); docs/formats.md says how tensors stand in each.
 *
 *  CLEFT_ERROR_ARGUMENT if the file does not have the voxels of the volume, as in cleft_io_read_sizing(). If `volume`
 *  is NULL, the field is on the grid of the file.
 *
 *  The tensors are in the coordinates of the file, or in its measurement frame (NRRD). `reading` may be NULL. It must
 *  name the world in which the volume was read. Its scale multiplies the lengths that the metric asks for.
 *
 *  CLEFT_ERROR_FORMAT if the order is FILE and the file does not say it, or if nine numbers are not symmetric; the
 *  sentence names the voxel. Tensors that are no metric are refused as in cleft_sizing_create_metric(). The caller owns
 *  *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_metric(cleft_context* context, const cleft_volume* volume,
                                                               const char* path, const cleft_io_reading* reading,
                                                               cleft_io_tensor_order order, int32_t combine,
                                                               const cleft_options* options,
                                                               cleft_sizing** out) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- meshes -- */

/** Writes a mesh in the given format, or in that of the extension of the path. Coordinates keep all their digits,
 *  except in STL.
 *
 *  TetGen's format has three files: PREFIX.node, PREFIX.ele and PREFIX.face. PREFIX is the path without such an
 *  extension. The function writes all three or none. Formats of surfaces (VTP, STL, PLY) get the triangles between
 *  labels. If the mesh does not fill its box, they also get the hull triangles inside the box.
 *
 *  CLEFT_ERROR_FILE if the file cannot be written; the message gives the reason, such as a missing folder, missing
 *  permission or a full disk. CLEFT_ERROR_ARGUMENT if the format is unknown. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_write_mesh(cleft_context* context, const cleft_mesh* mesh,
                                                              const char* path, cleft_io_format format) CLEFT_NOEXCEPT;

/** Reads a mesh of tetrahedra. The extension of the path gives the format: .vtu, .vtk (text), .mesh (text), .msh (2.2
 *  and 4.1, text and binary), .vtkhdf or .hdf (VTKHDF), .pvtu with its pieces, .node or .ele.
 *
 *  In VTK formats the labels are the cell array "material", else the first array of whole numbers. If a VTKHDF file has
 *  several partitions, points of different ones with the same coordinates become one. In MEDIT they are
 *  the references, in Gmsh the physical groups, else the entities, and in TetGen the first attribute. They are 0 if
 *  the file has none.
 *
 *  The function ignores elements of lower dimension. It returns CLEFT_ERROR_UNSUPPORTED for other three-dimensional
 *  elements, and CLEFT_ERROR_FORMAT for a malformed file. In text files the message names the line. The caller owns
 *  *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_mesh(cleft_context* context, const char* path,
                                                             cleft_mesh** out) CLEFT_NOEXCEPT;

/* --------------------------------------------------------------------------------------------------- names -- */

/** Names the labels of a volume by a table. A table has a label and its name on each line. Label descriptions of
 *  ITK-SNAP, colour tables of FreeSurfer, tables of MRIcron and those of BIDS are read too (docs/formats.md). Labels
 *  that are not in the table keep their names, and names of other labels are left out.
 *
 *  The function warns if the table names no label of the volume, or calls labels otherwise than the volume did. It also
 *  warns if the table has two names for a label, or may have another form than it is taken for.
 *
 *  CLEFT_ERROR_FILE if the table cannot be read. CLEFT_ERROR_FORMAT if it is malformed; the message names the line.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_volume_names(cleft_context* context, const char* path,
                                                                     cleft_volume* volume) CLEFT_NOEXCEPT;
/** Names the labels of a mesh by a table, as cleft_io_read_volume_names() names those of a volume. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_read_mesh_names(cleft_context* context, const char* path,
                                                                   cleft_mesh* mesh) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------ pictures -- */

/** What gives a tetrahedron its colour. \since 0.1 */
typedef int32_t cleft_io_colouring;
enum {
    CLEFT_IO_BY_LABEL = 0, /**< its label, which has the same colour in every mesh */
    CLEFT_IO_BY_ANGLE = 1, /**< its least dihedral angle, from 0 to 70 degrees */
    CLEFT_IO_BY_RATIO = 2, /**< its radius ratio, from 1 (the regular tetrahedron) to 4 */
    CLEFT_IO_BY_SIZE = 3   /**< its mean edge, from the least to the greatest that are drawn, by factors */
};

/** What is behind the mesh. \since 0.1 */
typedef int32_t cleft_io_backdrop;
enum {
    CLEFT_IO_BACKDROP_LIGHT = 0, /**< white */
    CLEFT_IO_BACKDROP_DARK = 1,  /**< nearly black */
    CLEFT_IO_BACKDROP_NONE = 2   /**< nothing: the picture is transparent there */
};

/** How a picture shows a mesh. The caller sets struct_size to sizeof(cleft_io_picture) and the rest to 0 for the
 *  defaults. Any other value is CLEFT_ERROR_ARGUMENT. \since 0.1 */
typedef struct cleft_io_picture {
    uint32_t struct_size;
    cleft_io_colouring by;
    int32_t width;  /**< pixels, 1 to 8192; 0: 1200 */
    int32_t height; /**< pixels, 1 to 8192; 0: 900 */
    cleft_io_backdrop backdrop;
    int32_t no_edges;  /**< nonzero: the edges of the tetrahedra are not drawn */
    int32_t legend;    /**< nonzero: the labels or the measure are explained at the right */
    int32_t reserved;  /**< 0 */
    double cut[3];     /**< 0 to 1: where the mesh is cut across x, y and z, as a share of its box; 0: not. Whole
                        *   tetrahedra are taken away on the side of the eye, those in front of all cuts */
    double view[3];    /**< the direction from the mesh to the eye; (0, 0, 0): (-0.5, -1, 0.6) */
    double up[3];      /**< the direction that is upwards; (0, 0, 0): z, or y where the eye looks along z */
    double zoom;       /**< 1 to fill the picture, up to 50; 0: 1 */
    double line_width; /**< of edges in pixels, up to 100; 0: 1. Lines of small triangles are paler */
    double range[2];   /**< the measures at the ends of the colours; both 0: those of cleft_io_colouring */
} cleft_io_picture;

/** Draws a mesh and writes the picture as PNG, without a screen. `strip` lists labels that are not drawn, and `whole`
 *  labels that are not cut. Both may be NULL if their number is 0. `picture` may be NULL for the defaults.
 *  Warnings name listed labels that the mesh does not have and names that the letters of the legend cannot show, and
 * say that all sizes are one.
 *
 *  The pixels are the same on every machine and for any number of threads. The bytes of the file are the same for the
 *  same version of zlib, which compresses them. The call reports its progress, and can be cancelled.
 *
 *  CLEFT_ERROR_ARGUMENT if the extension of the path is not .png, or if nothing would be drawn. CLEFT_ERROR_FILE if
 *  the file cannot be written. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_write_picture(cleft_context* context, const cleft_mesh* mesh,
                                                                 const int32_t* strip, int64_t strip_count,
                                                                 const int32_t* whole, int64_t whole_count,
                                                                 const cleft_io_picture* picture,
                                                                 const char* path) CLEFT_NOEXCEPT;

/* --------------------------------------------------------------------------------------------------- views -- */

/** What a page that shows a mesh has besides. The caller sets struct_size to sizeof(cleft_io_view) and the rest to 0
 * for the defaults. Texts are UTF-8; what is not is replaced. \since 0.1 */
typedef struct cleft_io_view {
    uint32_t struct_size;
    int32_t reserved;   /**< 0 */
    int64_t max_tets;   /**< tetrahedra that the page has of a mesh; 0: 3,000,000. Of a larger mesh it has those at
                         *   interfaces and the hull, or the middle of these if they are too many, and says so */
    double goal;        /**< the least dihedral angle that was wanted, in degrees; 0: as the report says, else 25 */
    const char* title;  /**< what the mesh is called; NULL: "Mesh" */
    const char* report; /**< the report of `cleft mesh --json`, as text; NULL: none */
    const char* names;  /**< path of a table of the names of labels; NULL: the names of the mesh */
    const cleft_mesh* other;  /**< a second mesh to compare with, which must live until the call ends; NULL: none */
    const char* other_title;  /**< what the second mesh is called */
    const char* other_report; /**< the report of the second mesh */
} cleft_io_view;

/** Writes a page of HTML that shows the mesh in any browser. It is one file, which needs no network and no other file.
 *  It has the materials, cuts through the mesh, the shapes and the worst of its tetrahedra. `view` may be NULL for the
 *  defaults. The call reports its progress, and can be cancelled. Warnings tell of a mesh that is shown in part, and of
 *  two meshes that lie in different places.
 *
 *  A table of names is one of cleft_io_read_mesh_names(). Labels that are not in the table keep the names of the mesh.
 *
 *  CLEFT_ERROR_FILE if the page cannot be written or the table cannot be read. CLEFT_ERROR_FORMAT if the table is
 *  malformed; the message names the line. CLEFT_ERROR_ARGUMENT if the mesh has no tetrahedra, or if the longest
 *  side of its box is beyond 1e-30 to 1e30. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_write_view(cleft_context* context, const cleft_mesh* mesh,
                                                              const cleft_io_view* view,
                                                              const char* path) CLEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
