! Wrong use from Fortran gives a status and a sentence, and never a crash.
program test_failures
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic
  use cleft
  use checks
  implicit none

  type(cleft_context) :: context
  type(cleft_options) :: options
  type(cleft_volume) :: volume
  type(cleft_mesh) :: mesh
  integer :: stat
  character(len=200) :: errmsg
  real(c_double) :: nan

  nan = ieee_value(nan, ieee_quiet_nan)
  call options%set('background', 'octree')
  call volume%create(context, two_balls())
  call mesh%create(context, volume, options)
  call options_refuse()
  call volumes_refuse()
  call sizings_refuse()
  call meshes_refuse()
  call what_is_destroyed_refuses()
  call cancelling_leaves_no_mesh()
  call messages_count_from_one()
  call finish()

contains

  subroutine failed(with, what)
    integer, intent(in) :: with
    character(len=*), intent(in) :: what
    call check(stat == with, what)
    call check(len_trim(errmsg) > 0, what // ': with a sentence')
    errmsg = ''
  end subroutine

  subroutine options_refuse()
    real(c_double) :: unused
    call options%set('no_such_option', 1, stat, errmsg)
    call failed(CLEFT_ERROR_OPTION, 'an unknown option is refused')
    call options%set('gradation', 7d0, stat, errmsg)
    call failed(CLEFT_ERROR_OPTION, 'a value out of range is refused')
    call options%set('size', nan, stat, errmsg)
    call check(stat /= CLEFT_OK, 'NaN is refused as an option')
    unused = options%value('no_such_option', stat, errmsg)
    call failed(CLEFT_ERROR_OPTION, 'an unknown option has no value')
    call options%set('strict', 'maybe', stat, errmsg)
    call check(stat == CLEFT_ERROR_OPTION .and. errmsg == 'strict is neither true nor false: maybe', &
      'a flag is true or false')
    call options%set_label_size(5, -1d0, stat, errmsg)
    call check(stat /= CLEFT_OK, 'a negative size of a label is refused')
    call options%set('gradation', 0.25d0, stat, errmsg)
    call check(stat == CLEFT_OK .and. options%value('gradation') == 0.25d0, 'and right values are still taken')
  end subroutine

  subroutine volumes_refuse()
    type(cleft_volume) :: other
    integer(c_int32_t) :: none(0, 4, 4)
    integer(c_int64_t) :: wide(4, 4, 4)
    real(c_double) :: field(4, 4, 4)
    integer(c_int32_t), allocatable :: labels(:)

    call other%create(context, none, stat=stat, errmsg=errmsg)
    call reported('voxels has no elements')
    call failed(CLEFT_ERROR_ARGUMENT, 'a volume without voxels is refused')
    call other%create(context, field(1:0, :, :), stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'a signed function without voxels is refused')
    call volume%set_label_name(7, 'seven', stat, errmsg)
    call reported('the volume has no label 7')
    call mesh%set_label_name(9, 'two' // new_line('a') // 'lines', stat, errmsg)
    call reported('the name of label 9 must be one line of text')
    wide = huge(0_c_int32_t)
    wide(2, 2, 2) = -wide(1, 1, 1) - 1
    call other%create(context, wide, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_OK .and. all(other%labels() == wide([2, 1], 2, 2)), 'labels of 64 bits are taken')
    wide(3, 3, 3) = wide(1, 1, 1) + 1
    call other%create(context, wide, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'a label beyond 32 bits is refused')
    call check(size(other%labels()) == 0, 'and the former volume is gone')
    call other%create(context, two_balls(), spacing=[1d0, 0d0, 1d0], stat=stat, errmsg=errmsg)
    call check(stat /= CLEFT_OK, 'a flat voxel is refused')
    call other%create(context, two_balls(), spacing=[1d0, nan, 1d0], stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_NOT_FINITE, 'a spacing of NaN is refused')
    call other%create(context, two_balls(), spacing=[1d0, -1d0, 1d0], stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'a negative spacing, which would be a mirror, is refused')
    field = 1
    field(2, 2, 2) = nan
    call other%create(context, field, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_NOT_FINITE, 'an indicator of NaN is refused')
    field = 1
    call other%create(context, field, labels=[1, 2, 3], stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'three labels for two materials are refused')
    call places_told_twice_are_refused(other, field)
    labels = volume%sample(reshape([1d0, 2d0], [2, 1]), stat, errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'points of two coordinates are refused')
    labels = volume%sample(reshape([1d0, nan, 2d0], [3, 1]), stat, errmsg)
    call failed(CLEFT_ERROR_NOT_FINITE, 'a point of NaN is refused')
  end subroutine

  subroutine places_told_twice_are_refused(other, field)
    type(cleft_volume), intent(inout) :: other
    real(c_double), intent(in) :: field(:, :, :)
    real(c_double), parameter :: affine(3, 4) = &
      reshape([1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0], [3, 4]), one(3) = 1

    call other%create(context, two_balls(), affine=affine, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_OK, 'an affine map alone is taken')
    call other%create(context, two_balls(), spacing=one, affine=affine, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'affine and spacing are refused')
    call check(size(other%labels()) == 0, 'and the former volume is gone')
    call other%create(context, two_balls(), origin=one, affine=affine, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'affine and origin are refused')
    call other%create(context, field, spacing=one, affine=affine, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'affine and spacing are refused for functions')
  end subroutine

  ! What a message numbers is what the program numbers so.
  subroutine messages_count_from_one()
    type(cleft_volume) :: other
    type(cleft_mesh) :: mesh
    type(cleft_validation) :: findings
    real(c_double) :: points(3, 8), fields(4, 4, 4, 3), affine(3, 4)
    integer(c_int32_t) :: tets(4, 2)

    points = reshape([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 5, 5, 6, 5, 5, 5, 6, 5, 5, 5, 6], [3, 8])
    tets = reshape([1, 2, 3, 4, 5, 6, 7, 9], [4, 2])
    call mesh%create_arrays(context, points, tets, stat=stat, errmsg=errmsg)
    call reported('the 2nd tetrahedron names point 9, but there are 8 points, counted from 1')
    tets(4, 2) = 0
    call mesh%create_arrays(context, points, tets, stat=stat, errmsg=errmsg)
    call reported('the 2nd tetrahedron names point 0')
    tets(:, 2) = [6, 5, 7, 8]
    call mesh%create_arrays(context, points, tets)
    findings = mesh%validate(context)
    errmsg = context%last_error()
    call reported('the 2nd tetrahedron at (5.25, 5.25, 5.25) is inverted')
    points(2, 3) = nan
    call mesh%create_arrays(context, points, tets, stat=stat, errmsg=errmsg)
    call reported('the 3rd point')

    fields = 1
    fields(4, 1, 2, 3) = nan
    call other%create(context, fields, stat=stat, errmsg=errmsg)
    call reported('the 3rd indicator function')
    call reported('the 4th along x, the 1st along y and the 2nd along z')
    affine = 0
    affine(1, 1) = 1
    affine(2, 2) = 1
    call other%create(context, two_balls(), affine=affine, stat=stat, errmsg=errmsg)
    call reported('3rd axis')
    affine(2, 3) = nan
    call other%create(context, two_balls(), affine=affine, stat=stat, errmsg=errmsg)
    call reported('2nd row, 3rd column')
  end subroutine

  subroutine reported(words)
    character(len=*), intent(in) :: words
    call check(index(errmsg, words) > 0, trim(errmsg) // ' does not mention ' // words)
  end subroutine

  subroutine sizings_refuse()
    type(cleft_sizing) :: sizing
    real(c_double) :: short(14, 12, 9), values(14, 12, 10)
    real(c_double), allocatable :: tensors(:, :, :, :)
    real(c_float), allocatable :: metric(:, :, :, :)

    short = 1
    call sizing%create_values(context, volume, short, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'a sizing field of another shape is refused')
    values = 1
    values(3, 3, 3) = nan
    call sizing%create_values(context, volume, values, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_NOT_FINITE, 'a size of NaN is refused')
    call sizing%create_constant(context, volume, 0d0, stat, errmsg)
    call check(stat /= CLEFT_OK, 'a size of zero is refused')
    allocate (tensors(6, 14, 12, 10), source=1d0)
    call sizing%create_metric(context, volume, reshape(tensors, [5, 14, 12, 10]), stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'tensors of another shape are refused')
    call sizing%create_metric(context, volume, tensors, stat=stat, errmsg=errmsg)
    call reported('voxel')
    call failed(CLEFT_ERROR_ARGUMENT, 'a tensor that is not positive definite is refused')
    call sizing%create_constant_metric(context, volume, tensors(:, 1, 1, 1), stat, errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'a constant tensor that is not positive definite is refused')
    call sizing%create_constant(context, volume, 2d0)
    metric = sizing%metric(stat, errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'sizes alone have no metric')
    call check(size(metric) == 0, 'a metric that is not there is empty')
  end subroutine

  subroutine meshes_refuse()
    type(cleft_mesh) :: other
    real(c_double) :: points(3, 4)
    integer(c_int32_t) :: tets(4, 1)

    points = reshape([0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 4])
    tets(:, 1) = [1, 2, 3, 4]
    call other%create_arrays(context, points, tets, stat=stat, errmsg=errmsg)
    call check(stat == CLEFT_OK .and. other%tet_count() == 1, 'one tetrahedron is a mesh')
    call other%create_arrays(context, transpose(points), tets, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'transposed points are refused')
    call check(other%tet_count() == 0, 'and nothing is left of the former mesh')
    call other%create_arrays(context, points, tets, labels=[1, 2], stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'two labels for one tetrahedron are refused')
    call other%create_arrays(context, points, tets - 1, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_ARGUMENT, 'a corner numbered 0 is refused')
    points(2, 2) = nan
    call other%create_arrays(context, points, tets, stat=stat, errmsg=errmsg)
    call failed(CLEFT_ERROR_NOT_FINITE, 'a coordinate of NaN is refused')
  end subroutine

  subroutine what_is_destroyed_refuses()
    type(cleft_volume) :: no_volume
    type(cleft_mesh) :: no_mesh, other
    type(cleft_sizing) :: no_sizing
    type(cleft_surface) :: surface
    type(cleft_report) :: report
    type(cleft_quality) :: quality
    type(cleft_label_report) :: row
    real(c_double), allocatable :: points(:, :)
    integer(c_int32_t), allocatable :: tets(:, :)
    real(c_float), allocatable :: values(:, :, :)
    character(len=:), allocatable :: name
    real(c_double) :: value
    integer :: dims(3)

    call context%set_threads(5000, stat, errmsg)
    call context%metric(0, name, value, stat, errmsg)
    call reported('there is no such figure')  ! and no sentence of another failure
    call check(stat /= CLEFT_OK .and. name == '' .and. abs(value) < tiny(value), 'there is no figure number 0')
    call other%create_arrays(context, mesh%points(), mesh%tets())
    call other%destroy()
    call other%destroy()
    points = other%points(stat, errmsg)
    call check(stat /= CLEFT_OK .and. size(points) == 0, 'a destroyed mesh has no points')
    tets = other%tets(stat, errmsg)
    call check(stat /= CLEFT_OK .and. size(tets) == 0, 'a destroyed mesh has no tetrahedra')
    call other%quadratic(points, tets, stat, errmsg)
    call check(stat /= CLEFT_OK .and. size(tets) == 0, 'a destroyed mesh has no ten-node tetrahedra')
    quality = other%quality(context, stat, errmsg)
    call failed(CLEFT_ERROR_NULL, 'a destroyed mesh has no quality')
    call other%create(context, no_volume, stat=stat, errmsg=errmsg)
    call reported('volume is not there: destroyed, or never made')
    call failed(CLEFT_ERROR_NULL, 'a volume that was never made cannot be meshed')
    call other%create(context, volume, options, background=no_mesh, stat=stat, errmsg=errmsg)
    call reported('background is not there')
    call failed(CLEFT_ERROR_NULL, 'a background that was never made is not left out in silence')
    call other%create(context, volume, options, sizing=no_sizing, stat=stat, errmsg=errmsg)
    call reported('sizing is not there')
    call failed(CLEFT_ERROR_NULL, 'a sizing field that was never made is not left out in silence')
    call check(other%tet_count() == 0, 'and nothing is made')
    call surface%create(context, no_mesh, stat, errmsg)
    call failed(CLEFT_ERROR_NULL, 'a mesh that was never made has no surface')
    call check(surface%interface_count() == 0 .and. size(surface%hull_triangles()) == 0, &
      'a surface that was never made is empty')
    dims = no_volume%dims(stat, errmsg)
    call check(stat /= CLEFT_OK, 'a volume that was never made has no dims')
    values = no_sizing%values(stat, errmsg)
    call check(stat /= CLEFT_OK .and. size(values) == 0, 'a field that was never made has no values')
    row = report%label(1, stat, errmsg)
    call check(stat /= CLEFT_OK, 'a report that was never made has no rows')
    call report%create(context, volume, mesh)
    row = report%label(4, stat, errmsg)
    call check(stat /= CLEFT_OK, 'a report has no row beyond its last')
  end subroutine

  subroutine cancelling_leaves_no_mesh()
    type(cleft_mesh) :: other
    call context%set_progress(stop_at_once)
    call other%create(context, volume, options, stat=stat, errmsg=errmsg)
    call context%set_progress()
    call failed(CLEFT_ERROR_CANCELLED, 'progress can cancel')
    call check(other%tet_count() == 0, 'a cancelled call leaves no mesh')
  end subroutine

end program
