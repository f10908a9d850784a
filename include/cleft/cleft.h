/*
 * libcleft makes conforming tetrahedral meshes of several materials from labelled volumes. Its method is mesh
 * cleaving.
 *
 * This header is the reference manual. Data go through these stages, with one call for each arrow:
 *
 *     volume --> sizing --> background --> cleave --> improve --> mesh arrays
 *
 * cleft_mesh_volume() runs all stages in one call.
 *
 * Conventions
 *  - Status. Every function that can fail returns a cleft_status: CLEFT_OK (0) or a fixed negative number.
 *    cleft_context_last_error() returns one sentence about the failure that names the value at fault. Functions
 *    without a context store no sentence; cleft_status_string() has a text for their status. Functions of options
 *    store theirs in cleft_options_last_error().
 *  - Outputs. Output arguments come last. On failure the library sets output pointers to NULL and leaves numbers and
 *    buffers as they were. There is never half a result.
 *  - Handles. Handles are opaque. The caller owns every handle that a function makes, and must destroy it with the
 *    function `_destroy` of its kind, which accepts NULL. The library does not detect the use of a destroyed handle.
 *  - Threads. All handles except contexts and options are immutable. Many threads may read one at the same time, also
 *    after its context is destroyed. The only exception is names of labels: set them before other threads read.
 *  - Calls. A context runs one call at a time. During a call, any other call on that context from another thread or a
 *    callback returns CLEFT_ERROR_BUSY and stores no sentence. A callback may use cleft_context_cancel(),
 *    cleft_context_threads(), cleft_context_last_error() and the metrics of its context. If a callback destroys a
 *    handle that the running call uses, the handle lives until that call ends.
 *  - Structs. Each struct begins with struct_size, which the caller sets to sizeof of the struct. Structs grow only
 *    at their end, so programs and libraries of different versions work together. The library fills only the fields
 *    that the caller's struct has. It leaves fields that it does not know unchanged, and reads fields that the caller
 *    lacks as 0. It returns CLEFT_ERROR_ARGUMENT if struct_size is less than the size of the struct in its first
 *    release. It does so too if an input has a field that the library does not know and that is not 0.
 *  - State. The library has no global or thread-local state and prints nothing.
 *  - Arrays. The library copies the arrays that it receives. It returns arrays in two ways. A `const` pointer is
 *    borrowed: it is valid until its handle is destroyed, and is NULL if there are no elements. Functions with `_copy_`
 *    in their names copy into a buffer of the caller.
 *  - Numbers. Counts are int64_t. Point numbers are int32_t and start at 0 unless a function takes an index base.
 *    Coordinates are double, interleaved x y z. Labels are int32_t: the user's own numbers of the materials.
 *  - Sentences. Messages count from the first: "the 3rd point" is point 2 of an array that starts at 0.
 *  - Units. Lengths are in the unit of the volume's world coordinates.
 *  - Determinism. Results are the same bytes for every number of threads.
 *
 * Limits
 *  - Volume: at most 2,147,483,647 voxels and 65,535 labels.
 *  - Spacings: within 1e-15 to 1e15, and the greatest at most 1,000 times the least.
 *  - World coordinates of the volume's box: at most 1e14 times the least distance between planes of voxels.
 *  - Affine: if each column is divided by its length, the determinant must be at least 1e-6 in magnitude.
 *  - A volume outside these limits gives CLEFT_ERROR_ARGUMENT or CLEFT_ERROR_TOO_LARGE.
 *  - Sizes: within 1e-30 to 1e30. Sizes that need more elements than memory or 32-bit numbers allow give
 *    CLEFT_ERROR_TOO_LARGE.
 *  - Indicator functions: finite. Values beyond 1e30 in magnitude mean "far away"; see
 *    cleft_volume_create_indicators().
 *  - Input meshes: the library validates a mesh fully before it cleaves or improves it. A fault gives
 *    CLEFT_ERROR_INVALID_MESH.
 *  - Output meshes: the library checks every mesh that it returns. Coordinates are finite, no two points coincide,
 *    and an exact predicate finds every tetrahedron positively oriented. If double precision cannot represent such a
 *    mesh far from the origin, the call returns CLEFT_ERROR_ARGUMENT. Any other fault gives CLEFT_ERROR_INTERNAL,
 *    never a bad mesh. cleft_mesh_validate() runs the full validation.
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

/* Compilers warn where a program ignores a status. */
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

/** Returns the version of the running library as static text, "major.minor.patch". Each output may be NULL.
 *  \since 0.1 */
CLEFT_API const char* cleft_version(int32_t* major, int32_t* minor, int32_t* patch) CLEFT_NOEXCEPT;

/** Returns static text for a status code, "unknown status" for any other number. \since 0.1 */
CLEFT_API const char* cleft_status_string(cleft_status status) CLEFT_NOEXCEPT;

/** Returns 1 if this build contains TetGen, which the option DELAUNAY can choose, else 0. \since 0.1 */
CLEFT_API int32_t cleft_has_tetgen(void) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------- handles -- */

typedef struct cleft_context cleft_context; /**< errors, callbacks, threads, metrics; one call at a time */
typedef struct cleft_options cleft_options; /**< the settings of meshing */
typedef struct cleft_volume cleft_volume;   /**< a label map or indicator functions */
typedef struct cleft_sizing cleft_sizing;   /**< the wanted edge length at each point */
typedef struct cleft_mesh cleft_mesh;       /**< points, tetrahedra, labels; a background has label 0 only */
typedef struct cleft_surface cleft_surface; /**< the interface and hull triangles of a mesh */
typedef struct cleft_report cleft_report;   /**< what became of each label */

/* ------------------------------------------------------------------------------------------------- context -- */

/** Makes a context with one thread and no callbacks. The caller owns *out. The function fails only if memory is short
 *  or `out` is NULL. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_create(cleft_context** out) CLEFT_NOEXCEPT;
/** Destroys a context; NULL is allowed. Handles made with it stay valid. \since 0.1 */
CLEFT_API void cleft_context_destroy(cleft_context* context) CLEFT_NOEXCEPT;

/** Returns the sentence of the last failure on this context, "" if there was none. It is one line of UTF-8: bytes of a
 *  file's name that are no text are question marks in it. The text is borrowed until the next call on the context.
 *  \since 0.1 */
CLEFT_API const char* cleft_context_last_error(const cleft_context* context) CLEFT_NOEXCEPT;
/** Stores a sentence as the last error of the context and returns `status`, or CLEFT_ERROR_BUSY. It is meant for
 *  components that build on this library. \since 0.1 */
