/* Where a void has most room: its point that is farthest from all balls, the centre of its largest empty sphere. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/geometry.h"

/* The balls with a face on a void, as they are in the model, and a box that the void lies in. */
struct void_wall {
  uint32_t region;
  const uint32_t *balls;
  uint32_t ball_count;
  const double *xyz;    /* [3] of every ball of the molecule */
  const double *radius; /* likewise */
  double probe;         /* that the model adds to them */
  double low[3], high[3];
};

/* A point of the void and its clearance, the distance to the nearest ball. Up to rounding no point of the void has more
 * than `bound`, which is the clearance itself; a little more, by at most a millionth, where nine balls or more are
 * nearly as near; and any bound above it where ROOM_MOST_COMPARED comparisons
 * of a ball with a box did not suffice. */
struct void_room {
  bool found; /* false: the void is narrower than the lattice of the model can show */
  double xyz[3];
  double clearance;
  double bound;
};

enum { ROOM_MOST_COMPARED = 1 << 26 };

/* Find it, for a computed topology. False: memory is short, or the library refuses. */
bool void_room_find(const struct geometry *geometry, const struct void_wall *wall, struct void_room *room,
                    struct failure *failure);
