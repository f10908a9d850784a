! What the modules of the Fortran interface share: texts, failures and what the library tells of itself.
module cleft_support
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit
  use cleft_c
  implicit none
  private
  public :: c_text, text_at, conclude, naming_mistake, cleft_library_version, cleft_can_make_particles

  interface
    function c_strlen(text) bind(C, name='strlen') result(length)
      import
      type(c_ptr), value :: text
      integer(c_size_t) :: length
    end function
  end interface

contains

  ! A text as C wants it.
  pure function c_text(text) result(chars)
    character(len=*), intent(in) :: text
    character(kind=c_char, len=:), allocatable :: chars
    chars = trim(text) // c_null_char
  end function

  ! The text that C shows.
  function text_at(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: chars(:)
    integer :: i

    if (.not. c_associated(pointer)) then
      text = ''
      return
    end if
    call c_f_pointer(pointer, chars, [c_strlen(pointer)])
    allocate (character(len=size(chars)) :: text)
    do i = 1, size(chars)
      text(i:i) = chars(i)
    end do
  end function

  ! Ends a fallible procedure as Fortran's own statements end: with `stat`, the caller deals with the failure and finds
  ! the sentence in `errmsg`; without it, the program stops with that sentence.
  subroutine conclude(status, sentence, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    character(len=*), intent(in) :: sentence
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg

    if (present(stat)) stat = status
    if (status == CLEFT_OK) return
    if (present(errmsg)) errmsg = sentence
    if (present(stat)) return
    if (sentence == text_at(cleft_status_string(status))) then
      write (error_unit, '(2a)') 'cleft: ', sentence
    else
      write (error_unit, '(4a)') 'cleft: ', text_at(cleft_status_string(status)), ': ', sentence
    end if
    error stop 1
  end subroutine

  ! Why a label cannot get a name.
  function naming_mistake(of, labels, label) result(sentence)
    character(len=*), intent(in) :: of
    integer(c_int32_t), intent(in) :: labels(:), label
    character(len=:), allocatable :: sentence
    character(len=16) :: number

    write (number, '(i0)') label
    if (any(labels == label)) then
      sentence = 'the name of label ' // trim(number) // ' must be one line of text, in UTF-8'
    else
      sentence = 'the ' // of // ' has no label ' // trim(number)
    end if
  end function

  ! "major.minor.patch" of the library that runs.
  function cleft_library_version() result(version)
    character(len=:), allocatable :: version
    version = text_at(cleft_version(c_null_ptr, c_null_ptr, c_null_ptr))
  end function

  ! Is TetGen in this build, which the option DELAUNAY can choose?
  function cleft_can_make_particles() result(answer)
    logical :: answer
    answer = cleft_has_tetgen() /= 0
  end function

end module
