/* Whether two sets name the same ball, for comparisons of results in another order. */
#pragma once

#include "computed.h"

/* Whether the balls are equal: an id may name any of several equal balls. */
static inline int same_ball(const computed *a, uint32_t i, const computed *b, uint32_t j) {
  if (i == HSP_NONE || j == HSP_NONE) return i == j;
  if (i >= a->n || j >= b->n) return 0;
  return a->radius[i] == b->radius[j] && a->xyz[3 * i] == b->xyz[3 * j] && a->xyz[3 * i + 1] == b->xyz[3 * j + 1] &&
         a->xyz[3 * i + 2] == b->xyz[3 * j + 2];
}
