! The interface as a Fortran program sees it: every function of the module is called, records arrive field by field,
! optional arguments arrive as null pointers, and errors as statuses.
program fortran_interface_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_ptr, c_ptr, c_size_t, &
                                         c_sizeof, c_associated
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

  integer :: checks = 0, failures = 0
  integer(c_int8_t), allocatable, target :: model_memory(:), boundary_memory(:)
  type(c_ptr) :: model, boundary

  call sizes_and_constants()
  call model_functions()
  call query_functions()
  call boundary_functions()
  call reports_errors()
  print '(i0, a, i0, a)', checks, ' checks, ', failures, ' failed'
  if (failures > 0 .or. checks == 0) stop 1

contains

  subroutine check(holds, what)
    logical, intent(in) :: holds
    character(len=*), intent(in) :: what
    checks = checks + 1
    if (holds) return
    failures = failures + 1
    print '(a, a)', 'failed: ', what
  end subroutine

  subroutine expect(status, expected, what)
    integer(c_int32_t), intent(in) :: status, expected
    character(len=*), intent(in) :: what
    call check(status == expected, what//': '//hsp_status_message(status)//', expected '//hsp_status_message(expected))
  end subroutine

  subroutine sizes_and_constants()
    type(hsp_model_options) :: options
    type(hsp_model_info) :: info
    type(hsp_figures) :: figures
    type(hsp_boundary_limits) :: limits
    type(hsp_boundary_counts) :: counts
    type(hsp_vertex) :: vertex
    type(hsp_arc) :: arc
    type(hsp_circle) :: circle
    type(hsp_face) :: face
    type(hsp_ball) :: ball
    type(hsp_totals) :: totals
    type(c_ptr) :: text
    call check(c_sizeof(options) == 24, 'size of hsp_model_options')
    call check(c_sizeof(info) == 40, 'size of hsp_model_info')
    call check(c_sizeof(figures) == 40, 'size of hsp_figures')
    call check(c_sizeof(limits) == 24, 'size of hsp_boundary_limits')
    call check(c_sizeof(counts) == 56, 'size of hsp_boundary_counts')
    call check(c_sizeof(vertex) == 48, 'size of hsp_vertex')
    call check(c_sizeof(arc) == 32, 'size of hsp_arc')
    call check(c_sizeof(circle) == 72, 'size of hsp_circle')
    call check(c_sizeof(face) == 16, 'size of hsp_face')
    call check(c_sizeof(ball) == 16, 'size of hsp_ball')
    call check(c_sizeof(totals) == 16, 'size of hsp_totals')
    call check(hsp_version() == HSP_VERSION_NUMBER, 'version')
    text = hsp_status_text(HSP_OK)
    call check(c_associated(text), 'status text')
    call check(hsp_status_message(12345_c_int32_t) == 'unknown status', 'text of an unknown status')
    call check(len(hsp_status_message(HSP_E_ID)) > 0, 'text of a known status')
    call check(hsp_index(0_c_int32_t) == 1, 'hsp_index')
    call check(all(hsp_index([3_c_int32_t, 7_c_int32_t]) == [4, 8]), 'hsp_index of an array')
  end subroutine

  subroutine model_functions()
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: bad
    type(hsp_model_options) :: options
    type(hsp_model_info) :: info
    type(hsp_figures) :: figures
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
    call check(options%struct_size == 24 .and. options%reserved == 0, 'options')
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
    call expect(hsp_model_get_figures(model, figures), HSP_OK, 'hsp_model_get_figures')
    call check(abs(figures%k - 3) < 1e-14_c_double, 'figures%k')
    call check(abs(figures%rho - sqrt(3.25_c_double)/1.5_c_double) < 1e-14_c_double, 'figures%rho')
    call check(abs(figures%mean_overlaps - 1.5_c_double) < 1e-14_c_double, 'figures%mean_overlaps')
    call check(abs(figures%neighbour_bound/(216*(figures%k/figures%rho)**3) - 1) < 1e-14_c_double, 'figures%neighbour_bound')
    call check(figures%max_overlaps == 2 .and. figures%flags == 0, 'figures%max_overlaps')
  end subroutine

  subroutine query_functions()
    integer(c_int32_t) :: ids(n), needed, meets
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
  end subroutine

  subroutine boundary_functions()
    integer(c_size_t) :: bytes
    type(hsp_boundary_limits) :: limits, needed_limits
    type(hsp_boundary_counts) :: counts
    type(hsp_vertex) :: vertices(2)
    type(hsp_arc) :: arcs(3)
    type(hsp_circle) :: circles(1)
    type(hsp_face) :: faces(4)
    type(hsp_ball) :: balls(n)
    type(hsp_totals) :: totals
    real(c_double) :: area(n), volume(n)
    integer(c_int32_t) :: needed, law, where
    integer :: v, b
    call expect(hsp_boundary_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_boundary_limits_init')
    call check(limits%balls == n .and. limits%neighbours == n .and. limits%vertices == 96 .and. limits%circles == 24, &
               'default limits')
    call expect(hsp_boundary_bytes(limits, bytes), HSP_OK, 'hsp_boundary_bytes')
    call check(bytes > 0 .and. bytes <= hsp_boundary_bytes_bound(n, n, 96_c_int32_t, 24_c_int32_t), 'boundary bytes')
    allocate (boundary_memory(bytes))
    call expect(hsp_boundary_init(c_loc(boundary_memory), bytes, limits, boundary), HSP_OK, 'hsp_boundary_init')
    call expect(hsp_boundary_get_counts(boundary, counts), HSP_E_STATE, 'nothing computed')
    call expect(hsp_boundary_compute(boundary, model), HSP_OK, 'hsp_boundary_compute')
    call expect(hsp_boundary_get_needed(boundary, needed_limits), HSP_OK, 'hsp_boundary_get_needed')
    call check(needed_limits%neighbours == 2 .and. needed_limits%vertices == 2 .and. needed_limits%circles == 0, 'needed')
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
    end do
    call expect(hsp_boundary_get_circles(boundary, circles, 1_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_circles')
    call check(needed == 0, 'number of circles')
    call expect(hsp_boundary_get_circles(boundary, capacity=0_c_int32_t, needed=needed), HSP_OK, 'no circles, no array')
    call expect(hsp_boundary_get_faces(boundary, faces, 4_c_int32_t, needed), HSP_OK, 'hsp_boundary_get_faces')
    call check(needed == 4, 'number of faces')
    call check(all(faces%shell >= 0 .and. faces%shell < 2), 'shells of faces')
    call expect(hsp_boundary_get_balls(boundary, balls, n, needed), HSP_OK, 'hsp_boundary_get_balls')
    call check(needed == n, 'number of balls')
    do b = 1, n
      call check(balls(b)%faces == 1 .and. hsp_index(faces(hsp_index(balls(b)%first_face))%ball) == b, 'face of a ball')
      call check(faces(hsp_index(balls(b)%first_face))%loops == merge(0, 1, b == 4), 'loops of a face')
    end do
    call check(balls(1)%component == balls(3)%component .and. balls(1)%component /= balls(4)%component, 'components')

    call expect(hsp_boundary_measure(boundary, totals, area, volume, n), HSP_OK, 'hsp_boundary_measure')
    call check(abs(area(4) - pi) < 1e-14_c_double .and. abs(volume(4) - pi/6) < 1e-14_c_double, 'the ball apart')
    call check(abs(sum(area) - totals%area) < 1e-12_c_double .and. abs(sum(volume) - totals%volume) < 1e-12_c_double, 'totals')
    totals%area = 0
    call expect(hsp_boundary_measure(boundary, totals, capacity=0_c_int32_t), HSP_OK, 'totals alone')
    call check(totals%area > pi, 'totals alone')
    area = 0
    call expect(hsp_boundary_measure(boundary, area=area, capacity=n), HSP_OK, 'areas alone')
    call check(all(area > 0), 'areas alone')
    law = 7
    call expect(hsp_boundary_check(boundary, law, where), HSP_OK, 'hsp_boundary_check')
    call check(law == 0, 'no law is broken')
    call two_balls_circle()
  end subroutine

  ! The fields of a circle: two equal balls, 2 apart.
  subroutine two_balls_circle()
    type(hsp_circle) :: circle(1)
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
    call expect(hsp_query_neighbours(model, n, capacity=0_c_int32_t, needed=needed), HSP_E_ID, 'no such ball')
    call expect(hsp_model_bytes(HSP_NONE, bytes), HSP_E_RANGE, 'far too many balls')
    call expect(hsp_model_init(c_loc(model_memory), 10_c_size_t, n, handle), HSP_E_MEMORY, 'too little memory')
  end subroutine
end program fortran_interface_test
