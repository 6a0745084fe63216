! The workspace as a Fortran program uses it: area, volume and gradient of sets of balls, one larger than the one before,
! against sets whose figures are known; and what becomes of it when balls are refused, there is no memory for many, the
! workspace is copied, or its executor shares the work or stops it.
program fortran_workspace_test
  use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_funloc, c_int, c_int32_t, c_int64_t, c_int8_t, &
                                         c_loc, c_null_ptr, c_size_t
  use fortran_checks
  use fortran_loops
  use hardsphere_workspace
  implicit none

  real(c_double), parameter :: pi = acos(-1.0_c_double)
  real(c_double), parameter :: away(3) = [5.0_c_double, 7.0_c_double, 9.0_c_double]
  type(hsp_workspace), target :: work
  type(hsp_path) :: path
  type(hsp_tunnel) :: tunnel, cheapest
  type(hsp_pore_passage) :: widest

  interface
    function getpagesize() result(bytes) bind(C)
      import :: c_int
      integer(c_int) :: bytes
    end function

    function getrlimit(resource, limit) result(failed) bind(C)
      import :: c_int, c_int64_t
      integer(c_int), value :: resource
      integer(c_int64_t), intent(out) :: limit(2)
      integer(c_int) :: failed
    end function

    function setrlimit(resource, limit) result(failed) bind(C)
      import :: c_int, c_int64_t
      integer(c_int), value :: resource
      integer(c_int64_t), intent(in) :: limit(2)
      integer(c_int) :: failed
    end function
  end interface

  call nothing_set()
  call view_without_boundary()
  call rows_of_balls(1_c_int32_t)
  call rows_of_balls(500_c_int32_t)
  call rows_of_balls(20_c_int32_t)
  call refused()
  call too_many()
  call copied()
  call boxes()
  call areas()
  call shells()
  call meshes()
  call ways()
  call shared()
  call stopped()
  call handed_on()
  call report_checks()

