#include "boxed_balls.h"

#include <string.h>

#include "check.h"

void set_box(boxed_balls *in, double ax, double bx, double by, double cx, double cy, double cz) {
  const double vectors[9] = {ax, 0, 0, bx, by, 0, cx, cy, cz};
  memcpy(in->box, vectors, sizeof in->box);
}

void compute_pores(boxed_balls *in, double floor) {
  const ball_set *set = &in->balls;
  hsp_pores_options options;
  CHECK_EQUAL(hsp_pores_options_init(&options, sizeof options), HSP_OK);
  options.floor = floor;
  CHECK_EQUAL(hsp_workspace_periodic(&in->work, set->n, set->xyz, set->radius, in->box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores_periodic(&in->work, &options), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_counts(in->work.pores, &in->counts), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_percolation(in->work.pores, &in->wide), HSP_OK);
  CHECK_EQUAL(in->wide.reserved, 0);
}
