/* The records of vertices, edges and simple faces, and how they cut the arcs, circles and faces of the boundary. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "topology_result.h"

static const double pi = 3.14159265358979323846;

static const char *broken_counts(const topology_result *t) {
  const hsp_topology_counts *k = &t->counts;
  const hsp_boundary_counts *b = &t->base->counts;
  if ((int64_t)k->vertices - k->edges + k->simple_faces != b->euler) {
    return "hsp_topology_get_counts, property 1: vertices - edges + simple_faces is the Euler characteristic";
  }
  if (k->vertices > k->edges || k->simple_faces > k->edges) return "more vertices or simple faces than edges";
  if (k->shells != b->shells || k->components != b->components || k->cells != 1 + b->voids) {
    return "shells, components or cells are not those of the boundary";
  }
  if ((k->start_face == HSP_NONE) != (t->base->n == 0)) return "start_face is HSP_NONE exactly without balls";
  if (k->start_face != HSP_NONE && k->start_face >= k->simple_faces) return "start_face: no such simple face";
  if (t->enlargements > 3) return "hsp_topology_get_needed: more than three enlargements";
  if (t->needed.struct_size != sizeof t->needed || t->needed.reserved != 0 || t->needed.balls != t->base->n ||
      t->needed.edges != k->edges) {
    return "hsp_topology_get_needed: not exact after HSP_OK";
  }
  return NULL;
}

static const char *broken_vertex_records(const topology_result *t) {
  const computed *c = t->base;
  uint32_t i, m, there = HSP_NONE;
  for (i = 0; i < t->counts.vertices; ++i) {
    const hsp_topology_vertex *v = t->vertices + i;
    const uint32_t balls = v->kind == HSP_POINT_VERTEX ? 3 : v->kind == HSP_POINT_CIRCLE ? 2 : 1;
    hsp_topology_vertex one;
    if (v->kind > HSP_POINT_POLE || v->reserved != 0) return "vertex: unknown kind or reserved not 0";
    if ((v->kind == HSP_POINT_VERTEX) != (i < c->counts.vertices)) return "vertex: the boundary's do not come first";
    if (i < c->counts.vertices && (memcmp(v->xyz, c->vertices[i].xyz, sizeof v->xyz) != 0 ||
                                   memcmp(v->ball, c->vertices[i].ball, sizeof v->ball) != 0)) {
      return "vertex: differs from the boundary's of this id";
    }
    for (m = 0; m < 3; ++m) {
      if (m >= balls ? v->ball[m] != HSP_NONE : v->ball[m] >= c->n) return "vertex: balls that do not suit its kind";
      if (m > 0 && m < balls && v->ball[m - 1] >= v->ball[m]) return "vertex: balls not ascending";
    }
    if (v->q >= 4 * t->counts.edges || v->q % 2 != 0 || t->origin[v->q] != i) return "vertex: q does not start there";
    if (hsp_topology_get_vertex(t->topology, i, &one) != HSP_OK || memcmp(&one, v, sizeof one) != 0) {
      return "hsp_topology_get_vertex and hsp_topology_get_vertices differ";
    }
    there = i;
  }
  return there + 1 == t->counts.vertices ? NULL : "vertices were left out";
}

static const char *broken_face_records(const topology_result *t) {
  const computed *c = t->base;
  const char *broken = NULL;
  uint32_t i;
  uint32_t *pieces = calloc((size_t)c->counts.faces + 1, sizeof *pieces);
  if (pieces == NULL) exit(2);
  for (i = 0; i < t->counts.simple_faces && broken == NULL; ++i) {
    const hsp_simple_face *f = t->faces + i;
    hsp_simple_face one;
    if (f->face >= c->counts.faces) {
      broken = "simple face: no such maximal face";
      break;
    }
    ++pieces[f->face];
    if (f->reserved != 0) broken = "simple face: reserved is not 0";
    if (f->ball != c->faces[f->face].ball) broken = "simple face: not on the ball of its maximal face";
    if (f->shell != c->faces[f->face].shell) broken = "simple face: not in the shell of its maximal face";
    if (f->edges < 2) broken = "simple face: fewer than two edges";
    if (f->q >= 4 * t->counts.edges || f->q % 2 != 0 || hsp_topology_left(t->topology, f->q) != i) {
      broken = "simple face: does not lie to the left of its q";
    }
    if (hsp_topology_get_face(t->topology, i, &one) != HSP_OK || memcmp(&one, f, sizeof one) != 0) {
      broken = "hsp_topology_get_face and hsp_topology_get_faces differ";
    }
  }
  for (i = 0; i < c->counts.faces && broken == NULL; ++i) {
    const uint32_t loops = c->faces[i].loops;
    if (loops == 0 && pieces[i] != 2) broken = "a whole sphere is not cut in two";
    if (loops == 1 && pieces[i] != 1) broken = "a face with one loop is cut";
    if (loops > 1 && pieces[i] < 2) broken = "a face with several loops is not cut into simple faces";
  }
  free(pieces);
  return broken;
}

static const char *broken_edge_records(const topology_result *t) {
  uint32_t i, e, extra = 0;
  for (i = 0; i < t->counts.edges; ++i) {
    const hsp_topology_edge *edge = t->edges + i;
    hsp_topology_edge one;
    if (edge->kind > HSP_EDGE_EXTRA) return "edge: unknown kind";
    if (edge->face[0] != hsp_topology_left(t->topology, 4 * i) || edge->face[1] != t->origin[4 * i + 1]) {
      return "edge: its faces are not what lies to its left and right";
    }
    if (edge->face[0] == edge->face[1]) return "edge: the same simple face on both sides";
    if (edge->vertex[0] != t->origin[4 * i] || edge->vertex[1] != t->origin[4 * i + 2]) {
      return "edge: its vertices are not its origin and destination";
    }
    for (e = 0; e < 2; ++e) {
      if (edge->ball[e] != t->faces[edge->face[e]].ball) return "edge: its balls are not those of its faces";
    }
    if (edge->kind == HSP_EDGE_EXTRA) {
      ++extra;
      if (edge->source != HSP_NONE) return "extra edge: has a source";
      if (edge->ball[0] != edge->ball[1] || t->faces[edge->face[0]].face != t->faces[edge->face[1]].face) {
        return "extra edge: not inside one maximal face";
      }
    } else if (edge->source >= (edge->kind == HSP_EDGE_ARC ? t->base->counts.arcs : t->base->counts.circles)) {
      return "edge: no such arc or circle";
    }
    if (hsp_topology_get_edge(t->topology, i, &one) != HSP_OK || memcmp(&one, edge, sizeof one) != 0) {
      return "hsp_topology_get_edge and hsp_topology_get_edges differ";
    }
  }
  return extra == t->counts.extra_edges ? NULL : "extra_edges is not the number of edges of that kind";
}

/* What the pieces of one arc or circle add up to. */
typedef struct pieces {
  uint32_t count;
  double angle;
} pieces;

