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

static int32_t periodic_gradients(const hsp_periodic *periodic, uint32_t atoms, const struct gradient *of_area,
                                  const struct gradient *of_volume, uint32_t *flags) {
  const hsp_gradient_request area = {.struct_size = sizeof area, .tension = 1.0};
  const hsp_gradient_request volume = {.struct_size = sizeof volume, .pressure = 1.0};
  hsp_periodic_gradient_outputs outputs = {.struct_size = sizeof outputs,
                                           .capacity = atoms,
                                           .d_centre = of_area->centre,
                                           .d_radius = of_area->radius,
                                           .flags = flags};
  const int32_t status = hsp_periodic_get_gradient(periodic, &area, &outputs);
  if (status != HSP_OK) return status;
  outputs.d_centre = of_volume->centre;
  outputs.d_radius = of_volume->radius;
  outputs.flags = NULL;
  return hsp_periodic_get_gradient(periodic, &volume, &outputs);
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
    status = periodic_gradients(measurement->box.periodic, molecule->atoms, of_area, of_volume, flags);
  } else if (excluded_surface) {
    status = excluded_surface_gradients(geometry, molecule->atoms, of_area, of_volume, flags);
  } else {
    hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs,
                                       .capacity = molecule->atoms,
                                       .area_centre = of_area->centre,
                                       .area_radius = of_area->radius,
                                       .volume_centre = of_volume->centre,
                                       .volume_radius = of_volume->radius,
                                       .flags = flags};
    status = hsp_boundary_get_derivatives(geometry->work.boundary, NULL, &outputs);
  }
  for (uint32_t i = 0; status == HSP_OK && i < molecule->atoms; ++i) {
    if (flags[i] != 0) ++measurement->one_sided;
  }
  free(flags);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The weighted area and its gradient, of the union or of that in the box; either may be NULL. */
static int32_t get_weighted_area(const struct geometry *geometry, const struct measurement *measurement, uint32_t atoms,
                                 hsp_energy *energy, const struct gradient *gradient) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1.0, .sigma = measurement->weights};
  double *const centre = gradient != NULL ? gradient->centre : NULL;
  double *const radius = gradient != NULL ? gradient->radius : NULL;
  if (measurement->box.periodic != NULL) {
    hsp_periodic_gradient_outputs outputs = {
        .struct_size = sizeof outputs, .capacity = atoms, .energy = energy, .d_centre = centre, .d_radius = radius};
    return hsp_periodic_get_gradient(measurement->box.periodic, &request, &outputs);
  }
  hsp_gradient_outputs outputs = {
      .struct_size = sizeof outputs, .capacity = atoms, .energy = energy, .d_centre = centre, .d_radius = radius};
  return hsp_boundary_get_gradient(geometry->work.boundary, &request, &outputs);
}

static bool measure_weighted_gradient(const struct molecule *molecule, const struct geometry *geometry,
                                      struct measurement *measurement, struct failure *failure) {
  struct gradient *gradient = &measurement->of_weighted_area;
  if (!allocate_gradient(molecule, gradient, failure)) return false;
  const int32_t status = get_weighted_area(geometry, measurement, molecule->atoms, NULL, gradient);
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
  const int32_t status = get_weighted_area(geometry, measurement, atoms, &energy, NULL);
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
  return geometry_measure(geometry, molecule->atoms, measurement->part, &measurement->totals, measurement->area,
                          failure);
}

bool measurement_find_part(const struct request *request, const struct molecule *molecule,
                           struct measurement *measurement, struct failure *failure) {
  if (!request_wants_part(request)) return true;
  measurement->part = malloc((size_t)molecule->atoms + 1);
  if (measurement->part == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    measurement->part[i] = selection_takes(&request->part, molecule, i) ? 1 : 0;
    measurement->part_atoms += measurement->part[i];
  }
  return measurement->part_atoms > 0 || failure_in_input(failure, 0, "--of names no atom that is read");
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
  if (!measurement_find_part(request, molecule, measurement, failure)) return false;
  if (!boxed && !geometry_compute_boundary_of(geometry, measurement->part, failure)) return false;
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

size_t measurement_quantities(const struct request *request, const struct measurement *measurement,
                              struct quantity quantities[MOST_QUANTITIES]) {
  const struct excluded_surface *const surface = &measurement->surface;
  const bool smooth = request->excluded_surface;
  const struct {
    bool asked;
    struct quantity quantity;
  } rows[MOST_QUANTITIES] = {
      {true, {"area", "area", "@^2", measurement->totals.area}},
      {!request_wants_part(request), {"volume", "volume", "@^3", measurement->totals.volume}},
      {request->curvature,
       {"mean_curvature", "mean curvature", "@, integrated over the boundary", measurement->curvatures.mean}},
      {request->curvature,
       {"gauss_curvature", "gauss curvature", ", 2 pi times its Euler characteristic", measurement->curvatures.gauss}},
      {smooth, {"convex_area", "convex area", "@^2, where the probe touches one atom", surface->convex_area}},
      {smooth, {"saddle_area", "saddle area", "@^2, where it touches two", surface->saddle_area}},
      {smooth, {"concave_area", "concave area", "@^2, where it touches three", surface->concave_area}},
      {request->weights != NULL,
       {"weighted_area", "weighted area",
        smooth ? ", the sum of weight x share of the area" : ", the sum of weight x free area",
        measurement->weighted_area}},
      {request->polar, {"polar_area", "polar area", "@^2, of nitrogen and oxygen", measurement->polar_area}},
      {request->polar, {"apolar_area", "apolar area", "@^2, of carbon, sulfur and selenium", measurement->apolar_area}},
      {request->polar, {"other_area", "other area", "@^2, of all others", measurement->other_area}},
  };
  size_t count = 0;
  for (size_t k = 0; k < MOST_QUANTITIES; ++k) {
    if (rows[k].asked) quantities[count++] = rows[k].quantity;
  }
  return count;
}

void measurement_free(struct measurement *measurement) {
  free(measurement->part);
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