CLEFT_API cleft_status cleft_context_set_error(cleft_context* context, cleft_status status,
                                               const char* sentence) CLEFT_NOEXCEPT;

/** Sets the number of threads, 1 .. 1024. 0 means as many as the machine has. Results do not depend on it.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_set_threads(cleft_context* context,
                                                                 int32_t threads) CLEFT_NOEXCEPT;
/** Returns the number of threads in use, 0 for NULL. \since 0.1 */
CLEFT_API int32_t cleft_context_threads(const cleft_context* context) CLEFT_NOEXCEPT;

/** Receives the progress of the running call. `fraction` is in [0, 1] and never falls. It grows about as time passes
 *  (docs/quality.md), and ends at 1 if the call succeeds. `stage` names the stage in words and is borrowed for the
 *  call. A nonzero return value cancels the call. The library calls it on the thread that called the library, usually
 *  ten times a second or more. It may repeat a fraction. Where the option DELAUNAY chooses TetGen, it cannot be
 *  interrupted; it takes seconds for millions of tetrahedra. \since 0.1 */
typedef int (*cleft_progress_callback)(double fraction, const char* stage, void* user);
/** Sets the progress callback; NULL removes it. The library passes `user` to the callback. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_set_progress(cleft_context* context,
                                                                  cleft_progress_callback callback,
                                                                  void* user) CLEFT_NOEXCEPT;

/** Levels of log messages. \since 0.1 */
enum {
    CLEFT_LOG_WARNING = 1, /**< a result may not be what the user intends */
    CLEFT_LOG_INFO = 2,    /**< useful information */
    CLEFT_LOG_DEBUG = 3    /**< details for finding a fault */
};
/** Receives a log message. `sentence` is borrowed for the call. The library calls it on the thread that called the
 *  library. \since 0.1 */
typedef void (*cleft_log_callback)(int32_t level, const char* sentence, void* user);
/** Sets the log callback; NULL removes it. The library passes `user` to the callback. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_set_log(cleft_context* context, cleft_log_callback callback,
                                                             void* user) CLEFT_NOEXCEPT;

/** Passes a sentence to the log callback, if one is set. It is meant for components that build on this library.
 *  `level` must be one of CLEFT_LOG_WARNING to CLEFT_LOG_DEBUG, else CLEFT_ERROR_ARGUMENT. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_log(cleft_context* context, int32_t level,
                                                         const char* sentence) CLEFT_NOEXCEPT;

/** Begins one call of the context that lasts until cleft_context_end(). It is meant for components that build on this
 *  library. Until then other threads and callbacks get CLEFT_ERROR_BUSY. If a callback destroys the context or one of
 *  the `count` handles, these stay valid until the end. A handle may be of any kind or NULL. Like any call, this one
 *  clears the last error and earlier requests to cancel. Calls may be nested. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_begin(cleft_context* context, const void* const* handles,
                                                           int64_t count) CLEFT_NOEXCEPT;
/** Tells how far a call between cleft_context_begin() and cleft_context_end() is, and asks whether it shall stop. It is
 *  meant for components that build on this library, on the thread that began the call. The progress callback, if one is
 *  set, receives `fraction` and `stage`. Calls of this library until the next report are the part of the component's
 *  call from `fraction` to `end`, and report their own progress within it. CLEFT_ERROR_CANCELLED if the callback or
 *  cleft_context_cancel() asks to stop. CLEFT_ERROR_ARGUMENT unless 0 <= fraction <= end <= 1. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_report(cleft_context* context, double fraction, double end,
                                                            const char* stage) CLEFT_NOEXCEPT;
/** Ends the call that cleft_context_begin() began on the same thread. \since 0.1 */
CLEFT_API void cleft_context_end(cleft_context* context) CLEFT_NOEXCEPT;

/** Asks the call that runs on this context to stop soon with CLEFT_ERROR_CANCELLED. Any thread may call it. If no
 *  call runs, the request has no effect: the next call clears it. \since 0.1 */
CLEFT_API cleft_status cleft_context_cancel(cleft_context* context) CLEFT_NOEXCEPT;

/** Returns the number of metrics on this context. A metric is a figure that a stage stores under a name, such as
 *  seconds, counts, or angles before and after. Metrics are in the order in which they were first stored. A later
 *  call overwrites metrics of the same name. \since 0.1 */
CLEFT_API int64_t cleft_context_metric_count(const cleft_context* context) CLEFT_NOEXCEPT;
/** Gets the metric `index`, from 0. `name` is borrowed until the next call on the context. CLEFT_ERROR_ARGUMENT if
 *  there is no such metric. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_metric(const cleft_context* context, int64_t index,
                                                            const char** name, double* value) CLEFT_NOEXCEPT;
/** Removes all metrics. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_context_clear_metrics(cleft_context* context) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------------- options -- */

/** Keys of options; their numbers never change. cleft_option_info() reads the meaning, default and range of each from
 *  the table of options. `cleft mesh --help` prints the same table. \since 0.1 */
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
    CLEFT_OPTION_KEEP_THIN = 17,
    CLEFT_OPTION_MIN_ANGLE = 18,
    CLEFT_OPTION_DELAUNAY = 19,
    CLEFT_OPTION_SURFACE_ERROR = 20,
    CLEFT_OPTION_ANISOTROPY = 21,
    CLEFT_OPTION_BLOCK = 22
};

/** Kinds of background meshes. \since 0.1 */
enum {
    CLEFT_BACKGROUND_PARTICLES = 0, /**< relaxed particles and their Delaunay tetrahedra, which have the best shapes */
    CLEFT_BACKGROUND_LATTICE = 1,   /**< a regular lattice, which is quick and has one size everywhere */
    CLEFT_BACKGROUND_OCTREE = 2     /**< an adaptive lattice, which is quick and follows the sizing field */
};
/** Rules that move background points onto interfaces. \since 0.1 */
enum {
    CLEFT_SNAP_QUALITY = 0, /**< by the quality of the surrounding elements */
    CLEFT_SNAP_SAFE = 1,    /**< by the safe distances of the published method */
    CLEFT_SNAP_NONE = 2     /**< no point moves */
};
/** Effort spent on the worst dihedral angles. \since 0.1 */
enum {
    CLEFT_IMPROVE_OFF = 0,  /**< no improvement */
    CLEFT_IMPROVE_FAST = 1, /**< moderate effort, the default */
    CLEFT_IMPROVE_BEST = 2  /**< effort until nothing improves further */
};
/** Engines of Delaunay tetrahedra, which give the same mesh. \since 0.1 */
enum {
    CLEFT_DELAUNAY_CLEFT = 0, /**< Cleft's own, which works on all threads */
    CLEFT_DELAUNAY_TETGEN = 1 /**< TetGen, on one thread; refused where the library has no TetGen */
};
/* </options> */

