/* A molecule in a periodic box, and what every command says of it. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "commands/request.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "write/record.h"

struct periodic_result {
  const hsp_periodic *periodic; /* the geometry's */
  double box[9];
  const struct symmetry *symmetry; /* the molecule's; NULL if the box is not that of its file */
  hsp_periodic_counts counts;
  hsp_periodic_totals totals;
  hsp_winding *windings; /* [counts.components] */
  double strain_area[9], strain_volume[9];
};

/* The box that the request or the file names, alone. */
bool periodic_result_find_box(const struct request *request, const struct molecule *molecule,
                              struct periodic_result *result, struct failure *failure);

/* Compute everything in the box that the request or the file names. weights [atoms]: of areas, for totals.area and
 * strain_area; NULL: all are 1. Free the result on true and on false. */
bool periodic_result_make(const struct request *request, const struct molecule *molecule, const double *weights,
                          struct geometry *geometry, struct periodic_result *result, struct failure *failure);

void periodic_result_free(struct periodic_result *result);

/* The box, and what was made of it. */
void periodic_result_record_box(struct record *record, const struct periodic_result *result);

/* Keys of JSON: where something leads that goes on for ever, as hsp_winding says. */
void directions_json(struct text_buffer *out, uint32_t directions, uint32_t copies, const int32_t row[9]);

/* The box, what of it is free, components by their directions. In a row of a frame its volumes alone. */
void periodic_result_record(struct record *record, const struct periodic_result *result);
