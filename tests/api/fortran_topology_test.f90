! The topology section of the interface as a Fortran program sees it: every function is called, records arrive field by
! field, the two flat arrays hold what the steps say, ids are 0-based indices.
program fortran_topology_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use fortran_checks
  use hardsphere
  implicit none

  ! Eight balls on a cube's corners, near enough to close the room between them, and one ball apart.
  integer(c_int32_t), parameter :: n = 9
  real(c_double), parameter :: apart(3) = [9.0_c_double, 0.5_c_double, 0.5_c_double]
  real(c_double), parameter :: middle(3) = 0.5_c_double, outside(3) = [-5.0_c_double, 2.0_c_double, 1.0_c_double]

  real(c_double) :: xyz(3, n), radius(n)
  integer(c_int8_t), allocatable, target :: model_memory(:), boundary_memory(:), topology_memory(:)
  type(c_ptr) :: model, boundary, topology = c_null_ptr
  type(hsp_topology_counts) :: counts

  call compute_boundary()
  call sizes_and_quarter_edges()
  call compute_topology()
  call steps_and_arrays()
  call records()
  call shells_and_regions()
  call scan_and_places()
  call check_and_errors()
  call report_checks()

contains

  subroutine compute_boundary()
    integer(c_size_t) :: bytes
    type(hsp_boundary_limits) :: limits
    integer :: i
    do i = 0, 7
      xyz(:, i + 1) = [iand(i, 1), iand(i/2, 1), i/4]
    end do
    xyz(:, n) = apart
    radius = 0.75_c_double
    call expect(hsp_model_bytes(n, bytes), HSP_OK, 'hsp_model_bytes')
    allocate (model_memory(bytes))
    call expect(hsp_model_init(c_loc(model_memory), bytes, n, model), HSP_OK, 'hsp_model_init')
    call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'hsp_model_set')
    call expect(hsp_boundary_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'limits')
    call expect(hsp_boundary_bytes(limits, bytes), HSP_OK, 'hsp_boundary_bytes')
    allocate (boundary_memory(bytes))
    call expect(hsp_boundary_init(c_loc(boundary_memory), bytes, limits, boundary), HSP_OK, 'hsp_boundary_init')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'hsp_boundary_compute')
  end subroutine

  subroutine sizes_and_quarter_edges()
    type(hsp_topology_limits) :: limits
    type(hsp_topology_vertex) :: vertex
    type(hsp_topology_edge) :: edge
    type(hsp_simple_face) :: face
    type(hsp_shell) :: shell
    type(hsp_component) :: component
    type(hsp_region) :: region
    integer(c_int32_t) :: q
    call check(c_sizeof(limits) == 24, 'size of hsp_topology_limits')
    call check(c_sizeof(counts) == 48, 'size of hsp_topology_counts')
    call check(c_sizeof(vertex) == 48, 'size of hsp_topology_vertex')
    call check(c_sizeof(edge) == 96, 'size of hsp_topology_edge')
    call check(c_sizeof(face) == 24, 'size of hsp_simple_face')
    call check(c_sizeof(shell) == 88, 'size of hsp_shell')
    call check(c_sizeof(component) == 24, 'size of hsp_component')
    call check(c_sizeof(region) == 32, 'size of hsp_region')
    do q = 0, 11
      call check(hsp_quad_sym(q) == 4*(q/4) + mod(q + 2, 4), 'hsp_quad_sym')
      call check(hsp_quad_rot(hsp_quad_rot(q)) == hsp_quad_sym(q), 'hsp_quad_rot')
      call check(hsp_quad_inverse_rot(hsp_quad_rot(q)) == q, 'hsp_quad_inverse_rot')
    end do
    call check(hsp_quad_rot(HSP_NONE) == HSP_NONE .and. hsp_quad_inverse_rot(HSP_NONE) == HSP_NONE, 'rot of nothing')
    call check(hsp_quad_sym(HSP_NONE) == HSP_NONE, 'sym of nothing')
    call check(hsp_quad_rot(huge(0_c_int32_t)) == huge(0_c_int32_t) - 3, 'rot of the largest number')
    call check(all(hsp_quad_rot([0_c_int32_t, 3_c_int32_t]) == [1, 0]), 'rot of an array')
  end subroutine

  subroutine compute_topology()
    integer(c_size_t) :: bytes
    type(hsp_topology_limits) :: limits, needed
    type(hsp_boundary_counts) :: boundary_counts
    integer(c_int32_t) :: bytes_of_limits
    bytes_of_limits = int(c_sizeof(limits), c_int32_t)
    call expect(hsp_topology_limits_init(limits, bytes_of_limits, c_null_ptr), HSP_E_ARGUMENT, 'limits without a boundary')
    call expect(hsp_topology_limits_init(limits, bytes_of_limits, boundary), HSP_OK, 'hsp_topology_limits_init')
    call check(limits%balls == n .and. limits%struct_size == bytes_of_limits, 'limits for a boundary')
    call check(limits%shells == 3, 'limits for a boundary')
    call expect(hsp_topology_bytes(limits, bytes), HSP_OK, 'hsp_topology_bytes')
    call check(bytes > 0 .and. bytes <= hsp_topology_bytes_bound(limits%balls, limits%neighbours, limits%edges, &
                                                                 limits%cut_arcs), 'hsp_topology_bytes_bound')
    allocate (topology_memory(bytes))
    call expect(hsp_topology_init(c_loc(topology_memory), bytes, limits, topology), HSP_OK, 'hsp_topology_init')
    call expect(hsp_topology_get_counts(topology, counts), HSP_E_STATE, 'nothing computed')
    needed%struct_size = int(c_sizeof(needed), c_int32_t)
    call expect(hsp_topology_compute(topology, boundary, needed), HSP_OK, 'hsp_topology_compute')
    call check(needed%edges <= limits%edges .and. needed%cut_arcs <= limits%cut_arcs, 'what was needed')
    call expect(hsp_topology_get_counts(topology, counts), HSP_OK, 'hsp_topology_get_counts')
    call check(counts%edges == needed%edges, 'edges are what limits count')
    call check(counts%shells == 3 .and. counts%components == 2 .and. counts%regions == 2, 'counts of shells and regions')
    call expect(hsp_boundary_get_counts(boundary, boundary_counts), HSP_OK, 'hsp_boundary_get_counts')
    call check(counts%vertices - counts%edges + counts%simple_faces == boundary_counts%euler, 'Euler characteristic')
    call check(counts%cut_edges >= 2, 'the ball apart is cut in two')
  end subroutine

  subroutine steps_and_arrays()
    integer(c_int32_t), allocatable :: onext(:, :), origin(:, :)
    integer(c_int32_t) :: q, edge, k
    call expect(hsp_topology_get_quad_edges(topology, 0_c_int32_t, 0_c_int32_t), HSP_OK, 'no edges')
    allocate (onext(0:3, 0:counts%edges - 1), origin(0:3, 0:counts%edges - 1))
    call expect(hsp_topology_get_quad_edges(topology, 0_c_int32_t, counts%edges, onext, origin), HSP_OK, &
                'hsp_topology_get_quad_edges')
    do edge = 0, counts%edges - 1
      do k = 0, 3
        q = 4*edge + k
        call check(hsp_topology_onext(topology, q) == onext(k, edge), 'hsp_topology_onext')
        call check(hsp_topology_origin(topology, q) == origin(k, edge), 'hsp_topology_origin')
        call check(hsp_topology_oprev(topology, onext(k, edge)) == q, 'hsp_topology_oprev')
        call check(hsp_topology_lprev(topology, hsp_topology_lnext(topology, q)) == q, 'hsp_topology_lnext and lprev')
        call check(hsp_topology_lnext(topology, q) == hsp_quad_rot(hsp_topology_onext(topology, hsp_quad_inverse_rot(q))), &
                   'lnext from onext')
        call check(hsp_topology_left(topology, q) == hsp_topology_origin(topology, hsp_quad_inverse_rot(q)), &
                   'hsp_topology_left')
      end do
    end do
    call check(hsp_topology_onext(topology, 4*counts%edges) == HSP_NONE, 'no such quarter-edge')
    call check(hsp_topology_left(c_null_ptr, 0_c_int32_t) == HSP_NONE, 'no topology')
    onext = -7
    call expect(hsp_topology_get_quad_edges(topology, 1_c_int32_t, counts%edges - 1, origin=onext), HSP_OK, 'one array')
    call check(all(onext(:, 0:counts%edges - 2) == origin(:, 1:)) .and. all(onext(:, counts%edges - 1) == -7), 'one array')
  end subroutine

  subroutine records()
    type(hsp_topology_vertex) :: vertex, one_vertex(1), vertices(counts%vertices)
    type(hsp_topology_edge) :: edge, one_edge(1), edges(counts%edges)
    type(hsp_simple_face) :: face, faces(counts%simple_faces)
    integer(c_int32_t) :: i
    call expect(hsp_topology_get_vertices(topology, 0_c_int32_t, counts%vertices, vertices), HSP_OK, &
                'hsp_topology_get_vertices')
    call expect(hsp_topology_get_edges(topology, 0_c_int32_t, counts%edges, edges), HSP_OK, 'hsp_topology_get_edges')
    call expect(hsp_topology_get_simple_faces(topology, 0_c_int32_t, counts%simple_faces, faces), HSP_OK, &
                'hsp_topology_get_simple_faces')
    do i = 0, counts%vertices - 1
      call expect(hsp_topology_get_vertices(topology, i, 1_c_int32_t, one_vertex), HSP_OK, 'one vertex')
      vertex = one_vertex(1)
      call check(all(vertex%ball == vertices(hsp_index(i))%ball) .and. vertex%q == vertices(hsp_index(i))%q, 'a vertex')
      call check(hsp_topology_origin(topology, vertex%q) == i .and. vertex%reserved == 0, 'quarter-edge of a vertex')
      call check(vertex%kind >= HSP_POINT_VERTEX .and. vertex%kind <= HSP_POINT_POLE, 'kind of a vertex')
      call check(on_sphere(vertex%xyz, vertex%ball(1)), 'a vertex lies on its sphere')
      call check((vertex%kind == HSP_POINT_POLE) .eqv. (vertex%ball(2) == HSP_NONE), 'a pole lies on one sphere')
    end do
    do i = 0, counts%edges - 1
      call expect(hsp_topology_get_edges(topology, i, 1_c_int32_t, one_edge), HSP_OK, 'one edge')
      edge = one_edge(1)
      call check(all(edge%vertex == edges(hsp_index(i))%vertex) .and. all(edge%face == edges(hsp_index(i))%face), 'an edge')
      call check(edge%vertex(1) == hsp_topology_origin(topology, 4*i), 'an edge''s origin')
      call check(edge%vertex(2) == hsp_topology_origin(topology, hsp_quad_sym(4*i)), 'an edge''s destination')
      call check(all(edge%ball == [faces(hsp_index(edge%face(1)))%ball, faces(hsp_index(edge%face(2)))%ball]), 'its balls')
      call check((edge%kind == HSP_EDGE_CUT) .eqv. (edge%source == HSP_NONE), 'source of an edge')
      call check(abs(norm2(vertices(hsp_index(edge%vertex(2)))%xyz - edge%centre) - edge%radius) < 1e-13_c_double, 'circle')
      call check(abs(norm2(edge%axis) - 1) < 1e-14_c_double, 'axis of an edge')
      ! four spheres meet on each side of the cube: some arcs have length 0
      call check(edge%angle >= 0 .and. edge%angle < 7, 'angle of an edge')
    end do
    do i = 0, counts%simple_faces - 1
      face = faces(hsp_index(i))
      call check(hsp_topology_left(topology, face%q) == i .and. face%edges >= 2 .and. face%reserved == 0, 'a simple face')
      call check(face%shell >= 0 .and. face%shell < counts%shells .and. face%face >= 0, 'shell of a simple face')
    end do
    call expect(hsp_topology_get_vertices(topology, counts%vertices, 1_c_int32_t, vertices), HSP_E_ID, 'no such vertex')
    call expect(hsp_topology_get_edges(topology, 1_c_int32_t, counts%edges, edges), HSP_E_ID, 'no such edge')
    call expect(hsp_topology_get_simple_faces(topology, HSP_NONE, 1_c_int32_t, faces), HSP_E_ID, 'no such face')
  end subroutine

  logical function on_sphere(place, ball)
    real(c_double), intent(in) :: place(3)
    integer(c_int32_t), intent(in) :: ball
    on_sphere = abs(norm2(place - xyz(:, hsp_index(ball))) - radius(hsp_index(ball))) < 1e-13_c_double
  end function

  subroutine shells_and_regions()
    type(hsp_shell) :: shells(3)
    type(hsp_component) :: components(2)
    type(hsp_region) :: regions(2)
    type(hsp_totals) :: totals
    integer(c_int32_t) :: needed, around(3), enclosing
    integer :: i
    call expect(hsp_topology_get_shells(topology, shells, 3_c_int32_t, needed), HSP_OK, 'hsp_topology_get_shells')
    call check(needed == 3, 'number of shells')
    call expect(hsp_boundary_measure(boundary, totals=totals, capacity=0_c_int32_t), HSP_OK, 'hsp_boundary_measure')
    call check(abs(sum(shells%area) - totals%area) < 1e-12_c_double, 'areas of shells')
    call check(abs(sum(merge(1, -1, shells%kind == HSP_SHELL_OUTER)*abs(shells%volume)) - totals%volume) < 1e-12_c_double, &
               'volumes of shells')
    call check(count(shells%kind == HSP_SHELL_VOID) == 1, 'one shell around a void')
    call check(all(shells%euler == 2 .and. shells%genus == 0), 'shells without handles')
    call check(sum(shells%simple_faces) == counts%simple_faces .and. sum(shells%edges) == counts%edges, 'parts of shells')
    call check(sum(shells%vertices) == counts%vertices .and. all(shells%faces > 0), 'parts of shells')
    do i = 1, 3
      call check(shells(i)%start_face >= 0 .and. shells(i)%start_face < counts%simple_faces, 'start face of a shell')
      call check(any([on_sphere(shells(i)%point, 0), on_sphere(shells(i)%point, 1), on_sphere(shells(i)%point, 2), &
                      on_sphere(shells(i)%point, 3), on_sphere(shells(i)%point, 4), on_sphere(shells(i)%point, 5), &
                      on_sphere(shells(i)%point, 6), on_sphere(shells(i)%point, 7), on_sphere(shells(i)%point, 8)]), &
                 'point of a shell')
    end do
    call expect(hsp_topology_get_components(topology, components, 2_c_int32_t, needed), HSP_OK, 'hsp_topology_get_components')
    call check(needed == 2, 'number of components')
    call check(components(1)%balls == 8 .and. components(2)%balls == 1, 'balls of components')
    call check(components(1)%top_ball >= 4 .and. components(2)%top_ball == 8, 'top balls')
    call check(components(1)%shells == 2 .and. components(2)%shells == 1 .and. all(components%region == 0), 'shells, regions')
    call check(all(shells(hsp_index(components%outer_shell))%kind == HSP_SHELL_OUTER), 'outer shells')
    call expect(hsp_topology_get_regions(topology, regions, 2_c_int32_t, needed), HSP_OK, 'hsp_topology_get_regions')
    call check(needed == 2 .and. regions(1)%enclosing_shell == HSP_NONE .and. regions(1)%components == 2, 'the outer region')
    call check(regions(1)%shells == 2 .and. regions(2)%shells == 1 .and. regions(2)%components == 0, 'shells of regions')
    enclosing = regions(2)%enclosing_shell
    call check(shells(hsp_index(enclosing))%kind == HSP_SHELL_VOID .and. shells(hsp_index(enclosing))%region == 1, &
        'around the void')
    call check(abs(regions(2)%area - shells(hsp_index(enclosing))%area) < 1e-13_c_double, 'area of the void')
    call check(regions(2)%volume > 0 .and. regions(2)%volume < 0.1_c_double, 'volume of the void')
    call expect(hsp_topology_get_region_shells(topology, 1_c_int32_t, around, 3_c_int32_t, needed), HSP_OK, &
                'hsp_topology_get_region_shells')
    call check(needed == 1 .and. around(1) == enclosing, 'shells around the void')
    call expect(hsp_topology_get_region_shells(topology, 2_c_int32_t, around, 3_c_int32_t, needed), HSP_E_ID, 'no such region')
  end subroutine

  subroutine scan_and_places()
    type(hsp_shell) :: shells(3)
    integer(c_int32_t) :: faces(counts%simple_faces), needed, shell, region
    logical :: seen(0:counts%simple_faces - 1)
    integer :: i
    call expect(hsp_topology_get_shells(topology, shells, 3_c_int32_t, needed), HSP_OK, 'hsp_topology_get_shells')
    seen = .false.
    do shell = 0, 2
      call expect(hsp_topology_get_traversal(topology, shell, faces, counts%simple_faces, needed), HSP_OK, &
        'hsp_topology_get_traversal')
      call check(needed == shells(hsp_index(shell))%simple_faces, 'length of a scan')
      call check(faces(1) == shells(hsp_index(shell))%start_face, 'start of a scan')
      do i = 1, needed
        call check(.not. seen(faces(i)), 'a scan visits no face twice')
        seen(faces(i)) = .true.
      end do
    end do
    call check(all(seen), 'scans visit every face')
    region = 7
    call expect(hsp_topology_locate(topology, middle, region), HSP_OK, 'hsp_topology_locate')
    call check(region == 1, 'the middle lies in the void')
    call expect(hsp_topology_locate(topology, outside, region), HSP_OK, 'locate outside')
    call check(region == 0, 'outside')
    call expect(hsp_topology_locate(topology, apart, region), HSP_OK, 'locate in a ball')
    call check(region == HSP_NONE, 'in a ball')
  end subroutine

  subroutine check_and_errors()
    integer(c_int32_t) :: invariant, id
    type(hsp_topology_limits) :: limits
    integer(c_size_t) :: bytes
    invariant = 7
    id = 7
    call expect(hsp_topology_check(topology, invariant, id), HSP_OK, 'hsp_topology_check')
    call check(invariant == 0 .and. id == HSP_NONE, 'no invariant is broken')
    call expect(hsp_topology_compute(c_null_ptr, boundary), HSP_E_ARGUMENT, 'no topology')
    call expect(hsp_topology_limits_init(limits, int(c_sizeof(limits), c_int32_t), boundary), HSP_OK, 'limits')
    limits%edges = HSP_MAX_BALLS + 1
    call expect(hsp_topology_bytes(limits, bytes), HSP_E_RANGE, 'too many')
    limits%edges = HSP_MAX_BALLS
    limits%shells = HSP_MAX_BALLS + 1
    call expect(hsp_topology_bytes(limits, bytes), HSP_E_RANGE, 'too many shells')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'hsp_boundary_compute')
    call expect(hsp_topology_get_counts(topology, counts), HSP_OK, 'the boundary is that of the same balls')
  end subroutine
end program fortran_topology_test
