# Integrated curvatures of the union, and energies with them.
hsp_part(curvature
  STANDS_ON union
  HEADERS curvature
  SOURCES
    curvature/curvature.cpp
    curvature/edge_sums.kernel.cpp
  SHIMS hsp_curvature
  LEVELS shims -O2)