/** Types of option values. \since 0.1 */
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
    const char* choices; /**< names of the choices 0, 1, ..., separated by '|'; "" for other types */
    const char* text;    /**< what it does, with its unit */
    const char* group;   /**< the heading under which help lists it: "Sizes" */
    const char* calls;   /**< the calls that read it, separated by '|': "volume" is cleft_volume_create_labels(),
                          *   "sizing" cleft_sizing_create(), "background" cleft_background_create(), "cleave"
                          *   cleft_mesh_cleave(), "improve" cleft_mesh_improve(), "mesh" cleft_mesh_volume() */
} cleft_option_description;

/** Returns the number of rows of the table of options. \since 0.1 */
CLEFT_API int32_t cleft_option_count(void) CLEFT_NOEXCEPT;
/** Gets row `index` of the table of options, from 0. CLEFT_ERROR_ARGUMENT if there is no such row. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_option_info(int32_t index, cleft_option_description* out) CLEFT_NOEXCEPT;

/** Makes options with their default values. The caller owns *out. Calls read options only while they run. Change
 *  options from one thread at a time, and not while a call reads them. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_create(cleft_options** out) CLEFT_NOEXCEPT;
/** Destroys options; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_options_destroy(cleft_options* options) CLEFT_NOEXCEPT;
/** Returns the sentence about the last value that these options refused, "" if there was none. The text is borrowed
 *  until the next call on the options. \since 0.1 */
CLEFT_API const char* cleft_options_last_error(const cleft_options* options) CLEFT_NOEXCEPT;

/** Sets an option of type integer, choice or flag. CLEFT_ERROR_OPTION for an unknown key, a real option, or a value
 *  out of range. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_integer(cleft_options* options, cleft_option key,
                                                                 int64_t value) CLEFT_NOEXCEPT;
/** Sets a real option. CLEFT_ERROR_OPTION as for cleft_options_set_integer(); CLEFT_ERROR_NOT_FINITE for NaN and
 *  infinity. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_real(cleft_options* options, cleft_option key,
                                                              double value) CLEFT_NOEXCEPT;
/** Sets any option from text. `name` is its name in the table of options; '-' and '_' are the same. `value` is a
 *  number in C notation, the name of a choice, or "true", "false", "1" or "0" for a flag. Errors are as for
 *  cleft_options_set_integer() and cleft_options_set_real(). \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_text(cleft_options* options, const char* name,
                                                              const char* value) CLEFT_NOEXCEPT;
/** Gets the value of an integer, choice or flag. CLEFT_ERROR_OPTION for an unknown key. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_get_integer(const cleft_options* options, cleft_option key,
                                                                 int64_t* value) CLEFT_NOEXCEPT;
/** Gets the value of an option as a real number. CLEFT_ERROR_OPTION for an unknown key. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_get_real(const cleft_options* options, cleft_option key,
                                                              double* value) CLEFT_NOEXCEPT;

/** Sets the greatest wanted edge length inside one label, in world units. 0 removes the limit for this label. As with
 *  all sizes, single edges may be longer: see section 3 of docs/guide.md. CLEFT_ERROR_OPTION for a negative size,
 *  CLEFT_ERROR_NOT_FINITE for NaN and infinity. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_label_size(cleft_options* options, int32_t label,
                                                                    double size) CLEFT_NOEXCEPT;
/** Sets the labels whose tetrahedra the finished mesh leaves out; the list replaces the former one. No label is
 *  special: without this list, the background label is meshed like the others. A call with these options warns about
 *  labels that its volume or mesh does not have. It returns CLEFT_ERROR_OPTION if the lists leave no label.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_strip(cleft_options* options, const int32_t* labels,
                                                               int64_t count) CLEFT_NOEXCEPT;
/** Sets the only labels whose tetrahedra the finished mesh keeps; count 0 keeps all. The list replaces the former
 *  one. Labels that are not there are treated as in cleft_options_set_strip(). \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_options_set_only(cleft_options* options, const int32_t* labels,
                                                              int64_t count) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- volume -- */

/** Types of voxels. \since 0.1 */
typedef int32_t cleft_type;
enum {
    CLEFT_TYPE_UINT8 = 1,   /**< unsigned whole numbers of 8 bits */
    CLEFT_TYPE_UINT16 = 2,  /**< unsigned whole numbers of 16 bits */
    CLEFT_TYPE_INT16 = 3,   /**< signed whole numbers of 16 bits */
    CLEFT_TYPE_UINT32 = 4,  /**< unsigned whole numbers of 32 bits */
    CLEFT_TYPE_INT32 = 5,   /**< signed whole numbers of 32 bits */
    CLEFT_TYPE_FLOAT32 = 6, /**< real numbers, single precision */
    CLEFT_TYPE_FLOAT64 = 7  /**< real numbers, double precision */
};

