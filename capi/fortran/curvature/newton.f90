! Newton's method with a surface energy that is smooth where balls touch, from Fortran: four dimers on a square, bonds and
! attraction between all others, and a tension of -0.1 of their surface, so that they want to show it and to touch at
! once. In place of the area A it takes its mean over a window w of radii, from two volumes (guide: smooth_energies.md),
!   W = (V(r + w) - V(r - w)) / 2w
! with its first and second derivatives, and undoes the rounding of the lattice to second order. One line for each step:
! number, energy, the largest derivative.
program newton
  use, intrinsic :: iso_fortran_env, only: error_unit
  use hardsphere_workspace
  implicit none

  integer(c_int32_t), parameter :: n = 8
  real(c_double), parameter :: tension = -0.1_c_double, window = 0.05_c_double, radius(n) = 1.7_c_double
  real(c_double), parameter :: spring = 600, bond = 1.54_c_double                ! within a dimer
  real(c_double), parameter :: depth = 0.1_c_double, rest = 3.2_c_double         ! between dimers: Lennard-Jones
  real(c_double), parameter :: good_enough = 1e-12_c_double
  integer, parameter :: most_steps = 60

  type(hsp_workspace), target :: work(2)
  type(hsp_model_options) :: options
  real(c_double) :: xyz(3, n), gradient(3, n), matrix(3*n, 3*n), energy
  real(c_double) :: trial(3, n), trial_gradient(3, n), trial_matrix(3*n, 3*n), trial_energy, move(3, n), length
  integer :: step

  call must(hsp_model_options_init(options, options%struct_size))
  options%step = 1e-8_c_double
  options%largest_radius = 2
  call place(xyz)
  call evaluate(xyz, energy, gradient, matrix)
  do step = 0, most_steps
    print '(i4, f19.10, es13.3)', step, energy, maxval(abs(gradient))
    if (maxval(abs(gradient)) < good_enough) exit
    move = downhill(matrix, gradient)
    length = 1
    do
      trial = xyz + length*move
      call evaluate(trial, trial_energy, trial_gradient, trial_matrix)
      ! Near the minimum the energy's last digits say nothing any more, and the gradient decides.
      if (trial_energy < energy) exit
      if (trial_energy < energy + 1e-9_c_double .and. maxval(abs(trial_gradient)) < maxval(abs(gradient))) exit
      length = length/2
      if (length < 1e-9_c_double) stop 'newton: no step downhill'
    end do
    xyz = trial
    energy = trial_energy
    gradient = trial_gradient
    matrix = trial_matrix
  end do

