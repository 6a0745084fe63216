! A picture from Fortran: a ring of balls seen from the side, as SVG into a file, through a sink written in Fortran.
!   draw_fortran_example FILE.svg
module file_sink
  use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_int32_t, c_ptr, c_size_t
  implicit none

contains

  ! The context is the address of the file's unit. Any value but 0 stops the picture.
  function write_bytes(context, bytes, count) result(stop) bind(C)
    type(c_ptr), value :: context
    integer(c_size_t), value :: count
    character(kind=c_char), intent(in) :: bytes(count)
    integer(c_int32_t) :: stop
    integer, pointer :: unit
    call c_f_pointer(context, unit)
    write (unit, iostat=stop) bytes
  end function
end module

program draw
  use, intrinsic :: iso_c_binding, only: c_funloc, c_loc, c_null_char
  use, intrinsic :: iso_fortran_env, only: error_unit
  use hardsphere_workspace
  use file_sink
  implicit none
  integer(c_int32_t), parameter :: n = 12
  real(c_double), parameter :: turn = 6.283185307179586_c_double/n
  type(hsp_workspace), target :: work
  type(hsp_view_options) :: direction
  real(c_double) :: xyz(3, n), radius(n)
  integer(c_int32_t) :: colour(n), status, i
  integer, target :: unit
  character(len=1000) :: file

  do i = 1, n
    xyz(:, i) = [4*cos(turn*i), 4*sin(turn*i), 0.0_c_double]
    colour(i) = hsp_palette_colour(HSP_PALETTE_CHAIN, 6_c_int32_t, i)
  end do
  radius = [(1.2_c_double + 0.3_c_double*mod(i, 2), i=1, n)]
  call get_command_argument(1, file)
  open (newunit=unit, file=file, access='stream', status='replace', iostat=i)
  if (i /= 0) then
    write (error_unit, '(a)') 'draw: cannot write '//trim(file)
    stop 1
  end if
  status = work%set(n, xyz, radius)
  if (status == HSP_OK) status = hsp_view_options_init(direction, direction%struct_size)
  if (status == HSP_OK) status = hsp_view_options_turn(direction, -60.0_c_double, 0.0_c_double, 0.0_c_double)
  if (status == HSP_OK) status = work%compute_view(direction)
  if (status == HSP_OK) status = hsp_picture_write(work%view, colour=colour, title='A ring'//c_null_char, &
                                                   sink=c_funloc(write_bytes), context=c_loc(unit))
  close (unit)
  if (status /= HSP_OK) then
    write (error_unit, '(a)') 'draw: '//hsp_status_message(status)
    stop 1
  end if
end program
