/* Every output array of the view's functions, for every set of topology_sets.h and every kind of pieces, at capacities
 * 0, 1, needed-1, needed and needed+1: HSP_E_CAPACITY with the number needed and nothing written, or success with
 * exactly that many records. Guard bytes lie around every array. */
#include <hardsphere.h>

#include "check.h"
#include "output_sweep.h"
#include "topology_sets.h"
#include "view_result.h"

static int32_t ask_pieces(const void *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_pieces(view, out, capacity, needed);
}
static int32_t ask_loops(const void *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_loops(view, out, capacity, needed);
}
static int32_t ask_arcs(const void *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_arcs(view, out, capacity, needed);
}

static void sweep_outputs(const computed *c, uint32_t pieces, uint32_t flags, int with_boundary) {
  hsp_view_options options;
  view_result all;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.pieces = pieces;
  options.flags = flags;
  options.towards[0] = 3;
  options.towards[1] = c->n % 3;
  options.towards[2] = 1;
  if (CHECK_EQUAL(view_result_make(c, &options, with_boundary, &all), HSP_OK)) {
    sweep_output(ask_pieces, all.view, sizeof(hsp_view_piece), all.info.pieces);
    sweep_output(ask_loops, all.view, sizeof(hsp_view_loop), all.info.loops);
    sweep_output(ask_arcs, all.view, sizeof(hsp_view_arc), all.info.arcs);
  }
  view_result_release(&all);
}

int main(void) {
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    static ball_set set;
    computed c;
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      sweep_outputs(&c, HSP_PIECES_OUTSIDE_FARTHER, 0, 0);
      sweep_outputs(&c, HSP_PIECES_OUTSIDE_FARTHER, HSP_VIEW_ALL_BALLS, which % 2 == 0);
      sweep_outputs(&c, HSP_PIECES_OUTSIDE_ALL, which % 2 == 0 ? 0 : HSP_VIEW_ALL_BALLS, 1);
    }
    computed_release(&c);
  }
  return check_report();
}
