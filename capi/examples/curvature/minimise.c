/* An energy minimiser with the morphometric energy of solvation: atoms on springs to where they start give way to what
 * volume, area and curvatures of their union cost.
 *   minimise FILE.xyzr [STEPS [PRESSURE TENSION BENDING GAUSSIAN]]      x y z r on each line
 * Prints balls as it reads them, where they end, with the energies of all accepted steps in comments above. Each trial
 * is one boundary and one call for energy and gradient. Where an arc is born the slope of the mean curvature is
 * unbounded: so the step is not the gradient's alone, but grows while the energy falls and is halved if not. */
#include <hardsphere_workspace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../read_balls.h"

static const double stiffness = 5.0, probe = 1.4;

struct search {
  struct balls balls;
  hsp_morphometry_request factors;
  double *start, *place, *gradient; /* [count][3] */
  hsp_morphometric_energy surface;  /* of the last place that was evaluated */
  hsp_workspace work;
};

/* The energy and its gradient with the atoms at `place`. */
static int32_t evaluate(struct search *search, double *energy) {
  const uint32_t n = search->balls.count;
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK) {
    status = hsp_workspace_set(&search->work, n, search->place, search->balls.radius, &options, NULL);
  }
  if (status == HSP_OK) status = hsp_workspace_boundary(&search->work);
  if (status == HSP_OK) {
    hsp_morphometry_outputs outputs = {
        .struct_size = sizeof outputs, .capacity = n, .energy = &search->surface, .d_centre = search->gradient};
    status = hsp_boundary_get_morphometry(search->work.boundary, &search->factors, &outputs);
  }
  if (status != HSP_OK) return status;
  *energy = search->surface.value;
  for (size_t k = 0; k < 3 * (size_t)n; ++k) {
    const double stretch = search->place[k] - search->start[k];
    *energy += stiffness / 2 * stretch * stretch;
    search->gradient[k] += stiffness * stretch;
  }
  return HSP_OK;
}

static void print_step(const struct search *search, unsigned step, double energy, double slope) {
  printf("# %5u %18.10f %14.6f %16.8f %16.8f %16.8f\n", step, energy, slope, search->surface.volume,
         search->surface.area, search->surface.mean);
}

static double length_of(const double *v, size_t count) {
  double sum = 0.0;
  for (size_t k = 0; k < count; ++k) sum += v[k] * v[k];
  return sqrt(sum);
}

/* Down the gradient; search->balls.xyz is the best place so far, `down` [count][3] its gradient. */
static int32_t descend(struct search *search, unsigned steps, double *down) {
  const size_t count = 3 * (size_t)search->balls.count;
  double best = 0.0, reach = 0.01;
  int32_t status = evaluate(search, &best);
  if (status != HSP_OK) return status;
  memcpy(down, search->gradient, count * sizeof *down);
  printf("#  step             energy          slope           volume             area   mean curvature\n");
  print_step(search, 0, best, length_of(down, count));
  for (unsigned step = 1; step <= steps && reach > 1e-9; ++step) {
    double energy = 0.0;
    for (size_t k = 0; k < count; ++k) search->place[k] = search->balls.xyz[k] - reach * down[k];
    status = evaluate(search, &energy);
    if (status != HSP_OK) return status;
    if (!(energy < best)) {
      reach /= 2;
      continue;
    }
    best = energy;
    reach *= 1.3;
    memcpy(search->balls.xyz, search->place, count * sizeof *down);
    memcpy(down, search->gradient, count * sizeof *down);
    print_step(search, step, best, length_of(down, count));
  }
  return HSP_OK;
}

int main(int count, char **arguments) {
  struct search search;
  memset(&search, 0, sizeof search);
  if (count != 2 && count != 3 && count != 7) {
    fprintf(stderr, "usage: minimise FILE.xyzr [STEPS [PRESSURE TENSION BENDING GAUSSIAN]]\n");
    return 2;
  }
  search.factors.struct_size = sizeof search.factors;
  search.factors.pressure = count == 7 ? strtod(arguments[3], NULL) : 0.02;
  search.factors.tension = count == 7 ? strtod(arguments[4], NULL) : 0.05;
  search.factors.bending = count == 7 ? strtod(arguments[5], NULL) : -0.1;
  search.factors.gaussian = count == 7 ? strtod(arguments[6], NULL) : 0.0;
  int done = read_balls(arguments[1], &search.balls);
  const size_t coordinates = 3 * (size_t)search.balls.count;
  double *memory = calloc(4 * coordinates + 1, sizeof *memory);
  done = done && memory != NULL;
  if (done && coordinates > 0) {
    search.start = memcpy(memory, search.balls.xyz, coordinates * sizeof *memory);
    search.place = memcpy(memory + coordinates, search.balls.xyz, coordinates * sizeof *memory);
    search.gradient = memory + 2 * coordinates;
    const unsigned steps = count > 2 ? (unsigned)strtoul(arguments[2], NULL, 10) : 100;
    const int32_t status = descend(&search, steps, memory + 3 * coordinates);
    if (status != HSP_OK) fprintf(stderr, "minimise: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  for (uint32_t i = 0; done && i < search.balls.count; ++i) {
    const double *c = search.balls.xyz + 3 * (size_t)i;
    printf("%.9f %.9f %.9f %.9f\n", c[0], c[1], c[2], search.balls.radius[i]);
  }
  hsp_workspace_free(&search.work);
  free_balls(&search.balls);
  free(memory);
  return done ? 0 : 1;
}
