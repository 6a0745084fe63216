#include "map_record_invariants.h"

#include <math.h>
#include <stdlib.h>

#include "handle_kind.h"
#include "vectors.h"

static uint32_t bodies_of(const map_records *m) {
  return m->balls + 2 * m->sticks;
}

static uint32_t origin_of(const map_records *m, uint32_t h) {
  return m->edges[h / 2].vertex[h % 2];
}

static const char *broken_frame(const map_records *m) {
  const hsp_map_info *info = m->info;
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

static const char *broken_steps(const map_records *m) {
  uint32_t *reached = test_zeros(2 * (size_t)m->info->edges, sizeof *reached);
  const char *broken = NULL;
  uint32_t h;
  for (h = 0; h < 2 * m->info->edges && broken == NULL; ++h) {
    const hsp_map_edge *edge = &m->edges[h / 2];
    const uint32_t next = edge->next[h % 2];
    if (edge->vertex[h % 2] >= m->info->vertices || edge->face[h % 2] >= m->info->faces) {
      broken = "no such vertex or face";
    } else if (next >= 2 * m->info->edges || ++reached[next] > 1) {
      broken = "next is no directed edge, or that of two";
    } else if (m->edges[next / 2].face[next % 2] != edge->face[h % 2]) {
      broken = "the face changes along a loop";
    } else if (origin_of(m, next) != edge->vertex[1 - h % 2]) {
      broken = "next does not start where a directed edge ends";
    }
  }
  free(reached);
  return broken;
}

static double on_edge(const hsp_map_edge *edge, double t, int axis) {
  return edge->centre[axis] + cos(t) * edge->first[axis] + sin(t) * edge->second[axis];
}

static const char *broken_edges(const map_records *m) {
  const double tolerance = 1e-5 * m->largest + 1e-12 * m->extent;
  uint32_t e;
  int end, axis;
  for (e = 0; e < m->info->edges; ++e) {
    const hsp_map_edge *edge = &m->edges[e];
    if (!(edge->from <= edge->to && edge->to - edge->from <= 2 * pi + 1e-15)) return "parameters of an edge";
    if (!(edge->from >= -3 * pi && edge->from <= pi)) return "an edge begins beyond pi or before -3 pi";
    if (fabs(edge->first[0] * edge->second[0] + edge->first[1] * edge->second[1]) >
        1e-12 * tolerance * tolerance * 1e10)
      return "the semi-axes of an edge are not at right angles";
    if (edge->first[0] * edge->second[1] - edge->first[1] * edge->second[0] < 0) return "an edge turns clockwise";
    if (edge->ball[0] >= bodies_of(m)) return "no such body on the left of an edge";
    if (m->faces[edge->face[0]].ball != edge->ball[0]) return "another body on the left of an edge";
    if (edge->ball[1] != HSP_NONE && m->faces[edge->face[1]].ball != edge->ball[1])
      return "another body on the right of a crease";
    for (end = 0; end < 2; ++end) {
      const double t = end == 0 ? edge->from : edge->to;
      for (axis = 0; axis < 2; ++axis) {
        if (!near(on_edge(edge, t, axis), m->vertices[edge->vertex[end]].xyz[axis], tolerance))
          return "an edge does not end at its vertex";
      }
    }
  }
  return NULL;
}

static const char *broken_vertices(const map_records *m) {
  uint32_t v, k;
  for (v = 0; v < m->info->vertices; ++v) {
    const hsp_map_vertex *vertex = &m->vertices[v];
    const uint32_t most = vertex->kind == HSP_MAP_PLAIN || vertex->kind == HSP_MAP_TANGENCY ? 2 : 3;
    uint32_t h = vertex->h;
    for (k = 0; k < most; ++k) {
      if (h >= 2 * m->info->edges || origin_of(m, h) != v) return "a directed edge of a vertex starts elsewhere";
      h = m->edges[h / 2].next[1 - h % 2];
    }
    if (h != vertex->h) return "the number of edges of a vertex";
    if (vertex->kind > (m->sticks > 0 ? HSP_MAP_HALVES : HSP_MAP_TANGENCY)) return "the kind of a vertex";
    if (vertex->reserved != 0) return "reserved of a vertex is not 0";
  }
  return NULL;
}

/* Twice the area that a directed edge sweeps about a point: a triangle for a straight edge, else by Gauss's quadrature
 * over short parts of the edge. */
static double swept_twice(const hsp_map_edge *edge, const double about[2]) {
  static const double node = 0.57735026918962576451;
  enum { PARTS = 64 };
  const double step = (edge->to - edge->from) / PARTS;
  double sum = 0;
  int part, side;
  if (edge->second[0] == 0 && edge->second[1] == 0) {
    return (on_edge(edge, edge->from, 0) - about[0]) * (on_edge(edge, edge->to, 1) - about[1]) -
           (on_edge(edge, edge->from, 1) - about[1]) * (on_edge(edge, edge->to, 0) - about[0]);
  }
  for (part = 0; part < PARTS; ++part) {
    for (side = -1; side <= 1; side += 2) {
      const double t = edge->from + step * (part + 0.5 + 0.5 * side * node);
      const double x = on_edge(edge, t, 0) - about[0];
      const double y = on_edge(edge, t, 1) - about[1];
      const double dx = cos(t) * edge->second[0] - sin(t) * edge->first[0];
      const double dy = cos(t) * edge->second[1] - sin(t) * edge->first[1];
      sum += 0.5 * step * (x * dy - y * dx);
    }
  }
  return sum;
}

/* Adds the area within each loop to that of its face, and counts the loops. */
static void add_loops(const map_records *m, double *area, uint32_t *loops) {
  uint32_t *seen = test_zeros(2 * (size_t)m->info->edges, sizeof *seen);
  uint32_t first;
  for (first = 0; first < 2 * m->info->edges; ++first) {
    const double *about = m->vertices[origin_of(m, first)].xyz;
    const uint32_t face = m->edges[first / 2].face[first % 2];
    uint32_t h;
    for (h = first; !seen[h]; h = m->edges[h / 2].next[h % 2]) {
      const double twice = swept_twice(&m->edges[h / 2], about);
      area[face] += h % 2 == 0 ? 0.5 * twice : -0.5 * twice;
      if (h == first) ++loops[face];
      seen[h] = 1;
    }
  }
  free(seen);
}

static const char *broken_face(const map_records *m, uint32_t f, double area, uint32_t loops) {
  const hsp_map_face *face = &m->faces[f];
  if (face->reserved != 0) return "reserved of a face is not 0";
  if (face->ball != HSP_NONE && face->ball >= bodies_of(m)) return "no such body of a face";
  if (loops != face->loops) return "the number of a face's loops";
  if (f == 0) {
    if (face->ball != HSP_NONE || face->area != 0) return "the unbounded face";
    if (m->info->edges == 0) return face->h == HSP_NONE ? NULL : "a directed edge where there is none";
  }
  if (face->h >= 2 * m->info->edges || m->edges[face->h / 2].face[face->h % 2] != f)
    return "the directed edge of a face is another's";
  if (f > 0 && !near(area, face->area, 1e-7 * m->largest * m->largest + 2e-9 * face->area))
    return "the area of a face is not that within its edges";
  return f == 0 || face->area > 0 ? NULL : "the area of a face is not positive";
}

static const char *broken_sums(const map_records *m) {
  double *left = test_zeros(bodies_of(m), sizeof *left);
  const char *broken = NULL;
  double sum = 0;
  uint32_t f, i, seen = 0;
  for (i = 0; i < bodies_of(m); ++i) left[i] = m->area[i];
  for (f = 0; f < m->info->faces; ++f) {
    if (m->faces[f].ball == HSP_NONE) continue;
    left[m->faces[f].ball] -= m->faces[f].area;
    sum += m->faces[f].area;
  }
  if (!near(sum, m->info->area, 1e-12 * sum)) broken = "areas of faces do not sum to that of the map";
  for (i = 0; i < bodies_of(m); ++i) {
    if (!near(left[i], 0, 1e-12 * sum)) broken = "areas of faces do not sum to those of the bodies";
    seen += i < m->balls && m->area[i] > 0;
  }
  if (seen != m->info->balls) broken = "the number of balls that are seen";
  free(left);
  return broken;
}

static const char *broken_faces(const map_records *m) {
  double *area = test_zeros(m->info->faces, sizeof *area);
  uint32_t *loops = test_zeros(m->info->faces, sizeof *loops);
  const char *broken = NULL;
  uint32_t f;
  add_loops(m, area, loops);
  for (f = 0; f < m->info->faces && broken == NULL; ++f) broken = broken_face(m, f, area[f], loops[f]);
  free(area);
  free(loops);
  return broken == NULL ? broken_sums(m) : broken;
}

const char *broken_map_records(const map_records *m) {
  const char *broken = broken_frame(m);
  if (broken == NULL) broken = broken_steps(m);
  if (broken == NULL) broken = broken_edges(m);
  if (broken == NULL) broken = broken_vertices(m);
  if (broken == NULL) broken = broken_faces(m);
  return broken;
}
