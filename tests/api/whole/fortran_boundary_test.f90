! The interface as a Fortran program sees it: every function of the module is called, records arrive field by field,
! optional arguments arrive as null pointers, and errors as statuses.
program fortran_interface_test
  use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_ptr, c_ptr, &
                                         c_size_t, c_sizeof, c_associated, c_null_char
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  use fortran_checks
  use fortran_loops
  use hardsphere
  implicit none

  integer(c_int32_t), parameter :: n = 4
  real(c_double), parameter :: pi = acos(-1.0_c_double)
  ! Three balls with two common points, and one ball apart.
  real(c_double), parameter :: xyz(3, n) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    2.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    1.0_c_double, 1.5_c_double, 0.0_c_double, &
                                                    9.0_c_double, 9.0_c_double, 9.0_c_double], [3, 4])
  real(c_double), parameter :: radius(n) = [1.5_c_double, 1.5_c_double, 1.25_c_double, 0.5_c_double]

  integer(c_int8_t), allocatable, target :: model_memory(:), boundary_memory(:)
  type(c_ptr) :: model, boundary

  call sizes_and_constants()
  call element_radii()
  call model_functions()
  call query_functions()
  call boundary_functions()
  call measure_of_parts()
  call gradient_functions()
  call area_rows()
  call curvatures()
  call contacts_functions()
  call bodies()
  call balls_that_move()
  call reports_errors()
  call report_checks()

