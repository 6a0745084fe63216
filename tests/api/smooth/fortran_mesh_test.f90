! Triangles as a Fortran program makes them: of three balls and the smooth surface over them, closed, in the order of
! their patches, with areas that come near the exact ones.
program fortran_mesh_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int8_t, c_loc, c_ptr, c_size_t, c_sizeof
  use fortran_checks
  use hardsphere_workspace
  implicit none

  integer(c_int32_t), parameter :: n = 3
  real(c_double), parameter :: xyz(3, n) = reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    2.0_c_double, 0.0_c_double, 0.0_c_double, &
                                                    1.0_c_double, 1.5_c_double, 0.0_c_double], [3, 3])
  real(c_double), parameter :: radius(n) = [1.5_c_double, 1.5_c_double, 1.25_c_double]
  real(c_double), parameter :: edge = 0.3_c_double
  type(hsp_workspace), target :: work
  type(hsp_model_options) :: options
  type(hsp_totals) :: totals
  type(hsp_surface_totals) :: smooth
  integer(c_int8_t), allocatable, target :: memory(:)
  type(c_ptr) :: mesh

  call expect(hsp_model_options_init(options, int(c_sizeof(options), c_int32_t)), HSP_OK, 'options')
  options%probe = 1.4_c_double
  call expect(work%set(n, xyz, radius, options), HSP_OK, 'three balls')
  call expect(work%compute_boundary(), HSP_OK, 'their boundary')
  call expect(hsp_boundary_measure(work%boundary, totals=totals, capacity=0_c_int32_t), HSP_OK, 'its area')
  call expect(work%compute_surface(), HSP_OK, 'their smooth surface')
  call expect(hsp_surface_measure(work%surface, smooth, capacity=0_c_int32_t), HSP_OK, 'the area of that')
  call make(.false.)
  call read_back(totals%area, 1)
  call make(.true.)
  call read_back(smooth%area, 3)
  call report_checks()

contains

  ! With the limits that are expected to suffice, and what is asked for otherwise.
  subroutine make(of_surface)
    logical, intent(in) :: of_surface
    type(hsp_mesh_limits) :: limits
    integer(c_size_t) :: bytes
    integer(c_int32_t) :: status, size
    size = int(c_sizeof(limits), c_int32_t)
    if (of_surface) then
      call expect(hsp_mesh_limits_init_surface(limits, size, work%surface, edge), HSP_OK, 'limits of a surface')
    else
      call expect(hsp_mesh_limits_init(limits, size, work%boundary, edge), HSP_OK, 'limits of a boundary')
    end if
    do
      call expect(hsp_mesh_bytes(limits, bytes), HSP_OK, 'bytes')
      call check(bytes <= hsp_mesh_bytes_bound(limits%balls, limits%curves, limits%vertices, limits%triangles, &
                                               limits%points), 'no more bytes than the bound')
      if (allocated(memory)) deallocate (memory)
      allocate (memory(bytes))
      call expect(hsp_mesh_init(c_loc(memory), bytes, limits, mesh), HSP_OK, 'a mesh')
      if (of_surface) then
        status = hsp_mesh_compute_surface(mesh, work%surface, edge, limits)
      else
        status = hsp_mesh_compute(mesh, work%boundary, edge, limits)
      end if
      if (status /= HSP_E_CAPACITY) exit
    end do
    call expect(status, HSP_OK, 'triangles')
  end subroutine

  subroutine read_back(area, kinds_there)
    real(c_double), intent(in) :: area
    integer, intent(in) :: kinds_there
    type(hsp_mesh_counts) :: counts
    real(c_double), allocatable :: places(:, :), normals(:, :), areas(:)
    integer(c_int32_t), allocatable :: vertex_balls(:), corners(:, :), kinds(:), patches(:), balls(:)
    integer(c_int32_t) :: needed, first, count, next, kind
    integer :: seen
    call expect(hsp_mesh_get_counts(mesh, counts), HSP_OK, 'counts')
    call check(counts%vertices - counts%triangles/2 == 2, 'one sphere')
    allocate (places(3, counts%vertices), normals(3, counts%vertices), areas(counts%vertices))
    allocate (vertex_balls(counts%vertices), corners(3, counts%triangles), kinds(counts%triangles))
    allocate (patches(counts%triangles), balls(counts%triangles))
    call expect(hsp_mesh_get_vertices(mesh, places, normals, areas, vertex_balls, counts%vertices, needed), HSP_OK, &
                'vertices')
    call check(needed == counts%vertices, 'number of vertices')
    call check(all(abs(sum(normals**2, 1) - 1) < 1e-12_c_double), 'normals have length 1')
    call check(sum(areas) < area .and. sum(areas) > 0.95*area, 'the triangles are a little smaller')
    call check(all(vertex_balls >= 0 .and. vertex_balls < n), 'balls of vertices')
    call expect(hsp_mesh_get_triangles(mesh, corners, kinds, patches, balls, counts%triangles, needed), HSP_OK, &
                'corners')
    call check(needed == counts%triangles .and. all(balls >= 0 .and. balls < n), 'balls of triangles')
    call check(all(corners >= 0 .and. corners < counts%vertices), 'corners')
    seen = 0
    do kind = HSP_PATCH_CONVEX, HSP_PATCH_CIRCLE_SADDLE
      if (any(kinds == kind)) seen = seen + 1
    end do
    call check(seen == kinds_there, 'kinds of patches')
    next = 0
    do while (next < counts%triangles)
      call expect(hsp_mesh_get_patch(mesh, patches(next + 1), first, count), HSP_OK, 'a patch')
      call check(first == next .and. count > 0, 'triangles of a patch')
      if (count <= 0) exit
      next = next + count
    end do
  end subroutine
end program
