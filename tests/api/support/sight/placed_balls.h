/* The balls of a set in view coordinates, from the caller's own numbers, and which of them is seen at a point. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct placed_balls {
  const computed *c;     /* must outlive it */
  double (*position)[3]; /* [n] of the centres, right, up and towards the viewer */
  double margin;         /* what is nearer than this to a sphere is left undecided */
} placed_balls;

/* The frame is that of a view or map: its origin and unit vectors. To be followed by placed_balls_release. */
void placed_balls_make(const computed *c, const double origin[3], const double right[3], const double up[3],
                       const double towards[3], placed_balls *placed);

void placed_balls_release(placed_balls *placed);

/* The ball that is seen over p, HSP_NONE if none is, UNSURE_BALL if that is not for sure. */
#define UNSURE_BALL (HSP_NONE - 1)
uint32_t seen_ball(const placed_balls *placed, const double p[2]);

/* The height of ball i's front over p, of its centre beside its disc. */
double front_height(const placed_balls *placed, uint32_t i, const double p[2]);

#ifdef __cplusplus
}
#endif
