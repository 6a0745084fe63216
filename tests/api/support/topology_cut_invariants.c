/* The records of vertices, edges and simple faces, and how they cut the arcs, circles and faces of the boundary. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "topology_invariants.h"
#include "vectors.h"

static const char *broken_counts(const topology_result *t) {
  const hsp_topology_counts *k = &t->counts;
  const hsp_boundary_counts *b = &t->base->counts;
  if ((int64_t)k->vertices - k->edges + k->simple_faces != b->euler) {
    return "hsp_topology_get_counts, property 1: vertices - edges + simple_faces is the Euler characteristic";
  }
  if (k->vertices > k->edges || k->simple_faces > k->edges) return "more vertices or simple faces than edges";
  if (k->shells != b->shells || k->components != b->components || k->regions != 1 + b->voids) {
    return "shells, components or regions are not those of the boundary";
  }
  if ((k->start_face == HSP_NONE) != (t->base->n == 0)) return "start_face is HSP_NONE exactly without balls";
  if (k->start_face != HSP_NONE && k->start_face >= k->simple_faces) return "start_face: no such simple face";
  if (t->enlargements > 3) return "hsp_topology_compute: more than three enlargements";
  if (t->needed.struct_size != sizeof t->needed || t->needed.shells != t->counts.shells ||
      t->needed.balls != t->base->n || t->needed.edges != k->edges) {
    return "hsp_topology_compute: limits not exact after HSP_OK";
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
    if (hsp_topology_get_vertices(t->topology, i, 1, &one) != HSP_OK || memcmp(&one, v, sizeof one) != 0) {
      return "hsp_topology_get_vertices: one is not that of all";
    }
    there = i;
  }
  return there + 1 == t->counts.vertices ? NULL : "vertices were left out";
}

static const char *broken_face_records(const topology_result *t) {
  const computed *c = t->base;
  const char *broken = NULL;
  uint32_t i;
  uint32_t *pieces = test_zeros(c->counts.faces, sizeof *pieces);
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
    if (hsp_topology_get_simple_faces(t->topology, i, 1, &one) != HSP_OK || memcmp(&one, f, sizeof one) != 0) {
      broken = "hsp_topology_get_simple_faces: one is not that of all";
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
    if (edge->kind > HSP_EDGE_CUT) return "edge: unknown kind";
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
    if (edge->kind == HSP_EDGE_CUT) {
      ++extra;
      if (edge->source != HSP_NONE) return "cut edge: has a source";
      if (edge->ball[0] != edge->ball[1] || t->faces[edge->face[0]].face != t->faces[edge->face[1]].face) {
        return "cut edge: not inside one maximal face";
      }
    } else if (edge->source >= (edge->kind == HSP_EDGE_ARC ? t->base->counts.arcs : t->base->counts.circles)) {
      return "edge: no such arc or circle";
    }
    if (hsp_topology_get_edges(t->topology, i, 1, &one) != HSP_OK || memcmp(&one, edge, sizeof one) != 0) {
      return "hsp_topology_get_edges: one is not that of all";
    }
  }
  return extra == t->counts.cut_edges ? NULL : "cut_edges is not the number of edges of that kind";
}

/* The left side of an edge is the side that its axis points to. So an edge with the lower ball a on its left runs
 * against the sense of the boundary's arc. `start` and `end` become its ends in the sense of the boundary. */
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

/* An edge as a piece of the arc or circle that it comes from, in the boundary's sense. */
typedef struct piece {
  uint32_t kind, source;
  uint32_t start, end; /* vertices */
  double angle;
} piece;

static int by_source_and_start(const void *a, const void *b) {
  const piece *p = a, *q = b;
  if (p->kind != q->kind) return p->kind < q->kind ? -1 : 1;
  if (p->source != q->source) return p->source < q->source ? -1 : 1;
  return p->start < q->start ? -1 : p->start > q->start;
}

/* Whether the pieces lead one after the other from a vertex to another (or around, if they are the same), each once,
 * and turn by the angle in all. */
static const char *broken_chain(const piece *pieces, uint32_t count, uint32_t from, uint32_t to, double angle) {
  piece next = pieces[0];
  uint32_t k;
  double sum = 0;
  next.start = from;
  for (k = 0; k < count; ++k) {
    const piece *found = bsearch(&next, pieces, count, sizeof *pieces, by_source_and_start);
    if (k > 0 && pieces[k].start == pieces[k - 1].start) return "two pieces of an arc or circle start at one vertex";
    if (found == NULL) return "a gap between the pieces of an arc or circle";
    next.start = found->end;
    if (next.start == to && k + 1 < count) return "pieces of an arc or circle beside those from its start to its end";
    sum += pieces[k].angle;
  }
  if (next.start != to) return "the pieces of an arc or circle do not end where it ends";
  return fabs(sum - angle) <= 1e-9 ? NULL : "the pieces of an arc or circle do not add up to its angle";
}

