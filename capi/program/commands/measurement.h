/* The findings of `hardsphere measure` about a molecule: the numbers, before they are printed. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
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
  double *weights;                 /* [atoms], as the user gave them; 0 of those that only block */
  double weighted_area;            /* sum of weight x free area */
  struct gradient of_area;
  struct gradient of_volume;
  struct gradient of_weighted_area;
  double windowed_area; /* if there is a window: its mean, with derivatives if these are wanted */
  struct gradient of_windowed_area;
  hsp_curvatures curvatures;                  /* if they were asked for */
  double polar_area, apolar_area, other_area; /* if they were asked for */
  struct periodic_result box;                 /* if there is one; then all of this is of what is in it */
  uint8_t *part;                              /* [atoms], 0 of those that only block; NULL: all are measured */
  double *part_weights;                       /* the same as weights of areas */
  uint32_t part_atoms;                        /* how many are measured, if there is such a part */
  uint32_t one_sided;                         /* balls whose derivatives are one-sided because they touch another */
};

/* Compute the boundary and measure it as far as the request asks for it. Free the measurement on true and on false. */
bool measurement_make(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct measurement *measurement, struct failure *failure);

/* Find the part and how many atoms it has; NULL if the request has none. False: it is of no atom, or memory is short.
 */
bool measurement_find_part(const struct request *request, const struct molecule *molecule,
                           struct measurement *measurement, struct failure *failure);

/* A number about the molecule as a whole. */
struct quantity {
  const char *key;    /* of JSON and CSV */
  const char *title;  /* for persons */
  const char *remark; /* for persons, with its unit */
  double value;
};

enum { MOST_QUANTITIES = 12 };

struct quantities {
  struct quantity of[MOST_QUANTITIES];
  size_t count;
  size_t totals; /* of the union itself, which come first: area and volume */
};

/* All that the request asks for, always as many and in the same order. */
void measurement_quantities(const struct request *request, const struct measurement *measurement,
                            struct quantities *quantities);

void measurement_free(struct measurement *measurement);
