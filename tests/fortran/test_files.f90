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
  call tables_name_labels()
  call what_is_not_there_is_named()
  call metrics_are_written_and_read()
  call raw_voxels_are_read()
  call fields_are_read()
  call files_are_told_apart()
  call pictures_are_drawn()
  call views_are_written()
  call finish()

contains

  subroutine pictures_are_drawn()
    character(len=*), parameter :: picture_file = 'fortran_picture.png'
    integer :: unit
    integer(c_int8_t) :: head(26)
    character(len=200) :: message

    call cleft_write_picture(context, mesh, picture_file, by=CLEFT_IO_BY_ANGLE, size=[64, 48], edges=.false., &
      legend=.true., cut=[0.5d0, 0d0, 0.5d0], strip=[0_c_int32_t], whole=[9_c_int32_t], zoom=1.5d0)
    open (newunit=unit, file=picture_file, access='stream', form='unformatted', status='old')
    read (unit) head
    close (unit, status='delete')
    call check(head(20) == 64 .and. head(24) == 48, 'a picture has the size that was asked for')
    call cleft_write_picture(context, mesh, picture_file, cut=[1.5d0, 0d0, 0d0], stat=stat, errmsg=message)
    call check(stat == CLEFT_ERROR_ARGUMENT .and. index(message, 'cut along x') > 0, 'a wrong cut is named')
    call cleft_write_picture(context, mesh, picture_file, strip=[0_c_int32_t, 5_c_int32_t, 9_c_int32_t], stat=stat)
    call check(stat == CLEFT_ERROR_ARGUMENT, 'a picture of nothing is refused')
  end subroutine

  subroutine views_are_written()
    character(len=*), parameter :: page_file = 'fortran_view.html'
    character(len=4000) :: start
    character(len=200) :: message
    integer :: unit

    call cleft_write_view(context, mesh, page_file, title='ours', report='{}', goal=20d0, max_tets=50_c_int64_t, &
      other=mesh, other_title='theirs')
    open (newunit=unit, file=page_file, access='stream', form='unformatted', status='old')
    read (unit) start
    close (unit, status='delete')
    call check(index(start, '<title>ours | theirs</title>') > 0, 'a view has the titles of both meshes')
    call cleft_write_view(context, mesh, page_file, goal=91d0, stat=stat, errmsg=message)
    call check(stat == CLEFT_ERROR_ARGUMENT .and. index(message, 'goal') > 0, 'a wrong goal is named')
    call cleft_write_view(context, mesh, page_file, names='none.txt', stat=stat)
    call check(stat == CLEFT_ERROR_FILE, 'a table that is not there is refused')
  end subroutine

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

  subroutine tables_name_labels()
    integer :: unit
    open(newunit=unit, file='test_files_names.txt', action='write')
    write(unit, '(a)') '5 left kidney', '9 liver'
    close(unit)
    call cleft_read_names(context, 'test_files_names.txt', mesh)
    call cleft_read_names(context, 'test_files_names.txt', volume)
    call check(mesh%label_name(5) == 'left kidney' .and. volume%label_name(9) == 'liver', 'a table names labels')
    call cleft_read_names(context, 'no_such_table.txt', mesh, stat, errmsg)
    call check(stat == CLEFT_ERROR_FILE .and. index(errmsg, 'no_such_table.txt') > 0, 'a missing table is named')
  end subroutine

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

  subroutine metrics_are_written_and_read()
    real(c_float), allocatable :: wanted(:, :, :, :)

    call cleft_read_volume(context, voxels_file, volume)
    call sizing%create_constant_metric(context, volume, [0.3d0, 0.01d0, -0.02d0, 0.4d0, 0.03d0, 0.5d0])
    wanted = sizing%metric()
    call cleft_write_sizing(context, sizing, 'test_files_metric.nrrd')
    call cleft_read_metric(context, 'test_files_metric.nrrd', sizing, volume)
    call check(maxval(abs(sizing%metric() - wanted)) < 1e-5, 'a metric comes back from a file')
    call cleft_read_metric(context, 'test_files_metric.nrrd', sizing, order=CLEFT_IO_ORDER_NRRD)
    call check(all(sizing%dims() == volume%dims()), 'without a volume, a metric has the voxels of its file')
    call volume%destroy()
    call cleft_read_metric(context, 'test_files_metric.nrrd', sizing, volume, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_NULL, 'a volume that was destroyed is not left out in silence')
  end subroutine

  subroutine raw_voxels_are_read()
    integer, parameter :: dims(3) = [14, 12, 10]
    character(len=*), parameter :: file = 'test_files.raw', rest = 'test_rest.raw'
    integer :: unit, kind, functions
    real(c_float) :: mask(2, 2, 2)

    open (newunit=unit, file=file, access='stream', status='replace')
    write (unit) 'head', ishft(two_balls(), 24)  ! small numbers with their bytes in the other order
    close (unit)
    call cleft_read_raw(context, file, dims, CLEFT_TYPE_INT32, volume, spacing, big_endian=.true., skip=4)
    call check(all(volume%labels() == [0, 5, 9]) .and. is_at(spacing, spacing / 2), 'raw voxels and their spacing')
    call check(all(volume%voxel_counts() == &
      [count(two_balls() == 0), count(two_balls() == 5), count(two_balls() == 9)]), 'raw voxels are those of the file')
    call cleft_read_raw(context, file, dims, CLEFT_TYPE_INT32, volume, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_FORMAT .and. index(errmsg, file) > 0, 'bytes that are left over are reported')
    call check(size(volume%labels()) == 0, 'and the former volume is gone')
    call cleft_read_raw(context, file, [14, 12, 0], CLEFT_TYPE_INT32, volume, stat=stat)
    call check(stat == CLEFT_ERROR_ARGUMENT, 'no voxels are refused')
    call cleft_read_raw(context, file, dims, CLEFT_TYPE_INT32, volume, [0d0, 0d0, 0d0], .true., 4, &
      stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_ARGUMENT .and. index(errmsg, 'spacing') > 0, 'a spacing of 0 is refused')

    mask = reshape([0., 1., 0., 1., 0., 1., 0., 1.], [2, 2, 2])
    open (newunit=unit, file=file, access='stream', status='replace')
    write (unit) mask
    close (unit)
    open (newunit=unit, file=rest, access='stream', status='replace')
    write (unit) 1 - mask
    close (unit)
    do kind = CLEFT_IO_KIND_AUTO, CLEFT_IO_KIND_INDICATORS
      functions = merge(1, 0, kind == CLEFT_IO_KIND_INDICATORS)
      call cleft_read_raw(context, file, [2, 2, 2], CLEFT_TYPE_FLOAT32, volume, kind=kind)
      call check(volume%indicator_count() == functions, 'the kind decides what one file means')
      call cleft_read_raw(context, [character(len=16) :: file, rest], [2, 2, 2], CLEFT_TYPE_FLOAT32, volume, kind=kind)
      call check(volume%indicator_count() == 2 * functions, 'the kind decides what two files mean')
    end do
  end subroutine

  subroutine fields_are_read()
    real(c_double), allocatable :: values(:, :, :)
    real(c_double) :: map(3, 4)

    call cleft_read_field(context, voxels_file, values, map, world=CLEFT_IO_WORLD_RAS)
    call check(all(shape(values) == [14, 12, 10]), 'a field has the shape of the file')
    call check(all(values == two_balls()), 'and its values')
    call check(all(abs(map(:, 4) - [-100, 50, 25]) < 1d-9) .and. abs(map(1, 1) + 1) < 1d-9, 'its places are in RAS')
    call cleft_read_field(context, voxels_file, values, map, scale=0.5d0)
    call check(abs(map(3, 3) - 2) < 1d-9 .and. maxval(values) == 9, 'a scale does not multiply the numbers')
    call cleft_read_field(context, 'no_such_file.nrrd', values, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_ERROR_FILE .and. index(errmsg, 'no_such_file.nrrd') > 0 .and. size(values) == 0, &
      'a missing field is named')
    call cleft_read_field(context, voxels_file, values, scale=-1d0, stat=stat)
    call check(stat == CLEFT_ERROR_ARGUMENT .and. size(values) == 0, 'a wrong scale is refused')
  end subroutine

  subroutine files_are_told_apart()
    call check(cleft_guess(voxels_file) == CLEFT_IO_VOLUME, 'a volume is one')
    call check(cleft_guess(mesh_file) == CLEFT_IO_MESH, 'a mesh is one')
    call check(cleft_guess('notes.txt') == CLEFT_IO_UNKNOWN, 'anything else is neither')
  end subroutine

end program
