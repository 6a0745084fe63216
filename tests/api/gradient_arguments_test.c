/* Arguments that measuring parts, gradients and rows of the Jacobian refuse, every call out of order, and every
 * output that may be left out. Nothing is written by a call that fails. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS, FACES = 3, ENTRIES = 3 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static hsp_model *model;
static hsp_boundary *boundary;

static const uint8_t selected[BALLS] = {1, 0, 1};
static const double sigma[BALLS] = {1, -2, 0};

static hsp_totals totals;
static double area[BALLS], volume[BALLS], face_area[FACES], face_volume[FACES];
static hsp_energy energy;
static double by_centre[BALLS][3], by_radius[BALLS], volume_by_centre[BALLS][3], volume_by_radius[BALLS];
static uint32_t flags[BALLS], needed;
static hsp_area_derivative row[ENTRIES];

static void fill_outputs(void) {
  FILL(totals);
  FILL(area);
  FILL(volume);
  FILL(face_area);
  FILL(face_volume);
  FILL(energy);
  FILL(by_centre);
  FILL(by_radius);
  FILL(volume_by_centre);
  FILL(volume_by_radius);
  FILL(flags);
  FILL(needed);
  FILL(row);
}

static void check_outputs_untouched(void) {
  CHECK_UNTOUCHED(totals);
  CHECK_UNTOUCHED(area);
  CHECK_UNTOUCHED(volume);
  CHECK_UNTOUCHED(face_area);
  CHECK_UNTOUCHED(face_volume);
  CHECK_UNTOUCHED(energy);
  CHECK_UNTOUCHED(by_centre);
  CHECK_UNTOUCHED(by_radius);
  CHECK_UNTOUCHED(volume_by_centre);
  CHECK_UNTOUCHED(volume_by_radius);
  CHECK_UNTOUCHED(flags);
  CHECK_UNTOUCHED(needed);
  CHECK_UNTOUCHED(row);
}

static int32_t gradient_with(const hsp_boundary *of, const double *weights, double tension, double pressure,
                             uint32_t tangency) {
  return hsp_boundary_get_gradient(
      of, SIZED(hsp_gradient_request, .sigma = weights, .tension = tension, .pressure = pressure, .tangency = tangency),
      SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = &by_centre[0][0], .d_radius = by_radius,
            .flags = flags, .capacity = BALLS));
}

static int32_t derivatives_with(const hsp_boundary *of, const double *weights, uint32_t tangency) {
  return hsp_boundary_get_derivatives(of, SIZED(hsp_derivatives_request, .sigma = weights, .tangency = tangency),
                                      SIZED(hsp_derivatives_outputs, .area_centre = &by_centre[0][0],
                                            .area_radius = by_radius, .volume_centre = &volume_by_centre[0][0],
                                            .volume_radius = volume_by_radius, .flags = flags, .capacity = BALLS));
}

static void check_measure(const hsp_boundary *which, int32_t status) {
  CHECK_EQUAL(hsp_boundary_measure(which, selected, &totals, area, volume, BALLS, NULL), status);
}

static void out_of_order(void) {
  static const double bad_radius[BALLS] = {1, -1, 1};
  hsp_boundary_limits limits;
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.vertices = limits.circles = 16;
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  check_scene("nothing computed");
  check_measure(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_scene("model set to fewer balls, then the same again");
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_measure(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_gradient(boundary, SIZED(hsp_gradient_request, .tension = 1),
                                        SIZED(hsp_gradient_outputs, .capacity = 0)),
              HSP_OK);
  check_scene("model emptied by a refusal");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_measure(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_scene("a limit was too small");
  limits.vertices = 1;
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_E_CAPACITY);
  check_measure(boundary, HSP_E_STATE);
  limits.vertices = 16;
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
}

static void bad_arguments(void) {
  static const double not_finite[3] = {NAN, INFINITY, -INFINITY};
  static const uint32_t unknown[3] = {2, 77, HSP_NONE};
  double weights[BALLS] = {1, 1, 1};
  int v, i;
  fill_outputs();
  check_scene("unknown tangency");
  for (v = 0; v < 3; ++v) {
    CHECK_EQUAL(gradient_with(boundary, NULL, 1, 1, unknown[v]), HSP_E_ARGUMENT);
    CHECK_EQUAL(derivatives_with(boundary, NULL, unknown[v]), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_get_area_row(boundary, 0, unknown[v], row, ENTRIES, &needed), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_get_area_row(boundary, 0, unknown[v], NULL, 0, &needed), HSP_E_ARGUMENT);
  }
  check_scene("numbers that are not finite");
  for (v = 0; v < 3; ++v) {
    CHECK_EQUAL(gradient_with(boundary, NULL, not_finite[v], 1, HSP_TANGENT_OVERLAP), HSP_E_NOT_FINITE);
    CHECK_EQUAL(gradient_with(boundary, NULL, 1, not_finite[v], HSP_TANGENT_OVERLAP), HSP_E_NOT_FINITE);
    for (i = 0; i < BALLS; ++i) {
      hsp_gradient_outputs nothing = {.struct_size = sizeof nothing, .first_bad = 12345};
      hsp_derivatives_outputs no_parts = {.struct_size = sizeof no_parts, .first_bad = 12345};
      weights[i] = not_finite[v];
      CHECK_EQUAL(derivatives_with(boundary, weights, HSP_TANGENT_OVERLAP), HSP_E_NOT_FINITE);
      /* whether or not results are asked for */
      CHECK_EQUAL(
          hsp_boundary_get_gradient(
              boundary, SIZED(hsp_gradient_request, .sigma = weights, .tension = 1, .tangency = HSP_TANGENT_DISJOINT),
              &nothing),
          HSP_E_NOT_FINITE);
      CHECK_EQUAL(nothing.first_bad, i);
      CHECK_EQUAL(
          hsp_boundary_get_derivatives(
              boundary, SIZED(hsp_derivatives_request, .sigma = weights, .tangency = HSP_TANGENT_DISJOINT), &no_parts),
          HSP_E_NOT_FINITE);
      CHECK_EQUAL(no_parts.first_bad, i);
      CHECK_EQUAL(gradient_with(boundary, weights, 1, 1, HSP_TANGENT_DISJOINT), HSP_E_NOT_FINITE);
      /* whatever it is multiplied with */
      CHECK_EQUAL(gradient_with(boundary, weights, 0, 1, HSP_TANGENT_OVERLAP), HSP_E_NOT_FINITE);
      weights[i] = 1;
    }
  }
  {
    hsp_gradient_outputs nothing = {.struct_size = sizeof nothing, .first_bad = 12345};
    CHECK_EQUAL(
        hsp_boundary_get_gradient(boundary, SIZED(hsp_gradient_request, .sigma = weights, .tension = NAN), &nothing),
        HSP_E_NOT_FINITE);
    CHECK_EQUAL(nothing.first_bad, HSP_NONE);
  }
  check_scene("rows");
  CHECK_EQUAL(hsp_boundary_get_area_row(boundary, BALLS, HSP_TANGENT_OVERLAP, row, ENTRIES, &needed), HSP_E_ID);
  check_outputs_untouched();
}

