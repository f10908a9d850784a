! Made by tools/generate.py from include/cleft/cleft_io.h, which is its manual: the C interface of the file
! component, one to one. Conventions: see cleft_c.
module cleft_io_c
  use, intrinsic :: iso_c_binding
  use cleft_c
  implicit none
  public

  integer(c_int32_t), parameter :: &
    CLEFT_FORMAT_BY_NAME = 0, &
    CLEFT_FORMAT_VTU = 1, &
    CLEFT_FORMAT_VTP = 2, &
    CLEFT_FORMAT_VTK = 3, &
    CLEFT_FORMAT_MEDIT = 4, &
    CLEFT_FORMAT_MSH41 = 5, &
    CLEFT_FORMAT_MSH22 = 6, &
    CLEFT_FORMAT_ABAQUS = 7, &
    CLEFT_FORMAT_TETGEN = 8, &
    CLEFT_FORMAT_STL = 9, &
    CLEFT_FORMAT_PLY = 10, &
    CLEFT_FORMAT_VTKHDF = 11, &
    CLEFT_FORMAT_PVTU = 12

  integer(c_int32_t), parameter :: &
    CLEFT_IO_READS_MESH = 1, &
    CLEFT_IO_WRITES_MESH = 2, &
    CLEFT_IO_READS_VOLUME = 4, &
    CLEFT_IO_WRITES_SIZING = 8

  integer(c_int32_t), parameter :: &
    CLEFT_IO_UNKNOWN = 0, &
    CLEFT_IO_VOLUME = 1, &
    CLEFT_IO_MESH = 2

  integer(c_int32_t), parameter :: &
    CLEFT_IO_WORLD_LPS = 0, &
    CLEFT_IO_WORLD_RAS = 1

  integer(c_int32_t), parameter :: &
    CLEFT_IO_KIND_AUTO = 0, &
    CLEFT_IO_KIND_LABELS = 1, &
    CLEFT_IO_KIND_INDICATORS = 2

  integer(c_int32_t), parameter :: &
    CLEFT_IO_ORDER_FILE = 0, &
    CLEFT_IO_ORDER_NRRD = 1, &
    CLEFT_IO_ORDER_VTK = 2, &
    CLEFT_IO_ORDER_NIFTI = 3

  integer(c_int32_t), parameter :: &
    CLEFT_IO_BY_LABEL = 0, &
    CLEFT_IO_BY_ANGLE = 1, &
    CLEFT_IO_BY_RATIO = 2, &
    CLEFT_IO_BY_SIZE = 3

  integer(c_int32_t), parameter :: &
    CLEFT_IO_BACKDROP_LIGHT = 0, &
    CLEFT_IO_BACKDROP_DARK = 1, &
    CLEFT_IO_BACKDROP_NONE = 2

  type, bind(C) :: cleft_io_format_description
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: format
    integer(c_int32_t) :: directions
    integer(c_int32_t) :: reserved
    type(c_ptr) :: name
    type(c_ptr) :: extensions
    type(c_ptr) :: text
  end type

  type, bind(C) :: cleft_io_reading
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: world
    integer(c_int32_t) :: kind
    integer(c_int32_t) :: reserved
    real(c_double) :: spacing(3)
    real(c_double) :: scale
  end type

  type, bind(C) :: cleft_io_raw
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: type
    integer(c_int32_t) :: big_endian
    integer(c_int32_t) :: kind
    integer(c_int64_t) :: skip
    integer(c_int64_t) :: dims(3)
    real(c_double) :: spacing(3)
  end type

  type, bind(C) :: cleft_io_picture
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: by
    integer(c_int32_t) :: width
    integer(c_int32_t) :: height
    integer(c_int32_t) :: backdrop
    integer(c_int32_t) :: no_edges
    integer(c_int32_t) :: legend
    integer(c_int32_t) :: reserved
    real(c_double) :: cut(3)
    real(c_double) :: view(3)
    real(c_double) :: up(3)
    real(c_double) :: zoom
    real(c_double) :: line_width
    real(c_double) :: range(2)
  end type

  type, bind(C) :: cleft_io_view
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: reserved
    integer(c_int64_t) :: max_tets
    real(c_double) :: goal
    type(c_ptr) :: title
    type(c_ptr) :: report
    type(c_ptr) :: names
    type(c_ptr) :: other
    type(c_ptr) :: other_title
    type(c_ptr) :: other_report
  end type

  interface

    ! --------------------------------------------------------------------------------------------------------- formats

    function cleft_io_format_count() bind(C) result(answer)
      import
      integer(c_int32_t) :: answer
    end function

    function cleft_io_format_info(index, out) bind(C) result(answer)
      import
      integer(c_int32_t), value :: index
      type(cleft_io_format_description), intent(inout) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_io_guess(path) bind(C) result(answer)
      import
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: answer
    end function

    ! --------------------------------------------------------------------------------------------------------- volumes

    function cleft_io_read_volume(context, options, paths, count, reading, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, options
      type(c_ptr), intent(in) :: paths(*)
      integer(c_int64_t), value :: count
      type(c_ptr), value :: reading
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_io_read_raw(context, options, paths, count, raw, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, options
      type(c_ptr), intent(in) :: paths(*)
      integer(c_int64_t), value :: count
      type(cleft_io_raw), intent(in) :: raw
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    ! --------------------------------------------------------------------------------------------------- sizing fields

    function cleft_io_write_sizing(context, sizing, path, world) bind(C) result(answer)
      import
      type(c_ptr), value :: context, sizing
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t), value :: world
      integer(c_int32_t) :: answer
    end function

    function cleft_io_read_field(context, path, reading, dims, affine, values) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: reading, dims, affine
      type(c_ptr), intent(out) :: values
      integer(c_int32_t) :: answer
    end function

    subroutine cleft_io_free(array) bind(C)
      import
      type(c_ptr), value :: array
    end subroutine

    function cleft_io_read_sizing(context, volume, path, reading, combine, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: reading
      integer(c_int32_t), value :: combine
      type(c_ptr), value :: options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    function cleft_io_read_metric(context, volume, path, reading, order, combine, options, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context, volume
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: reading
      integer(c_int32_t), value :: order, combine
      type(c_ptr), value :: options
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    ! ---------------------------------------------------------------------------------------------------------- meshes

    function cleft_io_write_mesh(context, mesh, path, format) bind(C) result(answer)
      import
      type(c_ptr), value :: context, mesh
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t), value :: format
      integer(c_int32_t) :: answer
    end function

    function cleft_io_read_mesh(context, path, out) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: out
      integer(c_int32_t) :: answer
    end function

    ! ----------------------------------------------------------------------------------------------------------- names

    function cleft_io_read_volume_names(context, path, volume) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: volume
      integer(c_int32_t) :: answer
    end function

    function cleft_io_read_mesh_names(context, path, mesh) bind(C) result(answer)
      import
      type(c_ptr), value :: context
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: mesh
      integer(c_int32_t) :: answer
    end function

    ! -------------------------------------------------------------------------------------------------------- pictures

    function cleft_io_write_picture(context, mesh, strip, strip_count, whole, whole_count, picture, path) bind(C) &
      result(answer)
      import
      type(c_ptr), value :: context, mesh, strip
      integer(c_int64_t), value :: strip_count
      type(c_ptr), value :: whole
      integer(c_int64_t), value :: whole_count
      type(c_ptr), value :: picture
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: answer
    end function

    ! ----------------------------------------------------------------------------------------------------------- views

    function cleft_io_write_view(context, mesh, view, path) bind(C) result(answer)
      import
      type(c_ptr), value :: context, mesh, view
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: answer
    end function

  end interface

end module cleft_io_c
