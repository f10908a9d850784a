! Linear elasticity on a segmented volume: how stiff is the tissue as a whole?
!
!   elasticity VOLUME.nrrd
!
! All labels but 0 are five times stiffer than label 0. The box is pressed together by 1 % along z between smooth
! plates; the other sides slide along smooth walls. Linear elements, conjugate gradients. Two things are known, and the
! program fails if they do not come out: of one material alone, the strain is even and the stiffness that of the
! material (the patch test); of two, it lies between the harmonic and the arithmetic mean, weighted by the volumes in
! the mesh (Reuss and Voigt).
module solid
  use, intrinsic :: iso_fortran_env, only: int32, real64
  implicit none
  private
  public :: real64, int32, elements, set_up, solve, energy, stiffness

  real(real64), parameter :: poisson = 0.3_real64

  type :: elements
    integer(int32), allocatable :: corners(:, :)
    real(real64), allocatable :: volume(:)
    real(real64), allocatable :: gradients(:, :, :)  ! of the shape functions: axis, corner, element
    real(real64), allocatable :: young(:)
  end type

contains

  function set_up(points, tets) result(mesh)
    real(real64), intent(in) :: points(:, :)
    integer(int32), intent(in) :: tets(:, :)
    type(elements) :: mesh
    real(real64) :: edges(3, 3), six_volumes
    integer :: t, c

    mesh%corners = tets
    allocate (mesh%volume(size(tets, 2)), mesh%young(size(tets, 2)), mesh%gradients(3, 4, size(tets, 2)))
    mesh%young = 1
    do t = 1, size(tets, 2)
      do c = 1, 3
        edges(:, c) = points(:, tets(c + 1, t)) - points(:, tets(1, t))
      end do
      six_volumes = dot_product(edges(:, 1), cross(edges(:, 2), edges(:, 3)))
      mesh%volume(t) = six_volumes / 6
      mesh%gradients(:, 2, t) = cross(edges(:, 2), edges(:, 3)) / six_volumes
      mesh%gradients(:, 3, t) = cross(edges(:, 3), edges(:, 1)) / six_volumes
      mesh%gradients(:, 4, t) = cross(edges(:, 1), edges(:, 2)) / six_volumes
      mesh%gradients(:, 1, t) = -sum(mesh%gradients(:, 2:4, t), dim=2)
    end do
  end function

  pure function cross(a, b) result(c)
    real(real64), intent(in) :: a(3), b(3)
    real(real64) :: c(3)
    c = [a(2) * b(3) - a(3) * b(2), a(3) * b(1) - a(1) * b(3), a(1) * b(2) - a(2) * b(1)]
  end function

  ! Stress over strain when the sides cannot give way.
  pure elemental function stiffness(young) result(modulus)
    real(real64), intent(in) :: young
    real(real64) :: modulus
    modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))
  end function

  pure function stress(young, slope) result(sigma)
    real(real64), intent(in) :: young, slope(3, 3)
    real(real64) :: sigma(3, 3), lame, shear, pressure
    integer :: d
    lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    shear = young / (2 * (1 + poisson))
    pressure = lame * (slope(1, 1) + slope(2, 2) + slope(3, 3))
    sigma = shear * (slope + transpose(slope))
    do d = 1, 3
      sigma(d, d) = sigma(d, d) + pressure
    end do
  end function

  ! The forces that hold the displacements u.
  function forces(mesh, u) result(f)
    type(elements), intent(in) :: mesh
    real(real64), intent(in) :: u(:, :)
    real(real64), allocatable :: f(:, :)
    real(real64) :: slope(3, 3), sigma(3, 3)
    integer :: t, c

    allocate (f(3, size(u, 2)), source=0._real64)
    do t = 1, size(mesh%volume)
      slope = matmul(u(:, mesh%corners(:, t)), transpose(mesh%gradients(:, :, t)))
      sigma = mesh%volume(t) * stress(mesh%young(t), slope)
      do c = 1, 4
        f(:, mesh%corners(c, t)) = f(:, mesh%corners(c, t)) + matmul(sigma, mesh%gradients(:, c, t))
      end do
    end do
  end function

  function energy(mesh, u) result(work)
    type(elements), intent(in) :: mesh
    real(real64), intent(in) :: u(:, :)
    real(real64) :: work
    work = sum(u * forces(mesh, u)) / 2
  end function

  function diagonal(mesh, points) result(d)
    type(elements), intent(in) :: mesh
    integer, intent(in) :: points
    real(real64), allocatable :: d(:, :)
    real(real64) :: g(3)
    integer :: t, c

    allocate (d(3, points), source=0._real64)
    do t = 1, size(mesh%volume)
      do c = 1, 4
        g = mesh%gradients(:, c, t)
        d(:, mesh%corners(c, t)) = d(:, mesh%corners(c, t)) + mesh%young(t) * mesh%volume(t) &
          * (g**2 / (1 - 2 * poisson) + dot_product(g, g)) / (2 * (1 + poisson))
      end do
    end do
  end function

  ! Conjugate gradients with the diagonal as preconditioner. Where `held`, u keeps its value.
  subroutine solve(mesh, held, u, steps)
    type(elements), intent(in) :: mesh
    logical, intent(in) :: held(:, :)
    real(real64), intent(inout) :: u(:, :)
    integer, intent(out) :: steps
    real(real64), allocatable :: residual(:, :), direction(:, :), scaled(:, :), answer(:, :), d(:, :)
    real(real64) :: norm, former, enough, length

    d = diagonal(mesh, size(u, 2))
    residual = merge(0._real64, -forces(mesh, u), held)
    direction = residual / d
    norm = sum(residual * direction)
    enough = 1e-13_real64 * norm
    do steps = 0, 2000
      if (norm <= enough) exit
      answer = merge(0._real64, forces(mesh, direction), held)
      length = norm / sum(direction * answer)
      u = u + length * direction
      residual = residual - length * answer
      scaled = residual / d
      former = norm
      norm = sum(residual * scaled)
      direction = scaled + norm / former * direction
    end do
  end subroutine

