#include "commands/excluded_surface.h"

#include <stdlib.h>

#include "commands/surface_geometry.h"

bool excluded_surface_measure(bool outer, uint32_t atoms, struct geometry *geometry, struct excluded_surface *surface,
                              double *share, struct failure *failure) {
  hsp_surface_totals totals;
  hsp_surface_totals *shares = NULL;
  if (!(outer ? geometry_compute_outer_surface(geometry, failure) : geometry_compute_surface(geometry, failure))) {
    return false;
  }
  if (share != NULL) {
    shares = calloc((size_t)atoms + 1, sizeof *shares);
    if (shares == NULL) return failure_of_memory(failure);
  }
  progress_show(&geometry->progress, "measuring");
  const int32_t status = hsp_surface_measure(geometry->work.surface, &totals, shares, shares == NULL ? 0 : atoms, NULL);
  for (uint32_t i = 0; shares != NULL && i < atoms; ++i) share[i] = shares[i].area;
  free(shares);
  if (status != HSP_OK) return failure_in_library(failure, status);
  *surface = (struct excluded_surface){totals.area, totals.volume, totals.convex_area, totals.saddle_area,
                                       totals.concave_area};
  return true;
}

int32_t excluded_surface_gradients(const struct geometry *geometry, uint32_t atoms, const struct gradient *of_area,
                                   const struct gradient *of_volume, uint32_t *flags) {
  const hsp_gradient_request area = {.struct_size = sizeof area, .tension = 1.0};
  const hsp_gradient_request volume = {.struct_size = sizeof volume, .pressure = 1.0};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs,
                                  .capacity = atoms,
                                  .d_centre = of_area->centre,
                                  .d_radius = of_area->radius,
                                  .flags = flags};
  const int32_t status = hsp_surface_get_gradient(geometry->work.surface, &area, &outputs);
  if (status != HSP_OK) return status;
  outputs.d_centre = of_volume->centre;
  outputs.d_radius = of_volume->radius;
  outputs.flags = NULL;
  return hsp_surface_get_gradient(geometry->work.surface, &volume, &outputs);
}
