/* A molecule in a periodic box, and the results that all commands report of it. */
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

/* Find only the box that the request or the file names. */
bool periodic_result_find_box(const struct request *request, const struct molecule *molecule,
                              struct periodic_result *result, struct failure *failure);

/* Compute everything in the box that the request or the file names. weights [atoms]: weights of areas in totals.area
 * and strain_area; NULL: all are 1. Free the result on true and on false. */
bool periodic_result_make(const struct request *request, const struct molecule *molecule, const double *weights,
                          struct geometry *geometry, struct periodic_result *result, struct failure *failure);

void periodic_result_free(struct periodic_result *result);

/* Write the box, and how it was filled with copies. */
void periodic_result_record_box(struct record *record, const struct periodic_result *result);

/* Write keys of JSON for the directions in which something extends without end, as hsp_winding has them. */
void directions_json(struct text_buffer *out, uint32_t directions, uint32_t copies, const int32_t row[9]);

/* Write the box, its free part, and components by their directions; in a row of a frame only its volumes. */
void periodic_result_record(struct record *record, const struct periodic_result *result);
