/* Cavities of a molecule, and whether something inside can get out.
 *   cavities                               six balls that close a cage, and a seventh inside
 *   cavities FILE.xyzr [PROBE [X Y Z]]     x y z r on each line; where the point lies, and whether it is shut in
 */
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <stdlib.h>

#include "read_balls.h"

static int take_cage(struct balls *balls) {
  static const double cage[7][4] = {{1, 0, 0, 0.9}, {-1, 0, 0, 0.9}, {0, 1, 0, 0.9},    {0, -1, 0, 0.9},
                                    {0, 0, 1, 0.9}, {0, 0, -1, 0.9}, {0.05, 0, 0, 0.02}};
  for (int i = 0; i < 7; ++i) {
    if (!add_ball(balls, cage[i])) return 0;
  }
  return 1;
}

static int32_t compute(hsp_workspace *work, const struct balls *balls, double probe) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK) status = hsp_workspace_set(work, balls->count, balls->xyz, balls->radius, &options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(work);
  if (status == HSP_OK) status = hsp_workspace_topology(work);
  return status;
}

static int32_t print_wall(const hsp_workspace *work, uint32_t region, uint32_t *balls, uint32_t ball_count) {
  const int32_t status = hsp_topology_get_region_balls(work->topology, region, balls, ball_count, &ball_count);
  for (uint32_t i = 0; status == HSP_OK && i < ball_count; ++i) printf(" %u", (unsigned)balls[i]);
  printf("\n");
  return status;
}

static int32_t print_cavities(const hsp_workspace *work, uint32_t ball_count) {
  uint32_t count = 0;
  hsp_topology_get_regions(work->topology, NULL, 0, &count);
  hsp_region *regions = malloc(((size_t)count + 1) * sizeof *regions);
  uint32_t *balls = malloc(((size_t)ball_count + 1) * sizeof *balls);
  int32_t status = regions == NULL || balls == NULL ? HSP_E_MEMORY : HSP_OK;
  if (status == HSP_OK) status = hsp_topology_get_regions(work->topology, regions, count, &count);
  if (status == HSP_OK) printf("cavities: %u\n", (unsigned)count - 1);
  for (uint32_t region = 1; status == HSP_OK && region < count; ++region) { /* region 0 is the outside */
    printf("cavity %u: volume %.6f, area %.6f, pieces inside %u, balls around:", (unsigned)region,
           regions[region].volume, regions[region].area, (unsigned)regions[region].components);
    status = print_wall(work, region, balls, ball_count);
  }
  free(regions);
  free(balls);
  return status;
}

/* A point beyond all balls on the x axis is outside for certain. */
static int32_t print_way_out(const hsp_workspace *work, const struct balls *balls, double probe, const double *point) {
  double outside[3] = {point[0], point[1], point[2]};
  for (uint32_t i = 0; i < balls->count; ++i) {
    const double right = balls->xyz[3 * (size_t)i] + 2 * (balls->radius[i] + probe);
    if (right > outside[0]) outside[0] = right;
  }
  uint32_t region = HSP_NONE, region_outside = 0;
  int32_t status = hsp_topology_locate(work->topology, point, &region);
  if (status == HSP_OK) status = hsp_topology_locate(work->topology, outside, &region_outside);
  if (status != HSP_OK) return status;
  printf("the point %g %g %g lies ", point[0], point[1], point[2]);
  if (region == HSP_NONE) {
    printf("in a ball\n");
  } else if (region == region_outside) { /* a point, and a probe's centre, moves freely within its region */
    printf("outside\n");
  } else {
    printf("in cavity %u and cannot get out\n", (unsigned)region);
  }
  return status;
}

int main(int count, char **arguments) {
  double point[3] = {-0.05, 0.0, 0.0};
  double probe = 0.0;
  struct balls balls = {0, NULL, NULL};
  hsp_workspace work = {0};
  int done = count == 1 ? take_cage(&balls) : read_balls(arguments[1], &balls);
  if (count > 2) probe = strtod(arguments[2], NULL);
  for (int axis = 0; axis < 3 && axis + 3 < count; ++axis) point[axis] = strtod(arguments[axis + 3], NULL);
  if (done) {
    int32_t status = compute(&work, &balls, probe);
    if (status == HSP_OK) status = print_cavities(&work, balls.count);
    if (status == HSP_OK && (count == 1 || count > 5)) status = print_way_out(&work, &balls, probe, point);
    if (status != HSP_OK) fprintf(stderr, "cavities: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  hsp_workspace_free(&work);
  free_balls(&balls);
  return done ? 0 : 1;
}
