#include "draw/ball_values.h"

#include <stddef.h>
#include <stdlib.h>

#include "read/geometry.h"
#include "read/weights.h"

static const double water_radius = 1.4;

static bool take_numbers(const struct drawing *drawing, const struct molecule *molecule, double *value,
                         struct failure *failure) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_extra *extra = &molecule->extra[i];
    if (!extra->has_value) {
      return failure_in_input(failure, molecule->line[i], "no %s for --colour %s",
                              drawing->colour == COLOUR_CHARGE ? "charge" : "temperature factor",
                              drawing->colour == COLOUR_CHARGE  ? "charge"
                              : drawing->colour == COLOUR_PLDDT ? "plddt"
                                                                : "bfactor");
    }
    value[i] = extra->value;
  }
  return true;
}

static bool find_free_areas(const struct molecule *molecule, double *value, struct failure *failure) {
  struct geometry geometry = {.work = {0}};
  bool done = geometry_set_model(&geometry, molecule, water_radius, 0.0, failure) &&
              geometry_compute_boundary(&geometry, failure);
  if (done) {
    const int32_t status = hsp_boundary_measure(geometry.work.boundary, NULL, NULL, value, NULL, molecule->atoms, NULL);
    done = status == HSP_OK || failure_in_library(failure, status);
  }
  geometry_free(&geometry);
  return done;
}

bool ball_values_make(const struct drawing *drawing, const struct molecule *molecule, double **value,
                      struct failure *failure) {
  if (drawing->colour == COLOUR_FILE) {
    return weights_read(drawing->colour_file, "number", molecule->atoms, value, failure);
  }
  *value = malloc(((size_t)molecule->atoms + 1) * sizeof **value);
  if (*value == NULL) return failure_of_memory(failure);
  if (drawing->colour == COLOUR_AREA ? find_free_areas(molecule, *value, failure)
                                     : take_numbers(drawing, molecule, *value, failure)) {
    return true;
  }
  free(*value);
  return false;
}