/* One array, or all, and a capacity that is too small by one, or 0. */
static void too_small(void) {
  uint32_t capacity;
  fill_outputs();
  check_scene("too small");
  for (capacity = 0; capacity < BALLS; ++capacity) {
    CHECK_EQUAL(hsp_boundary_measure(boundary, selected, &totals, area, NULL, capacity, NULL), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, &totals, NULL, volume, capacity, NULL), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_measure(boundary, selected, NULL, area, volume, capacity, NULL), HSP_E_CAPACITY);
    CHECK_EQUAL(
        hsp_boundary_get_measures(boundary, NULL, SIZED(hsp_measure_outputs, .area = area, .capacity = capacity)),
        HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_get_measures(boundary, NULL,
                                          SIZED(hsp_measure_outputs, .volume_term = volume, .capacity = capacity)),
                HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_measure_faces(boundary, face_area, NULL, capacity, NULL), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_measure_faces(boundary, NULL, face_volume, capacity, NULL), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_measure_faces(boundary, face_area, face_volume, capacity, NULL), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_get_gradient(
                    boundary, SIZED(hsp_gradient_request, .sigma = sigma, .tension = 1, .pressure = 1),
                    SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = &by_centre[0][0], .capacity = capacity)),
                HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_get_gradient(
                    boundary, SIZED(hsp_gradient_request, .sigma = sigma, .tension = 1, .pressure = 1),
                    SIZED(hsp_gradient_outputs, .energy = &energy, .d_radius = by_radius, .capacity = capacity)),
                HSP_E_CAPACITY);
    CHECK_EQUAL(
        hsp_boundary_get_gradient(
            boundary, SIZED(hsp_gradient_request, .tension = 1, .pressure = 1, .tangency = HSP_TANGENT_DISJOINT),
            SIZED(hsp_gradient_outputs, .energy = &energy, .flags = flags, .capacity = capacity)),
        HSP_E_CAPACITY);
    CHECK_EQUAL(
        hsp_boundary_get_gradient(
            boundary, SIZED(hsp_gradient_request, .tension = 1, .pressure = 1, .tangency = HSP_TANGENT_DISJOINT),
            SIZED(hsp_gradient_outputs, .d_centre = &by_centre[0][0], .d_radius = by_radius, .flags = flags,
                  .capacity = capacity)),
        HSP_E_CAPACITY);
  }
  check_outputs_untouched();
  for (capacity = 0; capacity <= BALLS; ++capacity) {
    const int32_t status = capacity < BALLS ? HSP_E_CAPACITY : HSP_OK;
    hsp_gradient_outputs gradient = {.struct_size = sizeof gradient, .capacity = capacity, .d_radius = by_radius};
    hsp_derivatives_outputs parts = {
        .struct_size = sizeof parts, .capacity = capacity, .volume_radius = volume_by_radius};
    uint32_t balls = 0, faces = 0;
    CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, area, NULL, capacity, &balls), status);
    CHECK_EQUAL(hsp_boundary_measure_faces(boundary, face_area, NULL, capacity, &faces), status); /* FACES == BALLS */
    CHECK_EQUAL(
        hsp_boundary_get_gradient(boundary, SIZED(hsp_gradient_request, .tension = 1, .pressure = 1), &gradient),
        status);
    CHECK_EQUAL(hsp_boundary_get_derivatives(boundary, NULL, &parts), status);
    CHECK(balls == BALLS && faces == FACES && gradient.needed == BALLS && parts.needed == BALLS);
  }
  fill_outputs();
  CHECK_EQUAL(hsp_boundary_get_area_row(boundary, 0, HSP_TANGENT_OVERLAP, row, ENTRIES - 1, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, ENTRIES);
  CHECK_UNTOUCHED(row);
}

