#include "commands/measurement.h"

#include <stdlib.h>
#include <string.h>

#include "commands/excluded_surface.h"
#include "commands/radius_window.h"
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

/* Compute tension A + pressure V of the union, or of that in the box, and its derivatives. The request has weights of
 * areas, or NULL; energy, gradient and flags may be NULL. */
static int32_t get_gradient(const struct geometry *geometry, const struct measurement *measurement, uint32_t atoms,
                            const hsp_gradient_request *request, hsp_energy *energy, const struct gradient *gradient,
                            uint32_t *flags) {
  double *const centre = gradient != NULL ? gradient->centre : NULL;
  double *const radius = gradient != NULL ? gradient->radius : NULL;
  if (measurement->box.periodic != NULL) {
    hsp_periodic_gradient_outputs outputs = {.struct_size = sizeof outputs,
                                             .capacity = atoms,
                                             .energy = energy,
                                             .d_centre = centre,
                                             .d_radius = radius,
                                             .flags = flags};
    return hsp_periodic_get_gradient(measurement->box.periodic, request, &outputs);
  }
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs,
                                  .capacity = atoms,
                                  .energy = energy,
                                  .d_centre = centre,
                                  .d_radius = radius,
                                  .flags = flags};
  return hsp_boundary_get_gradient(geometry->work.boundary, request, &outputs);
}

/* Derivatives of area and volume by all centres and radii, of a part's area alone, and how many balls have one-sided
 * ones. */
static bool measure_gradients(const struct molecule *molecule, const struct geometry *geometry, bool excluded_surface,
                              struct measurement *measurement, struct failure *failure) {
  struct gradient *of_area = &measurement->of_area, *of_volume = &measurement->of_volume;
  const bool with_volume = measurement->part == NULL;
  if (!allocate_gradient(molecule, of_area, failure)) return false;
  if (with_volume && !allocate_gradient(molecule, of_volume, failure)) return false;
  uint32_t *flags = calloc((size_t)molecule->atoms + 1, sizeof *flags);
  if (flags == NULL) return failure_of_memory(failure);
  int32_t status;
  if (excluded_surface) {
    status = excluded_surface_gradients(geometry, molecule->atoms, of_area, of_volume, flags);
  } else if (measurement->box.periodic != NULL) {
    const hsp_gradient_request area = {.struct_size = sizeof area, .tension = 1.0, .sigma = measurement->part_weights};
    const hsp_gradient_request volume = {.struct_size = sizeof volume, .pressure = 1.0};
    status = get_gradient(geometry, measurement, molecule->atoms, &area, NULL, of_area, flags);
    if (status == HSP_OK && with_volume) {
      status = get_gradient(geometry, measurement, molecule->atoms, &volume, NULL, of_volume, NULL);
    }
  } else {
    const hsp_derivatives_request asked = {.struct_size = sizeof asked, .sigma = measurement->part_weights};
    hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs,
                                       .capacity = molecule->atoms,
                                       .area_centre = of_area->centre,
                                       .area_radius = of_area->radius,
                                       .volume_centre = of_volume->centre,
                                       .volume_radius = of_volume->radius,
                                       .flags = flags};
    status = hsp_boundary_get_derivatives(geometry->work.boundary, &asked, &outputs);
  }
  for (uint32_t i = 0; status == HSP_OK && i < molecule->atoms; ++i) {
    if (flags[i] != 0) ++measurement->one_sided;
  }
  free(flags);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The weighted area and its gradient; either may be NULL. */
static int32_t get_weighted_area(const struct geometry *geometry, const struct measurement *measurement, uint32_t atoms,
                                 hsp_energy *energy, const struct gradient *gradient) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1.0, .sigma = measurement->weights};
  return get_gradient(geometry, measurement, atoms, &request, energy, gradient, NULL);
}

static bool measure_weighted_gradient(const struct molecule *molecule, const struct geometry *geometry,
                                      struct measurement *measurement, struct failure *failure) {
  struct gradient *gradient = &measurement->of_weighted_area;
  if (!allocate_gradient(molecule, gradient, failure)) return false;
  const int32_t status = get_weighted_area(geometry, measurement, molecule->atoms, NULL, gradient);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Sum the weighted areas. For the solvent-excluded surface the balls' shares are known already. */
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
    if (!excluded_surface_measure(request->measure.outer, molecule->atoms, geometry, surface, measurement->area,
                                  failure)) {
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
    for (uint32_t i = 0; measurement->area != NULL && measurement->part != NULL && i < molecule->atoms; ++i) {
      measurement->area[i] *= measurement->part_weights[i];
    }
    return status == HSP_OK || failure_in_library(failure, status);
  }
  return geometry_measure(geometry, molecule->atoms, measurement->part, &measurement->totals, measurement->area,
                          failure);
}

