/* In place of excluded_surface.c if the library has no solvent-excluded surface: options that ask for one are refused
 * before these functions are called. */
#include "commands/excluded_surface.h"

bool excluded_surface_measure(bool outer, uint32_t atoms, struct geometry *geometry, struct excluded_surface *surface,
                              double *share, struct failure *failure) {
  (void)outer, (void)atoms, (void)geometry, (void)surface, (void)share;
  return failure_in_library(failure, HSP_E_ARGUMENT);
}

int32_t excluded_surface_gradients(const struct geometry *geometry, uint32_t atoms, const struct gradient *of_area,
                                   const struct gradient *of_volume, uint32_t *flags) {
  (void)geometry, (void)atoms, (void)of_area, (void)of_volume, (void)flags;
  return HSP_E_ARGUMENT;
}
