! The output of digits.c, by the Fortran modules.
program digits
  use, intrinsic :: iso_c_binding, only: c_int64_t
  use hardsphere_workspace
  implicit none
  integer, parameter :: most = 1000
  real(c_double) :: xyz(3, most), radius(most), area(most), volume(most), gradient(3, most)
  type(hsp_totals) :: totals
  type(hsp_workspace), target :: work
  integer(c_int32_t) :: n, status
  integer :: unit, ending
  character(1000) :: name

  call get_command_argument(1, name)
  open (newunit=unit, file=trim(name), status="old", action="read")
  n = 0
  do while (n < most)
    read (unit, *, iostat=ending) xyz(:, n + 1), radius(n + 1)
    if (ending /= 0) exit
    n = n + 1
  end do
  close (unit)

  status = work%set(n, xyz, radius)
  if (status == HSP_OK) status = work%compute_boundary()
  if (status == HSP_OK) status = hsp_boundary_measure(work%boundary, totals=totals, area=area, volume_term=volume, capacity=n)
  if (status == HSP_OK) status = hsp_boundary_get_gradient(work%boundary, tension=1.0_c_double, &
    pressure=1.0_c_double, d_centre=gradient, capacity=n)
  if (status /= HSP_OK) error stop
  call print_bits([totals%area, totals%volume])
  call print_bits(area(:n))
  call print_bits(volume(:n))
  call print_bits(reshape(gradient(:, :n), [3*n]))

contains

  subroutine print_bits(numbers)
    real(c_double), intent(in) :: numbers(:)
    print "(z16.16)", transfer(numbers, [0_c_int64_t])
  end subroutine

end program
