! Meshes: points, tetrahedra and their labels. Points are numbered from 1.
module cleft_meshes
  use, intrinsic :: iso_c_binding
  use cleft_c
  use cleft_support
  use cleft_handles
  use cleft_contexts
  use cleft_option_sets
  use cleft_volumes
  use cleft_sizings
  implicit none
  private
  public :: cleft_mesh, estimate_mesh

  ! Immutable once made; given back when it goes out of scope. It cannot be copied.
  type, extends(cleft_handle) :: cleft_mesh
  contains
    procedure :: create
    procedure :: create_background
    procedure :: create_arrays
    procedure :: cleave
    procedure :: improve
    procedure :: strip
    procedure :: point_count
    procedure :: tet_count
    procedure :: points
    procedure :: tets
    procedure :: tet_labels
    procedure :: labels
    procedure :: set_label_name
    procedure :: label_name
    procedure :: quadratic
    procedure :: quality
    procedure :: metric_quality
    procedure :: validate
    procedure :: adopt
  end type

  character(len=*), parameter :: closed = 'the mesh is not there: destroyed, or never made'

contains

  ! What mesh%create will come to with the same arguments: tetrahedra, within 15 %, and memory. No mesh is made.
  function estimate_mesh(context, volume, options, sizing, background, stat, errmsg) result(figures)
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    type(cleft_options), intent(inout), optional :: options
    type(cleft_sizing), intent(in), optional :: sizing
    type(cleft_mesh), intent(in), optional :: background
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_estimate) :: figures
    type(c_ptr) :: sizing_at, background_at

    sizing_at = c_null_ptr
    background_at = c_null_ptr
    if (present(sizing)) sizing_at = sizing%c_handle()
    if (present(background)) background_at = background%c_handle()
    figures%struct_size = int(c_sizeof(figures), c_int32_t)
    if (present(sizing) .and. .not. c_associated(sizing_at)) then
      call conclude(CLEFT_ERROR_NULL, 'sizing is not there: destroyed, or never made', stat, errmsg)
    else if (present(background) .and. .not. c_associated(background_at)) then
      call conclude(CLEFT_ERROR_NULL, 'background is not there: destroyed, or never made', stat, errmsg)
    else
      call context%conclude(cleft_mesh_estimate( &
        context%c_handle(), volume%c_handle(), sizing_at, background_at, c_options(options), figures), stat, errmsg)
    end if
  end function

  ! All of it: sizing (unless given), background (unless given), cleaving, improving, ordering, stripping.
  subroutine create(self, context, volume, options, sizing, background, stat, errmsg)
    class(cleft_mesh), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    type(cleft_options), intent(inout), optional :: options
    type(cleft_sizing), intent(in), optional :: sizing
    type(cleft_mesh), intent(in), optional :: background
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: sizing_at, background_at, made
    integer(c_int32_t) :: status

    sizing_at = c_null_ptr
    background_at = c_null_ptr
    if (present(sizing)) sizing_at = sizing%c_handle()
    if (present(background)) background_at = background%c_handle()
    ! What is given but empty is not the same as what is not given.
    if (present(sizing) .and. .not. c_associated(sizing_at)) then
      call refuse_empty('sizing')
      return
    end if
    if (present(background) .and. .not. c_associated(background_at)) then
      call refuse_empty('background')
      return
    end if
    status = cleft_mesh_volume( &
      context%c_handle(), volume%c_handle(), sizing_at, background_at, c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)

  contains

    subroutine refuse_empty(name)
      character(len=*), intent(in) :: name
      call self%destroy()
      call conclude(CLEFT_ERROR_NULL, name // ' is not there: destroyed, or never made', stat, errmsg)
    end subroutine

  end subroutine

  ! The background mesh of a sizing field; its only label is 0.
  subroutine create_background(self, context, sizing, options, stat, errmsg)
    class(cleft_mesh), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_sizing), intent(in) :: sizing
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_background_create(context%c_handle(), sizing%c_handle(), c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! From points(3, n), tets(4, m) counted from 1, and labels(m), 0 if absent.
  subroutine create_arrays(self, context, points, tets, labels, stat, errmsg)
    class(cleft_mesh), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    real(c_double), intent(in) :: points(:, :)
    integer(c_int32_t), intent(in) :: tets(:, :)
    integer(c_int32_t), intent(in), optional :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t), allocatable, target :: copy(:)
    type(c_ptr) :: made
    integer(c_int32_t) :: status

    call self%destroy()
    if (size(points, 1) /= 3 .or. size(tets, 1) /= 4) then
      call conclude(CLEFT_ERROR_ARGUMENT, 'points must be shaped (3, n) and tets (4, m)', stat, errmsg)
      return
    end if
    allocate (copy(size(tets, 2)), source=0_c_int32_t)
    if (present(labels)) then
      if (size(labels) /= size(copy)) then
        call conclude(CLEFT_ERROR_ARGUMENT, 'labels must have one value for each tetrahedron', stat, errmsg)
        return
      end if
      copy = labels
    end if
    status = cleft_mesh_create(context%c_handle(), size(points, 2, c_int64_t), points, &
      size(tets, 2, c_int64_t), tets, c_loc(copy), 1_c_int32_t, made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Cleaves a background along the interfaces of a volume.
  subroutine cleave(self, context, volume, background, options, stat, errmsg)
    class(cleft_mesh), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    type(cleft_mesh), intent(in) :: background
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_mesh_cleave( &
      context%c_handle(), volume%c_handle(), background%c_handle(), c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Raises the worst dihedral angles of a cleaved mesh of this volume.
  subroutine improve(self, context, volume, mesh, options, stat, errmsg)
    class(cleft_mesh), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    type(cleft_mesh), intent(in) :: mesh
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_mesh_improve(context%c_handle(), volume%c_handle(), mesh%c_handle(), c_options(options), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Without the labels that the options leave out.
  subroutine strip(self, context, mesh, options, stat, errmsg)
    class(cleft_mesh), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_mesh), intent(in) :: mesh
    type(cleft_options), intent(inout) :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_mesh_strip(context%c_handle(), mesh%c_handle(), options%c_handle(), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! 0 for a mesh that is not there.
  function point_count(self) result(count)
    class(cleft_mesh), intent(in) :: self
    integer :: count
    count = int(cleft_mesh_point_count(self%c_handle()))
  end function

  function tet_count(self) result(count)
    class(cleft_mesh), intent(in) :: self
    integer :: count
    count = int(cleft_mesh_tet_count(self%c_handle()))
  end function

  ! points(3, n) in world coordinates.
  function points(self, stat, errmsg)
    class(cleft_mesh), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_double), allocatable :: points(:, :)
    allocate (points(3, self%point_count()))
    call conclude(cleft_mesh_copy_points(self%c_handle(), points, size(points, kind=c_int64_t)), closed, stat, errmsg)
  end function

  ! tets(4, m), counted from 1, positively oriented.
  function tets(self, stat, errmsg)
    class(cleft_mesh), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t), allocatable :: tets(:, :)
    allocate (tets(4, self%tet_count()))
    call conclude(cleft_mesh_copy_tets(self%c_handle(), 1_c_int32_t, tets, size(tets, kind=c_int64_t)), &
      closed, stat, errmsg)
  end function

  ! The label of each tetrahedron.
  function tet_labels(self, stat, errmsg) result(labels)
    class(cleft_mesh), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t), allocatable :: labels(:)
    allocate (labels(self%tet_count()))
    call conclude(cleft_mesh_copy_tet_labels(self%c_handle(), labels, size(labels, kind=c_int64_t)), &
      closed, stat, errmsg)
  end function

  ! The different labels, ascending; none for a mesh that is not there.
  function labels(self)
    class(cleft_mesh), intent(in) :: self
    integer(c_int32_t), allocatable :: labels(:)
    integer(c_int32_t), pointer :: borrowed(:)
    integer(c_int64_t) :: count

    count = cleft_mesh_label_count(self%c_handle())
    allocate (labels(count))
    if (count == 0) return
    call c_f_pointer(cleft_mesh_labels(self%c_handle()), borrowed, [count])
    labels = borrowed
  end function

  ! Names a label, in one line; '' takes the name away. Meshes have the names of their volume.
  subroutine set_label_name(self, label, name, stat, errmsg)
    class(cleft_mesh), intent(inout) :: self
    integer(c_int32_t), intent(in) :: label
    character(len=*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char, len=:), allocatable, target :: chars

    chars = c_text(name)
    call conclude(cleft_mesh_set_label_name(self%c_handle(), label, c_loc(chars)), &
      naming_mistake('mesh', self%labels(), label), stat, errmsg)
  end subroutine

  ! The name of a label, '' if it has none.
  function label_name(self, label) result(name)
    class(cleft_mesh), intent(in) :: self
    integer(c_int32_t), intent(in) :: label
    character(len=:), allocatable :: name
    name = text_at(cleft_mesh_label_name(self%c_handle(), label))
  end function

  ! Ten-node tetrahedra, tets(10, m), with a point at the middle of each edge: 01, 12, 02, 03, 13, 23 after the corners.
  subroutine quadratic(self, points, tets, stat, errmsg)
    class(cleft_mesh), intent(in) :: self
    real(c_double), allocatable, target, intent(out) :: points(:, :)
    integer(c_int32_t), allocatable, target, intent(out) :: tets(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status

    count = 0
    status = cleft_mesh_copy_quadratic( &
      self%c_handle(), 1_c_int32_t, c_null_ptr, 0_c_int64_t, c_null_ptr, 0_c_int64_t, count)
    allocate (points(3, count), tets(10, self%tet_count()))
    if (count > 0) status = cleft_mesh_copy_quadratic(self%c_handle(), 1_c_int32_t, &
      c_loc(points), size(points, kind=c_int64_t), c_loc(tets), size(tets, kind=c_int64_t), count)
    call conclude(status, closed, stat, errmsg)
  end subroutine

  ! The shape of the mesh in figures.
  function quality(self, context, stat, errmsg) result(figures)
    class(cleft_mesh), intent(in) :: self
    type(cleft_context), intent(inout) :: context
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_quality) :: figures
    figures%struct_size = int(c_sizeof(figures), c_int32_t)
    call context%conclude(cleft_mesh_quality(context%c_handle(), self%c_handle(), figures), stat, errmsg)
  end function

  ! How well the mesh meets the metric of a sizing field.
  function metric_quality(self, context, sizing, stat, errmsg) result(figures)
    class(cleft_mesh), intent(in) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_sizing), intent(in) :: sizing
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_metric_quality) :: figures
    figures%struct_size = int(c_sizeof(figures), c_int32_t)
    call context%conclude(cleft_mesh_metric_quality(context%c_handle(), self%c_handle(), sizing%c_handle(), figures), &
      stat, errmsg)
  end function

  ! What is wrong with the mesh: result%valid is 1 if nothing is, else context%last_error() names the first fault.
  function validate(self, context, fills_box, stat, errmsg) result(findings)
    class(cleft_mesh), intent(in) :: self
    type(cleft_context), intent(inout) :: context
    logical, intent(in), optional :: fills_box
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_validation) :: findings
    integer(c_int32_t) :: c_fills_box

    findings%struct_size = int(c_sizeof(findings), c_int32_t)
    c_fills_box = 0
    if (present(fills_box)) c_fills_box = merge(1_c_int32_t, 0_c_int32_t, fills_box)
    call context%conclude(cleft_mesh_validate(context%c_handle(), self%c_handle(), c_fills_box, findings), stat, errmsg)
  end function

  ! Takes over a handle that cleft_c gave.
  subroutine adopt(self, handle)
    class(cleft_mesh), intent(inout) :: self
    type(c_ptr), intent(in) :: handle
    call self%take(handle, cleft_mesh_destroy)
  end subroutine

end module
