! Files: reading volumes, reading and writing meshes. Programs that use this module link libcleft_io, too.
! include/cleft/cleft_io.h and docs/formats.md tell what each format holds.
module cleft_io
  use, intrinsic :: iso_c_binding
  use cleft_c
  use cleft_io_c
  use cleft_support
  use cleft
  use cleft_volumes, only: c_options
  implicit none
  private
  public :: cleft_read_volume, cleft_read_raw, cleft_read_field, cleft_write_mesh, cleft_read_mesh, &
    cleft_write_sizing, cleft_read_sizing, cleft_read_metric, cleft_guess, cleft_write_picture, cleft_write_view, &
    cleft_read_names
  ! <numbers> made by tools/generate.py from include/cleft/cleft_io.h
  public :: CLEFT_TYPE_UINT8, CLEFT_TYPE_UINT16, CLEFT_TYPE_INT16, CLEFT_TYPE_UINT32, CLEFT_TYPE_INT32, &
    CLEFT_TYPE_FLOAT32, CLEFT_TYPE_FLOAT64, CLEFT_FORMAT_BY_NAME, CLEFT_FORMAT_VTU, CLEFT_FORMAT_VTP, &
    CLEFT_FORMAT_VTK, CLEFT_FORMAT_MEDIT, CLEFT_FORMAT_MSH41, CLEFT_FORMAT_MSH22, CLEFT_FORMAT_ABAQUS, &
    CLEFT_FORMAT_TETGEN, CLEFT_FORMAT_STL, CLEFT_FORMAT_PLY, CLEFT_FORMAT_VTKHDF, CLEFT_FORMAT_PVTU, CLEFT_IO_UNKNOWN, &
    CLEFT_IO_VOLUME, CLEFT_IO_MESH, CLEFT_IO_WORLD_LPS, CLEFT_IO_WORLD_RAS, CLEFT_IO_KIND_AUTO, CLEFT_IO_KIND_LABELS, &
    CLEFT_IO_KIND_INDICATORS, CLEFT_IO_ORDER_FILE, CLEFT_IO_ORDER_NRRD, CLEFT_IO_ORDER_VTK, CLEFT_IO_ORDER_NIFTI, &
    CLEFT_IO_BY_LABEL, CLEFT_IO_BY_ANGLE, CLEFT_IO_BY_RATIO, CLEFT_IO_BY_SIZE, CLEFT_IO_BACKDROP_LIGHT, &
    CLEFT_IO_BACKDROP_DARK, CLEFT_IO_BACKDROP_NONE
  ! </numbers>

  ! One path, or several: a mask or an indicator function each, in the order of the materials.
  interface cleft_read_volume
    module procedure read_one, read_several
  end interface

  ! The same of files that hold voxels and no header.
  interface cleft_read_raw
    module procedure read_one_raw, read_several_raw
  end interface

  ! Names the labels by a table: a label and its name a line, or a table of ITK-SNAP, FreeSurfer, MRIcron or BIDS.
  interface cleft_read_names
    module procedure read_volume_names, read_mesh_names
  end interface

