#include "commands/measurement.h"

#include <stdlib.h>
#include <string.h>

#include "commands/excluded_surface.h"
#include "read/weights.h"

static double *allocate(const struct molecule *molecule, size_t numbers_per_atom, struct failure *failure) {
  /* An atom has at least 50 bytes in memory already, so that the size cannot overflow. */
  double *numbers = malloc((numbers_per_atom * molecule->atoms + 1) * sizeof *numbers);
  if (numbers == NULL) failure_of_memory(failure);
  return numbers;
}

static bool allocate_gradient(const struct molecule *molecule, struct gradient *gradient, struct failure *failure) {
  gradient->centre = allocate(molecule, 3, failure);
  gradient->radius = allocate(molecule, 1, failure);
  return gradient->centre != NULL && gradient->radius != NULL;
}

/* Derivatives of area and volume by all centres and radii, and how many balls have one-sided ones. */
static bool measure_gradients(const struct molecule *molecule, const struct geometry *geometry, bool excluded_surface,
                              struct measurement *measurement, struct failure *failure) {
  struct gradient *of_area = &measurement->of_area, *of_volume = &measurement->of_volume;
  if (!allocate_gradient(molecule, of_area, failure) || !allocate_gradient(molecule, of_volume, failure)) return false;
  uint32_t *flags = calloc((size_t)molecule->atoms + 1, sizeof *flags);
  if (flags == NULL) return failure_of_memory(failure);
  int32_t status;
  if (measurement->box.periodic != NULL) {
    status = hsp_periodic_gradient(measurement->box.periodic, NULL, 1.0, 0.0, HSP_TANGENT_OVERLAP, NULL,
                                   of_area->centre, of_area->radius, flags, NULL, NULL, molecule->atoms, NULL, NULL);
    if (status == HSP_OK) {
      status =
          hsp_periodic_gradient(measurement->box.periodic, NULL, 0.0, 1.0, HSP_TANGENT_OVERLAP, NULL, of_volume->centre,
                                of_volume->radius, NULL, NULL, NULL, molecule->atoms, NULL, NULL);
    }
  } else if (excluded_surface) {
    status = excluded_surface_gradients(geometry, molecule->atoms, of_area, of_volume, flags);
  } else {
    status =
        hsp_boundary_derivatives(geometry->work.boundary, NULL, HSP_TANGENT_OVERLAP, of_area->centre, of_area->radius,
                                 of_volume->centre, of_volume->radius, flags, molecule->atoms, NULL, NULL);
  }
  for (uint32_t i = 0; status == HSP_OK && i < molecule->atoms; ++i) {
    if (flags[i] != 0) ++measurement->one_sided;
  }
  free(flags);
  return status == HSP_OK || failure_in_library(failure, status);
}

