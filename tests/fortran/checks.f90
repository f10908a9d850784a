! What the tests share: a check that names its place, and the volume that they mesh.
module checks
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  private
  public :: check, finish, two_balls, listen, stop_at_once, calls, last_fraction

  integer :: failures = 0
  integer :: calls = 0                ! of listen()
  real(c_double) :: last_fraction = 0

contains

  subroutine check(holds, what)
    logical, intent(in) :: holds
    character(len=*), intent(in) :: what
    if (holds) return
    failures = failures + 1
    write (error_unit, '(2a)') 'FAILED: ', what
  end subroutine

  subroutine finish()
    if (failures > 0) error stop 1
    print '(a)', 'all checks hold'
  end subroutine

  ! Labels 0, 5 and 9 in a small box.
  pure function two_balls() result(voxels)
    integer(c_int32_t) :: voxels(14, 12, 10)
    integer :: i, j, k

    voxels = 0
    do k = 1, 10
      do j = 1, 12
        do i = 1, 14
          if ((i - 5)**2 + (j - 6)**2 + (k - 5)**2 <= 9) voxels(i, j, k) = 5
          if ((i - 10)**2 + (j - 7)**2 + (k - 6)**2 <= 9) voxels(i, j, k) = 9
        end do
      end do
    end do
  end function

  subroutine listen(fraction, stage, cancel)
    real(c_double), intent(in) :: fraction
    character(len=*), intent(in) :: stage
    logical, intent(inout) :: cancel
    calls = calls + 1
    last_fraction = fraction
    cancel = len(stage) == 0
  end subroutine

  subroutine stop_at_once(fraction, stage, cancel)
    real(c_double), intent(in) :: fraction
    character(len=*), intent(in) :: stage
    logical, intent(inout) :: cancel
    cancel = fraction >= 0 .and. len(stage) > 0
  end subroutine

end module
