! Surfaces: the interface and hull triangles of a mesh. Points are numbered from 1.
module cleft_surfaces
  use, intrinsic :: iso_c_binding
  use cleft_c
  use cleft_support
  use cleft_handles
  use cleft_contexts
  use cleft_meshes
  implicit none
  private
  public :: cleft_surface

  ! Immutable once made; given back when it goes out of scope. It cannot be copied.
  type, extends(cleft_handle) :: cleft_surface
  contains
    procedure :: create
    procedure :: interface_count
    procedure :: interface_triangles
    procedure :: interface_labels
    procedure :: hull_count
    procedure :: hull_triangles
    procedure :: hull_labels
    procedure :: hull_sides
    procedure :: adopt
  end type

contains

  ! Does not need the mesh afterwards.
  subroutine create(self, context, mesh, stat, errmsg)
    class(cleft_surface), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_mesh), intent(in) :: mesh
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    status = cleft_surface_create(context%c_handle(), mesh%c_handle(), made)
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! The triangles between different labels. Nothing is in a surface that is not there.
  function interface_count(self) result(count)
    class(cleft_surface), intent(in) :: self
    integer :: count
    count = int(cleft_surface_interface_count(self%c_handle()))
  end function

  ! triangles(3, n), counted from 1; the normal points from the first label of the pair to the second.
  function interface_triangles(self) result(triangles)
    class(cleft_surface), intent(in) :: self
    integer(c_int32_t), allocatable :: triangles(:, :)
    triangles = table(cleft_surface_interface_triangles(self%c_handle()), 3, self%interface_count()) + 1
  end function

  ! labels(2, n), the lower first.
  function interface_labels(self) result(labels)
    class(cleft_surface), intent(in) :: self
    integer(c_int32_t), allocatable :: labels(:, :)
    labels = table(cleft_surface_interface_labels(self%c_handle()), 2, self%interface_count())
  end function

  function hull_count(self) result(count)
    class(cleft_surface), intent(in) :: self
    integer :: count
    count = int(cleft_surface_hull_count(self%c_handle()))
  end function

  ! triangles(3, n), counted from 1, normals outward.
  function hull_triangles(self) result(triangles)
    class(cleft_surface), intent(in) :: self
    integer(c_int32_t), allocatable :: triangles(:, :)
    triangles = table(cleft_surface_hull_triangles(self%c_handle()), 3, self%hull_count()) + 1
  end function

  ! The label inside each hull triangle.
  function hull_labels(self) result(labels)
    class(cleft_surface), intent(in) :: self
    integer(c_int32_t), allocatable :: labels(:)
    labels = reshape(table(cleft_surface_hull_labels(self%c_handle()), 1, self%hull_count()), [self%hull_count()])
  end function

  ! CLEFT_SIDE_... of each hull triangle.
  function hull_sides(self) result(sides)
    class(cleft_surface), intent(in) :: self
    integer(c_int32_t), allocatable :: sides(:)
    sides = reshape(table(cleft_surface_hull_sides(self%c_handle()), 1, self%hull_count()), [self%hull_count()])
  end function

  ! A copy of what C shows.
  function table(pointer, rows, columns) result(numbers)
    type(c_ptr), intent(in) :: pointer
    integer, intent(in) :: rows, columns
    integer(c_int32_t), allocatable :: numbers(:, :)
    integer(c_int32_t), pointer :: borrowed(:, :)

    allocate (numbers(rows, columns))
    if (columns == 0) return
    call c_f_pointer(pointer, borrowed, [rows, columns])
    numbers = borrowed
  end function

  ! Takes over a handle that cleft_c gave.
  subroutine adopt(self, handle)
    class(cleft_surface), intent(inout) :: self
    type(c_ptr), intent(in) :: handle
    call self%take(handle, cleft_surface_destroy)
  end subroutine

end module
