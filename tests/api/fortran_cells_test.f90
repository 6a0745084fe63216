! Cells of free space as a Fortran program sees them: every function is called, and records arrive field by field.
program fortran_cells_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use fortran_checks
  use hardsphere
  implicit none

  integer(c_int32_t), parameter :: n = 1
  real(c_double), parameter :: xyz(3, n) = reshape([2.0_c_double, 2.0_c_double, 2.0_c_double], [3, 1])
  real(c_double), parameter :: radius(n) = [2.0_c_double]
  real(c_double), parameter :: below(3) = [0.0_c_double, 0.0_c_double, -100.0_c_double]

  integer(c_int8_t), allocatable, target :: model_memory(:), cells_memory(:)
  type(c_ptr) :: model = c_null_ptr, cells = c_null_ptr
  type(hsp_cells_limits) :: limits
  type(hsp_cells_counts) :: counts
  type(hsp_free_cell), allocatable :: records(:)
  type(hsp_cell_pair), allocatable :: pairs(:)
  type(hsp_arrangement) :: arrangement, spheres(n)
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
  call report_checks()
end program
