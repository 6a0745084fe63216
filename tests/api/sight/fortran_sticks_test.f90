module counted_bytes
  use, intrinsic :: iso_c_binding, only: c_char, c_int32_t, c_int64_t, c_ptr, c_size_t
  implicit none
  integer(c_int64_t) :: counted = 0
contains
  function count_bytes(context, bytes, count) result(stop) bind(C)
    type(c_ptr), value :: context
    integer(c_size_t), value :: count
    character(kind=c_char), intent(in) :: bytes(count)
    integer(c_int32_t) :: stop
    counted = counted + size(bytes)
    stop = 0
  end function
end module

! Balls and sticks as a Fortran program sees them: every function is called, and records arrive field by field.
program fortran_sticks_test
  use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_char, c_null_ptr, &
                                         c_ptr, c_size_t, c_sizeof
  use counted_bytes
  use fortran_checks
  use hardsphere
  implicit none

  integer(c_int32_t), parameter :: n = 3
  real(c_double), parameter :: xyz(3, n) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    10.0_c_double, 0.0_c_double, 4.0_c_double, &
                                                    0.0_c_double, 10.0_c_double, 0.0_c_double], [3, 3])
  real(c_double), parameter :: radius(n) = [2.0_c_double, 2.0_c_double, 3.0_c_double]

  integer(c_int8_t), allocatable, target :: model_memory(:), sticks_memory(:)
  type(c_ptr) :: model = c_null_ptr, sticks = c_null_ptr
  type(hsp_sticks_limits) :: limits
  type(hsp_sticks_conflict) :: conflict
  type(hsp_sticks_info) :: info
  type(hsp_stick) :: stick(2)
  type(hsp_view_options) :: options
  integer(c_size_t) :: bytes
  integer(c_int64_t) :: taken
  type(hsp_map_info) :: map_info
  type(hsp_map_vertex) :: vertex(2)
  type(hsp_map_edge) :: edge(2)
  type(hsp_map_face) :: face(2)
  type(hsp_map_sight) :: sight
  type(hsp_map_point) :: point
  type(hsp_map_pole) :: pole
  integer(c_int32_t) :: outline(7)
  real(c_double) :: area(7)
  integer(c_int32_t) :: needed, invariant, id

  call check(c_sizeof(limits) == 20, 'size of hsp_sticks_limits')
  call check(c_sizeof(stick(1)) == 16, 'size of hsp_stick')
  call check(c_sizeof(conflict) == 16, 'size of hsp_sticks_conflict')
  call check(c_sizeof(info) == 144, 'size of hsp_sticks_info')

  call expect(hsp_model_bytes(n, bytes), HSP_OK, 'hsp_model_bytes')
  allocate (model_memory(bytes))
  call expect(hsp_model_init(c_loc(model_memory), bytes, n, model), HSP_OK, 'hsp_model_init')
  call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'hsp_model_set')
  call expect(hsp_sticks_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_sticks_limits_init')
  call check(limits%balls == n .and. limits%sticks == 2*n .and. limits%pairs == 64*n + 64 &
             .and. limits%edges == 0, 'limits')
  call expect(hsp_sticks_bytes(limits, bytes), HSP_OK, 'hsp_sticks_bytes')
  call check(bytes <= hsp_sticks_bytes_bound(limits%balls, limits%sticks, limits%pairs, limits%edges), &
             'hsp_sticks_bytes_bound')
  allocate (sticks_memory(bytes))
  call expect(hsp_sticks_init(c_loc(sticks_memory), bytes, limits, sticks), HSP_OK, 'hsp_sticks_init')
  call expect(hsp_sticks_get_info(sticks, info), HSP_E_STATE, 'info of nothing')

  stick(1) = hsp_stick([0_c_int32_t, 1_c_int32_t], 0_c_int32_t, 0_c_int32_t)
  stick(2) = hsp_stick([2_c_int32_t, 0_c_int32_t], HSP_STICK_WHOLE, 0_c_int32_t)
  call expect(hsp_view_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'hsp_view_options_init')
  call expect(hsp_sticks_compute(sticks, model, options, stick, 2, 2.5_c_double, conflict), HSP_E_CONFLICT, 'too thick')
  call check(conflict%kind == HSP_STICKS_THIN_BALL .and. conflict%first == 0 .and. conflict%second == 0, 'conflict')
  call expect(hsp_sticks_compute(sticks, model, options, stick, 2, 1.0_c_double, conflict, limits), HSP_OK, &
              'hsp_sticks_compute')
  call check(conflict%kind == HSP_STICKS_NO_CONFLICT .and. conflict%first == HSP_NONE, 'no conflict')
  call check(limits%balls == 3 .and. limits%sticks == 2 .and. limits%pairs >= 5, 'needed limits')
  call expect(hsp_sticks_get_info(sticks, info), HSP_OK, 'hsp_sticks_get_info')
  call check(info%paths == 6 .and. info%balls == 3 .and. info%sticks == 2, 'numbers of info')
  call check(abs(info%high(2) + info%origin(2) - 13.0_c_double) < 1e-6_c_double, 'box of info')
  call expect(hsp_sticks_get_map_info(sticks, map_info), HSP_E_STATE, 'an order and no map')
  deallocate (sticks_memory)
  limits%edges = 100
  call expect(hsp_sticks_bytes(limits, bytes), HSP_OK, 'hsp_sticks_bytes with edges')
  allocate (sticks_memory(bytes))
  call expect(hsp_sticks_init(c_loc(sticks_memory), bytes, limits, sticks), HSP_OK, 'hsp_sticks_init with edges')
  call expect(hsp_sticks_compute_map(sticks, model, options, stick, 2, 1.0_c_double, conflict, limits), HSP_OK, &
              'hsp_sticks_compute_map')
  call expect(hsp_sticks_get_map_info(sticks, map_info), HSP_OK, 'hsp_sticks_get_map_info')
  call check(map_info%balls == 3 .and. map_info%vertices + map_info%faces == map_info%edges + map_info%components + 1, &
             'numbers of the map')
  call expect(hsp_sticks_get_vertices(sticks, 0, 2, vertex), HSP_OK, 'hsp_sticks_get_vertices')
  call check(all(vertex%kind <= HSP_MAP_HALVES), 'kinds of vertices')
  call expect(hsp_sticks_get_edges(sticks, 0, 2, edge), HSP_OK, 'hsp_sticks_get_edges')
  call check(edge(1)%ball(1) >= 0 .and. edge(1)%ball(1) < 7, 'the ball or half of an edge')
  call expect(hsp_sticks_get_faces(sticks, 0, 2, face), HSP_OK, 'hsp_sticks_get_faces')
  call check(face(1)%ball == HSP_NONE .and. face(2)%area > 0, 'faces')
  call expect(hsp_sticks_get_areas(sticks, area, 7, needed), HSP_OK, 'hsp_sticks_get_areas')
  call check(needed == 7 .and. abs(sum(area) - map_info%area) < 1e-9_c_double, 'areas')
  call expect(hsp_sticks_pick(sticks, 0.0_c_double - map_info%origin(1), 4.0_c_double - map_info%origin(2), sight), HSP_OK, &
              'hsp_sticks_pick')
  call check(sight%ball == hsp_sticks_half(n, 1, 0), 'a whole stick')
  call check(hsp_sticks_half(1000_c_int32_t, 10_c_int32_t, 1_c_int32_t) == 1021, 'a half of a stick')
  call expect(hsp_sticks_get_pole(sticks, sight%face, pole), HSP_OK, 'hsp_sticks_get_pole')
  call check(pole%radius > 0 .and. pole%radius <= pole%bound, 'the radius of a pole')
  call expect(hsp_sticks_get_outline(sticks, sight%ball, outline, 7, needed), HSP_OK, 'hsp_sticks_get_outline')
  call check(needed == 1 .and. outline(1) >= 0 .and. outline(1) < 2 * map_info%edges, 'the outline of a stick')
  call expect(hsp_sticks_get_point(sticks, 0, edge(1)%from, point), HSP_OK, 'hsp_sticks_get_point')
  call check(abs(point%gap(1)) < 1e-12_c_double .and. point%gap(2) >= 0, 'the gaps of a point')
  call expect(hsp_sticks_check(sticks, invariant, id), HSP_OK, 'hsp_sticks_check')
  call check(invariant == 0, 'no violated invariant')
  call expect(hsp_sticks_compute(sticks, model, count=0_c_int32_t, radius=1.0_c_double), HSP_OK, 'without sticks')
  call expect(hsp_picture_write_sticks(sticks, title='sticks'//c_null_char, sink=c_funloc(count_bytes), &
                                       context=c_null_ptr, bytes=taken), HSP_OK, 'hsp_picture_write_sticks')
  call check(taken > 0 .and. taken == counted, 'bytes of a picture')
  call report_checks()
end program
