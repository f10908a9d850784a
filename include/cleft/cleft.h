/*
 * libcleft: conforming multi-material tetrahedral meshes from labelled volumes, by mesh cleaving.
 *
 * This header is the reference manual. The flow of data, one call an arrow:
 *
 *     volume --> sizing --> background --> cleave --> improve --> mesh arrays
 *
 * and cleft_mesh_volume() does them all.
 *
 * Conventions
 *  - Every fallible function returns a cleft_status: CLEFT_OK (0) or a fixed negative number. What went wrong, in one
 *    sentence that names the value, is in cleft_context_last_error(). Functions that take no context leave no sentence
 *    (those of options leave it in cleft_options_last_error()): cleft_status_string() has the words for their status.
 *    Outputs come last and are set to NULL (or left untouched, for numbers and buffers) on failure: there is never half
 *    a result.
 *  - Handles are opaque. `_create` gives a handle that the caller owns and gives back to `_destroy`; `_destroy` takes
 *    NULL. Handles other than contexts and options are immutable once made and may be read from many threads at once,
 *    also after the context that made them is gone. (Names of labels are the one exception: set them before.)
 *  - A context has one call at a time. While one runs, others on the same context, from other threads or from its
 *    callbacks, get CLEFT_ERROR_BUSY, which leaves no sentence. A callback may use cleft_context_cancel(), _threads(),
 *    _last_error() and the metrics of its context. What a callback destroys lives until the call that uses it ends.
 *    Otherwise a handle must not be used once it is destroyed: that is not found out.
 *  - Structs begin with struct_size, which the caller sets to sizeof. They grow at their end only, so that programs and
 *    libraries of different ages work together. A library fills in the fields that the caller has; it leaves those that
 *    it does not know as they were, and takes those that the caller lacks for 0. CLEFT_ERROR_ARGUMENT: a struct_size of
 *    0, or less than the struct had in the release that brought it; an unknown field of an input that is not 0.
 *  - The library has no global or thread-local state and prints nothing.
 *  - Arrays that come in are copied. Arrays that go out are either borrowed (`const` pointers, valid until the handle
 *    is destroyed; NULL if there are no elements) or copied into the caller's buffer (`_copy_`).
 *  - Counts are int64_t. Point numbers are int32_t, from 0 unless a function takes an index base. Coordinates are
 *    double, interleaved x y z. Labels (materials) are int32_t, the user's own values.
 *  - Sentences count from the first: "the 3rd point" is point 2 of an array that begins at 0.
 *  - Lengths are in the unit of the volume's world coordinates. Results are the same bytes for every thread count.
 *
 * Limits
 *  - A volume: up to 2,147,483,647 voxels and 65,535 labels; spacings within 1e-15 to 1e15, the greatest no more than
 *    1,000 times the least; world coordinates of its box up to 1e14 times the least distance between planes of voxels;
 *    an affine whose columns, each divided by its length, have a determinant of 1e-6 or more in magnitude. Beyond:
 *    CLEFT_ERROR_ARGUMENT or CLEFT_ERROR_TOO_LARGE.
 *  - Sizes: within 1e-30 to 1e30. Those that ask for more than memory or 32-bit numbering hold: CLEFT_ERROR_TOO_LARGE.
 *  - Indicator functions: finite; values beyond 1e30 in magnitude stand for "far away", see
 *    cleft_volume_create_indicators().
 *  - A mesh that is given to be cleaved or improved is validated whole first: CLEFT_ERROR_INVALID_MESH.
 *  - A mesh that is given back has been checked: finite coordinates, no two points at one place, every tetrahedron
 *    positively oriented by an exact predicate. Where the numbers of a world far from the origin cannot hold a mesh so,
 *    the call fails with CLEFT_ERROR_ARGUMENT. Anything else that goes wrong is CLEFT_ERROR_INTERNAL, never a bad mesh.
 *    The whole validation is cleft_mesh_validate().
 */
#ifndef CLEFT_H
#define CLEFT_H

#include <stddef.h>
#include <stdint.h>

#include "cleft/cleft_status.h"

#if defined(_WIN32) && !defined(CLEFT_STATIC)
#ifdef CLEFT_BUILDING_LIBRARY
#define CLEFT_API __declspec(dllexport)
#else
#define CLEFT_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define CLEFT_API __attribute__((visibility("default")))
#else
#define CLEFT_API
#endif

/* The status is to be looked at: compilers warn where it is not. */
#if (defined(__cplusplus) && __cplusplus >= 201703L) || (defined(__STDC_VERSION__) && __STDC_VERSION__ > 201710L)
#define CLEFT_NODISCARD [[nodiscard]]
#elif defined(__GNUC__)
#define CLEFT_NODISCARD __attribute__((warn_unused_result))
#else
#define CLEFT_NODISCARD
#endif

