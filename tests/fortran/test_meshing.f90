! Meshing from Fortran: shapes, numbering, agreement of the stages, progress and figures.
program test_meshing
  use, intrinsic :: iso_c_binding
  use cleft
  use checks
  implicit none

  real(c_double), parameter :: spacing(3) = [1d0, 0.5d0, 2d0], origin(3) = [10d0, 20d0, 30d0]
  type(cleft_context) :: context
  type(cleft_options) :: options
  type(cleft_volume) :: volume
  type(cleft_mesh) :: mesh

  call context%set_threads(2)
  call check(context%threads() == 2, 'threads are what was set')
  call options%set('background', 'octree')
  call options%set('feature_scale', 1.5)
  call check(options%value('feature_scale') == 1.5d0, 'a single-precision value is taken')
  call options%set('seed', 3)
  call check(options%value('seed') == 3, 'an integer is taken')
  call options%set('strict', .true.)
  call check(options%value('strict') == 1, 'a logical is taken')
  call options%set('strict', .false.)

  call volume%create(context, two_balls(), spacing, origin, options=options)
  call volume_is_as_given()
  call context%set_progress(listen)
  call mesh%create(context, volume, options)
  call context%set_progress()
  call check(calls > 0, 'progress was reported')
  call check(last_fraction > 0.5d0 .and. last_fraction <= 1, 'progress went on')
  call mesh_is_sound()
  call mesh_goes_through_arrays()
  call stages_make_a_mesh()
  call metrics_come_in_and_go_out()
  call the_one_call_is_the_five_calls()
  call the_estimate_is_near()
  call surface_belongs_to_mesh()
  call report_agrees()
  call indicators_are_taken()
  call contacts_are_told()
  call labels_have_names()
  call figures_are_noted()
  call finish()

