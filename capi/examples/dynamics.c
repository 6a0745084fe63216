/* Molecular dynamics with a surface energy: atoms on springs to where they start, every other one pays for its area.
 *   dynamics FILE.xyzr [FRAMES]       x y z r on each line
 * Velocity Verlet with unit masses. The surface's forces come from one call a frame, so the total energy stays. */
#include <hardsphere_workspace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read_balls.h"

struct system {
  struct balls balls;
  double *start, *velocity, *force; /* [count][3] */
  double *sigma;                    /* [count]: what a unit of each atom's area costs, in units of the tension */
  hsp_workspace work;
};

static const double stiffness = 5.0, tension = 0.05, pressure = 0.01, probe = 1.4, time_step = 0.02;

/* Forces, and the potential energy. */
static int32_t evaluate(struct system *system, double *potential) {
  const struct balls *balls = &system->balls;
  const size_t coordinates = 3 * (size_t)balls->count;
  hsp_energy surface;
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK) {
    status = hsp_workspace_set(&system->work, balls->count, balls->xyz, balls->radius, &options, NULL);
  }
  if (status == HSP_OK) status = hsp_workspace_boundary(&system->work);
  if (status == HSP_OK) {
    const hsp_gradient_request request = {
        .struct_size = sizeof request, .tension = tension, .pressure = pressure, .sigma = system->sigma};
    hsp_gradient_outputs outputs = {
        .struct_size = sizeof outputs, .capacity = balls->count, .energy = &surface, .d_centre = system->force};
    status = hsp_boundary_get_gradient(system->work.boundary, &request, &outputs);
  }
  if (status != HSP_OK) return status;
  *potential = surface.value;
  for (size_t i = 0; i < coordinates; ++i) {
    const double stretch = balls->xyz[i] - system->start[i];
    *potential += stiffness / 2 * stretch * stretch;
    system->force[i] = -system->force[i] - stiffness * stretch;
  }
  return HSP_OK;
}

static double kinetic(const struct system *system) {
  double sum = 0.0;
  for (size_t i = 0; i < 3 * (size_t)system->balls.count; ++i) sum += system->velocity[i] * system->velocity[i] / 2;
  return sum;
}

static void kick(struct system *system) {
  for (size_t i = 0; i < 3 * (size_t)system->balls.count; ++i) {
    system->velocity[i] += time_step / 2 * system->force[i];
  }
}

static int32_t run(struct system *system, unsigned frames) {
  double potential = 0.0;
  int32_t status = evaluate(system, &potential);
  const double first = potential;
  double worst = 0.0, most_kinetic = 0.0;
  for (unsigned frame = 1; frame <= frames && status == HSP_OK; ++frame) {
    kick(system);
    for (size_t i = 0; i < 3 * (size_t)system->balls.count; ++i) {
      system->balls.xyz[i] += time_step * system->velocity[i];
    }
    status = evaluate(system, &potential);
    kick(system);
    const double total = potential + kinetic(system);
    worst = fmax(worst, fabs(total - first));
    most_kinetic = fmax(most_kinetic, kinetic(system));
    if (frame % 20 == 0) printf("%6u %16.8f %16.8f %16.8f\n", frame, potential, kinetic(system), total);
  }
  if (status == HSP_OK) printf("# largest kinetic energy %.8f, total energy kept within %.3e\n", most_kinetic, worst);
  return status;
}

int main(int count, char **arguments) {
  struct system system;
  memset(&system, 0, sizeof system);
  if (count < 2 || count > 3) {
    fprintf(stderr, "usage: dynamics FILE.xyzr [FRAMES]\n");
    return 2;
  }
  int done = read_balls(arguments[1], &system.balls);
  const size_t n = system.balls.count;
  double *memory = calloc(10 * n + 1, sizeof *memory);
  done = done && memory != NULL;
  if (done) {
    system.start = memory;
    if (n > 0) memcpy(system.start, system.balls.xyz, 3 * n * sizeof *memory);
    system.velocity = memory + 3 * n;
    system.force = memory + 6 * n;
    system.sigma = memory + 9 * n;
    for (size_t i = 0; i < n; i += 2) system.sigma[i] = 1.0;
    printf("#frame        potential          kinetic            total\n");
    const int32_t status = run(&system, count == 3 ? (unsigned)strtoul(arguments[2], NULL, 10) : 200);
    if (status != HSP_OK) fprintf(stderr, "dynamics: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  hsp_workspace_free(&system.work);
  free_balls(&system.balls);
  free(memory);
  return done ? 0 : 1;
}
