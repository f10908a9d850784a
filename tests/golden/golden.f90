! The golden case (README.md) in Fortran.
program golden
  use, intrinsic :: iso_c_binding
  use cleft
  implicit none

  integer(c_int64_t), parameter :: offset_basis = -3750763034362895579_c_int64_t  ! 0xcbf29ce484222325
  type(cleft_context) :: context
  type(cleft_options) :: options
  type(cleft_volume) :: volume
  type(cleft_mesh) :: mesh
  integer(c_int8_t) :: voxels(16, 14, 12)
  integer(c_int64_t) :: hash
  integer :: i, j, k

  do concurrent(i=0:15, j=0:13, k=0:11)
    voxels(i + 1, j + 1, k + 1) = label_at(i, j, k)
  end do

  call context%set_threads(1)
  call options%set('background', 'particles')
  call volume%create(context, voxels, spacing=[1d0, 1.25d0, 1.5d0], origin=[-4.5d0, 2.25d0, 100d0], options=options)
  call mesh%create(context, volume, options)

  hash = offset_basis
  call add(hash, transfer(mesh%points(), [0_c_int8_t]))
  call add(hash, transfer(mesh%tets() - 1_c_int32_t, [0_c_int8_t]))
  call add(hash, transfer(mesh%tet_labels(), [0_c_int8_t]))
  call print_hexadecimal(hash)

contains

  ! 200 is -56 in signed bytes.
  pure function label_at(i, j, k) result(label)
    integer, intent(in) :: i, j, k
    integer(c_int8_t) :: label
    label = 0
    if ((i - 5)**2 + (j - 6)**2 + (k - 5)**2 <= 17) label = 3
    if ((i - 10)**2 + (j - 7)**2 + (k - 6)**2 <= 14) label = -56
  end function

  ! FNV-1a. The prime is 2^40 + 435; Fortran's integers must not overflow, so the two halves are multiplied apart.
  pure subroutine add(hash, bytes)
    integer(c_int64_t), intent(inout) :: hash
    integer(c_int8_t), intent(in) :: bytes(:)
    integer(c_int64_t), parameter :: low_half = 4294967295_c_int64_t
    integer(c_int64_t) :: low, high
    integer :: n

    do n = 1, size(bytes)
      hash = ieor(hash, iand(int(bytes(n), c_int64_t), 255_c_int64_t))
      low = iand(hash, low_half)
      high = 435 * shiftr(hash, 32) + shiftl(low, 8)
      low = 435 * low
      high = iand(high + shiftr(low, 32), low_half)
      hash = ior(shiftl(high, 32), iand(low, low_half))
    end do
  end subroutine

  subroutine print_hexadecimal(number)
    integer(c_int64_t), intent(in) :: number
    character(len=16), parameter :: digits = '0123456789abcdef'
    character(len=16) :: text
    integer :: n, digit

    do n = 1, 16
      digit = int(iand(shiftr(number, 4 * (16 - n)), 15_c_int64_t)) + 1
      text(n:n) = digits(digit:digit)
    end do
    print '(a)', text
  end subroutine

end program
