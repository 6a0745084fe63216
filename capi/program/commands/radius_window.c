#include "commands/radius_window.h"

#include <math.h>
#include <stdlib.h>

static double grown(const struct radius_window *window, const struct molecule *molecule, uint32_t ball, double by) {
  const double sigma = window->sigma == NULL ? 1.0 : window->sigma[ball];
  return fmax(0.0, molecule->radius[ball] + window->probe + by * sigma);
}

bool radius_window_for_each_side(const struct radius_window *window, const struct molecule *molecule,
                                 struct geometry *whole, take_side *take, void *of, struct failure *failure) {
  const double widths[2] = {window->width, -window->width};
  struct geometry side = {.work = {0}, .executor = whole->executor};
  struct molecule balls = *molecule;
  balls.radius = malloc(((size_t)molecule->atoms + 1) * sizeof *balls.radius);
  if (balls.radius == NULL) return failure_of_memory(failure);
  side.executor.context = &side.executor;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    for (int k = 0; k < 2; ++k) side.largest_radius = fmax(side.largest_radius, grown(window, molecule, i, widths[k]));
  }
  bool done = true;
  for (int k = 0; k < 2 && done; ++k) {
    for (uint32_t i = 0; i < molecule->atoms; ++i) balls.radius[i] = grown(window, molecule, i, widths[k]);
    done = geometry_set_model(&side, &balls, 0.0, 0.0, failure) && geometry_compute_boundary(&side, failure) &&
           take(of, &side, 0.5 / widths[k], failure);
  }
  whole->largest_rounding = fmax(whole->largest_rounding, side.largest_rounding);
  free(balls.radius);
  geometry_free(&side);
  return done;
}
