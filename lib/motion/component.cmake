# One molecule against another that is moved as a whole, and balls of which a few move at a time.
hsp_part(motion
  STANDS_ON union
  HEADERS pose moving
  SOURCES
    poses/near_pairs.kernel.cpp
    poses/pose.cpp
    poses/pose_queries.cpp
    poses/rational_pose.cpp
    poses/sphere_tree.cpp
    moving/boundary_part.cpp
    moving/ball_cells.cpp
    moving/ball_group.cpp
    moving/component_update.cpp
    moving/moving_balls.cpp
  SHIMS_APART hsp_body hsp_moving
  LEVELS shims -O2 moving -O2)
