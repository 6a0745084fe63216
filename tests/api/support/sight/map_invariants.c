#include "map_invariants.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "map_record_invariants.h"
#include "same_ball.h"
#include "vectors.h"

/* Of the largest radius of the set. */
static double largest_radius(const computed *c) {
  double largest = 0;
  uint32_t i;
  for (i = 0; i < c->n; ++i) largest = fmax(largest, c->radius[i]);
  return largest;
}

static const char *broken_steps(const map_result *m) {
  const hsp_map *map = m->map;
  uint32_t h;
  for (h = 0; h < 2 * m->info.edges; ++h) {
    const hsp_map_edge *edge = &m->edges[h / 2];
    const uint32_t next = hsp_map_next(map, h);
    if (next != edge->next[h % 2]) return "next is not that of the record";
    if (hsp_map_previous(map, next) != h) return "previous is not the inverse of next";
    if (hsp_map_left(map, h) != edge->face[h % 2]) return "left is not that of the record";
    if (hsp_map_origin(map, h) != edge->vertex[h % 2]) return "origin is not that of the record";
    if (HSP_MAP_TWIN(HSP_MAP_TWIN(h)) != h) return "twin is not an involution";
  }
  if (hsp_map_next(map, h) != HSP_NONE || hsp_map_previous(map, h) != HSP_NONE || hsp_map_left(map, h) != HSP_NONE ||
      hsp_map_origin(map, h) != HSP_NONE || hsp_map_next_loop(map, h) != HSP_NONE)
    return "a step from a directed edge that is not there";
  return NULL;
}

/* The answers of hsp_map_get_point at the ends of edges. */
static const char *broken_points(const map_result *m) {
  const double tolerance = 1e-5 * largest_radius(m->base) + 1e-12 * m->base->extent;
  uint32_t e;
  int end, axis;
  for (e = 0; e < m->info.edges; ++e) {
    const hsp_map_edge *edge = &m->edges[e];
    for (end = 0; end < 2; ++end) {
      const double t = end == 0 ? edge->from : edge->to;
      /* A T has the depth of its stem, the edge that ends there; of the other edges x and y alone are compared. */
      const hsp_map_vertex *vertex = &m->vertices[edge->vertex[end]];
      const int axes = vertex->kind == HSP_MAP_T && vertex->h != 2 * e + (uint32_t)end ? 2 : 3;
      hsp_map_point point;
      if (hsp_map_get_point(m->map, e, t, &point) != HSP_OK) return "no point at the end of an edge";
      for (axis = 0; axis < 2; ++axis) {
        const double on_curve = edge->centre[axis] + cos(t) * edge->first[axis] + sin(t) * edge->second[axis];
        if (!near(on_curve, point.xyz[axis], 1e-9 * tolerance + 1e-12 * (m->base->extent + largest_radius(m->base))))
          return "a point of an edge is not on its curve";
      }
      for (axis = 0; axis < axes; ++axis) {
        if (!near(point.xyz[axis], vertex->xyz[axis], tolerance)) return "a point of an edge is not at its vertex";
      }
    }
  }
  return NULL;
}

/* Following each face from loop to loop must give as many loops as its record says. */
static const char *broken_loops(const map_result *m) {
  uint32_t f;
  for (f = 0; f < m->info.faces; ++f) {
    const uint32_t first = m->faces[f].h;
    uint32_t h = first, loops = 0;
    if (first == HSP_NONE) continue;
    do {
      if (hsp_map_left(m->map, h) != f) return "the next loop is another face's";
      if (++loops > m->faces[f].loops) return "the next loops of a face are more than it has";
      h = hsp_map_next_loop(m->map, h);
    } while (h != first);
    if (loops != m->faces[f].loops) return "the next loops of a face are fewer than it has";
  }
  return NULL;
}

