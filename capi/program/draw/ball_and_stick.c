#include "draw/ball_and_stick.h"

#include <stdlib.h>

#include "draw/bonds.h"
#include "draw/view_axes.h"

static const double default_ball_size = 0.25;
static const double default_stick = 0.12;

double ball_and_stick_size(const struct drawing *drawing) {
  return drawing->ball_size > 0.0 ? drawing->ball_size : default_ball_size;
}

static bool set_balls(const struct molecule *molecule, double size, struct geometry *geometry,
                      struct failure *failure) {
  double *radius = calloc((size_t)molecule->atoms + 1, sizeof *radius);
  if (radius == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < molecule->atoms; ++i) radius[i] = size * molecule->radius[i];
  const int32_t status = hsp_workspace_set(&geometry->work, molecule->atoms, molecule->xyz, radius, NULL, NULL);
  free(radius);
  return status == HSP_OK || failure_in_library(failure, status);
}

static bool failure_of_conflict(const struct molecule *molecule, const hsp_stick *stick,
                                const hsp_sticks_conflict *conflict, struct failure *failure) {
  const uint32_t first = conflict->first, second = conflict->second;
  const uint64_t line = molecule->line[stick[first].ball[0]];
  const unsigned long a = stick[first].ball[0], b = stick[first].ball[1];
  switch (conflict->kind) {
    case HSP_STICKS_THIN_BALL:
      return failure_in_input(failure, line, "ball %lu is not thicker than its sticks: see --ball-size and --stick",
                              (unsigned long)second);
    case HSP_STICKS_STICK_IN_BALL:
      return failure_in_input(failure, line, "the stick between balls %lu and %lu runs into ball %lu", a, b,
                              (unsigned long)second);
    default:
      return failure_in_input(failure, line,
                              "the sticks between balls %lu and %lu and balls %lu and %lu meet: see --ball-size and "
                              "--stick",
                              a, b, (unsigned long)stick[second].ball[0], (unsigned long)stick[second].ball[1]);
  }
}

/* Into a handle in memory of its own; as a map also where they have an order. */
static bool compute(const struct molecule *molecule, const struct drawing *drawing, const hsp_stick *stick,
                    uint32_t count, bool as_map, struct geometry *geometry, hsp_sticks **sticks, void **memory,
                    struct failure *failure) {
  const double radius = drawing->stick > 0.0 ? drawing->stick : default_stick;
  const hsp_model *model = geometry->work.model;
  hsp_view_options options;
  hsp_sticks_limits limits;
  hsp_sticks_conflict conflict;
  int32_t (*const find)(hsp_sticks *, const hsp_model *, const hsp_view_options *, const hsp_stick *, uint32_t, double,
                        hsp_sticks_conflict *, hsp_sticks_limits *) =
      as_map ? hsp_sticks_compute_map : hsp_sticks_compute;
  progress_show(&geometry->progress, "ordering balls and sticks");
  int32_t status = viewing_options(&drawing->viewing, molecule, &options);
  if (status == HSP_OK) status = hsp_sticks_limits_init(&limits, (uint32_t)sizeof limits, molecule->atoms);
  if (status != HSP_OK) return failure_in_library(failure, status);
  limits.sticks = count;
  do {
    size_t bytes = 0;
    status = hsp_sticks_bytes(&limits, &bytes);
    if (status == HSP_OK) status = hsp_workspace_allocate(memory, bytes);
    if (status == HSP_OK) status = hsp_sticks_init(*memory, bytes, &limits, sticks);
    if (status == HSP_OK) status = find(*sticks, model, &options, stick, count, radius, &conflict, &limits);
  } while (status == HSP_E_CAPACITY);
  if (status == HSP_E_CONFLICT) return failure_of_conflict(molecule, stick, &conflict, failure);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* A stick for each bond, to be freed; NULL where memory is short. */
static hsp_stick *sticks_of(uint32_t (*bonds)[2], uint32_t count, const uint32_t *colour) {
  hsp_stick *stick = calloc((size_t)count + 1, sizeof *stick);
  for (uint32_t k = 0; stick != NULL && k < count; ++k) {
    const uint32_t *bond = bonds[k];
    stick[k].ball[0] = bond[0];
    stick[k].ball[1] = bond[1];
    if (colour[bond[0]] == colour[bond[1]]) stick[k].flags = HSP_STICK_WHOLE;
  }
  return stick;
}

bool ball_and_stick_compute(const struct molecule *molecule, const struct drawing *drawing, const uint32_t *colour,
                            struct geometry *geometry, struct failure *failure) {
  uint32_t(*bonds)[2] = NULL;
  uint32_t count = 0;
  if (!bonds_find(molecule, geometry, &bonds, &count, failure)) return false;
  hsp_stick *stick = sticks_of(bonds, count, colour);
  free(bonds);
  if (stick == NULL) return failure_of_memory(failure);
  const bool as_map = drawing_is_of_map(drawing), inked = drawing_has_ink(drawing);
  bool done =
      set_balls(molecule, ball_and_stick_size(drawing), geometry, failure) &&
      compute(molecule, drawing, stick, count, as_map, geometry, &geometry->sticks, &geometry->sticks_memory, failure);
  geometry->ink_of_sticks = geometry->sticks;
  if (done && inked && !as_map) {
    done = compute(molecule, drawing, stick, count, true, geometry, &geometry->ink_of_sticks,
                   &geometry->ink_of_sticks_memory, failure);
  }
  free(stick);
  return done;
}
