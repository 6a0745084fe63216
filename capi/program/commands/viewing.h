/* The direction from which a user looks at the balls: the options of draw, map and pick. */
#pragma once

#include <stdbool.h>

/* Three numbers that a user may give; `given` tells whether there are any. */
struct given_vector {
  bool given;
  double xyz[3];
};

struct viewing {
  struct given_vector view;   /* towards the viewer; along the thinnest principal axis if it is not given */
  bool automatic;             /* the user asks for the automatic view */
  bool of_highlight;          /* the view in which most of the highlighted atoms is seen: highlight_view.h */
  struct given_vector up;     /* upwards */
  struct given_vector rotate; /* angles in degrees by which the balls are turned from there */
  double spin;                /* degrees by which they are turned about the upright axis after that */
};

/* Whether the user gives any of these options. */
bool viewing_is_given(const struct viewing *viewing);