/** Makes a volume from a label map: one label per voxel.
 *
 *  `voxels` has dims[0] * dims[1] * dims[2] values, x fastest, of one of the five integer types. Labels may be any
 *  values within int32_t, at most 65,535 different ones. The mesh does not depend on the values: other values in
 *  their place give the same points and tetrahedra in every bit.
 *
 *  `affine` maps voxel indices to world coordinates. It has 3 rows of 4 numbers: world = A[:, 0:3] * index + A[:, 3].
 *  Voxel centres are at whole indices. It may flip or shear but not flatten. NULL means spacing 1 with the corner of
 *  the box at the origin. The meshed box ends where the voxels end, half a voxel beyond the outermost centres.
 *
 *  Wanted sizes are lengths in the frame of the voxel axes. That frame has other lengths and angles than the world only
 *  if the affine shears. MIN_ANGLE and all results of measuring a mesh are of the world. With shears, improving takes
 *  longer. Beyond 37 degrees, tetrahedra miss MIN_ANGLE, the more the further it shears; a warning gives their number.
 *
 *  The library copies the voxels. It takes one or two bytes per voxel, and two more for the weights of smoothing.
 *  `options` may be NULL.
 *  Options read: SMOOTH.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_create_labels(cleft_context* context, cleft_type type,
                                                                  const void* voxels, const int64_t dims[3],
                                                                  const double affine[12], const cleft_options* options,
                                                                  cleft_volume** out) CLEFT_NOEXCEPT;
/** Makes a volume from `count` indicator functions, one per material. At each point the material with the largest
 *  value holds. The type is FLOAT32 or FLOAT64; the library copies the values as float. Each function has one value
 *  per voxel, x fastest. `dims` and `affine` are as in cleft_volume_create_labels().
 *
 *  If count is 1, the function is signed: the second label is inside, where the function is > 0, and the first
 *  outside.
 *
 *  `labels` has the label of each material: `count` values, or two if count is 1. NULL means 0, 1, 2, ...
 *
 *  Values must be finite. Values beyond 1e30 in magnitude, such as FLT_MAX and DBL_MAX, mean "far away". Each counts
 *  as twice the greatest magnitude within 1e30 of all functions, with its own sign. If there is no such magnitude but
 *  0, it counts as 1. A warning gives the number of these values.
 *
 *  Several functions with two values each, of which the lower is the same in all, are masks. If voxels are in none of
 *  the masks, the call returns CLEFT_ERROR_ARGUMENT. Then give the outside its own mask, or make a label map.
 *
 *  The library warns if:
 *  - voxels are in several masks;
 *  - several functions are equal and greatest over a whole region, where the first of them holds;
 *  - the only function is a mask.
 *
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_create_indicators(cleft_context* context, cleft_type type,
                                                                      const void* const* fields, int64_t count,
                                                                      const int64_t dims[3], const double affine[12],
                                                                      const int32_t* labels,
                                                                      cleft_volume** out) CLEFT_NOEXCEPT;
/** Destroys a volume and the arrays borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_volume_destroy(cleft_volume* volume) CLEFT_NOEXCEPT;

/** Copies the number of voxels along each axis. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_dims(const cleft_volume* volume, int64_t dims[3]) CLEFT_NOEXCEPT;
/** Copies the affine map from voxel indices to world coordinates, 3 rows of 4. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_affine(const cleft_volume* volume,
                                                           double affine[12]) CLEFT_NOEXCEPT;
/** Returns the number of labels, 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_volume_label_count(const cleft_volume* volume) CLEFT_NOEXCEPT;
/** Returns the labels: ascending for a label map, else in the order of the functions. Borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_volume_labels(const cleft_volume* volume) CLEFT_NOEXCEPT;
/** Returns the number of indicator functions: 1 for a signed function, 0 for a label map or NULL. It shows how
 *  cleft_io_read_volume() understood a file. \since 0.1 */
CLEFT_API int64_t cleft_volume_indicator_count(const cleft_volume* volume) CLEFT_NOEXCEPT;
/** Sets the name of a label: one line of UTF-8, which the library copies. NULL or "" removes the name. Meshes of the
 *  volume get its names. Set names before other threads read the volume. CLEFT_ERROR_ARGUMENT if the volume has no
 *  such label, or if the name is not UTF-8 or contains a control character. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_set_label_name(cleft_volume* volume, int32_t label,
                                                                   const char* name) CLEFT_NOEXCEPT;
/** Returns the name of a label in UTF-8, "" if it has none. The text is borrowed until the name is set again or the
 *  volume is destroyed. \since 0.1 */
CLEFT_API const char* cleft_volume_label_name(const cleft_volume* volume, int32_t label) CLEFT_NOEXCEPT;
/** Copies the number of voxels of each label, in the order of cleft_volume_labels(). `capacity` must be at least the
 *  label count, else CLEFT_ERROR_BUFFER. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_copy_voxel_counts(const cleft_volume* volume, int64_t* counts,
                                                                      int64_t capacity) CLEFT_NOEXCEPT;
/** Gets the labels at `count` world points, given as 3 * count coordinates. They are those that the mesh resolves:
 *  for a label map, the label whose smoothed indicator function is the greatest. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_volume_sample(const cleft_volume* volume, const double* points,
                                                           int64_t count, int32_t* labels) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- sizing -- */

/** Computes the sizing field of a volume from its features, within the limits of the options and the label sizes. It
 *  uses three distance transforms; see docs/method.md. `options` may be NULL.
 *
 *  With TETS the library scales the field until its mesh has that number of tetrahedra in the labels that strip and
 *  only keep. It makes meshes for that as cleft_mesh_volume() does, and takes as long. Then MAX_TETS limits only the
 *  whole mesh from which labels are left out.
 *  Options read: all but SMOOTH, STRICT, REPAIR and DELAUNAY.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create(cleft_context* context, const cleft_volume* volume,
                                                           const cleft_options* options,
                                                           cleft_sizing** out) CLEFT_NOEXCEPT;
/** Makes a sizing field with one size everywhere. CLEFT_ERROR_ARGUMENT if the size is not within 1e-30 to 1e30. The
 *  function reads no options, so it does not scale the size to TETS; cleft_mesh_volume() does if it gets the field.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create_constant(cleft_context* context, const cleft_volume* volume,
                                                                    double size, cleft_sizing** out) CLEFT_NOEXCEPT;
/** Makes a sizing field from user-supplied values: one per voxel of the volume, x fastest, FLOAT32 or FLOAT64, within
 *  1e-30 to 1e30. If `combine` is nonzero, the field is the minimum of these values and the computed field, with
 *  options as in cleft_sizing_create(). Else the library uses the values unchanged. With TETS it scales the field as
 *  cleft_sizing_create() does. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create_values(cleft_context* context, const cleft_volume* volume,
                                                                  cleft_type type, const void* values, int32_t combine,
                                                                  const cleft_options* options,
                                                                  cleft_sizing** out) CLEFT_NOEXCEPT;
/** Makes a sizing field with a metric: wanted lengths that depend on the direction. An edge v has the wanted length
 *  where v^T M v = 1, in world units. `tensors` has six numbers per voxel of the volume, FLOAT32 or FLOAT64: xx, xy,
 * xz, yy, yz, zz of the symmetric M of the first voxel, then those of the next, x fastest. The library interpolates the
 *  logarithm of M.
 *
 *  With a metric, cleft_background_create() makes tetrahedra whose edges have the wanted lengths and whose angles are
 *  good where M measures them. cleft_mesh_cleave(), cleft_mesh_improve() and cleft_mesh_volume() then measure lengths
 *  and angles by M as well: MIN_ANGLE is a goal for angles in the metric. Validity, volumes of labels, the exact box
 *  and the same bytes for any threads stay promised.
 *
 *  If `combine` is nonzero, no length is greater, in any direction, than the computed field with `options` asks for.
 *  Else the library uses the metric unchanged. If SIZE_MIN or SIZE_MAX is set, it bounds the lengths in every
 * direction. With TETS the library scales the metric as cleft_sizing_create() does.
 *
 *  CLEFT_ERROR_NOT_FINITE for NaN and infinity. CLEFT_ERROR_ARGUMENT if a tensor is not positive definite, if it asks
 *  for a length beyond 1e-30 to 1e30, or if its greatest length is more than 10000 times its least. The sentence names
 *  the first such voxel. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create_metric(cleft_context* context, const cleft_volume* volume,
                                                                  cleft_type type, const void* tensors, int32_t combine,
                                                                  const cleft_options* options,
                                                                  cleft_sizing** out) CLEFT_NOEXCEPT;
/** Makes a sizing field with one metric everywhere: xx, xy, xz, yy, yz, zz, as in cleft_sizing_create_metric(). If its
 *  axes are those of the voxels, all kinds of backgrounds meet it exactly: they are made in a stretched box. The
 *  function reads no options. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_create_constant_metric(cleft_context* context,
                                                                           const cleft_volume* volume,
                                                                           const double tensor[6],
                                                                           cleft_sizing** out) CLEFT_NOEXCEPT;
/** Returns 1 if the field has a metric, 0 if it has sizes alone or is NULL. \since 0.1 */
CLEFT_API int32_t cleft_sizing_has_metric(const cleft_sizing* sizing) CLEFT_NOEXCEPT;
/** Copies the metric, in world units and the order of cleft_sizing_create_metric(). The values are single precision
 *  inside, so they may differ in last digits from those given. `capacity` counts floats and must be at least six times
 *  the number of voxels, else CLEFT_ERROR_BUFFER. CLEFT_ERROR_ARGUMENT if the field has no metric. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_copy_metric(const cleft_sizing* sizing, float* tensors,
                                                                int64_t capacity) CLEFT_NOEXCEPT;
/** Destroys a sizing field and the array borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_sizing_destroy(cleft_sizing* sizing) CLEFT_NOEXCEPT;
/** Copies the number of values along each axis. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_dims(const cleft_sizing* sizing, int64_t dims[3]) CLEFT_NOEXCEPT;
/** Copies the affine map from indices of values to world coordinates, 3 rows of 4. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_affine(const cleft_sizing* sizing,
                                                           double affine[12]) CLEFT_NOEXCEPT;
/** Returns the field: one value per voxel, x fastest; borrowed. Of a field with a metric, these are the lengths of
 *  regular tetrahedra that are as large. \since 0.1 */
