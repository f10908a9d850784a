! Reports: what became of each label.
module cleft_reports
  use, intrinsic :: iso_c_binding
  use cleft_c
  use cleft_support
  use cleft_handles
  use cleft_contexts
  use cleft_volumes
  use cleft_meshes
  implicit none
  private
  public :: cleft_report

  ! Immutable once made; given back when it goes out of scope. It cannot be copied.
  type, extends(cleft_handle) :: cleft_report
  contains
    procedure :: create
    procedure :: count => row_count
    procedure :: label
    procedure :: contact_count
    procedure :: contact
    procedure :: distance_count
    procedure :: distance
    procedure :: adopt
  end type

contains

  ! Compares a finished (not stripped) mesh with its volume; with `distances`, also their interfaces.
  subroutine create(self, context, volume, mesh, stat, errmsg, distances)
    class(cleft_report), intent(inout) :: self
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    type(cleft_mesh), intent(in) :: mesh
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    logical, intent(in), optional :: distances
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    logical :: with_distances
    with_distances = .false.
    if (present(distances)) with_distances = distances
    if (with_distances) then
      status = cleft_report_create_with_distances(context%c_handle(), volume%c_handle(), mesh%c_handle(), made)
    else
      status = cleft_report_create(context%c_handle(), volume%c_handle(), mesh%c_handle(), made)
    end if
    call self%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Number of labels of the volume.
  function row_count(self) result(count)
    class(cleft_report), intent(in) :: self
    integer :: count
    count = int(cleft_report_count(self%c_handle()))
  end function

  ! Row `index`, counted from 1, in the order of the volume's labels.
  function label(self, index, stat, errmsg) result(row)
    class(cleft_report), intent(in) :: self
    integer, intent(in) :: index
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_label_report) :: row
    row%struct_size = int(c_sizeof(row), c_int32_t)
    call conclude(cleft_report_label(self%c_handle(), int(index - 1, c_int64_t), row), &
      'the report is not there, or has no such row', stat, errmsg)
  end function

  ! Number of pairs of labels that share triangles, but of which no two voxels share a face or an edge.
  function contact_count(self) result(count)
    class(cleft_report), intent(in) :: self
    integer :: count
    count = int(cleft_report_contact_count(self%c_handle()))
  end function

  ! Pair `index`, counted from 1: the labels pair%first and pair%second share pair%triangles triangles.
  function contact(self, index, stat, errmsg) result(pair)
    class(cleft_report), intent(in) :: self
    integer, intent(in) :: index
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_contact) :: pair
    pair%struct_size = int(c_sizeof(pair), c_int32_t)
    call conclude(cleft_report_contact(self%c_handle(), int(index - 1, c_int64_t), pair), &
      'the report is not there, or has no such contact', stat, errmsg)
  end function

  ! Number of interfaces and lines whose distances were measured.
  function distance_count(self) result(count)
    class(cleft_report), intent(in) :: self
    integer :: count
    count = int(cleft_report_distance_count(self%c_handle()))
  end function

  ! Interface or line `index`, counted from 1: how far that of the mesh is from that of the volume.
  function distance(self, index, stat, errmsg) result(row)
    class(cleft_report), intent(in) :: self
    integer, intent(in) :: index
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_distance) :: row
    row%struct_size = int(c_sizeof(row), c_int32_t)
    call conclude(cleft_report_distance(self%c_handle(), int(index - 1, c_int64_t), row), &
      'the report is not there, or has no such distance', stat, errmsg)
  end function

  ! Takes over a handle that cleft_c gave.
  subroutine adopt(self, handle)
    class(cleft_report), intent(inout) :: self
    type(c_ptr), intent(in) :: handle
    call self%take(handle, cleft_report_destroy)
  end subroutine

end module