static const char *broken_outlines(const map_result *m) {
  uint32_t *hs = test_zeros(2 * (size_t)m->info.edges, sizeof *hs);
  const char *broken = NULL;
  uint32_t f, i, k, count, all = 0, loops = 0;
  for (f = 0; f < m->info.faces; ++f) loops += m->faces[f].ball != HSP_NONE ? m->faces[f].loops : 0;
  for (i = 0; i < m->base->n && broken == NULL; ++i) {
    if (hsp_map_get_outline(m->map, i, hs, 2 * m->info.edges, &count) != HSP_OK) broken = "an outline";
    for (k = 0; k < count && broken == NULL; ++k) {
      if (m->faces[hsp_map_left(m->map, hs[k])].ball != i) broken = "an outline is another ball's";
    }
    all += count;
  }
  if (all != loops) broken = "outlines do not have all loops";
  free(hs);
  return broken;
}

/* The visible area of a ball is a part of its disc, and something is seen where there are balls. */
static const char *broken_areas(const map_result *m) {
  const double largest = largest_radius(m->base), slack = 1e-6 * largest * largest;
  uint32_t i;
  for (i = 0; i < m->base->n; ++i) {
    const double radius = m->base->radius[i];
    if (!(m->area[i] >= -slack && m->area[i] <= pi * radius * radius + slack)) return "an area is not within the disc";
  }
  return largest > 0 && m->faces[0].h == HSP_NONE ? "no edges around the background" : NULL;
}

const char *broken_map(const map_result *m) {
  const map_records records = {
      &m->info, m->vertices, m->edges, m->faces, m->area, m->base->n, 0, largest_radius(m->base), m->base->extent};
  uint32_t invariant = 0, id = 0;
  const char *broken = broken_map_records(&records);
  if (broken == NULL && hsp_map_check(m->map, &invariant, &id) != HSP_OK) broken = "hsp_map_check finds something";
  if (broken == NULL && (invariant != 0 || id != HSP_NONE)) broken = "hsp_map_check reports something that is well";
  if (broken == NULL) broken = broken_areas(m);
  if (broken == NULL) broken = broken_steps(m);
  if (broken == NULL) broken = broken_points(m);
  if (broken == NULL) broken = broken_loops(m);
  if (broken == NULL) broken = broken_outlines(m);
  return broken;
}

/* ---- another order of the balls ---- */

static int same_balls(const map_result *a, uint32_t *i, const map_result *b, uint32_t *j, int count) {
  int k;
  for (k = 0; k < count; ++k) {
    if (!same_ball(a->base, i[k], b->base, j[k])) return 0;
    i[k] = j[k] = 0;
  }
  return 1;
}

const char *map_difference_after_permutation(const map_result *a, const map_result *b) {
  uint32_t i;
  if (memcmp(&a->needed, &b->needed, sizeof a->needed) != 0) return "needed limits depend on the order of the balls";
  if (memcmp(&a->info, &b->info, sizeof a->info) != 0) return "info depends on the order of the balls";
  for (i = 0; i < a->info.vertices; ++i) {
    hsp_map_vertex p = a->vertices[i], q = b->vertices[i];
    if (!same_balls(a, p.ball, b, q.ball, 3)) return "balls of vertices depend on the order of the balls";
    if (memcmp(&p, &q, sizeof p) != 0) return "vertices depend on the order of the balls";
  }
  for (i = 0; i < a->info.edges; ++i) {
    hsp_map_edge p = a->edges[i], q = b->edges[i];
    if (!same_balls(a, p.ball, b, q.ball, 2)) return "balls of edges depend on the order of the balls";
    if (memcmp(&p, &q, sizeof p) != 0) return "edges depend on the order of the balls";
  }
  for (i = 0; i < a->info.faces; ++i) {
    hsp_map_face p = a->faces[i], q = b->faces[i];
    if (!same_balls(a, &p.ball, b, &q.ball, 1)) return "balls of faces depend on the order of the balls";
    if (memcmp(&p, &q, sizeof p) != 0) return "faces depend on the order of the balls";
  }
  return NULL;
}
