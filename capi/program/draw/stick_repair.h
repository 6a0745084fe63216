/* Balls and sticks that are in each other's way, where a picture is not to be refused for a few of them. */
#pragma once

#include "hardsphere.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Balls and sticks that are to fit each other. */
struct stick_parts {
  double *radius; /* of each ball */
  hsp_stick *stick;
  uint32_t sticks;
  double stick_radius; /* of all that are no bonds of several strands */
  uint32_t smaller;    /* balls that were made smaller */
  uint32_t single;     /* sticks of which that is so */
  uint32_t left_out;   /* sticks */
};

/* Change one thing of a conflict: a bond of several strands becomes a thinner, single one; a ball that a stick runs
 * into becomes smaller, unless it would be small for its own sticks or less than a third of what it was; else a stick
 * is left out, of two the longer one. False: that does not help. */
bool stick_repair(const struct molecule *molecule, const hsp_sticks_conflict *conflict, struct stick_parts *parts);

/* Why, and what became of it: "the stick between balls 0 and 1 runs into ball 3; drawn with 1 ball smaller". */
void stick_repair_tell(const struct stick_parts *parts, const char *reason, char out[MISFIT_BYTES]);
