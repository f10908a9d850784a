! Sizing fields: the wanted edge length at each point.
module cleft_sizings
  use, intrinsic :: iso_c_binding
  use cleft_c
  use cleft_support
  use cleft_handles
  use cleft_contexts
  use cleft_option_sets
  use cleft_volumes
  implicit none
  private
  public :: cleft_sizing

  ! Immutable once made; given back when it goes out of scope. It cannot be copied.
  type, extends(cleft_handle) :: cleft_sizing
  contains
    procedure :: create
    procedure :: create_constant
    generic :: create_values => create_values_32, create_values_64
    procedure :: create_constant_metric
    generic :: create_metric => create_metric_32, create_metric_64
    procedure :: dims
    procedure :: affine
    procedure :: values
    procedure :: has_metric
    procedure :: metric
    procedure :: at
    procedure :: expected_tets
    procedure :: adopt
    procedure, private :: create_values_32, create_values_64, create_any
    procedure, private :: create_metric_32, create_metric_64, create_any_metric
  end type

  character(len=*), parameter :: closed = 'the sizing field is not there: destroyed, or never made'

contains

  ! From the features of a volume.
  subroutine create(self, context, volume, options, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_sizing_create(context%c_handle(), volume%c_handle(), c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! One size everywhere.
  subroutine create_constant(self, context, volume, size, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    real(c_double), intent(in) :: size
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_sizing_create_constant(context%c_handle(), volume%c_handle(), size, made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Your own field: one value for each voxel. With `combine`, the smaller of it and the one of create() is taken.
  subroutine create_values_32(self, context, volume, values, combine, options, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    real(c_float), intent(in), contiguous, target :: values(:, :, :)
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%create_any(context, volume, CLEFT_TYPE_FLOAT32, c_loc(values), shape(values), &
      combine, options, stat, errmsg)
  end subroutine

  subroutine create_values_64(self, context, volume, values, combine, options, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    real(c_double), intent(in), contiguous, target :: values(:, :, :)
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%create_any(context, volume, CLEFT_TYPE_FLOAT64, c_loc(values), shape(values), &
      combine, options, stat, errmsg)
  end subroutine

  subroutine create_any(self, context, volume, type, values, counts, combine, options, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    integer(c_int32_t), intent(in) :: type
    type(c_ptr), intent(in) :: values
    integer, intent(in) :: counts(3)
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status, c_combine
    integer :: wanted(3), there

    call self%destroy()
    wanted = volume%dims(there)
    if (there == CLEFT_OK .and. any(counts /= wanted)) then
      call conclude(CLEFT_ERROR_ARGUMENT, 'values must have the shape of the volume', stat, errmsg)
      return
    end if
    c_combine = 0
    if (present(combine)) c_combine = merge(1_c_int32_t, 0_c_int32_t, combine)
    status = cleft_sizing_create_values(context%c_handle(), volume%c_handle(), type, values, c_combine, &
      c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! One metric everywhere: xx, xy, xz, yy, yz, zz. An edge v is to have v M v = 1.
  subroutine create_constant_metric(self, context, volume, tensor, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    real(c_double), intent(in) :: tensor(6)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_sizing_create_constant_metric(context%c_handle(), volume%c_handle(), tensor, made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Your own metric: tensors(:, i, j, k) has xx, xy, xz, yy, yz, zz of a voxel. With `combine`, no length is greater
  ! than that of create().
  subroutine create_metric_32(self, context, volume, tensors, combine, options, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    real(c_float), intent(in), contiguous, target :: tensors(:, :, :, :)
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%create_any_metric(context, volume, CLEFT_TYPE_FLOAT32, c_loc(tensors), shape(tensors), &
      combine, options, stat, errmsg)
  end subroutine

  subroutine create_metric_64(self, context, volume, tensors, combine, options, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    real(c_double), intent(in), contiguous, target :: tensors(:, :, :, :)
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%create_any_metric(context, volume, CLEFT_TYPE_FLOAT64, c_loc(tensors), shape(tensors), &
      combine, options, stat, errmsg)
  end subroutine

  subroutine create_any_metric(self, context, volume, type, tensors, counts, combine, options, stat, errmsg)
    class(cleft_sizing), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    integer(c_int32_t), intent(in) :: type
    type(c_ptr), intent(in) :: tensors
    integer, intent(in) :: counts(4)
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status, c_combine
    integer :: wanted(3), there

    call self%destroy()
    wanted = volume%dims(there)
    if (there == CLEFT_OK .and. any(counts /= [6, wanted])) then
      call conclude(CLEFT_ERROR_ARGUMENT, 'tensors must have the shape 6, then that of the volume', stat, errmsg)
      return
    end if
    c_combine = 0
    if (present(combine)) c_combine = merge(1_c_int32_t, 0_c_int32_t, combine)
    status = cleft_sizing_create_metric(context%c_handle(), volume%c_handle(), type, tensors, c_combine, &
      c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Voxels along x, y, z.
  function dims(self, stat, errmsg) result(counts)
    class(cleft_sizing), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer :: counts(3)
    integer(c_int64_t) :: c_dims(3)
    c_dims = 0
    call conclude(cleft_sizing_dims(self%c_handle(), c_dims), closed, stat, errmsg)
    counts = int(c_dims)
  end function

  ! From voxel indices, counted from 0, to the world.
  function affine(self, stat, errmsg) result(map)
    class(cleft_sizing), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_double) :: map(3, 4), rows(12)
    rows = 0
    call conclude(cleft_sizing_affine(self%c_handle(), rows), closed, stat, errmsg)
    map = transpose(reshape(rows, [4, 3]))
  end function

  ! One value for each voxel.
  function values(self, stat, errmsg)
    class(cleft_sizing), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_float), allocatable :: values(:, :, :)
    real(c_float), pointer :: borrowed(:, :, :)
    integer :: counts(3), status

    counts = self%dims(status)
    call conclude(int(status, c_int32_t), closed, stat, errmsg)
    allocate (values(counts(1), counts(2), counts(3)))
    if (status /= CLEFT_OK) return
    call c_f_pointer(cleft_sizing_values(self%c_handle()), borrowed, counts)
    values = borrowed
  end function

  ! Whether the wanted lengths depend on the direction.
  function has_metric(self)
    class(cleft_sizing), intent(in) :: self
    logical :: has_metric
    has_metric = cleft_sizing_has_metric(self%c_handle()) /= 0
  end function

  ! The metric: tensors(:, i, j, k) has xx, xy, xz, yy, yz, zz of a voxel.
  function metric(self, stat, errmsg) result(tensors)
    class(cleft_sizing), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_float), allocatable :: tensors(:, :, :, :)
    integer :: counts(3), there

    counts = 0
    if (self%has_metric()) counts = self%dims(there)
    allocate (tensors(6, counts(1), counts(2), counts(3)))
    call conclude(cleft_sizing_copy_metric(self%c_handle(), tensors, size(tensors, kind=c_int64_t)), &
      'the sizing field is not there, or has no metric', stat, errmsg)
  end function

  ! The field at a world point.
  function at(self, point, stat, errmsg) result(size)
    class(cleft_sizing), intent(in) :: self
    real(c_double), intent(in) :: point(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_double) :: size
    size = 0
    call conclude(cleft_sizing_at(self%c_handle(), point, size), 'the field is not there, or the point is not finite', &
      stat, errmsg)
  end function

  ! Tetrahedra that a background of this field will have, within some 10 %.
  function expected_tets(self) result(count)
    class(cleft_sizing), intent(in) :: self
    real(c_double) :: count
    count = cleft_sizing_expected_tets(self%c_handle())
  end function

  ! Takes over a handle that cleft_c gave.
  subroutine adopt(self, handle)
    class(cleft_sizing), intent(inout) :: self
    type(c_ptr), intent(in) :: handle
    call self%take(handle, cleft_sizing_destroy)
  end subroutine

end module
