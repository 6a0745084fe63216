#include "commands/void_list.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    list->voids[list->count++] = (struct void_cell){.region = region,
                                                    .figures = all[region],
                                                    .low = {HUGE_VAL, HUGE_VAL, HUGE_VAL},
                                                    .high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  }
  free(all);
  return done;
}

/* The pieces of the boundary, as far as boxes of voids are made of it. */
struct pieces {
  hsp_boundary_counts counts;
  hsp_face *faces;
  hsp_arc *arcs;
  hsp_vertex *vertices;
};

static bool take_pieces(const struct geometry *geometry, struct pieces *pieces, struct failure *failure) {
  const hsp_boundary *boundary = geometry->work.boundary;
  hsp_boundary_counts *counts = &pieces->counts;
  uint32_t needed = 0;
  int32_t status = hsp_boundary_get_counts(boundary, counts);
  if (status != HSP_OK) return failure_in_library(failure, status);
  pieces->faces = calloc((size_t)counts->faces + 1, sizeof *pieces->faces);
  pieces->arcs = calloc((size_t)counts->arcs + 1, sizeof *pieces->arcs);
  pieces->vertices = calloc((size_t)counts->vertices + 1, sizeof *pieces->vertices);
  if (pieces->faces == NULL || pieces->arcs == NULL || pieces->vertices == NULL) return failure_of_memory(failure);
  status = hsp_boundary_get_faces(boundary, pieces->faces, counts->faces, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_arcs(boundary, pieces->arcs, counts->arcs, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_vertices(boundary, pieces->vertices, counts->vertices, &needed);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* A void lies in the convex hull of its vertices: all else of its wall bulges into it. */
static void find_boxes(const struct pieces *pieces, const hsp_shell *shells, struct void_list *list) {
  for (uint32_t i = 0; i < pieces->counts.arcs; ++i) {
    const hsp_arc *arc = &pieces->arcs[i];
    const uint32_t region = shells[pieces->faces[arc->face[0]].shell].region;
    if (region == 0) continue;
    struct void_cell *of = &list->voids[region - 1];
    for (int axis = 0; axis < 3; ++axis) {
      for (int end = 0; end < 2; ++end) {
        const double coordinate = pieces->vertices[arc->vertex[end]].xyz[axis];
        of->low[axis] = fmin(of->low[axis], coordinate);
        of->high[axis] = fmax(of->high[axis], coordinate);
      }
    }
  }
}

/* Every ball of a void has a face there: room for all faces is room for the balls of all voids. */
static bool take_balls(const struct geometry *geometry, uint32_t face_count, struct void_list *list,
                       struct failure *failure) {
  list->balls = calloc((size_t)face_count + 1, sizeof *list->balls);
  if (list->balls == NULL) return failure_of_memory(failure);
  uint32_t taken = 0;
  for (uint32_t i = 0; i < list->count; ++i) {
    struct void_cell *of = &list->voids[i];
    of->balls = &list->balls[taken];
    const int32_t status = hsp_topology_get_region_balls(geometry->work.topology, of->region, &list->balls[taken],
                                                         face_count - taken, &of->ball_count);
    if (status != HSP_OK) return failure_in_library(failure, status);
    taken += of->ball_count;
  }
  return true;
}

static bool take_walls(const struct geometry *geometry, const hsp_shell *shells, struct void_list *list,
                       struct failure *failure) {
  struct pieces pieces = {.faces = NULL, .arcs = NULL, .vertices = NULL};
  const bool done = take_pieces(geometry, &pieces, failure) && take_balls(geometry, pieces.counts.faces, list, failure);
  if (done) find_boxes(&pieces, shells, list);
  free(pieces.faces);
  free(pieces.arcs);
  free(pieces.vertices);
  return done;
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

static bool find_rooms(const struct geometry *geometry, const struct molecule *molecule, double probe,
                       struct void_list *list, struct failure *failure) {
  for (uint32_t i = 0; i < list->count; ++i) {
    struct void_cell *of = &list->voids[i];
    const struct void_wall wall = {.region = of->region,
                                   .balls = of->balls,
                                   .ball_count = of->ball_count,
                                   .xyz = molecule->xyz,
                                   .radius = molecule->radius,
                                   .probe = probe,
                                   .low = {of->low[0], of->low[1], of->low[2]},
                                   .high = {of->high[0], of->high[1], of->high[2]}};
    if (!void_room_find(geometry, &wall, &of->room, failure)) return false;
  }
  return true;
}

bool void_list_make(const struct geometry *geometry, const struct molecule *molecule, double probe, double min_volume,
                    struct void_list *list, struct failure *failure) {
  *list = (struct void_list)VOID_LIST_NONE;
  hsp_shell *shells = NULL;
  uint32_t shell_count = 0;
  if (!geometry_list_shells(geometry, &shells, &shell_count, failure)) return false;
  const bool done = take_regions(geometry, list, failure) && take_walls(geometry, shells, list, failure);
  free(shells);
  if (!done) return false;
  if (list->count > 1) qsort(list->voids, list->count, sizeof *list->voids, order_of_voids);
  leave_out_smaller(min_volume, list);
  find_middles(molecule->xyz, list);
  return find_rooms(geometry, molecule, probe, list, failure);
}

bool void_list_point(struct geometry *geometry, const struct molecule *molecule, double probe, uint64_t rank,
                     const char *option, double point[3], struct failure *failure) {
  if (!geometry_compute_topology(geometry, failure)) return false;
  struct void_list list;
  bool done = void_list_make(geometry, molecule, probe, 0.0, &list, failure);
  if (done && rank > list.count) {
    done = failure_in_input(failure, 0, "%s: there is no void %" PRIu64 ", with probe %g there are %" PRIu32, option,
                            rank, probe, list.count);
  } else if (done && !list.voids[rank - 1].room.found) {
    done = failure_in_input(failure, 0, "%s: void %" PRIu64 " has no room for a point", option, rank);
  } else if (done) {
    memcpy(point, list.voids[rank - 1].room.xyz, sizeof list.voids[rank - 1].room.xyz);
  }
  void_list_free(&list);
  return done;
}

void void_list_free(struct void_list *list) {
  free(list->voids);
  free(list->balls);
  *list = (struct void_list)VOID_LIST_NONE;
}
