! Made by tools/generate.py from include/cleft/cleft.h, which is its manual: the C interface of libcleft, one to one.
!
! - Handles are type(c_ptr). What may be NULL in C is a type(c_ptr) here, too: pass c_null_ptr or c_loc(array).
! - Texts that go in end with c_null_char. Texts and arrays that come out are type(c_ptr), borrowed: see c_f_pointer.
! - Numbers that come out are intent(inout), for they are left untouched on failure.
! - Points are numbered from 0, as in C. The module `cleft` numbers them from 1 and needs no pointers.
module cleft_c
  use, intrinsic :: iso_c_binding
  implicit none
  public

  integer(c_int32_t), parameter :: &
    CLEFT_VERSION_MAJOR = 0, &
    CLEFT_VERSION_MINOR = 1, &
    CLEFT_VERSION_PATCH = 0

  integer(c_int32_t), parameter :: &
    CLEFT_OK = 0, &
    CLEFT_ERROR_INTERNAL = -1, &
    CLEFT_ERROR_OUT_OF_MEMORY = -2, &
    CLEFT_ERROR_CANCELLED = -3, &
    CLEFT_ERROR_NULL = -4, &
    CLEFT_ERROR_ARGUMENT = -5, &
    CLEFT_ERROR_NOT_FINITE = -6, &
    CLEFT_ERROR_TOO_LARGE = -7, &
    CLEFT_ERROR_BUFFER = -8, &
    CLEFT_ERROR_OPTION = -9, &
    CLEFT_ERROR_UNSUPPORTED = -10, &
    CLEFT_ERROR_INVALID_MESH = -11, &
    CLEFT_ERROR_LABEL_LOST = -12, &
    CLEFT_ERROR_FILE = -13, &
    CLEFT_ERROR_FORMAT = -14, &
    CLEFT_ERROR_HANDLE = -15, &
    CLEFT_ERROR_BUSY = -16, &
    CLEFT_ERROR_EXCHANGE = -17

  integer(c_int32_t), parameter :: &
    CLEFT_LOG_WARNING = 1, &
    CLEFT_LOG_INFO = 2, &
    CLEFT_LOG_DEBUG = 3

  integer(c_int32_t), parameter :: &
    CLEFT_OPTION_BACKGROUND = 1, &
    CLEFT_OPTION_SIZE = 2, &
    CLEFT_OPTION_SIZE_MIN = 3, &
    CLEFT_OPTION_SIZE_MAX = 4, &
    CLEFT_OPTION_FEATURE_SCALE = 5, &
    CLEFT_OPTION_GRADATION = 6, &
    CLEFT_OPTION_INTERFACE_SIZE = 7, &
    CLEFT_OPTION_TETS = 8, &
    CLEFT_OPTION_SMOOTH = 9, &
    CLEFT_OPTION_SNAP = 10, &
    CLEFT_OPTION_IMPROVE = 11, &
    CLEFT_OPTION_STEPS = 12, &
    CLEFT_OPTION_SEED = 13, &
    CLEFT_OPTION_STRICT = 14, &
    CLEFT_OPTION_REPAIR = 15, &
    CLEFT_OPTION_MAX_TETS = 16, &
    CLEFT_OPTION_KEEP_THIN = 17, &
    CLEFT_OPTION_MIN_ANGLE = 18, &
    CLEFT_OPTION_DELAUNAY = 19, &
    CLEFT_OPTION_SURFACE_ERROR = 20, &
    CLEFT_OPTION_ANISOTROPY = 21, &
    CLEFT_OPTION_BLOCK = 22

  integer(c_int32_t), parameter :: &
    CLEFT_BACKGROUND_PARTICLES = 0, &
    CLEFT_BACKGROUND_LATTICE = 1, &
    CLEFT_BACKGROUND_OCTREE = 2

  integer(c_int32_t), parameter :: &
    CLEFT_SNAP_QUALITY = 0, &
    CLEFT_SNAP_SAFE = 1, &
    CLEFT_SNAP_NONE = 2

  integer(c_int32_t), parameter :: &
    CLEFT_IMPROVE_OFF = 0, &
    CLEFT_IMPROVE_FAST = 1, &
    CLEFT_IMPROVE_BEST = 2

  integer(c_int32_t), parameter :: &
    CLEFT_DELAUNAY_CLEFT = 0, &
    CLEFT_DELAUNAY_TETGEN = 1

  integer(c_int32_t), parameter :: &
    CLEFT_OPTION_TYPE_INTEGER = 1, &
    CLEFT_OPTION_TYPE_REAL = 2, &
    CLEFT_OPTION_TYPE_CHOICE = 3, &
    CLEFT_OPTION_TYPE_FLAG = 4

  integer(c_int32_t), parameter :: &
    CLEFT_TYPE_UINT8 = 1, &
    CLEFT_TYPE_UINT16 = 2, &
    CLEFT_TYPE_INT16 = 3, &
    CLEFT_TYPE_UINT32 = 4, &
    CLEFT_TYPE_INT32 = 5, &
    CLEFT_TYPE_FLOAT32 = 6, &
    CLEFT_TYPE_FLOAT64 = 7

  integer(c_int32_t), parameter :: &
    CLEFT_SIDE_X_MIN = 0, &
    CLEFT_SIDE_X_MAX = 1, &
    CLEFT_SIDE_Y_MIN = 2, &
    CLEFT_SIDE_Y_MAX = 3, &
    CLEFT_SIDE_Z_MIN = 4, &
    CLEFT_SIDE_Z_MAX = 5, &
    CLEFT_SIDE_OTHER = 6

  type, bind(C) :: cleft_option_description
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: key
    integer(c_int32_t) :: type
    type(c_ptr) :: name
    real(c_double) :: value
    real(c_double) :: least
    real(c_double) :: greatest
    type(c_ptr) :: choices
    type(c_ptr) :: text
    type(c_ptr) :: group
    type(c_ptr) :: calls
  end type

  type, bind(C) :: cleft_estimate
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: is_rough
    real(c_double) :: tets
    real(c_double) :: whole_tets
    real(c_double) :: background_tets
    real(c_double) :: peak_bytes
  end type

  type, bind(C) :: cleft_quality
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: tet_count
    real(c_double) :: min_dihedral
    real(c_double) :: max_dihedral
    integer(c_int64_t) :: tets_below_5
    integer(c_int64_t) :: tets_below_10
    integer(c_int64_t) :: tets_below_15
    integer(c_int64_t) :: tets_below_20
    integer(c_int64_t) :: tets_above_165
    real(c_double) :: radius_ratio_median
    real(c_double) :: radius_ratio_95
    real(c_double) :: radius_ratio_max
    real(c_double) :: edge_ratio_max
    real(c_double) :: min_edge
    real(c_double) :: mean_edge
    real(c_double) :: max_edge
    real(c_double) :: min_volume
    real(c_double) :: total_volume
    integer(c_int64_t) :: dihedral_histogram(36)
  end type

  type, bind(C) :: cleft_metric_quality
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: tet_count
    integer(c_int64_t) :: edge_count
    integer(c_int64_t) :: edges_in_range
    real(c_double) :: edge_least
    real(c_double) :: edge_01
    real(c_double) :: edge_median
    real(c_double) :: edge_99
    real(c_double) :: edge_greatest
    real(c_double) :: mean_ratio_least
    real(c_double) :: mean_ratio_01
    real(c_double) :: mean_ratio_median
    real(c_double) :: min_dihedral
    real(c_double) :: max_dihedral
    integer(c_int64_t) :: dihedral_histogram(36)
  end type

  type, bind(C) :: cleft_validation
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: valid
    integer(c_int64_t) :: negative_tets
    integer(c_int64_t) :: flat_tets
    integer(c_int64_t) :: repeated_corners
    integer(c_int64_t) :: crowded_faces
    integer(c_int64_t) :: folded_faces
    integer(c_int64_t) :: hull_off_box
    integer(c_int64_t) :: open_interface_edges
    integer(c_int64_t) :: unused_points
    integer(c_int64_t) :: repeated_points
    real(c_double) :: volume
    real(c_double) :: box_volume
    real(c_double) :: hull_area
    real(c_double) :: box_area
    integer(c_int64_t) :: interface_triangles
    integer(c_int64_t) :: hull_triangles
  end type

  type, bind(C) :: cleft_label_report
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: label
    integer(c_int64_t) :: voxels
    real(c_double) :: voxel_volume
    real(c_double) :: mesh_volume
    integer(c_int64_t) :: tets
    integer(c_int64_t) :: voxel_components
    integer(c_int64_t) :: mesh_components
    integer(c_int64_t) :: large_components
    integer(c_int64_t) :: large_components_lost
    integer(c_int32_t) :: lost
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: large_components_broken
    integer(c_int64_t) :: large_components_joined
  end type

  type, bind(C) :: cleft_contact
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: first
    integer(c_int32_t) :: second
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: triangles
  end type

  type, bind(C) :: cleft_distance
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: first
    integer(c_int32_t) :: second
    integer(c_int32_t) :: third
    integer(c_int32_t) :: is_line
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: elements
    integer(c_int64_t) :: points
    real(c_double) :: mesh_mean
    real(c_double) :: mesh_99
    real(c_double) :: mesh_greatest
    real(c_double) :: volume_mean
    real(c_double) :: volume_99
    real(c_double) :: volume_greatest
  end type

  abstract interface

    function cleft_progress_callback(fraction, stage, user) bind(C) result(answer)
      import
      real(c_double), value :: fraction
      type(c_ptr), value :: stage, user
      integer(c_int) :: answer
    end function

    subroutine cleft_log_callback(level, sentence, user) bind(C)
      import
      integer(c_int32_t), value :: level
      type(c_ptr), value :: sentence, user
    end subroutine

  end interface

  interface

    ! --------------------------------------------------------------------------------------------------------- version

    function cleft_version(major, minor, patch) bind(C) result(answer)
      import
      type(c_ptr), value :: major, minor, patch
      type(c_ptr) :: answer
    end function

    function cleft_status_string(status) bind(C) result(answer)
      import
      integer(c_int32_t), value :: status
      type(c_ptr) :: answer
    end function

    function cleft_has_tetgen() bind(C) result(answer)
      import
      integer(c_int32_t) :: answer
    end function

    ! --------------------------------------------------------------------------------------------------------- context

    function cleft_context_create(out) bind(C) result(answer)
      import
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_context_destroy(context) bind(C)
      import
      type(c_ptr), value :: context
    end subroutine

    function cleft_context_last_error(context) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      type(c_ptr) :: answer
    end function

    function cleft_context_set_error(context, status, sentence) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: status
      character(kind=c_char), intent(in) :: sentence(*)
      integer(c_int32_t) :: answer
    end function

    function cleft_context_set_threads(context, threads) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: threads
      integer(c_int32_t) :: answer
    end function

    function cleft_context_threads(context) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t) :: answer
    end function

    function cleft_context_set_progress(context, callback, user) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      type(c_funptr), value :: callback
      type(c_ptr), value :: user
      integer(c_int32_t) :: answer
    end function

    function cleft_context_set_log(context, callback, user) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      type(c_funptr), value :: callback
      type(c_ptr), value :: user
      integer(c_int32_t) :: answer
    end function

    function cleft_context_log(context, level, sentence) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: level
      character(kind=c_char), intent(in) :: sentence(*)
      integer(c_int32_t) :: answer
    end function

    function cleft_context_begin(context, handles, count) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      type(c_ptr), intent(in) :: handles(*)
      integer(c_int64_t), value :: count
      integer(c_int32_t) :: answer
    end function

    function cleft_context_report(context, fraction, end, stage) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      real(c_double), value :: fraction, end
      character(kind=c_char), intent(in) :: stage(*)
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_context_end(context) bind(C)
      import
      type(c_ptr), value :: context
    end subroutine

    function cleft_context_cancel(context) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t) :: answer
    end function

    function cleft_context_metric_count(context) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int64_t) :: answer
    end function

    function cleft_context_metric(context, index, name, value) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int64_t), value :: index
      type(c_ptr), intent(out) :: name
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: answer
    end function

    function cleft_context_clear_metrics(context) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t) :: answer
    end function

    ! --------------------------------------------------------------------------------------------------------- options

    function cleft_option_count() bind(C) result(answer)
      import
      integer(c_int32_t) :: answer
    end function

    function cleft_option_info(index, out) bind(C) result(answer)
      import
      integer(c_int32_t), value :: index
      type(cleft_option_description), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_options_create(out) bind(C) result(answer)
      import
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_options_destroy(options) bind(C)
      import
      type(c_ptr), value :: options
    end subroutine

    function cleft_options_last_error(options) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      type(c_ptr) :: answer
    end function

    function cleft_options_set_integer(options, key, value) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      integer(c_int32_t), value :: key
      integer(c_int64_t), value :: value
      integer(c_int32_t) :: answer
    end function

    function cleft_options_set_real(options, key, value) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      integer(c_int32_t), value :: key
      real(c_double), value :: value
      integer(c_int32_t) :: answer
    end function

    function cleft_options_set_text(options, name, value) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: name(*), value
      integer(c_int32_t) :: answer
    end function

    function cleft_options_get_integer(options, key, value) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      integer(c_int32_t), value :: key
      integer(c_int64_t), intent(inout) :: value
      integer(c_int32_t) :: answer
    end function

    function cleft_options_get_real(options, key, value) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      integer(c_int32_t), value :: key
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: answer
    end function

    function cleft_options_set_label_size(options, label, size) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      integer(c_int32_t), value :: label
      real(c_double), value :: size
      integer(c_int32_t) :: answer
    end function

    function cleft_options_set_strip(options, labels, count) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      integer(c_int32_t), intent(in) :: labels(*)
      integer(c_int64_t), value :: count
      integer(c_int32_t) :: answer
    end function

    function cleft_options_set_only(options, labels, count) bind(C) result(answer)
      import
      type(c_ptr), value :: options
      integer(c_int32_t), intent(in) :: labels(*)
      integer(c_int64_t), value :: count
      integer(c_int32_t) :: answer
    end function

    ! ---------------------------------------------------------------------------------------------------------- volume

    function cleft_volume_create_labels(context, type, voxels, dims, affine, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: type
      type(c_ptr), value :: voxels
      integer(c_int64_t), intent(in) :: dims(3)
      type(c_ptr), value :: affine, options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_volume_create_indicators(context, type, fields, count, dims, affine, labels, out) bind(C) &
      result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: type
      type(c_ptr), intent(in) :: fields(*)
      integer(c_int64_t), value :: count
      integer(c_int64_t), intent(in) :: dims(3)
      type(c_ptr), value :: affine, labels
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_volume_destroy(volume) bind(C)
      import
      type(c_ptr), value :: volume
    end subroutine

    function cleft_volume_dims(volume, dims) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      integer(c_int64_t), intent(inout) :: dims(3)
      integer(c_int32_t) :: answer
    end function

    function cleft_volume_affine(volume, affine) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      real(c_double), intent(inout) :: affine(12)
      integer(c_int32_t) :: answer
    end function

    function cleft_volume_label_count(volume) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      integer(c_int64_t) :: answer
    end function

    function cleft_volume_labels(volume) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      type(c_ptr) :: answer
    end function

    function cleft_volume_indicator_count(volume) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      integer(c_int64_t) :: answer
    end function

    function cleft_volume_set_label_name(volume, label, name) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      integer(c_int32_t), value :: label
      type(c_ptr), value :: name
      integer(c_int32_t) :: answer
    end function

    function cleft_volume_label_name(volume, label) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      integer(c_int32_t), value :: label
      type(c_ptr) :: answer
    end function

    function cleft_volume_copy_voxel_counts(volume, counts, capacity) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      integer(c_int64_t), intent(inout) :: counts(*)
      integer(c_int64_t), value :: capacity
      integer(c_int32_t) :: answer
    end function

    function cleft_volume_sample(volume, points, count, labels) bind(C) result(answer)
      import
      type(c_ptr), value :: volume
      real(c_double), intent(in) :: points(*)
      integer(c_int64_t), value :: count
      integer(c_int32_t), intent(inout) :: labels(*)
      integer(c_int32_t) :: answer
    end function

    ! ---------------------------------------------------------------------------------------------------------- sizing

    function cleft_sizing_create(context, volume, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume, options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_create_constant(context, volume, size, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume
      real(c_double), value :: size
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_create_values(context, volume, type, values, combine, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume
      integer(c_int32_t), value :: type
      type(c_ptr), value :: values
      integer(c_int32_t), value :: combine
      type(c_ptr), value :: options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_create_metric(context, volume, type, tensors, combine, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume
      integer(c_int32_t), value :: type
      type(c_ptr), value :: tensors
      integer(c_int32_t), value :: combine
      type(c_ptr), value :: options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_create_constant_metric(context, volume, tensor, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume
      real(c_double), intent(in) :: tensor(6)
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_has_metric(sizing) bind(C) result(answer)
      import
      type(c_ptr), value :: sizing
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_copy_metric(sizing, tensors, capacity) bind(C) result(answer)
      import
      type(c_ptr), value :: sizing
      real(c_float), intent(inout) :: tensors(*)
      integer(c_int64_t), value :: capacity
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_sizing_destroy(sizing) bind(C)
      import
      type(c_ptr), value :: sizing
    end subroutine

    function cleft_sizing_dims(sizing, dims) bind(C) result(answer)
      import
      type(c_ptr), value :: sizing
      integer(c_int64_t), intent(inout) :: dims(3)
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_affine(sizing, affine) bind(C) result(answer)
      import
      type(c_ptr), value :: sizing
      real(c_double), intent(inout) :: affine(12)
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_values(sizing) bind(C) result(answer)
      import
      type(c_ptr), value :: sizing
      type(c_ptr) :: answer
    end function

    function cleft_sizing_at(sizing, point, size) bind(C) result(answer)
      import
      type(c_ptr), value :: sizing
      real(c_double), intent(in) :: point(3)
      real(c_double), intent(inout) :: size
      integer(c_int32_t) :: answer
    end function

    function cleft_sizing_expected_tets(sizing) bind(C) result(answer)
      import
      type(c_ptr), value :: sizing
      real(c_double) :: answer
    end function

    ! ------------------------------------------------------------------------------------------------------ background

    function cleft_background_create(context, sizing, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, sizing, options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    ! ---------------------------------------------------------------------------------------------------------- meshes

    function cleft_mesh_create(context, point_count, points, tet_count, tets, labels, index_base, out) bind(C) &
      result(answer)
      import
      type(c_ptr), value :: context
      integer(c_int64_t), value :: point_count
      real(c_double), intent(in) :: points(*)
      integer(c_int64_t), value :: tet_count
      integer(c_int32_t), intent(in) :: tets(*)
      type(c_ptr), value :: labels
      integer(c_int32_t), value :: index_base
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_mesh_destroy(mesh) bind(C)
      import
      type(c_ptr), value :: mesh
    end subroutine

    function cleft_mesh_cleave(context, volume, background, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume, background, options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_improve(context, volume, mesh, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume, mesh, options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_strip(context, mesh, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, mesh, options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_volume(context, volume, sizing, background, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume, sizing, background, options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_estimate(context, volume, sizing, background, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume, sizing, background, options
      type(cleft_estimate), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_point_count(mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int64_t) :: answer
    end function

    function cleft_mesh_points(mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      type(c_ptr) :: answer
    end function

    function cleft_mesh_tet_count(mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int64_t) :: answer
    end function

    function cleft_mesh_tets(mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      type(c_ptr) :: answer
    end function

    function cleft_mesh_tet_labels(mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      type(c_ptr) :: answer
    end function

    function cleft_mesh_label_count(mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int64_t) :: answer
    end function

    function cleft_mesh_labels(mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      type(c_ptr) :: answer
    end function

    function cleft_mesh_set_label_name(mesh, label, name) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int32_t), value :: label
      type(c_ptr), value :: name
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_label_name(mesh, label) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int32_t), value :: label
      type(c_ptr) :: answer
    end function

    function cleft_mesh_copy_points(mesh, points, capacity) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      real(c_double), intent(inout) :: points(*)
      integer(c_int64_t), value :: capacity
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_copy_tets(mesh, index_base, tets, capacity) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int32_t), value :: index_base
      integer(c_int32_t), intent(inout) :: tets(*)
      integer(c_int64_t), value :: capacity
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_copy_tet_labels(mesh, labels, capacity) bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int32_t), intent(inout) :: labels(*)
      integer(c_int64_t), value :: capacity
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_copy_quadratic(mesh, index_base, points, point_capacity, tets, tet_capacity, point_count) &
      bind(C) result(answer)
      import
      type(c_ptr), value :: mesh
      integer(c_int32_t), value :: index_base
      type(c_ptr), value :: points
      integer(c_int64_t), value :: point_capacity
      type(c_ptr), value :: tets
      integer(c_int64_t), value :: tet_capacity
      integer(c_int64_t), intent(inout) :: point_count
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_quality(context, mesh, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, mesh
      type(cleft_quality), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_metric_quality(context, mesh, sizing, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, mesh, sizing
      type(cleft_metric_quality), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_mesh_validate(context, mesh, fills_box, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, mesh
      integer(c_int32_t), value :: fills_box
      type(cleft_validation), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    ! -------------------------------------------------------------------------------------------------------- surfaces

    function cleft_surface_create(context, mesh, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, mesh
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_surface_destroy(surface) bind(C)
      import
      type(c_ptr), value :: surface
    end subroutine

    function cleft_surface_interface_count(surface) bind(C) result(answer)
      import
      type(c_ptr), value :: surface
      integer(c_int64_t) :: answer
    end function

    function cleft_surface_interface_triangles(surface) bind(C) result(answer)
      import
      type(c_ptr), value :: surface
      type(c_ptr) :: answer
    end function

    function cleft_surface_interface_labels(surface) bind(C) result(answer)
      import
      type(c_ptr), value :: surface
      type(c_ptr) :: answer
    end function

    function cleft_surface_hull_count(surface) bind(C) result(answer)
      import
      type(c_ptr), value :: surface
      integer(c_int64_t) :: answer
    end function

    function cleft_surface_hull_triangles(surface) bind(C) result(answer)
      import
      type(c_ptr), value :: surface
      type(c_ptr) :: answer
    end function

    function cleft_surface_hull_labels(surface) bind(C) result(answer)
      import
      type(c_ptr), value :: surface
      type(c_ptr) :: answer
    end function

    function cleft_surface_hull_sides(surface) bind(C) result(answer)
      import
      type(c_ptr), value :: surface
      type(c_ptr) :: answer
    end function

    ! ------------------------------------------------------------------------------------------------ per-label report

    function cleft_report_create(context, volume, mesh, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume, mesh
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_report_destroy(report) bind(C)
      import
      type(c_ptr), value :: report
    end subroutine

    function cleft_report_count(report) bind(C) result(answer)
      import
      type(c_ptr), value :: report
      integer(c_int64_t) :: answer
    end function

    function cleft_report_label(report, index, out) bind(C) result(answer)
      import
      type(c_ptr), value :: report
      integer(c_int64_t), value :: index
      type(cleft_label_report), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_report_contact_count(report) bind(C) result(answer)
      import
      type(c_ptr), value :: report
      integer(c_int64_t) :: answer
    end function

    function cleft_report_contact(report, index, out) bind(C) result(answer)
      import
      type(c_ptr), value :: report
      integer(c_int64_t), value :: index
      type(cleft_contact), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_report_create_with_distances(context, volume, mesh, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume, mesh
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_report_distance_count(report) bind(C) result(answer)
      import
      type(c_ptr), value :: report
      integer(c_int64_t) :: answer
    end function

    function cleft_report_distance(report, index, out) bind(C) result(answer)
      import
      type(c_ptr), value :: report
      integer(c_int64_t), value :: index
      type(cleft_distance), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

  end interface

end module cleft_c
