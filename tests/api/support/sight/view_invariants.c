#include "view_invariants.h"

double view_rounding(const view_result *v, double radius) {
  return 1e-10 * radius + 1e-13 * v->base->extent + 4 * v->base->rounding;
}

const char *broken_view(const view_result *v) {
  const char *broken = broken_view_records(v);
  return broken == NULL ? broken_view_arcs(v) : broken;
}
