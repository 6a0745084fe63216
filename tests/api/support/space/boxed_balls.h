/* Balls in a periodic box and their pores, for tests that make one after the other. */
#pragma once

#include <hardsphere_workspace.h>

#include "ball_sets.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct boxed_balls {
  ball_set balls;
  double box[9]; /* its vectors */
  hsp_workspace work;
  hsp_pores_counts counts;
  hsp_pore_percolation wide;
} boxed_balls;

/* The vectors (ax, 0, 0), (bx, by, 0), (cx, cy, cz). */
void set_box(boxed_balls *in, double ax, double bx, double by, double cx, double cy, double cz);

/* Pores above a floor, in the workspace. */
void compute_pores(boxed_balls *in, double floor);

#ifdef __cplusplus
}
#endif