contains

  subroutine volume_is_as_given()
    real(c_double) :: map(3, 4)
    integer(c_int32_t) :: found(2)

    call check(all(volume%dims() == [14, 12, 10]), 'dims are those of the array')
    map = volume%affine()
    call check(map(1, 1) == 1 .and. map(2, 2) == 0.5d0 .and. map(3, 3) == 2 .and. all(map(:, 4) == origin), &
      'the affine map has spacing and origin')
    call check(map(1, 2) == 0 .and. map(2, 1) == 0, 'the affine map is diagonal')
    call check(all(volume%labels() == [0, 5, 9]), 'labels ascend')
    call check(volume%indicator_count() == 0, 'a label map has no functions')
    call check(sum(volume%voxel_counts()) == 14 * 12 * 10, 'all voxels are counted')
    found = volume%sample(reshape([origin + spacing * [4, 5, 4], origin], [3, 2]))
    call check(all(found == [5, 0]), 'samples are the labels of the voxels')
  end subroutine

  subroutine mesh_is_sound()
    real(c_double), allocatable :: points(:, :)
    integer(c_int32_t), allocatable :: tets(:, :), labels(:)
    type(cleft_quality) :: quality
    type(cleft_validation) :: findings
    real(c_double) :: total
    integer :: t

    points = mesh%points()
    tets = mesh%tets()
    labels = mesh%tet_labels()
    call check(all(shape(points) == [3, mesh%point_count()]), 'points are shaped (3, n)')
    call check(all(shape(tets) == [4, mesh%tet_count()]), 'tets are shaped (4, m)')
    call check(size(labels) == mesh%tet_count(), 'every tetrahedron has a label')
    call check(minval(tets) == 1 .and. maxval(tets) == mesh%point_count(), 'points are numbered from 1')
    call check(all(mesh%labels() == [0, 5, 9]), 'no label is lost')
    call check(abs(minval(points(1, :)) - 9.5d0) < 1d-9, 'the box begins half a voxel before the first centre')

    total = 0
    do t = 1, size(tets, 2)
      total = total + volume_of(points(:, tets(:, t)))
    end do
    call check(abs(total - 14 * 12 * 10) < 1d-6, 'tetrahedra fill the box')
    quality = mesh%quality(context)
    call check(quality%tet_count == size(tets, 2) .and. abs(quality%total_volume - total) < 1d-6, &
      'quality is of this mesh')
    findings = mesh%validate(context, fills_box=.true.)
    call check(findings%valid == 1, 'the mesh is valid')
  end subroutine

  pure function volume_of(corners) result(volume)
    real(c_double), intent(in) :: corners(3, 4)
    real(c_double) :: volume, a(3), b(3), c(3)
    a = corners(:, 2) - corners(:, 1)
    b = corners(:, 3) - corners(:, 1)
    c = corners(:, 4) - corners(:, 1)
    volume = dot_product(a, [b(2) * c(3) - b(3) * c(2), b(3) * c(1) - b(1) * c(3), b(1) * c(2) - b(2) * c(1)]) / 6
  end function

  subroutine mesh_goes_through_arrays()
    type(cleft_mesh) :: again
    real(c_double), allocatable :: points(:, :)
    integer(c_int32_t), allocatable :: tets(:, :)

    call again%create_arrays(context, mesh%points(), mesh%tets(), mesh%tet_labels())
    call check(all(again%tets() == mesh%tets()) .and. all(again%points() == mesh%points()) .and. &
      all(again%tet_labels() == mesh%tet_labels()), 'a mesh from arrays is the same mesh')
    call again%quadratic(points, tets)
    call check(all(tets(1:4, :) == mesh%tets()), 'corners come first in ten-node tetrahedra')
    call check(maxval(abs(points(:, tets(5, 1)) - (points(:, tets(1, 1)) + points(:, tets(2, 1))) / 2)) < 1d-12, &
      'the fifth node is in the middle of the first edge')
  end subroutine

  subroutine stages_make_a_mesh()
    type(cleft_sizing) :: sizing, own
    type(cleft_mesh) :: background, cleaved, improved, stripped
    type(cleft_options) :: strip
    type(cleft_validation) :: findings
    real(c_float), allocatable :: values(:, :, :)

    call sizing%create(context, volume, options)
    values = sizing%values()
    call check(all(shape(values) == volume%dims()), 'a sizing field has a value for each voxel')
    call check(sizing%at(origin) > 0 .and. sizing%expected_tets() > 100, 'a sizing field can be asked')
    call own%create_values(context, volume, 2 * values)
    call check(own%expected_tets() < sizing%expected_tets(), 'doubled sizes make fewer tetrahedra')
    call own%create_constant(context, volume, 2d0)
    call check(abs(own%at(origin) - 2) < 1d-6, 'a constant field is constant')

    call background%create_background(context, sizing, options)
    call check(all(background%labels() == [0]), 'a background knows no labels')
    call cleaved%cleave(context, volume, background, options)
    call improved%improve(context, volume, cleaved, options)
    findings = improved%validate(context, fills_box=.true.)
    call check(findings%valid == 1, 'the stages make a valid mesh')
    call strip%set_strip([0])
    call stripped%strip(context, improved, strip)
    call check(all(stripped%labels() == [5, 9]), 'label 0 can be stripped')
  end subroutine

  subroutine metrics_come_in_and_go_out()
    type(cleft_sizing) :: sizing
    type(cleft_mesh) :: mesh
    type(cleft_metric_quality) :: figures
    real(c_double), allocatable :: tensors(:, :, :, :)
    integer :: n(3), i

    n = volume%dims()
    allocate (tensors(6, n(1), n(2), n(3)))
    do i = 1, n(1)
      tensors(:, i, :, :) = spread(spread([0.2d0 + 0.01d0 * i, 0.01d0, -0.02d0, 0.3d0, 0.03d0, 0.5d0], 2, n(2)), 3, &
        n(3))
    end do
    call sizing%create_metric(context, volume, tensors)
    call check(sizing%has_metric(), 'a field of tensors has a metric')
    call check(all(shape(sizing%metric()) == [6, n]), 'a metric has six numbers for each voxel')
    call check(maxval(abs(sizing%metric() - tensors)) < 1d-5, 'a metric comes back as it was given')
    call sizing%create_metric(context, volume, real(tensors, c_float), combine=.true., options=options)
    call check(sizing%has_metric(), 'a metric can be combined with features')
    call sizing%create_constant_metric(context, volume, [1d0 / 9, 0d0, 0d0, 1d0 / 9, 0d0, 1d0])
    tensors = sizing%metric()
    call check(maxval(abs(tensors(6, :, :, :) - 1)) < 1d-6, 'a constant metric is constant')
    call mesh%create(context, volume, options, sizing)
    figures = mesh%metric_quality(context, sizing)
    call check(figures%tet_count == mesh%tet_count(), 'quality in a metric is of this mesh')
    call check(figures%edge_least > 0 .and. figures%edge_least < 1 .and. figures%edge_greatest > 1, &
      'a metric measures edges')
    call sizing%create_constant(context, volume, 2d0)
    call check(.not. sizing%has_metric(), 'sizes alone are no metric')
  end subroutine

  subroutine the_one_call_is_the_five_calls()
    character(len=9), parameter :: backgrounds(3) = [character(len=9) :: 'particles', 'lattice', 'octree']
    type(cleft_sizing) :: own
    real(c_float), allocatable :: values(:, :, :)
    integer :: b

    call own%create(context, volume, options)
    values = 0.9 * own%values()
    call own%create_values(context, volume, values)
    do b = 1, 3
      call stages_agree(trim(backgrounds(b)), 0)
      call stages_agree(trim(backgrounds(b)), 3000)
      call stages_agree(trim(backgrounds(b)), 0, own)
    end do
  end subroutine

  subroutine stages_agree(kind, tets, own)
    character(len=*), intent(in) :: kind
    integer, intent(in) :: tets
    type(cleft_sizing), intent(in), optional :: own
    type(cleft_options) :: wanted
    type(cleft_sizing) :: sizing

    call wanted%set('background', kind)
    call wanted%set('tets', tets)
    if (tets > 0) call wanted%set_strip([0])
    if (present(own)) then
      call wanted%set('strict', .true.)
      call compare(own, wanted, .true.)
    else
      call sizing%create(context, volume, wanted)
      call compare(sizing, wanted, .false.)
    end if
  end subroutine

  subroutine compare(sizing, wanted, is_given)
    type(cleft_sizing), intent(in) :: sizing
    type(cleft_options), intent(inout) :: wanted
    logical, intent(in) :: is_given
    type(cleft_mesh) :: background, cleaved, improved, stripped, whole

    call background%create_background(context, sizing, wanted)
    call cleaved%cleave(context, volume, background, wanted)
    call improved%improve(context, volume, cleaved, wanted)
    call stripped%strip(context, improved, wanted)
    if (is_given) then
      call whole%create(context, volume, wanted, sizing)
    else
      call whole%create(context, volume, wanted)
    end if
    call check(stripped%tet_count() == whole%tet_count(), 'the five calls make as many tetrahedra as the one')
    call check(all(stripped%points() == whole%points()) .and. all(stripped%tets() == whole%tets()) .and. &
      all(stripped%tet_labels() == whole%tet_labels()), 'the five calls make the mesh of the one')
  end subroutine

  subroutine the_estimate_is_near()
    type(cleft_estimate) :: figures
    type(cleft_options) :: wanted
    type(cleft_mesh) :: made

    call wanted%set('background', 'octree')
    call wanted%set('size', 0.8d0)
    figures = estimate_mesh(context, volume, wanted)
    call made%create(context, volume, wanted)
    call check(abs(figures%tets - made%tet_count()) < 0.15d0 * made%tet_count(), 'the estimate is near')
    call check(figures%peak_bytes > 100 * figures%tets, 'a mesh takes memory')
  end subroutine

  subroutine surface_belongs_to_mesh()
    type(cleft_surface) :: surface
    integer(c_int32_t), allocatable :: triangles(:, :), labels(:, :), sides(:)

    call surface%create(context, mesh)
    triangles = surface%interface_triangles()
    labels = surface%interface_labels()
    call check(size(triangles, 1) == 3 .and. size(triangles, 2) == surface%interface_count(), 'triangles have corners')
    call check(minval(triangles) >= 1 .and. maxval(triangles) <= mesh%point_count(), 'corners are points of the mesh')
    call check(all(labels(1, :) < labels(2, :)), 'the lower label comes first')
    triangles = surface%hull_triangles()
    sides = surface%hull_sides()
    call check(size(triangles, 2) == surface%hull_count() .and. size(surface%hull_labels()) == size(sides), &
      'every hull triangle has a label and a side')
    call check(all(sides >= CLEFT_SIDE_X_MIN .and. sides <= CLEFT_SIDE_Z_MAX), 'the hull is the box')
  end subroutine

  subroutine report_agrees()
    type(cleft_report) :: report
    type(cleft_label_report) :: row

    call report%create(context, volume, mesh)
    call check(report%count() == 3, 'the report has a row for each label')
    row = report%label(2)
    call check(row%label == 5 .and. row%tets == count(mesh%tet_labels() == 5), 'its rows are counted from 1')
  end subroutine

  ! A ball in a socket, the gap between them narrower than the tetrahedra.
  subroutine contacts_are_told()
    type(cleft_options) :: coarse
    type(cleft_volume) :: joint
    type(cleft_mesh) :: made
    type(cleft_report) :: report
    type(cleft_contact) :: pair
    type(cleft_distance) :: distance
    integer(c_int32_t) :: voxels(24, 24, 24)
    real(c_double) :: r
    integer :: i, j, k, stat

    voxels = 0
    do k = 1, 24
      do j = 1, 24
        do i = 1, 24
          r = norm2([i - 12.5d0, j - 12.5d0, k - 12.5d0])
          if (r < 6) voxels(i, j, k) = 7
          if (r > 7.6d0 .and. r < 10.5d0 .and. k < 15) voxels(i, j, k) = -1
        end do
      end do
    end do
    call joint%create(context, voxels)
    call coarse%set('size', 3.5)
    call coarse%set('background', 'lattice')
    call made%create(context, joint, coarse)
    call report%create(context, joint, made)
    call check(report%contact_count() == 1, 'the ball touches its socket')
    pair = report%contact(1)
    call check(pair%first == -1 .and. pair%second == 7 .and. pair%triangles > 0, 'both are named')
    pair = report%contact(2, stat)
    call check(stat == CLEFT_ERROR_ARGUMENT, 'there is no second contact')
    call check(report%distance_count() == 0, 'distances were not asked for')
    call report%create(context, joint, made, distances=.true.)
    call check(report%distance_count() >= 3, 'any two of three labels touch')
    distance = report%distance(1)
    call check(distance%first == -1 .and. distance%second == 0 .and. distance%mesh_greatest > 0, 'they ascend')
    distance = report%distance(report%distance_count() + 1, stat)
    call check(stat == CLEFT_ERROR_ARGUMENT, 'there is no further distance')
    call report%create(context, volume, mesh)
    call check(report%contact_count() == 0, 'a fine mesh has none')
  end subroutine

  subroutine labels_have_names()
    type(cleft_volume) :: named
    type(cleft_mesh) :: made
    character(len=200) :: errmsg
    integer :: stat

    call named%create(context, two_balls())
    call check(named%label_name(5) == '', 'no label has a name at first')
    call named%set_label_name(5, 'left kidney')
    call named%set_label_name(9, 'liver')
    call named%set_label_name(9, '')
    call named%set_label_name(4, 'none', stat, errmsg)
    call check(stat == CLEFT_ERROR_ARGUMENT .and. index(errmsg, '4') > 0, 'a label that is not there has no name')
    call made%create(context, named, options)
    call check(made%label_name(5) == 'left kidney' .and. made%label_name(9) == '', &
      'the mesh has the names of the volume')
    call made%set_label_name(9, 'spleen')
    call check(made%label_name(9) == 'spleen' .and. named%label_name(9) == '', 'and its own')
  end subroutine

  subroutine indicators_are_taken()
    type(cleft_volume) :: signed, fields
    real(c_float) :: distance(8, 8, 8), pair(8, 8, 8, 2)
    integer :: i, j, k

    do concurrent(i=1:8, j=1:8, k=1:8)
      distance(i, j, k) = 3 - norm2([i - 4.5, j - 4.5, k - 4.5])
    end do
    call signed%create(context, distance, labels=[4, 7])
    call check(all(signed%labels() == [4, 7]), 'a signed function has two labels')
    call check(signed%indicator_count() == 1, 'and is one function')
    call check(all(signed%sample(reshape([4d0, 4d0, 4d0, 0.5d0, 0.5d0, 0.5d0], [3, 2])) == [7, 4]), &
      'the second label is inside')
    pair(:, :, :, 1) = -distance
    pair(:, :, :, 2) = distance
    call fields%create(context, real(pair, c_double))
    call check(all(fields%sample(reshape([4d0, 4d0, 4d0, 0.5d0, 0.5d0, 0.5d0], [3, 2])) == [1, 0]), &
      'the largest indicator wins')
  end subroutine

  subroutine figures_are_noted()
    character(len=:), allocatable :: name
    real(c_double) :: value

    call check(context%metric_count() > 0, 'figures were noted')
    call context%metric(1, name, value)
    call check(len(name) > 0, 'figures have names')
    call context%clear_metrics()
    call check(context%metric_count() == 0, 'figures can be forgotten')
    call check(index(cleft_library_version(), '.') > 0, 'the version is reported')
  end subroutine

end program
