#include "draw/smooth_borders.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct smoothing {
  const struct triangle_mesh *mesh;
  uint32_t areas;
  double reach;
  size_t *first;       /* [vertices + 1] */
  uint32_t *neighbour; /* of each vertex, once: the surface is closed, so an edge leads both ways */
  uint32_t *stamp;     /* [vertices] the last vertex, from 1 on, from which this one was reached */
  uint32_t *reached;   /* [vertices] */
  double *way;         /* [vertices] from there */
  double *share;       /* [vertices][areas] */
};

static void find_neighbours(const struct smoothing *all) {
  const struct triangle_mesh *const mesh = all->mesh;
  for (size_t k = 0; k < 3 * (size_t)mesh->triangles; ++k) ++all->first[mesh->corners[k] + 1];
  for (uint32_t v = 0; v < mesh->vertices; ++v) all->first[v + 1] += all->first[v];
  for (size_t k = 0; k < 3 * (size_t)mesh->triangles; ++k) {
    const size_t next = k % 3 == 2 ? k - 2 : k + 1;
    all->neighbour[--all->first[mesh->corners[k] + 1]] = mesh->corners[next];
  }
  /* Each beginning has moved to its own place in the row before. */
  memmove(all->first, all->first + 1, mesh->vertices * sizeof *all->first);
  all->first[mesh->vertices] = 3 * (size_t)mesh->triangles;
}

static double length_between(const struct triangle_mesh *mesh, uint32_t v, uint32_t w) {
  double square = 0.0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double way = mesh->xyz[3 * (size_t)w + axis] - mesh->xyz[3 * (size_t)v + axis];
    square += way * way;
  }
  return sqrt(square);
}

/* The area of each number around a vertex, the nearer the more. Distances are along edges: across a fold much of a
 * surface is near in space. */
static void find_shares(const struct smoothing *all, const uint8_t *of_vertex, uint32_t v) {
  const struct triangle_mesh *const mesh = all->mesh;
  double *const share = all->share + (size_t)v * all->areas;
  uint32_t count = 1;
  all->reached[0] = v;
  all->stamp[v] = v + 1;
  all->way[v] = 0.0;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t at = all->reached[i];
    const double part = i == 0 ? 0.0 : all->way[at] / all->reach, left = 1.0 - part * part;
    if (of_vertex[at] != NO_AREA) share[of_vertex[at]] += mesh->areas[at] * left * left;
    for (size_t k = all->first[at]; k < all->first[at + 1]; ++k) {
      const uint32_t next = all->neighbour[k];
      const double way = all->way[at] + length_between(mesh, at, next);
      if (!(way < all->reach) || (all->stamp[next] == v + 1 && all->way[next] <= way)) continue;
      all->way[next] = way;
      if (all->stamp[next] == v + 1) continue;
      all->stamp[next] = v + 1;
      all->reached[count++] = next;
    }
  }
}

static void choose(const struct smoothing *all, uint8_t *of_vertex) {
  for (uint32_t v = 0; v < all->mesh->vertices; ++v) {
    const double *const share = all->share + (size_t)v * all->areas;
    uint32_t most = 0;
    for (uint32_t a = 1; a < all->areas; ++a) most = share[a] > share[most] ? a : most;
    if (share[most] > 0.0) of_vertex[v] = (uint8_t)most;
  }
}

/* Where on an edge there is as much of one number as of the other. */
static double crossing(const struct smoothing *all, const uint8_t *of_vertex, uint32_t from, uint32_t to) {
  const double *const low = all->share + (size_t)from * all->areas, *const high = all->share + (size_t)to * all->areas;
  const uint8_t own = of_vertex[from], other = of_vertex[to];
  double sum[2] = {0.0, 0.0};
  for (uint32_t a = 0; a < all->areas; ++a) {
    sum[0] += low[a];
    sum[1] += high[a];
  }
  const double before = (low[own] - low[other]) / sum[0], after = (high[other] - high[own]) / sum[1];
  return before + after > 0.0 ? before / (before + after) : 0.5;
}

static bool find_edges(const struct smoothing *all, const uint8_t *of_vertex, struct split_edge **edges,
                       size_t *count) {
  size_t found = 0;
  for (int pass = 0; pass < 2; ++pass) {
    if (pass == 1) *edges = calloc(found + 1, sizeof **edges);
    if (pass == 1 && *edges == NULL) return false;
    found = 0;
    for (uint32_t v = 0; v < all->mesh->vertices; ++v) {
      for (size_t k = all->first[v]; k < all->first[v + 1]; ++k) {
        const uint32_t w = all->neighbour[k];
        if (w < v || of_vertex[v] == of_vertex[w] || of_vertex[v] == NO_AREA || of_vertex[w] == NO_AREA) continue;
        if (pass == 1) (*edges)[found] = (struct split_edge){v, w, crossing(all, of_vertex, v, w)};
        ++found;
      }
    }
  }
  *count = mesh_split_sort(*edges, found);
  return true;
}

bool smooth_borders_find(const struct triangle_mesh *mesh, uint32_t areas, double reach, uint8_t *of_vertex,
                         struct split_edge **edges, size_t *count) {
  const size_t vertices = (size_t)mesh->vertices + 2;
  const struct smoothing all = {mesh,
                                areas,
                                reach,
                                calloc(vertices, sizeof *all.first),
                                calloc(3 * (size_t)mesh->triangles + 1, sizeof *all.neighbour),
                                calloc(vertices, sizeof *all.stamp),
                                calloc(vertices, sizeof *all.reached),
                                calloc(vertices, sizeof *all.way),
                                calloc(vertices, areas * sizeof *all.share)};
  bool enough = all.first != NULL && all.neighbour != NULL && all.stamp != NULL && all.reached != NULL &&
                all.way != NULL && all.share != NULL;
  if (enough) {
    find_neighbours(&all);
    for (uint32_t v = 0; v < mesh->vertices; ++v) find_shares(&all, of_vertex, v);
    choose(&all, of_vertex);
    enough = find_edges(&all, of_vertex, edges, count);
  }
  free(all.first);
  free(all.neighbour);
  free(all.stamp);
  free(all.reached);
  free(all.way);
  free(all.share);
  return enough;
}