/* An edge's left side lies on the axis's side, so with ball a on its left, the lower one, it runs against the
 * boundary's sense. `start` and `end` as the boundary has them. */
static const char *broken_piece(const topology_result *t, const hsp_topology_edge *edge, const uint32_t ball[2],
                                const uint32_t face[2], uint32_t *start, uint32_t *end) {
  const uint32_t against = edge->ball[0] == ball[0];
  if (edge->ball[against ? 0 : 1] != ball[0] || edge->ball[against ? 1 : 0] != ball[1]) {
    return "edge: not on the balls of its source";
  }
  if (t->faces[edge->face[against ? 0 : 1]].face != face[0] || t->faces[edge->face[against ? 1 : 0]].face != face[1]) {
    return "edge: not between the faces of its source";
  }
  *start = edge->vertex[against ? 1 : 0];
  *end = edge->vertex[against ? 0 : 1];
  return NULL;
}

/* The pieces of an arc or circle are as many edges, end to end: the balance of starts and ends at every vertex is that
 * of the source's ends, and the angles sum to the source's. */
static const char *broken_pieces(const topology_result *t) {
  const computed *c = t->base;
  const char *broken = NULL;
  uint32_t i, e, start = 0, end = 0;
  /* per vertex and source: the sum of hashes of the sources that start there less that of those that end there */
  uint64_t *balance = calloc((size_t)t->counts.vertices + 1, sizeof *balance);
  pieces *of_arc = calloc((size_t)c->counts.arcs + 1, sizeof *of_arc);
  pieces *of_circle = calloc((size_t)c->counts.circles + 1, sizeof *of_circle);
  if (balance == NULL || of_arc == NULL || of_circle == NULL) exit(2);
  for (i = 0; i < t->counts.edges && broken == NULL; ++i) {
    const hsp_topology_edge *edge = t->edges + i;
    pieces *of;
    uint64_t name;
    if (edge->kind == HSP_EDGE_EXTRA) continue;
    if (edge->kind == HSP_EDGE_ARC) {
      const hsp_arc *arc = c->arcs + edge->source;
      broken = broken_piece(t, edge, arc->ball, arc->face, &start, &end);
      of = of_arc + edge->source;
    } else {
      const hsp_circle *circle = c->circles + edge->source;
      broken = broken_piece(t, edge, circle->ball, circle->face, &start, &end);
      of = of_circle + edge->source;
    }
    name = (2 * (uint64_t)edge->source + (edge->kind == HSP_EDGE_ARC) + 1) * UINT64_C(0x9E3779B97F4A7C15);
    name ^= name >> 31;
    balance[start] += name;
    balance[end] -= name;
    ++of->count;
    of->angle += edge->angle;
  }
  for (i = 0; i < c->counts.arcs && broken == NULL; ++i) {
    const uint64_t name = (2 * (uint64_t)i + 2) * UINT64_C(0x9E3779B97F4A7C15);
    if (of_arc[i].count == 0) broken = "an arc without an edge";
    if (!(fabs(of_arc[i].angle - c->arcs[i].angle) <= 1e-9)) broken = "the pieces of an arc do not sum to its angle";
    for (e = 0; e < 2; ++e) balance[c->arcs[i].vertex[e]] += e == 0 ? -(name ^ name >> 31) : name ^ name >> 31;
  }
  for (i = 0; i < c->counts.circles && broken == NULL; ++i) {
    if (of_circle[i].count < 2) broken = "a free circle of fewer than two edges";
    if (!(fabs(of_circle[i].angle - 2 * pi) <= 1e-9)) broken = "the pieces of a circle do not go round it once";
  }
  for (i = 0; i < t->counts.vertices && broken == NULL; ++i) {
    if (balance[i] != 0) broken = "the pieces of an arc or circle do not follow each other";
  }
  free(balance);
  free(of_arc);
  free(of_circle);
  return broken;
}

const char *broken_cuts(const topology_result *t) {
  const char *broken = broken_counts(t);
  if (broken == NULL) broken = broken_vertex_records(t);
  if (broken == NULL) broken = broken_face_records(t);
  if (broken == NULL) broken = broken_edge_records(t);
  if (broken == NULL) broken = broken_pieces(t);
  return broken;
}