end module

program elasticity
  use cleft
  use cleft_io
  use solid
  implicit none

  real(real64), parameter :: strain = -0.01_real64, stiffer = 5
  type(cleft_context) :: context
  type(cleft_options) :: options
  type(cleft_volume) :: volume
  type(cleft_mesh) :: mesh
  type(elements) :: parts
  real(real64), allocatable :: points(:, :)
  integer(int32), allocatable :: labels(:)
  real(real64) :: one, two, whole, voigt, reuss
  character(len=1000) :: path

  call get_command_argument(1, path)
  call cleft_read_volume(context, path, volume)
  call options%set('feature_scale', 2)
  call options%set('gradation', 0.5)
  call options%set('size_min', 2.5)
  call mesh%create(context, volume, options)
  points = mesh%points()
  labels = mesh%tet_labels()
  print '(i0, a, i0, a, i0, a)', size(mesh%labels()), ' labels, ', size(points, 2), ' points, ', &
    size(labels), ' tetrahedra'

  parts = set_up(points, mesh%tets())
  whole = sum(parts%volume)
  one = stiffness_of_whole()
  print '(a, es16.8, a, es16.8)', 'one material:  ', one, ', exactly ', stiffness(1._real64)

  parts%young = merge(1._real64, stiffer, labels == 0)
  two = stiffness_of_whole()
  voigt = sum(parts%volume * stiffness(parts%young)) / whole
  reuss = whole / sum(parts%volume / stiffness(parts%young))
  print '(a, es16.8, a, es16.8, a, es16.8)', 'two materials: ', two, ', between ', reuss, ' and ', voigt

  if (abs(one / stiffness(1._real64) - 1) > 1e-6_real64) error stop 'the patch test fails'
  if (two <= reuss .or. two >= voigt) error stop 'the stiffness is out of its bounds'

contains

  ! From the energy of the strain that the plates force on it.
  function stiffness_of_whole() result(modulus)
    real(real64) :: modulus, low(3), high(3), near
    real(real64), allocatable :: u(:, :)
    logical, allocatable :: held(:, :)
    integer :: axis, steps

    low = minval(points, dim=2)
    high = maxval(points, dim=2)
    near = 1e-9_real64 * maxval(high - low)
    allocate (held(3, size(points, 2)), u(3, size(points, 2)))
    do axis = 1, 3
      held(axis, :) = points(axis, :) < low(axis) + near .or. points(axis, :) > high(axis) - near
    end do
    u = 0
    where (points(3, :) > high(3) - near) u(3, :) = strain * (high(3) - low(3))
    call solve(parts, held, u, steps)
    modulus = 2 * energy(parts, u) / (strain**2 * whole)
    print '(i0, a)', steps, ' steps'
  end function

end program
