/* The voids of a molecule: the bounded cells of the complement, with the balls around them. */
#ifndef HARDSPHERE_TOOL_VOID_LIST_H
#define HARDSPHERE_TOOL_VOID_LIST_H

#include <stdbool.h>
#include <stdint.h>

#include "failure.h"
#include "geometry.h"

struct void_cell {
  uint32_t cell; /* its number in the library, from 1 on */
  hsp_cell figures;
  const uint32_t *balls; /* those with a face on it, ascending; in void_list.balls */
  uint32_t ball_count;
  double middle[3]; /* mean of the centres of these balls */
};

struct void_list {
  struct void_cell *voids; /* largest volume first */
  uint32_t count;
  uint32_t smaller; /* voids that were left out because of their volume */
  uint32_t *balls;
};

#define VOID_LIST_NONE \
  { NULL, 0, 0, NULL }

/* List the voids of a computed topology that are no smaller than min_volume; xyz [balls][3] are the balls' centres.
 * Free the list on true and on false. */
bool void_list_make(const struct geometry *geometry, const double *xyz, double min_volume, struct void_list *list,
                    struct failure *failure);

void void_list_free(struct void_list *list);

#endif
