! A water molecule from Fortran: its surface areas, bare and solvent-accessible.
! This is the whole life of a model and of a boundary: ask for the size, give memory, compute, read.
program water
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_ptr, c_size_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use hardsphere
  implicit none

  integer(c_int32_t), parameter :: n = 3
  character(len=1), parameter :: element(n) = ['O', 'H', 'H']
  ! Angstrom; an O-H bond of 0.9572 and an angle of 104.52 degrees.
  real(c_double), parameter :: xyz(3, n) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    0.9572_c_double, 0.0_c_double, 0.0_c_double, &
                                                    -0.23998721_c_double, 0.92662721_c_double, 0.0_c_double], [3, 3])
  real(c_double), parameter :: radius(n) = [1.52_c_double, 1.10_c_double, 1.10_c_double]
  real(c_double), parameter :: probes(2) = [0.0_c_double, 1.4_c_double]

  integer(c_int8_t), allocatable, target :: model_memory(:), boundary_memory(:)
  integer(c_size_t) :: bytes
  type(c_ptr) :: model, boundary
  type(hsp_model_options) :: options
  type(hsp_boundary_limits) :: limits
  type(hsp_boundary_counts) :: counts
  type(hsp_totals) :: totals
  real(c_double) :: area(n)
  integer :: i, p

  call must(hsp_model_bytes(n, bytes))
  allocate (model_memory(bytes))
  call must(hsp_model_init(c_loc(model_memory), bytes, n, model))

  call must(hsp_boundary_limits_init(limits, limits%struct_size, n))
  call must(hsp_boundary_bytes(limits, bytes))
  allocate (boundary_memory(bytes))
  call must(hsp_boundary_init(c_loc(boundary_memory), bytes, limits, boundary))

  call must(hsp_model_options_init(options, options%struct_size))
  do p = 1, size(probes)
    options%probe = probes(p)
    call must(hsp_model_set(model, n, xyz, radius, options))
    call must(hsp_boundary_compute(boundary, model))
    call must(hsp_boundary_get_counts(boundary, counts))
    call must(hsp_boundary_measure(boundary, totals=totals, area=area, capacity=n))
    print '(a, f4.1, a, f9.4, a, f9.4, a, i0, a, i0, a)', 'probe ', probes(p), ' A: area ', totals%area, &
      ' A^2, volume ', totals%volume, ' A^3, ', counts%vertices, ' vertices, ', counts%faces, ' faces'
    do i = 1, n
      print '(a, a, f9.4, a)', '  ', element(i), area(i), ' A^2'
    end do
  end do

contains

  subroutine must(status)
    integer(c_int32_t), intent(in) :: status
    if (status == HSP_OK) return
    write (error_unit, '(a)') 'water: '//hsp_status_message(status)
    stop 1
  end subroutine
end program water
