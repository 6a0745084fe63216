/* "The order of the balls has no effect but on ids": two views compared record by record, in their order. An id may
 * name any of several equal balls. */
#include <string.h>

#include "same_ball.h"
#include "view_invariants.h"

const char *view_difference_after_permutation(const view_result *a, const view_result *b) {
  uint32_t i;
  if (memcmp(&a->needed, &b->needed, sizeof a->needed) != 0) return "needed limits depend on the order of the balls";
  if (memcmp(&a->info, &b->info, sizeof a->info) != 0) return "info depends on the order of the balls";
  for (i = 0; i < a->info.pieces; ++i) {
    hsp_view_piece p = a->pieces[i], q = b->pieces[i];
    if (!same_ball(a->base, p.ball, b->base, q.ball)) return "order of pieces depends on the order of the balls";
    p.ball = q.ball = 0;
    if (memcmp(&p, &q, sizeof p) != 0) return "pieces depend on the order of the balls";
  }
  if (memcmp(a->loops, b->loops, a->info.loops * sizeof *a->loops) != 0)
    return "loops depend on the order of the balls";
  for (i = 0; i < a->info.arcs; ++i) {
    hsp_view_arc p = a->arcs[i], q = b->arcs[i];
    if (!same_ball(a->base, p.other_ball, b->base, q.other_ball))
      return "an arc's `other_ball` depends on the order of the balls";
    p.other_ball = q.other_ball = 0;
    if (memcmp(&p, &q, sizeof p) != 0) return "arcs depend on the order of the balls";
  }
  return NULL;
}
