! Views and pictures as a Fortran program sees them: every function is called, records arrive field by field, and a sink
! written in Fortran receives a picture.
module collected_picture
  use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_int32_t, c_ptr, c_size_t
  implicit none

  type :: picture_text
    character(len=:), allocatable :: text
    integer(c_size_t) :: most = huge(0_c_size_t)  ! stops when there would be more
    integer :: calls = 0
  end type

contains

  ! Appends to the picture_text whose address is the context.
  function append(context, bytes, count) result(stop) bind(C)
    type(c_ptr), value :: context
    integer(c_size_t), value :: count
    character(kind=c_char), intent(in) :: bytes(count)
    integer(c_int32_t) :: stop
    type(picture_text), pointer :: picture
    character(len=:), allocatable :: piece
    integer(c_size_t) :: i
    call c_f_pointer(context, picture)
    picture%calls = picture%calls + 1
    stop = merge(1_c_int32_t, 0_c_int32_t, len(picture%text) + count > picture%most)
    if (stop /= 0) return
    allocate (character(len=count) :: piece)
    do i = 1, count
      piece(i:i) = bytes(i)
    end do
    picture%text = picture%text//piece
  end function
end module collected_picture

program fortran_view_test
  use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_char, &
                                         c_null_funptr, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use collected_picture
  use fortran_checks
  use hardsphere
  implicit none

  ! Water, in Angstrom.
  integer(c_int32_t), parameter :: n = 3
  real(c_double), parameter :: water(3, n) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                      0.9572_c_double, 0.0_c_double, 0.0_c_double, &
                                                      -0.23998721_c_double, 0.92662721_c_double, 0.0_c_double], [3, 3])
  real(c_double), parameter :: water_radius(n) = [1.52_c_double, 1.10_c_double, 1.10_c_double]
  integer(c_int32_t), parameter :: atomic_number(n) = [8, 1, 1]
  real(c_double), parameter :: pi = acos(-1.0_c_double)

  integer(c_int8_t), allocatable, target :: model_memory(:), boundary_memory(:), view_memory(:)
  type(c_ptr) :: model, boundary, view = c_null_ptr

  call sizes()
  call make_handles()
  call two_balls()
  call directions()
  call pieces_of_faces()
  call palettes()
  call draw_water()
  call draw_map()
  call reports_errors()
  call report_checks()