static bool measure_weighted_gradient(const struct molecule *molecule, const struct geometry *geometry,
                                      struct measurement *measurement, struct failure *failure) {
  struct gradient *gradient = &measurement->of_weighted_area;
  if (!allocate_gradient(molecule, gradient, failure)) return false;
  const hsp_periodic *const periodic = measurement->box.periodic;
  const int32_t status =
      periodic != NULL
          ? hsp_periodic_gradient(periodic, measurement->weights, 1.0, 0.0, HSP_TANGENT_OVERLAP, NULL, gradient->centre,
                                  gradient->radius, NULL, NULL, NULL, molecule->atoms, NULL, NULL)
          : hsp_boundary_gradient(geometry->work.boundary, measurement->weights, 1.0, 0.0, HSP_TANGENT_OVERLAP, NULL,
                                  gradient->centre, gradient->radius, NULL, molecule->atoms, NULL, NULL);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Of the solvent-excluded surface the balls' shares are there already. */
static bool measure_weighted_area(const struct request *request, uint32_t atoms, const struct geometry *geometry,
                                  struct measurement *measurement, struct failure *failure) {
  if (request->excluded_surface) {
    for (uint32_t i = 0; i < atoms; ++i) measurement->weighted_area += measurement->weights[i] * measurement->area[i];
    return true;
  }
  hsp_energy energy;
  const hsp_periodic *const periodic = measurement->box.periodic;
  const int32_t status = periodic != NULL
                             ? hsp_periodic_gradient(periodic, measurement->weights, 1.0, 0.0, HSP_TANGENT_OVERLAP,
                                                     &energy, NULL, NULL, NULL, NULL, NULL, 0, NULL, NULL)
                             : hsp_boundary_gradient(geometry->work.boundary, measurement->weights, 1.0, 0.0,
                                                     HSP_TANGENT_OVERLAP, &energy, NULL, NULL, NULL, 0, NULL, NULL);
  if (status != HSP_OK) return failure_in_library(failure, status);
  measurement->weighted_area = energy.area;
  return true;
}

static bool measure_areas(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                          struct measurement *measurement, struct failure *failure) {
  if (request_wants_areas(request)) {
    measurement->area = allocate(molecule, 1, failure);
    if (measurement->area == NULL) return false;
  }
  if (request->excluded_surface) {
    struct excluded_surface *surface = &measurement->surface;
    if (!excluded_surface_measure(request->outer, molecule->atoms, geometry, surface, measurement->area, failure)) {
      return false;
    }
    measurement->totals.area = surface->area;
    measurement->totals.volume = surface->volume;
    return true;
  }
  progress_show(&geometry->progress, "measuring");
  if (measurement->box.periodic != NULL) {
    const struct periodic_result *box = &measurement->box;
    measurement->totals.area = box->totals.area;
    measurement->totals.volume = box->totals.volume;
    const int32_t status = hsp_periodic_measure(box->periodic, NULL, measurement->area, NULL, molecule->atoms, NULL);
    return status == HSP_OK || failure_in_library(failure, status);
  }
  return geometry_measure(geometry, molecule->atoms, &measurement->totals, measurement->area, failure);
}

/* Which of the three sums an atom counts for. */
static double *polarity_sum(struct measurement *measurement, struct element_symbol element) {
  static const char *const polar[] = {"N", "O"};
  static const char *const apolar[] = {"C", "S", "Se"};
  for (size_t i = 0; i < sizeof polar / sizeof polar[0]; ++i) {
    if (strcmp(element.text, polar[i]) == 0) return &measurement->polar_area;
  }
  for (size_t i = 0; i < sizeof apolar / sizeof apolar[0]; ++i) {
    if (strcmp(element.text, apolar[i]) == 0) return &measurement->apolar_area;
  }
  return &measurement->other_area;
}

bool measurement_make(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct measurement *measurement, struct failure *failure) {
  memset(measurement, 0, sizeof *measurement);
  const bool weighted = request->weights != NULL;
  if (weighted && !weights_read(request->weights, "weight", molecule->atoms, &measurement->weights, failure))
    return false;
  const bool boxed = request->box.source != BOX_NONE;
  if (boxed && !periodic_result_make(request, molecule, geometry, &measurement->box, failure)) return false;
  if (!boxed && !geometry_compute_boundary(geometry, failure)) return false;
  if (!measure_areas(request, molecule, geometry, measurement, failure)) return false;
  for (uint32_t i = 0; request->polar && i < molecule->atoms; ++i) {
    *polarity_sum(measurement, molecule->label[i].element) += measurement->area[i];
  }
  if (weighted && !measure_weighted_area(request, molecule->atoms, geometry, measurement, failure)) return false;
  if (request->curvature) {
    const hsp_periodic *const periodic = measurement->box.periodic;
    const int32_t status =
        periodic != NULL
            ? hsp_periodic_curvature(periodic, &measurement->curvatures, NULL, NULL, 0, NULL)
            : hsp_boundary_curvature(geometry->work.boundary, &measurement->curvatures, NULL, NULL, 0, NULL);
    if (status != HSP_OK) return failure_in_library(failure, status);
  }
  if (!request->gradient) return true;
  progress_show(&geometry->progress, "computing derivatives");
  return measure_gradients(molecule, geometry, request->excluded_surface, measurement, failure) &&
         (!weighted || measure_weighted_gradient(molecule, geometry, measurement, failure));
}

void measurement_free(struct measurement *measurement) {
  periodic_result_free(&measurement->box);
  free(measurement->area);
  free(measurement->weights);
  struct gradient *const gradients[] = {&measurement->of_area, &measurement->of_volume, &measurement->of_weighted_area};
  for (size_t i = 0; i < sizeof gradients / sizeof gradients[0]; ++i) {
    free(gradients[i]->centre);
    free(gradients[i]->radius);
  }
  memset(measurement, 0, sizeof *measurement);
}