#ifdef __cplusplus
#define CLEFT_NOEXCEPT noexcept
extern "C" {
#else
#define CLEFT_NOEXCEPT
#endif

/* ------------------------------------------------------------------------------------------------- version -- */

#define CLEFT_VERSION_MAJOR 0
#define CLEFT_VERSION_MINOR 1
#define CLEFT_VERSION_PATCH 0
#define CLEFT_VERSION_STRING "0.1.0"

/** The version of the library that runs, as "major.minor.patch"; static text. Any of the outputs may be NULL.
 *  \since 0.1 */
CLEFT_API const char* cleft_version(int32_t* major, int32_t* minor, int32_t* patch) CLEFT_NOEXCEPT;

/** Static text for a status code; "unknown status" for a number that is none. \since 0.1 */
CLEFT_API const char* cleft_status_string(cleft_status status) CLEFT_NOEXCEPT;

/** Can this build make Delaunay backgrounds (is TetGen in it)? 1 or 0. \since 0.1 */
CLEFT_API int32_t cleft_has_tetgen(void) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------- handles -- */

typedef struct cleft_context cleft_context; /**< errors, callbacks, threads, metrics; one thread at a time */
typedef struct cleft_options cleft_options; /**< how to mesh */
typedef struct cleft_volume cleft_volume;   /**< the labelled volume or the indicator functions */
typedef struct cleft_sizing cleft_sizing;   /**< the wanted edge length at each point */
typedef struct cleft_mesh cleft_mesh;       /**< points, tetrahedra, materials; a background has material 0 only */
typedef struct cleft_surface cleft_surface; /**< the interface and hull triangles of a mesh */
typedef struct cleft_report cleft_report;   /**< what became of each label */

/* ------------------------------------------------------------------------------------------------- context -- */

/** Makes a context with one thread, no callbacks. The caller owns *out. Fails only for want of memory or a NULL `out`.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_create(cleft_context** out) CLEFT_NOEXCEPT;
/** Destroys a context; NULL is allowed. Handles made with it live on. \since 0.1 */
CLEFT_API void cleft_context_destroy(cleft_context* context) CLEFT_NOEXCEPT;

/** The sentence of the last failure on this context, "" if there was none; borrowed until the next call on the
 *  context. \since 0.1 */
CLEFT_API const char* cleft_context_last_error(const cleft_context* context) CLEFT_NOEXCEPT;
/** Puts a sentence on the context and returns `status` (or CLEFT_ERROR_BUSY): for components that build on this
 * library. \since 0.1 */
CLEFT_API cleft_status cleft_context_set_error(cleft_context* context, cleft_status status,
                                               const char* sentence) CLEFT_NOEXCEPT;

/** Threads to use, 1 .. 1024; 0 means as many as the machine has. The result does not depend on it. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_set_threads(cleft_context* context,
                                                                 int32_t threads) CLEFT_NOEXCEPT;
/** The number of threads in use; 0 for NULL. \since 0.1 */
CLEFT_API int32_t cleft_context_threads(const cleft_context* context) CLEFT_NOEXCEPT;

/** fraction in [0, 1] of the running call, `stage` in words (borrowed for the call); a nonzero answer cancels. The
 *  fraction never falls, and the last one of a call that succeeds is 1. Always
 *  called on the thread that called the library, mostly ten times a second or more, at times with the same fraction
 *  again; TetGen's part, seconds for millions of tetrahedra, cannot be interrupted. \since 0.1 */
typedef int (*cleft_progress_callback)(double fraction, const char* stage, void* user);
/** Sets or (NULL) removes the progress callback. `user` is passed through. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_set_progress(cleft_context* context,
                                                                  cleft_progress_callback callback,
                                                                  void* user) CLEFT_NOEXCEPT;

/** How much a sentence of the log matters. \since 0.1 */
enum {
    CLEFT_LOG_WARNING = 1, /**< something may not be as intended */
    CLEFT_LOG_INFO = 2,    /**< good to know */
    CLEFT_LOG_DEBUG = 3    /**< for those who look for a fault */
};
/** `sentence` is borrowed for the call. Called on the thread that called the library. \since 0.1 */
typedef void (*cleft_log_callback)(int32_t level, const char* sentence, void* user);
/** Sets or (NULL) removes the log callback. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_set_log(cleft_context* context, cleft_log_callback callback,
                                                             void* user) CLEFT_NOEXCEPT;

/** Hands a sentence to the log callback, if there is one: for components that build on this library. `level` is one of
 *  CLEFT_LOG_WARNING ... CLEFT_LOG_DEBUG, else CLEFT_ERROR_ARGUMENT. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_log(cleft_context* context, int32_t level,
                                                         const char* sentence) CLEFT_NOEXCEPT;

/** For components that build on this library: what they do until cleft_context_end() is one call of the context. Other
 *  threads and callbacks get CLEFT_ERROR_BUSY meanwhile, and the context and the `count` handles (or NULL) of any kind
 *  live on if a callback destroys them. Begins like any call: the last sentence and requests to cancel are forgotten.
 *  May be nested. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_begin(cleft_context* context, const void* const* handles,
                                                           int64_t count) CLEFT_NOEXCEPT;
/** Ends what cleft_context_begin() began, on the same thread. \since 0.1 */
CLEFT_API void cleft_context_end(cleft_context* context) CLEFT_NOEXCEPT;

/** Asks the call that runs on this context to stop soon with CLEFT_ERROR_CANCELLED; from any thread. A request made
 *  while nothing runs is forgotten when the next call begins. \since 0.1 */
CLEFT_API cleft_status cleft_context_cancel(cleft_context* context) CLEFT_NOEXCEPT;

/** Figures that the stages noted on this context (seconds, counts, angles before and after ...), in the order in which
 *  they were first noted. A later call overwrites figures of the same name. \since 0.1 */
CLEFT_API int64_t cleft_context_metric_count(const cleft_context* context) CLEFT_NOEXCEPT;
/** Figure number `index`; `name` is borrowed until the next call on the context. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_metric(const cleft_context* context, int64_t index,
                                                            const char** name, double* value) CLEFT_NOEXCEPT;
/** Forgets all figures. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_clear_metrics(cleft_context* context) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------- options -- */

/** Keys of options; the numbers never change. What each means, its default and its range are in the table that
 *  cleft_option_info() reads (and `cleft mesh --help` prints). \since 0.1 */
typedef int32_t cleft_option;
/* <options> Made by tools/generate.py from src/capi/options.toml. */
enum {
    CLEFT_OPTION_BACKGROUND = 1,
    CLEFT_OPTION_SIZE = 2,
    CLEFT_OPTION_SIZE_MIN = 3,
    CLEFT_OPTION_SIZE_MAX = 4,
    CLEFT_OPTION_FEATURE_SCALE = 5,
    CLEFT_OPTION_GRADATION = 6,
    CLEFT_OPTION_INTERFACE_SIZE = 7,
    CLEFT_OPTION_TETS = 8,
    CLEFT_OPTION_SMOOTH = 9,
    CLEFT_OPTION_SNAP = 10,
    CLEFT_OPTION_IMPROVE = 11,
    CLEFT_OPTION_STEPS = 12,
    CLEFT_OPTION_SEED = 13,
    CLEFT_OPTION_STRICT = 14,
    CLEFT_OPTION_REPAIR = 15,
    CLEFT_OPTION_MAX_TETS = 16,
    CLEFT_OPTION_KEEP_THIN = 17
};

/** Kinds of background meshes. \since 0.1 */
enum {
    CLEFT_BACKGROUND_PARTICLES = 0, /**< relaxed particles and their Delaunay tetrahedra: the best shapes */
    CLEFT_BACKGROUND_LATTICE = 1,   /**< a regular lattice: quick, one size everywhere */
    CLEFT_BACKGROUND_OCTREE = 2     /**< an adaptive lattice */
};
/** Rules that move background points onto interfaces. \since 0.1 */
enum {
    CLEFT_SNAP_QUALITY = 0, /**< by the quality of the elements around */
    CLEFT_SNAP_SAFE = 1,    /**< by the safe distances of the paper */
    CLEFT_SNAP_NONE = 2     /**< never */
};
/** Effort spent on the worst dihedral angles. \since 0.1 */
enum {
    CLEFT_IMPROVE_OFF = 0,  /**< none */
    CLEFT_IMPROVE_FAST = 1, /**< some: the default */
    CLEFT_IMPROVE_BEST = 2  /**< as much as helps */
};
/* </options> */

/** What values an option takes. \since 0.1 */
enum {
    CLEFT_OPTION_TYPE_INTEGER = 1, /**< whole numbers */
    CLEFT_OPTION_TYPE_REAL = 2,    /**< real numbers */
    CLEFT_OPTION_TYPE_CHOICE = 3,  /**< one of several names */
    CLEFT_OPTION_TYPE_FLAG = 4     /**< on or off */
};

/** One row of the table of options. The caller sets struct_size to sizeof(cleft_option_description). All texts are
 *  static. \since 0.1 */
typedef struct cleft_option_description {
    uint32_t struct_size;
    cleft_option key;
    int32_t type;        /**< CLEFT_OPTION_TYPE_... */
    const char* name;    /**< "feature_scale" */
    double value;        /**< the default */
    double least;        /**< the least value allowed */
    double greatest;     /**< the greatest value allowed */
    const char* choices; /**< names of the choices 0, 1, ... separated by '|'; "" for other types */
    const char* text;    /**< what it does, with its unit */
    const char* group;   /**< the heading under which help lists it: "Sizes" */
    const char* calls;   /**< the calls that read it, separated by '|', of "volume" (cleft_volume_create_labels()),
                          *   "sizing", "background", "cleave", "improve" (those functions) and "mesh"
                          *   (cleft_mesh_volume()) */
} cleft_option_description;

/** Number of rows of the table. \since 0.1 */
CLEFT_API int32_t cleft_option_count(void) CLEFT_NOEXCEPT;
/** Row `index` (0 ..) of the table. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_option_info(int32_t index, cleft_option_description* out) CLEFT_NOEXCEPT;

/** Options with their defaults. The caller owns *out. A cleft_options may be changed at any time by one thread; calls
 *  read it only while they run. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_create(cleft_options** out) CLEFT_NOEXCEPT;
/** Destroys options; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_options_destroy(cleft_options* options) CLEFT_NOEXCEPT;
/** The sentence of the last value that these options refused, "" if none was; borrowed until the next call on them.
 *  \since 0.1 */
CLEFT_API const char* cleft_options_last_error(const cleft_options* options) CLEFT_NOEXCEPT;

/** Sets an integer, choice or flag. CLEFT_ERROR_OPTION for an unknown key, a real option, or a value out of range.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_integer(cleft_options* options, cleft_option key,
                                                                 int64_t value) CLEFT_NOEXCEPT;
/** Sets a real option; CLEFT_ERROR_NOT_FINITE for NaN and infinity. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_real(cleft_options* options, cleft_option key,
                                                              double value) CLEFT_NOEXCEPT;
/** Sets any option from text: by its name in the table ('-' and '_' are the same), numbers in C notation, choices by
 *  name, flags as "true", "false", "1", "0". \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_text(cleft_options* options, const char* name,
                                                              const char* value) CLEFT_NOEXCEPT;
/** The value of an integer, choice or flag. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_get_integer(const cleft_options* options, cleft_option key,
                                                                 int64_t* value) CLEFT_NOEXCEPT;
/** The value of a real option. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_get_real(const cleft_options* options, cleft_option key,
                                                              double* value) CLEFT_NOEXCEPT;

/** The greatest wanted edge length inside one label (> 0), in world units; 0 takes the wish back. As with all sizes,
 *  single edges come out longer: see docs/guide.md, section 3. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_label_size(cleft_options* options, int32_t label,
                                                                    double size) CLEFT_NOEXCEPT;
/** Labels whose tetrahedra are left out of the finished mesh; replaces the former list. No label is special: without
 *  this, the background label is meshed like the others. A call that is given these options warns of labels that its
 *  volume (or mesh) does not have, and refuses lists that leave nothing of it with CLEFT_ERROR_OPTION. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_strip(cleft_options* options, const int32_t* labels,
                                                               int64_t count) CLEFT_NOEXCEPT;
/** Labels whose tetrahedra alone are kept (count 0: all); replaces the former list. Labels that are not there: as for
 *  strip. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_only(cleft_options* options, const int32_t* labels,
                                                              int64_t count) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- volume -- */

/** Types of voxels. \since 0.1 */
typedef int32_t cleft_type;
enum {
    CLEFT_TYPE_UINT8 = 1,   /**< whole numbers of 8 bits without sign */
    CLEFT_TYPE_UINT16 = 2,  /**< whole numbers of 16 bits without sign */
    CLEFT_TYPE_INT16 = 3,   /**< whole numbers of 16 bits */
    CLEFT_TYPE_UINT32 = 4,  /**< whole numbers of 32 bits without sign */
    CLEFT_TYPE_INT32 = 5,   /**< whole numbers of 32 bits */
    CLEFT_TYPE_FLOAT32 = 6, /**< real numbers, single precision */
    CLEFT_TYPE_FLOAT64 = 7  /**< real numbers, double precision */
};

/** A label map: dims[0] * dims[1] * dims[2] voxels, x fastest, of one of the five integer types; any label values
 *  (within int32_t), up to 65,535 different ones. Other values in their place give the same mesh in every bit.
 *  `affine` maps voxel indices to world coordinates: 3 rows of 4 numbers, world = A[:, 0:3] * index + A[:, 3], voxel
 *  centres at whole indices; it may flip or shear but not flatten. NULL: spacing 1, the corner of the box at the
 * origin. The box that is meshed ends where the voxels end, half a voxel beyond the outermost centres. Wanted sizes,
 * and the angles that are improved, are those in the frame of the voxel axes, which differs from the world only if the
 * affine shears; whatever is measured of a mesh is told in the world. `options` may
 *  be NULL.
 *  Options read: SMOOTH.
 *  The voxels are copied (one or two bytes a voxel, and two for the weights). The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_create_labels(cleft_context* context, cleft_type type,
                                                                  const void* voxels, const int64_t dims[3],
                                                                  const double affine[12], const cleft_options* options,
                                                                  cleft_volume** out) CLEFT_NOEXCEPT;
/** `count` indicator functions (FLOAT32 or FLOAT64), one for each material; the largest wins at a point. count = 1: a
 *  signed function, inside (second label) where it is > 0. `labels`: what the materials are called, `count` values (two
 *  for count = 1, outside first), or NULL for 0, 1, 2, ... Values must be finite. Copied as float. Values beyond 1e30
 * in magnitude, sentinels as FLT_MAX and DBL_MAX, stand for "far away": each counts as twice the greatest magnitude
 * that the functions have within 1e30 (1 if there is none or only 0), with its sign; a warning tells how many there
 * are. Several functions of two values each, the lower the same in all, are masks: CLEFT_ERROR_ARGUMENT if voxels are
 * in none of them (give the outside a mask of its own, or make a label map). Warnings: voxels are in several masks;
 * other functions are equal and the greatest all over a region (the first holds); a single one is a mask. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_create_indicators(cleft_context* context, cleft_type type,
                                                                      const void* const* fields, int64_t count,
                                                                      const int64_t dims[3], const double affine[12],
                                                                      const int32_t* labels,
                                                                      cleft_volume** out) CLEFT_NOEXCEPT;
/** Destroys a volume, and the arrays borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_volume_destroy(cleft_volume* volume) CLEFT_NOEXCEPT;

/** Copies the number of voxels along each axis. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_dims(const cleft_volume* volume, int64_t dims[3]) CLEFT_NOEXCEPT;
/** Copies the map from voxel indices to the world, 3 rows of 4. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_affine(const cleft_volume* volume,
                                                           double affine[12]) CLEFT_NOEXCEPT;
/** Number of materials; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_volume_label_count(const cleft_volume* volume) CLEFT_NOEXCEPT;
/** The label of each material, ascending for a label map; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_volume_labels(const cleft_volume* volume) CLEFT_NOEXCEPT;
/** Number of indicator functions: 1 for a signed function, 0 for a label map; 0 for NULL. Tells what a file was taken
 *  for. \since 0.1 */
CLEFT_API int64_t cleft_volume_indicator_count(const cleft_volume* volume) CLEFT_NOEXCEPT;
/** Names a label, in one line of UTF-8, which is copied; NULL or "" takes the name away. Meshes of the volume have its
 *  names. Set them before others read the volume. CLEFT_ERROR_ARGUMENT if the volume has no such label, or if the name
 *  is not UTF-8 or has a control character in it. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_set_label_name(cleft_volume* volume, int32_t label,
                                                                   const char* name) CLEFT_NOEXCEPT;
/** The name of a label, UTF-8, "" if it has none; borrowed until it is set again or the volume is destroyed.
 *  \since 0.1 */
CLEFT_API const char* cleft_volume_label_name(const cleft_volume* volume, int32_t label) CLEFT_NOEXCEPT;
/** Voxels of each material, `capacity` >= label count. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_copy_voxel_counts(const cleft_volume* volume, int64_t* counts,
                                                                      int64_t capacity) CLEFT_NOEXCEPT;
/** The labels at `count` world points (3 * count coordinates), as the mesh sees them: the smoothed label map's winner.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_sample(const cleft_volume* volume, const double* points,
                                                           int64_t count, int32_t* labels) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- sizing -- */

/** The sizing field of a volume from its features: three distance transforms (see docs/method.md), limited by the
 *  options and the label sizes. With TETS the field is scaled until its mesh has that number of tetrahedra in the
 *  labels that strip and only keep. Meshes are made for that as cleft_mesh_volume() makes them, and it takes as long.
 *  `options` may be NULL.
 *  Options read: all but SMOOTH, STRICT and REPAIR.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create(cleft_context* context, const cleft_volume* volume,
                                                           const cleft_options* options,
                                                           cleft_sizing** out) CLEFT_NOEXCEPT;
/** One size everywhere, within 1e-30 to 1e30. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create_constant(cleft_context* context, const cleft_volume* volume,
                                                                    double size, cleft_sizing** out) CLEFT_NOEXCEPT;
/** The user's own field: one value a voxel of the volume, within 1e-30 to 1e30, x fastest, FLOAT32 or FLOAT64; taken as
 *  it is, and combined by minimum with the computed one if `combine` is nonzero (options as in cleft_sizing_create()).
 *  With TETS it is scaled as there. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create_values(cleft_context* context, const cleft_volume* volume,
                                                                  cleft_type type, const void* values, int32_t combine,
                                                                  const cleft_options* options,
                                                                  cleft_sizing** out) CLEFT_NOEXCEPT;
/** Destroys a sizing field, and the array borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_sizing_destroy(cleft_sizing* sizing) CLEFT_NOEXCEPT;
/** Copies the number of values along each axis. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_dims(const cleft_sizing* sizing, int64_t dims[3]) CLEFT_NOEXCEPT;
/** Copies the map from the indices of values to the world, 3 rows of 4. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_affine(const cleft_sizing* sizing,
                                                           double affine[12]) CLEFT_NOEXCEPT;
/** One value a voxel, x fastest; borrowed. \since 0.1 */
CLEFT_API const float* cleft_sizing_values(const cleft_sizing* sizing) CLEFT_NOEXCEPT;
/** The field at a world point. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_at(const cleft_sizing* sizing, const double point[3],
                                                       double* size) CLEFT_NOEXCEPT;
/** Tetrahedra that a background of this field will have, within some 10 %. The options with which the field was made
 *  say which: of the kind BACKGROUND, in the labels that strip and only keep (without options: of particles, in all
 *  labels). The number in all labels is the figure "sizing.expected_background_tets" on the context.
 *  cleft_mesh_estimate() tells of the finished mesh. User-supplied sizes that jump from voxel to voxel count as they
 *  are interpolated. 0 for NULL. \since 0.1 */
CLEFT_API double cleft_sizing_expected_tets(const cleft_sizing* sizing) CLEFT_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------- background -- */

/** The background mesh of a sizing field, of the kind of the option BACKGROUND. It fills the box and knows nothing of
 *  materials: its only label is 0. Particles have STEPS and a SEED. A lattice has one size, the least of the field;
 *  where neither SIZE nor SIZE_MIN nor TETS ask for it, it is raised to keep to MAX_TETS. `options` may be NULL.
 *  Options read: BACKGROUND, SIZE, SIZE_MIN, TETS, MAX_TETS, STEPS and SEED.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_background_create(cleft_context* context, const cleft_sizing* sizing,
                                                               const cleft_options* options,
                                                               cleft_mesh** out) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- meshes -- */

/** A mesh from arrays: a background of the user's own, or a finished mesh to check or write. `points`: 3 * point_count
 *  doubles in world coordinates; `tets`: 4 * tet_count point numbers counted from `index_base` (0 or 1); `labels`:
 *  tet_count labels, or NULL for 0. Numbers out of range, NaN and infinity are refused; anything else is taken, and
 *  cleft_mesh_validate() tells whether it is sound. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_create(cleft_context* context, int64_t point_count,
                                                         const double* points, int64_t tet_count, const int32_t* tets,
                                                         const int32_t* labels, int32_t index_base,
                                                         cleft_mesh** out) CLEFT_NOEXCEPT;
/** Destroys a mesh, and the arrays borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_mesh_destroy(cleft_mesh* mesh) CLEFT_NOEXCEPT;

/** Cleaves a background along the interfaces of a volume; with REPAIR above 0, poor tetrahedra of a background that is
 *  not of cleft_background_create() are repaired first. The background must be positively oriented and conforming, else
 *  CLEFT_ERROR_INVALID_MESH with the first fault; outside of the volume's box, CLEFT_ERROR_ARGUMENT. It need not fill
 *  the box: a warning tells how much of it it fills, or that it reaches out. `options` may be NULL.
 *  Options read: SNAP and REPAIR.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_cleave(cleft_context* context, const cleft_volume* volume,
                                                         const cleft_mesh* background, const cleft_options* options,
                                                         cleft_mesh** out) CLEFT_NOEXCEPT;
/** The last stage: raises the worst dihedral angles of a cleaved mesh of this volume, fits its volumes to those of the
 *  voxels (with IMPROVE off, neither), and orders points and tetrahedra spatially. Warns and, with STRICT, fails as
 *  cleft_mesh_volume() does. CLEFT_ERROR_INVALID_MESH if the mesh is not positively oriented and conforming. `options`
 *  may be NULL.
 *  Options read: IMPROVE and STRICT.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_improve(cleft_context* context, const cleft_volume* volume,
                                                          const cleft_mesh* mesh, const cleft_options* options,
                                                          cleft_mesh** out) CLEFT_NOEXCEPT;
/** The mesh without the labels that the strip and only lists of the options leave out. The caller owns *out.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_strip(cleft_context* context, const cleft_mesh* mesh,
                                                        const cleft_options* options, cleft_mesh** out) CLEFT_NOEXCEPT;
/** All of it: cleft_sizing_create() (unless given), cleft_background_create() (unless given), cleft_mesh_cleave(),
 *  cleft_mesh_improve() and cleft_mesh_strip(). Called one by one, these give the same bytes. `sizing`, `background`
 *  and `options` may be NULL.
 *  Options read: all but SMOOTH.
 *  With TETS, the size is corrected until the number of tetrahedra that strip and only keep is within 10 % (at most
 *  eight rounds; where labels are left out, the whole mesh keeps to MAX_TETS, and a warning tells if the number is not
 *  met). With STRICT, CLEFT_ERROR_LABEL_LOST if a kept label, or a piece of more than 30 voxels of one, is not in the
 *  mesh or broke, or if two kept labels are a cleft_contact; also, without STRICT, if no kept label is in the mesh.
 *  Warns (CLEFT_LOG_WARNING, in one sentence) of kept labels of 100 voxels or more whose volume in the mesh differs by
 *  more than 5 % from that of their voxels. Warns in one sentence, too, of tetrahedra with dihedral angles below 20 or
 *  above 155 degrees in the frame of the voxel axes, unless IMPROVE is off. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_volume(cleft_context* context, const cleft_volume* volume,
                                                         const cleft_sizing* sizing, const cleft_mesh* background,
                                                         const cleft_options* options, cleft_mesh** out) CLEFT_NOEXCEPT;

/** What a mesh will come to. The caller sets struct_size to sizeof(cleft_estimate). \since 0.1 */
typedef struct cleft_estimate {
    uint32_t struct_size;
    int32_t is_bound;       /**< 1 if there may be fewer: labels have few points each, and most cuts may have to stay */
    double tets;            /**< tetrahedra of the finished mesh, in the labels that strip and only keep */
    double whole_tets;      /**< tetrahedra of the mesh from which the other labels are left out */
    double background_tets; /**< tetrahedra of the background that is cleaved */
    double peak_bytes;      /**< the most memory that a process takes to make the mesh, in bytes, no less */
} cleft_estimate;

/** What cleft_mesh_volume() will come to with the same arguments, within 15 % (see docs/quality.md). It computes the
 *  sizing field unless that or a background is given, and makes no mesh. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_estimate(cleft_context* context, const cleft_volume* volume,
                                                           const cleft_sizing* sizing, const cleft_mesh* background,
                                                           const cleft_options* options,
                                                           cleft_estimate* out) CLEFT_NOEXCEPT;

/** Number of points; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_mesh_point_count(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** World coordinates, x y z interleaved, 3 * point count; borrowed. \since 0.1 */
CLEFT_API const double* cleft_mesh_points(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Number of tetrahedra; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_mesh_tet_count(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Corners, 4 * tetrahedron count, from 0, positively oriented: det[b-a, c-a, d-a] > 0; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_mesh_tets(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** The label of each tetrahedron; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_mesh_tet_labels(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Number of different labels; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_mesh_label_count(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** The different labels, ascending; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_mesh_labels(const cleft_mesh* mesh) CLEFT_NOEXCEPT;

/** Names a label of the mesh: see cleft_volume_set_label_name(). Meshes made of a volume have its names, of the labels
 *  that they have; cleft_mesh_improve() and cleft_mesh_strip() keep a mesh's. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_set_label_name(cleft_mesh* mesh, int32_t label,
                                                                 const char* name) CLEFT_NOEXCEPT;
/** The name of a label, UTF-8, "" if it has none; borrowed until it is set again or the mesh is destroyed. \since 0.1
 */
CLEFT_API const char* cleft_mesh_label_name(const cleft_mesh* mesh, int32_t label) CLEFT_NOEXCEPT;

/** Copies the points; `capacity` is in doubles and must be at least 3 * point count. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_points(const cleft_mesh* mesh, double* points,
                                                              int64_t capacity) CLEFT_NOEXCEPT;
/** Copies the corners, counted from index_base (0 or 1); `capacity` in int32_t, at least 4 * tetrahedron count.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_tets(const cleft_mesh* mesh, int32_t index_base, int32_t* tets,
                                                            int64_t capacity) CLEFT_NOEXCEPT;
/** Copies the label of each tetrahedron; `capacity` at least the tetrahedron count. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_tet_labels(const cleft_mesh* mesh, int32_t* labels,
                                                                  int64_t capacity) CLEFT_NOEXCEPT;
/** Ten-node tetrahedra: adds a point at the middle of each edge. Corners of element t are tets[10 t .. 10 t + 3]; then
 *  the middles of edges 01, 12, 02, 03, 13, 23 (the order of VTK, Abaqus C3D10). Call with NULL buffers and zero
 *  capacities to get the counts. The first points are those of the mesh. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_quadratic(const cleft_mesh* mesh, int32_t index_base,
                                                                 double* points, int64_t point_capacity, int32_t* tets,
                                                                 int64_t tet_capacity,
                                                                 int64_t* point_count) CLEFT_NOEXCEPT;

/** The shape of a mesh in figures. The caller sets struct_size to sizeof(cleft_quality). \since 0.1 */
typedef struct cleft_quality {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t tet_count;              /**< tetrahedra */
    double min_dihedral;            /**< the least dihedral angle, in degrees */
    double max_dihedral;            /**< the greatest dihedral angle, in degrees */
    int64_t tets_below_5;           /**< tetrahedra whose least dihedral angle is below 5 degrees */
    int64_t tets_below_10;          /**< tetrahedra whose least dihedral angle is below 10 degrees */
    int64_t tets_below_15;          /**< tetrahedra whose least dihedral angle is below 15 degrees */
    int64_t tets_below_20;          /**< tetrahedra whose least dihedral angle is below 20 degrees */
    int64_t tets_above_165;         /**< tetrahedra whose greatest dihedral angle is above 165 degrees */
    double radius_ratio_median;     /**< circumradius / (3 inradius), 1 for the regular tetrahedron: the median */
    double radius_ratio_95;         /**< 95th percentile of the radius ratio */
    double radius_ratio_max;        /**< the greatest radius ratio */
    double edge_ratio_max;          /**< longest / shortest edge of one tetrahedron */
    double min_edge;                /**< the shortest edge */
    double mean_edge;               /**< the mean edge */
    double max_edge;                /**< the longest edge */
    double min_volume;              /**< the least volume of a tetrahedron */
    double total_volume;            /**< the volume of all */
    int64_t dihedral_histogram[36]; /**< all angles, in bins of 5 degrees */
} cleft_quality;

/** Measures a mesh. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_quality(cleft_context* context, const cleft_mesh* mesh,
                                                          cleft_quality* out) CLEFT_NOEXCEPT;

/** What is wrong with a mesh; all counts of faults are 0 for a sound one. The caller sets struct_size. \since 0.1 */
typedef struct cleft_validation {
    uint32_t struct_size;
    int32_t valid;         /**< 1 if nothing is wrong */
    int64_t negative_tets; /**< tetrahedra that are turned inside out, by an exact predicate */
    int64_t flat_tets;     /**< tetrahedra that are flat, or of less volume than 1e-12 of the cube of their mean edge */
    int64_t repeated_corners;     /**< tetrahedra that name a point twice */
    int64_t crowded_faces;        /**< faces of more than two tetrahedra */
    int64_t folded_faces;         /**< faces whose two tetrahedra lie on one side */
    int64_t hull_off_box;         /**< hull triangles in no side of the bounding box */
    int64_t open_interface_edges; /**< edges inside the box with one interface triangle only */
    int64_t unused_points;        /**< points of no tetrahedron */
    int64_t repeated_points;      /**< points at the place of another */
    double volume;                /**< the volume of the tetrahedra */
    double box_volume;            /**< the volume of the bounding box */
    double hull_area;             /**< the area of the hull */
    double box_area;              /**< the area of the bounding box */
    /** faces between tetrahedra of different labels, counted face by face: a surface finds as many, by
     *  another way */
    int64_t interface_triangles;
    int64_t hull_triangles; /**< faces of one tetrahedron, counted so, too */
} cleft_validation;

/** Looks for faults. `fills_box` nonzero: the mesh is also asked to fill its bounding box, as meshes of
 *  cleft_mesh_volume() do; ask it neither of a mesh from which labels were left out (strip, only) nor of one of a
 *  background of the user's that does not fill it. A fault is no failure of the call; the first one and its place are
 *  then in cleft_context_last_error(). \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_validate(cleft_context* context, const cleft_mesh* mesh,
                                                           int32_t fills_box, cleft_validation* out) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------ surfaces -- */

/** Sides of the box, in the axes of the voxels. \since 0.1 */
enum {
    CLEFT_SIDE_X_MIN = 0, /**< the least x */
    CLEFT_SIDE_X_MAX = 1, /**< the greatest x */
    CLEFT_SIDE_Y_MIN = 2, /**< the least y */
    CLEFT_SIDE_Y_MAX = 3, /**< the greatest y */
    CLEFT_SIDE_Z_MIN = 4, /**< the least z */
    CLEFT_SIDE_Z_MAX = 5, /**< the greatest z */
    CLEFT_SIDE_OTHER = 6  /**< no side of the box */
};

/** The interfaces between labels and the hull of a mesh, as triangles that number the mesh's points. The caller owns
 *  *out, which does not need the mesh afterwards. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_surface_create(cleft_context* context, const cleft_mesh* mesh,
                                                            cleft_surface** out) CLEFT_NOEXCEPT;
/** Destroys a surface, and the arrays borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_surface_destroy(cleft_surface* surface) CLEFT_NOEXCEPT;
/** Number of triangles between different labels; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_surface_interface_count(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Corners, 3 a triangle; the normal points from the first label of the pair to the second. Sorted by pair. Borrowed.
 *  \since 0.1 */
CLEFT_API const int32_t* cleft_surface_interface_triangles(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Two labels a triangle, the lower first; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_interface_labels(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Number of hull triangles; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_surface_hull_count(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Corners, 3 a triangle, normals outward, sorted by side, then label; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_hull_triangles(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** The label inside each hull triangle; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_hull_labels(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** CLEFT_SIDE_... of each hull triangle; borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_hull_sides(const cleft_surface* surface) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------ per-label report -- */

/** What became of one label. Volumes in world units cubed. Components of voxels are joined by faces, components of
 *  the mesh by faces of tetrahedra. The caller sets struct_size. \since 0.1 */
typedef struct cleft_label_report {
    uint32_t struct_size;
    int32_t label;                 /**< the label */
    int64_t voxels;                /**< its voxels */
    double voxel_volume;           /**< the volume of its voxels */
    double mesh_volume;            /**< the volume of its tetrahedra */
    int64_t tets;                  /**< its tetrahedra */
    int64_t voxel_components;      /**< pieces of its voxels, joined by faces */
    int64_t mesh_components;       /**< pieces of its tetrahedra, joined by faces */
    int64_t large_components;      /**< voxel components of more than 30 voxels */
    int64_t large_components_lost; /**< of those, the ones in which no tetrahedron of the label lies */
    int32_t lost;                  /**< 1 if the label has voxels but no tetrahedron */
    int32_t reserved;              /**< large_components_broken again, up to 2147483647: programs built early read it */
    /** of the large components, those that lie in several components of the mesh, each with half a voxel or more: parts
     *  thinner than the tetrahedra around broke; a smaller size there keeps them */
    int64_t large_components_broken;
    /** of the large components, those that lie in one component of the mesh with another of them, each with half a
     * voxel or more. They touch over an edge or a corner of voxels, or are nearer than an element tells apart */
    int64_t large_components_joined;
} cleft_label_report;

/** Compares a finished (not stripped) mesh with its volume, label by label. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_create(cleft_context* context, const cleft_volume* volume,
                                                           const cleft_mesh* mesh, cleft_report** out) CLEFT_NOEXCEPT;
/** Destroys a report; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_report_destroy(cleft_report* report) CLEFT_NOEXCEPT;
/** Number of labels of the volume; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_report_count(const cleft_report* report) CLEFT_NOEXCEPT;
/** Row `index`, in the order of cleft_volume_labels(). \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_label(const cleft_report* report, int64_t index,
                                                          cleft_label_report* out) CLEFT_NOEXCEPT;

/** Two labels that share triangles in the mesh, but of which no two voxels share a face or an edge (a corner at most,
 *  through which a gap of one voxel goes on): the gap between them is narrower than the tetrahedra there, and a smaller
 *  size opens it. The caller sets struct_size.
 *  \since 0.1 */
typedef struct cleft_contact {
    uint32_t struct_size;
    int32_t first;  /**< the lower of the two labels */
    int32_t second; /**< the other */
    int32_t reserved;
    int64_t triangles; /**< the triangles that the two share */
} cleft_contact;

/** Number of such pairs of labels; 0 for NULL. Where the volume is of indicator functions, the label of a voxel is that
 *  of the function which wins at its centre. \since 0.1 */
CLEFT_API int64_t cleft_report_contact_count(const cleft_report* report) CLEFT_NOEXCEPT;
/** Pair `index` (0 ..), in ascending order of the labels. CLEFT_ERROR_ARGUMENT if there is no such pair. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_contact(const cleft_report* report, int64_t index,
                                                            cleft_contact* out) CLEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
