#include "draw/stick_repair.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "read/bonds.h"
#include "read/vectors.h"

static double radius_of_stick(const struct stick_parts *parts, const hsp_stick *stick) {
  const uint32_t thick = HSP_STICK_DOUBLE | HSP_STICK_TRIPLE | HSP_STICK_AROMATIC;
  return (stick->flags & thick) != 0 ? 1.5 * parts->stick_radius : parts->stick_radius;
}

static void way(const struct molecule *molecule, uint32_t from, uint32_t to, double out[3]) {
  for (size_t k = 0; k < 3; ++k) out[k] = molecule->xyz[3 * (size_t)to + k] - molecule->xyz[3 * (size_t)from + k];
}

/* How far a point is from a stick, a cylinder with flat ends. */
static double distance_to(const struct molecule *molecule, const struct stick_parts *parts, const hsp_stick *stick,
                          uint32_t ball) {
  double axis[3], to[3];
  way(molecule, stick->ball[0], stick->ball[1], axis);
  way(molecule, stick->ball[0], ball, to);
  const double length = vector_length(axis), along = length > 0.0 ? dot(axis, to) / length : 0.0;
  const double across = sqrt(fmax(0.0, dot(to, to) - along * along)) - radius_of_stick(parts, stick);
  const double beside = fmax(0.0, across), behind = fmax(0.0, fmax(-along, along - length));
  return sqrt(beside * beside + behind * behind); /* hypot is of glibc 2.35 and rounds as each library likes */
}

/* The least radius of a ball with which its own sticks do not meet outside of it: sticks.h. */
static double least_radius(const struct molecule *molecule, const struct stick_parts *parts, uint32_t ball) {
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
  return atoms_squared_distance(molecule, stick->ball[0], stick->ball[1]);
}

bool stick_repair(const struct molecule *molecule, const hsp_sticks_conflict *conflict, struct stick_parts *parts) {
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

void stick_repair_tell(const struct stick_parts *parts, const char *reason, char out[MISFIT_BYTES]) {
  const struct {
    uint32_t count;
    const char *one, *many;
  } changes[] = {{parts->smaller, "ball smaller", "balls smaller"},
                 {parts->single, "multiple bond as a single one", "multiple bonds as single ones"},
                 {parts->left_out, "bond less", "bonds less"}};
  const char *separator = "; drawn with ";
  size_t at = (size_t)snprintf(out, MISFIT_BYTES, "%.130s", reason);
  for (size_t k = 0; k < sizeof changes / sizeof changes[0]; ++k) {
    if (changes[k].count == 0) continue;
    at += (size_t)snprintf(out + at, MISFIT_BYTES - at, "%s%lu %s", separator, (unsigned long)changes[k].count,
                           changes[k].count == 1 ? changes[k].one : changes[k].many);
    separator = ", ";
  }
}
