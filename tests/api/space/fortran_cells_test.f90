! Cells of free space and paths through it as a Fortran program sees them: every function is called, and records arrive
! field by field.
program fortran_cells_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use fortran_checks
  use hardsphere
  implicit none

  integer(c_int32_t), parameter :: n = 1
  real(c_double), parameter :: xyz(3, n) = reshape([2.0_c_double, 2.0_c_double, 2.0_c_double], [3, 1])
  real(c_double), parameter :: radius(n) = [2.0_c_double]
  real(c_double), parameter :: below(3) = [0.0_c_double, 0.0_c_double, -100.0_c_double]

  real(c_double), parameter :: above(3) = [2.0_c_double, 2.0_c_double, 8.0_c_double]
  real(c_double), parameter :: under(3) = [2.0_c_double, 2.0_c_double, -8.0_c_double]

  integer(c_int8_t), allocatable, target :: model_memory(:), cells_memory(:), paths_memory(:)
  type(c_ptr) :: model = c_null_ptr, cells = c_null_ptr, paths = c_null_ptr
  type(hsp_cells_limits) :: limits
  type(hsp_cells_counts) :: counts
  type(hsp_free_cell), allocatable :: records(:)
  type(hsp_cell_pair), allocatable :: pairs(:)
  type(hsp_arrangement) :: arrangement, spheres(n)
  type(hsp_paths_limits) :: paths_limits
  type(hsp_path) :: path
  real(c_double) :: points(3, 20)
  integer(c_int32_t) :: neighbours(100), needed, cell, last
  integer(c_size_t) :: bytes

  call check(c_sizeof(limits) == 40, 'size of hsp_cells_limits')
  call check(c_sizeof(counts) == 24, 'size of hsp_cells_counts')

  call expect(hsp_model_bytes(n, bytes), HSP_OK, 'hsp_model_bytes')
  allocate (model_memory(bytes))
  call expect(hsp_model_init(c_loc(model_memory), bytes, n, model), HSP_OK, 'hsp_model_init')
  call expect(hsp_model_set(model, n, xyz, radius), HSP_OK, 'hsp_model_set')
  call expect(hsp_cells_limits_init(limits, int(c_sizeof(limits), c_int32_t), n), HSP_OK, 'hsp_cells_limits_init')
  call check(limits%cubes == 66 .and. limits%adjacencies == 1064 .and. limits%cube_balls == 1, 'limits')
  call expect(hsp_cells_bytes(limits, bytes), HSP_OK, 'hsp_cells_bytes')
  call check(bytes <= hsp_cells_bytes_bound(limits%cubes, limits%entries, limits%cells, limits%adjacencies, &
                                            limits%landmarks, limits%facets, limits%corners, limits%cube_balls, &
                                            limits%cube_corners), 'hsp_cells_bytes_bound')
  allocate (cells_memory(bytes))
  call expect(hsp_cells_init(c_loc(cells_memory), bytes, limits, cells), HSP_OK, 'hsp_cells_init')
  call expect(hsp_cells_get_counts(cells, counts), HSP_E_STATE, 'counts of nothing')

  call expect(hsp_cells_compute(cells, model, limits), HSP_OK, 'hsp_cells_compute')
  call check(limits%cubes == 7 .and. limits%entries == 7, 'needed limits')
  call expect(hsp_cells_get_counts(cells, counts), HSP_OK, 'hsp_cells_get_counts')
  call check(counts%cubes == 7 .and. counts%power_cells == 7 .and. counts%runs == 18 .and. counts%regions == 1, 'counts')

  allocate (records(counts%cells), pairs(counts%adjacencies))
  call expect(hsp_cells_get_cells(cells, 0_c_int32_t, counts%cells, records), HSP_OK, 'hsp_cells_get_cells')
  last = counts%cells
  call check(records(1)%ball == HSP_NONE .and. records(1)%kind == HSP_CELL_RUN, 'the first cell')
  call check(records(last)%ball == 0 .and. records(last)%kind == HSP_CELL_AT_BALL, 'the last cell')
  call check(records(last)%high(3) - records(last)%low(3) > 3.9_c_double, 'its box')
  call expect(hsp_cells_get_pairs(cells, 0_c_int32_t, counts%adjacencies, pairs), HSP_OK, 'hsp_cells_get_pairs')
  call check(all(pairs%cell(1) < pairs%cell(2)), 'pairs')
  call expect(hsp_cells_get_neighbours(cells, 0_c_int32_t, neighbours, size(neighbours, kind=c_int32_t), needed), HSP_OK, &
              'hsp_cells_get_neighbours')
  call check(needed == records(1)%neighbours .and. needed > 0, 'neighbours')
  call expect(hsp_cells_locate(cells, below, cell), HSP_OK, 'hsp_cells_locate')
  call check(cell == 0, 'far below')
  call expect(hsp_cells_locate(cells, xyz(:, 1), cell), HSP_OK, 'hsp_cells_locate in a ball')
  call check(cell == HSP_NONE, 'in the ball')
  call expect(hsp_cells_check(cells, c_null_ptr, cell, last), HSP_OK, 'hsp_cells_check')
  call check(cell == 0 .and. last == HSP_NONE, 'no invariant is violated')

  call check(c_sizeof(arrangement) == 24, 'size of hsp_arrangement')
  call expect(hsp_model_arrangement(model, arrangement, spheres, words=0_c_int32_t, words_needed=needed), HSP_OK, &
              'hsp_model_arrangement')
  call check(arrangement%vertices == 0 .and. arrangement%edges == 0 .and. arrangement%faces == 1, 'one face')
  call check(spheres(1)%faces == 1 .and. needed == 0, 'of one sphere')

  call check(c_sizeof(paths_limits) == 44 .and. c_sizeof(path) == 32, 'sizes of records of paths')
  call expect(hsp_paths_limits_init(paths_limits, int(c_sizeof(paths_limits), c_int32_t), n), HSP_OK, &
              'hsp_paths_limits_init')
  call check(paths_limits%cubes == 66 .and. paths_limits%cube_balls == 1 .and. paths_limits%points == 1028, &
             'limits of paths')
  call expect(hsp_paths_bytes(paths_limits, bytes), HSP_OK, 'hsp_paths_bytes')
  call check(bytes <= hsp_paths_bytes_bound(paths_limits%cubes, paths_limits%entries, paths_limits%cells, &
                                            paths_limits%adjacencies, paths_limits%landmarks, paths_limits%facets, &
                                            paths_limits%corners, paths_limits%cube_balls, paths_limits%cube_corners, &
                                            paths_limits%points), 'hsp_paths_bytes_bound')
  allocate (paths_memory(bytes))
  call expect(hsp_paths_init(c_loc(paths_memory), bytes, paths_limits, paths), HSP_OK, 'hsp_paths_init')
  call expect(hsp_paths_find(paths, under, above, path), HSP_E_STATE, 'a path through nothing')
  call expect(hsp_paths_compute(paths, model, paths_limits), HSP_OK, 'hsp_paths_compute')
  call check(paths_limits%cubes == 7 .and. paths_limits%points == 0, 'needed limits of paths')
  call expect(hsp_paths_find(paths, under, above, path, paths_limits), HSP_OK, 'hsp_paths_find')
  call check(path%ends == HSP_PATH_CONNECTED .and. path%certified == 1 .and. path%clearance > 0, 'around the ball')
  call check(path%length > 16 .and. path%length < 30 .and. paths_limits%points >= path%points, 'its length')
  call expect(hsp_paths_get_points(paths, points, size(points, 2, c_int32_t), needed), HSP_OK, 'hsp_paths_get_points')
  call check(needed == path%points .and. needed > 2, 'how many points')
  call check(all(points(:, 1) == under) .and. all(points(:, needed) == above), 'its ends')
  call expect(hsp_paths_find(paths, xyz(:, 1), above, path), HSP_OK, 'hsp_paths_find from a centre')
  call check(path%ends == HSP_PATH_COVERED .and. path%points == 0, 'no path')
  call report_checks()
end program
