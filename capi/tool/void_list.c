#include "void_list.h"

#include <stdlib.h>

static int order_of_numbers(uint32_t a, uint32_t b) {
  return (a > b) - (a < b);
}

/* A ball with a face on a void. */
struct wall {
  uint32_t cell;
  uint32_t ball;
};

static int order_of_walls(const void *left, const void *right) {
  const struct wall *a = left;
  const struct wall *b = right;
  const int by_cell = order_of_numbers(a->cell, b->cell);
  return by_cell != 0 ? by_cell : order_of_numbers(a->ball, b->ball);
}

static int order_of_voids(const void *left, const void *right) {
  const struct void_cell *a = left;
  const struct void_cell *b = right;
  const double more = b->figures.volume - a->figures.volume;
  if (more != 0.0) return more > 0.0 ? 1 : -1;
  return order_of_numbers(a->cell, b->cell);
}

static bool take_cells(const struct geometry *geometry, struct void_list *list, struct failure *failure) {
  uint32_t cells = 0;
  int32_t status = hsp_topology_get_cells(geometry->work.topology, NULL, 0, &cells);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  hsp_cell *all = calloc((size_t)cells + 1, sizeof *all);
  list->voids = calloc((size_t)cells + 1, sizeof *list->voids);
  bool done = all != NULL && list->voids != NULL;
  if (!done) {
    failure_of_memory(failure);
  } else {
    status = hsp_topology_get_cells(geometry->work.topology, all, cells, &cells);
    done = status == HSP_OK || failure_in_library(failure, status);
  }
  for (uint32_t cell = 1; done && cell < cells; ++cell) {
    list->voids[list->count++] = (struct void_cell){cell, all[cell], NULL, 0, {0, 0, 0}};
  }
  free(all);
  return done;
}

/* Every face on the wall of a void gives a pair of void and ball; each pair once, in order. */
static uint32_t gather_walls(const hsp_face *faces, uint32_t face_count, const hsp_shell *shells, struct wall *walls) {
  uint32_t pairs = 0;
  for (uint32_t i = 0; i < face_count; ++i) {
    const uint32_t cell = shells[faces[i].shell].cell;
    if (cell > 0) walls[pairs++] = (struct wall){cell, faces[i].ball};
  }
  qsort(walls, pairs, sizeof *walls, order_of_walls);
  uint32_t kept = 0;
  for (uint32_t i = 0; i < pairs; ++i) {
    if (kept == 0 || order_of_walls(&walls[kept - 1], &walls[i]) != 0) walls[kept++] = walls[i];
  }
  return kept;
}

static bool take_walls(const struct geometry *geometry, const hsp_shell *shells, struct void_list *list,
                       struct failure *failure) {
  uint32_t face_count = 0;
  int32_t status = hsp_boundary_get_faces(geometry->work.boundary, NULL, 0, &face_count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  hsp_face *faces = calloc((size_t)face_count + 1, sizeof *faces);
  struct wall *walls = calloc((size_t)face_count + 1, sizeof *walls);
  list->balls = calloc((size_t)face_count + 1, sizeof *list->balls);
  bool done = faces != NULL && walls != NULL && list->balls != NULL;
  if (!done) {
    failure_of_memory(failure);
  } else {
    status = hsp_boundary_get_faces(geometry->work.boundary, faces, face_count, &face_count);
    done = status == HSP_OK || failure_in_library(failure, status);
  }
  if (done) {
    const uint32_t pairs = gather_walls(faces, face_count, shells, walls);
    for (uint32_t i = 0; i < pairs; ++i) {
      struct void_cell *of = &list->voids[walls[i].cell - 1];
      list->balls[i] = walls[i].ball;
      if (of->ball_count++ == 0) of->balls = &list->balls[i];
    }
  }
  free(faces);
  free(walls);
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

bool void_list_make(const struct geometry *geometry, const double *xyz, double min_volume, struct void_list *list,
                    struct failure *failure) {
  *list = (struct void_list)VOID_LIST_NONE;
  hsp_shell *shells = NULL;
  uint32_t shell_count = 0;
  if (!geometry_list_shells(geometry, &shells, &shell_count, failure)) return false;
  const bool done = take_cells(geometry, list, failure) && take_walls(geometry, shells, list, failure);
  free(shells);
  if (!done) return false;
  if (list->count > 1) qsort(list->voids, list->count, sizeof *list->voids, order_of_voids);
  leave_out_smaller(min_volume, list);
  find_middles(xyz, list);
  return true;
}

void void_list_free(struct void_list *list) {
  free(list->voids);
  free(list->balls);
  *list = (struct void_list)VOID_LIST_NONE;
}
