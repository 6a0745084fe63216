/* The light on surfaces: that of the radial gradient on the disc of a ball. */
#pragma once

#include <stdint.h>

/* The gradient's circles on the disc of radius 1, y up, have the centre (1 - s) focus and the radius s. They go from
 * the focus, s = 0, where it is lightest, to the rim, s = 1. */
enum { SURFACE_STOPS = 8 };
extern const double surface_light_focus[2];

/* The circle on which a normal lies, which has length 1 or less. So a surface that is not a sphere has the light of a
 * sphere with the same normal. */
double surface_light_circle(const double normal[2]);

/* The circle of a stop of the gradient, and the tone that a colour has there. Between stops it is linear. */
double surface_light_offset(int stop);
uint32_t surface_light_stop(uint32_t colour, int stop);
uint32_t surface_light_on(uint32_t colour, double circle);

/* The circle with the tone at that share of the way from the brightest tone to the darkest; for a share above 1 a
 * circle beyond all others. With equal steps of the share no border between bands is more visible than the others. */
double surface_light_border(double share);
