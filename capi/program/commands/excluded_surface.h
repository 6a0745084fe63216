/* The solvent-excluded surface in `measure`: areas, volume, the share of each ball, derivatives. Without the library's
 * component smooth, no_excluded_surface.c takes its place. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/geometry.h"

/* The derivatives of one quantity with respect to every centre and every radius. */
struct gradient {
  double *centre; /* [atoms][3] */
  double *radius; /* [atoms] */
};

struct excluded_surface {
  double area, volume;
  double convex_area, saddle_area, concave_area;
};

/* Measure the surface over the boundary, which is computed; with `outer` only its outer region. share [atoms] gets each
 * ball's part of the area; NULL: not wanted. */
bool excluded_surface_measure(bool outer, uint32_t atoms, struct geometry *geometry, struct excluded_surface *surface,
                              double *share, struct failure *failure);

/* The derivatives of its area and volume; flags [atoms] tell which are one-sided. Returns the status of the library. */
int32_t excluded_surface_gradients(const struct geometry *geometry, uint32_t atoms, const struct gradient *of_area,
                                   const struct gradient *of_volume, uint32_t *flags);
