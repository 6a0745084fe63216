! A user's program: the area of two unit balls at distance 1, whose caps are known.
program main
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_ptr, c_size_t, c_sizeof
  use hardsphere
  implicit none
  integer(c_int32_t), parameter :: n = 2
  real(c_double), parameter :: xyz(3, n) = reshape([0, 0, 0, 1, 0, 0], [3, 2])
  real(c_double), parameter :: radius(n) = 1
  integer(c_int8_t), allocatable, target :: model_memory(:), boundary_memory(:)
  integer(c_size_t) :: bytes
  type(hsp_boundary_limits) :: limits
  type(hsp_totals) :: totals
  type(c_ptr) :: model, boundary
  allocate (model_memory(hsp_model_bytes_bound(n)))
  if (hsp_model_init(c_loc(model_memory), size(model_memory, kind=c_size_t), n, model) /= HSP_OK) stop 2
  if (hsp_boundary_limits_init(limits, int(c_sizeof(limits), c_int32_t), n) /= HSP_OK) stop 3
  if (hsp_boundary_bytes(limits, bytes) /= HSP_OK) stop 4
  allocate (boundary_memory(bytes))
  if (hsp_boundary_init(c_loc(boundary_memory), bytes, limits, boundary) /= HSP_OK) stop 5
  if (hsp_model_set(model, n, xyz, radius) /= HSP_OK) stop 6
  if (hsp_boundary_compute(boundary, model) /= HSP_OK) stop 7
  if (hsp_boundary_measure(boundary, totals=totals, capacity=0_c_int32_t) /= HSP_OK) stop 8
  print '(a, f18.15)', 'Fortran: area ', totals%area
  if (abs(totals%area - 6*acos(-1.0_c_double)) >= 1e-12_c_double) stop 1
end program main
