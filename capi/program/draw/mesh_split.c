#include "draw/mesh_split.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int compare(const void *left, const void *right) {
  const struct split_edge *a = left;
  const struct split_edge *b = right;
  if (a->low != b->low) return a->low < b->low ? -1 : 1;
  return (a->high > b->high) - (a->high < b->high);
}

/* A total order, so that the result of sorting is unique. */
static int compare_places(const void *left, const void *right) {
  const struct split_edge *a = left;
  const struct split_edge *b = right;
  int order = compare(a, b);
  if (order == 0) order = (a->share > b->share) - (a->share < b->share);
  for (int axis = 0; axis < 3 && order == 0; ++axis) {
    order = (a->bulge[axis] > b->bulge[axis]) - (a->bulge[axis] < b->bulge[axis]);
  }
  return order;
}

size_t mesh_split_sort(struct split_edge *edges, size_t count) {
  size_t kept = 0;
  qsort(edges, count, sizeof *edges, compare_places);
  for (size_t k = 0; k < count; ++k) {
    if (kept == 0 || compare(&edges[k], &edges[kept - 1]) != 0) edges[kept++] = edges[k];
  }
  return kept;
}

/* The vertex on an edge, or UINT32_MAX. */
static uint32_t vertex_on(const struct split_edge *edges, size_t count, uint32_t a, uint32_t b, uint32_t first) {
  const struct split_edge wanted = {.low = a < b ? a : b, .high = a < b ? b : a};
  const struct split_edge *const found = bsearch(&wanted, edges, count, sizeof *edges, compare);
  return found == NULL ? UINT32_MAX : first + (uint32_t)(found - edges);
}

static void set_vertices(const struct triangle_mesh *mesh, const struct split_edge *edges, size_t count,
                         struct triangle_mesh *more) {
  for (size_t k = 0; k < count; ++k) {
    double normal[3], square = 0.0;
    for (size_t axis = 0; axis < 3; ++axis) {
      const size_t from = 3 * (size_t)edges[k].low + axis, to = 3 * (size_t)edges[k].high + axis;
      more->xyz[3 * k + axis] =
          mesh->xyz[from] + edges[k].share * (mesh->xyz[to] - mesh->xyz[from]) + edges[k].bulge[axis];
      normal[axis] = mesh->normals[from] + edges[k].share * (mesh->normals[to] - mesh->normals[from]);
      square += normal[axis] * normal[axis];
    }
    for (size_t axis = 0; axis < 3; ++axis) {
      more->normals[3 * k + axis] = square > 0.0 ? normal[axis] / sqrt(square) : 0.0;
    }
    more->vertex_balls[k] = mesh->vertex_balls[edges[k].low];
  }
}

/* The parts of a triangle; the first one stands in its place. The vertex on[k] is on the edge from the k-th corner. */
static int part_corners(const uint32_t corner[3], const uint32_t on[3], uint32_t part[4][3]) {
  int crossed = 0, whole = 0;
  for (int k = 0; k < 3; ++k) {
    if (on[k] == UINT32_MAX) whole = k;
    if (on[k] != UINT32_MAX) ++crossed;
  }
  if (crossed == 3) {
    for (int k = 0; k < 3; ++k) memcpy(part[k], (uint32_t[3]){corner[k], on[k], on[(k + 2) % 3]}, sizeof *part);
    memcpy(part[3], on, sizeof *part);
    return 4;
  }
  const uint32_t a = corner[whole], b = corner[(whole + 1) % 3], c = corner[(whole + 2) % 3];
  const uint32_t on_b = on[(whole + 1) % 3], on_c = on[(whole + 2) % 3];
  if (crossed == 2) { /* all but that from a to b */
    memcpy(part[0], (uint32_t[3]){c, on_c, on_b}, sizeof *part);
    memcpy(part[1], (uint32_t[3]){a, b, on_c}, sizeof *part);
    memcpy(part[2], (uint32_t[3]){b, on_b, on_c}, sizeof *part);
    return 3;
  }
  for (int k = 0; k < 3; ++k) {
    if (on[k] == UINT32_MAX) continue;
    memcpy(part[0], (uint32_t[3]){corner[k], on[k], corner[(k + 2) % 3]}, sizeof *part);
    memcpy(part[1], (uint32_t[3]){corner[(k + 1) % 3], corner[(k + 2) % 3], on[k]}, sizeof *part);
  }
  return 2;
}

/* Make room for the marks of `more` triangles. */
static bool grow_marks(uint8_t **marks, uint32_t triangles, uint32_t more, struct failure *failure) {
  if (marks == NULL) return true;
  uint8_t *const grown = realloc(*marks, (size_t)triangles + more + 1);
  if (grown == NULL) return failure_of_memory(failure);
  *marks = grown;
  return true;
}

bool mesh_split(struct triangle_mesh *mesh, const struct split_edge *edges, size_t count, uint8_t **marks,
                struct failure *failure) {
  const uint32_t first = mesh->vertices;
  struct triangle_mesh more = {.vertices = 0};
  uint32_t room = 0, made = 0;
  bool enough = true;
  for (int pass = 0; enough && pass < 2; ++pass) {
    enough = pass == 0 || (triangle_mesh_make(&more, (uint32_t)count, room, failure) &&
                           grow_marks(marks, mesh->triangles, room, failure));
    for (uint32_t t = 0; enough && t < mesh->triangles; ++t) {
      uint32_t *const corner = mesh->corners + 3 * (size_t)t;
      uint32_t on[3], part[4][3];
      for (int k = 0; k < 3; ++k) on[k] = vertex_on(edges, count, corner[k], corner[(k + 1) % 3], first);
      if (on[0] == UINT32_MAX && on[1] == UINT32_MAX && on[2] == UINT32_MAX) continue;
      const int parts = part_corners(corner, on, part);
      if (pass == 0) room += (uint32_t)parts - 1;
      if (pass == 0) continue;
      for (int k = 1; k < parts; ++k, ++made) {
        for (int i = 0; i < 3; ++i) more.corners[3 * (size_t)made + (size_t)i] = part[k][i] - first; /* to be added */
        more.kinds[made] = mesh->kinds[t];
        more.patches[made] = mesh->patches[t];
        more.balls[made] = mesh->balls[t];
        if (marks != NULL) (*marks)[(size_t)mesh->triangles + made] = (*marks)[t];
      }
      memcpy(corner, part[0], sizeof *part);
    }
  }
  if (enough) set_vertices(mesh, edges, count, &more);
  const bool done = enough && triangle_mesh_append(mesh, &more, failure);
  triangle_mesh_free(&more);
  return done;
}