CLEFT_API const float* cleft_sizing_values(const cleft_sizing* sizing) CLEFT_NOEXCEPT;
/** Gets the field at a world point, interpolated. CLEFT_ERROR_NOT_FINITE for NaN and infinity. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_sizing_at(const cleft_sizing* sizing, const double point[3],
                                                       double* size) CLEFT_NOEXCEPT;
/** Returns the expected number of tetrahedra of a background of this field, within about 10 %; 0 for NULL. It is for
 *  the options that the field was made with: the kind BACKGROUND, and the labels that strip and only keep. Without
 *  options it is for particles and all labels. The metric "sizing.expected_background_tets" has the number for all
 *  labels. cleft_mesh_estimate() estimates the finished mesh. User-supplied sizes that jump from voxel to voxel count
 *  as interpolated. \since 0.1 */
CLEFT_API double cleft_sizing_expected_tets(const cleft_sizing* sizing) CLEFT_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------- background -- */

/** Makes the background mesh of a sizing field, of the kind that BACKGROUND names. It fills the box and does not
 *  depend on the materials: its only label is 0. STEPS and SEED apply to particles. A lattice has one size, the least
 *  of the field. To keep to MAX_TETS the library raises that size, unless SIZE, SIZE_MIN or TETS is set. `options`
 *  may be NULL.
 *
 *  The function does not scale the sizes to TETS: cleft_sizing_create() and cleft_sizing_create_values() do. A warning
 *  reports a field that they did not make with the same TETS.
 *  Options read: BACKGROUND, SIZE, SIZE_MIN, TETS, MAX_TETS, STEPS, SEED, BLOCK and DELAUNAY.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_background_create(cleft_context* context, const cleft_sizing* sizing,
                                                               const cleft_options* options,
                                                               cleft_mesh** out) CLEFT_NOEXCEPT;

/* -------------------------------------------------------------------------------------------------- meshes -- */

