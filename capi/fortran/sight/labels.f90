! A ring of balls seen from the side, from Fortran: how much of each, and where a label fits.
program labels
  use, intrinsic :: iso_fortran_env, only: error_unit
  use hardsphere_workspace
  implicit none
  integer(c_int32_t), parameter :: n = 12
  real(c_double), parameter :: turn = 6.283185307179586_c_double/n
  type(hsp_workspace), target :: work
  type(hsp_view_options) :: direction
  type(hsp_map_info) :: info
  type(hsp_map_face) :: face(1)
  type(hsp_map_pole) :: pole
  real(c_double) :: xyz(3, n), area(n)
  integer(c_int32_t) :: status, needed, f, i

  do i = 1, n
    xyz(:, i) = [4*cos(turn*i), 4*sin(turn*i), 0.0_c_double]
  end do
  status = work%set(n, xyz, [(1.2_c_double + 0.3_c_double*mod(i, 2), i=1, n)])
  if (status == HSP_OK) status = hsp_view_options_init(direction, direction%struct_size)
  if (status == HSP_OK) status = hsp_view_options_turn(direction, -60.0_c_double, 0.0_c_double, 0.0_c_double)
  if (status == HSP_OK) status = work%compute_map(direction)
  if (status == HSP_OK) status = hsp_map_get_info(work%map, info)
  if (status == HSP_OK) status = hsp_map_get_areas(work%map, area, n, needed)
  if (status == HSP_OK) then
    print '(i0, a, i0, a, f0.4)', info%balls, ' balls in ', info%faces - 1, ' faces, area ', sum(area)
    ! The faces of a ball follow each other; 0 is the unbounded one.
    do f = 1, info%faces - 1
      if (status == HSP_OK) status = hsp_map_get_faces(work%map, f, 1, face)
      if (status == HSP_OK) status = hsp_map_get_pole(work%map, f, pole)
      if (face(1)%ball == HSP_NONE) cycle
      print '(a, i0, a, f7.4, a, 2f9.4, a, f7.4)', 'ball ', face(1)%ball, ': area', face(1)%area, ', label at', &
        pole%centre, ', within', pole%radius
    end do
  end if
  if (status /= HSP_OK) then
    write (error_unit, '(a)') 'labels: '//hsp_status_message(status)
    stop 1
  end if
end program
