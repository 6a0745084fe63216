#include "commands/void_list.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "commands/void_sphere.h"

static int order_of_numbers(uint32_t a, uint32_t b) {
  return (a > b) - (a < b);
}

static int order_of_voids(const void *left, const void *right) {
  const struct void_cell *a = left;
  const struct void_cell *b = right;
  const double more = b->figures.volume - a->figures.volume;
  if (more != 0.0) return more > 0.0 ? 1 : -1;
  return order_of_numbers(a->region, b->region);
}

static bool take_regions(const struct geometry *geometry, struct void_list *list, struct failure *failure) {
  uint32_t regions = 0;
  int32_t status = hsp_topology_get_regions(geometry->work.topology, NULL, 0, &regions);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  hsp_region *all = calloc((size_t)regions + 1, sizeof *all);
  list->voids = calloc((size_t)regions + 1, sizeof *list->voids);
  bool done = all != NULL && list->voids != NULL;
  if (!done) {
    failure_of_memory(failure);
  } else {
    status = hsp_topology_get_regions(geometry->work.topology, all, regions, &regions);
    done = status == HSP_OK || failure_in_library(failure, status);
  }
  for (uint32_t region = 1; done && region < regions; ++region) {
    list->voids[list->count++] = (struct void_cell){.region = region, .figures = all[region]};
  }
  free(all);
  return done;
}

/* Every ball of a void has a face there: room for all faces is room for the balls of all voids. */
static bool take_balls(const struct geometry *geometry, struct void_list *list, struct failure *failure) {
  hsp_boundary_counts counts;
  int32_t status = hsp_boundary_get_counts(geometry->work.boundary, &counts);
  if (status != HSP_OK) return failure_in_library(failure, status);
  list->balls = calloc((size_t)counts.faces + 1, sizeof *list->balls);
  if (list->balls == NULL) return failure_of_memory(failure);
  uint32_t taken = 0;
  for (uint32_t i = 0; i < list->count; ++i) {
    struct void_cell *of = &list->voids[i];
    of->balls = &list->balls[taken];
    status = hsp_topology_get_region_balls(geometry->work.topology, of->region, &list->balls[taken],
                                           counts.faces - taken, &of->ball_count);
    if (status != HSP_OK) return failure_in_library(failure, status);
    taken += of->ball_count;
  }
  return true;
}

static void find_middles(const double *xyz, struct void_list *list) {
  for (uint32_t i = 0; i < list->count; ++i) {
    struct void_cell *of = &list->voids[i];
    for (size_t axis = 0; axis < 3; ++axis) {
      double sum = 0.0;
      for (uint32_t k = 0; k < of->ball_count; ++k) sum += xyz[3 * (size_t)of->balls[k] + axis];
      of->middle[axis] = of->ball_count == 0 ? 0.0 : sum / of->ball_count;
    }
  }
}

/* The voids are in order: those to leave out are the last ones. */
static void leave_out_smaller(double min_volume, struct void_list *list) {
  while (list->count > 0 && list->voids[list->count - 1].figures.volume < min_volume) {
    --list->count;
    ++list->smaller;
  }
}

bool void_list_make(const struct geometry *geometry, const struct molecule *molecule, double probe, double min_volume,
                    struct void_list *list, struct failure *failure) {
  *list = (struct void_list)VOID_LIST_NONE;
  if (!take_regions(geometry, list, failure) || !take_balls(geometry, list, failure)) return false;
  if (list->count > 1) qsort(list->voids, list->count, sizeof *list->voids, order_of_voids);
  leave_out_smaller(min_volume, list);
  find_middles(molecule->xyz, list);
  return void_spheres_find(geometry, molecule, probe, list, failure);
}

bool void_list_point(struct geometry *geometry, const struct molecule *molecule, double probe, uint64_t rank,
                     const char *option, double point[3], struct failure *failure) {
  if (!geometry_compute_topology(geometry, failure)) return false;
  struct void_list list;
  bool done = void_list_make(geometry, molecule, probe, 0.0, &list, failure);
  if (done && rank > list.count) {
    done = failure_in_input(failure, 0, "%s: there is no void %" PRIu64 ", with probe %g there are %" PRIu32, option,
                            rank, probe, list.count);
  } else if (done && !list.voids[rank - 1].sphere.found) {
    done = failure_in_input(failure, 0, "%s: void %" PRIu64 " has no room for a point", option, rank);
  } else if (done) {
    memcpy(point, list.voids[rank - 1].sphere.xyz, sizeof list.voids[rank - 1].sphere.xyz);
  }
  void_list_free(&list);
  return done;
}

void void_list_free(struct void_list *list) {
  free(list->voids);
  free(list->balls);
  *list = (struct void_list)VOID_LIST_NONE;
}
