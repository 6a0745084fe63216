/* The voids of a molecule: the bounded regions of the complement, with the balls around them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* The largest empty sphere. */
struct void_sphere {
  bool found; /* false: the void is narrower than the lattice of the model can show */
  double xyz[3];
  double clearance; /* its radius: the distance to the nearest ball; no point of the void has a larger one */
};

struct void_cell {
  uint32_t region; /* its number in the library, from 1 on */
  hsp_region figures;
  const uint32_t *balls; /* balls with a face on it, ascending; in void_list.balls */
  uint32_t ball_count;
  double middle[3]; /* the mean of the centres of these balls; it may lie in a ball */
  struct void_sphere sphere;
};

struct void_list {
  struct void_cell *voids; /* largest volume first */
  uint32_t count;
  uint32_t smaller; /* voids that were too small to be listed */
  uint32_t *balls;
};

#define VOID_LIST_NONE \
  { NULL, 0, 0, NULL }

/* List the voids of a computed topology whose volume is at least min_volume. probe: the length that the model has added
 * to the molecule's radii. Free the list on true and on false. */
bool void_list_make(const struct geometry *geometry, const struct molecule *molecule, double probe, double min_volume,
                    struct void_list *list, struct failure *failure);

/* Find the centre of the largest empty sphere in the void of that rank, counted from 1, of a molecule grown by the
 * probe. The geometry's model is set; all else that was computed of it is lost. option: the option that asks for it.
 * False: there is no such void, or no room in it. */
bool void_list_point(struct geometry *geometry, const struct molecule *molecule, double probe, uint64_t rank,
                     const char *option, double point[3], struct failure *failure);

void void_list_free(struct void_list *list);
