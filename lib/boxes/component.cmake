# Boxes whose copies fill space.
hsp_part(boxes
  STANDS_ON curvature
  HEADERS periodic periodic_boundary
  SOURCES
    periodic/box_frame.cpp
    periodic/periodic_box.cpp
    periodic/periodic_check.cpp
    periodic/periodic_hessian.cpp
    periodic/periodic_images.cpp
    periodic/periodic_measures.cpp
    periodic/periodic_morphometry.cpp
    periodic/periodic_queries.cpp
    periodic/periodic_records.cpp
    periodic/periodic_union.cpp
    periodic/surface_volume.cpp
    periodic/windings.cpp
  SHIMS hsp_periodic hsp_periodic_boundary hsp_periodic_curvature hsp_periodic_hessian
        hsp_periodic_queries
  LEVELS shims -O1 periodic -O2)