bool measurement_find_part(const struct request *request, const struct molecule *molecule,
                           struct measurement *measurement, struct failure *failure) {
  if (!request_wants_part(request)) return true;
  measurement->part = malloc((size_t)molecule->atoms + 1);
  measurement->part_weights = allocate(molecule, 1, failure);
  if (measurement->part == NULL || measurement->part_weights == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    measurement->part[i] = selection_takes(&request->measure.part, molecule, i) ? 1 : 0;
    measurement->part_weights[i] = measurement->part[i];
    measurement->part_atoms += measurement->part[i];
    if (measurement->weights != NULL) measurement->weights[i] *= measurement->part[i];
  }
  return measurement->part_atoms > 0 || failure_in_input(failure, 0, "--of names no atom that is read");
}

/* If only a part is measured, its curvatures are the sums over its balls. */
static bool measure_curvatures(const struct molecule *molecule, const struct geometry *geometry,
                               struct measurement *measurement, struct failure *failure) {
  const double third_of_pi = 1.0471975511965977;
  const hsp_periodic *const periodic = measurement->box.periodic;
  const uint32_t atoms = molecule->atoms;
  hsp_curvatures *const totals = &measurement->curvatures;
  const bool of_part = measurement->part != NULL;
  const uint32_t listed = of_part ? atoms : 0;
  double *const mean = of_part ? allocate(molecule, 1, failure) : NULL;
  int32_t *const thirds = of_part ? malloc(((size_t)atoms + 1) * sizeof *thirds) : NULL;
  int32_t status = HSP_E_MEMORY;
  if (!of_part || (mean != NULL && thirds != NULL)) {
    status = periodic != NULL ? hsp_periodic_curvature(periodic, totals, mean, thirds, listed, NULL)
                              : hsp_boundary_curvature(geometry->work.boundary, totals, mean, thirds, listed, NULL);
  }
  if (status == HSP_OK && of_part) {
    int64_t sum = 0;
    totals->mean = 0.0;
    for (uint32_t i = 0; i < atoms; ++i) {
      totals->mean += measurement->part_weights[i] * mean[i];
      sum += measurement->part[i] != 0 ? thirds[i] : 0;
    }
    totals->gauss = third_of_pi * (double)sum;
  }
  free(mean);
  free(thirds);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* A windowed area, and the sum of its derivatives; `side` has those of the set of balls that is being added. */
struct windowed_area {
  double value;
  struct gradient sum, side;
  uint32_t atoms;
};

static bool add_side(void *of, const struct geometry *side, double factor, struct failure *failure) {
  struct windowed_area *const windowed = of;
  const hsp_gradient_request request = {.struct_size = sizeof request, .pressure = factor};
  hsp_energy energy;
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs,
                                  .capacity = windowed->atoms,
                                  .energy = &energy,
                                  .d_centre = windowed->side.centre,
                                  .d_radius = windowed->side.radius};
  const int32_t status = hsp_boundary_get_gradient(side->work.boundary, &request, &outputs);
  if (status != HSP_OK) return failure_in_library(failure, status);
  windowed->value += energy.value;
  for (size_t k = 0; windowed->sum.centre != NULL && k < 3 * (size_t)windowed->atoms; ++k) {
    windowed->sum.centre[k] += windowed->side.centre[k];
  }
  for (size_t k = 0; windowed->sum.radius != NULL && k < windowed->atoms; ++k) {
    windowed->sum.radius[k] += windowed->side.radius[k];
  }
  return true;
}

/* The mean over the window, of a part over radii of its balls alone. */
static bool measure_window(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                           struct measurement *measurement, struct failure *failure) {
  const double *const weights = measurement->weights != NULL ? measurement->weights : measurement->part_weights;
  const struct radius_window window = {request->probe, request->window, weights};
  struct gradient *const gradient = &measurement->of_windowed_area;
  struct windowed_area windowed = {.atoms = molecule->atoms};
  bool done = true;
  progress_show(&geometry->progress, "measuring the window");
  if (request->measure.gradient) {
    done = allocate_gradient(molecule, gradient, failure) && allocate_gradient(molecule, &windowed.side, failure);
    for (size_t k = 0; done && k < molecule->atoms; ++k) {
      gradient->centre[3 * k] = gradient->centre[3 * k + 1] = gradient->centre[3 * k + 2] = gradient->radius[k] = 0.0;
    }
    windowed.sum = *gradient;
  }
  done = done && radius_window_for_each_side(&window, molecule, geometry, add_side, &windowed, failure);
  measurement->windowed_area = windowed.value;
  free(windowed.side.centre);
  free(windowed.side.radius);
  return done;
}

