# The surface that a rolling probe leaves, and triangles.
hsp_part(smooth
  STANDS_ON union wide
  HEADERS surface mesh
  SOURCES
    surface/actual_balls.cpp
    surface/actual_numbers.cpp
    surface/arc_figures.cpp
    surface/concave_patches.cpp
    surface/covered_gaps.cpp
    surface/creased_patches.cpp
    surface/creases.cpp
    surface/cusped_circles.cpp
    surface/cut_patches.cpp
    surface/degenerate_balls.cpp
    surface/near_probes.kernel.cpp
    surface/near_vertices.cpp
    surface/patch_corners.cpp
    surface/patch_loops.cpp
    surface/probe_caps.cpp
    surface/probe_grid.cpp
    surface/saddle.cpp
    surface/saddle_sums.kernel.cpp
    surface/surface_areas.cpp
    surface/surface_gradients.cpp
    surface/surface_builder.cpp
    surface/surface_check.cpp
    surface/surface_map.cpp
    surface/surface_patches.cpp
    surface/surface_positions.cpp
    surface/surface_shells.cpp
    surface/probe_triangles.kernel.cpp
    surface/weighted_joints.cpp
    mesh/boundary_curves.cpp
    mesh/boundary_outline.cpp
    mesh/concave_outline.cpp
    mesh/convex_outline.cpp
    mesh/fixed_edges.cpp
    mesh/mesh_builder.cpp
    mesh/patch_from_loops.cpp
    mesh/pinched_cells.cpp
    mesh/pinched_patch.cpp
    mesh/sphere_triangulation.cpp
    mesh/saddle_band.cpp
    mesh/saddle_grids.cpp
    mesh/spherical_patch.cpp
    mesh/surface_curves.cpp
    mesh/surface_outline.cpp
    mesh/surface_vertices.cpp
  SHIMS hsp_surface hsp_surface_records hsp_mesh
  LEVELS shims -O2 mesh -O2)
