! Memory stays flat over 1,000 cycles of making everything and letting it go out of scope.
program test_cycles
  use, intrinsic :: iso_c_binding
  use cleft
  use checks
  implicit none

  type :: part  ! of a program's own: what it holds goes with it
    type(cleft_mesh) :: mesh
    type(cleft_volume), allocatable :: volumes(:)
  end type

  integer :: cycle, before

  do cycle = 1, 200
    call make_and_leave()
  end do
  before = resident_kilobytes()
  do cycle = 1, 1000
    call make_and_leave()
  end do
  call check(before > 0, 'the system reports how much memory is used')
  call check(resident_kilobytes() - before < 2000, 'memory is flat')
  call finish()

contains

  subroutine make_and_leave()
    type(cleft_context) :: context
    type(cleft_options) :: options
    type(cleft_volume) :: volume
    type(cleft_sizing) :: sizing
    type(cleft_mesh) :: mesh, meshes(2)
    type(cleft_surface) :: surface
    type(part), allocatable :: parts(:)
    integer :: stat
    integer(c_int32_t) :: voxels(4, 4, 4)

    voxels = 0
    voxels(2:3, 2:3, 2:3) = 1
    call options%set('background', 'lattice')
    call options%set('size', 2d0)
    call context%set_progress(listen)
    call volume%create(context, voxels, options=options)
    call volume%create(context, voxels, options=options)
    call sizing%create(context, volume, options)
    call mesh%create(context, volume, options, sizing)
    call meshes(1)%create_arrays(context, mesh%points(), mesh%tets())
    call meshes(2)%create_arrays(context, mesh%points(), mesh%tets(), stat=stat)
    call surface%create(context, mesh)
    allocate (parts(2))
    call parts(2)%mesh%create(context, volume, options)
    allocate (parts(1)%volumes(3))
    call parts(1)%volumes(2)%create(context, voxels)
    call mesh%create_arrays(context, mesh%points(), mesh%tets() + 1000000, stat=stat)
  end subroutine

  function resident_kilobytes() result(kilobytes)
    integer :: kilobytes, unit, status
    character(len=200) :: line

    kilobytes = 0
    open (newunit=unit, file='/proc/self/status', action='read')
    do
      read (unit, '(a)', iostat=status) line
      if (status /= 0) exit
      if (line(1:6) == 'VmRSS:') read (line(7:index(line, 'kB') - 1), *) kilobytes
    end do
    close (unit)
  end function

end program
