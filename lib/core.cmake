# The core: all that the stable functions reach (CORE.md), which every build has.
hsp_part(ground
  SOURCES
    core/elementary.cpp
    core/executor.cpp
    core/key_ranks.kernel.cpp
    core/sorting.cpp
    exact/exact_predicates.cpp exact/power_vertex.cpp)
hsp_part(balls
  STANDS_ON ground
  SOURCES
    model/ball_set.cpp
    model/block_sweep.cpp
    model/cube_grid.cpp
    model/cube_index.cpp
    model/digit_sort.cpp
    model/halo.cpp
    model/meeting.cpp
    model/ordered_balls.cpp
    model/pair_block.kernel.cpp
    model/queries.cpp
    model/query_hits.cpp
    model/query_hits.kernel.cpp
    model/rounded_block.kernel.cpp
    model/radius_levels.cpp
    model/row_directory.cpp
    model/set_digest.cpp
  APART
    model/neighbour_lists.cpp
    model/packing_statistics.cpp
    model/ray_query.cpp
    model/vertical_ray.cpp
  SHIMS_APART versioned_struct hsp_status element_radii element_symbols hsp_element hsp_model hsp_query hsp_neighbours
    hsp_packing hsp_ray)
hsp_part(union
  STANDS_ON balls
  SOURCES
    sphere/arc_geometry.cpp
    sphere/cap_boxes.cpp
    sphere/cap_clusters.cpp
    sphere/candidate_block.kernel.cpp
    sphere/caps.cpp
    sphere/cell_cutting.cpp
    sphere/cell_ties.cpp
    sphere/cube_candidates.cpp
    sphere/few_caps.kernel.cpp
    sphere/exposed_caps.cpp
    sphere/float_caps.kernel.cpp
    sphere/great_circles.cpp
    sphere/lane_search.cpp
    sphere/meridian_sectors.cpp
    sphere/near_balls.kernel.cpp
    sphere/near_caps.cpp
    sphere/outer_cell.cpp
    sphere/outer_cell.kernel.cpp
    sphere/pair_sweep.kernel.cpp
    sphere/pairs_of_few.cpp
    sphere/root_discriminants.kernel.cpp
    sphere/vertex_finder.cpp
    boundary/boundary_builder.cpp
    boundary/boundary_check.cpp
    boundary/boundary_worker.cpp
    boundary/components.cpp
    boundary/faces.cpp
    measure/arc_batches.cpp
    measure/arc_sums.kernel.cpp
    measure/areas.cpp
    measure/boundary_metric_check.cpp
    measure/boundary_positions.cpp
    measure/gradients.cpp
    measure/tangency.cpp
    topology/regions.cpp
    topology/cut_arcs.cpp
    topology/positions.cpp
    topology/shell_volumes.cpp
    topology/simple_faces.cpp
    topology/subdivision.cpp
    topology/topology_builder.cpp
    topology/topology_check.cpp
    topology/traversal.cpp
    contacts/chord_clipper.cpp
    contacts/chord_cuts.kernel.cpp
    contacts/chord_ends.cpp
    contacts/chord_ends.kernel.cpp
    contacts/chord_walk.cpp
    contacts/contact_measures.cpp
    contacts/contact_measures.kernel.cpp
    contacts/contacts_builder.cpp
    contacts/contacts_check.cpp
    contacts/empty_cell.cpp
  APART
    boundary/half_edge_links.cpp
    boundary/point_location.cpp
  LEVELS sphere -O2 boundary -O2 boundary_half_edge_links -O3 boundary_point_location -O3
  SHIMS hsp_boundary hsp_measure hsp_areas
  SHIMS_APART caller_executor hsp_gradient hsp_contacts hsp_regions hsp_topology hsp_topology_records)