contains

  subroutine nothing_set()
    call expect(work%compute_boundary(), HSP_E_ARGUMENT, 'no balls were set')
    call expect(work%compute_topology(), HSP_E_STATE, 'no boundary')
    call expect(work%compute_surface(), HSP_E_STATE, 'no boundary for a surface')
    call expect(work%compute_surface_of([0], 1), HSP_E_STATE, 'no boundary for a surface of a shell')
    call expect(work%compute_view(), HSP_E_ARGUMENT, 'no model to be seen')
    call expect(work%compute_mesh(1.0_c_double), HSP_E_STATE, 'no boundary for triangles')
    call expect(work%compute_map(), HSP_E_ARGUMENT, 'no model for a map')
    call expect(work%compute_contacts(), HSP_E_STATE, 'no boundary for contacts')
    call expect(work%compute_cells(), HSP_E_ARGUMENT, 'no model for cells')
    call expect(work%find_path(away, away, path), HSP_E_ARGUMENT, 'no model for a path')
    call expect(work%set_moving(1.0_c_double, 0.0_c_double, HSP_TANGENT_OVERLAP), HSP_E_ARGUMENT, 'no model to move')
  end subroutine

  ! Two unit balls that meet across a face of a box, then eight such boxes as one, without a model.
  subroutine boxes()
    type(hsp_workspace), target :: fresh
    type(hsp_periodic_totals) :: one, eight
    type(hsp_periodic_counts) :: counts
    type(hsp_model_options) :: options
    real(c_double) :: xyz(3, 16), box(9)
    real(c_double), parameter :: radius(16) = 1
    integer(c_int32_t) :: first_bad
    integer :: i
    do i = 0, 7
      xyz(:, 2*i + 1) = 4*[mod(i, 2), mod(i/2, 2), i/4] + [0.5_c_double, 0.0_c_double, 0.0_c_double]
      xyz(:, 2*i + 2) = xyz(:, 2*i + 1) + [2.75_c_double, 0.0_c_double, 0.0_c_double]
    end do
    box = 0
    box([1, 5, 9]) = 4
    call expect(fresh%compute_periodic(2_c_int32_t, xyz, radius, box=box), HSP_OK, 'two balls in a box')
    call expect(hsp_periodic_measure(fresh%periodic, totals=one, capacity=0_c_int32_t), HSP_OK, 'what they have')
    call check(near(one%area, 4*pi*(2 - 0.375_c_double)), 'area: each loses a cap of height 3/8')
    call expect(hsp_model_options_init(options, options%struct_size), HSP_OK, 'options')
    options%probe = 0.5_c_double
    call expect(fresh%compute_periodic(2_c_int32_t, xyz, radius - 0.5_c_double, box=box, options=options), HSP_OK, &
                'smaller balls and a probe')
    call expect(hsp_periodic_measure(fresh%periodic, totals=eight, capacity=0_c_int32_t), HSP_OK, 'what they have, too')
    call check(near(eight%area, one%area), 'the same')
    call expect(fresh%compute_periodic(16_c_int32_t, xyz, radius, box=2*box, first_bad=first_bad), HSP_OK, 'eight boxes')
    call expect(hsp_periodic_measure(fresh%periodic, totals=eight, capacity=0_c_int32_t), HSP_OK, 'what these have')
    call check(near(eight%area, 8*one%area) .and. near(eight%volume, 8*one%volume), 'eight times as much')
    call expect(hsp_periodic_get_counts(fresh%periodic, counts), HSP_OK, 'hsp_periodic_get_counts')
    call check(counts%components == 8 .and. first_bad == HSP_NONE, 'eight components')
    call expect(fresh%compute_periodic(2_c_int32_t, xyz, [1.0_c_double, -1.0_c_double], box=box, first_bad=first_bad), &
                HSP_E_NEGATIVE, 'a negative radius')
    call check(first_bad == 1, 'that of the second ball')
    call expect(hsp_periodic_get_counts(fresh%periodic, counts), HSP_E_STATE, 'no results')
    call check(.not. c_associated(fresh%model), 'no model')
  end subroutine

  ! A row of n balls at distance 1 that a probe of 1/2 makes unit balls.
  subroutine row_of_halves(n, xyz, radius)
    integer(c_int32_t), intent(in) :: n
    real(c_double), intent(out) :: xyz(3, n), radius(n)
    integer :: i
    xyz = 0
    xyz(1, :) = [(real(i, c_double), i=1, n)]
    radius = 0.5_c_double
  end subroutine

  ! Bit for bit those of hsp_areas.
  subroutine areas()
    type(hsp_workspace), target :: fresh
    type(hsp_totals) :: totals, expected_totals
    type(hsp_boundary_counts) :: counts
    integer(c_int32_t), parameter :: sizes(4) = [2, 300, 5, 0]
    real(c_double), parameter :: probe = 0.5_c_double
    real(c_double) :: xyz(3, 300), radius(300), area(300), expected(300)
    integer(c_int8_t), allocatable, target :: memory(:)
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: n
    integer :: k
    do k = 1, size(sizes)
      n = sizes(k)
      call row_of_halves(n, xyz, radius)
      call expect(hsp_areas_bytes(n, bytes), HSP_OK, 'memory for areas')
      allocate (memory(bytes))
      call expect(hsp_areas(n, xyz, radius, probe, c_loc(memory), bytes, expected_totals, expected), HSP_OK, &
                  'hsp_areas')
      deallocate (memory)
      call expect(fresh%compute_areas(n, xyz, radius, probe, totals, area), HSP_OK, 'areas')
      call check(all(area(:n) == expected(:n)) .and. totals%volume == expected_totals%volume, 'areas of hsp_areas')
      call check(near(totals%area, 4*pi*n - 2*pi*max(n - 1, 0)), 'area of a row')
      call expect(hsp_boundary_get_counts(fresh%boundary, counts), HSP_OK, 'the boundary is there')
      call check(counts%balls == n, 'that of these balls')
      area = 0
      call expect(fresh%compute_areas(n, xyz, radius, probe, area=area), HSP_OK, 'areas alone')
      call check(all(area(:n) == expected(:n)), 'the same')
      call expect(fresh%compute_areas(n, xyz, radius, probe), HSP_OK, 'nothing asked for')
    end do
    call row_of_halves(2_c_int32_t, xyz, radius)
    call expect(fresh%compute_areas(2_c_int32_t, xyz, radius, -probe, totals), HSP_E_NEGATIVE, 'a negative probe')
    call expect(hsp_boundary_get_counts(fresh%boundary, counts), HSP_E_STATE, 'no balls, no boundary')
    call expect(fresh%compute_areas(-1_c_int32_t, xyz, radius, probe, totals), HSP_E_RANGE, 'in C 4294967295 balls')
  end subroutine

  ! Of a row and a ball apart, each on its own, and none; then of a row that takes more room.
  subroutine shells()
    type(hsp_workspace), target :: fresh
    type(hsp_surface_totals) :: totals
    type(hsp_surface_counts) :: patches
    integer(c_int32_t), allocatable :: none(:)
    real(c_double) :: xyz(3, 300), radius(300), found(0:1)
    integer(c_int32_t) :: shell
    call row_of_halves(3_c_int32_t, xyz, radius)
    radius = 1
    xyz(:, 3) = away
    call expect(fresh%set(3_c_int32_t, xyz, radius), HSP_OK, 'two balls and one')
    call expect(fresh%compute_boundary(), HSP_OK, 'their boundary')
    do shell = 0, 1
      call expect(fresh%compute_surface_of([shell], 1_c_int32_t), HSP_OK, 'the surface of a shell')
      call expect(hsp_surface_measure(fresh%surface, totals, capacity=0_c_int32_t), HSP_OK, 'its area')
      found(shell) = totals%area
    end do
    call check(near(minval(found), 4*pi) .and. near(maxval(found), 6*pi), 'a ball, and two that meet')
    call expect(fresh%compute_surface_of([0, 1], 2_c_int32_t), HSP_OK, 'the surface of both shells')
    call expect(hsp_surface_measure(fresh%surface, totals, capacity=0_c_int32_t), HSP_OK, 'their area')
    call check(near(totals%area, 10*pi), 'all of it')
    call expect(fresh%compute_surface_of(count=0_c_int32_t), HSP_OK, 'the surface without a choice')
    call expect(hsp_surface_measure(fresh%surface, totals, capacity=0_c_int32_t), HSP_OK, 'its area')
    call check(near(totals%area, 10*pi), 'all of it, too')
    allocate (none(0))
    call expect(fresh%compute_surface_of(none, 0_c_int32_t), HSP_OK, 'the surface of no shells')
    call expect(hsp_surface_measure(fresh%surface, totals, capacity=0_c_int32_t), HSP_OK, 'its area')
    call check(totals%area == 0, 'none of it')
    call expect(fresh%compute_surface_of([0, 2], 2_c_int32_t), HSP_E_ID, 'a shell that is not there')
    call expect(hsp_surface_get_counts(fresh%surface, patches), HSP_E_STATE, 'and no surface')
    call row_of_halves(300_c_int32_t, xyz, radius)
    radius = 1
    call expect(fresh%set(300_c_int32_t, xyz, radius), HSP_OK, 'a row')
    call expect(fresh%compute_boundary(), HSP_OK, 'its boundary')
    call expect(fresh%compute_surface_of([0], 1_c_int32_t), HSP_OK, 'the surface of its shell')
    call expect(hsp_surface_get_counts(fresh%surface, patches), HSP_OK, 'its patches')
    call check(patches%convex_patches == 300 .and. patches%saddle_patches == 299, 'balls and saddles of a row')
  end subroutine

  ! Of a small ball in a large probe's surface: as triangles this has room where that would have none.
  subroutine meshes()
    type(hsp_workspace), target :: fresh
    type(hsp_model_options) :: options
    type(hsp_mesh_counts) :: counts
    real(c_double), parameter :: xyz(3, 1) = 0, radius(1) = 0.1_c_double, edge = 0.002_c_double
    call expect(hsp_model_options_init(options, options%struct_size), HSP_OK, 'options')
    options%probe = 10
    call expect(fresh%set(1_c_int32_t, xyz, radius, options), HSP_OK, 'a ball')
    call expect(fresh%compute_boundary(), HSP_OK, 'its boundary')
    call expect(fresh%compute_surface(), HSP_OK, 'its surface')
    call expect(fresh%compute_mesh(edge), HSP_E_RANGE, 'more triangles than there may be')
    call expect(fresh%compute_mesh(edge, use_surface=.true.), HSP_OK, 'those of its surface')
    call expect(hsp_mesh_get_counts(fresh%mesh, counts), HSP_OK, 'how many')
    call check(2*counts%vertices - counts%triangles == 4 .and. counts%triangles > 10000, 'one closed surface')
    call expect(fresh%compute_mesh(2*edge, use_surface=.true.), HSP_OK, 'fewer of them')
    call expect(fresh%compute_mesh(edge), HSP_E_RANGE, 'still more than there may be')
    call expect(fresh%compute_mesh(1.0_c_double), HSP_OK, 'large ones of the boundary')
  end subroutine

  ! The widest tunnel between balls, and the cheapest one, which is another.
  subroutine ways()
    type(hsp_workspace), target :: fresh
    type(hsp_tunnel) :: widest, cheapest, expected
    integer(c_int32_t), parameter :: n = 100
    real(c_double), parameter :: steps(3) = [0.8191725_c_double, 0.6710436_c_double, 0.5497005_c_double]
    real(c_double), parameter :: from(3) = [8.0_c_double, 2.0_c_double, 5.0_c_double]
    real(c_double), parameter :: to(3) = [12.0_c_double, 5.0_c_double, 5.0_c_double]
    real(c_double) :: xyz(3, n), radius(n)
    integer :: i
    do i = 1, n
      xyz(:, i) = 10*modulo(i*steps, 1.0_c_double)
    end do
    radius = 1
    call expect(fresh%set(n, xyz, radius), HSP_OK, 'balls here and there')
    call expect(fresh%compute_pores(), HSP_OK, 'what is between them')
    call expect(fresh%find_tunnel(from=from, to=to, count=0_c_int32_t, tunnel=widest), HSP_OK, 'the widest tunnel')
    call expect(fresh%find_cheapest_tunnel(from=from, to=to, count=0_c_int32_t, tunnel=cheapest), HSP_OK, &
                'the cheapest')
    call check(widest%radius > cheapest%radius .and. widest%length > cheapest%length, 'narrower and shorter')
    call expect(hsp_pores_find_tunnel(fresh%pores, from, to, count=0_c_int32_t, tunnel=expected), HSP_OK, 'the widest')
    call check(widest%length == expected%length .and. widest%gate == expected%gate, 'the same')
    call expect(hsp_pores_find_cheapest_tunnel(fresh%pores, from, to, count=0_c_int32_t, tunnel=expected), HSP_OK, &
                'the cheapest of the handle')
    call check(cheapest%length == expected%length .and. cheapest%gate == expected%gate, 'the same, too')
  end subroutine

  ! By a loop of the caller's, with the same bits; by that of a request where there is one.
  subroutine shared()
    type(hsp_workspace), target :: alone, fresh
    type(hsp_executor), target :: good, bad
    type(hsp_boundary_request) :: request
    type(hsp_periodic_request) :: periodic_request
    integer(c_int32_t), parameter :: n = 60
    integer(c_int32_t), target :: runs
    real(c_double) :: xyz(3, n), radius(n), expected(n), area(n), box(9)
    runs = 0
    good = hsp_executor(workers=3, context=c_loc(runs), run=c_funloc(run_backwards))
    bad = hsp_executor(workers=3, run=c_funloc(run_nothing))
    call row_of_halves(n, xyz, radius)
    call expect(alone%compute_areas(n, xyz, radius, 0.5_c_double, area=expected), HSP_OK, 'by one worker')
    fresh%executor = c_loc(good)
    call expect(fresh%compute_areas(n, xyz, radius, 0.5_c_double, area=area), HSP_OK, 'by three workers')
    call check(runs > 0 .and. all(area == expected), 'the same areas')
    fresh%executor = c_loc(bad)
    call expect(fresh%compute_boundary(), HSP_E_EXECUTOR, 'a loop that does nothing')
    runs = 0
    request%executor = c_loc(good)
    call expect(fresh%compute_boundary(request), HSP_OK, 'the loop of a request')
    call check(runs > 0, 'which has run')
    request%executor = c_null_ptr
    call expect(fresh%compute_boundary(request), HSP_OK, 'a request without a loop')
    box = 0
    box([1, 5, 9]) = 70
    call expect(fresh%compute_periodic(n, xyz, radius, box), HSP_E_EXECUTOR, 'a loop that does nothing in a box')
    call expect(fresh%compute_periodic_with(n, xyz, radius, box), HSP_OK, 'no request in a box')
    runs = 0
    periodic_request%executor = c_loc(good)
    call expect(fresh%compute_periodic_with(n, xyz, radius, box, periodic_request), HSP_OK, 'the loop of one in a box')
    call check(runs > 0, 'which has run there')
    fresh%executor = c_null_ptr
    call expect(fresh%compute_boundary(), HSP_OK, 'no loop any more')
  end subroutine

  subroutine stopped()
    type(hsp_workspace), target :: fresh
    type(hsp_executor), target :: executor
    type(hsp_boundary_counts) :: counts
    integer(c_int32_t), parameter :: n = 300
    integer(c_int32_t), target :: asked
    real(c_double) :: xyz(3, n), radius(n)
    asked = 0
    executor = hsp_executor(context=c_loc(asked), proceed=c_funloc(stop_at_once))
    call row_of_halves(n, xyz, radius)
    call expect(fresh%compute_areas(n, xyz, radius, 0.5_c_double), HSP_OK, 'a row')
    fresh%executor = c_loc(executor)
    call expect(fresh%compute_boundary(), HSP_E_STOPPED, 'a boundary that is stopped')
    call expect(hsp_boundary_get_counts(fresh%boundary, counts), HSP_E_STATE, 'and is not there')
    call check(asked == 1, 'a question')
    fresh%executor = c_null_ptr
    call expect(fresh%compute_boundary(), HSP_OK, 'one that is not')
    call check(asked == 1, 'no question')
  end subroutine

  ! Every function that can hands the executor on: one that cannot share anything is refused by each. Nothing is there
  ! then, and afterwards all is as before.
  subroutine handed_on()
    type(hsp_workspace), target :: fresh
    type(hsp_executor), target :: executor
    executor = hsp_executor(workers=2)
    call each(fresh, c_null_ptr, HSP_OK)
    call each(fresh, c_loc(executor), HSP_E_ARGUMENT)
    call each(fresh, c_null_ptr, HSP_OK)
    fresh%executor = c_loc(executor)
    call expect(fresh%compute_view(), HSP_OK, 'a view has its own in its options')
    call expect(fresh%compute_map(), HSP_OK, 'a map has its own in its options')
    call expect(fresh%compute_pores(), HSP_OK, 'pores have their own in their options')
  end subroutine

  ! All is there first. Each comes before the one that it is computed from, which has nothing when it has failed.
  subroutine each(work, executor, expected)
    type(hsp_workspace), intent(inout), target :: work
    type(c_ptr), intent(in) :: executor
    integer(c_int32_t), intent(in) :: expected
    integer(c_int32_t), parameter :: n = 20
    real(c_double) :: xyz(3, n), radius(n), box(9)
    type(hsp_tunnel) :: tunnel
    type(hsp_path) :: path
    type(hsp_mesh_counts) :: mesh
    type(hsp_surface_counts) :: surface
    integer(c_int32_t) :: there
    there = merge(HSP_OK, HSP_E_STATE, expected == HSP_OK)
    call row_of_halves(n, xyz, radius)
    box = 0
    box([1, 5, 9]) = 30
    work%executor = c_null_ptr
    call expect(work%compute_areas(n, xyz, radius, 0.5_c_double), HSP_OK, 'balls and their boundary')
    call expect(work%compute_surface(), HSP_OK, 'their surface')
    call expect(work%compute_pores(), HSP_OK, 'their pores')
    work%executor = executor
    call expect(work%compute_mesh(0.5_c_double), expected, 'triangles')
    call expect(work%compute_mesh(0.5_c_double, use_surface=.true.), expected, 'triangles of the surface')
    call expect(hsp_mesh_get_counts(work%mesh, mesh), there, 'how many')
    call expect(work%compute_surface(), expected, 'a surface')
    call expect(work%compute_surface_of([0], 1_c_int32_t), expected, 'a surface of a shell')
    call expect(hsp_surface_get_counts(work%surface, surface), there, 'patches')
    call expect(work%compute_topology(), expected, 'a topology')
    call expect(work%compute_contacts(), expected, 'contacts')
    call expect(work%compute_cells(), expected, 'cells')
    call expect(work%find_path(away, -away, path), expected, 'a path')
    call expect(work%find_tunnel(from=away, to=-away, count=0_c_int32_t, tunnel=tunnel), expected, 'a tunnel')
    call expect(work%find_cheapest_tunnel(from=away, to=-away, count=0_c_int32_t, tunnel=tunnel), expected, &
                'the cheapest tunnel')
    call expect(work%set_moving(1.0_c_double, 0.0_c_double, HSP_TANGENT_OVERLAP, radius), expected, 'balls that move')
    call expect(work%compute_periodic(n, xyz, radius, box), expected, 'balls in a box')
    call expect(work%compute_pores_periodic(), there, 'their pores')
    call expect(work%compute_boundary(), expected, 'a boundary')
    call expect(work%set(n, xyz, radius), expected, 'balls')
    call expect(work%compute_areas(n, xyz, radius, 0.5_c_double), expected, 'areas')
  end subroutine

  ! A view of the boundary is none of the model alone.
  subroutine view_without_boundary()
    type(hsp_workspace), target :: fresh
    type(hsp_view_info) :: info
    real(c_double), parameter :: xyz(3, 1) = 0, radius(1) = 1
    call expect(fresh%set(1_c_int32_t, xyz, radius), HSP_OK, 'a ball')
    call expect(fresh%compute_view(use_boundary=.true.), HSP_E_ARGUMENT, 'no boundary to be seen')
    call expect(fresh%compute_view(), HSP_OK, 'the model is seen')
    call expect(fresh%compute_view(use_boundary=.true.), HSP_E_ARGUMENT, 'still no boundary to be seen')
    call expect(hsp_view_get_info(fresh%view, info), HSP_E_STATE, 'and no view')
  end subroutine

  ! n unit balls in a row at distance 1: each inner one loses two caps of height 1/2, and what is left is symmetric.
  subroutine rows_of_balls(n)
    integer(c_int32_t), intent(in) :: n
    real(c_double) :: xyz(3, n), radius(n), area(n), gradient(3, n)
    type(hsp_totals) :: totals
    type(hsp_energy) :: energy
    type(hsp_topology_counts) :: counts
    type(hsp_view_info) :: info
    type(hsp_map_info) :: seen
    type(hsp_surface_totals) :: surface, shares(n)
    type(hsp_surface_counts) :: patches
    type(hsp_surface_part_counts) :: map
    type(hsp_surface_patch) :: patch(1)
    type(hsp_mesh_counts) :: coarse, fine, smooth
    real(c_double) :: sigma(n)
    integer(c_int32_t) :: invariant, id, first_bad, needed
    integer(c_int32_t) :: status
    integer :: i
    xyz = 0
    xyz(1, :) = [(real(i, c_double), i=1, n)]
    radius = 1
    status = work%set(n, xyz, radius)
    if (status == HSP_OK) status = work%compute_boundary()
    if (status == HSP_OK) status = hsp_boundary_measure(work%boundary, totals=totals, area=area, capacity=n)
    if (status == HSP_OK) status = hsp_boundary_get_gradient(work%boundary, tension=1.0_c_double, energy=energy, &
      d_centre=gradient, capacity=n)
    call expect(status, HSP_OK, 'area and gradient')
    call check(near(totals%area, 4*pi*n - 2*pi*(n - 1)), 'area')
    call check(near(totals%volume, 4*pi/3*n - 2*(n - 1)*pi*5/24), 'volume: caps have pi h^2 (3 - h)/3')
    call check(near(sum(area), totals%area), 'the areas of the balls')
    ! Only the ends feel anything: 2 pi dr/dd per pair at distance d, which is pi for each of the two caps.
    call check(all(abs(gradient(2:3, :)) < 1e-12_c_double), 'nothing pulls sideways')
    if (n > 1) call check(near(gradient(1, n), 2*pi) .and. near(gradient(1, 1), -2*pi), 'the ends pull outwards')
    call expect(work%compute_topology(), HSP_OK, 'topology')
    call expect(hsp_topology_get_counts(work%topology, counts), HSP_OK, 'its counts')
    call check(counts%components == 1 .and. counts%shells == 1, 'one piece')
    call expect(work%compute_surface(), HSP_OK, 'surface')
    call expect(hsp_surface_get_counts(work%surface, patches), HSP_OK, 'its counts')
    call check(patches%convex_patches == n .and. patches%saddle_patches == n - 1, 'a saddle between any two')
    call expect(hsp_surface_measure(work%surface, surface, shares, n), HSP_OK, 'its areas')
    call check(near(surface%area, totals%area) .and. near(surface%volume, totals%volume), 'without a probe: the boundary')
    call check(near(sum(shares%area), surface%area), 'the shares of the balls')
    energy%area = 0
    gradient = 0
    call expect(hsp_surface_get_gradient(work%surface, tension=1.0_c_double, energy=energy, d_centre=gradient, &
                                         capacity=n), HSP_OK, 'its gradient')
    call check(near(energy%area, totals%area), 'the energy is the area')
    if (n > 1) call check(near(gradient(1, n), 2*pi) .and. near(gradient(1, 1), -2*pi), 'the ends pull as before')
    ! Weights 1 .. n: of the inner balls, which have all the same area, the weights at both ends count.
    sigma = [(real(i, c_double), i=1, n)]
    first_bad = 0
    call expect(hsp_surface_get_gradient(work%surface, sigma=sigma, tension=1.0_c_double, energy=energy, &
                                         d_centre=gradient, capacity=n, first_bad=first_bad), HSP_OK, 'with weights')
    call check(near(energy%area, sum(sigma*area)) .and. first_bad == HSP_NONE, 'the weighted area')
    if (n > 1) call check(near(gradient(1, n), pi*(2*n - 1)), 'the last pair pulls with the sum of its weights')
    call expect(hsp_surface_compute_shells(work%surface, work%boundary, [0], 1), HSP_OK, 'of its only shell')
    call expect(hsp_surface_measure(work%surface, surface, capacity=0), HSP_OK, 'its areas again')
    call check(near(surface%area, totals%area), 'which is all')
    call expect(hsp_surface_get_part_counts(work%surface, map), HSP_OK, 'its parts')
    call check(map%shells == 1 .and. map%patches == 2*n - 1 .and. map%edges == 2*n - 2, 'balls and saddles')
    call expect(hsp_surface_get_patches(work%surface, 0, 1, patch), HSP_OK, 'its first patch')
    call check(patch(1)%kind == HSP_PATCH_CONVEX .and. (n == 1 .or. &
               hsp_surface_left(work%surface, patch(1)%h) == 0), 'the patch beside its edge')
    call expect(hsp_surface_check(work%surface, invariant, id), HSP_OK, 'its invariants')
    call expect(work%compute_mesh(1.0_c_double), HSP_OK, 'triangles')
    call expect(hsp_mesh_get_counts(work%mesh, coarse), HSP_OK, 'how many')
    call expect(work%compute_mesh(0.5_c_double), HSP_OK, 'smaller triangles')
    call expect(hsp_mesh_get_counts(work%mesh, fine), HSP_OK, 'how many more')
    call check(2*fine%vertices - fine%triangles == 4 .and. fine%triangles > coarse%triangles, 'one closed surface')
    call expect(work%compute_mesh(0.5_c_double, use_surface=.true.), HSP_OK, 'triangles of the surface')
    call expect(hsp_mesh_get_counts(work%mesh, smooth), HSP_OK, 'as many')
    call check(smooth%triangles == fine%triangles, 'without a probe: those of the boundary')
    call expect(work%compute_view(), HSP_OK, 'view of the model')
    call expect(work%compute_view(use_boundary=.true.), HSP_OK, 'view of the boundary')
    call expect(hsp_view_get_info(work%view, info), HSP_OK, 'its figures')
    call check(info%pieces == n, 'every ball of the row is seen')
    call expect(work%compute_map(), HSP_OK, 'map')
    call expect(hsp_map_get_info(work%map, seen), HSP_OK, 'its figures')
    call check(seen%balls == n .and. seen%faces == n + 1 .and. seen%components == 1, 'each in one face')
    call check(near(seen%area, pi + (n - 1)*(pi/3 + sqrt(0.75_c_double))), 'discs at distance 1')
    call expect(work%compute_contacts(), HSP_OK, 'contacts')
    call expect(hsp_contacts_get_pairs(work%contacts, capacity=0, needed=needed), merge(HSP_OK, HSP_E_CAPACITY, n == 1), &
                'how many')
    call check(needed == n - 1, 'each touches the next')
    call expect(work%compute_cells(), HSP_OK, 'cells')
    call expect(hsp_cells_check(work%cells, work%topology, invariant, id), HSP_OK, 'their invariants')
    call expect(work%find_path(away, -away, path), HSP_OK, 'a path')
    call check(path%ends == HSP_PATH_CONNECTED .and. path%certified == 1, 'past all balls')
    call expect(work%compute_pores(), HSP_OK, 'pores')
    call expect(hsp_pores_widest(work%pores, away, -away, widest), HSP_OK, 'the widest probe on that way')
    call check(widest%passes == 1 .and. widest%radius > 0, 'some probe passes')
    call expect(work%find_tunnel(from=away, to=-away, count=0_c_int32_t, tunnel=tunnel), HSP_OK, 'a tunnel')
    call check(tunnel%there == 1 .and. tunnel%points >= 2, 'some probe gets through')
    call expect(work%find_cheapest_tunnel(from=away, to=-away, count=0_c_int32_t, tunnel=cheapest), HSP_OK, &
                'the cheapest tunnel')
    call check(cheapest%there == 1 .and. cheapest%radius <= tunnel%radius, 'it is no wider')
    call expect(work%set_moving(1.0_c_double, 0.0_c_double, HSP_TANGENT_OVERLAP, sigma), HSP_OK, 'balls that move')
    call expect(hsp_moving_gradient(work%moving, energy, capacity=0), HSP_OK, 'their energy')
    call check(near(energy%area, sum(sigma*area)) .and. near(energy%value, energy%area), 'their weighted area')
    call expect(work%set_moving(2.0_c_double, 3.0_c_double, HSP_TANGENT_OVERLAP), HSP_OK, 'with a pressure')
    call expect(hsp_moving_gradient(work%moving, energy, capacity=0), HSP_OK, 'their energy')
    call check(near(energy%value, 2*totals%area + 3*totals%volume), 'that of area and volume')
    call expect(work%set_moving(1.0_c_double, 0.0_c_double, -1_c_int32_t), HSP_E_ARGUMENT, 'an unknown tangency')
  end subroutine

  subroutine refused()
    real(c_double) :: xyz(3, 1), radius(1)
    integer(c_int32_t) :: first_bad
    type(hsp_boundary_counts) :: counts
    xyz = 0
    radius = -1
    first_bad = HSP_NONE
    call expect(work%set(1_c_int32_t, xyz, radius, first_bad=first_bad), HSP_E_NEGATIVE, 'a negative radius')
    call check(first_bad == 0, 'the first bad ball')
    call expect(hsp_boundary_get_counts(work%boundary, counts), HSP_E_STATE, 'results of balls that are gone')
    call expect(work%compute_boundary(), HSP_E_STATE, 'balls that were refused')
    radius = 1
    call expect(work%set(1_c_int32_t, xyz, radius), HSP_OK, 'a good ball')
    call expect(work%set(300000000_c_int32_t, xyz, radius), HSP_E_RANGE, 'more balls than there may be')
    call expect(work%compute_boundary(), HSP_E_STATE, 'the balls of before')
    call expect(work%set(1_c_int32_t, xyz, radius), HSP_OK, 'a good ball again')
    call expect(work%set(-1_c_int32_t, xyz, radius), HSP_E_RANGE, 'in C 4294967295 balls')
    call expect(work%compute_boundary(), HSP_E_STATE, 'the balls of before, too')
    call expect(work%set(0_c_int32_t, xyz, radius), HSP_OK, 'to set no balls')
    call expect(work%compute_boundary(), HSP_OK, 'no balls')
    call expect(hsp_boundary_get_counts(work%boundary, counts), HSP_OK, 'counts of no balls')
    call check(counts%balls == 0, 'no balls')
  end subroutine

  ! Where there is memory for a model and none for its boundary: a small set is not refused for a large one.
  subroutine too_many()
    integer(c_int), parameter :: address_space = 9 ! RLIMIT_AS of Linux
    integer(c_int32_t), parameter :: n = 100000, few = 2
    type(hsp_workspace), target :: fresh
    type(hsp_totals) :: totals
    real(c_double), allocatable :: xyz(:, :), radius(:)
    integer(c_int64_t) :: before(2), pages
    integer(c_size_t) :: bytes
    integer :: unit
    allocate (xyz(3, n), radius(n))
    call row_of_halves(n, xyz, radius)
    open (newunit=unit, file='/proc/self/statm', action='read')
    read (unit, *) pages
    close (unit)
    call expect(hsp_model_bytes(n, bytes), HSP_OK, 'memory for many balls')
    call check(getrlimit(address_space, before) == 0, 'how much there may be')
    call check(setrlimit(address_space, [getpagesize()*pages + bytes + bytes/8, before(2)]) == 0, 'a little more')
    call expect(fresh%compute_areas(n, xyz, radius, 0.5_c_double, totals), HSP_E_MEMORY, 'no memory for a boundary')
    call check(c_associated(fresh%model) .and. .not. c_associated(fresh%boundary), 'a model is there')
    call expect(fresh%compute_areas(few, xyz, radius, 0.5_c_double, totals), HSP_OK, 'two balls')
    call check(near(totals%area, 6*pi), 'their area')
    call check(setrlimit(address_space, before) == 0, 'as before')
  end subroutine

  ! The memory of a copy lies elsewhere, but its handles are those of the original: they are as good as that is.
  subroutine copied()
    type(hsp_workspace), target :: copy
    type(hsp_boundary_counts) :: counts
    copy = work
    call expect(hsp_boundary_get_counts(copy%boundary, counts), HSP_OK, 'the handle of the original')
    call check(c_associated(copy%boundary, work%boundary), 'one handle')
  end subroutine
end program
