/* From where a user looks at the balls: the options of draw, map and pick. */
#ifndef HARDSPHERE_TOOL_VIEWING_H
#define HARDSPHERE_TOOL_VIEWING_H

#include <stdbool.h>

#include "app/option_reader.h"
#include "hardsphere.h"
#include "read/failure.h"

struct molecule;

struct viewing {
  struct option_vector view;   /* towards the viewer; along the thinnest principal axis if it is not given */
  bool automatic;              /* the user says so */
  struct option_vector up;     /* upwards */
  struct option_vector rotate; /* degrees, by which the balls are turned from there */
  double spin;                 /* degrees, by which they are turned about the upright axis after that */
};

/* Take the argument if it is one of these options, and its value from the reader; *known tells whether it is one. */
bool viewing_take_option(struct viewing *viewing, struct option_reader *reader, const char *argument, bool *known);

/* Whether the angles can be turned by. */
bool viewing_check(const struct viewing *viewing, struct failure *failure);

/* Whether the user says anything. */
bool viewing_is_given(const struct viewing *viewing);

/* The same for the library, defaults included, for looking at a molecule. The status of the library. */
int32_t viewing_options(const struct viewing *viewing, const struct molecule *molecule, hsp_view_options *options);

/* Axes to the right, upwards and towards the viewer: unit vectors. The status of the library. */
int32_t viewing_axes(const struct viewing *viewing, const struct molecule *molecule, double axis[3][3]);

#endif
