! What owns a handle of the library: it gives it back, and cannot be copied.
module cleft_handles
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: cleft_handle

  abstract interface
    subroutine destroyer(handle) bind(C)
      import :: c_ptr
      type(c_ptr), value :: handle
    end subroutine
  end interface

  ! The base of volumes, meshes and all that never changes once it is made. The finalizer is that of the base for all of
  ! them, and knows nothing of what extends it: so the procedure that destroys is kept with the handle.
  type :: cleft_handle
    private
    type(c_ptr) :: handle = c_null_ptr
    procedure(destroyer), pointer, nopass :: give_back => null()
  contains
    procedure :: destroy
    procedure :: c_handle
    procedure :: take
    procedure, private :: refuse_copy
    generic :: assignment(=) => refuse_copy
    final :: finalize
  end type

contains

  ! Gives the handle back; nothing if there is none.
  subroutine destroy(self)
    class(cleft_handle), intent(inout) :: self
    if (associated(self%give_back)) call self%give_back(self%handle)
    self%handle = c_null_ptr
    self%give_back => null()
  end subroutine

  ! The handle for calls of cleft_c: NULL if there is none.
  function c_handle(self) result(handle)
    class(cleft_handle), intent(in) :: self
    type(c_ptr) :: handle
    handle = self%handle
  end function

  ! Takes over a handle, and what gives it back, in place of the one it has.
  subroutine take(self, handle, give_back)
    class(cleft_handle), intent(inout) :: self
    type(c_ptr), intent(in) :: handle
    procedure(destroyer) :: give_back
    call self%destroy()
    self%handle = handle
    self%give_back => give_back
  end subroutine

  subroutine refuse_copy(self, other)
    class(cleft_handle), intent(inout) :: self
    class(cleft_handle), intent(in) :: other
    if (c_associated(self%handle, other%handle)) return
    error stop 'cleft: what has a handle of the library cannot be copied'
  end subroutine

  impure elemental subroutine finalize(self)
    type(cleft_handle), intent(inout) :: self
    call self%destroy()
  end subroutine

end module
