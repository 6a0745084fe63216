/* Repair of balls and sticks that intersect in a way that cannot be drawn, so that a few of them do not prevent a
 * picture. */
#pragma once

#include "hardsphere.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Balls and sticks, and how many of them were changed. */
struct stick_parts {
  double *radius; /* of each ball */
  hsp_stick *stick;
  uint32_t sticks;
  double stick_radius; /* of single sticks, not of strands */
  uint32_t smaller;    /* balls that were made smaller */
  uint32_t single;     /* bonds of several strands that became single sticks */
  uint32_t left_out;   /* sticks that were left out */
};

/* Change one thing in a conflict. A bond of several strands becomes a thinner single stick; a ball into which a stick
 * runs becomes smaller, unless it would be too small for its own sticks or less than a third of its size; else a stick
 * is left out, of two the longer one. False: none of these helps. */
bool stick_repair(const struct molecule *molecule, const hsp_sticks_conflict *conflict, struct stick_parts *parts);

/* Tell the conflict and its repair: "the stick between balls 0 and 1 runs into ball 3; drawn with 1 ball smaller". */
void stick_repair_tell(const struct stick_parts *parts, const char *reason, char out[MISFIT_BYTES]);
