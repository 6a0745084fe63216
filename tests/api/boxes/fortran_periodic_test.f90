! Balls in a periodic box as a Fortran program sees them: every function is called, and records arrive field by field.
program fortran_periodic_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use fortran_checks
  use hardsphere
  implicit none

  ! A rod along x, its second ball given three boxes away, and a ball beside it.
  integer(c_int32_t), parameter :: n = 3
  real(c_double), parameter :: pi = 3.14159265358979323846_c_double
  real(c_double), parameter :: xyz(3, n) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    14.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    1.0_c_double, 4.0_c_double, 4.0_c_double], [3, n])
  real(c_double), parameter :: radius(n) = [1.25_c_double, 1.25_c_double, 1.0_c_double]
  real(c_double), parameter :: box(9) = [4.0_c_double, 0.0_c_double, 0.0_c_double, &
                                         1.0_c_double, 8.0_c_double, 0.0_c_double, &
                                         -1.0_c_double, 2.0_c_double, 8.0_c_double]
  real(c_double), parameter :: point(3) = [3.0_c_double, 8.0_c_double, 0.0_c_double]

  integer(c_int8_t), allocatable, target :: memory(:)
  type(c_ptr) :: periodic = c_null_ptr
  type(hsp_model_options) :: options
  type(hsp_periodic_limits) :: limits
  type(hsp_periodic_counts) :: counts
  type(hsp_periodic_request) :: request
  type(hsp_periodic_totals) :: totals
  type(hsp_curvatures) :: curvatures
  type(hsp_periodic_contact) :: contacts(10)
  type(hsp_winding) :: windings(n)
  type(hsp_image) :: images(10)
  type(hsp_periodic_vertex) :: vertices(1)
  type(hsp_periodic_arc) :: arcs(1)
  type(hsp_periodic_circle) :: circles(2)
  type(hsp_periodic_face) :: faces(n)
  type(hsp_periodic_loop) :: loops(4)
  type(hsp_periodic_loop_arc) :: loop_arcs(1)
  type(hsp_ball) :: balls(n)
  type(hsp_energy) :: energy
  type(hsp_morphometric_energy) :: morphometric
  type(hsp_group_contact) :: between(2)
  real(c_double) :: area(n), share_volume(n), d_centre(3, n), d_radius(n), d_strain(9), d_box(9), rod, mean(n)
  type(hsp_gradient_request) :: asked
  real(c_double) :: block(3, 3, 9)
  integer(c_int32_t) :: column(9), row_flags(n + 1)
  integer(c_int32_t) :: thirds(n), component(n), flags(n), first(n + 1), needed, invariant, id, bad
  integer(c_size_t) :: bytes

  call check(c_sizeof(limits) == 32 .and. c_sizeof(counts) == 48 .and. c_sizeof(totals) == 40, 'sizes of records')
  call check(c_sizeof(contacts(1)) == 56 .and. c_sizeof(windings(1)) == 52 .and. c_sizeof(images(1)) == 16, &
             'sizes of lists')
  call expect(hsp_periodic_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_periodic_limits_init')
  call check(limits%balls == 3 .and. limits%images == 134 .and. limits%contacts == 12*137 + 64, 'limits')
  call expect(hsp_periodic_bytes(limits, bytes), HSP_OK, 'hsp_periodic_bytes')
  call check(bytes <= hsp_periodic_bytes_bound(limits%balls, limits%images, limits%neighbours, limits%vertices, &
                                               limits%circles, limits%contacts), 'hsp_periodic_bytes_bound')
  allocate (memory(bytes))
  call expect(hsp_periodic_init(c_loc(memory), bytes, limits, periodic), HSP_OK, 'hsp_periodic_init')
  call expect(hsp_periodic_get_counts(periodic, counts), HSP_E_STATE, 'counts of nothing')

  call expect(hsp_model_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'hsp_model_options_init')
  call expect(hsp_periodic_compute(periodic, n, xyz, radius, box, options, limits, bad), HSP_OK, 'hsp_periodic_compute')
  call check(bad == HSP_NONE .and. limits%vertices == 0 .and. limits%images > 0, 'needed limits')
  request%struct_size = int(c_sizeof(request), c_int32_t)
  request%areas_alone = 1
  call expect(hsp_periodic_compute_with(periodic, n, xyz, radius, box, request, limits, bad), HSP_OK, &
              'hsp_periodic_compute_with')
  call expect(hsp_periodic_get_counts(periodic, counts), HSP_E_STATE, 'counts of areas alone')
  call expect(hsp_periodic_get_gradient(periodic, tension=1.0_c_double, energy=energy, area=area, capacity=n), HSP_OK, &
              'areas with their gradient')
  call check(abs(energy%area - 14*pi) < 1e-11_c_double .and. abs(sum(area) - energy%area) < 1e-11_c_double, 'areas alone')
  call expect(hsp_periodic_compute(periodic, n, xyz, radius, box, options, limits, bad), HSP_OK, 'hsp_periodic_compute')
  call expect(hsp_periodic_get_counts(periodic, counts), HSP_OK, 'hsp_periodic_get_counts')
  call check(counts%balls == 3 .and. counts%circles == 2 .and. counts%contacts == 2 .and. counts%components == 2, 'counts')
  call check(counts%faces == 3 .and. counts%shells == 2 .and. counts%euler == 2, 'more counts')

  call expect(hsp_periodic_measure(periodic, totals, area, share_volume, n, needed), HSP_OK, 'hsp_periodic_measure')
  rod = 10*pi
  call check(abs(totals%area - rod - 4*pi) < 1e-11_c_double .and. needed == n, 'area')
  call check(abs(area(1) - rod/2) < 1e-11_c_double .and. abs(area(3) - 4*pi) < 1e-11_c_double, 'areas')
  call check(abs(sum(share_volume) - totals%volume) < 1e-11_c_double, 'cells')
  call check(totals%box_volume == 256 .and. totals%free_volume == 256 - totals%volume, 'volumes')
  call check(abs(totals%contact_area - 1.125_c_double*pi) < 1e-11_c_double, 'contact area')

  call expect(hsp_periodic_curvature(periodic, curvatures, mean, thirds, n, needed), HSP_OK, 'hsp_periodic_curvature')
  call check(needed == n .and. all(thirds == [0, 0, 12]) .and. abs(mean(3) - 4*pi) < 1e-12_c_double, 'curvatures')
  call check(abs(sum(mean) - curvatures%mean) < 1e-11_c_double .and. abs(curvatures%gauss - 4*pi) < 1e-12_c_double, &
             'sums of curvatures')

  call expect(hsp_periodic_get_contacts(periodic, contacts, size(contacts, kind=c_int32_t), needed), HSP_OK, &
              'hsp_periodic_get_contacts')
  call check(needed == 2 .and. all(contacts(1)%ball == [0, 1]) .and. contacts(1)%flags == HSP_CONTACT_CIRCLE, 'a contact')
  call check(all(contacts(1)%shift == [-4, 0, 0]) .and. all(contacts(2)%shift == [-3, 0, 0]), 'shifts')
  call check(contacts(1)%distance == 2 .and. contacts(1)%chords == 0, 'its distance')
  call check(abs(contacts(2)%area - 0.5625_c_double*pi) < 1e-12_c_double, 'its area')
  call check(abs(contacts(2)%rim - 1.5_c_double*pi) < 1e-12_c_double, 'its edge')
  call expect(hsp_periodic_group_contacts(periodic, [7_c_int32_t, 3_c_int32_t, 3_c_int32_t], between, 2_c_int32_t, needed), &
              HSP_OK, 'hsp_periodic_group_contacts')
  call check(needed == 1 .and. all(between(1)%group == [3, 7]) .and. between(1)%contacts == 2, 'two groups')
  call check(abs(between(1)%area - totals%contact_area) < 1e-12_c_double, 'their contacts')
  call expect(hsp_periodic_get_windings(periodic, windings, n, needed), HSP_OK, 'hsp_periodic_get_windings')
  call check(needed == 2 .and. windings(1)%balls == 2 .and. windings(1)%directions == 1, 'the rod')
  call check(all(windings(1)%row == [1, 0, 0, 0, 0, 0, 0, 0, 0]) .and. windings(1)%copies == 1, 'its windings')
  call check(windings(2)%first == 2 .and. windings(2)%directions == 0, 'the ball beside it')
  call expect(hsp_periodic_get_components(periodic, component, n, needed), HSP_OK, 'hsp_periodic_get_components')
  call check(all(component == [0, 0, 1]), 'components')

  call expect(hsp_periodic_get_gradient(periodic, pressure=1.0_c_double, energy=energy, d_centre=d_centre, &
                                        d_radius=d_radius, flags=flags, d_strain=d_strain, d_box=d_box, capacity=n), &
              HSP_OK, 'hsp_periodic_get_gradient')
  call check(abs(energy%value - totals%volume) < 1e-11_c_double .and. all(flags == 0), 'energy')
  call check(maxval(abs(d_centre)) < 1e-11_c_double .and. maxval(abs(d_radius - area)) < 1e-11_c_double, 'gradient')
  call check(abs(d_strain(1) - 2.25_c_double*pi) < 1e-11_c_double, 'strain')
  call check(maxval(abs(d_strain(2:))) < 1e-11_c_double, 'no more strain')
  call check(abs(d_box(1) - 0.5625_c_double*pi) < 1e-11_c_double, 'by the box')

  ! Second derivatives of the two balls of the rod: two circles of radius 3/4, halfway between centres 2 apart.
  call expect(hsp_gradient_request_init(asked, int(c_sizeof(asked), c_int32_t)), HSP_OK, 'hsp_gradient_request_init')
  asked%pressure = 1
  call expect(hsp_periodic_get_hessian_rows(periodic, asked, first, column, block, flags=row_flags, &
                                            capacity=size(column, kind=c_int32_t), needed=needed), HSP_OK, &
              'hsp_periodic_get_hessian_rows')
  call check(needed == 5 .and. all(first == [0, 2, 4, 5]) .and. all(column(:5) == [0, 1, 0, 1, 2]), 'rows')
  call check(abs(block(1, 1, 2) - 2*pi) < 1e-11_c_double .and. abs(block(2, 2, 2) + 0.5625_c_double*pi) < &
             1e-11_c_double .and. maxval(abs(block(:, :, 1) + block(:, :, 2))) < 1e-11_c_double, 'a block')
  call check(maxval(abs(block(:, :, 5))) == 0 .and. all(row_flags == 0), 'of the ball beside it')

  call expect(hsp_periodic_get_morphometry(periodic, pressure=0.5_c_double, bending=2.0_c_double, gaussian=1.0_c_double, &
                                           energy=morphometric, d_centre=d_centre, d_radius=d_radius, flags=flags, &
                                           d_strain=d_strain, d_box=d_box, capacity=n), HSP_OK, &
              'hsp_periodic_get_morphometry')
  call check(abs(morphometric%mean - curvatures%mean) < 1e-11_c_double .and. all(flags == 0), 'morphometric energy')
  call check(abs(morphometric%value - totals%volume/2 - 2*curvatures%mean - curvatures%gauss) < 1e-11_c_double, 'its value')
  call check(abs(d_strain(1) + dot_product(radius, d_radius) - 1.5_c_double*totals%volume - 2*curvatures%mean) < &
             1e-11_c_double .and. abs(d_box(1) - d_strain(1)/4) < 1e-11_c_double, 'its strain')

  ! The centre of ball 1 moved by b - 3 a.
  call expect(hsp_periodic_query_point(periodic, point, images, size(images, kind=c_int32_t), needed), HSP_OK, &
              'hsp_periodic_query_point')
  call check(needed == 1 .and. images(1)%ball == 1 .and. all(images(1)%shift == [-3, 1, 0]), 'at a point')
  call expect(hsp_periodic_query_neighbours(periodic, 1_c_int32_t, images, size(images, kind=c_int32_t), needed), HSP_OK, &
              'hsp_periodic_query_neighbours')
  call check(needed == 2 .and. all(images(1:2)%ball == 0) .and. images(1)%shift(1) == 3, 'neighbours')
  call expect(hsp_periodic_query_ball(periodic, point, 1.5_c_double, images, size(images, kind=c_int32_t), needed), &
              HSP_OK, 'hsp_periodic_query_ball')
  call check(needed == 3 .and. images(1)%ball == 0 .and. all(images(1)%shift == [0, 1, 0]), 'at a ball')
  call check(all(images(2)%shift == [1, 1, 0]) .and. images(3)%ball == 1, 'more of them')
  call expect(hsp_periodic_query_pairs(periodic, HSP_PAIRS_ONCE, first, images, size(images, kind=c_int32_t), needed), &
              HSP_OK, 'hsp_periodic_query_pairs')
  call check(needed == 2 .and. all(first == [0, 2, 2, 2]) .and. all(images(1:2)%ball == 1), 'pairs')
  call check(all(images(1)%shift == [-4, 0, 0]) .and. all(images(2)%shift == [-3, 0, 0]), 'shifts of pairs')

  call check(c_sizeof(vertices(1)) == 80 .and. c_sizeof(arcs(1)) == 160 .and. c_sizeof(circles(1)) == 120, 'sizes of parts')
  call check(c_sizeof(faces(1)) == 32 .and. c_sizeof(loops(1)) == 32 .and. c_sizeof(loop_arcs(1)) == 40, 'sizes of faces')
  call expect(hsp_periodic_get_vertices(periodic, vertices, 1_c_int32_t, needed), HSP_OK, 'hsp_periodic_get_vertices')
  call check(needed == 0, 'no vertex')
  call expect(hsp_periodic_get_arcs(periodic, arcs, 1_c_int32_t, needed), HSP_OK, 'hsp_periodic_get_arcs')
  call expect(hsp_periodic_get_loop_arcs(periodic, loop_arcs, 1_c_int32_t, needed), HSP_OK, 'hsp_periodic_get_loop_arcs')
  call check(needed == 0, 'no arc')
  call expect(hsp_periodic_get_balls(periodic, balls, n, needed), HSP_OK, 'hsp_periodic_get_balls')
  call check(all(balls%faces == 1) .and. all(balls%component == component), 'a face of each ball')
  call expect(hsp_periodic_get_faces(periodic, faces, n, needed), HSP_OK, 'hsp_periodic_get_faces')
  call check(needed == 3 .and. faces(balls(2)%first_face + 1)%image%ball == 1, 'faces')
  call check(all(faces(balls(2)%first_face + 1)%image%shift == [-3, 0, 0]), 'the place of a ball')
  call expect(hsp_periodic_get_circles(periodic, circles, 2_c_int32_t, needed), HSP_OK, 'hsp_periodic_get_circles')
  call check(needed == 2 .and. all(circles%image(1)%ball == 0) .and. all(circles%image(2)%ball == 1), 'circles')
  call check(all(abs(circles%radius - 0.75_c_double) < 1e-15_c_double), 'their radii')
  call check(abs(circles(1)%centre(1) + circles(2)%centre(1)) < 1e-15_c_double, 'their centres')
  call check(all(circles%face(1)%id == balls(1)%first_face) .and. all(circles%face(2)%id == balls(2)%first_face), &
             'their faces')
  call expect(hsp_periodic_get_loops(periodic, loops, 4_c_int32_t, needed), HSP_OK, 'hsp_periodic_get_loops')
  call check(needed == 4 .and. all(loops%arcs == 0) .and. sum(loops%side) == 2, 'loops')
  call check(sum(loops%circle%id) == 2 .and. sum(loops%circle%shift(1)) == 1, 'circles of loops')
  call expect(hsp_periodic_check(periodic, invariant, id), HSP_OK, 'hsp_periodic_check')
  call check(invariant == 0 .and. id == HSP_NONE, 'no invariant is violated')
  call report_checks()
end program