/* Everything else is the same if one output is left out. */
static void left_out(void) {
  hsp_energy all_energy;
  double all_centre[BALLS][3], all_radius[BALLS], all_volume_centre[BALLS][3], all_volume_radius[BALLS];
  uint32_t all_flags[BALLS];
  int given;
  CHECK_EQUAL(gradient_with(boundary, sigma, 3, -0.5, HSP_TANGENT_OVERLAP), HSP_OK);
  all_energy = energy;
  memcpy(all_centre, by_centre, sizeof all_centre);
  memcpy(all_radius, by_radius, sizeof all_radius);
  memcpy(all_flags, flags, sizeof all_flags);
  for (given = 0; given < 16; ++given) {
    check_scene("gradient without those outputs that 15 - %d stands for", given);
    fill_outputs();
    CHECK_EQUAL(hsp_boundary_get_gradient(
                    boundary, SIZED(hsp_gradient_request, .sigma = sigma, .tension = 3, .pressure = -0.5),
                    SIZED(hsp_gradient_outputs, .energy = (given & 1) != 0 ? &energy : NULL,
                          .d_centre = (given & 2) != 0 ? &by_centre[0][0] : NULL,
                          .d_radius = (given & 4) != 0 ? by_radius : NULL, .flags = (given & 8) != 0 ? flags : NULL,
                          .capacity = (given & 14) != 0 ? BALLS : 0)),
                HSP_OK);
    if ((given & 1) != 0) CHECK_BYTES(&energy, &all_energy, sizeof energy);
    if ((given & 2) != 0) CHECK_BYTES(by_centre, all_centre, sizeof by_centre);
    if ((given & 4) != 0) CHECK_BYTES(by_radius, all_radius, sizeof by_radius);
    if ((given & 8) != 0) CHECK_BYTES(flags, all_flags, sizeof flags);
    if ((given & 1) == 0) CHECK_UNTOUCHED(energy);
    if ((given & 2) == 0) CHECK_UNTOUCHED(by_centre);
    if ((given & 4) == 0) CHECK_UNTOUCHED(by_radius);
    if ((given & 8) == 0) CHECK_UNTOUCHED(flags);
  }
  check_scene("derivatives, all and each alone, are the gradient's two parts");
  CHECK_EQUAL(gradient_with(boundary, sigma, 1, 0, HSP_TANGENT_DISJOINT), HSP_OK);
  memcpy(all_centre, by_centre, sizeof all_centre);
  memcpy(all_radius, by_radius, sizeof all_radius);
  CHECK_EQUAL(gradient_with(boundary, sigma, 0, 1, HSP_TANGENT_DISJOINT), HSP_OK);
  memcpy(all_volume_centre, by_centre, sizeof all_volume_centre);
  memcpy(all_volume_radius, by_radius, sizeof all_volume_radius);
  memcpy(all_flags, flags, sizeof all_flags);
  for (given = 0; given < 32; ++given) {
    fill_outputs();
    CHECK_EQUAL(hsp_boundary_get_derivatives(
                    boundary, SIZED(hsp_derivatives_request, .sigma = sigma, .tangency = HSP_TANGENT_DISJOINT),
                    SIZED(hsp_derivatives_outputs, .area_centre = (given & 1) != 0 ? &by_centre[0][0] : NULL,
                          .area_radius = (given & 2) != 0 ? by_radius : NULL,
                          .volume_centre = (given & 4) != 0 ? &volume_by_centre[0][0] : NULL,
                          .volume_radius = (given & 8) != 0 ? volume_by_radius : NULL,
                          .flags = (given & 16) != 0 ? flags : NULL, .capacity = given ? BALLS : 0)),
                HSP_OK);
    if ((given & 1) != 0) CHECK_BYTES(by_centre, all_centre, sizeof by_centre);
    if ((given & 2) != 0) CHECK_BYTES(by_radius, all_radius, sizeof by_radius);
    if ((given & 4) != 0) CHECK_BYTES(volume_by_centre, all_volume_centre, sizeof by_centre);
    if ((given & 8) != 0) CHECK_BYTES(volume_by_radius, all_volume_radius, sizeof by_radius);
    if ((given & 16) != 0) CHECK_BYTES(flags, all_flags, sizeof flags);
    if ((given & 1) == 0) CHECK_UNTOUCHED(by_centre);
    if ((given & 2) == 0) CHECK_UNTOUCHED(by_radius);
    if ((given & 4) == 0) CHECK_UNTOUCHED(volume_by_centre);
    if ((given & 8) == 0) CHECK_UNTOUCHED(volume_by_radius);
    if ((given & 16) == 0) CHECK_UNTOUCHED(flags);
  }
  check_scene("measures of parts, left out");
  fill_outputs();
  CHECK_EQUAL(hsp_boundary_measure(boundary, selected, NULL, NULL, NULL, 0, NULL), HSP_OK);
  check_outputs_untouched();
  CHECK_EQUAL(hsp_boundary_measure(boundary, selected, NULL, area, NULL, BALLS, NULL), HSP_OK);
  CHECK(area[0] > 0 && area[1] == 0 && area[2] > 0);
  CHECK_UNTOUCHED(volume);
  CHECK_EQUAL(hsp_boundary_measure(boundary, selected, NULL, NULL, volume, BALLS, NULL), HSP_OK);
  CHECK(volume[0] > 0 && volume[1] == 0 && volume[2] > 0);
  CHECK_UNTOUCHED(totals);
  CHECK_EQUAL(hsp_boundary_measure(boundary, selected, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_NEAR(totals.area, area[0] + area[2], 1e-13);
  CHECK_NEAR(totals.volume, volume[0] + volume[2], 1e-13);
  CHECK_EQUAL(hsp_boundary_measure_faces(boundary, face_area, NULL, FACES, NULL), HSP_OK);
  CHECK_UNTOUCHED(face_volume);
  CHECK(face_area[0] > 0 && face_area[1] > 0 && face_area[2] > 0);
  CHECK_EQUAL(hsp_boundary_measure_faces(boundary, NULL, face_volume, FACES, NULL), HSP_OK);
  CHECK(face_volume[0] > 0 && face_volume[1] > 0 && face_volume[2] > 0);
}

/* Without balls there is nothing to give room to. */
static void no_balls(void) {
  check_scene("no balls");
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  fill_outputs();
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, area, volume, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure_faces(boundary, face_area, face_volume, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure_faces(boundary, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(
      hsp_boundary_get_gradient(
          boundary,
          SIZED(hsp_gradient_request, .sigma = sigma, .tension = 1, .pressure = 1, .tangency = HSP_TANGENT_DISJOINT),
          SIZED(hsp_gradient_outputs, .d_centre = &by_centre[0][0], .d_radius = by_radius, .flags = flags)),
      HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_area_row(boundary, 0, HSP_TANGENT_OVERLAP, row, ENTRIES, &needed), HSP_E_ID);
  CHECK_EQUAL(gradient_with(boundary, NULL, NAN, 1, HSP_TANGENT_OVERLAP), HSP_E_NOT_FINITE);
  CHECK_EQUAL(gradient_with(boundary, NULL, 1, 1, 2), HSP_E_ARGUMENT);
  check_outputs_untouched();
  CHECK_EQUAL(hsp_boundary_measure(boundary, selected, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK(totals.area == 0 && totals.volume == 0);
  CHECK_EQUAL(hsp_boundary_get_gradient(
                  boundary, SIZED(hsp_gradient_request, .tension = 1, .pressure = 1, .tangency = HSP_TANGENT_DISJOINT),
                  SIZED(hsp_gradient_outputs, .energy = &energy)),
              HSP_OK);
  CHECK(energy.value == 0 && energy.area == 0 && energy.volume == 0 && energy.d_probe == 0);
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  out_of_order();
  bad_arguments();
  too_small();
  left_out();
  no_balls();
  return check_report();
}
