/* The results of `hardsphere measure` for a molecule, before they are printed. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "commands/excluded_surface.h"
#include "commands/periodic_result.h"
#include "commands/request.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Arrays that are not wanted are NULL. */
struct measurement {
  hsp_totals totals;
  struct excluded_surface surface; /* if the solvent-excluded surface is wanted; then `totals` are its totals, too */
  double *area;                    /* [atoms], free area of each ball, or its share of the surface */
  double *weights;                 /* [atoms], as the user gave them; 0 for balls that only block */
  double weighted_area;            /* sum of weight x free area */
  struct gradient of_area;
  struct gradient of_volume;
  struct gradient of_weighted_area;
  double windowed_area; /* if there is a window: the mean area over it, with derivatives if these are wanted */
  struct gradient of_windowed_area;
  hsp_curvatures curvatures;                  /* if they are wanted */
  double polar_area, apolar_area, other_area; /* if they are wanted */
  struct periodic_result box;                 /* if there is a box; then all results are those in the box */
  uint8_t *part;                              /* [atoms], 0: the ball only blocks; NULL: all are measured */
  double *part_weights;                       /* [atoms], the same as weights of areas */
  uint32_t part_atoms;                        /* how many balls are measured, if only a part is */
  uint32_t one_sided;                         /* balls whose derivatives are one-sided because they touch another */
};

/* Compute the boundary and measure it as far as the request asks for it. Free the measurement on true and on false. */
bool measurement_make(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct measurement *measurement, struct failure *failure);

/* Find the part that the request names, and how many atoms it has; NULL if it names none. False: the part has no atom,
 * or memory is short. */
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
  size_t totals; /* how many are totals of the union itself: area and volume, which come first */
};

/* List all quantities that the request asks for: for the same request always the same number, in the same order. */
void measurement_quantities(const struct request *request, const struct measurement *measurement,
                            struct quantities *quantities);

void measurement_free(struct measurement *measurement);
