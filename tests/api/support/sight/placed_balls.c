#include "placed_balls.h"

#include <math.h>
#include <stdlib.h>

#include "vectors.h"

void placed_balls_make(const computed *c, const double origin[3], const double right[3], const double up[3],
                       const double towards[3], placed_balls *placed) {
  double largest = 0, extent = 0;
  uint32_t i;
  placed->c = c;
  placed->position = test_zeros(c->n, sizeof *placed->position);
  for (i = 0; i < c->n; ++i) {
    double from_origin[3];
    difference(&c->xyz[3 * i], origin, from_origin);
    placed->position[i][0] = dot(from_origin, right);
    placed->position[i][1] = dot(from_origin, up);
    placed->position[i][2] = dot(from_origin, towards);
    largest = fmax(largest, c->radius[i]);
    extent = fmax(extent, length(from_origin));
  }
  placed->margin = 1e-7 * largest + 1e-12 * extent + 8 * c->rounding;
}

void placed_balls_release(placed_balls *placed) {
  free(placed->position);
}

/* The square of half the chord along the line of sight through p, negative beside the disc. */
static double half_chord(const placed_balls *placed, uint32_t i, const double p[2]) {
  const double x = p[0] - placed->position[i][0], y = p[1] - placed->position[i][1];
  return placed->c->radius[i] * placed->c->radius[i] - x * x - y * y;
}

double front_height(const placed_balls *placed, uint32_t i, const double p[2]) {
  return placed->position[i][2] + sqrt(fmax(0, half_chord(placed, i, p)));
}

uint32_t seen_ball(const placed_balls *placed, const double p[2]) {
  const computed *c = placed->c;
  double best = -INFINITY, second = -INFINITY;
  uint32_t i, found = HSP_NONE;
  for (i = 0; i < c->n; ++i) {
    const double x = p[0] - placed->position[i][0], y = p[1] - placed->position[i][1];
    double height;
    if (fabs(sqrt(x * x + y * y) - c->radius[i]) <= placed->margin) return UNSURE_BALL;
    if (half_chord(placed, i, p) < 0) continue;
    height = front_height(placed, i, p);
    if (height > best) {
      second = best;
      best = height;
      found = i;
    } else if (height > second) {
      second = height;
    }
  }
  return found != HSP_NONE && best - second <= placed->margin ? UNSURE_BALL : found;
}