contains

  ! `world`: CLEFT_IO_WORLD_LPS (the default) or _RAS. `kind`: CLEFT_IO_KIND_... `scale` multiplies the origin and the
  ! spacing of the file together: 0.001 makes metres of millimetres. `spacing`: instead of the file's, whose origin
  ! stays.
  subroutine read_one(context, path, volume, options, world, kind, spacing, scale, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: path
    type(cleft_volume), intent(inout) :: volume
    type(cleft_options), intent(inout), optional :: options
    integer(c_int32_t), intent(in), optional :: world, kind
    real(c_double), intent(in), optional :: spacing(3), scale
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call read_several(context, [path], volume, options, world, kind, spacing, scale, stat, errmsg)
  end subroutine

  subroutine read_several(context, paths, volume, options, world, kind, spacing, scale, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: paths(:)
    type(cleft_volume), intent(inout) :: volume
    type(cleft_options), intent(inout), optional :: options
    integer(c_int32_t), intent(in), optional :: world, kind
    real(c_double), intent(in), optional :: spacing(3), scale
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), target :: chars(len(paths) + 1, size(paths))
    type(cleft_io_reading), target :: reading
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    integer :: j

    call volume%destroy()
    if (is_wrong(scale, stat, errmsg)) return
    chars = c_texts(paths)
    reading = how_to_read(world, kind, spacing, scale)
    status = cleft_io_read_volume(context%c_handle(), c_options(options), [(c_loc(chars(1, j)), j=1, size(paths))], &
      size(paths, kind=c_int64_t), c_loc(reading), made)
    call volume%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! `dims` voxels along x, y and z of a CLEFT_TYPE_..., x fastest. `spacing`: lengths of a voxel, 1 without it; the
  ! corner of the box is at the origin. `big_endian`: the most significant byte comes first. `skip`: bytes before the
  ! first voxel; what follows must be exactly the voxels. `kind`: CLEFT_IO_KIND_...
  subroutine read_one_raw(context, path, dims, type, volume, spacing, big_endian, skip, kind, options, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: path
    integer, intent(in) :: dims(3)
    integer(c_int32_t), intent(in) :: type
    type(cleft_volume), intent(inout) :: volume
    real(c_double), intent(in), optional :: spacing(3)
    logical, intent(in), optional :: big_endian
    integer, intent(in), optional :: skip
    integer(c_int32_t), intent(in), optional :: kind
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call read_several_raw(context, [path], dims, type, volume, spacing, big_endian, skip, kind, options, stat, errmsg)
  end subroutine

  subroutine read_several_raw( &
    context, paths, dims, type, volume, spacing, big_endian, skip, kind, options, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: paths(:)
    integer, intent(in) :: dims(3)
    integer(c_int32_t), intent(in) :: type
    type(cleft_volume), intent(inout) :: volume
    real(c_double), intent(in), optional :: spacing(3)
    logical, intent(in), optional :: big_endian
    integer, intent(in), optional :: skip
    integer(c_int32_t), intent(in), optional :: kind
    type(cleft_options), intent(inout), optional :: options
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), target :: chars(len(paths) + 1, size(paths))
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    integer :: j

    call volume%destroy()
    if (present(spacing)) then
      if (.not. all(spacing > 0)) then
        call conclude(CLEFT_ERROR_ARGUMENT, 'spacing must be above 0 along each axis', stat, errmsg)
        return
      end if
    end if
    chars = c_texts(paths)
    status = cleft_io_read_raw(context%c_handle(), c_options(options), [(c_loc(chars(1, j)), j=1, size(paths))], &
      size(paths, kind=c_int64_t), raw_layout(dims, type, spacing, big_endian, skip, kind), made)
    call volume%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! One number a voxel, values(i, j, k), of any file that cleft_read_volume() reads. `affine`: from indices, counted
  ! from 0, to the world.
  subroutine cleft_read_field(context, path, values, affine, world, spacing, scale, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: path
    real(c_double), allocatable, intent(out) :: values(:, :, :)
    real(c_double), intent(out), optional :: affine(3, 4)
    integer(c_int32_t), intent(in), optional :: world
    real(c_double), intent(in), optional :: spacing(3), scale
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_io_reading), target :: reading
    integer(c_int64_t), target :: dims(3)
    real(c_double), target :: rows(12)
    real(c_double), pointer :: borrowed(:, :, :)
    type(c_ptr) :: read
    integer(c_int32_t) :: status

    if (present(affine)) affine = 0
    allocate (values(0, 0, 0))
    if (is_wrong(scale, stat, errmsg)) return
    reading = how_to_read(world, spacing=spacing, scale=scale)
    status = cleft_io_read_field(context%c_handle(), c_text(path), c_loc(reading), c_loc(dims), c_loc(rows), read)
    if (status == CLEFT_OK) then
      call c_f_pointer(read, borrowed, dims)
      values = borrowed
      if (present(affine)) affine = transpose(reshape(rows, [4, 3]))
      call cleft_io_free(read)
    end if
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! What a file most likely holds: CLEFT_IO_VOLUME, CLEFT_IO_MESH or CLEFT_IO_UNKNOWN.
  function cleft_guess(path) result(content)
    character(len=*), intent(in) :: path
    integer :: content
    content = cleft_io_guess(c_text(path))
  end function

  ! In the format given (CLEFT_FORMAT_...) or in that of the path's extension.
  subroutine cleft_write_mesh(context, mesh, path, format, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    type(cleft_mesh), intent(in) :: mesh
    character(len=*), intent(in) :: path
    integer(c_int32_t), intent(in), optional :: format
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: wanted

    wanted = CLEFT_FORMAT_BY_NAME
    if (present(format)) wanted = format
    call context%conclude( &
      cleft_io_write_mesh(context%c_handle(), mesh%c_handle(), c_text(path), wanted), stat, errmsg)
  end subroutine

  subroutine cleft_read_mesh(context, path, mesh, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: path
    type(cleft_mesh), intent(inout) :: mesh
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: made
    integer(c_int32_t) :: status

    status = cleft_io_read_mesh(context%c_handle(), c_text(path), made)
    call mesh%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  subroutine read_volume_names(context, path, volume, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: path
    type(cleft_volume), intent(inout) :: volume
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call context%conclude( &
      cleft_io_read_volume_names(context%c_handle(), c_text(path), volume%c_handle()), stat, errmsg)
  end subroutine

  subroutine read_mesh_names(context, path, mesh, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: path
    type(cleft_mesh), intent(inout) :: mesh
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call context%conclude(cleft_io_read_mesh_names(context%c_handle(), c_text(path), mesh%c_handle()), stat, errmsg)
  end subroutine

  subroutine cleft_write_sizing(context, sizing, path, world, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    type(cleft_sizing), intent(in) :: sizing
    character(len=*), intent(in) :: path
    integer(c_int32_t), intent(in), optional :: world
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: wanted

    wanted = CLEFT_IO_WORLD_LPS
    if (present(world)) wanted = world
    call context%conclude( &
      cleft_io_write_sizing(context%c_handle(), sizing%c_handle(), c_text(path), wanted), stat, errmsg)
  end subroutine

  ! The file must lie on the grid of the volume, read with the same `world`, `spacing` and `scale`; `scale` multiplies
  ! the edge lengths too. With `combine`, the smaller of it and the computed field is taken.
  subroutine cleft_read_sizing(context, volume, path, sizing, combine, options, world, spacing, scale, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    type(cleft_volume), intent(in) :: volume
    character(len=*), intent(in) :: path
    type(cleft_sizing), intent(inout) :: sizing
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer(c_int32_t), intent(in), optional :: world
    real(c_double), intent(in), optional :: spacing(3), scale
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_io_reading), target :: reading
    type(c_ptr) :: made
    integer(c_int32_t) :: status, c_combine

    call sizing%destroy()
    if (is_wrong(scale, stat, errmsg)) return
    reading = how_to_read(world, spacing=spacing, scale=scale)
    c_combine = 0
    if (present(combine)) c_combine = merge(1_c_int32_t, 0_c_int32_t, combine)
    status = cleft_io_read_sizing(context%c_handle(), volume%c_handle(), c_text(path), c_loc(reading), c_combine, &
      c_options(options), made)
    call sizing%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! A metric of your own. `order` says how the six numbers of a tensor follow each other: CLEFT_IO_ORDER_... Without a
  ! volume the field has the voxels of the file; else as cleft_read_sizing().
  subroutine cleft_read_metric( &
    context, path, sizing, volume, order, combine, options, world, spacing, scale, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    character(len=*), intent(in) :: path
    type(cleft_sizing), intent(inout) :: sizing
    type(cleft_volume), intent(in), optional :: volume
    integer(c_int32_t), intent(in), optional :: order
    logical, intent(in), optional :: combine
    type(cleft_options), intent(inout), optional :: options
    integer(c_int32_t), intent(in), optional :: world
    real(c_double), intent(in), optional :: spacing(3), scale
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_io_reading), target :: reading
    type(c_ptr) :: volume_at, made
    integer(c_int32_t) :: status, c_combine, c_order

    call sizing%destroy()
    volume_at = c_null_ptr
    if (present(volume)) volume_at = volume%c_handle()
    if (present(volume) .and. .not. c_associated(volume_at)) then
      call conclude(CLEFT_ERROR_NULL, 'volume is not there: destroyed, or never made', stat, errmsg)
      return
    end if
    if (is_wrong(scale, stat, errmsg)) return
    reading = how_to_read(world, spacing=spacing, scale=scale)
    c_order = CLEFT_IO_ORDER_FILE
    if (present(order)) c_order = order
    c_combine = 0
    if (present(combine)) c_combine = merge(1_c_int32_t, 0_c_int32_t, combine)
    status = cleft_io_read_metric(context%c_handle(), volume_at, c_text(path), c_loc(reading), c_order, c_combine, &
      c_options(options), made)
    call sizing%adopt(made)
    call context%conclude(status, stat, errmsg)
  end subroutine

  ! Draws a mesh as PNG, without a screen. `by`: CLEFT_IO_BY_... `cut`: shares of the box along x, y and z, 0 for no
  ! cut. `strip`: labels that are not drawn. `whole`: labels that are not cut. `size`: width and height in pixels. What
  ! is not given is as cleft_io.h says.
  subroutine cleft_write_picture(context, mesh, path, by, size, backdrop, edges, legend, cut, strip, whole, view, up, &
    zoom, line_width, range, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    type(cleft_mesh), intent(in) :: mesh
    character(len=*), intent(in) :: path
    integer(c_int32_t), intent(in), optional :: by, backdrop
    integer, intent(in), optional :: size(2)
    logical, intent(in), optional :: edges, legend
    integer(c_int32_t), intent(in), optional :: strip(:), whole(:)
    real(c_double), intent(in), optional :: cut(3), view(3), up(3), zoom, line_width, range(2)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_io_picture), target :: picture
    integer(c_int32_t), allocatable, target :: stripped(:), uncut(:)

    picture = default_picture()
    if (present(by)) picture%by = by
    if (present(size)) picture%width = size(1)
    if (present(size)) picture%height = size(2)
    if (present(backdrop)) picture%backdrop = backdrop
    if (present(edges)) picture%no_edges = merge(0_c_int32_t, 1_c_int32_t, edges)
    if (present(legend)) picture%legend = merge(1_c_int32_t, 0_c_int32_t, legend)
    if (present(cut)) picture%cut = cut
    if (present(view)) picture%view = view
    if (present(up)) picture%up = up
    if (present(zoom)) picture%zoom = zoom
    if (present(line_width)) picture%line_width = line_width
    if (present(range)) picture%range = range
    allocate (stripped(0), uncut(0))
    if (present(strip)) stripped = strip
    if (present(whole)) uncut = whole
    call context%conclude(cleft_io_write_picture(context%c_handle(), mesh%c_handle(), c_loc(stripped), &
      int(ubound(stripped, 1), c_int64_t), c_loc(uncut), int(ubound(uncut, 1), c_int64_t), c_loc(picture), &
      c_text(path)), stat, errmsg)
  end subroutine

  pure function default_picture() result(picture)
    type(cleft_io_picture) :: picture

    picture%struct_size = int(c_sizeof(picture), c_int32_t)
    picture%by = CLEFT_IO_BY_LABEL
    picture%width = 0
    picture%height = 0
    picture%backdrop = CLEFT_IO_BACKDROP_LIGHT
    picture%no_edges = 0
    picture%legend = 0
    picture%reserved = 0
    picture%cut = 0
    picture%view = 0
    picture%up = 0
    picture%zoom = 0
    picture%line_width = 0
    picture%range = 0
  end function

  ! Writes a page that shows a mesh in any browser. `report`: what cleft mesh --json reported, as text. `names`: the
  ! path of a table of the names of labels. `goal`: the least dihedral angle that is marked. `max_tets`: how many
  ! tetrahedra the page has at most. `other`: a second mesh to compare with. What is not given is as cleft_io.h says.
  subroutine cleft_write_view(context, mesh, path, title, report, names, goal, max_tets, other, other_title, &
    other_report, stat, errmsg)
    type(cleft_context), intent(inout) :: context
    type(cleft_mesh), intent(in) :: mesh
    character(len=*), intent(in) :: path
    character(len=*), intent(in), optional :: title, report, names, other_title, other_report
    real(c_double), intent(in), optional :: goal
    integer(c_int64_t), intent(in), optional :: max_tets
    type(cleft_mesh), intent(in), optional :: other
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(cleft_io_view), target :: view
    character(kind=c_char, len=:), allocatable, target :: c_title, c_report, c_names, second_title, second_report

    view%struct_size = int(c_sizeof(view), c_int32_t)
    view%reserved = 0
    view%goal = 0
    view%max_tets = 0
    view%other = c_null_ptr
    if (present(goal)) view%goal = goal
    if (present(max_tets)) view%max_tets = max_tets
    if (present(other)) view%other = other%c_handle()
    c_title = c_text(or_empty(title))
    c_report = c_text(or_empty(report))
    c_names = c_text(or_empty(names))
    second_title = c_text(or_empty(other_title))
    second_report = c_text(or_empty(other_report))
    view%title = c_loc(c_title)
    view%report = c_loc(c_report)
    view%names = c_null_ptr
    if (present(names)) view%names = c_loc(c_names)
    view%other_title = c_loc(second_title)
    view%other_report = c_loc(second_report)
    call context%conclude(cleft_io_write_view(context%c_handle(), mesh%c_handle(), c_loc(view), c_text(path)), stat, &
      errmsg)
  end subroutine

  pure function or_empty(text) result(given)
    character(len=*), intent(in), optional :: text
    character(len=:), allocatable :: given

    given = ''
    if (present(text)) given = text
  end function

  ! Paths as C wants them, one a column.
  pure function c_texts(paths) result(chars)
    character(len=*), intent(in) :: paths(:)
    character(kind=c_char) :: chars(len(paths) + 1, size(paths))
    integer :: i, j

    chars = c_null_char
    do j = 1, size(paths)
      do i = 1, len_trim(paths(j))
        chars(i, j) = paths(j)(i:i)
      end do
    end do
  end function

  function is_wrong(scale, stat, errmsg) result(answer)
    real(c_double), intent(in), optional :: scale
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    logical :: answer
    answer = .false.
    if (present(scale)) answer = .not. scale > 0
    if (answer) call conclude(CLEFT_ERROR_ARGUMENT, 'scale must be above 0', stat, errmsg)
  end function

  pure function how_to_read(world, kind, spacing, scale) result(reading)
    integer(c_int32_t), intent(in), optional :: world, kind
    real(c_double), intent(in), optional :: spacing(3), scale
    type(cleft_io_reading) :: reading

    reading%struct_size = int(c_sizeof(reading), c_int32_t)
    reading%world = CLEFT_IO_WORLD_LPS
    reading%kind = CLEFT_IO_KIND_AUTO
    reading%reserved = 0
    reading%spacing = 0
    reading%scale = 0
    if (present(world)) reading%world = world
    if (present(kind)) reading%kind = kind
    if (present(spacing)) reading%spacing = spacing
    if (present(scale)) reading%scale = scale
  end function

  pure function raw_layout(dims, type, spacing, big_endian, skip, kind) result(raw)
    integer, intent(in) :: dims(3)
    integer(c_int32_t), intent(in) :: type
    real(c_double), intent(in), optional :: spacing(3)
    logical, intent(in), optional :: big_endian
    integer, intent(in), optional :: skip
    integer(c_int32_t), intent(in), optional :: kind
    type(cleft_io_raw) :: raw

    raw%struct_size = int(c_sizeof(raw), c_int32_t)
    raw%type = type
    raw%big_endian = 0
    raw%kind = CLEFT_IO_KIND_AUTO
    raw%skip = 0
    raw%dims = dims
    raw%spacing = 1
    if (present(big_endian)) raw%big_endian = merge(1_c_int32_t, 0_c_int32_t, big_endian)
    if (present(kind)) raw%kind = kind
    if (present(skip)) raw%skip = skip
    if (present(spacing)) raw%spacing = spacing
  end function

end module
