# Integrated curvatures of the union, and energies with them.
hsp_part(curvature
  STANDS_ON union
  HEADERS curvature hessian
  SOURCES
    curvature/curvature.cpp
    curvature/edge_sums.kernel.cpp
    curvature/hessian_rows.cpp
    curvature/hessians.cpp
  SHIMS hsp_curvature hsp_hessian
  LEVELS shims -O2)
