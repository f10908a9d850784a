! Options: how to mesh. Names (with '_' for '-'), ranges and defaults are those that `cleft mesh --help` prints.
module cleft_option_sets
  use, intrinsic :: iso_c_binding
  use cleft_c
  use cleft_support
  implicit none
  private
  public :: cleft_options

  ! Made with the defaults when first used, given back when it goes out of scope. It cannot be copied.
  type :: cleft_options
    private
    type(c_ptr) :: handle = c_null_ptr
  contains
    generic :: set => set_text, set_integer, set_real, set_single, set_logical
    procedure :: value
    procedure :: set_label_size
    procedure :: set_strip
    procedure :: set_only
    procedure :: destroy
    procedure :: c_handle
    procedure, private :: set_text, set_integer, set_real, set_single, set_logical, conclude_call, refuse_copy
    generic :: assignment(=) => refuse_copy
    final :: finalize
  end type

contains

  ! call options%set('size_max', 4.0d0), ('tets', 100000), ('background', 'octree'), ('strict', .true.)
  subroutine set_text(self, name, value, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    character(len=*), intent(in) :: name, value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%conclude_call(cleft_options_set_text(self%c_handle(), c_text(name), c_text(value)), stat, errmsg)
  end subroutine

  subroutine set_integer(self, name, value, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer, intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(len=24) :: text
    write (text, '(i0)') value
    call self%set_text(name, text, stat, errmsg)
  end subroutine

  subroutine set_real(self, name, value, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    character(len=*), intent(in) :: name
    real(c_double), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(len=32) :: text
    write (text, '(es26.16e3)') value
    call self%set_text(name, adjustl(text), stat, errmsg)
  end subroutine

  subroutine set_single(self, name, value, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    character(len=*), intent(in) :: name
    real(c_float), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%set_real(name, real(value, c_double), stat, errmsg)
  end subroutine

  subroutine set_logical(self, name, value, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    character(len=*), intent(in) :: name
    logical, intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%set_text(name, merge('true ', 'false', value), stat, errmsg)
  end subroutine

  ! The value of an option; choices and flags as their numbers.
  function value(self, name, stat, errmsg) result(number)
    class(cleft_options), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(c_double) :: number
    type(cleft_option_description) :: row
    integer(c_int64_t) :: whole

    number = 0
    whole = 0
    if (.not. find_option(name, row)) then
      call conclude(CLEFT_ERROR_OPTION, 'there is no option "' // trim(name) // '"', stat, errmsg)
    else if (row%type == CLEFT_OPTION_TYPE_REAL) then
      call self%conclude_call(cleft_options_get_real(self%c_handle(), row%key, number), stat, errmsg)
    else
      call self%conclude_call(cleft_options_get_integer(self%c_handle(), row%key, whole), stat, errmsg)
      number = real(whole, c_double)
    end if
  end function

  function find_option(name, row) result(found)
    character(len=*), intent(in) :: name
    type(cleft_option_description), intent(out) :: row
    logical :: found
    integer(c_int32_t) :: i

    found = .false.
    row%struct_size = int(c_sizeof(row), c_int32_t)
    do i = 0, cleft_option_count() - 1
      if (cleft_option_info(i, row) /= CLEFT_OK) return
      found = text_at(row%name) == trim(name)
      if (found) return
    end do
  end function

  ! Sets the greatest wanted edge length inside one label; 0 removes the limit for this label.
  subroutine set_label_size(self, label, size, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    integer(c_int32_t), intent(in) :: label
    real(c_double), intent(in) :: size
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%conclude_call(cleft_options_set_label_size(self%c_handle(), label, size), stat, errmsg)
  end subroutine

  ! The labels to leave out of the finished mesh.
  subroutine set_strip(self, labels, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    integer(c_int32_t), intent(in) :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%conclude_call( &
      cleft_options_set_strip(self%c_handle(), labels, size(labels, kind=c_int64_t)), stat, errmsg)
  end subroutine

  ! The labels that alone are kept; none: all.
  subroutine set_only(self, labels, stat, errmsg)
    class(cleft_options), intent(inout) :: self
    integer(c_int32_t), intent(in) :: labels(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%conclude_call( &
      cleft_options_set_only(self%c_handle(), labels, size(labels, kind=c_int64_t)), stat, errmsg)
  end subroutine

  subroutine destroy(self)
    class(cleft_options), intent(inout) :: self
    call cleft_options_destroy(self%handle)
    self%handle = c_null_ptr
  end subroutine

  ! The handle for calls of cleft_c, made now if need be.
  function c_handle(self) result(handle)
    class(cleft_options), intent(inout) :: self
    type(c_ptr) :: handle
    if (.not. c_associated(self%handle)) &
      call conclude(cleft_options_create(self%handle), 'options cannot be made')
    handle = self%handle
  end function

  subroutine conclude_call(self, status, stat, errmsg)
    class(cleft_options), intent(in) :: self
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg

    if (status == CLEFT_OK) then
      if (present(stat)) stat = CLEFT_OK
    else
      call conclude(status, text_at(cleft_options_last_error(self%handle)), stat, errmsg)
    end if
  end subroutine

  subroutine refuse_copy(self, other)
    class(cleft_options), intent(inout) :: self
    type(cleft_options), intent(in) :: other
    if (c_associated(self%handle, other%handle)) return
    error stop 'cleft: a cleft_options cannot be copied'
  end subroutine

  impure elemental subroutine finalize(self)
    type(cleft_options), intent(inout) :: self
    call self%destroy()
  end subroutine

end module
