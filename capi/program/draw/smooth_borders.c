#include "draw/smooth_borders.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double detour = 1.2; /* at most, of a way along edges, where a surface is smooth */

struct smoothing {
  const struct triangle_mesh *mesh;
  uint32_t areas;
  double reach;
  size_t *first;       /* [vertices + 1] */
  uint32_t *neighbour; /* of each vertex, once: the surface is closed, so an edge leads both ways */
  uint32_t *stamp;     /* [vertices] the last vertex, from 1 on, from which this one was reached */
  uint32_t *reached;   /* [vertices] */
  double *way;         /* [vertices] from there */
  double *share;       /* [vertices][areas], of the surface around each */
  double *mean;        /* [vertices][areas], of shares */
  bool *waiting;       /* [vertices] */
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

static void set_shares(const struct smoothing *all, const uint8_t *of_vertex) {
  for (uint32_t v = 0; v < all->mesh->vertices; ++v) {
    if (of_vertex[v] != NO_AREA) all->share[(size_t)v * all->areas + of_vertex[v]] = 1.0;
  }
}

/* The mean of the shares around a vertex by area, the nearer the more. Others are found along edges, as across a fold
 * much of a surface is near; distances are in space, as ways along edges are longer by more or less from vertex to
 * vertex, and borders would go to and fro. */
static void find_mean(const struct smoothing *all, uint32_t v) {
  const struct triangle_mesh *const mesh = all->mesh;
  double *const mean = all->mean + (size_t)v * all->areas;
  double sum = 0.0;
  uint32_t count = 1;
  all->reached[0] = v;
  all->stamp[v] = v + 1;
  all->way[v] = 0.0;
  memset(mean, 0, all->areas * sizeof *mean);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t at = all->reached[i];
    const double part = length_between(mesh, v, at) / all->reach, left = fmax(1.0 - part * part, 0.0);
    const double weight = mesh->areas[at] * left * left, *const share = all->share + (size_t)at * all->areas;
    for (uint32_t a = 0; a < all->areas; ++a) {
      mean[a] += weight * share[a];
      sum += weight * share[a];
    }
    for (size_t k = all->first[at]; k < all->first[at + 1]; ++k) {
      const uint32_t next = all->neighbour[k];
      const double way = all->way[at] + length_between(mesh, at, next);
      if (!(way < detour * all->reach) || (all->stamp[next] == v + 1 && all->way[next] <= way)) continue;
      all->way[next] = way;
      if (all->stamp[next] == v + 1) continue;
      all->stamp[next] = v + 1;
      all->reached[count++] = next;
    }
  }
  for (uint32_t a = 0; a < all->areas && sum > 0.0; ++a) mean[a] /= sum;
}

static bool has_share_of(const struct smoothing *all, uint32_t v, uint32_t w) {
  const size_t row = all->areas * sizeof *all->share;
  return memcmp(all->share + (size_t)v * all->areas, all->share + (size_t)w * all->areas, row) == 0;
}

/* How far each vertex is along edges from where shares differ, if that is no farther than means reach, else infinite:
 * its mean is its share then. */
static void find_ways(const struct smoothing *all) {
  const uint32_t vertices = all->mesh->vertices;
  const double most =
      detour * all->reach * (1.0 + 1e-9); /* sums of ways may be rounded otherwise the other way round */
  uint32_t first = 0, count = 0;
  for (uint32_t v = 0; v < vertices; ++v) {
    bool differs = false;
    for (size_t k = all->first[v]; k < all->first[v + 1]; ++k) {
      differs = differs || !has_share_of(all, v, all->neighbour[k]);
    }
    all->way[v] = differs ? 0.0 : INFINITY;
    all->waiting[v] = differs;
    if (differs) all->reached[count++] = v;
  }
  while (count > 0) {
    const uint32_t at = all->reached[first];
    first = first + 1 < vertices ? first + 1 : 0;
    --count;
    all->waiting[at] = false;
    for (size_t k = all->first[at]; k < all->first[at + 1]; ++k) {
      const uint32_t next = all->neighbour[k];
      const double way = all->way[at] + length_between(all->mesh, at, next);
      if (!(way < most && way < all->way[next])) continue;
      all->way[next] = way;
      if (all->waiting[next]) continue;
      all->waiting[next] = true;
      all->reached[first + count < vertices ? first + count : first + count - vertices] = next;
      ++count;
    }
  }
}

/* Twice: what is left of corners after a mean is gone after another one. */
static void find_shares(struct smoothing *all, const uint8_t *of_vertex) {
  set_shares(all, of_vertex);
  for (int pass = 0; pass < 2; ++pass) {
    memset(all->stamp, 0, all->mesh->vertices * sizeof *all->stamp);
    find_ways(all);
    for (uint32_t v = 0; v < all->mesh->vertices; ++v) all->waiting[v] = all->way[v] < INFINITY;
    for (uint32_t v = 0; v < all->mesh->vertices; ++v) {
      const size_t row = (size_t)v * all->areas;
      if (all->waiting[v]) {
        find_mean(all, v);
      } else {
        memcpy(all->mean + row, all->share + row, all->areas * sizeof *all->mean);
      }
    }
    double *const before = all->share;
    all->share = all->mean;
    all->mean = before;
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
  const double before = low[own] - low[other], after = high[other] - high[own];
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
        if (pass == 1)
          (*edges)[found] = (struct split_edge){.low = v, .high = w, .share = crossing(all, of_vertex, v, w)};
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
  struct smoothing all = {mesh,
                          areas,
                          reach,
                          calloc(vertices, sizeof *all.first),
                          calloc(3 * (size_t)mesh->triangles + 1, sizeof *all.neighbour),
                          calloc(vertices, sizeof *all.stamp),
                          calloc(vertices, sizeof *all.reached),
                          calloc(vertices, sizeof *all.way),
                          calloc(vertices, areas * sizeof *all.share),
                          calloc(vertices, areas * sizeof *all.mean),
                          calloc(vertices, sizeof *all.waiting)};
  bool enough = all.first != NULL && all.neighbour != NULL && all.stamp != NULL && all.reached != NULL &&
                all.way != NULL && all.share != NULL && all.mean != NULL && all.waiting != NULL;
  if (enough) {
    find_neighbours(&all);
    find_shares(&all, of_vertex);
    choose(&all, of_vertex);
    enough = find_edges(&all, of_vertex, edges, count);
  }
  free(all.first);
  free(all.neighbour);
  free(all.stamp);
  free(all.reached);
  free(all.way);
  free(all.share);
  free(all.mean);
  free(all.waiting);
  return enough;
}
