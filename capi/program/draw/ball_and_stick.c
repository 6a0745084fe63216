#include "draw/ball_and_stick.h"

#include <stdlib.h>
#include <string.h>

#include "draw/bonds.h"
#include "draw/view_axes.h"

static const double default_ball_size = 0.25;
static const double default_stick = 0.12;

double ball_and_stick_size(const struct drawing *drawing) {
  return drawing->ball_size > 0.0 ? drawing->ball_size : default_ball_size;
}

double ball_and_stick_radius(const struct drawing *drawing) {
  return drawing->stick > 0.0 ? drawing->stick : default_stick;
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
  const double radius = ball_and_stick_radius(drawing);
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

/* Turned so that what else is bonded to the ends of an aromatic bond is on the right of the way along it. */
static void turn_to_ring(const struct molecule *molecule, double axis[3][3], const struct bond *bonds, uint32_t count,
                         hsp_stick *stick) {
  const double *const from = molecule->xyz + 3 * (size_t)stick->ball[0];
  const double *const to = molecule->xyz + 3 * (size_t)stick->ball[1];
  double left = 0.0;
  for (uint32_t k = 0; k < count; ++k) {
    for (int end = 0; end < 2; ++end) {
      const uint32_t inner = bonds[k].atom[end], outer = bonds[k].atom[1 - end];
      if (bonds[k].order != BOND_AROMATIC || (inner != stick->ball[0] && inner != stick->ball[1])) continue;
      const double *const at = molecule->xyz + 3 * (size_t)outer;
      double along[2] = {0.0, 0.0}, away[2] = {0.0, 0.0};
      for (int i = 0; i < 2; ++i) {
        for (int k3 = 0; k3 < 3; ++k3) {
          along[i] += axis[i][k3] * (to[k3] - from[k3]);
          away[i] += axis[i][k3] * (at[k3] - from[k3]);
        }
      }
      left += along[0] * away[1] - along[1] * away[0];
    }
  }
  if (left <= 0.0) return;
  const uint32_t first = stick->ball[0];
  stick->ball[0] = stick->ball[1];
  stick->ball[1] = first;
}

/* A stick for each bond, to be freed; NULL where memory is short. */
static hsp_stick *sticks_of(const struct molecule *molecule, double axis[3][3], const struct bond *bonds,
                            uint32_t count, const uint32_t *colour, bool with_orders) {
  static const uint32_t flags[] = {
      [BOND_DOUBLE] = HSP_STICK_DOUBLE, [BOND_TRIPLE] = HSP_STICK_TRIPLE, [BOND_AROMATIC] = HSP_STICK_AROMATIC};
  hsp_stick *stick = calloc((size_t)count + 1, sizeof *stick);
  for (uint32_t k = 0; stick != NULL && k < count; ++k) {
    const uint32_t *bond = bonds[k].atom;
    memcpy(stick[k].ball, bond, sizeof stick[k].ball);
    if (colour[bond[0]] == colour[bond[1]]) stick[k].flags = HSP_STICK_WHOLE;
    if (with_orders) stick[k].flags |= flags[bonds[k].order];
    if (stick[k].flags & HSP_STICK_AROMATIC) turn_to_ring(molecule, axis, bonds, count, &stick[k]);
  }
  return stick;
}

static bool compute_sticks(const struct molecule *molecule, const struct drawing *drawing, const hsp_stick *stick,
                           uint32_t count, struct geometry *geometry, struct failure *failure) {
  const bool as_map = drawing_is_of_map(drawing), inked = drawing_has_ink(drawing);
  if (stick == NULL) return failure_of_memory(failure);
  bool done =
      compute(molecule, drawing, stick, count, as_map, geometry, &geometry->sticks, &geometry->sticks_memory, failure);
  geometry->ink_of_sticks = geometry->sticks;
  if (done && inked && !as_map) {
    done = compute(molecule, drawing, stick, count, true, geometry, &geometry->ink_of_sticks,
                   &geometry->ink_of_sticks_memory, failure);
  }
  return done;
}

/* Multiple bonds are thicker. Where they do not fit they are drawn as single ones, which may. */
static bool compute_bonds(const struct molecule *molecule, const struct drawing *drawing, const struct bond *bonds,
                          uint32_t count, const uint32_t *colour, struct geometry *geometry, struct failure *failure) {
  double axis[3][3];
  const int32_t status = viewing_axes(&drawing->viewing, molecule, axis);
  if (status != HSP_OK) return failure_in_library(failure, status);
  geometry->multiple_bonds = 0;
  for (uint32_t k = 0; k < count; ++k) geometry->multiple_bonds += bonds[k].order > BOND_SINGLE ? 1U : 0U;
  geometry->multiple_shown = false;
  if (geometry->multiple_bonds > 0) {
    struct failure unfit = *failure;
    hsp_stick *stick = sticks_of(molecule, axis, bonds, count, colour, true);
    geometry->multiple_shown = compute_sticks(molecule, drawing, stick, count, geometry, &unfit);
    free(stick);
    if (geometry->multiple_shown) return true;
  }
  hsp_stick *stick = sticks_of(molecule, axis, bonds, count, colour, false);
  const bool done = compute_sticks(molecule, drawing, stick, count, geometry, failure);
  free(stick);
  return done;
}

bool ball_and_stick_compute(const struct molecule *molecule, const struct drawing *drawing, const uint32_t *colour,
                            struct geometry *geometry, struct failure *failure) {
  free(geometry->bond);
  geometry->bond = NULL;
  return bonds_find(molecule, geometry, &geometry->bond, &geometry->bonds, failure) &&
         set_balls(molecule, ball_and_stick_size(drawing), geometry, failure) &&
         compute_bonds(molecule, drawing, geometry->bond, geometry->bonds, colour, geometry, failure);
}
