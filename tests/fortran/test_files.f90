! Files from Fortran: places in the world, what is not there, meshes there and back.
program test_files
  use, intrinsic :: iso_c_binding
  use cleft
  use cleft_io
  use checks
  implicit none

  character(len=*), parameter :: voxels_file = 'test_files.nrrd', mesh_file = 'test_files.vtu'
  real(c_double), parameter :: spacing(3) = [1d0, 2d0, 4d0], origin(3) = [100d0, -50d0, 25d0]
  type(cleft_context) :: context
  type(cleft_options) :: options
  type(cleft_volume) :: volume
  type(cleft_mesh) :: mesh, again
  type(cleft_sizing) :: sizing
  character(len=200) :: errmsg
  integer :: stat

  call write_nrrd()
  call places_are_those_of_the_file()
  call options%set('background', 'lattice')
  call mesh%create(context, volume, options)
  call cleft_write_mesh(context, mesh, mesh_file)
  call cleft_read_mesh(context, mesh_file, again)
  call check(all(again%tets() == mesh%tets()) .and. all(again%labels() == [0, 5, 9]), 'a mesh comes back as it was')
  call what_is_not_there_is_named()
  call finish()

contains

  subroutine write_nrrd()
    integer :: unit
    open (newunit=unit, file=voxels_file, access='stream', status='replace')
    write (unit) 'NRRD0004' // new_line('a') // 'type: int' // new_line('a') // 'dimension: 3' // new_line('a') // &
      'sizes: 14 12 10' // new_line('a') // 'space: left-posterior-superior' // new_line('a') // &
      'space directions: (1,0,0) (0,2,0) (0,0,4)' // new_line('a') // 'space origin: (100,-50,25)' // new_line('a') // &
      'endian: little' // new_line('a') // 'encoding: raw' // new_line('a') // new_line('a')
    write (unit) two_balls()
    close (unit)
  end subroutine

  subroutine places_are_those_of_the_file()
    call cleft_read_volume(context, voxels_file, volume)
    call check(is_at(spacing, origin), 'spacing and origin are the file''s')
    call cleft_read_volume(context, voxels_file, volume, scale=0.001d0)
    call check(is_at(spacing / 1000, origin / 1000), 'a scale takes both together')
    call cleft_read_volume(context, voxels_file, volume, spacing=[3d0, 0d0, 0d0])
    call check(is_at([3d0, 2d0, 4d0], origin), 'a spacing is taken alone, 0 for the file''s')
    call cleft_read_volume(context, voxels_file, volume, scale=0d0, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_ARGUMENT .and. index(errmsg, 'scale') > 0, 'a scale of 0 is refused')
    call check(size(volume%labels()) == 0, 'and the former volume is gone')
    call cleft_read_volume(context, voxels_file, volume, scale=-1d0, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_ARGUMENT, 'a negative scale is refused')
    call cleft_read_volume(context, voxels_file, volume)
  end subroutine

  function is_at(lengths, first) result(answer)
    real(c_double), intent(in) :: lengths(3), first(3)
    logical :: answer
    real(c_double) :: map(3, 4)
    integer :: axis
    map = volume%affine()
    answer = all(abs(map(:, 4) - first) < 1d-9 * abs(first))
    do axis = 1, 3
      answer = answer .and. abs(map(axis, axis) - lengths(axis)) < 1d-9 * lengths(axis)
    end do
  end function

  subroutine what_is_not_there_is_named()
    call cleft_read_volume(context, 'no_such_file.nrrd', volume, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_FILE .and. index(errmsg, 'no_such_file.nrrd') > 0, 'a missing volume is named')
    call cleft_read_mesh(context, 'no_such_file.vtu', again, stat, errmsg)
    call check(stat == CLEFT_ERROR_FILE .and. index(errmsg, 'no_such_file.vtu') > 0, 'a missing mesh is named')
    call check(again%tet_count() == 0, 'and nothing is left of the former one')
    call cleft_read_volume(context, voxels_file, volume)
    call sizing%create_constant(context, volume, 2d0)
    call cleft_write_sizing(context, sizing, 'test_files_sizes.nrrd')
    call cleft_read_volume(context, voxels_file, volume, scale=0.5d0)
    call cleft_read_sizing(context, volume, 'test_files_sizes.nrrd', sizing, scale=0.5d0)
    call check(abs(sizing%at(origin / 2) - 1) < 1d-6, 'a scale takes edge lengths too')
    call cleft_read_sizing(context, volume, 'test_files_sizes.nrrd', sizing, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_ARGUMENT, 'without the scale, the field lies elsewhere')
  end subroutine

end program
