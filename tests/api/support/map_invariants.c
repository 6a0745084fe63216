#include "map_invariants.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "same_ball.h"
#include "vectors.h"

/* Of the largest radius of the set. */
static double largest_radius(const computed *c) {
  double largest = 0;
  uint32_t i;
  for (i = 0; i < c->n; ++i) largest = fmax(largest, c->radius[i]);
  return largest;
}

static const char *broken_frame(const map_result *m) {
  const hsp_map_info *info = &m->info;
  double w[3];
  cross(info->right, info->up, w);
  if (!near(length(info->right), 1, 1e-14) || !near(length(info->up), 1, 1e-14)) return "axes are not unit vectors";
  if (!near(w[0], info->towards[0], 1e-14) || !near(w[1], info->towards[1], 1e-14) ||
      !near(w[2], info->towards[2], 1e-14))
    return "the frame is not right-handed and orthonormal";
  if (info->reserved != 0) return "reserved of info is not 0";
  if (info->faces == 0) return "no unbounded face";
  if (info->vertices + info->faces != 1 + info->components + info->edges) return "V - E + F is not 1 + C";
  return NULL;
}

static const char *broken_steps(const map_result *m) {
  const hsp_map *map = m->map;
  uint32_t h;
  for (h = 0; h < 2 * m->info.edges; ++h) {
    const hsp_map_edge *edge = &m->edges[h / 2];
    const uint32_t next = hsp_map_next(map, h);
    if (next != edge->next[h % 2]) return "next is not that of the record";
    if (next >= 2 * m->info.edges) return "next is no directed edge";
    if (hsp_map_previous(map, next) != h) return "previous is not the inverse of next";
    if (hsp_map_left(map, h) != edge->face[h % 2]) return "left is not that of the record";
    if (hsp_map_left(map, next) != hsp_map_left(map, h)) return "left changes along a loop";
    if (hsp_map_origin(map, h) != edge->vertex[h % 2]) return "origin is not that of the record";
    if (hsp_map_origin(map, next) != edge->vertex[1 - h % 2]) return "next does not start where a directed edge ends";
    if (edge->vertex[h % 2] >= m->info.vertices || edge->face[h % 2] >= m->info.faces) return "no such vertex or face";
    if (HSP_MAP_TWIN(HSP_MAP_TWIN(h)) != h) return "twin is not an involution";
  }
  if (hsp_map_next(map, h) != HSP_NONE || hsp_map_previous(map, h) != HSP_NONE || hsp_map_left(map, h) != HSP_NONE ||
      hsp_map_origin(map, h) != HSP_NONE || hsp_map_next_loop(map, h) != HSP_NONE)
    return "a step from a directed edge that is not there";
  return NULL;
}

static const char *broken_edges(const map_result *m) {
  const double tolerance = 1e-5 * largest_radius(m->base) + 1e-12 * m->base->extent;
  uint32_t e;
  int end, axis;
  for (e = 0; e < m->info.edges; ++e) {
    const hsp_map_edge *edge = &m->edges[e];
    if (!(edge->from <= edge->to && edge->to - edge->from <= 2 * pi + 1e-15)) return "parameters of an edge";
    if (!(edge->from >= -3 * pi && edge->from <= pi)) return "an edge begins beyond pi or before -3 pi";
    if (fabs(edge->first[0] * edge->second[0] + edge->first[1] * edge->second[1]) >
        1e-12 * tolerance * tolerance * 1e10)
      return "the semi-axes of an edge are not at right angles";
    if (edge->first[0] * edge->second[1] - edge->first[1] * edge->second[0] < 0) return "an edge turns clockwise";
    if (edge->ball[0] >= m->base->n) return "no such ball on the left of an edge";
    for (end = 0; end < 2; ++end) {
      const double t = end == 0 ? edge->from : edge->to;
      hsp_map_point point;
      if (hsp_map_get_point(m->map, e, t, &point) != HSP_OK) return "no point at the end of an edge";
      for (axis = 0; axis < 2; ++axis) {
        const double on_curve = edge->centre[axis] + cos(t) * edge->first[axis] + sin(t) * edge->second[axis];
        if (!near(on_curve, point.xyz[axis], 1e-9 * tolerance + 1e-12 * (m->base->extent + largest_radius(m->base))))
          return "a point of an edge is not on its curve";
      }
      {
        /* A T is as deep as its stem. */
        const hsp_map_vertex *vertex = &m->vertices[edge->vertex[end]];
        const int axes = vertex->kind == HSP_MAP_T && vertex->h != 2 * e + (uint32_t)end ? 2 : 3;
        for (axis = 0; axis < axes; ++axis) {
          if (!near(point.xyz[axis], vertex->xyz[axis], tolerance)) return "an edge does not end at its vertex";
        }
      }
    }
  }
  return NULL;
}

