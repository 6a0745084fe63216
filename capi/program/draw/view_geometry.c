#include "draw/view_geometry.h"

#include "draw/view_axes.h"

bool geometry_compute_view(struct geometry *geometry, const hsp_view_options *options, struct failure *failure) {
  progress_show(&geometry->progress, "cutting and sorting");
  const int32_t status = hsp_workspace_view(&geometry->work, geometry->work.boundary != NULL, options);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_map(struct geometry *geometry, const struct viewing *viewing, const struct molecule *molecule,
                          struct failure *failure) {
  hsp_view_options options;
  progress_show(&geometry->progress, "finding what is seen");
  int32_t status = viewing_options(viewing, molecule, &options);
  if (status == HSP_OK) status = hsp_workspace_map(&geometry->work, &options);
  if (status == HSP_E_DEGENERATE) {
    return failure_in_input(failure, 0, "too many balls tie as seen from there: look from elsewhere");
  }
  return status == HSP_OK || failure_in_library(failure, status);
}