bool measurement_make(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct measurement *measurement, struct failure *failure) {
  memset(measurement, 0, sizeof *measurement);
  const bool weighted = request->weights != NULL;
  if (weighted && !weights_read(request->weights, "weight", molecule->atoms, &measurement->weights, failure))
    return false;
  if (!measurement_find_part(request, molecule, measurement, failure)) return false;
  /* Edges curve between two balls, and derivatives are by the others, too. */
  const uint8_t *const selected = request->measure.curvature || request->measure.gradient ? NULL : measurement->part;
  if (request->box.source != BOX_NONE
          ? !periodic_result_make(request, molecule, measurement->part_weights, geometry, &measurement->box, failure)
          : !geometry_compute_boundary_of(geometry, selected, failure)) {
    return false;
  }
  if (!measure_areas(request, molecule, geometry, measurement, failure)) return false;
  for (uint32_t i = 0; request->measure.polar && i < molecule->atoms; ++i) {
    const struct atom_label *const label = &molecule->label[i];
    *(label->polar    ? &measurement->polar_area
      : label->apolar ? &measurement->apolar_area
                      : &measurement->other_area) += measurement->area[i];
  }
  if (weighted && !measure_weighted_area(request, molecule->atoms, geometry, measurement, failure)) return false;
  if (request->window > 0.0 && !measure_window(request, molecule, geometry, measurement, failure)) return false;
  if (request->measure.curvature && !measure_curvatures(molecule, geometry, measurement, failure)) return false;
  if (!request->measure.gradient) return true;
  progress_show(&geometry->progress, "computing derivatives");
  return measure_gradients(molecule, geometry, request->excluded_surface, measurement, failure) &&
         (!weighted || measure_weighted_gradient(molecule, geometry, measurement, failure));
}

void measurement_quantities(const struct request *request, const struct measurement *measurement,
                            struct quantities *quantities) {
  const struct excluded_surface *const surface = &measurement->surface;
  const bool smooth = request->excluded_surface, whole = !request_wants_part(request);
  enum { TOTALS = 2 };
  const struct {
    bool asked;
    struct quantity quantity;
  } rows[MOST_QUANTITIES] = {
      {true, {"area", "area", "@^2", measurement->totals.area}},
      {whole, {"volume", "volume", "@^3", measurement->totals.volume}},
      {request->measure.curvature,
       {"mean_curvature", "mean curvature",
        whole ? "@, integrated over the boundary" : "@, integrated over what is measured",
        measurement->curvatures.mean}},
      {request->measure.curvature,
       {"gauss_curvature", "gauss curvature",
        whole ? ", 2 pi times its Euler characteristic" : ", likewise; corners belong to three balls",
        measurement->curvatures.gauss}},
      {smooth, {"convex_area", "convex area", "@^2, where the probe touches one atom", surface->convex_area}},
      {smooth, {"saddle_area", "saddle area", "@^2, where it touches two", surface->saddle_area}},
      {smooth, {"concave_area", "concave area", "@^2, where it touches three", surface->concave_area}},
      {request->weights != NULL,
       {"weighted_area", "weighted area",
        smooth ? ", the sum of weight x share of the area" : ", the sum of weight x free area",
        measurement->weighted_area}},
      {request->window > 0.0,
       {"windowed_area", "windowed area",
        request->weights != NULL ? ", the mean of the weighted area over the window of radii"
                                 : "@^2, its mean over the window of radii",
        measurement->windowed_area}},
      {request->measure.polar,
       {"polar_area", "polar area", "@^2, of nitrogen, oxygen and their hydrogens", measurement->polar_area}},
      {request->measure.polar,
       {"apolar_area", "apolar area", "@^2, of carbon, sulfur, selenium and theirs", measurement->apolar_area}},
      {request->measure.polar, {"other_area", "other area", "@^2, of all others", measurement->other_area}},
  };
  quantities->count = quantities->totals = 0;
  for (size_t k = 0; k < MOST_QUANTITIES; ++k) {
    if (rows[k].asked) quantities->of[quantities->count++] = rows[k].quantity;
    if (k < TOTALS) quantities->totals = quantities->count;
  }
}

void measurement_free(struct measurement *measurement) {
  free(measurement->part);
  free(measurement->part_weights);
  periodic_result_free(&measurement->box);
  free(measurement->area);
  free(measurement->weights);
  struct gradient *const gradients[] = {&measurement->of_area, &measurement->of_volume, &measurement->of_weighted_area,
                                        &measurement->of_windowed_area};
  for (size_t i = 0; i < sizeof gradients / sizeof gradients[0]; ++i) {
    free(gradients[i]->centre);
    free(gradients[i]->radius);
  }
  memset(measurement, 0, sizeof *measurement);
}