contains

  ! Upright dimers, each ball a little away from where it would be.
  subroutine place(places)
    real(c_double), intent(out) :: places(3, n)
    integer :: i, k
    do i = 1, n
      places(:, i) = [3.7_c_double*mod((i - 1)/2, 2), 3.7_c_double*((i - 1)/4), bond*mod(i - 1, 2)]
      do k = 1, 3
        places(k, i) = places(k, i) + 0.3_c_double*sin(real(7*i*i + 3*k, c_double))
      end do
    end do
  end subroutine

  subroutine evaluate(places, value, slope, bend)
    real(c_double), intent(in) :: places(3, n)
    real(c_double), intent(out) :: value, slope(3, n), bend(3*n, 3*n)
    real(c_double) :: side
    integer :: i, j, which
    value = 0
    slope = 0
    bend = 0
    do which = 1, 2
      side = merge(window, -window, which == 1)
      call add_volume(work(which), places, radius + side, tension/(2*side), value, slope, bend)
    end do
    do i = 1, n
      do j = i + 1, n
        call add_pair(places, i, j, value, slope, bend)
      end do
    end do
  end subroutine

  ! Adds factor * volume, at the given places: with the derivatives at those of the lattice and how far these are off.
  subroutine add_volume(set, places, radii, factor, value, slope, bend)
    type(hsp_workspace), target, intent(inout) :: set
    real(c_double), intent(in) :: places(3, n), radii(n), factor
    real(c_double), intent(inout) :: value, slope(3, n), bend(3*n, 3*n)
    type(hsp_gradient_request) :: request
    type(hsp_energy) :: volume
    real(c_double) :: rounded(3, n), off(3, n), by_centre(3, n), product(3, n)
    integer(c_int32_t) :: first(n + 1), entries, i, j, k
    integer(c_int32_t), allocatable :: ball(:)
    real(c_double), allocatable :: block(:, :, :)
    request%pressure = factor
    call must(set%set(n, places, radii, options))
    call must(set%compute_boundary())
    call must(hsp_model_get_balls(set%model, rounded, capacity=n))
    off = places - rounded
    call must(hsp_boundary_get_gradient(set%boundary, pressure=factor, energy=volume, d_centre=by_centre, capacity=n))
    call must(hsp_boundary_get_hessian_product(set%boundary, request, off, product, capacity=n))
    value = value + volume%value + sum(off*(by_centre + product/2))
    slope = slope + by_centre + product

    ! With room for none the number of blocks comes back.
    i = hsp_boundary_get_hessian_rows(set%boundary, request, first, capacity=0, needed=entries)
    allocate (ball(entries), block(3, 3, entries))
    call must(hsp_boundary_get_hessian_rows(set%boundary, request, first, ball, block, capacity=entries))
    do i = 1, n
      do k = first(i) + 1, first(i + 1)
        j = ball(k) + 1
        ! Fortran has the last index of C first.
        bend(3*i - 2:3*i, 3*j - 2:3*j) = bend(3*i - 2:3*i, 3*j - 2:3*j) + transpose(block(:, :, k))
      end do
    end do
  end subroutine

  subroutine add_pair(places, i, j, value, slope, bend)
    real(c_double), intent(in) :: places(3, n)
    integer, intent(in) :: i, j
    real(c_double), intent(inout) :: value, slope(3, n), bend(3*n, 3*n)
    real(c_double) :: u(3), distance, s, first, second, part(3, 3)
    integer :: k, l
    u = places(:, j) - places(:, i)
    distance = norm2(u)
    u = u/distance
    if ((i - 1)/2 == (j - 1)/2) then
      value = value + spring/2*(distance - bond)**2
      first = spring*(distance - bond)
      second = spring
    else
      s = (rest/distance)**6
      value = value + depth*(s*s - 2*s)
      first = 12*depth/distance*(s - s*s)
      second = depth/distance**2*(156*s*s - 84*s)
    end if
    slope(:, j) = slope(:, j) + first*u
    slope(:, i) = slope(:, i) - first*u
    do k = 1, 3
      do l = 1, 3
        part(k, l) = second*u(k)*u(l) + first/distance*(merge(1, 0, k == l) - u(k)*u(l))
      end do
    end do
    associate (a => 3*i - 2, b => 3*j - 2)
      bend(a:a + 2, a:a + 2) = bend(a:a + 2, a:a + 2) + part
      bend(b:b + 2, b:b + 2) = bend(b:b + 2, b:b + 2) + part
      bend(a:a + 2, b:b + 2) = bend(a:a + 2, b:b + 2) - part
      bend(b:b + 2, a:a + 2) = bend(b:b + 2, a:a + 2) - part
    end associate
  end subroutine

  ! Against the gradient along each eigenvector, by the size of its eigenvalue: downhill also where that is negative.
  ! Motions of the whole are left out; no coordinate moves by more than 0.2.
  function downhill(bend, slope) result(move)
    real(c_double), intent(in) :: bend(3*n, 3*n), slope(3, n)
    real(c_double) :: move(3, n), a(3*n, 3*n), v(3*n, 3*n), along, steps(3*n)
    integer :: i
    a = bend
    call diagonalise(a, v)
    steps = 0
    do i = 1, 3*n
      if (abs(a(i, i)) < 1e-6_c_double) cycle
      along = dot_product(v(:, i), reshape(slope, [3*n]))
      steps = steps - along/max(abs(a(i, i)), 1e-3_c_double)*v(:, i)
    end do
    if (maxval(abs(steps)) > 0.2_c_double) steps = steps*(0.2_c_double/maxval(abs(steps)))
    move = reshape(steps, [3, int(n)])
  end function

  ! Jacobi 1846: a symmetric matrix becomes diagonal, and v its vectors, in columns.
  subroutine diagonalise(a, v)
    real(c_double), intent(inout) :: a(3*n, 3*n)
    real(c_double), intent(out) :: v(3*n, 3*n)
    real(c_double) :: theta, t, c, s, off, column(3*n)
    integer :: p, q, sweep
    v = 0
    do p = 1, 3*n
      v(p, p) = 1
    end do
    do sweep = 1, 30
      off = 0
      do p = 1, 3*n
        do q = p + 1, 3*n
          off = off + a(p, q)**2
          if (abs(a(p, q)) < 1e-150_c_double) cycle
          theta = (a(q, q) - a(p, p))/(2*a(p, q))
          t = sign(1/(abs(theta) + sqrt(theta**2 + 1)), theta)
          c = 1/sqrt(t**2 + 1)
          s = t*c
          column = a(:, p)
          a(:, p) = c*column - s*a(:, q)
          a(:, q) = s*column + c*a(:, q)
          column = a(p, :)
          a(p, :) = c*column - s*a(q, :)
          a(q, :) = s*column + c*a(q, :)
          column = v(:, p)
          v(:, p) = c*column - s*v(:, q)
          v(:, q) = s*column + c*v(:, q)
        end do
      end do
      if (off < 1e-26_c_double) return
    end do
  end subroutine

  subroutine must(status)
    integer(c_int32_t), intent(in) :: status
    if (status == HSP_OK) return
    write (error_unit, '(a)') 'newton: '//hsp_status_message(status)
    stop 1
  end subroutine
end program newton