/** Makes a mesh from arrays: a user-supplied background, or a finished mesh to check or write. `points` has 3 *
 *  point_count coordinates in the world. `tets` has 4 * tet_count point numbers, counted from `index_base` (0 or 1).
 *  `labels` has tet_count labels; NULL means 0. The library refuses NaN, infinity and point numbers out of range, and
 *  accepts anything else. cleft_mesh_validate() finds further faults. The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_create(cleft_context* context, int64_t point_count,
                                                         const double* points, int64_t tet_count, const int32_t* tets,
                                                         const int32_t* labels, int32_t index_base,
                                                         cleft_mesh** out) CLEFT_NOEXCEPT;
/** Destroys a mesh and the arrays borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_mesh_destroy(cleft_mesh* mesh) CLEFT_NOEXCEPT;

/** Cleaves a background along the interfaces of a volume. `options` may be NULL.
 *
 *  The background must be positively oriented and conforming, else the call returns CLEFT_ERROR_INVALID_MESH and
 *  names the first fault. A background outside the volume's box gives CLEFT_ERROR_ARGUMENT. The background need not
 *  fill the box: a warning gives the filled share, or says that the background extends beyond the box.
 *
 *  If REPAIR is above 0, the library first repairs poor tetrahedra of the background. It leaves backgrounds of
 *  cleft_background_create() as they are.
 *  Options read: SNAP and REPAIR.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_cleave(cleft_context* context, const cleft_volume* volume,
                                                         const cleft_mesh* background, const cleft_options* options,
                                                         cleft_mesh** out) CLEFT_NOEXCEPT;
/** Improves a cleaved mesh of this volume. It raises the worst dihedral angles, fits the volume of each label to that
 *  of its voxels, and orders points and tetrahedra spatially. With IMPROVE off it does only the last. `options` may
 *  be NULL.
 *
 *  CLEFT_ERROR_INVALID_MESH if the mesh is not positively oriented and conforming. Warnings, and failures with
 *  STRICT, are those of cleft_mesh_volume().
 *  Options read: SURFACE_ERROR, IMPROVE, MIN_ANGLE and STRICT.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_improve(cleft_context* context, const cleft_volume* volume,
                                                          const cleft_mesh* mesh, const cleft_options* options,
                                                          cleft_mesh** out) CLEFT_NOEXCEPT;
/** Makes a copy of the mesh without the labels that the strip and only lists of the options leave out. The caller
 *  owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_strip(cleft_context* context, const cleft_mesh* mesh,
                                                        const cleft_options* options, cleft_mesh** out) CLEFT_NOEXCEPT;
/** Makes the mesh of a volume. It does the work of cleft_sizing_create(), cleft_background_create(),
 *  cleft_mesh_cleave(), cleft_mesh_improve() and cleft_mesh_strip(), which give the same bytes if called one by one.
 *  `sizing`, `background` and `options` may be NULL; the call skips the stages whose results it receives.
 *
 *  If both are given, the background decides over sizes, and a warning says that the field has no effect. A metric has
 *  one: the library adapts a background of the user to it if REPAIR is above 0, and measures lengths and angles by it.
 *  Before that the background may have any sizes. It keeps its hull.
 *
 *  With TETS the library corrects the size until the number of kept tetrahedra is within 10 %, in at most eight
 *  rounds. A given sizing field is corrected too, unless it was made with the same TETS and gives the number that was
 *  found then. A given background is not, and a warning says so. Then MAX_TETS has no effect, with one exception. If
 * strip or only leaves labels out, the whole mesh keeps to MAX_TETS, and a warning says if the number is not met.
 *
 *  With STRICT the call returns CLEFT_ERROR_LABEL_LOST if:
 *  - a kept label, or a piece of more than 30 voxels of one, is not in the mesh;
 *  - such a piece broke;
 *  - two kept labels are a cleft_contact.
 *
 *  Without STRICT it returns that status only if no kept label is in the mesh.
 *
 *  One warning (CLEFT_LOG_WARNING) names kept labels of 100 voxels or more whose volume in the mesh differs by more
 *  than 5 % from that of their voxels. Unless IMPROVE is off, another reports tetrahedra whose dihedral angles miss
 *  MIN_ANGLE: their number, the range of their angles, and the voxel of the worst one.
 *  Options read: all but SMOOTH.
 *  The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_volume(cleft_context* context, const cleft_volume* volume,
                                                         const cleft_sizing* sizing, const cleft_mesh* background,
                                                         const cleft_options* options, cleft_mesh** out) CLEFT_NOEXCEPT;

/** The expected size of a mesh. The caller sets struct_size to sizeof(cleft_estimate). \since 0.1 */
typedef struct cleft_estimate {
    uint32_t struct_size;
    int32_t is_rough;       /**< 1 if the numbers may be far off, since several interfaces cross one edge: the sizes are
                             *   large against the parts */
    double tets;            /**< tetrahedra of the finished mesh, in the labels that strip and only keep */
    double whole_tets;      /**< tetrahedra of the mesh before labels are left out */
    double background_tets; /**< tetrahedra of the background */
    double peak_bytes;      /**< an upper bound on the memory of a process that reads the volume and makes the mesh, in
                             *   bytes */
} cleft_estimate;

