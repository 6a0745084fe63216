! Pores as a Fortran program sees them: every function is called, and records arrive as the header has them.
program fortran_pores_test
  use, intrinsic :: iso_c_binding
  use hardsphere
  use hardsphere_workspace
  use fortran_checks
  implicit none
  integer(c_int32_t), parameter :: n = 4
  real(c_double), parameter :: xyz(3, n) = reshape([1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1]*1.0_c_double, [3, n])
  real(c_double), parameter :: radius(n) = [1.0_c_double, 1.0_c_double, 1.0_c_double, 1.25_c_double]
  real(c_double), parameter :: middle(3) = 0, away(3) = [9, 8, 7]
  integer(c_int8_t), allocatable, target :: model_memory(:), memory(:)
  type(c_ptr) :: model = c_null_ptr, pores = c_null_ptr
  type(hsp_pores_limits) :: limits
  type(hsp_pores_options) :: options
  type(hsp_pores_counts) :: counts
  type(hsp_pore_maximum) :: top(1)
  type(hsp_pore_gate) :: gates(8)
  type(hsp_pore_place) :: place
  type(hsp_pore_passage) :: passage
  type(hsp_pore_pocket) :: pocket(1)
  type(hsp_tunnel) :: tunnel
  type(hsp_tunnel_point), allocatable :: points(:)
  integer(c_int32_t) :: list(8), needed, number
  integer(c_size_t) :: bytes

  call check(c_sizeof(limits) == 32 .and. c_sizeof(options) == 32 .and. c_sizeof(counts) == 24, 'sizes of numbers')
  call check(c_sizeof(top(1)) == 64 .and. c_sizeof(gates(1)) == 56 .and. c_sizeof(place) == 16, 'sizes of records')
  call check(c_sizeof(passage) == 32 .and. c_sizeof(pocket(1)) == 40 .and. c_sizeof(tunnel) == 40, 'sizes of answers')
  call expect(hsp_model_bytes(n, bytes), HSP_OK, 'hsp_model_bytes')
  allocate (model_memory(bytes))
  call expect(hsp_model_init(c_loc(model_memory), bytes, n, model), HSP_OK, 'hsp_model_init')
  call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'hsp_model_set')
  call expect(hsp_pores_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_pores_limits_init')
  call check(limits%maxima == 72 .and. limits%points == 4100, 'limits of pores')
  call expect(hsp_pores_bytes(limits, bytes), HSP_OK, 'hsp_pores_bytes')
  call check(bytes <= hsp_pores_bytes_bound(limits%balls, limits%maxima, limits%gates, limits%tied, limits%candidates, &
                                            limits%neighbours, limits%points), 'hsp_pores_bytes_bound')
  allocate (memory(bytes))
  call expect(hsp_pores_init(c_loc(memory), bytes, limits, pores), HSP_OK, 'hsp_pores_init')
  call expect(hsp_pores_get_counts(pores, counts), HSP_E_STATE, 'no pores yet')
  call expect(hsp_pores_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'hsp_pores_options_init')
  options%floor = -0.5_c_double
  call expect(hsp_pores_compute(pores, model, options, limits), HSP_OK, 'hsp_pores_compute')
  call expect(hsp_pores_get_counts(pores, counts), HSP_OK, 'hsp_pores_get_counts')
  call check(counts%maxima == 1 .and. counts%gates == 4 .and. counts%cavities == 0 .and. counts%outer_balls == 4, 'counts')
  call expect(hsp_pores_get_maxima(pores, 0_c_int32_t, 1_c_int32_t, top), HSP_OK, 'hsp_pores_get_maxima')
  call check(top(1)%radius > 0.6 .and. top(1)%radius < 0.732 .and. top(1)%parent == HSP_PORE_OUTSIDE, 'the maximum')
  call expect(hsp_pores_get_gates(pores, 0_c_int32_t, 4_c_int32_t, gates), HSP_OK, 'hsp_pores_get_gates')
  call check(abs(gates(1)%radius - (sqrt(8.0_c_double/3) - 1)) < 1e-12, 'the gate of the three small balls')
  call check(abs(top(1)%death - gates(1)%radius) < 1e-12 .and. top(1)%gate == 0, 'where it merges')
  call expect(hsp_pores_get_maximum_balls(pores, 0_c_int32_t, list, 8_c_int32_t, needed), HSP_OK, &
              'hsp_pores_get_maximum_balls')
  call check(needed == 4 .and. all(list(1:4) == [0, 1, 2, 3]), 'its balls')
  call expect(hsp_pores_get_gate_balls(pores, 0_c_int32_t, list, 8_c_int32_t, needed), HSP_OK, 'hsp_pores_get_gate_balls')
  call check(needed == 3 .and. all(list(1:3) == [0, 1, 2]), 'balls of the gate')
  call expect(hsp_pores_class_at(pores, 0_c_int32_t, 0.7_c_double, number), HSP_OK, 'hsp_pores_class_at')
  call check(number == 0 .or. number == HSP_NONE, 'the class of a probe')
  call expect(hsp_pores_gate_between(pores, 0_c_int32_t, HSP_PORE_OUTSIDE, number), HSP_OK, 'hsp_pores_gate_between')
  call check(number == 0, 'the way out')
  call expect(hsp_pores_locate(pores, middle, place), HSP_OK, 'hsp_pores_locate')
  call check(place%maximum == 0 .and. place%ball == 3, 'where the middle is')
  call expect(hsp_pores_widest(pores, middle, passage=passage), HSP_OK, 'hsp_pores_widest')
  call check(passage%passes == 1 .and. passage%radius <= place%radius, 'how wide')
  call expect(hsp_pores_widest(pores, middle, away, passage), HSP_OK, 'hsp_pores_widest to a point')
  call expect(hsp_pores_find_pockets(pores, 0.0_c_double, 1.0_c_double, number), HSP_OK, 'hsp_pores_find_pockets')
  call check(number == 1, 'one pocket')
  call expect(hsp_pores_get_pockets(pores, 0_c_int32_t, 1_c_int32_t, pocket), HSP_OK, 'hsp_pores_get_pockets')
  call check(pocket(1)%maxima == 1 .and. pocket(1)%mouths == 4 .and. pocket(1)%balls == 4, 'the pocket')
  call expect(hsp_pores_get_pocket_maxima(pores, 0_c_int32_t, list, 8_c_int32_t, needed), HSP_OK, &
              'hsp_pores_get_pocket_maxima')
  call check(needed == 1 .and. list(1) == 0, 'its maximum')
  call expect(hsp_pores_get_pocket_mouths(pores, 0_c_int32_t, list, 8_c_int32_t, needed), HSP_OK, &
              'hsp_pores_get_pocket_mouths')
  call check(needed == 4 .and. list(1) == 0, 'its mouths')
  call expect(hsp_pores_get_pocket_balls(pores, 0_c_int32_t, list, 8_c_int32_t, needed), HSP_OK, &
              'hsp_pores_get_pocket_balls')
  call check(needed == 4, 'its lining')
  call expect(hsp_pores_find_tunnel(pores, middle, count=0_c_int32_t, tunnel=tunnel), HSP_OK, 'hsp_pores_find_tunnel')
  call check(tunnel%there == 1 .and. tunnel%gate == 0 .and. tunnel%outside == 1, 'the tunnel')
  allocate (points(tunnel%points))
  call expect(hsp_pores_get_tunnel_points(pores, points, tunnel%points, needed), HSP_OK, 'hsp_pores_get_tunnel_points')
  call check(all(points(1)%xyz == middle) .and. any(points%gate == 0), 'its points')
  call expect(hsp_pores_find_tunnel(pores, middle, away, [0_c_int32_t], 1_c_int32_t, tunnel, limits), HSP_OK, &
              'hsp_pores_find_tunnel that avoids a gate')
  call check(tunnel%gate > 0 .and. limits%points >= tunnel%points, 'another way')
  call with_plugs()
  call in_a_box()
  call report_checks()

contains

  ! The pocket of the four balls, closed by four plugs.
  subroutine with_plugs()
    type(hsp_workspace) :: plugged
    type(hsp_pore_pocket_size) :: size(1)
    real(c_double) :: centre(3, 8), r(8)
    call check(c_sizeof(size(1)) == 32, 'the size of sizes')
    call expect(hsp_pores_get_plugged_balls(pores, capacity=0_c_int32_t, needed=needed), HSP_OK, 'how many balls')
    call check(needed == 8, 'four balls and four plugs')
    call expect(hsp_pores_get_plugged_balls(pores, centre, r, 8_c_int32_t, needed), HSP_OK, 'hsp_pores_get_plugged_balls')
    call check(all(centre(:, 1:4) == xyz) .and. all(r(1:4) == radius) .and. all(r(5:8) > 0), 'balls and plugs')
    call expect(plugged%set(8_c_int32_t, centre, r), HSP_OK, 'balls with plugs')
    call expect(plugged%compute_boundary(), HSP_OK, 'their boundary')
    call expect(plugged%compute_pores(), HSP_OK, 'their pores')
    call expect(hsp_pores_measure_pockets(pores, plugged%pores, plugged%boundary, size, 1_c_int32_t, needed), HSP_OK, &
                'hsp_pores_measure_pockets')
    call check(needed == 1 .and. size(1)%closed == 1 .and. size(1)%volume >= 0 .and. size(1)%area >= 0, 'its size')
  end subroutine

  ! One ball in a box: a simple cubic packing.
  subroutine in_a_box()
    real(c_double), parameter :: edge = 8, box(9) = [edge, 0.0_c_double, 0.0_c_double, 0.0_c_double, edge, 0.0_c_double, &
                                                     0.0_c_double, 0.0_c_double, edge]
    type(hsp_workspace) :: work
    type(hsp_pore_percolation) :: wide
    type(hsp_pore_channel) :: channel(1)
    type(hsp_pore_gate_shifts) :: shifts(3)
    type(hsp_pore_access) :: access
    type(hsp_pore_region) :: region(1)
    real(c_double), parameter :: pi = acos(-1.0_c_double)
    type(hsp_image) :: images(8)
    call check(c_sizeof(wide) == 120 .and. c_sizeof(channel(1)) == 64 .and. c_sizeof(shifts(1)) == 68, 'sizes in a box')
    call expect(work%compute_periodic(1_c_int32_t, xyz(:, 1:1), radius, box=box), HSP_OK, 'compute_periodic')
    call expect(work%compute_pores_periodic(), HSP_OK, 'hsp_pores_compute_periodic')
    call expect(hsp_pores_get_percolation(work%pores, wide), HSP_OK, 'hsp_pores_get_percolation')
    call check(abs(wide%largest - (edge*sqrt(3.0_c_double)/2 - 1)) < 1e-8, 'the largest cavity')
    call check(all(abs(wide%through - (edge*sqrt(2.0_c_double)/2 - 1)) < 1e-8), 'pore-limiting')
    call check(all(abs(wide%along - wide%through(1)) < 1e-8) .and. all(wide%maximum == 0), 'along the vectors')
    call expect(hsp_pores_get_channels(work%pores, 1.0_c_double, channel, 1_c_int32_t, needed), HSP_OK, &
                'hsp_pores_get_channels')
    call check(needed == 1 .and. channel(1)%directions == 3 .and. all(channel(1)%row == [1, 0, 0, 0, 1, 0, 0, 0, 1]), &
               'the channel')
    call expect(hsp_pores_get_gate_shifts(work%pores, 0_c_int32_t, 3_c_int32_t, shifts), HSP_OK, &
                'hsp_pores_get_gate_shifts')
    call check(sum(abs(shifts(1)%end(4:6) - shifts(1)%end(1:3))) == 1 .and. shifts(3)%directions == 3, 'one box away')
    call expect(hsp_pores_get_maximum_images(work%pores, 0_c_int32_t, images, 8_c_int32_t, needed), HSP_OK, &
                'hsp_pores_get_maximum_images')
    call check(needed == 8 .and. all(images%ball == 0), 'eight images of the ball')
    call expect(hsp_pores_get_gate_images(work%pores, 0_c_int32_t, images, 8_c_int32_t, needed), HSP_OK, &
                'hsp_pores_get_gate_images')
    call check(needed == 4, 'four of them around a gate')
    call check(c_sizeof(access) == 40 .and. c_sizeof(region(1)) == 88, 'sizes of regions')
    call expect(hsp_pores_find_regions(work%pores, c_null_ptr, access, number), HSP_OK, 'hsp_pores_find_regions')
    call check(number == 1 .and. access%accessible == 1 .and. access%blocked_volume == 0, 'one region')
    call check(abs(access%accessible_volume - (edge**3 - 4*pi/3)) < 1e-9, 'its volume')
    call expect(hsp_pores_get_regions(work%pores, 0_c_int32_t, 1_c_int32_t, region), HSP_OK, 'hsp_pores_get_regions')
    call check(region(1)%directions == 3 .and. abs(region(1)%area - 4*pi) < 1e-9, 'the region')
  end subroutine
end program
