#include "draw/surface_light.h"

#include <math.h>

#include "draw/colour_mixed.h"

/* As in pictures of style soft. */
const double surface_light_focus[2] = {-0.34, 0.4};

/* Less light and dark than on single balls, without a highlight: a surface is one body. Above 1 it is a share of white,
 * below the shade is a little blue. */
static const double offset[SURFACE_STOPS] = {0.0, 0.2, 0.4, 0.55, 0.7, 0.82, 0.92, 1.0};
static const double bright[SURFACE_STOPS] = {1.08, 1.055, 1.015, 0.975, 0.915, 0.84, 0.745, 0.62};
static const uint32_t shade = 0x0A0A18;

/* |n - (1 - s) f| = s. */
double surface_light_circle(const double normal[2]) {
  const double *const f = surface_light_focus;
  const double from[2] = {normal[0] - f[0], normal[1] - f[1]};
  const double a = 1.0 - (f[0] * f[0] + f[1] * f[1]);
  const double b = f[0] * from[0] + f[1] * from[1];
  const double c = from[0] * from[0] + from[1] * from[1];
  const double circle = (b + sqrt(b * b + a * c)) / a;
  return circle < 1.0 ? circle : 1.0;
}

double surface_light_offset(int stop) {
  return offset[stop];
}

uint32_t surface_light_stop(uint32_t colour, int stop) {
  return bright[stop] <= 1.0 ? colour_mixed(shade, colour, bright[stop])
                             : colour_mixed(colour, 0xFFFFFF, 4.0 * (bright[stop] - 1.0));
}

uint32_t surface_light_on(uint32_t colour, double circle) {
  int stop = 1;
  while (stop + 1 < SURFACE_STOPS && circle > offset[stop]) ++stop;
  const double part = (circle - offset[stop - 1]) / (offset[stop] - offset[stop - 1]);
  return colour_mixed(surface_light_stop(colour, stop - 1), surface_light_stop(colour, stop),
                      part < 0.0   ? 0.0
                      : part > 1.0 ? 1.0
                                   : part);
}

/* How dark it is by a stop; of light tones a step is seen twice as well. */
static double darkness(int stop) {
  return bright[stop] < 1.0 ? 1.0 - bright[stop] : 2.0 * (1.0 - bright[stop]);
}

double surface_light_border(double share) {
  const double lightest = darkness(0), wanted = lightest + share * (darkness(SURFACE_STOPS - 1) - lightest);
  int stop = 1;
  if (share > 1.0) return 2.0;
  while (stop + 1 < SURFACE_STOPS && wanted > darkness(stop)) ++stop;
  const double part = (wanted - darkness(stop - 1)) / (darkness(stop) - darkness(stop - 1));
  return offset[stop - 1] + part * (offset[stop] - offset[stop - 1]);
}