/** Estimates the mesh that cleft_mesh_volume() makes with the same arguments. The numbers are within 15 % for the
 *  volumes of docs/quality.md. For meshes of fewer than some thousand tetrahedra they may be off by more. Where
 *  is_rough is 1, the memory may be, too. The function makes no mesh. It computes the sizing field unless the caller
 *  gives that or a background.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_estimate(cleft_context* context, const cleft_volume* volume,
                                                           const cleft_sizing* sizing, const cleft_mesh* background,
                                                           const cleft_options* options,
                                                           cleft_estimate* out) CLEFT_NOEXCEPT;

/** Returns the number of points, 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_mesh_point_count(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Returns the world coordinates, x y z interleaved: 3 * point count numbers, borrowed. \since 0.1 */
CLEFT_API const double* cleft_mesh_points(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Returns the number of tetrahedra, 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_mesh_tet_count(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Returns the corners: 4 * tetrahedron count point numbers from 0, borrowed. Each tetrahedron a, b, c, d is
 *  positively oriented: det[b-a, c-a, d-a] > 0. Meshes of cleft_mesh_create() keep the orientation that the caller
 *  gave. \since 0.1 */
CLEFT_API const int32_t* cleft_mesh_tets(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Returns the label of each tetrahedron, borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_mesh_tet_labels(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Returns the number of different labels, 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_mesh_label_count(const cleft_mesh* mesh) CLEFT_NOEXCEPT;
/** Returns the different labels, ascending, borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_mesh_labels(const cleft_mesh* mesh) CLEFT_NOEXCEPT;

/** Sets the name of a label of the mesh, under the rules of cleft_volume_set_label_name(). A mesh of a volume has the
 *  volume's names of the labels that it contains. cleft_mesh_improve() and cleft_mesh_strip() keep the names of their
 *  mesh. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_set_label_name(cleft_mesh* mesh, int32_t label,
                                                                 const char* name) CLEFT_NOEXCEPT;
/** Returns the name of a label in UTF-8, "" if it has none. The text is borrowed until the name is set again or the
 *  mesh is destroyed. \since 0.1 */
CLEFT_API const char* cleft_mesh_label_name(const cleft_mesh* mesh, int32_t label) CLEFT_NOEXCEPT;

/** Copies the coordinates of the points. `capacity` counts doubles and must be at least 3 * point count, else
 *  CLEFT_ERROR_BUFFER. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_points(const cleft_mesh* mesh, double* points,
                                                              int64_t capacity) CLEFT_NOEXCEPT;
/** Copies the corners, counted from `index_base` (0 or 1). `capacity` counts int32_t and must be at least 4 *
 *  tetrahedron count, else CLEFT_ERROR_BUFFER. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_tets(const cleft_mesh* mesh, int32_t index_base, int32_t* tets,
                                                            int64_t capacity) CLEFT_NOEXCEPT;
/** Copies the label of each tetrahedron. `capacity` must be at least the tetrahedron count, else CLEFT_ERROR_BUFFER.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_tet_labels(const cleft_mesh* mesh, int32_t* labels,
                                                                  int64_t capacity) CLEFT_NOEXCEPT;
/** Copies the mesh as ten-node tetrahedra: it adds a point at the middle of each edge. The corners of element t are
 *  tets[10 t .. 10 t + 3]. The midpoints of edges 01, 12, 02, 03, 13, 23 follow, in the order of VTK and Abaqus
 *  C3D10. The first points are those of the mesh. The capacities count numbers: 3 * *point_count doubles and 10 *
 *  tetrahedron count int32_t. To get *point_count alone, pass NULL buffers and zero capacities. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_copy_quadratic(const cleft_mesh* mesh, int32_t index_base,
                                                                 double* points, int64_t point_capacity, int32_t* tets,
                                                                 int64_t tet_capacity,
                                                                 int64_t* point_count) CLEFT_NOEXCEPT;

/** Measures of the shape of a mesh, in world units. The caller sets struct_size to sizeof(cleft_quality). \since 0.1 */
typedef struct cleft_quality {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t tet_count;              /**< number of tetrahedra */
    double min_dihedral;            /**< the least dihedral angle, in degrees */
    double max_dihedral;            /**< the greatest dihedral angle, in degrees */
    int64_t tets_below_5;           /**< tetrahedra whose least dihedral angle is below 5 degrees */
    int64_t tets_below_10;          /**< tetrahedra whose least dihedral angle is below 10 degrees */
    int64_t tets_below_15;          /**< tetrahedra whose least dihedral angle is below 15 degrees */
    int64_t tets_below_20;          /**< tetrahedra whose least dihedral angle is below 20 degrees */
    int64_t tets_above_165;         /**< tetrahedra whose greatest dihedral angle is above 165 degrees */
    double radius_ratio_median;     /**< median of the radius ratio, circumradius / (3 * inradius); the least is 1 */
    double radius_ratio_95;         /**< 95th percentile of the radius ratio */
    double radius_ratio_max;        /**< the greatest radius ratio */
    double edge_ratio_max;          /**< the greatest ratio of longest to shortest edge of one tetrahedron */
    double min_edge;                /**< the length of the shortest edge */
    double mean_edge;               /**< the mean length of an edge */
    double max_edge;                /**< the length of the longest edge */
    double min_volume;              /**< the least volume of a tetrahedron */
    double total_volume;            /**< the volume of all tetrahedra */
    int64_t dihedral_histogram[36]; /**< counts of all dihedral angles, in bins of 5 degrees */
} cleft_quality;

/** Measures a mesh. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_quality(cleft_context* context, const cleft_mesh* mesh,
                                                          cleft_quality* out) CLEFT_NOEXCEPT;

/** How well a mesh meets a metric. A metric measures an edge of the wanted length as 1. The measures are those of the
 *  Unstructured Grid Adaptation Working Group; docs/method.md defines them. The caller sets struct_size to
 *  sizeof(cleft_metric_quality). \since 0.1 */
typedef struct cleft_metric_quality {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t tet_count;              /**< number of tetrahedra */
    int64_t edge_count;             /**< number of edges */
    int64_t edges_in_range;         /**< edges whose length in the metric is within 1/sqrt(2) to sqrt(2) */
    double edge_least;              /**< the least length of an edge in the metric */
    double edge_01;                 /**< 1st percentile of the lengths */
    double edge_median;             /**< median of the lengths */
    double edge_99;                 /**< 99th percentile of the lengths */
    double edge_greatest;           /**< the greatest length */
    double mean_ratio_least;        /**< the least mean ratio: 1 is regular in the metric, 0 flat */
    double mean_ratio_01;           /**< 1st percentile of the mean ratio */
    double mean_ratio_median;       /**< median of the mean ratio */
    double min_dihedral;            /**< the least dihedral angle in the metric, in degrees */
    double max_dihedral;            /**< the greatest dihedral angle in the metric, in degrees */
    int64_t dihedral_histogram[36]; /**< counts of all dihedral angles in the metric, in bins of 5 degrees */
} cleft_metric_quality;

/** Measures a mesh by the metric of a sizing field. Beyond the volume of the field, the metric is that of its outermost
 *  voxels. CLEFT_ERROR_ARGUMENT if the field has no metric. CLEFT_ERROR_INVALID_MESH if a tetrahedron names a point
 *  twice. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_mesh_metric_quality(cleft_context* context, const cleft_mesh* mesh,
                                                                 const cleft_sizing* sizing,
                                                                 cleft_metric_quality* out) CLEFT_NOEXCEPT;

/** The faults of a mesh. All counts of faults are 0 for a valid mesh. The caller sets struct_size to
 *  sizeof(cleft_validation). \since 0.1 */
typedef struct cleft_validation {
    uint32_t struct_size;
    int32_t valid;                /**< 1 if there is no fault */
    int64_t negative_tets;        /**< tetrahedra of negative orientation, by an exact predicate */
    int64_t flat_tets;            /**< tetrahedra that are flat, or of a volume below 1e-12 of their mean edge cubed */
    int64_t repeated_corners;     /**< tetrahedra that name a point twice */
    int64_t crowded_faces;        /**< faces that more than two tetrahedra share */
    int64_t folded_faces;         /**< faces whose two tetrahedra lie on the same side */
    int64_t hull_off_box;         /**< hull triangles that are in no side of the bounding box */
    int64_t open_interface_edges; /**< edges inside the box that only one interface triangle has */
    int64_t unused_points;        /**< points that no tetrahedron uses */
    int64_t repeated_points;      /**< points with the coordinates of another point */
    double volume;                /**< the volume of all tetrahedra */
    double box_volume;            /**< the volume of the bounding box */
    double hull_area;             /**< the area of the hull */
    double box_area;              /**< the area of the bounding box */
    /** faces between tetrahedra of different labels, counted face by face. cleft_surface_interface_count() of the mesh
     *  must be the same */
    int64_t interface_triangles;
    int64_t hull_triangles; /**< faces that only one tetrahedron has; cleft_surface_hull_count() must be the same */
} cleft_validation;

/** Looks for faults of a mesh. A fault is no failure of the call: *out counts the faults, and
 *  cleft_context_last_error() names the first one and its place.
 *
 *  If `fills_box` is nonzero, the mesh must also fill its bounding box, as meshes of cleft_mesh_volume() do. Set it
 *  to 0 for a mesh without some labels (strip, only), and for a mesh of a background that does not fill the box.
 *  \since 0.1 */
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

/** Makes the triangles of a mesh: those between labels (interfaces) and those of the hull. Corners are point numbers
 *  of the mesh. The caller owns *out, which stays valid if the mesh is destroyed. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_surface_create(cleft_context* context, const cleft_mesh* mesh,
                                                            cleft_surface** out) CLEFT_NOEXCEPT;
/** Destroys a surface and the arrays borrowed from it; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_surface_destroy(cleft_surface* surface) CLEFT_NOEXCEPT;
/** Returns the number of triangles between different labels, 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_surface_interface_count(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Returns 3 corners per interface triangle, from 0, sorted by pair of labels, borrowed. Normals point from the first
 *  label of the pair to the second. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_interface_triangles(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Returns the pair of labels of each interface triangle, the lower label first, borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_interface_labels(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Returns the number of hull triangles, 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_surface_hull_count(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Returns 3 corners per hull triangle, from 0, sorted by side, then by label, borrowed. Normals point outward.
 *  \since 0.1 */
CLEFT_API const int32_t* cleft_surface_hull_triangles(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Returns the label of the tetrahedron at each hull triangle, borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_hull_labels(const cleft_surface* surface) CLEFT_NOEXCEPT;
/** Returns the side (CLEFT_SIDE_...) of each hull triangle, borrowed. \since 0.1 */
CLEFT_API const int32_t* cleft_surface_hull_sides(const cleft_surface* surface) CLEFT_NOEXCEPT;

/* ------------------------------------------------------------------------------------------ per-label report -- */

/** What became of one label. Volumes are in cubic world units. A component of voxels is connected over faces of
 *  voxels, a component of the mesh over faces of tetrahedra. The caller sets struct_size to
 *  sizeof(cleft_label_report). \since 0.1 */
typedef struct cleft_label_report {
    uint32_t struct_size;
    int32_t label;                 /**< the label */
    int64_t voxels;                /**< number of its voxels */
    double voxel_volume;           /**< the volume of its voxels */
    double mesh_volume;            /**< the volume of its tetrahedra */
    int64_t tets;                  /**< number of its tetrahedra */
    int64_t voxel_components;      /**< components of its voxels */
    int64_t mesh_components;       /**< components of its tetrahedra */
    int64_t large_components;      /**< voxel components of more than 30 voxels */
    int64_t large_components_lost; /**< large components in which no tetrahedron of the label lies */
    int32_t lost;                  /**< 1 if the label has voxels but no tetrahedron */
    int32_t reserved; /**< large_components_broken, at most 2147483647, for programs older than that field */
    /** large components that lie in several components of the mesh, each with half a voxel or more. Such a part broke
     *  because it is thinner than the tetrahedra around it; a smaller size there keeps it whole */
    int64_t large_components_broken;
    /** large components that share a component of the mesh with another large one, each with half a voxel or more.
     *  They touch over an edge or corner of voxels, or are nearer than one element */
    int64_t large_components_joined;
} cleft_label_report;

/** Compares a finished mesh with its volume, label by label. The mesh must have all labels: call it before
 *  cleft_mesh_strip(). The caller owns *out. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_create(cleft_context* context, const cleft_volume* volume,
                                                           const cleft_mesh* mesh, cleft_report** out) CLEFT_NOEXCEPT;
/** Destroys a report; NULL is allowed. \since 0.1 */
CLEFT_API void cleft_report_destroy(cleft_report* report) CLEFT_NOEXCEPT;
/** Returns the number of rows, one per label of the volume; 0 for NULL. \since 0.1 */
CLEFT_API int64_t cleft_report_count(const cleft_report* report) CLEFT_NOEXCEPT;
/** Gets row `index`, from 0, in the order of cleft_volume_labels(). CLEFT_ERROR_ARGUMENT if there is no such row.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_label(const cleft_report* report, int64_t index,
                                                          cleft_label_report* out) CLEFT_NOEXCEPT;

/** Two labels that share triangles in the mesh, although no two of their voxels share a face or an edge. (Voxels that
 *  share only a corner leave a gap between the labels.) The gap is narrower than the tetrahedra there, and a smaller
 *  size opens it. The caller sets struct_size to sizeof(cleft_contact). \since 0.1 */
typedef struct cleft_contact {
    uint32_t struct_size;
    int32_t first;  /**< the lower of the two labels */
    int32_t second; /**< the higher of the two labels */
    int32_t reserved;
    int64_t triangles; /**< number of triangles that the two labels share */
} cleft_contact;

/** Returns the number of such pairs of labels, 0 for NULL. In a volume of indicator functions, a voxel has the label
 *  of the function that is greatest at its centre. \since 0.1 */
CLEFT_API int64_t cleft_report_contact_count(const cleft_report* report) CLEFT_NOEXCEPT;
/** Gets pair `index`, from 0, in ascending order of the labels. CLEFT_ERROR_ARGUMENT if there is no such pair.
 *  \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_contact(const cleft_report* report, int64_t index,
                                                            cleft_contact* out) CLEFT_NOEXCEPT;

/** How far an interface of the mesh is from that of the volume, in world units, or a line where three labels meet. The
 *  interface of a volume is where two indicator functions are equal and no other is greater; those of a label map are
 *  smooth. `mesh_` stands for distances from places of the triangles (corners, middles of edges, centroids) to the
 *  volume's interface, weighted by area, or from places of edges to the line. `volume_` stands for distances from
 *  points of the volume's interface, about one a voxel, to the triangles or edges. Numbers are 0 where there is nothing
 *  to measure. The caller sets struct_size to sizeof(cleft_distance). \since 0.1 */
typedef struct cleft_distance {
    uint32_t struct_size;
    int32_t first;   /**< the lowest of the labels */
    int32_t second;  /**< the next one */
    int32_t third;   /**< the highest of the labels of a line; for an interface the same as `second` */
    int32_t is_line; /**< 1 if it is a line where three labels meet */
    int32_t reserved;
    int64_t elements;       /**< number of triangles of the interface, or of edges of the line, in the mesh */
    int64_t points;         /**< number of points of the volume's interface or line that were looked at */
    double mesh_mean;       /**< mean distance from the mesh to the volume */
    double mesh_99;         /**< 99 % of the mesh are no farther from the volume */
    double mesh_greatest;   /**< greatest distance from the mesh to the volume */
    double volume_mean;     /**< mean distance from the volume to the mesh */
    double volume_99;       /**< 99 % of the points are no farther from the mesh */
    double volume_greatest; /**< greatest distance from the volume to the mesh */
} cleft_distance;

/** Like cleft_report_create(), and measures how far the interfaces of the mesh are from those of the volume. That takes
 *  about half as long as meshing. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_create_with_distances(cleft_context* context,
                                                                          const cleft_volume* volume,
                                                                          const cleft_mesh* mesh,
                                                                          cleft_report** out) CLEFT_NOEXCEPT;
/** Returns the number of interfaces and lines of a report with distances, 0 of any other and for NULL. \since 0.1 */
CLEFT_API int64_t cleft_report_distance_count(const cleft_report* report) CLEFT_NOEXCEPT;
/** Gets the distances of an interface or line, by `index` from 0: interfaces in ascending order of the labels, then
 *  lines. Where the mesh has two labels meet between which the volume has a third, the distance is the greater of those
 *  to the nearest interface of either label. CLEFT_ERROR_ARGUMENT if there is no such interface or line. \since 0.1 */
CLEFT_NODISCARD CLEFT_API cleft_status cleft_report_distance(const cleft_report* report, int64_t index,
                                                             cleft_distance* out) CLEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
