/* The findings of `hardsphere measure` about a molecule: the numbers, before anybody prints them. */
#ifndef HARDSPHERE_TOOL_MEASUREMENT_H
#define HARDSPHERE_TOOL_MEASUREMENT_H

#include <stdbool.h>
#include <stdint.h>

#include "commands/excluded_surface.h"
#include "commands/periodic_result.h"
#include "commands/request.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Arrays that were not asked for are NULL. */
struct measurement {
  hsp_totals totals;
  struct excluded_surface surface; /* if the solvent-excluded surface was asked for; then totals are of that, too */
  double *area;                    /* [atoms], free area of each ball, or its share of the surface */
  double *weights;                 /* [atoms], as the user gave them */
  double weighted_area;            /* sum of weight x free area */
  struct gradient of_area;
  struct gradient of_volume;
  struct gradient of_weighted_area;
  hsp_curvatures curvatures;                  /* if they were asked for */
  double polar_area, apolar_area, other_area; /* if they were asked for */
  struct periodic_result box;                 /* if there is one; then all of this is of what is in it */
  uint32_t one_sided;                         /* balls whose derivatives are one-sided because they touch another */
};

/* Compute the boundary and measure it as far as the request asks for it. Free the measurement on true and on false. */
bool measurement_make(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct measurement *measurement, struct failure *failure);

void measurement_free(struct measurement *measurement);

#endif