contains

  subroutine sizes_and_constants()
    type(hsp_model_options) :: options
    type(hsp_model_info) :: info
    type(hsp_packing) :: figures
    type(hsp_boundary_limits) :: limits
    type(hsp_boundary_counts) :: counts
    type(hsp_vertex) :: vertex
    type(hsp_arc) :: arc
    type(hsp_circle) :: circle
    type(hsp_face) :: face
    type(hsp_loop) :: loop
    type(hsp_loop_arc) :: loop_arc
    type(hsp_ball) :: ball
    type(hsp_totals) :: totals
    type(hsp_energy) :: energy
    type(hsp_area_derivative) :: derivative
    type(c_ptr) :: text
    call check(c_sizeof(options) == 32, 'size of hsp_model_options')
    call check(options%struct_size == c_sizeof(options), 'struct_size of hsp_model_options')
    call check(limits%struct_size == c_sizeof(limits), 'struct_size of hsp_boundary_limits')
    call check(c_sizeof(info) == 64, 'size of hsp_model_info')
    call check(c_sizeof(figures) == 56, 'size of hsp_packing')
    call check(c_sizeof(limits) == 24, 'size of hsp_boundary_limits')
    call check(c_sizeof(counts) == 72, 'size of hsp_boundary_counts')
    call check(c_sizeof(vertex) == 48, 'size of hsp_vertex')
    call check(c_sizeof(arc) == 88, 'size of hsp_arc')
    call check(c_sizeof(circle) == 72, 'size of hsp_circle')
    call check(c_sizeof(face) == 16, 'size of hsp_face')
    call check(c_sizeof(loop) == 20, 'size of hsp_loop')
    call check(c_sizeof(loop_arc) == 12, 'size of hsp_loop_arc')
    call check(c_sizeof(ball) == 16, 'size of hsp_ball')
    call check(c_sizeof(totals) == 32, 'size of hsp_totals')
    call check(c_sizeof(energy) == 48, 'size of hsp_energy')
    call check(c_sizeof(derivative) == 48, 'size of hsp_area_derivative')
    call check(hsp_version() == HSP_VERSION_NUMBER, 'version')
    call check(hsp_abi() == HSP_ABI_NUMBER, 'ABI number')
    call check(hsp_provisional() == HSP_PROVISIONAL_NUMBER, 'provisional number')
    call check(hsp_numerics() == HSP_NUMERICS_NUMBER, 'numerics number')
    call check(hsp_provisional_numerics() == HSP_PROVISIONAL_NUMERICS_NUMBER, 'provisional numerics')
    call check(hsp_model_max_balls() == HSP_MAX_BALLS, 'most balls')
    text = hsp_status_text(HSP_OK)
    call check(c_associated(text), 'status text')
    call check(hsp_status_message(12345_c_int32_t) == 'unknown status', 'text of an unknown status')
    call check(len(hsp_status_message(HSP_E_ID)) > 0, 'text of a known status')
    call check(hsp_index(0_c_int32_t) == 1, 'hsp_index')
    call check(all(hsp_index([3_c_int32_t, 7_c_int32_t]) == [4, 8]), 'hsp_index of an array')
  end subroutine

  subroutine element_radii()
    real(c_double) :: length
    integer(c_int32_t) :: flags
    flags = 7
    call expect(hsp_element_radius(HSP_RADII_BONDI, 8_c_int32_t, length, flags), HSP_OK, 'hsp_element_radius')
    call check(length == 1.52_c_double .and. flags == 0, 'oxygen')
    call expect(hsp_element_radius(HSP_RADII_BONDI, 26_c_int32_t, length, flags), HSP_OK, 'hsp_element_radius of iron')
    call check(length == 2.00_c_double .and. flags == HSP_RADIUS_FALLBACK, 'iron')
    call expect(hsp_element_radius(HSP_RADII_CHEM3D, 20_c_int32_t, length), HSP_OK, 'hsp_element_radius without flags')
    call check(length == 3.48_c_double, 'calcium')
    call expect(hsp_element_radius(2_c_int32_t, 8_c_int32_t, length), HSP_E_ARGUMENT, 'unknown set of radii')
    call expect(hsp_element_radius(HSP_RADII_BONDI, 119_c_int32_t, length), HSP_E_ID, 'no such element')
    call check(length == 3.48_c_double, 'radius after failure')
    call expect(hsp_element_number('Fe'//c_null_char, flags), HSP_OK, 'hsp_element_number')
    call check(flags == 26, 'iron by its symbol')
    call expect(hsp_element_number('X'//c_null_char, flags), HSP_E_ID, 'hsp_element_number of no element')
    call check(c_associated(hsp_element_symbol(26_c_int32_t)), 'hsp_element_symbol')
    call expect(hsp_residue_radius(HSP_RADII_PROTOR, 'ASP'//c_null_char, 'OD2'//c_null_char, length), HSP_OK, &
      'hsp_residue_radius')
    call check(length == 1.46_c_double, 'an oxygen of aspartate')
    call expect(hsp_residue_get_atoms(HSP_RADII_NACCESS, capacity=0_c_int32_t, needed=flags), HSP_E_CAPACITY, &
      'hsp_residue_get_atoms')
    call check(flags > 200, 'atoms of a set')
  end subroutine

  subroutine model_functions()
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: bad
    type(hsp_model_options) :: options
    type(hsp_model_info) :: info
    type(hsp_packing) :: figures
    call expect(hsp_model_bytes(n, bytes), HSP_OK, 'hsp_model_bytes')
    call check(bytes > 0 .and. bytes <= hsp_model_bytes_bound(n), 'hsp_model_bytes_bound')
    ! odd memory: one byte more, and the handle begins at the second
    allocate (model_memory(bytes + 1))
    call expect(hsp_model_init(c_loc(model_memory(2)), bytes, n, model), HSP_OK, 'hsp_model_init')
    call expect(hsp_model_set(model, 0_c_int32_t), HSP_OK, 'hsp_model_set of nothing')
    bad = 7
    call expect(hsp_model_set(model, n, xyz, radius, first_bad=bad), HSP_OK, 'hsp_model_set')
    call check(bad == HSP_NONE, 'first_bad')
    call expect(hsp_model_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'hsp_model_options_init')
    call check(options%struct_size == 32 .and. options%largest_radius == 0 .and. options%reserved == 0, 'options')
    options%probe = 0.25_c_double
    options%step = 1e-6_c_double
    call expect(hsp_model_set(model, n, xyz, radius, options), HSP_OK, 'hsp_model_set with options')
    call expect(hsp_model_get_info(model, info), HSP_OK, 'hsp_model_get_info')
    call check(info%balls == n, 'info%balls')
    call check(info%cubes >= 2 .and. info%cubes <= n .and. info%table_slots >= 2*info%cubes, 'info%cubes')
    call check(info%longest_probe >= 1, 'info%longest_probe')
    call check(abs(info%step - 1e-6_c_double) < 1e-20_c_double, 'info%step')
    call check(abs(info%probe - 0.25_c_double) < 1e-14_c_double, 'info%probe')
    call check(abs(info%largest_radius - 1.75_c_double) < 1e-14_c_double, 'info%largest_radius')
    call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'hsp_model_set without options')
    call expect(hsp_model_get_packing(model, figures), HSP_OK, 'hsp_model_get_packing')
    call check(abs(figures%k - 3) < 1e-14_c_double, 'figures%k')
    call check(abs(figures%rho - sqrt(3.25_c_double)/1.5_c_double) < 1e-14_c_double, 'figures%rho')
    call check(abs(figures%mean_overlaps - 1.5_c_double) < 1e-14_c_double, 'figures%mean_overlaps')
    call check(abs(figures%neighbour_bound/(216*(figures%k/figures%rho)**3) - 1) < 1e-14_c_double, 'figures%neighbour_bound')
    call check(figures%max_overlaps == 2 .and. figures%flags == 0, 'figures%max_overlaps')
  end subroutine

  subroutine query_functions()
    integer(c_int32_t) :: ids(n), first(n + 1), pairs(6), needed, meets
    type(hsp_ray_hit) :: hit
    ids = -7
    call expect(hsp_query_point(model, xyz(:, 1), ids, n, needed), HSP_OK, 'hsp_query_point')
    call check(needed == 1 .and. ids(1) == 0 .and. ids(2) == -7, 'hits of a point')
    call check(abs(radius(hsp_index(ids(1))) - 1.5_c_double) < 1e-14_c_double, 'radius of a hit')
    call expect(hsp_query_point(model, xyz(:, 1), capacity=0_c_int32_t, needed=needed), HSP_E_CAPACITY, 'query of the number')
    call check(needed == 1, 'number of hits')
    call expect(hsp_query_ball(model, [0.0_c_double, 0.0_c_double, 0.0_c_double], 0.5_c_double, ids, n, needed), HSP_OK, &
                'hsp_query_ball')
    call check(needed == 2, 'hits of a ball')
    call check(all(ids(1:2) == [0, 1]), 'ids of the hits of a ball')
    call expect(hsp_query_meets(model, xyz(:, 4), 0.0_c_double, meets), HSP_OK, 'hsp_query_meets')
    call check(meets == 1, 'meets')
    call expect(hsp_query_meets(model, 2*xyz(:, 4), 1.0_c_double, meets), HSP_OK, 'hsp_query_meets')
    call check(meets == 0, 'meets not')
    call expect(hsp_query_neighbours(model, 1_c_int32_t, ids, n, needed), HSP_OK, 'hsp_query_neighbours')
    call check(needed == 2, 'neighbours')
    call check(all(ids(1:2) == [0, 2]), 'ids of neighbours')
    call expect(hsp_query_neighbours(model, 3_c_int32_t, capacity=0_c_int32_t, needed=needed), HSP_OK, 'no neighbours')
    call check(needed == 0, 'no neighbours')
    call expect(hsp_query_pairs(model, 0_c_int32_t, first, capacity=0_c_int32_t, needed=needed), HSP_E_CAPACITY, &
                'number of pairs')
    call check(needed == 6 .and. all(first == [0, 2, 4, 6, 6]), 'where the rows of pairs begin')
    call expect(hsp_query_pairs(model, 0_c_int32_t, first, pairs, 6_c_int32_t, needed), HSP_OK, 'hsp_query_pairs')
    call check(all(pairs(first(2) + 1:first(3)) == [0, 2]), 'the row of ball 1')
    call expect(hsp_query_pairs(model, HSP_PAIRS_ONCE, first, pairs, 3_c_int32_t, needed), HSP_OK, 'pairs once')
    call check(all(first == [0, 2, 3, 3, 3]) .and. all(pairs(1:3) == [1, 2, 2]), 'pairs once')
    call check(c_sizeof(hit) == 40, 'size of hsp_ray_hit')
    call expect(hsp_query_ray(model, xyz(:, 4) - [50, 0, 0], [0.25_c_double, 0.0_c_double, 0.0_c_double], hit), HSP_OK, &
                'hsp_query_ray')
    call check(hit%ball == 3 .and. abs(hit%distance - (50 - radius(4))) < 1e-12_c_double, 'first on a ray')
    call check(all(abs(hit%xyz - (xyz(:, 4) - [radius(4), 0.0_c_double, 0.0_c_double])) < 1e-12_c_double), 'where it is')
    call expect(hsp_query_ray(model, xyz(:, 4), [0.0_c_double, 0.0_c_double, 0.0_c_double], hit), HSP_E_RANGE, 'no direction')
  end subroutine

  subroutine boundary_functions()
    integer(c_size_t) :: bytes
    type(hsp_boundary_limits) :: limits, needed_limits
    type(hsp_boundary_counts) :: counts
    type(hsp_vertex) :: vertices(2)
    type(hsp_arc) :: arcs(3)
    type(hsp_circle) :: circles(1)
    type(hsp_face) :: faces(4)
    type(hsp_loop) :: loops(3)
    type(hsp_loop_arc) :: loop_arcs(6)
    type(hsp_ball) :: balls(n)
    type(hsp_totals) :: totals
    real(c_double) :: area(n), volume(n)
    type(hsp_executor), target :: executor
    type(hsp_boundary_request) :: request
    integer(c_int32_t), target :: runs
    integer(c_int32_t) :: needed, invariant, id
    integer :: v, b
    runs = 0
    call expect(hsp_boundary_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_boundary_limits_init')
    call check(limits%balls == n .and. limits%neighbours == n .and. limits%vertices == 96 .and. limits%circles == 24, &
               'default limits')
    call expect(hsp_boundary_bytes(limits, bytes), HSP_OK, 'hsp_boundary_bytes')
    call check(bytes > 0 .and. bytes <= hsp_boundary_bytes_bound(n, n, 96_c_int32_t, 24_c_int32_t), 'boundary bytes')
    allocate (boundary_memory(bytes))
    call expect(hsp_boundary_init(c_loc(boundary_memory), bytes, limits, boundary), HSP_OK, 'hsp_boundary_init')
    call expect(hsp_boundary_get_counts(boundary, counts), HSP_E_STATE, 'nothing computed')
    needed_limits%struct_size = int(c_sizeof(needed_limits), c_int32_t)
    call expect(hsp_boundary_compute(boundary, model, needed_limits), HSP_OK, 'hsp_boundary_compute')
    call check(needed_limits%neighbours == 2 .and. needed_limits%vertices == 2 .and. needed_limits%circles == 0, 'needed')
    ! by more workers than there is room for, and then by two
    executor = hsp_executor(workers=2, context=c_loc(runs), run=c_funloc(run_backwards))
    request = hsp_boundary_request(int(c_sizeof(request), c_int32_t), 0, c_loc(executor), c_null_ptr)
    call expect(hsp_boundary_compute_with(boundary, model, request, limits), HSP_E_CAPACITY, 'room for one')
    call check(limits%workers == 2 .and. limits%vertices == 96 .and. runs == 0, 'limits for two workers')
    call expect(hsp_boundary_bytes(limits, bytes), HSP_OK, 'hsp_boundary_bytes')
    deallocate (boundary_memory)
    allocate (boundary_memory(bytes))
    call expect(hsp_boundary_init(c_loc(boundary_memory), bytes, limits, boundary), HSP_OK, 'hsp_boundary_init')
    call expect(hsp_boundary_compute_with(boundary, model, request, needed_limits), HSP_OK, 'hsp_boundary_compute_with')
    call check(needed_limits%vertices == 2 .and. needed_limits%workers == 2 .and. runs > 0, 'needed by two workers')
    executor%run = c_funloc(run_nothing)
    call expect(hsp_boundary_compute_with(boundary, model, request), HSP_E_EXECUTOR, 'a loop that does nothing')
    call expect(hsp_boundary_compute_with(boundary, model), HSP_OK, 'no request')
    call expect(hsp_boundary_get_counts(boundary, counts), HSP_OK, 'hsp_boundary_get_counts')
    call check(counts%balls == n .and. counts%exposed_balls == n .and. counts%contained_balls == 0, 'counts of balls')
    call check(counts%vertices == 2 .and. counts%arcs == 3 .and. counts%circles == 0, 'counts of vertices and arcs')
    call check(counts%faces == 4 .and. counts%loops == 3 .and. counts%shells == 2, 'counts of faces')
    call check(counts%components == 2 .and. counts%voids == 0 .and. counts%tied_vertices == 0, 'counts of components')
    call check(counts%euler == 4_c_int64_t, 'euler')

    call expect(hsp_boundary_get_vertices(boundary, vertices, 2_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_vertices')
    call check(needed == 2, 'number of vertices')
    do v = 1, 2
      call check(all(vertices(v)%ball == [0, 1, 2]), 'balls of a vertex')
      do b = 1, 3
        call check(abs(norm2(vertices(v)%xyz - xyz(:, hsp_index(vertices(v)%ball(b)))) &
                       - radius(hsp_index(vertices(v)%ball(b)))) < 1e-13_c_double, 'a vertex lies on its spheres')
      end do
      ! the centres lie in the plane z = 0, and (c_b - c_a) x (c_c - c_a) points up
      call check(abs(vertices(v)%sign) == 1 .and. vertices(v)%sign*vertices(v)%xyz(3) > 0, 'sign of a vertex')
      call check(vertices(v)%flags == 0 .and. vertices(v)%reserved == 0, 'flags of a vertex')
    end do
    call check(vertices(1)%sign /= vertices(2)%sign, 'two vertices of the same balls')

    call expect(hsp_boundary_get_arcs(boundary, arcs, 3_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_arcs')
    call check(needed == 3, 'number of arcs')
    do v = 1, 3
      call check(arcs(v)%ball(1) < arcs(v)%ball(2) .and. arcs(v)%vertex(1) /= arcs(v)%vertex(2), 'balls and ends of an arc')
      call check(arcs(v)%angle > 0 .and. arcs(v)%angle < 2*pi, 'angle of an arc')
      call check(all(arcs(v)%face >= 0 .and. arcs(v)%face < 4), 'faces of an arc')
      call check(abs(norm2(arcs(v)%axis) - 1) < 1e-14_c_double, 'axis of an arc')
      do b = 1, 2
        call check(abs(norm2(vertices(hsp_index(arcs(v)%vertex(b)))%xyz - arcs(v)%centre) - arcs(v)%radius) &
                   < 1e-13_c_double, 'an arc ends on its circle')
      end do
    end do
    call expect(hsp_boundary_get_circles(boundary, circles, 1_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_circles')
    call check(needed == 0, 'number of circles')
    call expect(hsp_boundary_get_circles(boundary, capacity=0_c_int32_t, needed=needed), HSP_OK, 'no circles, no array')
    call expect(hsp_boundary_get_faces(boundary, faces, 4_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_faces')
    call check(needed == 4, 'number of faces')
    call check(all(faces%shell >= 0 .and. faces%shell < 2), 'shells of faces')
    call expect(hsp_boundary_get_loops(boundary, loops, 3_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_loops')
    call check(needed == 3, 'number of loops')
    call expect(hsp_boundary_get_loop_arcs(boundary, loop_arcs, 6_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_loop_arcs')
    call check(needed == 6, 'number of arcs of loops')
    do v = 1, 3
      call check(all([loops(v)%circle, loops(v)%side, loops(v)%first_arc, loops(v)%arcs] == [HSP_NONE, 0, 2*(v - 1), 2]), &
                 'fields of a loop')
      call check(faces(hsp_index(loops(v)%face))%first_loop == v - 1, 'first_loop of a face')
      do b = 2*v - 1, 2*v
        associate (at => loop_arcs(b), arc => arcs(hsp_index(loop_arcs(b)%arc)))
          call check(arc%face(hsp_index(at%side)) == loops(v)%face, 'side of an arc of a loop')
          call check(arc%vertex(hsp_index(1_c_int32_t - at%side)) == at%vertex, 'vertex of an arc of a loop')
        end associate
      end do
      call check(loop_arcs(2*v - 1)%vertex /= loop_arcs(2*v)%vertex, 'a loop passes two vertices')
    end do
    call expect(hsp_boundary_get_balls(boundary, balls, n, needed), HSP_OK, 'hsp_boundary_get_balls')
    call check(needed == n, 'number of balls')
    do b = 1, n
      call check(balls(b)%faces == 1 .and. hsp_index(faces(hsp_index(balls(b)%first_face))%ball) == b, 'face of a ball')
      call check(faces(hsp_index(balls(b)%first_face))%loops == merge(0, 1, b == 4), 'loops of a face')
    end do
    call check(balls(1)%component == balls(3)%component .and. balls(1)%component /= balls(4)%component, 'components')

    call expect(hsp_boundary_measure(boundary, totals=totals, area=area, volume_term=volume, capacity=n), HSP_OK, &
        'hsp_boundary_measure')
    call check(abs(area(4) - pi) < 1e-14_c_double .and. abs(volume(4) - pi/6) < 1e-14_c_double, 'the ball apart')
    call check(abs(sum(area) - totals%area) < 1e-12_c_double .and. abs(sum(volume) - totals%volume) < 1e-12_c_double, 'totals')
    totals%area = 0
    call expect(hsp_boundary_measure(boundary, totals=totals, capacity=0_c_int32_t), HSP_OK, 'totals alone')
    call check(totals%area > pi, 'totals alone')
    area = 0
    call expect(hsp_boundary_measure(boundary, area=area, capacity=n), HSP_OK, 'areas alone')
    call check(all(area > 0), 'areas alone')
    invariant = 7
    id = 7
    call expect(hsp_boundary_check(boundary, invariant, id), HSP_OK, 'hsp_boundary_check')
    call check(invariant == 0 .and. id == HSP_NONE, 'no invariant is broken')
    call two_balls_circle()
  end subroutine

  ! The fields of a circle: two equal balls, 2 apart.
  subroutine two_balls_circle()
    type(hsp_circle) :: circle(1)
    type(hsp_loop) :: loops(2)
    integer(c_int32_t) :: needed
    call expect(hsp_model_set(model, 2_c_int32_t, xyz, radius), HSP_OK, 'two balls')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'two balls')
    call expect(hsp_boundary_get_circles(boundary, circle, 1_c_int32_t, needed), HSP_OK, 'two balls')
    call check(needed == 1, 'one circle')
    call check(all(abs(circle(1)%centre - [1, 0, 0]) < 1e-14_c_double), 'centre of a circle')
    call check(all(abs(circle(1)%axis - [1, 0, 0]) < 1e-14_c_double), 'axis of a circle')
    call check(abs(circle(1)%radius - sqrt(1.25_c_double)) < 1e-14_c_double, 'radius of a circle')
    call check(all(circle(1)%ball == [0, 1]), 'balls of a circle')
    call check(circle(1)%face(1) /= circle(1)%face(2), 'faces of a circle')
    call expect(hsp_boundary_get_loops(boundary, loops, 2_c_int32_t, needed), HSP_OK, 'loops of one circle')
    call check(needed == 2 .and. all(loops%circle == 0) .and. all(loops%arcs == 0), 'loops of one circle')
    call check(circle(1)%face(hsp_index(loops(1)%side)) == loops(1)%face .and. loops(2)%side == 1 - loops(1)%side, &
               'sides of one circle')
  end subroutine

  subroutine compute_all()
    call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'hsp_model_set')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'hsp_boundary_compute')
  end subroutine

  subroutine measure_of_parts()
    type(hsp_totals) :: totals
    type(hsp_face) :: faces(4)
    real(c_double) :: all_area(n), all_volume(n), area(n), volume(n), face_area(4), face_volume(4)
    real(c_double), target :: own_area(n)
    type(hsp_totals), target :: own_totals
    type(hsp_measure_request) :: request
    type(hsp_measure_outputs) :: outputs
    integer(c_int8_t), allocatable, target :: memory(:)
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: needed, f
    integer(c_int8_t), target :: selected(n)
    selected = [0_c_int8_t, 1_c_int8_t, 0_c_int8_t, -1_c_int8_t]
    call compute_all()
    call expect(hsp_boundary_measure(boundary, area=all_area, volume_term=all_volume, capacity=n), HSP_OK, 'all balls')
    call expect(hsp_boundary_measure(boundary, selected, totals, area, volume, n), HSP_OK, &
                'hsp_boundary_measure')
    call check(all(area == merge(all_area, 0.0_c_double, selected /= 0)), 'areas of selected balls')
    call check(all(volume == merge(all_volume, 0.0_c_double, selected /= 0)), 'volume terms of selected balls')
    call check(abs(totals%area - all_area(2) - all_area(4)) < 1e-13_c_double, 'area of selected balls')
    call check(abs(totals%volume - all_volume(2) - all_volume(4)) < 1e-13_c_double, 'volume of selected balls')
    request = hsp_measure_request(int(c_sizeof(request), c_int32_t), 0, c_loc(selected), c_null_ptr)
    outputs = hsp_measure_outputs(int(c_sizeof(outputs), c_int32_t), n, 0, 0, c_loc(own_totals), c_loc(own_area), c_null_ptr)
    call expect(hsp_boundary_get_measures(boundary, request, outputs), HSP_OK, 'hsp_boundary_get_measures')
    call check(all(own_area == area) .and. own_totals%volume == totals%volume .and. outputs%needed == n, 'by a request')
    call expect(hsp_areas_bytes(n, bytes), HSP_OK, 'hsp_areas_bytes')
    call check(bytes <= hsp_areas_bytes_bound(n), 'bytes for areas')
    allocate (memory(bytes))
    call expect(hsp_areas(n, xyz, radius, 0.0_c_double, c_loc(memory), bytes, totals, area), HSP_OK, 'hsp_areas')
    call check(all(area == all_area) .and. abs(totals%volume - sum(all_volume)) < 1e-12_c_double, 'areas in one call')
    bytes = 0
    call expect(hsp_areas(n, xyz, radius, 0.0_c_double, c_null_ptr, bytes), HSP_E_CAPACITY, 'bytes for areas')
    call check(bytes == size(memory, kind=c_size_t), 'bytes for areas')
    area = -1
    call expect(hsp_boundary_measure(boundary, area=area, capacity=n), HSP_OK, 'no selection selects all')
    call check(all(area == all_area), 'no selection selects all')
    call expect(hsp_boundary_measure_faces(boundary, face_area, face_volume, 4_c_int32_t), HSP_OK, &
                'hsp_boundary_measure_faces')
    call expect(hsp_boundary_get_faces(boundary, faces, 4_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_faces')
    do f = 1, 4
      call check(abs(face_area(f) - all_area(hsp_index(faces(f)%ball))) < 1e-13_c_double, 'area of a ball''s only face')
      call check(abs(face_volume(f) - all_volume(hsp_index(faces(f)%ball))) < 1e-13_c_double, 'volume of a face')
    end do
    call expect(hsp_boundary_measure_faces(boundary, volume_term=face_volume, capacity=3_c_int32_t), HSP_E_CAPACITY, 'faces')
  end subroutine

  subroutine gradient_functions()
    real(c_double), parameter :: sigma(n) = [1.0_c_double, -2.0_c_double, 0.5_c_double, 3.0_c_double]
    real(c_double), parameter :: h = 1e-4_c_double
    type(hsp_energy) :: energy
    type(hsp_totals) :: totals
    real(c_double) :: centre(3, n), by_radius(n), area(n), moved(3, n), at(-1:1)
    real(c_double) :: area_centre(3, n), area_radius(n), volume_centre(3, n), volume_radius(n)
    real(c_double), target :: own_centre(3, n), own_radius(n), weights(n)
    type(hsp_energy), target :: own_energy
    type(hsp_gradient_request) :: request
    type(hsp_gradient_outputs) :: outputs
    integer(c_int32_t), target :: own_flags(n)
    integer(c_int32_t) :: flags(n), needed, first_bad
    integer :: axis, step
    call compute_all()
    flags = 7
    call expect(hsp_boundary_get_gradient(boundary, sigma=sigma, tension=0.5_c_double, pressure=2.0_c_double, &
                                          energy=energy, d_centre=centre, d_radius=by_radius, flags=flags, capacity=n), &
                HSP_OK, 'a gradient by named arguments')
    weights = sigma
    request = hsp_gradient_request(tension=0.5_c_double, pressure=2.0_c_double, sigma=c_loc(weights))
    outputs = hsp_gradient_outputs(capacity=n, energy=c_loc(own_energy), d_centre=c_loc(own_centre), &
                                   d_radius=c_loc(own_radius), flags=c_loc(own_flags))
    call check(request%struct_size == c_sizeof(request) .and. outputs%struct_size == c_sizeof(outputs), 'sizes as made')
    call expect(hsp_boundary_get_gradient(boundary, request, outputs), HSP_OK, 'hsp_boundary_get_gradient')
    call check(outputs%needed == n .and. outputs%first_bad == HSP_NONE, 'needed by a request')
    call check(all(own_centre == centre) .and. all(own_radius == by_radius) .and. all(own_flags == flags) .and. &
               own_energy%value == energy%value .and. own_energy%d_probe == energy%d_probe, 'a gradient by a request')
    call expect(hsp_boundary_get_derivatives(boundary, sigma=sigma, area_centre=area_centre, area_radius=area_radius, &
                                             volume_centre=volume_centre, volume_radius=volume_radius, capacity=n, &
                                             needed=needed, first_bad=first_bad), HSP_OK, 'hsp_boundary_get_derivatives')
    call check(needed == n .and. first_bad == HSP_NONE, 'all weights are numbers')
    call check(all(abs(0.5_c_double*area_centre + 2*volume_centre - centre) < 1e-12_c_double) .and. &
               all(abs(0.5_c_double*area_radius + 2*volume_radius - by_radius) < 1e-12_c_double), 'the parts of a gradient')
    call expect(hsp_boundary_measure(boundary, totals=totals, area=area, capacity=n), HSP_OK, 'hsp_boundary_measure')
    call check(abs(energy%area - sum(sigma*area)) < 1e-12_c_double, 'energy%area')
    call check(abs(energy%volume - totals%volume) < 1e-12_c_double, 'energy%volume')
    call check(abs(energy%value - 0.5_c_double*energy%area - 2*energy%volume) < 1e-12_c_double, 'energy%value')
    call check(abs(energy%d_probe - sum(by_radius)) < 1e-11_c_double, 'energy%d_probe')
    call check(all(flags == 0), 'no balls touch')
    call check(all(abs(sum(centre, dim=2)) < 1e-12_c_double), 'forces sum to nothing')
    call check(all(centre(:, 4) == 0), 'nothing pulls the ball apart')
    call check(abs(by_radius(4) - 1.5_c_double*4*pi - 2*pi) < 1e-12_c_double, 'radius of the ball apart')
    do axis = 1, 3
      do step = -1, 1, 2
        moved = xyz
        moved(axis, 3) = moved(axis, 3) + step*h
        call expect(hsp_model_set(model, n, moved, radius), HSP_OK, 'moved')
        call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'moved')
        call expect(hsp_boundary_measure(boundary, totals=totals, area=area, capacity=n), HSP_OK, 'moved')
        at(step) = 0.5_c_double*sum(sigma*area) + 2*totals%volume
      end do
      call check(abs((at(1) - at(-1))/(2*h) - centre(axis, 3)) < 1e-5_c_double, 'centre against differences')
    end do
    call compute_all()
    energy%value = 0
    call expect(hsp_boundary_get_gradient(boundary, tension=1.0_c_double, tangency=HSP_TANGENT_DISJOINT, energy=energy), &
                HSP_OK, 'energy')
    call expect(hsp_boundary_measure(boundary, totals=totals, capacity=0_c_int32_t), HSP_OK, 'totals')
    call check(abs(energy%value - totals%area) < 1e-12_c_double, 'without weights all are 1')
    call expect(hsp_boundary_get_gradient(boundary, sigma=sigma, tangency=2_c_int32_t), HSP_E_ARGUMENT, 'unknown tangency')
    call expect(hsp_boundary_get_gradient(boundary, tension=ieee_value(pi, ieee_quiet_nan)), HSP_E_NOT_FINITE, &
                'tension that is no number')
    needed = 12345
    call expect(hsp_boundary_get_gradient(boundary, d_centre=centre, capacity=n - 1, needed=needed), HSP_E_CAPACITY, 'room')
    call check(needed == n, 'needed by named arguments')
    call touching_balls()
  end subroutine

  ! Both derivatives where two balls touch: radii 1.5 and 0.5, hence 2 pi r s / (r + s) for each of the two areas.
  subroutine touching_balls()
    real(c_double), parameter :: places(3, 2) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                         0.0_c_double, 2.0_c_double, 0.0_c_double], [3, 2])
    real(c_double), parameter :: radii(2) = [1.5_c_double, 0.5_c_double]
    real(c_double) :: centre(3, 2)
    integer(c_int32_t) :: flags(2)
    call expect(hsp_model_set(model, 2_c_int32_t, places, radii), HSP_OK, 'touching balls')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'touching balls')
    call expect(hsp_boundary_get_gradient(boundary, tension=1.0_c_double, d_centre=centre, flags=flags, &
                                          capacity=2_c_int32_t), HSP_OK, 'touching balls')
    call check(all(flags == HSP_GRADIENT_ONE_SIDED), 'flags of touching balls')
    call check(abs(centre(2, 2) - 1.5_c_double*pi) < 1e-13_c_double, 'touching balls as if they met')
    call expect(hsp_boundary_get_gradient(boundary, tension=1.0_c_double, tangency=HSP_TANGENT_DISJOINT, d_centre=centre, &
                                          capacity=2_c_int32_t), HSP_OK, 'apart')
    call check(all(centre == 0), 'touching balls as if they were apart')
  end subroutine

  subroutine area_rows()
    type(hsp_area_derivative) :: row(3)
    type(hsp_arc) :: arcs(3)
    real(c_double) :: centre(3, n), sigma(n), entry(3, 10)
    integer(c_int32_t) :: needed, first(n + 1), ball(10)
    call compute_all()
    call expect(hsp_boundary_get_area_row(boundary, 1_c_int32_t, HSP_TANGENT_OVERLAP, capacity=0_c_int32_t, &
                                          needed=needed), HSP_E_CAPACITY, 'length of a row')
    call check(needed == 3, 'length of a row')
    call expect(hsp_boundary_get_area_row(boundary, 1_c_int32_t, HSP_TANGENT_OVERLAP, row, 3_c_int32_t, needed), HSP_OK, &
                'hsp_boundary_get_area_row')
    call check(all(row%ball == [0, 1, 2]) .and. all(row%flags == 0), 'balls and flags of a row')
    call expect(hsp_boundary_get_arcs(boundary, arcs, 3_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_arcs')
    call check(abs(sum(pack(arcs%angle, arcs%ball(1) == 0 .and. arcs%ball(2) == 1)) - row(1)%angle) < 1e-13_c_double, &
               'angle of an entry')
    call check(row(2)%angle == 0, 'angle of the ball itself')
    sigma = [0, 1, 0, 0]
    call expect(hsp_boundary_get_gradient(boundary, sigma=sigma, tension=1.0_c_double, d_centre=centre, capacity=n), &
                HSP_OK, 'gradient of one area')
    call check(all(abs(centre(:, 1) - row(1)%centre) < 1e-13_c_double), 'first entry is the gradient')
    call check(all(abs(centre(:, 2) - row(2)%centre) < 1e-13_c_double), 'second entry is the gradient')
    call check(all(abs(centre(:, 3) - row(3)%centre) < 1e-13_c_double), 'third entry is the gradient')
    call check(row(1)%radius < 0 .and. row(2)%radius > 0 .and. row(3)%radius < 0, 'neighbours take area away')
    call expect(hsp_boundary_get_area_rows(boundary, first=first, ball=ball, d_centre=entry, capacity=10_c_int32_t, &
                                           needed=needed), HSP_OK, 'hsp_boundary_get_area_rows')
    call check(needed == 10 .and. all(first == [0, 3, 6, 9, 10]) .and. all(ball(4:6) == [0, 1, 2]), 'rows')
    call check(all(entry(:, 4) == row(1)%centre) .and. all(entry(:, 6) == row(3)%centre), 'entries of a row among all')
    call expect(hsp_boundary_get_area_row(boundary, n, HSP_TANGENT_DISJOINT, row, 3_c_int32_t, needed), HSP_E_ID, 'no ball')
    call expect(hsp_boundary_get_area_row(boundary, 3_c_int32_t, HSP_TANGENT_DISJOINT, row, 3_c_int32_t, needed), HSP_OK, &
                'row of the ball apart')
    call check(needed == 1 .and. row(1)%ball == 3 .and. abs(row(1)%radius - 4*pi) < 1e-13_c_double, 'row of one entry')
  end subroutine

  subroutine curvatures()
    type(hsp_curvatures) :: totals
    type(hsp_morphometric_energy) :: energy
    real(c_double) :: mean(n), d_centre(3, n), d_radius(n), sigma(n)
    integer(c_int32_t) :: thirds(n), flags(n), needed, first_bad
    call expect(hsp_boundary_curvature(boundary, totals, mean, thirds, n, needed), HSP_OK, 'hsp_boundary_curvature')
    call check(needed == n, 'needed of curvatures')
    call check(abs(sum(mean) - totals%mean) < 1e-12_c_double, 'sum of mean curvatures')
    call check(sum(thirds) == 24, 'Gauss-Bonnet')
    call check(abs(totals%gauss - 8*pi) < 1e-13_c_double, 'Gaussian curvature')
    call check(abs(mean(4) - 2*pi) < 1e-14_c_double, 'mean curvature of a ball alone')
    sigma = 1
    call expect(hsp_boundary_get_morphometry(boundary, sigma=sigma, bending=1.0_c_double, energy=energy, &
                                             d_centre=d_centre, d_radius=d_radius, flags=flags, capacity=n, &
                                             needed=needed, first_bad=first_bad), HSP_OK, 'hsp_boundary_get_morphometry')
    call check(first_bad == HSP_NONE .and. all(flags == 0), 'flags of a morphometric energy')
    call check(abs(energy%value - totals%mean) < 1e-12_c_double, 'bending energy')
    call check(abs(sum(d_radius*radius) + sum(d_centre*xyz) - energy%mean) < 1e-12_c_double, 'homogeneity')
    call check(maxval(abs(sum(d_centre, dim=2))) < 1e-13_c_double, 'sum of derivatives')
    call expect(hsp_boundary_get_morphometry(boundary, bending=1.0_c_double), HSP_OK, 'nothing asked')
  end subroutine

  ! The ball apart comes to the others and goes back.
  subroutine balls_that_move()
    type(c_ptr) :: moving
    type(hsp_moving_limits) :: limits
    type(hsp_moving_info) :: info
    type(hsp_moving_ball) :: ball(2)
    type(hsp_totals) :: totals, before, of_boundary
    type(hsp_energy) :: energy
    integer(c_int8_t), allocatable, target :: memory(:)
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: needed, changed(n), flags(n), first_bad
    real(c_double) :: area(n), volume(n), d_centre(3, n), d_radius(n)
    real(c_double), parameter :: near_to_others(3, 1) = reshape([3.5_c_double, 0.0_c_double, 0.0_c_double], [3, 1])
    call expect(hsp_moving_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_moving_limits_init')
    call expect(hsp_moving_bytes(limits, bytes), HSP_OK, 'hsp_moving_bytes')
    call check(bytes <= hsp_moving_bytes_bound(n, limits%neighbours), 'hsp_moving_bytes_bound')
    allocate (memory(bytes))
    call expect(hsp_moving_init(c_loc(memory), bytes, limits, moving), HSP_OK, 'hsp_moving_init')
    call expect(hsp_moving_set(moving, model, tension=1.0_c_double, pressure=0.0_c_double, &
                               tangency=HSP_TANGENT_OVERLAP, limits=limits, first_bad=first_bad), HSP_OK, 'hsp_moving_set')
    call check(limits%neighbours == 2 .and. first_bad == HSP_NONE, 'limits that were needed')
    call expect(hsp_moving_measure(moving, before, area, volume, n, needed), HSP_OK, 'hsp_moving_measure')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'hsp_boundary_compute')
    call expect(hsp_boundary_measure(boundary, totals=of_boundary, capacity=0_c_int32_t), HSP_OK, 'its totals')
    call check(needed == n .and. before%area == of_boundary%area .and. before%volume == of_boundary%volume, 'the same bits')
    call check(abs(area(4) - pi) < 1e-15_c_double, 'a ball alone')
    call expect(hsp_moving_move(moving, 1_c_int32_t, [3_c_int32_t], near_to_others, first_bad=first_bad), HSP_OK, &
                'hsp_moving_move')
    call expect(hsp_moving_get_info(moving, info), HSP_OK, 'hsp_moving_get_info')
    call check(info%balls == n .and. info%components == 1 .and. info%changed == 2, 'what has changed')
    call check(info%vertices == 2 .and. info%circles == 1, 'what there is')
    call expect(hsp_moving_get_changed(moving, changed, n, needed), HSP_OK, 'hsp_moving_get_changed')
    call check(needed == 2 .and. all(changed(1:2) == [1, 3]), 'which have changed')
    call expect(hsp_moving_gradient(moving, energy, d_centre, d_radius, flags, n, needed), HSP_OK, 'hsp_moving_gradient')
    call expect(hsp_moving_get_balls(moving, 2_c_int32_t, changed, ball), HSP_OK, 'hsp_moving_get_balls')
    call check(all(ball(2)%d_centre == d_centre(:, 4)) .and. ball(2)%faces == 1 .and. all(flags == 0), 'a ball')
    call check(abs(ball(2)%centre(1) - 3.5_c_double) < 1e-14_c_double, 'where it is')
    call expect(hsp_moving_get_model(moving, model), HSP_OK, 'hsp_moving_get_model')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'hsp_boundary_compute')
    call expect(hsp_boundary_measure(boundary, totals=of_boundary, capacity=0_c_int32_t), HSP_OK, 'its totals')
    call check(energy%area == of_boundary%area, 'the same bits after a move')
    call expect(hsp_moving_undo(moving), HSP_OK, 'hsp_moving_undo')
    call expect(hsp_moving_measure(moving, totals, capacity=0_c_int32_t), HSP_OK, 'totals alone')
    call check(totals%area == before%area .and. totals%volume == before%volume, 'as before')
    call expect(hsp_moving_undo(moving), HSP_E_STATE, 'nothing to take back')
    call expect(hsp_moving_get_model(moving, model), HSP_OK, 'the balls as they were')
  end subroutine

  subroutine bodies()
    type(c_ptr) :: body
    type(hsp_pose) :: pose(2)
    type(hsp_rational_pose) :: rational(2)
    type(hsp_body_gap) :: gap(2)
    type(hsp_body_overlap) :: overlap(2)
    integer(c_int8_t), allocatable, target :: memory(:)
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: hit(2), pair(2, n), needed, first_bad
    real(c_double), parameter :: quarter(3, 3) = reshape([0.0_c_double, 1.0_c_double, 0.0_c_double, -1.0_c_double, &
      0.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double, 1.0_c_double], [3, 3])
    call expect(hsp_body_bytes(n, bytes), HSP_OK, 'hsp_body_bytes')
    call check(bytes <= hsp_body_bytes_bound(n), 'hsp_body_bytes_bound')
    allocate (memory(bytes))
    call expect(hsp_body_init(c_loc(memory), bytes, n, body), HSP_OK, 'hsp_body_init')
    call expect(hsp_body_set(body, model), HSP_OK, 'hsp_body_set')
    pose(1) = hsp_pose([1.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double], [0.0_c_double, 0.0_c_double, 0.0_c_double])
    call expect(hsp_pose_from_matrix([transpose(quarter)], [0.0_c_double, 0.0_c_double, 1000.0_c_double], pose(2)), HSP_OK, &
                'hsp_pose_from_matrix')
    call check(abs(pose(2)%quaternion(1) - pose(2)%quaternion(4)) < 1e-15_c_double, 'a quarter turn')
    call expect(hsp_body_hits(body, body, 2_c_int32_t, pose, hit, first_bad), HSP_OK, 'hsp_body_hits')
    call check(all(hit == [1, 0]) .and. first_bad == HSP_NONE, 'hits')
    hit = 7
    call expect(hsp_body_hits_along(body, body, 2_c_int32_t, pose, 0.5_c_double, hit, first_bad), HSP_OK, 'hits along')
    call check(all(hit == [1, 0]) .and. first_bad == HSP_NONE, 'hits along a motion')
    call expect(hsp_body_gaps(body, body, 2_c_int32_t, pose, gap), HSP_OK, 'hsp_body_gaps')
    call check(gap(1)%gap == -2*maxval(radius) .and. gap(1)%fixed == gap(1)%posed, 'the gap of a body in its place')
    call check(gap(2)%gap > 900.0_c_double, 'the gap of a body far away')
    call expect(hsp_body_overlaps(body, body, 2_c_int32_t, pose, overlap), HSP_OK, 'hsp_body_overlaps')
    call check(overlap(2)%pairs == 0 .and. overlap(2)%volume == 0.0_c_double, 'no overlap')
    call expect(hsp_body_pairs(body, body, pose(2), pair, n, needed), HSP_OK, 'hsp_body_pairs')
    call check(needed == 0, 'no pairs')
    call expect(hsp_body_pairs(body, body, pose(1), capacity=0_c_int32_t, needed=needed), HSP_E_CAPACITY, 'no room')
    call check(needed == overlap(1)%pairs .and. needed >= n, 'as many pairs')
    rational(1) = hsp_rational_pose([7, 0, 0, 0], [0.0_c_double, 0.0_c_double, 0.0_c_double])
    rational(2) = hsp_rational_pose([1, 0, 0, 1], [0.0_c_double, 0.0_c_double, 1000.0_c_double])
    call expect(hsp_body_rational_hits(body, body, 2_c_int32_t, rational, hit, first_bad), HSP_OK, 'rational hits')
    call check(all(hit == [1, 0]) .and. first_bad == HSP_NONE, 'hits of rational poses')
    hit = 7
    call expect(hsp_body_rational_hits_along(body, body, 2_c_int32_t, rational, 0.5_c_double, hit), HSP_OK, 'rational along')
    call check(all(hit == [1, 0]), 'hits along a rational motion')
    call expect(hsp_body_rational_gaps(body, body, 2_c_int32_t, rational, gap), HSP_OK, 'rational gaps')
    call check(gap(1)%gap == -2*maxval(radius) .and. gap(2)%gap > 900.0_c_double, 'gaps of rational poses')
    call expect(hsp_body_rational_pairs(body, body, rational(1), capacity=0_c_int32_t, needed=needed), HSP_E_CAPACITY, &
                'no room for pairs of a rational pose')
    call check(needed == overlap(1)%pairs, 'as many pairs in a rational pose')
  end subroutine

  subroutine contacts_functions()
    type(hsp_contacts_limits) :: limits
    type(hsp_contact) :: contact(3), row(2)
    type(hsp_group_contact) :: between(1)
    type(hsp_complex) :: counts
    type(hsp_simplex) :: triangle(1)
    type(hsp_totals) :: totals, of_boundary
    type(c_ptr) :: contacts
    integer(c_int8_t), allocatable, target :: memory(:)
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: needed, invariant, id
    integer(c_int32_t), parameter :: group(n) = [5, 5, 2, 2]
    real(c_double) :: cell(n), area(n)
    call expect(hsp_contacts_limits_init(limits, int(c_sizeof(limits), c_int32_t), boundary), HSP_OK, &
                'hsp_contacts_limits_init')
    call check(limits%balls == n .and. limits%contacts == 12*n + 64, 'limits of contacts')
    limits%triangles = 1
    limits%tetrahedra = 1
    call expect(hsp_contacts_bytes(limits, bytes), HSP_OK, 'hsp_contacts_bytes')
    call check(bytes <= hsp_contacts_bytes_bound(limits%balls, limits%neighbours, limits%contacts, limits%triangles, &
                                                 limits%tetrahedra), 'hsp_contacts_bytes_bound')
    allocate (memory(bytes))
    call expect(hsp_contacts_init(c_loc(memory), bytes, limits, contacts), HSP_OK, 'hsp_contacts_init')
    call expect(hsp_contacts_get_pairs(contacts, capacity=0_c_int32_t, needed=needed), HSP_E_STATE, 'contacts of nothing')
    call expect(hsp_contacts_compute(contacts, boundary, limits), HSP_OK, 'hsp_contacts_compute')
    call check(limits%contacts == 3 .and. limits%triangles == 1 .and. limits%tetrahedra == 0, 'limits that were needed')
    call expect(hsp_contacts_get_pairs(contacts, contact, 3_c_int32_t, needed), HSP_OK, 'hsp_contacts_get_pairs')
    call check(needed == 3 .and. all(contact(1)%ball == [0, 1]) .and. all(contact(3)%ball == [1, 2]), 'balls of contacts')
    call check(all(contact%chords == 1) .and. all(contact%flags == 0), 'contacts with one side')
    call check(abs(contact(1)%distance - 2) < 1e-15_c_double, 'distance of a contact')
    call expect(hsp_contacts_get_row(contacts, 2_c_int32_t, row, 2_c_int32_t, needed), HSP_OK, 'hsp_contacts_get_row')
    call check(needed == 2 .and. row(1)%area == contact(2)%area .and. row(2)%area == contact(3)%area, 'a row')
    call expect(hsp_contacts_measure(contacts, totals, cell, area, n, needed), HSP_OK, 'hsp_contacts_measure')
    call expect(hsp_boundary_measure(boundary, totals=of_boundary, capacity=0_c_int32_t), HSP_OK, 'volume')
    call check(abs(totals%volume - of_boundary%volume) < 1e-12_c_double, 'volume of the cells')
    call check(abs(sum(area) - 2*sum(contact%area)) < 1e-12_c_double, 'areas of contacts')
    call check(abs(cell(4) - pi/6) < 1e-14_c_double, 'cell of a ball alone')
    call expect(hsp_contacts_group(contacts, group, between, 1_c_int32_t, needed), HSP_OK, 'hsp_contacts_group')
    call check(all(between(1)%group == [2, 5]) .and. between(1)%contacts == 2, 'contacts of two groups')
    call expect(hsp_contacts_get_complex(contacts, counts), HSP_OK, 'hsp_contacts_get_complex')
    call check(counts%singular(1) == 1 .and. counts%regular(2) == 3 .and. counts%singular(3) == 1, 'simplices')
    call check(counts%euler == 2 .and. all(counts%betti == [2, 0, 0]), 'Betti numbers')
    call expect(hsp_contacts_get_simplices(contacts, 2_c_int32_t, triangle, 1_c_int32_t, needed), HSP_OK, &
                'hsp_contacts_get_simplices')
    call check(all(triangle(1)%ball == [0, 1, 2, HSP_NONE]) .and. triangle(1)%kind == HSP_SIMPLEX_SINGULAR, 'a triangle')
    call expect(hsp_contacts_check(contacts, invariant, id), HSP_OK, 'hsp_contacts_check')
  end subroutine

  subroutine reports_errors()
    integer(c_int32_t) :: bad, needed
    real(c_double) :: negative(n)
    type(c_ptr) :: handle
    integer(c_size_t) :: bytes
    negative = radius
    negative(3) = -1
    call expect(hsp_model_set(model, n, xyz, negative, first_bad=bad), HSP_E_NEGATIVE, 'negative radius')
    call check(bad == 2, 'first_bad is 0-based')
    call expect(hsp_model_set(model, n, xyz), HSP_E_ARGUMENT, 'no radii')
    call expect(hsp_model_set(c_null_ptr, n, xyz, radius), HSP_E_ARGUMENT, 'no model')
    call expect(hsp_model_set(model, n + 1_c_int32_t, xyz, radius), HSP_E_CAPACITY, 'too many balls')
    call expect(hsp_query_neighbours(model, 0_c_int32_t, capacity=0_c_int32_t, needed=needed), HSP_E_STATE, 'refused balls')
    call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'the balls again')
    call expect(hsp_query_neighbours(model, n, capacity=0_c_int32_t, needed=needed), HSP_E_ID, 'no such ball')
    call expect(hsp_model_bytes(HSP_NONE, bytes), HSP_E_RANGE, 'far too many balls')
    call expect(hsp_model_init(c_loc(model_memory), 10_c_size_t, n, handle), HSP_E_MEMORY, 'too little memory')
  end subroutine
end program fortran_interface_test
