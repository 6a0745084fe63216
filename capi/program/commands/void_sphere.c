#include "commands/void_sphere.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands/space_geometry.h"
#include "read/vectors.h"

const char void_columns[] =
    "  volume in @^3, area in @^2; x y z: its point that is farthest from all balls, and its clearance, in @";

/* The pores of the balls with a face on the void suffice. Only faces of these balls bound the void, and so it is a part
 * of their free space, too. The straight way from a point of the void to the nearest ball meets no other ball before:
 * it stays in the void and ends on a face of it. So the distance to these balls is that to all balls, and the centre of
 * the largest empty sphere is the widest maximum in the void. The sphere touches only these balls, or a ball inside one
 * of them at the point where that one touches the sphere: another ball with that point on its sphere would cut the
 * empty sphere, or all three touch each other there. */

/* An empty sphere is no larger than the void. The search begins with pores wider than a part of the void's size. If
 * there are none in the void, it goes on with narrower ones, down to a part at which all pores may as well be found. */
#define FLOOR 0.4
#define LEAST_FLOOR 0.01

/* All balls around a void, as a molecule of their own. */
static bool make_wall(uint32_t most, struct molecule *wall, struct failure *failure) {
  wall->xyz = calloc((size_t)most + 1, 3 * sizeof *wall->xyz);
  wall->radius = calloc((size_t)most + 1, sizeof *wall->radius);
  wall->line = calloc((size_t)most + 1, sizeof *wall->line);
  return (wall->xyz != NULL && wall->radius != NULL && wall->line != NULL) || failure_of_memory(failure);
}

static void free_wall(struct molecule *wall) {
  free(wall->xyz);
  free(wall->radius);
  free(wall->line);
}

static void take_wall(const struct molecule *molecule, const struct void_cell *of, struct molecule *wall) {
  wall->atoms = of->ball_count;
  for (size_t k = 0; k < of->ball_count; ++k) {
    const size_t ball = of->balls[k];
    memcpy(wall->xyz + 3 * k, molecule->xyz + 3 * ball, 3 * sizeof *wall->xyz);
    wall->radius[k] = molecule->radius[ball];
    wall->line[k] = molecule->line[ball];
  }
}

/* Whether the point lies in the void, by integers. */
static bool lies_in(const struct geometry *geometry, const double point[3], uint32_t region) {
  uint32_t found = HSP_NONE;
  return hsp_topology_locate(geometry->work.topology, point, &found) == HSP_OK && found == region;
}

static double clearance_at(const struct molecule *wall, double probe, const double point[3]) {
  double least = HUGE_VAL;
  for (size_t k = 0; k < wall->atoms; ++k) {
    least = fmin(least, distance_between(point, wall->xyz + 3 * k) - (wall->radius[k] + probe));
  }
  return least;
}

/* A width that the widest maximum of the void exceeds if its middle lies in it; else one that it may exceed. */
static double first_floor(const struct geometry *geometry, const struct molecule *wall, const struct void_cell *of,
                          double probe, double step) {
  const double ball = 0.2387324146; /* 3 / (4 pi) */
  if (!lies_in(geometry, of->middle, of->region)) return FLOOR * cbrt(ball * of->figures.volume);
  return fmax(0.0, clearance_at(wall, probe, of->middle) - 4.0 * step);
}

/* A centre that lies on the lattice but for roundings, as in symmetric cages, becomes that point of it. */
static void put_on_lattice(double step, double point[3]) {
  const double per_unit = round(1.0 / step);
  for (int axis = 0; axis < 3 && per_unit >= 1.0; ++axis) {
    const double steps = per_unit * point[axis], nearest = round(steps);
    if (fabs(steps - nearest) < 1e-6) point[axis] = (nearest + 0.0) / per_unit;
  }
}

/* The widest maxima come first. That of a void has no gate: no way leads from it to a wider one. Its level is rounded
 * to a part of a step; the distance in doubles has more digits. */
static bool take_widest(const struct geometry *geometry, const hsp_pores *pores, const struct molecule *wall,
                        double probe, double step, struct void_cell *of, struct failure *failure) {
  hsp_pores_counts counts;
  int32_t status = hsp_pores_get_counts(pores, &counts);
  for (uint32_t k = 0; status == HSP_OK && k < counts.maxima && !of->sphere.found; ++k) {
    hsp_pore_maximum maximum;
    status = hsp_pores_get_maxima(pores, k, 1, &maximum);
    if (status != HSP_OK || maximum.gate != HSP_NONE || !lies_in(geometry, maximum.xyz, of->region)) continue;
    put_on_lattice(step, maximum.xyz);
    of->sphere.found = true;
    of->sphere.clearance = clearance_at(wall, probe, maximum.xyz);
    memcpy(of->sphere.xyz, maximum.xyz, sizeof of->sphere.xyz);
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

/* There is no sphere if balls are too far apart for their radii, also on a coarser lattice. */
static bool find_sphere(const struct geometry *geometry, struct geometry *around, const struct molecule *wall,
                        double probe, double step, struct void_cell *of, struct failure *failure) {
  const struct failure none = *failure;
  double floor = first_floor(geometry, wall, of, probe, step);
  const double least = LEAST_FLOOR * floor;
  bool done = geometry_set_model(around, wall, probe, step, failure);
  while (done) {
    done = geometry_find_pores(around, wall, probe, floor, failure);
    if (!done) break;
    if (!take_widest(geometry, around->work.pores, wall, probe, step, of, failure)) return false;
    if (of->sphere.found || floor == 0.0) break;
    floor = floor > least ? FLOOR * floor : 0.0;
  }
  if (done || failure->exit_status != EXIT_BAD_INPUT || failure->of_memory) return done;
  *failure = none;
  return true;
}

bool void_spheres_find(const struct geometry *geometry, const struct molecule *molecule, double probe,
                       struct void_list *list, struct failure *failure) {
  struct geometry around = {.largest_rounding = 0.0};
  struct molecule wall = {.atoms = 0};
  hsp_model_info info;
  uint32_t most = 0;
  for (uint32_t i = 0; i < list->count; ++i) most = most > list->voids[i].ball_count ? most : list->voids[i].ball_count;
  const int32_t status = hsp_model_get_info(geometry->work.model, &info);
  bool done = (status == HSP_OK || failure_in_library(failure, status)) && make_wall(most, &wall, failure);
  /* Small voids first: their pores take little memory, and the larger the memory is, the longer it takes to clear
   * it. */
  for (uint32_t i = list->count; done && i-- > 0;) {
    take_wall(molecule, &list->voids[i], &wall);
    done = find_sphere(geometry, &around, &wall, probe, info.step, &list->voids[i], failure);
  }
  free_wall(&wall);
  geometry_free(&around);
  return done;
}
