# The space that balls leave free: cells, paths, and every probe at once.
hsp_part(space
  STANDS_ON wide boxes
  HEADERS cells paths pores pockets
  SOURCES
    cells/arrangement.cpp
    cells/cell_location.cpp
    cells/cube_contacts.cpp
    cells/cube_cover.cpp
    cells/empty_runs.cpp
    cells/facet_overlay.cpp
    cells/facet_parts.cpp
    cells/free_space_builder.cpp
    cells/free_space_check.cpp
    cells/member_blocks.cpp
    cells/power_cell.cpp
    cells/power_cell.kernel.cpp
    cells/power_polytope.cpp
    cells/power_predicates.cpp
    cells/side_facets.cpp
    paths/cell_crossing.cpp
    paths/cell_search.cpp
    paths/free_segments.cpp
    paths/path_finder.cpp
    tangents/tangent_point.cpp
    pores/ascent.cpp
    pores/balls_around.cpp
    pores/critical_points.cpp
    pores/cube_halves.kernel.cpp
    pores/known_points.cpp
    pores/leaf_points.cpp
    pores/point_records.cpp
    pores/pore_balls.cpp
    pores/pores_builder.cpp
    pores/tied_balls.cpp
    pores/way_up.cpp
    pockets/class_tree.cpp
    pockets/plugs.cpp
    pockets/pockets.cpp
    pockets/region_finder.cpp
    pockets/tunnel.cpp
  SHIMS hsp_cells hsp_paths hsp_pores hsp_pores_pockets
  LEVELS paths -O2 tangents -O2)
