#include "draw/ball_and_stick.h"

#include <math.h>
#include <stdio.h>
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

/* Balls and sticks that are to fit each other. */
struct parts {
  double *radius; /* of each ball */
  hsp_stick *stick;
  uint32_t sticks;
  double stick_radius; /* of all that are no bonds of several strands */
  uint32_t smaller;    /* balls that were made smaller */
  uint32_t single;     /* sticks of which that is so */
  uint32_t left_out;   /* sticks */
};

static bool set_balls(const struct molecule *molecule, const double *radius, struct geometry *geometry,
                      struct failure *failure) {
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
static bool compute(const struct molecule *molecule, const struct drawing *drawing, const struct parts *parts,
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

/* ---- what does not fit ---- */

static double radius_of_stick(const struct parts *parts, const hsp_stick *stick) {
  const uint32_t thick = HSP_STICK_DOUBLE | HSP_STICK_TRIPLE | HSP_STICK_AROMATIC;
  return (stick->flags & thick) != 0 ? 1.5 * parts->stick_radius : parts->stick_radius;
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void way(const struct molecule *molecule, uint32_t from, uint32_t to, double out[3]) {
  for (size_t k = 0; k < 3; ++k) out[k] = molecule->xyz[3 * (size_t)to + k] - molecule->xyz[3 * (size_t)from + k];
}

/* How far a point is from a stick, a cylinder with flat ends. */
static double distance_to(const struct molecule *molecule, const struct parts *parts, const hsp_stick *stick,
                          uint32_t ball) {
  double axis[3], to[3];
  way(molecule, stick->ball[0], stick->ball[1], axis);
  way(molecule, stick->ball[0], ball, to);
  const double length = sqrt(dot(axis, axis)), along = length > 0.0 ? dot(axis, to) / length : 0.0;
  const double across = sqrt(fmax(0.0, dot(to, to) - along * along)) - radius_of_stick(parts, stick);
  return hypot(fmax(0.0, across), fmax(0.0, fmax(-along, along - length)));
}

/* The least radius of a ball with which its own sticks do not meet outside of it: sticks.h. */
static double least_radius(const struct molecule *molecule, const struct parts *parts, uint32_t ball) {
  double least = 0.0;
  for (uint32_t k = 0; k < parts->sticks; ++k) {
    const hsp_stick *const one = &parts->stick[k];
    if (one->ball[0] != ball && one->ball[1] != ball) continue;
    double axis[3];
    way(molecule, ball, one->ball[one->ball[0] == ball ? 1 : 0], axis);
    least = fmax(least, radius_of_stick(parts, one));
    for (uint32_t l = 0; l < k; ++l) {
      const hsp_stick *const two = &parts->stick[l];
      if (two->ball[0] != ball && two->ball[1] != ball) continue;
      double other[3];
      way(molecule, ball, two->ball[two->ball[0] == ball ? 1 : 0], other);
      const double cosine = dot(axis, other) / sqrt(dot(axis, axis) * dot(other, other));
      const double half = sqrt(fmax(0.0, 0.5 - 0.5 * cosine)); /* sine of half the angle */
      least = fmax(least, fmax(radius_of_stick(parts, one), radius_of_stick(parts, two)) / half);
    }
  }
  return least;
}

static double squared_length(const struct molecule *molecule, const hsp_stick *stick) {
  double axis[3];
  way(molecule, stick->ball[0], stick->ball[1], axis);
  return dot(axis, axis);
}

/* A bond of several strands becomes a thinner, single one; a ball that a stick runs into becomes smaller, unless it
 * would be small for its own sticks or less than a third of what it was; else a stick is left out, of two the longer
 * one. False: that does not help. */
static bool repair(const struct molecule *molecule, const hsp_sticks_conflict *conflict, struct parts *parts) {
  static const double narrower = 0.999, wider = 1.001, smallest = 1.0 / 3.0;
  const bool two = conflict->kind == HSP_STICKS_SHARP_ANGLE || conflict->kind == HSP_STICKS_MEET;
  const bool thin = conflict->kind == HSP_STICKS_THIN_BALL;
  if (!two && !thin && conflict->kind != HSP_STICKS_STICK_IN_BALL) return false;
  hsp_stick *const one = &parts->stick[conflict->first], *const other = two ? &parts->stick[conflict->second] : one;
  hsp_stick *const thick = radius_of_stick(parts, one) > parts->stick_radius ? one : other;
  if (radius_of_stick(parts, thick) > parts->stick_radius) {
    thick->flags &= HSP_STICK_WHOLE;
    ++parts->single;
    return true;
  }
  if (thin) return false;
  if (!two) {
    double *const radius = &parts->radius[conflict->second];
    const double room = narrower * distance_to(molecule, parts, one, conflict->second);
    if (room < *radius && room > smallest * *radius && room > wider * least_radius(molecule, parts, conflict->second)) {
      *radius = room;
      ++parts->smaller;
      return true;
    }
  }
  hsp_stick *const longer = squared_length(molecule, other) > squared_length(molecule, one) ? other : one;
  const size_t behind = (size_t)(&parts->stick[parts->sticks] - longer) - 1;
  memmove(longer, longer + 1, behind * sizeof *longer);
  --parts->sticks;
  ++parts->left_out;
  return true;
}

/* With no more repairs than `most`; without any the conflict is a failure. */
static bool compute_sticks(const struct molecule *molecule, const struct drawing *drawing, struct parts *parts,
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
    if (repairs == most || !repair(molecule, &conflict, parts)) {
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
                       const struct geometry *geometry, const uint32_t *colour, bool with_orders, struct parts *parts,
                       struct failure *failure) {
  const double size = ball_and_stick_size(drawing);
  free(parts->stick);
  parts->stick = sticks_of(molecule, axis, geometry->bond, geometry->bonds, colour, with_orders);
  parts->sticks = geometry->bonds;
  if (parts->stick == NULL || parts->radius == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < molecule->atoms; ++i) parts->radius[i] = size * molecule->radius[i];
  return true;
}

/* Why, and what became of it: "the stick between balls 0 and 1 runs into ball 3; drawn with 1 ball smaller". */
static void tell_misfit(const struct parts *parts, const char *reason, struct geometry *geometry) {
  const struct {
    uint32_t count;
    const char *one, *many;
  } changes[] = {{parts->smaller, "ball smaller", "balls smaller"},
                 {parts->single, "multiple bond as a single one", "multiple bonds as single ones"},
                 {parts->left_out, "bond less", "bonds less"}};
  char *const out = geometry->misfit;
  const char *separator = "; drawn with ";
  size_t at = (size_t)snprintf(out, sizeof geometry->misfit, "%.130s", reason);
  for (size_t k = 0; k < sizeof changes / sizeof changes[0]; ++k) {
    if (changes[k].count == 0) continue;
    at += (size_t)snprintf(out + at, sizeof geometry->misfit - at, "%s%lu %s", separator,
                           (unsigned long)changes[k].count, changes[k].count == 1 ? changes[k].one : changes[k].many);
    separator = ", ";
  }
}

/* Multiple bonds are thicker. Where they do not fit they are drawn as single ones, which may. Where these do not
 * either, what is in the way of a few is changed. */
static bool compute_bonds(const struct molecule *molecule, const struct drawing *drawing, const uint32_t *colour,
                          double axis[3][3], struct parts *parts, struct geometry *geometry, struct failure *failure) {
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
      if (ways[k].repairs > 0) tell_misfit(parts, conflict.reason, geometry);
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
  struct parts parts = {.radius = calloc((size_t)molecule->atoms + 1, sizeof *parts.radius),
                        .stick_radius = ball_and_stick_radius(drawing)};
  const bool done = compute_bonds(molecule, drawing, colour, axis, &parts, geometry, failure);
  free(parts.radius);
  free(parts.stick);
  return done;
}
