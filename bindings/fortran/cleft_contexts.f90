! Contexts: threads, progress, cancelling, figures and the sentence of the last failure.
module cleft_contexts
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit
  use cleft_c
  use cleft_support
  implicit none
  private
  public :: cleft_context, cleft_progress, cleft_log, cleft_show_warnings

  abstract interface

    ! Told of progress: `fraction` of the running call, `stage` in words. Set `cancel` to stop it.
    subroutine cleft_progress(fraction, stage, cancel)
      import :: c_double
      real(c_double), intent(in) :: fraction
      character(len=*), intent(in) :: stage
      logical, intent(inout) :: cancel
    end subroutine

    ! Told of what happens; `level` is CLEFT_LOG_WARNING, CLEFT_LOG_INFO or CLEFT_LOG_DEBUG.
    subroutine cleft_log(level, sentence)
      integer, intent(in) :: level
      character(len=*), intent(in) :: sentence
    end subroutine

  end interface

  ! What C hands back to our callbacks; it stays where it is however the context moves.
  type :: listeners
    procedure(cleft_progress), pointer, nopass :: progress => null()
    procedure(cleft_log), pointer, nopass :: log => null()
  end type

  ! Made when first used, given back when it goes out of scope. One thread at a time. It cannot be copied.
  type :: cleft_context
    private
    type(c_ptr) :: handle = c_null_ptr
    type(listeners), pointer :: listeners => null()
  contains
    procedure :: set_threads
    procedure :: threads
    procedure :: set_progress
    procedure :: set_log
    procedure :: cancel
    procedure :: metric_count
    procedure :: metric
    procedure :: clear_metrics
    procedure :: last_error
    procedure :: destroy
    procedure :: c_handle
    procedure :: conclude => conclude_call
    procedure, private :: refuse_copy
    generic :: assignment(=) => refuse_copy
    final :: finalize
  end type

