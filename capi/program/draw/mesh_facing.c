#include "draw/mesh_facing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/mesh_split.h"
#include "hardsphere.h"
#include "read/vectors.h"

/* A corner within this share of an edge from the contour counts as on it: the surface is nearly parallel to the line of
 * sight there. */
static const double nearest = 0.2;

/* The data from which the normals of all triangles follow. */
struct surface {
  const struct triangle_mesh *mesh;
  const struct mesh_view *view;
  const struct molecule *molecule;
};

static void normal_at(const struct surface *surface, uint32_t triangle, size_t k, double normal[3]) {
  const struct triangle_mesh *const mesh = surface->mesh;
  const size_t vertex = mesh->corners[3 * (size_t)triangle + k];
  const bool convex = mesh->kinds[triangle] == HSP_PATCH_CONVEX;
  memcpy(normal, mesh->normals + 3 * vertex, 3 * sizeof *normal);
  if (!convex && mesh->kinds[triangle] != HSP_PATCH_CONCAVE) return;
  const double *const centre = convex ? surface->molecule->xyz + 3 * (size_t)mesh->balls[triangle]
                                      : surface->view->patches[mesh->patches[triangle]].probe;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double away = mesh->xyz[3 * vertex + axis] - centre[axis];
    normal[axis] = convex ? away : -away;
  }
  const double length = vector_length(normal);
  for (size_t axis = 0; axis < 3 && length > 0.0; ++axis) normal[axis] /= length;
}

double mesh_facing(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                   uint32_t triangle) {
  const struct surface surface = {mesh, view, molecule};
  double sum = 0.0;
  for (size_t k = 0; k < 3; ++k) {
    double normal[3];
    normal_at(&surface, triangle, k, normal);
    sum += dot(view->axis[2], normal);
  }
  return sum;
}

/* Over the middle of a chord of a circle is an eighth of its square over the diameter. */
static struct split_edge edge_between(const struct triangle_mesh *mesh, const uint32_t end[2], double normal[2][3],
                                      const double value[2]) {
  const double share = value[0] / (value[0] - value[1]), rest = 1.0 - share;
  struct split_edge edge = {.low = end[0], .high = end[1], .share = share};
  double chord[3];
  for (size_t axis = 0; axis < 3; ++axis) {
    chord[axis] = mesh->xyz[3 * (size_t)end[1] + axis] - mesh->xyz[3 * (size_t)end[0] + axis];
  }
  const double rise[2] = {dot(chord, normal[0]), -dot(chord, normal[1])};
  for (int axis = 0; axis < 3; ++axis) {
    edge.bulge[axis] = -share * rest * (rest * rise[0] * normal[0][axis] + share * rise[1] * normal[1][axis]);
  }
  return edge;
}

/* The normals in the corners of a triangle, and their parts to the viewer. */
struct facing {
  double normal[3][3], value[3];
};

static struct facing facing_of(const struct surface *surface, uint32_t triangle) {
  struct facing facing;
  for (size_t k = 0; k < 3; ++k) {
    normal_at(surface, triangle, k, facing.normal[k]);
    facing.value[k] = dot(surface->view->axis[2], facing.normal[k]);
  }
  return facing;
}

static bool turns(const struct facing *facing, size_t k) {
  return (facing->value[k] > 0.0) != (facing->value[(k + 1) % 3] > 0.0);
}

/* Find for each vertex the largest value with which the contour still counts as passing through it; spheres that meet
 * at an angle have different values there. Returns how many edges the contour crosses, each counted once for each of
 * its triangles. */
static size_t find_near(const struct surface *surface, double *near) {
  const struct triangle_mesh *const mesh = surface->mesh;
  size_t crossed = 0;
  for (uint32_t t = 0; t < mesh->triangles; ++t) {
    const struct facing facing = facing_of(surface, t);
    for (size_t k = 0; k < 3; ++k) {
      if (!turns(&facing, k)) continue;
      ++crossed;
      for (size_t end = 0; end < 2; ++end) {
        const double own = fabs(facing.value[(k + end) % 3]), other = fabs(facing.value[(k + 1 - end) % 3]);
        double *const most = &near[mesh->corners[3 * (size_t)t + (k + end) % 3]];
        if (own <= nearest * (own + other) && own >= *most) *most = own * (1.0 + 1e-9); /* both sides of a border */
      }
    }
  }
  return crossed;
}

/* Find the edges that the contour crosses, once for each triangle; mesh_split_sort leaves each once. */
static size_t find_edges(const struct surface *surface, const double *near, struct split_edge *edges) {
  const struct triangle_mesh *const mesh = surface->mesh;
  size_t found = 0;
  for (uint32_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *const corner = mesh->corners + 3 * (size_t)t;
    struct facing facing = facing_of(surface, t);
    for (size_t k = 0; k < 3; ++k) {
      const size_t next = (k + 1) % 3, low = corner[k] < corner[next] ? k : next, high = k + next - low;
      if (!turns(&facing, k) || fabs(facing.value[k]) <= near[corner[k]]) continue;
      if (fabs(facing.value[next]) <= near[corner[next]]) continue;
      double normal[2][3];
      memcpy(normal[0], facing.normal[low], sizeof normal[0]);
      memcpy(normal[1], facing.normal[high], sizeof normal[1]);
      edges[found++] = edge_between(mesh, (uint32_t[2]){corner[low], corner[high]}, normal,
                                    (double[2]){facing.value[low], facing.value[high]});
    }
  }
  return found;
}

bool mesh_facing_split(struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                       uint8_t **marks, struct failure *failure) {
  const struct surface surface = {mesh, view, molecule};
  double *const near = calloc((size_t)mesh->vertices + 1, sizeof *near);
  struct split_edge *edges = NULL;
  if (near != NULL) edges = calloc(find_near(&surface, near) + 1, sizeof *edges);
  bool done = edges != NULL || failure_of_memory(failure);
  if (done) {
    const size_t count = mesh_split_sort(edges, find_edges(&surface, near, edges));
    done = count == 0 || mesh_split(mesh, edges, count, marks, failure);
  }
  free(near);
  free(edges);
  return done;
}
