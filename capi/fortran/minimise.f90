! A small chain of balls in a solvent that it avoids, from Fortran: steepest descent on
!   E = stiffness/2 sum over springs (|c_i - c_j| - length)^2 + tension A + pressure V
! where A and V are area and volume of the union of the balls, solvent-accessible, whose gradient is one call of
! hsp_boundary_get_gradient. Springs join neighbours and next neighbours, which keeps bonds and bond angles: what is
! left is to turn about the bonds, and the surface makes the chain fold. Nothing but the springs keeps balls from moving
! into each other, and where equal balls coincide the area has no derivative: the tension must not be much larger.
! One line for each step: number, energy, the largest derivative, the step's length.
program minimise
  use, intrinsic :: iso_fortran_env, only: error_unit
  use hardsphere_workspace
  implicit none

  integer(c_int32_t), parameter :: n = 5
  real(c_double), parameter :: bond = 1.53_c_double         ! angstrom
  real(c_double), parameter :: next_bond = 2.50_c_double    ! between next neighbours: an angle of 109.6 degrees
  real(c_double), parameter :: stiffness = 20.0_c_double
  real(c_double), parameter :: tension = 0.30_c_double
  real(c_double), parameter :: pressure = 0.05_c_double
  real(c_double), parameter :: radius(n) = 1.70_c_double, probe = 1.40_c_double
  real(c_double), parameter :: lattice_step = 1e-8_c_double
  real(c_double), parameter :: good_enough = 1e-5_c_double
  integer, parameter :: most_steps = 2000

  type(hsp_workspace), target :: work
  type(hsp_model_options) :: options
  real(c_double) :: xyz(3, n), force(3, n), energy, trial(3, n), trial_force(3, n), trial_energy, length, promised
  integer :: step

  call must(hsp_model_options_init(options, options%struct_size))
  options%probe = probe
  options%step = lattice_step
  xyz = on_lattice(zigzag())
  call evaluate(xyz, energy, force)
  length = 1e-2_c_double
  print '(a)', 'step             energy   derivative       length'
  print '(i4, f19.12, 2es13.3)', 0, energy, maxval(abs(force)), 0.0_c_double
  do step = 1, most_steps
    if (maxval(abs(force)) < good_enough) exit
    length = 2*length
    do
      trial = on_lattice(xyz + length*force)
      call evaluate(trial, trial_energy, trial_force)
      ! Armijo's rule: a quarter of what the slope promises is enough.
      promised = sum(force*(trial - xyz))
      if (promised > 0 .and. trial_energy <= energy - promised/4) exit
      length = length/2
      if (length < 1e-12_c_double) then
        write (error_unit, '(a)') 'minimise: no step downhill'
        stop 1
      end if
    end do
    xyz = trial
    force = trial_force
    energy = trial_energy
    print '(i4, f19.12, 2es13.3)', step, energy, maxval(abs(force)), length
  end do

contains

  ! Stretched out, with a little of a helix: in a plane no ball would feel where to turn.
  function zigzag() result(places)
    real(c_double) :: places(3, n)
    integer :: i
    do i = 1, n
      places(1, i) = 1.25_c_double*i
      places(2, i) = merge(0.44_c_double, -0.44_c_double, mod(i, 2) == 0)
      places(3, i) = 0.05_c_double*(i - 3)**2
    end do
  end function

  ! The library rounds coordinates to multiples of lattice_step. If they are that already, surface and springs see the
  ! same places, and energies can be compared to the last digits.
  function on_lattice(places) result(rounded)
    real(c_double), intent(in) :: places(3, n)
    real(c_double) :: rounded(3, n)
    rounded = anint(places/lattice_step)*lattice_step
  end function

  subroutine evaluate(places, value, downhill)
    real(c_double), intent(in) :: places(3, n)
    real(c_double), intent(out) :: value, downhill(3, n)
    type(hsp_energy) :: surface
    real(c_double) :: gradient(3, n)
    integer :: i
    call must(work%set(n, places, radius, options))
    call must(work%compute_boundary())
    call must(hsp_boundary_get_gradient(work%boundary, tension=tension, pressure=pressure, energy=surface, &
                                        d_centre=gradient, capacity=n))
    value = surface%value
    do i = 1, n - 1
      call add_spring(places, i, i + 1, bond, value, gradient)
      if (i + 2 <= n) call add_spring(places, i, i + 2, next_bond, value, gradient)
    end do
    downhill = -gradient
  end subroutine

  subroutine add_spring(places, i, j, rest, value, gradient)
    real(c_double), intent(in) :: places(3, n), rest
    integer, intent(in) :: i, j
    real(c_double), intent(inout) :: value, gradient(3, n)
    real(c_double) :: along(3), distance
    along = places(:, j) - places(:, i)
    distance = norm2(along)
    value = value + stiffness/2*(distance - rest)**2
    gradient(:, j) = gradient(:, j) + stiffness*(distance - rest)*along/distance
    gradient(:, i) = gradient(:, i) - stiffness*(distance - rest)*along/distance
  end subroutine

  subroutine must(status)
    integer(c_int32_t), intent(in) :: status
    if (status == HSP_OK) return
    write (error_unit, '(a)') 'minimise: '//hsp_status_message(status)
    stop 1
  end subroutine
end program minimise