contains

  ! Threads to use; 0: as many as the machine has. The result does not depend on it.
  subroutine set_threads(self, count, stat, errmsg)
    class(cleft_context), intent(inout) :: self
    integer, intent(in) :: count
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%conclude(cleft_context_set_threads(self%c_handle(), int(count, c_int32_t)), stat, errmsg)
  end subroutine

  function threads(self) result(count)
    class(cleft_context), intent(inout) :: self
    integer :: count
    count = cleft_context_threads(self%c_handle())
  end function

  ! Reports progress to `listener`, or to none if it is absent.
  subroutine set_progress(self, listener, stat, errmsg)
    class(cleft_context), intent(inout) :: self
    procedure(cleft_progress), optional :: listener
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: handle
    type(c_funptr) :: callback

    handle = self%c_handle()
    self%listeners%progress => null()
    callback = c_null_funptr
    if (present(listener)) then
      self%listeners%progress => listener
      callback = c_funloc(tell_progress)
    end if
    call self%conclude(cleft_context_set_progress(handle, callback, c_loc(self%listeners)), stat, errmsg)
  end subroutine

  ! Gives warnings and remarks to `listener`, or to none if it is absent. Until this is called, warnings are printed.
  subroutine set_log(self, listener, stat, errmsg)
    class(cleft_context), intent(inout) :: self
    procedure(cleft_log), optional :: listener
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: handle
    type(c_funptr) :: callback

    handle = self%c_handle()
    self%listeners%log => null()
    callback = c_null_funptr
    if (present(listener)) then
      self%listeners%log => listener
      callback = c_funloc(tell_log)
    end if
    call self%conclude(cleft_context_set_log(handle, callback, c_loc(self%listeners)), stat, errmsg)
  end subroutine

  ! The listener that a new context has: it writes warnings to the standard error.
  subroutine cleft_show_warnings(level, sentence)
    integer, intent(in) :: level
    character(len=*), intent(in) :: sentence
    if (level == CLEFT_LOG_WARNING) write (error_unit, '(2a)') 'cleft: warning: ', sentence
  end subroutine

  ! Asks the running call to stop soon with CLEFT_ERROR_CANCELLED; from any thread.
  subroutine cancel(self, stat, errmsg)
    class(cleft_context), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%conclude(cleft_context_cancel(self%c_handle()), stat, errmsg)
  end subroutine

  ! Number of figures that the stages noted.
  function metric_count(self) result(count)
    class(cleft_context), intent(inout) :: self
    integer :: count
    count = int(cleft_context_metric_count(self%c_handle()))
  end function

  ! Figure number `index`, counted from 1.
  subroutine metric(self, index, name, value, stat, errmsg)
    class(cleft_context), intent(inout) :: self
    integer, intent(in) :: index
    character(len=:), allocatable, intent(out) :: name
    real(c_double), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: chars
    integer(c_int32_t) :: status

    value = 0
    status = cleft_context_metric(self%c_handle(), int(index - 1, c_int64_t), chars, value)
    name = ''
    if (status == CLEFT_OK) name = text_at(chars)
    call conclude(status, 'there is no such figure', stat, errmsg)  ! the library leaves no sentence of its own
  end subroutine

  subroutine clear_metrics(self, stat, errmsg)
    class(cleft_context), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%conclude(cleft_context_clear_metrics(self%c_handle()), stat, errmsg)
  end subroutine

  ! The sentence of the last failure, '' if there was none.
  function last_error(self) result(sentence)
    class(cleft_context), intent(in) :: self
    character(len=:), allocatable :: sentence
    sentence = ''
    if (c_associated(self%handle)) sentence = text_at(cleft_context_last_error(self%handle))
  end function

  subroutine destroy(self)
    class(cleft_context), intent(inout) :: self
    call cleft_context_destroy(self%handle)
    self%handle = c_null_ptr
    if (associated(self%listeners)) deallocate (self%listeners)
  end subroutine

  ! The handle for calls of cleft_c, made now if need be.
  function c_handle(self) result(handle)
    class(cleft_context), intent(inout) :: self
    type(c_ptr) :: handle

    if (.not. c_associated(self%handle)) then
      call conclude(cleft_context_create(self%handle), 'a context cannot be made')
      allocate (self%listeners)
      self%listeners%log => cleft_show_warnings
      call self%conclude(cleft_context_set_log(self%handle, c_funloc(tell_log), c_loc(self%listeners)))
    end if
    handle = self%handle
  end function

  ! Ends a procedure that called C with this context.
  subroutine conclude_call(self, status, stat, errmsg)
    class(cleft_context), intent(in) :: self
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg

    character(len=:), allocatable :: sentence
    integer :: at

    if (status == CLEFT_OK) then
      if (present(stat)) stat = CLEFT_OK
      return
    end if
    sentence = self%last_error()
    ! A busy context leaves none: what is there is of the other call.
    if (status == CLEFT_ERROR_BUSY .or. sentence == '') sentence = text_at(cleft_status_string(status))
    at = index(sentence, ' is NULL')
    if (status == CLEFT_ERROR_NULL .and. at > 0) sentence = sentence(:at) // 'is not there: destroyed, or never made'
    call conclude(status, sentence, stat, errmsg)
  end subroutine

  function tell_progress(fraction, stage, user) bind(C, name='') result(answer)
    real(c_double), value :: fraction
    type(c_ptr), value :: stage, user
    integer(c_int) :: answer
    type(listeners), pointer :: to
    logical :: cancel

    cancel = .false.
    call c_f_pointer(user, to)
    call to%progress(fraction, text_at(stage), cancel)
    answer = merge(1_c_int, 0_c_int, cancel)
  end function

  subroutine tell_log(level, sentence, user) bind(C, name='')
    integer(c_int32_t), value :: level
    type(c_ptr), value :: sentence, user
    type(listeners), pointer :: to

    call c_f_pointer(user, to)
    call to%log(int(level), text_at(sentence))
  end subroutine

  subroutine refuse_copy(self, other)
    class(cleft_context), intent(inout) :: self
    type(cleft_context), intent(in) :: other
    if (c_associated(self%handle, other%handle)) return
    error stop 'cleft: a cleft_context cannot be copied'
  end subroutine

  impure elemental subroutine finalize(self)
    type(cleft_context), intent(inout) :: self
    call self%destroy()
  end subroutine

end module