static const char *broken_vertices(const map_result *m) {
  uint32_t v, k;
  for (v = 0; v < m->info.vertices; ++v) {
    const hsp_map_vertex *vertex = &m->vertices[v];
    const uint32_t most = vertex->kind == HSP_MAP_TRIPLE || vertex->kind == HSP_MAP_T ? 3 : 2;
    uint32_t h = vertex->h;
    for (k = 0; k < most; ++k) {
      if (hsp_map_origin(m->map, h) != v) return "a directed edge of a vertex starts elsewhere";
      h = hsp_map_next(m->map, HSP_MAP_TWIN(h));
    }
    if (h != vertex->h) return "the number of edges of a vertex";
    if (vertex->kind > HSP_MAP_TANGENCY || vertex->reserved != 0) return "the kind of a vertex";
  }
  return NULL;
}

/* Twice the area that a directed edge sweeps about a point, by Gauss's rule on short parts. */
static double swept_twice(const hsp_map_edge *edge, const double about[2]) {
  static const double node = 0.57735026918962576451;
  enum { PARTS = 64 };
  const double step = (edge->to - edge->from) / PARTS;
  double sum = 0;
  int part, side;
  for (part = 0; part < PARTS; ++part) {
    for (side = -1; side <= 1; side += 2) {
      const double t = edge->from + step * (part + 0.5 + 0.5 * side * node);
      const double x = edge->centre[0] - about[0] + cos(t) * edge->first[0] + sin(t) * edge->second[0];
      const double y = edge->centre[1] - about[1] + cos(t) * edge->first[1] + sin(t) * edge->second[1];
      const double dx = cos(t) * edge->second[0] - sin(t) * edge->first[0];
      const double dy = cos(t) * edge->second[1] - sin(t) * edge->first[1];
      sum += 0.5 * step * (x * dy - y * dx);
    }
  }
  return sum;
}

/* The area of a face from its edges; *loops becomes the number of its loops, HSP_NONE if they do not close. */
static double area_around(const map_result *m, uint32_t first, uint32_t face, uint32_t *loops) {
  double twice = 0;
  uint32_t of_loop = first, steps = 0;
  *loops = 0;
  do {
    const double *about = m->vertices[hsp_map_origin(m->map, of_loop)].xyz;
    uint32_t h = of_loop;
    do {
      const double swept = swept_twice(&m->edges[h / 2], about);
      twice += h % 2 == 0 ? swept : -swept;
      if (hsp_map_left(m->map, h) != face || ++steps > 2 * m->info.edges) {
        *loops = HSP_NONE;
        return 0;
      }
      h = hsp_map_next(m->map, h);
    } while (h != of_loop);
    ++*loops;
    of_loop = hsp_map_next_loop(m->map, of_loop);
  } while (of_loop != first);
  return 0.5 * twice;
}

static const char *broken_faces(const map_result *m) {
  const double largest = largest_radius(m->base), tolerance = 1e-7 * largest * largest;
  double *area = test_zeros(m->base->n, sizeof *area);
  const char *broken = NULL;
  double sum = 0;
  uint32_t f, i, loops, seen = 0;
  for (f = 0; f < m->info.faces && broken == NULL; ++f) {
    const hsp_map_face *face = &m->faces[f];
    if (face->reserved != 0) broken = "reserved of a face is not 0";
    if (face->ball != HSP_NONE && face->ball >= m->base->n) return "no such ball of a face";
    if (f == 0 && (face->ball != HSP_NONE || face->area != 0)) broken = "the unbounded face";
    if (face->h == HSP_NONE) {
      if (f > 0 || face->loops != 0 || m->info.edges > 0) broken = "a face without edges";
      continue;
    }
    {
      const double around = area_around(m, face->h, f, &loops);
      if (loops != face->loops) broken = "the number of a face's loops";
      if (f > 0 && !near(around, face->area, tolerance)) broken = "the area of a face is not that within its edges";
    }
    if (f > 0 && !(face->area > 0)) broken = "the area of a face is not positive";
    if (face->ball != HSP_NONE) {
      area[face->ball] += face->area;
      sum += face->area;
    }
  }
  if (!near(sum, m->info.area, 1e-12 * sum)) broken = "areas of faces do not sum to that of the map";
  for (i = 0; i < m->base->n; ++i) {
    if (!near(area[i], m->area[i], 1e-12 * sum)) broken = "areas of faces do not sum to those of the balls";
    seen += area[i] > 0;
  }
  if (seen != m->info.balls) broken = "the number of balls that are seen";
  free(area);
  return broken;
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

const char *broken_map(const map_result *m) {
  uint32_t invariant = 0, id = 0;
  const char *broken = broken_frame(m);
  if (broken == NULL && hsp_map_check(m->map, &invariant, &id) != HSP_OK) broken = "hsp_map_check finds something";
  if (broken == NULL && (invariant != 0 || id != HSP_NONE)) broken = "hsp_map_check reports something that is well";
  if (broken == NULL) broken = broken_steps(m);
  if (broken == NULL) broken = broken_edges(m);
  if (broken == NULL) broken = broken_vertices(m);
  if (broken == NULL) broken = broken_faces(m);
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
