! Volumes: labelled voxels or indicator functions.
module cleft_volumes
  use, intrinsic :: iso_c_binding
  use cleft_c
  use cleft_support
  use cleft_handles
  use cleft_contexts
  use cleft_option_sets
  implicit none
  private
  public :: cleft_volume, c_options

  ! Immutable once made; given back when it goes out of scope. It cannot be copied.
  type, extends(cleft_handle) :: cleft_volume
  contains
    ! From labels(nx, ny, nz), or indicators(nx, ny, nz) or (nx, ny, nz, materials).
    generic :: create => create_labels_8, create_labels_16, create_labels_32, create_labels_64, &
      create_signed_32, create_signed_64, create_indicators_32, create_indicators_64
    procedure :: dims
    procedure :: affine
    procedure :: labels
    procedure :: indicator_count
    procedure :: set_label_name
    procedure :: label_name
    procedure :: voxel_counts
    procedure :: sample
    procedure :: adopt
    procedure, private :: create_labels_8, create_labels_16, create_labels_32, create_labels_64
    procedure, private :: create_signed_32, create_signed_64, create_indicators_32, create_indicators_64
  end type

  character(len=*), parameter :: closed = 'the volume is not there: destroyed, or never made'

contains

  ! The lengths of a voxel and the centre of the first one place the voxels in the world, or `affine` does:
  ! world = matmul(affine(:, 1:3), index) + affine(:, 4), the index counted from 0. Without them, voxels are unit cubes
  ! and the corner of the box is at the origin. `affine` together with one of the others is refused, for they may
  ! disagree. Voxels of 8 bits are unsigned: 0 to 255.
  subroutine create_labels_8(self, context, voxels, spacing, origin, affine, options, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    integer(c_int8_t), intent(in), contiguous, target :: voxels(:, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call create_labels(self, context, CLEFT_TYPE_UINT8, c_loc(voxels), shape(voxels, c_int64_t), &
      spacing, origin, affine, options, stat, errmsg)
  end subroutine

  subroutine create_labels_16(self, context, voxels, spacing, origin, affine, options, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    integer(c_int16_t), intent(in), contiguous, target :: voxels(:, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call create_labels(self, context, CLEFT_TYPE_INT16, c_loc(voxels), shape(voxels, c_int64_t), &
      spacing, origin, affine, options, stat, errmsg)
  end subroutine

  subroutine create_labels_32(self, context, voxels, spacing, origin, affine, options, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    integer(c_int32_t), intent(in), contiguous, target :: voxels(:, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call create_labels(self, context, CLEFT_TYPE_INT32, c_loc(voxels), shape(voxels, c_int64_t), &
      spacing, origin, affine, options, stat, errmsg)
  end subroutine

  ! Of 64 bits, as long as the labels fit into 32.
  subroutine create_labels_64(self, context, voxels, spacing, origin, affine, options, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    integer(c_int64_t), intent(in) :: voxels(:, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int64_t), parameter :: greatest = huge(0_c_int32_t)
    integer(c_int32_t), allocatable :: narrow(:, :, :)

    call self%destroy()
    if (any(voxels > greatest .or. voxels < -greatest - 1)) then
      call conclude(CLEFT_ERROR_ARGUMENT, 'labels must fit into 32 bits', stat, errmsg)
      return
    end if
    narrow = int(voxels, c_int32_t)
    call self%create(context, narrow, spacing, origin, affine, options, stat, errmsg)
  end subroutine

  subroutine create_labels(self, context, type, voxels, dims, spacing, origin, affine, options, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    integer(c_int32_t), intent(in) :: type
    type(c_ptr), intent(in) :: voxels
    integer(c_int64_t), intent(in) :: dims(3)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_double), target :: rows(12)
    character(len=:), allocatable :: mistake
    type(c_ptr) :: made
    integer(c_int32_t) :: status

    call self%destroy()
    call find_place(spacing, origin, affine, rows, mistake)
    if (any(dims < 1)) mistake = 'voxels has no elements'
    if (len(mistake) > 0) then
      call conclude(CLEFT_ERROR_ARGUMENT, mistake, stat, errmsg)
      return
    end if
    status = cleft_volume_create_labels(context%c_handle(), type, voxels, dims, c_loc(rows), &
      c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! A signed function: inside, labels(2), where it is > 0; outside, labels(1). Without `labels`: 1 and 0.
  subroutine create_signed_32(self, context, field, spacing, origin, affine, labels, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    real(c_float), intent(in), contiguous, target :: field(:, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    integer(c_int32_t), intent(in), optional :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call create_indicators(self, context, CLEFT_TYPE_FLOAT32, [c_loc(field)], shape(field, c_int64_t), &
      spacing, origin, affine, labels, stat, errmsg)
  end subroutine

  subroutine create_signed_64(self, context, field, spacing, origin, affine, labels, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    real(c_double), intent(in), contiguous, target :: field(:, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    integer(c_int32_t), intent(in), optional :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call create_indicators(self, context, CLEFT_TYPE_FLOAT64, [c_loc(field)], shape(field, c_int64_t), &
      spacing, origin, affine, labels, stat, errmsg)
  end subroutine

  ! One function for each material: fields(:, :, :, m); the largest wins. Materials are called labels(m), or 0, 1, ...
  subroutine create_indicators_32(self, context, fields, spacing, origin, affine, labels, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    real(c_float), intent(in), contiguous, target :: fields(:, :, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    integer(c_int32_t), intent(in), optional :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: each(size(fields, 4))
    integer :: m

    do m = 1, size(fields, 4)
      each(m) = c_loc(fields(:, :, :, m))
    end do
    call create_indicators(self, context, CLEFT_TYPE_FLOAT32, each, shape(fields(:, :, :, 1), c_int64_t), &
      spacing, origin, affine, labels, stat, errmsg)
  end subroutine

  subroutine create_indicators_64(self, context, fields, spacing, origin, affine, labels, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    real(c_double), intent(in), contiguous, target :: fields(:, :, :, :)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    integer(c_int32_t), intent(in), optional :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: each(size(fields, 4))
    integer :: m

    do m = 1, size(fields, 4)
      each(m) = c_loc(fields(:, :, :, m))
    end do
    call create_indicators(self, context, CLEFT_TYPE_FLOAT64, each, shape(fields(:, :, :, 1), c_int64_t), &
      spacing, origin, affine, labels, stat, errmsg)
  end subroutine

  subroutine create_indicators(self, context, type, fields, dims, spacing, origin, affine, labels, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    integer(c_int32_t), intent(in) :: type
    type(c_ptr), intent(in) :: fields(:)
    integer(c_int64_t), intent(in) :: dims(3)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    integer(c_int32_t), intent(in), optional :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_double), target :: rows(12)
    integer(c_int32_t), allocatable, target :: names(:)
    character(len=:), allocatable :: mistake
    type(c_ptr) :: names_at
    integer :: names_wanted
    type(c_ptr) :: made
    integer(c_int32_t) :: status

    call self%destroy()
    call find_place(spacing, origin, affine, rows, mistake)
    if (any(dims < 1) .or. size(fields) < 1) mistake = 'the indicator functions have no elements'
    if (len(mistake) > 0) then
      call conclude(CLEFT_ERROR_ARGUMENT, mistake, stat, errmsg)
      return
    end if
    names_wanted = max(2, size(fields))
    names_at = c_null_ptr
    if (present(labels)) then
      if (size(labels) /= names_wanted) then
        call conclude(CLEFT_ERROR_ARGUMENT, 'labels must have one value for each material', stat, errmsg)
        return
      end if
      names = labels
      names_at = c_loc(names)
    end if
    status = cleft_volume_create_indicators(context%c_handle(), type, fields, &
      size(fields, kind=c_int64_t), dims, c_loc(rows), names_at, made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! The rows of the affine map as C has them, or what is wrong with the arguments: '' if nothing is.
  pure subroutine find_place(spacing, origin, affine, rows, mistake)
    real(c_double), intent(in), optional :: spacing(3), origin(3), affine(3, 4)
    real(c_double), intent(out) :: rows(12)
    character(len=:), allocatable, intent(out) :: mistake
    real(c_double) :: map(3, 4)
    integer :: axis

    mistake = ''
    map = 0
    do axis = 1, 3
      map(axis, axis) = 1
      if (present(spacing)) map(axis, axis) = spacing(axis)
      if (map(axis, axis) <= 0) mistake = 'spacing must be above 0 along each axis'
      map(axis, 4) = map(axis, axis) / 2
      if (present(origin)) map(axis, 4) = origin(axis)
    end do
    if (present(affine)) then
      if (present(spacing) .or. present(origin)) mistake = 'give either affine, or spacing and origin'
      map = affine
    end if
    rows = reshape(transpose(map), [12])
  end subroutine

  ! The handle of options that may be absent.
  function c_options(options) result(handle)
    type(cleft_options), intent(inout), optional :: options
    type(c_ptr) :: handle
    handle = c_null_ptr
    if (present(options)) handle = options%c_handle()
  end function

  ! Voxels along x, y, z.
  function dims(self, stat, errmsg) result(counts)
    class(cleft_volume), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer :: counts(3)
    integer(c_int64_t) :: c_dims(3)
    c_dims = 0
    call conclude(cleft_volume_dims(self%c_handle(), c_dims), closed, stat, errmsg)
    counts = int(c_dims)
  end function

  ! From voxel indices, counted from 0, to the world.
  function affine(self, stat, errmsg) result(map)
    class(cleft_volume), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_double) :: map(3, 4), rows(12)
    rows = 0
    call conclude(cleft_volume_affine(self%c_handle(), rows), closed, stat, errmsg)
    map = transpose(reshape(rows, [4, 3]))
  end function

  ! The label of each material, ascending for a label map; none for a volume that is not there.
  function labels(self)
    class(cleft_volume), intent(in) :: self
    integer(c_int32_t), allocatable :: labels(:)
    integer(c_int32_t), pointer :: borrowed(:)
    integer(c_int64_t) :: count

    count = cleft_volume_label_count(self%c_handle())
    allocate (labels(count))
    if (count == 0) return
    call c_f_pointer(cleft_volume_labels(self%c_handle()), borrowed, [count])
    labels = borrowed
  end function

  ! Number of indicator functions: 1 for a signed function, 0 for a label map. Tells what a file was taken for.
  function indicator_count(self) result(count)
    class(cleft_volume), intent(in) :: self
    integer :: count
    count = int(cleft_volume_indicator_count(self%c_handle()))
  end function

  ! Names a label, in one line; '' takes the name away. Meshes of the volume have its names.
  subroutine set_label_name(self, label, name, stat, errmsg)
    class(cleft_volume), intent(inout) :: self
    integer(c_int32_t), intent(in) :: label
    character(len=*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char, len=:), allocatable, target :: chars

    chars = c_text(name)
    call conclude(cleft_volume_set_label_name(self%c_handle(), label, c_loc(chars)), &
      naming_mistake('volume', self%labels(), label), stat, errmsg)
  end subroutine

  ! The name of a label, '' if it has none.
  function label_name(self, label) result(name)
    class(cleft_volume), intent(in) :: self
    integer(c_int32_t), intent(in) :: label
    character(len=:), allocatable :: name
    name = text_at(cleft_volume_label_name(self%c_handle(), label))
  end function

  ! Voxels of each material.
  function voxel_counts(self, stat, errmsg) result(counts)
    class(cleft_volume), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int64_t), allocatable :: counts(:)
    allocate (counts(cleft_volume_label_count(self%c_handle())), source=0_c_int64_t)
    call conclude(cleft_volume_copy_voxel_counts(self%c_handle(), counts, size(counts, kind=c_int64_t)), &
      closed, stat, errmsg)
  end function

  ! The labels at world points(3, n).
  function sample(self, points, stat, errmsg) result(found)
    class(cleft_volume), intent(in) :: self
    real(c_double), intent(in) :: points(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t), allocatable :: found(:)

    allocate (found(size(points, 2)), source=0_c_int32_t)
    if (size(points, 1) /= 3) then
      call conclude(CLEFT_ERROR_ARGUMENT, 'points must be shaped (3, n)', stat, errmsg)
      return
    end if
    call conclude(cleft_volume_sample(self%c_handle(), points, size(found, kind=c_int64_t), found), &
      'the volume is not there, or a point is not finite', stat, errmsg)
  end function

  ! Takes over a handle that cleft_c gave.
  subroutine adopt(self, handle)
    class(cleft_volume), intent(inout) :: self
    type(c_ptr), intent(in) :: handle
    call self%take(handle, cleft_volume_destroy)
  end subroutine

end module
