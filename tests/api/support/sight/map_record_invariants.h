/* The header's promises for the records of a map, of balls alone or of balls and halves of sticks. */
#pragma once

#include <hardsphere.h>

typedef struct map_records {
  const hsp_map_info *info;
  const hsp_map_vertex *vertices;
  const hsp_map_edge *edges;
  const hsp_map_face *faces;
  const double *area; /* of each body: balls first, then halves of sticks */
  uint32_t balls;     /* number of balls */
  uint32_t sticks;    /* number of sticks, with two halves each */
  double largest;     /* radius */
  double extent;      /* of the coordinates */
} map_records;

/* NULL, or a sentence about the first promise that does not hold. Later ones rely on what the earlier ones have found
 * sound. */
const char *broken_map_records(const map_records *m);