/* `pieces` has room for all edges; *count becomes the number of those that are pieces of arcs and circles. */
static const char *sorted_pieces(const topology_result *t, piece *pieces, uint32_t *count) {
  uint32_t i;
  *count = 0;
  for (i = 0; i < t->counts.edges; ++i) {
    const hsp_topology_edge *edge = t->edges + i;
    piece *p = pieces + *count;
    const int of_arc = edge->kind == HSP_EDGE_ARC;
    const char *broken;
    if (edge->kind == HSP_EDGE_CUT) continue;
    broken = broken_piece(t, edge, of_arc ? t->base->arcs[edge->source].ball : t->base->circles[edge->source].ball,
                          of_arc ? t->base->arcs[edge->source].face : t->base->circles[edge->source].face, &p->start,
                          &p->end);
    if (broken != NULL) return broken;
    p->kind = edge->kind;
    p->source = edge->source;
    p->angle = edge->angle;
    ++*count;
  }
  qsort(pieces, *count, sizeof *pieces, by_source_and_start);
  return NULL;
}

/* Every arc is one chain of edges, every free circle one ring of at least two. */
static const char *broken_pieces(const topology_result *t) {
  const computed *c = t->base;
  uint32_t i, count = 0, first = 0, arcs = 0, circles = 0;
  piece *pieces = test_zeros(t->counts.edges, sizeof *pieces);
  const char *broken;
  broken = sorted_pieces(t, pieces, &count);
  for (i = 0; i < count && broken == NULL; ++i) {
    const piece *p = pieces + i;
    if (i + 1 < count && p[1].kind == p->kind && p[1].source == p->source) continue;
    if (p->kind == HSP_EDGE_ARC) {
      const hsp_arc *arc = c->arcs + p->source;
      broken = broken_chain(pieces + first, i + 1 - first, arc->vertex[0], arc->vertex[1], arc->angle);
      ++arcs;
    } else {
      if (i == first) broken = "a free circle of fewer than two edges";
      if (broken == NULL) broken = broken_chain(pieces + first, i + 1 - first, p->start, p->start, 2 * pi);
      ++circles;
    }
    first = i + 1;
  }
  if (broken == NULL && (arcs != c->counts.arcs || circles != c->counts.circles)) {
    broken = "an arc or circle without an edge";
  }
  free(pieces);
  return broken;
}

/* Every maximal face of so many loops falls apart into discs: vertices inside it - cut edges + simple faces =
 * 2 - loops. Poles, and no other vertices, lie inside maximal faces: all their edges are extra. */
static const char *broken_discs(const topology_result *t) {
  const computed *c = t->base;
  const char *broken = NULL;
  uint32_t i, e;
  uint8_t *on_boundary = test_zeros(t->counts.vertices, 1);
  int64_t *euler = test_zeros(c->counts.faces, sizeof *euler);
  for (i = 0; i < t->counts.simple_faces; ++i) ++euler[t->faces[i].face];
  for (i = 0; i < t->counts.edges; ++i) {
    const hsp_topology_edge *edge = t->edges + i;
    if (edge->kind == HSP_EDGE_CUT) --euler[t->faces[edge->face[0]].face];
    for (e = 0; e < 2; ++e) on_boundary[edge->vertex[e]] |= edge->kind != HSP_EDGE_CUT;
  }
  for (i = 0; i < t->counts.vertices && broken == NULL; ++i) {
    if (on_boundary[i] == (t->vertices[i].kind == HSP_POINT_POLE)) {
      broken = "vertex: a pole on an arc or circle, or another one inside a maximal face";
    }
    if (!on_boundary[i]) ++euler[t->faces[t->edges[t->vertices[i].q / 4].face[0]].face];
  }
  for (i = 0; i < c->counts.faces && broken == NULL; ++i) {
    if (euler[i] != 2 - (int64_t)c->faces[i].loops) broken = "a maximal face is not cut into discs";
  }
  free(on_boundary);
  free(euler);
  return broken;
}

const char *broken_topology_cuts(const topology_result *t) {
  const char *broken = broken_counts(t);
  if (broken == NULL) broken = broken_vertex_records(t);
  if (broken == NULL) broken = broken_face_records(t);
  if (broken == NULL) broken = broken_edge_records(t);
  if (broken == NULL) broken = broken_pieces(t);
  if (broken == NULL) broken = broken_discs(t);
  return broken;
}
