! The visibility map as a Fortran program sees it: every function is called, and records arrive field by field.
program fortran_map_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use fortran_checks
  use hardsphere
  implicit none

  ! A small ball before a large one.
  integer(c_int32_t), parameter :: n = 2
  real(c_double), parameter :: xyz(3, n) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    1.0_c_double, 0.0_c_double, 20.0_c_double], [3, 2])
  real(c_double), parameter :: radius(n) = [5.0_c_double, 1.0_c_double]
  real(c_double), parameter :: pi = acos(-1.0_c_double)

  integer(c_int8_t), allocatable, target :: model_memory(:), map_memory(:)
  type(c_ptr) :: model = c_null_ptr, map = c_null_ptr
  type(hsp_map_info) :: info

  call sizes()
  call compute()
  call records()
  call questions()
  call report_checks()

contains

  subroutine sizes()
    type(hsp_map_limits) :: limits
    type(hsp_map_vertex) :: vertex
    type(hsp_map_edge) :: edge
    type(hsp_map_face) :: face
    type(hsp_map_sight) :: sight
    type(hsp_map_point) :: point
    type(hsp_map_pole) :: pole
    call check(c_sizeof(limits) == 16, 'size of hsp_map_limits')
    call check(c_sizeof(info) == 136, 'size of hsp_map_info')
    call check(c_sizeof(vertex) == 48, 'size of hsp_map_vertex')
    call check(c_sizeof(edge) == 96, 'size of hsp_map_edge')
    call check(c_sizeof(face) == 24, 'size of hsp_map_face')
    call check(c_sizeof(sight) == 16, 'size of hsp_map_sight')
    call check(c_sizeof(point) == 40, 'size of hsp_map_point')
    call check(c_sizeof(pole) == 32, 'size of hsp_map_pole')
  end subroutine

  subroutine compute()
    type(hsp_map_limits) :: limits
    type(hsp_view_options) :: options
    integer(c_size_t) :: bytes
    call expect(hsp_model_bytes(n, bytes), HSP_OK, 'hsp_model_bytes')
    allocate (model_memory(bytes))
    call expect(hsp_model_init(c_loc(model_memory), bytes, n, model), HSP_OK, 'hsp_model_init')
    call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'hsp_model_set')
    call expect(hsp_map_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_map_limits_init')
    call check(limits%balls == n .and. limits%neighbours == n .and. limits%edges == 12*n + 64, 'limits')
    call expect(hsp_map_bytes(limits, bytes), HSP_OK, 'hsp_map_bytes')
    call check(bytes <= hsp_map_bytes_bound(limits%balls, limits%neighbours, limits%edges), 'hsp_map_bytes_bound')
    allocate (map_memory(bytes))
    call expect(hsp_map_init(c_loc(map_memory), bytes, limits, map), HSP_OK, 'hsp_map_init')
    call expect(hsp_map_get_info(map, info), HSP_E_STATE, 'info of an empty map')
    call expect(hsp_view_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'hsp_view_options_init')
    call expect(hsp_map_compute(map, model, options, limits), HSP_OK, 'hsp_map_compute')
    call check(limits%neighbours == 1 .and. limits%edges == 2, 'needed limits')
    call expect(hsp_map_compute(map, model), HSP_OK, 'hsp_map_compute without options')
    call expect(hsp_map_get_info(map, info), HSP_OK, 'hsp_map_get_info')
    call check(info%vertices == 2 .and. info%edges == 2 .and. info%faces == 3, 'vertices, edges, faces')
    call check(info%components == 2 .and. info%balls == 2 .and. info%reserved == 0, 'components, balls')
    call check(near(info%area, 25*pi) .and. info%perturbation == 0, 'area, perturbation')
    call check(all(info%origin == [0.5_c_double, 0.0_c_double, 10.0_c_double]), 'origin')
    call check(info%right(1) == 1 .and. info%up(2) == 1 .and. info%towards(3) == 1, 'frame')
  end subroutine

  subroutine records()
    type(hsp_map_vertex) :: vertices(2)
    type(hsp_map_edge) :: edges(2)
    type(hsp_map_face) :: faces(3)
    real(c_double) :: area(n)
    integer(c_int32_t) :: needed, loops(2), e, h
    call expect(hsp_map_get_vertices(map, 0, 2, vertices), HSP_OK, 'hsp_map_get_vertices')
    call expect(hsp_map_get_edges(map, 0, 2, edges), HSP_OK, 'hsp_map_get_edges')
    call expect(hsp_map_get_faces(map, 0, 3, faces), HSP_OK, 'hsp_map_get_faces')
    call expect(hsp_map_get_faces(map, 3, 1, faces), HSP_E_ID, 'a face too many')
    call expect(hsp_map_get_areas(map, area, n, needed), HSP_OK, 'hsp_map_get_areas')
    call check(near(area(1), 24*pi) .and. near(area(2), pi) .and. needed == n, 'areas')
    call check(faces(1)%ball == HSP_NONE .and. faces(1)%area == 0 .and. faces(1)%loops == 1, 'the unbounded face')
    call check(all(vertices%kind == HSP_MAP_PLAIN), 'kinds of vertices')
    do e = 0, 1
      h = 2*e
      call check(edges(e + 1)%ball(2) == HSP_NONE, 'a silhouette')
      call check(near(edges(e + 1)%first(1), radius(edges(e + 1)%ball(1) + 1)), 'semi-axes')
      call check(near(edges(e + 1)%second(2), edges(e + 1)%first(1)), 'semi-axes')
      call check(near(edges(e + 1)%to - edges(e + 1)%from, 2*pi), 'a whole circle')
      call check(hsp_map_next(map, h) == h .and. edges(e + 1)%next(1) == h, 'next')
      call check(hsp_map_previous(map, h) == h .and. hsp_map_next_loop(map, hsp_map_twin(h)) >= 0, 'steps')
      call check(hsp_map_origin(map, h) == edges(e + 1)%vertex(1), 'origin')
      call check(hsp_map_left(map, h) == edges(e + 1)%face(1), 'left')
    end do
    call expect(hsp_map_get_outline(map, 0, loops, 2, needed), HSP_OK, 'hsp_map_get_outline')
    call check(needed == 2 .and. hsp_map_next_loop(map, loops(1)) == loops(2), 'an outline with a hole')
    call check(hsp_map_next(map, HSP_NONE) == HSP_NONE .and. hsp_map_twin(HSP_NONE) == HSP_NONE, 'no directed edge')
    call check(all(hsp_map_twin([6_c_int32_t, 7_c_int32_t]) == [7, 6]), 'twins')
    call check(all(hsp_surface_twin([6_c_int32_t, 7_c_int32_t, HSP_NONE]) == [7, 6, HSP_NONE]), 'twins of a surface')
  end subroutine

  subroutine questions()
    type(hsp_map_sight) :: sight
    type(hsp_map_point) :: point
    type(hsp_map_pole) :: pole
    integer(c_int32_t) :: invariant, id
    call expect(hsp_map_pick(map, 0.5_c_double, 0.0_c_double, sight), HSP_OK, 'hsp_map_pick')
    call check(sight%ball == 1 .and. near(sight%depth, 11.0_c_double) .and. sight%face > 0, 'the nearer ball')
    call expect(hsp_map_get_pole(map, sight%face, pole), HSP_OK, 'hsp_map_get_pole')
    call check(near(pole%centre(1), 0.5_c_double) .and. abs(pole%centre(2)) < 1e-12_c_double, 'the pole of a disc')
    call check(near(pole%radius, 1.0_c_double) .and. pole%bound >= pole%radius, 'its radius')
    call expect(hsp_map_get_pole(map, 0, pole), HSP_E_ID, 'the unbounded face')
    call expect(hsp_map_pick(map, -0.5_c_double, 4.0_c_double, sight), HSP_OK, 'hsp_map_pick')
    call check(sight%ball == 0 .and. near(sight%depth, -7.0_c_double), 'the farther ball')
    call expect(hsp_map_get_point(map, 0, 0.0_c_double, point), HSP_OK, 'hsp_map_get_point')
    call check(point%gap(1) == 0 .and. point%gap(2) > 0, 'gaps')
    call expect(hsp_map_get_point(map, 2, 0.0_c_double, point), HSP_E_ID, 'an edge too many')
    call expect(hsp_map_check(map, invariant, id), HSP_OK, 'hsp_map_check')
    call check(invariant == 0 .and. id == HSP_NONE, 'no invariant is violated')
  end subroutine
end program fortran_map_test
