/* The voids of a molecule: the bounded regions of the complement, with the balls around them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "commands/void_room.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

struct void_cell {
  uint32_t region; /* its number in the library, from 1 on */
  hsp_region figures;
  const uint32_t *balls; /* those with a face on it, ascending; in void_list.balls */
  uint32_t ball_count;
  double middle[3]; /* mean of the centres of these balls; it may lie in one */
  double low[3];    /* of a box that the void lies in */
  double high[3];
  struct void_room room;
};

struct void_list {
  struct void_cell *voids; /* largest volume first */
  uint32_t count;
  uint32_t smaller; /* voids that were left out because of their volume */
  uint32_t *balls;
};

#define VOID_LIST_NONE \
  { NULL, 0, 0, NULL }

/* List the voids of a computed topology that are no smaller than min_volume. probe: what the model has added to the
 * molecule's radii. Free the list on true and on false. */
bool void_list_make(const struct geometry *geometry, const struct molecule *molecule, double probe, double min_volume,
                    struct void_list *list, struct failure *failure);

/* The point with most room in the void of that rank, counted from 1, of a molecule grown by the probe: its model, which
 * is set, has all else that it knew forgotten. option: what asks for it. False: there is no such void, or no room. */
bool void_list_point(struct geometry *geometry, const struct molecule *molecule, double probe, uint64_t rank,
                     const char *option, double point[3], struct failure *failure);

void void_list_free(struct void_list *list);
