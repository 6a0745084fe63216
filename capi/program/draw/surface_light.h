/* The light on surfaces, as a radial gradient has it on the disc of a ball. */
#pragma once

#include <stdint.h>

/* The gradient's circles on the disc of radius 1, y up, have the centre (1 - s) focus and the radius s: from the focus,
 * s = 0, where it is lightest, to the rim, s = 1. */
enum { SURFACE_STOPS = 8 };
extern const double surface_light_focus[2];

/* On which of these circles a normal lies, of length 1 or less. So what is bent in another way than a sphere has the
 * light that a sphere has with this normal. */
double surface_light_circle(const double normal[2]);

/* Where the stops of the gradient are, and what becomes there of a colour. Between them it is linear. */
double surface_light_offset(int stop);
uint32_t surface_light_stop(uint32_t colour, int stop);
uint32_t surface_light_on(uint32_t colour, double circle);

/* The circle by which so large a share of the way from the brightest tone to the darkest is done; above a share of 1
 * one beyond all circles. Of equal steps of it no border is seen more than the others. */
double surface_light_border(double share);
