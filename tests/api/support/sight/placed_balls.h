/* The balls of a set in view coordinates, computed from the caller's numbers and the frame of a view or map, and which
 * of the balls is seen at a point, by looking at all of them. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct placed_balls {
  const computed *c;     /* must outlive it */
  double (*position)[3]; /* [n] centres: right, up and towards the viewer */
  double margin;         /* a point nearer than this to a silhouette or another front is undecided */
} placed_balls;

/* The frame is that of a view or map: its origin and unit vectors. To be followed by placed_balls_release. */
void placed_balls_make(const computed *c, const double origin[3], const double right[3], const double up[3],
                       const double towards[3], placed_balls *placed);

void placed_balls_release(placed_balls *placed);

/* The ball that is seen at the point p of the view plane, HSP_NONE if there is none, UNSURE_BALL if it is undecided. */
#define UNSURE_BALL (HSP_NONE - 1)
uint32_t seen_ball(const placed_balls *placed, const double p[2]);

/* The height of ball i's front over p; the height of its centre if p is beside the ball's disc. */
double front_height(const placed_balls *placed, uint32_t i, const double p[2]);

#ifdef __cplusplus
}
#endif
