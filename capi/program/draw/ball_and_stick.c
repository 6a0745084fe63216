#include "draw/ball_and_stick.h"

#include <stdlib.h>
#include <string.h>

#include "draw/stick_repair.h"
#include "draw/view_axes.h"
#include "read/bonds.h"
#include "read/stopping.h"

static const double default_ball_size = 0.25;
static const double default_stick = 0.12;

double ball_and_stick_size(const struct drawing *drawing) {
  return drawing->ball_size > 0.0 ? drawing->ball_size : default_ball_size;
}

double ball_and_stick_radius(const struct drawing *drawing) {
  return drawing->stick > 0.0 ? drawing->stick : default_stick;
}

static bool set_balls(const struct molecule *molecule, const double *radius, struct geometry *geometry,
                      struct failure *failure) {
  geometry->work.executor = stopping_executor();
  const int32_t status = hsp_workspace_set(&geometry->work, molecule->atoms, molecule->xyz, radius, NULL, NULL);
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

/* Into a handle in memory of its own; as a map also where they have an order. A conflict is no failure. */
static bool compute(const struct molecule *molecule, const struct drawing *drawing, const struct stick_parts *parts,
                    bool as_map, struct geometry *geometry, hsp_sticks **sticks, void **memory,
                    hsp_sticks_conflict *conflict, struct failure *failure) {
  const hsp_model *model = geometry->work.model;
  hsp_view_options options;
  hsp_sticks_limits limits;
  int32_t (*const find)(hsp_sticks *, const hsp_model *, const hsp_view_options *, const hsp_stick *, uint32_t, double,
                        hsp_sticks_conflict *, hsp_sticks_limits *) =
      as_map ? hsp_sticks_compute_map : hsp_sticks_compute;
  progress_show(&geometry->progress, "ordering balls and sticks");
  int32_t status = viewing_options(&drawing->viewing, molecule, &options);
  if (status == HSP_OK) status = hsp_sticks_limits_init(&limits, (uint32_t)sizeof limits, molecule->atoms);
  if (status != HSP_OK) return failure_in_library(failure, status);
  limits.sticks = parts->sticks;
  do {
    size_t bytes = 0;
    status = hsp_sticks_bytes(&limits, &bytes);
    if (status == HSP_OK) status = hsp_workspace_allocate(memory, bytes);
    if (status == HSP_OK) status = hsp_sticks_init(*memory, bytes, &limits, sticks);
    if (status == HSP_OK) {
      status = find(*sticks, model, &options, parts->stick, parts->sticks, parts->stick_radius, conflict, &limits);
    }
  } while (status == HSP_E_CAPACITY);
  if (status != HSP_E_CONFLICT) conflict->kind = HSP_STICKS_NO_CONFLICT;
  return status == HSP_OK || status == HSP_E_CONFLICT || failure_in_library(failure, status);
}

/* Turn the axes so that the other atoms bonded to the ends of an aromatic bond are on the right of the way along it. */
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

/* With no more repairs than `most`; without any the conflict is a failure. */
static bool compute_sticks(const struct molecule *molecule, const struct drawing *drawing, struct stick_parts *parts,
                           uint32_t most, struct geometry *geometry, struct failure *failure) {
  const bool as_map = drawing_is_of_map(drawing), inked = drawing_has_ink(drawing);
  hsp_sticks_conflict conflict;
  for (uint32_t repairs = 0;; ++repairs) {
    if (!set_balls(molecule, parts->radius, geometry, failure) ||
        !compute(molecule, drawing, parts, as_map, geometry, &geometry->sticks, &geometry->sticks_memory, &conflict,
                 failure)) {
      return false;
    }
    if (conflict.kind == HSP_STICKS_NO_CONFLICT) break;
    if (repairs == most || !stick_repair(molecule, &conflict, parts)) {
      return failure_of_conflict(molecule, parts->stick, &conflict, failure);
    }
  }
  geometry->ink_of_sticks = geometry->sticks;
  if (as_map || !inked) return true;
  return compute(molecule, drawing, parts, true, geometry, &geometry->ink_of_sticks, &geometry->ink_of_sticks_memory,
                 &conflict, failure) &&
         (conflict.kind == HSP_STICKS_NO_CONFLICT || failure_of_conflict(molecule, parts->stick, &conflict, failure));
}

/* Balls as they are, and a stick for each bond. */
static bool make_parts(const struct molecule *molecule, const struct drawing *drawing, double axis[3][3],
                       const struct geometry *geometry, const uint32_t *colour, bool with_orders,
                       struct stick_parts *parts, struct failure *failure) {
  const double size = ball_and_stick_size(drawing);
  free(parts->stick);
  parts->stick = sticks_of(molecule, axis, geometry->bond, geometry->bonds, colour, with_orders);
  parts->sticks = geometry->bonds;
  if (parts->stick == NULL || parts->radius == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < molecule->atoms; ++i) parts->radius[i] = size * molecule->radius[i];
  return true;
}

/* Multiple bonds are thicker. If they do not fit, all bonds are tried as single ones. If these do not fit either, bonds
 * are multiple, and a few bodies that are in the way are changed. */
static bool compute_bonds(const struct molecule *molecule, const struct drawing *drawing, const uint32_t *colour,
                          double axis[3][3], struct stick_parts *parts, struct geometry *geometry,
                          struct failure *failure) {
  enum { MOST = 40, SHARE = 10 };
  const uint32_t most = geometry->bonds / SHARE + 2 < MOST ? geometry->bonds / SHARE + 2 : MOST;
  const struct {
    bool orders;
    uint32_t repairs;
  } ways[] = {{true, 0}, {false, 0}, {true, most}};
  const struct failure before = *failure;
  struct failure conflict = before;
  for (int k = geometry->multiple_bonds > 0 ? 0 : 1; k < 3; ++k) {
    *failure = before;
    if (!make_parts(molecule, drawing, axis, geometry, colour, ways[k].orders, parts, failure)) return false;
    if (compute_sticks(molecule, drawing, parts, ways[k].repairs, geometry, failure)) {
      geometry->multiple_shown = ways[k].orders && geometry->multiple_bonds > parts->single;
      if (ways[k].repairs > 0) stick_repair_tell(parts, conflict.reason, geometry->misfit);
      return true;
    }
    if (k < 2) conflict = *failure;
  }
  *failure = conflict;
  return false;
}

bool ball_and_stick_compute(const struct molecule *molecule, const struct drawing *drawing, const uint32_t *colour,
                            struct geometry *geometry, struct failure *failure) {
  double axis[3][3];
  free(geometry->bond);
  geometry->bond = NULL;
  geometry->misfit[0] = '\0';
  const int32_t status = viewing_axes(&drawing->viewing, molecule, axis);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (!bonds_find(molecule, geometry, &geometry->bond, &geometry->bonds, failure)) return false;
  geometry->multiple_bonds = 0;
  for (uint32_t k = 0; k < geometry->bonds; ++k) {
    geometry->multiple_bonds += geometry->bond[k].order > BOND_SINGLE ? 1U : 0U;
  }
  struct stick_parts parts = {.radius = calloc((size_t)molecule->atoms + 1, sizeof *parts.radius),
                              .stick_radius = ball_and_stick_radius(drawing)};
  const bool done = compute_bonds(molecule, drawing, colour, axis, &parts, geometry, failure);
  free(parts.radius);
  free(parts.stick);
  return done;
}
