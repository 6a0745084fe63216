! capi/clients/exact_sasa.f90: areas in closed form, derivatives against difference quotients, their contraction against
! the matrix, and a step of other atoms in the same memory.
program exact_sasa_test
  use hardsphere_workspace
  use exact_sasa
  implicit none
  integer, parameter :: n = 120
  real(c_double), parameter :: pi = acos(-1.0_c_double), h = 1e-5_c_double
  type(hsp_workspace), target :: work
  real(c_double) :: xyz(3, n), r(n), area(n), forward(n), backward(n), d(3, n, n), gradient(3, n), tension(n)
  integer(c_int32_t) :: status
  integer :: i, k

  call compute_exact_sasa(work, 2, reshape([0, 0, 0, 1, 0, 0]*1.0_c_double, [3, 2]), [1, 1]*1.0_c_double, area(:2), &
                          status, d(:, :2, :2))
  call check(status == HSP_OK .and. all(abs(area(:2) - 3*pi) < 1e-12), 'areas of two balls')
  call check(abs(d(1, 2, 1) - pi) < 1e-7 .and. abs(d(1, 1, 1) + pi) < 1e-7, 'derivatives of two balls')

  do i = 1, n ! a winding chain
    xyz(:, i) = [7*cos(0.7d0*i), 7*sin(0.7d0*i), 0.55d0*i + sin(3.1d0*i)]
    r(i) = merge(5.7d0, 4.9d0, mod(i, 3) /= 0)
    tension(i) = 0.01d0*mod(i, 7)
  end do
  call compute_exact_sasa(work, n, xyz, r, area, status, d)
  call check(status == HSP_OK .and. maxval(area) > 10, 'areas of a chain')
  gradient = 1
  call add_exact_gradients(work, n, tension, gradient, status)
  call check(status == HSP_OK, 'add_exact_gradients')
  do i = 1, n
    do k = 1, 3
      call check(abs(gradient(k, i) - 1 - sum(tension*d(k, i, :))) < 1e-12, 'the gradient is the contraction')
    end do
  end do
  do i = 1, n, 13
    do k = 1, 3
      xyz(k, i) = xyz(k, i) + h
      call compute_exact_sasa(work, n, xyz, r, forward, status)
      xyz(k, i) = xyz(k, i) - 2*h
      call compute_exact_sasa(work, n, xyz, r, backward, status)
      xyz(k, i) = xyz(k, i) + h
      call check(maxval(abs((forward - backward)/(2*h) - d(k, i, :))) < 1e-5, 'quotients')
    end do
  end do
  xyz(1, 1) = ieee_nan()
  call compute_exact_sasa(work, n, xyz, r, area, status)
  call check(status == HSP_E_NOT_FINITE, 'a status')
  call add_exact_gradients(work, n, tension, gradient, status)
  call check(status /= HSP_OK, 'no gradient without areas')

contains

  function ieee_nan() result(nan)
    use, intrinsic :: ieee_arithmetic
    real(c_double) :: nan
    nan = ieee_value(1.0_c_double, ieee_quiet_nan)
  end function

  subroutine check(holds, what)
    logical, intent(in) :: holds
    character(*), intent(in) :: what
    if (holds) return
    print '(2a)', 'not so: ', what
    stop 1
  end subroutine
end program