contains

  subroutine sizes()
    type(hsp_view_limits) :: limits
    type(hsp_view_options) :: options
    type(hsp_view_info) :: info
    type(hsp_view_piece) :: piece
    type(hsp_view_loop) :: loop
    type(hsp_view_arc) :: arc
    type(hsp_picture_options) :: picture
    call check(c_sizeof(limits) == 16, 'size of hsp_view_limits')
    call check(c_sizeof(options) == 80, 'size of hsp_view_options')
    call check(c_sizeof(info) == 160, 'size of hsp_view_info')
    call check(c_sizeof(piece) == 56, 'size of hsp_view_piece')
    call check(c_sizeof(loop) == 16, 'size of hsp_view_loop')
    call check(c_sizeof(arc) == 96, 'size of hsp_view_arc')
    call check(c_sizeof(picture) == 208, 'size of hsp_picture_options')
    call check(picture%struct_size == c_sizeof(picture), 'struct_size of hsp_picture_options, which has pointers')
  end subroutine

  subroutine make_handles()
    integer(c_size_t) :: bytes
    type(hsp_boundary_limits) :: limits
    type(hsp_view_limits) :: view_limits
    call expect(hsp_model_bytes(n, bytes), HSP_OK, 'hsp_model_bytes')
    allocate (model_memory(bytes))
    call expect(hsp_model_init(c_loc(model_memory), bytes, n, model), HSP_OK, 'hsp_model_init')
    call expect(hsp_boundary_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'limits')
    call expect(hsp_boundary_bytes(limits, bytes), HSP_OK, 'hsp_boundary_bytes')
    allocate (boundary_memory(bytes))
    call expect(hsp_boundary_init(c_loc(boundary_memory), bytes, limits, boundary), HSP_OK, 'hsp_boundary_init')
    call expect(hsp_view_limits_init(view_limits, int(c_sizeof(view_limits), c_int32_t), n), HSP_OK, 'hsp_view_limits_init')
    call check(view_limits%balls == n .and. view_limits%neighbours == n .and. view_limits%arcs == 12*n + 64, 'limits')
    call expect(hsp_view_bytes(view_limits, bytes), HSP_OK, 'hsp_view_bytes')
    call check(bytes > 0 .and. bytes <= hsp_view_bytes_bound(view_limits%balls, view_limits%neighbours, view_limits%arcs), &
               'hsp_view_bytes_bound')
    allocate (view_memory(bytes))
    call expect(hsp_view_init(c_loc(view_memory), bytes, view_limits, view), HSP_OK, 'hsp_view_init')
  end subroutine

  subroutine usual_options(options)
    type(hsp_view_options), intent(out) :: options
    call expect(hsp_view_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'hsp_view_options_init')
  end subroutine

  ! Radii 5, centres 6 apart along x: they meet in a circle of radius 4, which is seen as a line. The ball at the origin is
  ! the farther one, since depths are equal and its x is smaller.
  subroutine two_balls()
    real(c_double), parameter :: xyz(3, 2) = reshape([0, 0, 0, 6, 0, 0]*1.0_c_double, [3, 2])
    real(c_double), parameter :: radius(2) = [5.0_c_double, 5.0_c_double]
    type(hsp_view_info) :: info
    type(hsp_view_piece) :: pieces(2)
    type(hsp_view_loop) :: loops(2)
    type(hsp_view_arc) :: arcs(3)
    type(hsp_view_limits) :: needed_limits
    integer(c_int32_t) :: needed
    integer :: i
    call expect(hsp_view_get_info(view, info), HSP_E_STATE, 'nothing computed')
    call expect(hsp_model_set(model, 2_c_int32_t, xyz, radius), HSP_OK, 'hsp_model_set')
    needed_limits%struct_size = int(c_sizeof(needed_limits), c_int32_t)
    call expect(hsp_view_compute(view, model, c_null_ptr, limits=needed_limits), HSP_OK, 'hsp_view_compute')
    call check(needed_limits%balls == 2 .and. needed_limits%neighbours == 1 .and. needed_limits%arcs == 3, 'what was needed')
    call expect(hsp_view_get_info(view, info), HSP_OK, 'hsp_view_get_info')
    call check(info%pieces == 2 .and. info%loops == 2 .and. info%arcs == 3 .and. info%kind == HSP_PIECES_OUTSIDE_FARTHER, 'counts')
    call check(all(info%origin == [3, 0, 0]) .and. all(info%towards == [0, 0, 1]), 'where the view is')
    call check(all(info%right == [1, 0, 0]) .and. all(info%up == [0, 1, 0]), 'how the view is turned')
    call check(all(abs(info%low - [-8, -5]) < 1e-12_c_double) .and. all(abs(info%high - [8, 5]) < 1e-12_c_double), 'the box')
    call check(info%depth_low == 0 .and. info%depth_high == 0, 'depths')
    call expect(hsp_view_get_pieces(view, capacity=0_c_int32_t, needed=needed), HSP_E_CAPACITY, 'how many pieces')
    call check(needed == 2, 'number of pieces')
    call expect(hsp_view_get_pieces(view, pieces, 2_c_int32_t, needed), HSP_OK, 'hsp_view_get_pieces')
    call check(all(pieces%ball == [0, 1]) .and. all(pieces%loops == 1) .and. all(pieces%arcs == [1, 2]), 'pieces')
    call check(all(pieces%first_loop == [0, 1]) .and. all(pieces%first_arc == [0, 1]), 'where pieces begin')
    call check(all(pieces%radius == 5) .and. all(pieces%depth == 0) .and. all(pieces%reserved == 0), 'their balls')
    call check(pieces(1)%centre(1) == -3 .and. pieces(2)%centre(1) == 3 .and. pieces(2)%centre(2) == 0, 'their places')
    call expect(hsp_view_get_loops(view, loops, 2_c_int32_t, needed), HSP_OK, 'hsp_view_get_loops')
    call check(all(loops%piece == [0, 1]) .and. all(loops%first_arc == [0, 1]) .and. all(loops%arcs == [1, 2]), 'loops')
    call expect(hsp_view_get_arcs(view, arcs, 3_c_int32_t, needed), HSP_OK, 'hsp_view_get_arcs')
    call check(needed == 3 .and. all(arcs%piece == [0, 1, 1]), 'arcs')
    call check(arcs(1)%other_ball == HSP_NONE .and. near(arcs(1)%to - arcs(1)%from, 2*pi), 'the farther ball is whole')
    call check(all(arcs(2)%end == arcs(3)%start) .and. all(arcs(3)%end == arcs(2)%start), 'a closed loop')
    do i = 2, 3
      if (arcs(i)%other_ball == HSP_NONE) then
        call check(all(arcs(i)%semi_axis == 5) .and. arcs(i)%to > arcs(i)%from, 'a silhouette')
      else
        call check(arcs(i)%other_ball == 0 .and. near(arcs(i)%semi_axis(1), 4.0_c_double), 'an intersection')
        call check(arcs(i)%semi_axis(2) == 0 .and. near(abs(arcs(i)%rotation), pi/2), 'seen edge on')
        call check(near(abs(arcs(i)%start(2)), 4.0_c_double) .and. near(arcs(i)%centre(1), 0.0_c_double), 'where it lies')
      end if
    end do
    call check(count(arcs%other_ball == HSP_NONE) == 2, 'two silhouettes')
  end subroutine

  subroutine directions()
    type(hsp_view_options) :: options
    type(hsp_view_info) :: info
    call usual_options(options)
    call check(options%struct_size == 80 .and. options%pieces == HSP_PIECES_OUTSIDE_FARTHER .and. options%flags == 0, 'options')
    call expect(hsp_view_options_turn(options, 90.0_c_double, 0.0_c_double, 0.0_c_double), HSP_OK, 'hsp_view_options_turn')
    options%flags = HSP_VIEW_ALL_BALLS
    call expect(hsp_view_compute(view, model, c_null_ptr, options), HSP_OK, 'turned by a quarter')
    call expect(hsp_view_get_info(view, info), HSP_OK, 'hsp_view_get_info')
    call check(all(info%towards == [0, 1, 0]) .and. all(info%up == [0, 0, -1]), 'what pointed up points to the viewer')
    options%towards = [1, 0, 0]
    options%up = 0
    call expect(hsp_view_compute(view, model, c_null_ptr, options), HSP_OK, 'from the side')
    call expect(hsp_view_get_info(view, info), HSP_OK, 'hsp_view_get_info')
    call check(info%pieces == 2 .and. info%arcs == 2, 'one behind the other')
    call check(info%depth_low == -3 .and. info%depth_high == 3, 'depths')
  end subroutine

  subroutine pieces_of_faces()
    type(hsp_view_options) :: options
    type(hsp_view_info) :: info
    call usual_options(options)
    options%pieces = HSP_PIECES_OUTSIDE_ALL
    call expect(hsp_view_compute(view, model, c_null_ptr, options), HSP_E_ARGUMENT, 'H-pieces without a boundary')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'hsp_boundary_compute')
    call expect(hsp_view_compute(view, model, boundary, options), HSP_OK, 'H-pieces')
    call expect(hsp_view_get_info(view, info), HSP_OK, 'hsp_view_get_info')
    call check(info%kind == HSP_PIECES_OUTSIDE_ALL .and. info%pieces == 2 .and. info%arcs == 4, 'both balls are cut')
  end subroutine

  subroutine palettes()
    call check(hsp_palette_colour(HSP_PALETTE_JMOL, 8_c_int32_t, 0_c_int32_t) == int(z'FF0D0D', c_int32_t), 'oxygen')
    call check(hsp_palette_colour(HSP_PALETTE_SOFT, 6_c_int32_t, 5_c_int32_t) == &
               hsp_palette_colour(99_c_int32_t, 6_c_int32_t, 0_c_int32_t), 'an unknown palette')
    call check(hsp_palette_colour(HSP_PALETTE_CHAIN, 6_c_int32_t, 1_c_int32_t) == &
               hsp_palette_colour(HSP_PALETTE_CHAIN, 6_c_int32_t, 13_c_int32_t), 'tints repeat')
  end subroutine

  subroutine draw_water()
    type(hsp_picture_options) :: options
    type(picture_text), target :: picture, short
    integer(c_int32_t) :: colour(n)
    integer(c_int64_t) :: bytes
    integer(c_int32_t) :: format
    integer :: i
    do i = 1, n
      colour(i) = hsp_palette_colour(HSP_PALETTE_SOFT, atomic_number(i), 0_c_int32_t)
    end do
    call expect(hsp_model_set(model, n, water, water_radius), HSP_OK, 'hsp_model_set')
    call expect(hsp_view_compute(view, model, c_null_ptr), HSP_OK, 'hsp_view_compute')
    call expect(hsp_picture_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'hsp_picture_options_init')
    call check(options%format == HSP_FORMAT_SVG .and. options%style == HSP_STYLE_FLAT .and. options%unit == HSP_UNIT_PX, &
               'picture options')
    call check(options%width == 1000 .and. options%height == 0 .and. options%margin == 0.03_c_double, 'picture options')
    call check(options%outline == -1 .and. options%fog == 0.3_c_double .and. options%flags == 0, 'picture options')
    call check(options%outline_colour == int(z'23202B', c_int32_t) .and. options%background == int(z'FFFFFF', c_int32_t), &
               'colours of picture options')
    options%width = 400
    picture%text = ''
    call expect(hsp_picture_write(view, colour, options, 'water'//c_null_char, 'drawn by Fortran'//c_null_char, &
                                  c_funloc(append), c_loc(picture), bytes), HSP_OK, 'hsp_picture_write')
    call check(bytes == len(picture%text) .and. bytes > 300 .and. picture%calls > 0, 'number of bytes')
    call check(index(picture%text, '<svg') > 0 .and. index(picture%text, '</svg>') > 0, 'an SVG')
    call check(index(picture%text, 'water') > 0 .and. index(picture%text, 'drawn by Fortran') > 0, 'title, description')
    do i = 0, n - 1
      call check(index(picture%text, 'data-ball="'//achar(iachar('0') + i)//'"') > 0, 'each atom is drawn')
    end do
    short%text = ''
    short%most = 100
    call expect(hsp_picture_write(view, colour, options, 'water'//c_null_char, 'drawn by Fortran'//c_null_char, &
                                  c_funloc(append), c_loc(short), bytes), HSP_E_SINK, 'a sink that stops')
    call check(bytes == len(short%text), 'bytes before the end')
    call check(short%text == picture%text(1:bytes), 'the same picture up to there')
    do format = HSP_FORMAT_EPS, HSP_FORMAT_PDF
      options%format = format
      options%style = HSP_STYLE_HEADLIGHT
      options%unit = HSP_UNIT_MM
      options%flags = ior(HSP_PICTURE_NO_IDS, HSP_PICTURE_NO_BACKGROUND)
      picture%text = ''
      call expect(hsp_picture_write(view, options=options, sink=c_funloc(append), context=c_loc(picture)), HSP_OK, &
                  'no colours, title, description, number of bytes')
      call check(index(picture%text, merge('%!PS-', '%PDF-', format == HSP_FORMAT_EPS)) == 1, 'EPS or PDF')
    end do
  end subroutine

  subroutine draw_map()
    type(hsp_map_limits) :: limits
    type(picture_text), target :: picture
    integer(c_int8_t), allocatable, target :: map_memory(:)
    type(c_ptr) :: map
    integer(c_size_t) :: size
    integer(c_int64_t) :: bytes
    call expect(hsp_model_set(model, n, water, water_radius), HSP_OK, 'hsp_model_set')
    call expect(hsp_map_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_map_limits_init')
    call expect(hsp_map_bytes(limits, size), HSP_OK, 'hsp_map_bytes')
    allocate (map_memory(size))
    call expect(hsp_map_init(c_loc(map_memory), size, limits, map), HSP_OK, 'hsp_map_init')
    picture%text = ''
    call expect(hsp_picture_write_map(map, sink=c_funloc(append), context=c_loc(picture)), HSP_E_STATE, 'no map yet')
    call expect(hsp_map_compute(map, model), HSP_OK, 'hsp_map_compute')
    call expect(hsp_picture_write_map(map, title='water'//c_null_char, sink=c_funloc(append), context=c_loc(picture), &
                                      bytes=bytes), HSP_OK, 'hsp_picture_write_map')
    call check(bytes == len(picture%text) .and. index(picture%text, '</svg>') > 0, 'an SVG of a map')
    call check(index(picture%text, 'data-ball="2"') > 0 .and. index(picture%text, 'fill="none"') > 0, 'paths and lines')
  end subroutine

  subroutine reports_errors()
    type(hsp_view_options) :: options
    type(hsp_picture_options) :: picture
    type(hsp_view_info) :: info
    type(picture_text), target :: nothing
    nothing%text = ''
    call usual_options(options)
    options%reserved = 1
    call expect(hsp_view_compute(view, model, c_null_ptr, options), HSP_E_VERSION, 'reserved')
    call expect(hsp_view_options_turn(options, 2e6_c_double, 0.0_c_double, 0.0_c_double), HSP_E_RANGE, 'a large angle')
    call expect(hsp_view_compute(view, model, c_null_ptr), HSP_OK, 'hsp_view_compute')
    call expect(hsp_picture_write(view, sink=c_null_funptr, context=c_null_ptr), HSP_E_ARGUMENT, 'no sink')
    call expect(hsp_picture_options_init(picture, int(c_sizeof(picture), c_int32_t)), HSP_OK, 'hsp_picture_options_init')
    picture%style = HSP_STYLE_SOFT + 1
    call expect(hsp_picture_write(view, options=picture, sink=c_funloc(append), context=c_loc(nothing)), HSP_E_ARGUMENT, &
                'an unknown style')
    picture%style = HSP_STYLE_SOFT
    picture%scale = 20
    picture%centre(1) = 1e7_c_double
    call expect(hsp_picture_write(view, options=picture, sink=c_funloc(append), context=c_loc(nothing)), HSP_E_RANGE, &
                'a frame far away')
    picture%margin = -1
    call expect(hsp_picture_write(view, options=picture, sink=c_funloc(append), context=c_loc(nothing)), HSP_E_RANGE, &
                'a negative margin')
    call expect(hsp_model_set(model, n - 1, water, water_radius), HSP_OK, 'hsp_model_set')
    call expect(hsp_view_get_info(view, info), HSP_E_STATE, 'the model holds other balls')
    call expect(hsp_picture_write(view, sink=c_funloc(append), context=c_loc(nothing)), HSP_E_STATE, 'nothing to draw')
    call check(len(nothing%text) == 0 .and. nothing%calls == 0, 'the sink hears nothing of errors')
  end subroutine
end program fortran_view_test
