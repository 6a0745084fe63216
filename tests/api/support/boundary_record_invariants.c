/* The header's promises about the records of a boundary and how they refer to each other. Properties have the numbers
 * that hardsphere.h gives them. Which balls meet is taken from hsp_query_neighbours, not computed anew. */
#include <stdlib.h>
#include <string.h>

#include "boundary_invariants.h"

/* ---- classes: a plain union-find over 0 .. n-1 ---- */

static uint32_t *classes_start(uint32_t n) {
  uint32_t i;
  uint32_t *parent = test_zeros(n, sizeof *parent);
  for (i = 0; i < n; ++i) parent[i] = i;
  return parent;
}

static uint32_t classes_find(uint32_t *parent, uint32_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

static void classes_join(uint32_t *parent, uint32_t i, uint32_t j) {
  parent[classes_find(parent, i)] = classes_find(parent, j);
}

/* Whether label(i) = label(j) exactly for i, j of one class, and the labels are 0 .. labels-1, each used. */
static int labels_are_classes(uint32_t *parent, uint32_t n, const uint32_t *label, uint32_t labels) {
  uint32_t i, roots = 0;
  int good = 1;
  uint32_t *of_label = test_zeros(labels, sizeof *of_label);
  for (i = 0; i < labels; ++i) of_label[i] = HSP_NONE;
  for (i = 0; i < n && good; ++i) {
    const uint32_t root = classes_find(parent, i);
    if (root == i) ++roots;
    if (label[i] >= labels) {
      good = 0;
    } else if (of_label[label[i]] == HSP_NONE) {
      of_label[label[i]] = root;
    } else if (of_label[label[i]] != root) {
      good = 0;
    }
  }
  free(of_label);
  return good && roots == labels;
}

static const char *broken_counts(const computed *c) {
  const hsp_boundary_counts *k = &c->counts;
  if (k->balls != c->n) return "counts.balls is not n";
  if (k->euler != (int64_t)k->vertices - k->arcs + 2 * (int64_t)k->faces - k->loops) {
    return "hsp_boundary_get_counts, property 1: euler = vertices - arcs + 2 faces - loops";
  }
  if (k->voids + k->components != k->shells) {
    return "hsp_boundary_get_counts, property 2: voids = shells - components";
  }
  if (2 * (uint64_t)k->arcs != 3 * (uint64_t)k->vertices) {
    return "hsp_boundary_get_counts, property 3: 2 arcs = 3 vertices";
  }
  if (k->euler % 2 != 0 || k->euler > 2 * (int64_t)k->shells) return "euler is not a sum of 2 - 2 genus over shells";
  if (c->n > 0 && (k->components == 0 || k->faces == 0)) return "balls without component or face";
  return NULL;
}

static const char *broken_vertices(const computed *c) {
  uint32_t i, tied = 0;
  for (i = 0; i < c->counts.vertices; ++i) {
    const hsp_vertex *v = c->vertices + i;
    if (!(v->ball[0] < v->ball[1] && v->ball[1] < v->ball[2] && v->ball[2] < c->n)) return "vertex: not a < b < c < n";
    if (v->sign != 1 && v->sign != -1) return "vertex: sign is neither +1 nor -1";
    if ((v->flags & ~HSP_VERTEX_TIED) != 0 || v->reserved != 0) return "vertex: unknown flags or reserved not 0";
    if (v->flags & HSP_VERTEX_TIED) ++tied;
  }
  if (tied != c->counts.tied_vertices) return "tied_vertices is not the number of vertices with HSP_VERTEX_TIED";
  return NULL;
}

static int vertex_has(const hsp_vertex *v, uint32_t ball) {
  return v->ball[0] == ball || v->ball[1] == ball || v->ball[2] == ball;
}

static const char *broken_arcs(const computed *c, uint32_t *ends_of_vertex) {
  uint32_t i, e;
  for (i = 0; i < c->counts.arcs; ++i) {
    const hsp_arc *arc = c->arcs + i;
    if (!(arc->ball[0] < arc->ball[1] && arc->ball[1] < c->n)) return "arc: not a < b < n";
    for (e = 0; e < 2; ++e) {
      if (arc->vertex[e] >= c->counts.vertices) return "arc: no such vertex";
      if (!vertex_has(c->vertices + arc->vertex[e], arc->ball[0]) ||
          !vertex_has(c->vertices + arc->vertex[e], arc->ball[1])) {
        return "arc: its vertex does not lie on both balls";
      }
      if (arc->face[e] >= c->counts.faces || c->faces[arc->face[e]].ball != arc->ball[e]) {
        return "arc: its face does not lie on its ball";
      }
      ++ends_of_vertex[arc->vertex[e]];
    }
  }
  for (i = 0; i < c->counts.vertices; ++i) {
    if (ends_of_vertex[i] != 3) return "hsp_boundary_get_vertices, property 1: each vertex ends exactly three arcs";
  }
  return NULL;
}

static const char *broken_circles(const computed *c) {
  uint32_t i, e;
  for (i = 0; i < c->counts.circles; ++i) {
    const hsp_circle *circle = c->circles + i;
    if (!(circle->ball[0] < circle->ball[1] && circle->ball[1] < c->n)) return "circle: not a < b < n";
    for (e = 0; e < 2; ++e) {
      if (circle->face[e] >= c->counts.faces || c->faces[circle->face[e]].ball != circle->ball[e]) {
        return "circle: its face does not lie on its ball";
      }
    }
  }
  return NULL;
}

static const char *broken_balls(const computed *c) {
  uint32_t i, f, exposed = 0, inside = 0, faces = 0;
  for (i = 0; i < c->n; ++i) {
    const hsp_ball *ball = c->balls + i;
    if ((ball->flags & ~HSP_BALL_CONTAINED) != 0) return "ball: unknown flags";
    if (ball->flags & HSP_BALL_CONTAINED) ++inside;
    if ((ball->flags & HSP_BALL_CONTAINED) != 0 && ball->faces != 0) return "ball: contained in another, but exposed";
    faces += ball->faces;
    if (ball->faces == 0) {
      if (ball->first_face != HSP_NONE) return "ball: buried, but first_face is not HSP_NONE";
      continue;
    }
    ++exposed;
    if (ball->first_face >= c->counts.faces || ball->faces > c->counts.faces - ball->first_face) {
      return "ball: faces that do not exist";
    }
    for (f = 0; f < ball->faces; ++f) {
      if (c->faces[ball->first_face + f].ball != i) return "faces of one ball are not consecutive from first_face";
    }
  }
  if (faces != c->counts.faces) return "the balls' numbers of faces do not sum to counts.faces";
  if (exposed != c->counts.exposed_balls) return "exposed_balls is not the number of balls with a face";
  if (inside != c->counts.contained_balls) return "contained_balls is not the number of balls with the flag";
  return NULL;
}

/* On one face a vertex is passed by at most one loop, so loops are the classes of the face's arcs that share vertices,
 * and its free circles. A union-find over (arc, side) pairs counts them. */
static const char *broken_loops(const computed *c) {
  const uint32_t sides = 2 * c->counts.arcs;
  const char *broken = NULL;
  uint32_t i, e, s;
  uint64_t all = 0;
  uint32_t *side_class = classes_start(sides);
  uint32_t *loops = test_zeros(c->counts.faces, sizeof *loops);
  uint32_t *passing = test_zeros(3 * (size_t)c->counts.vertices, sizeof *passing);
  /* passing[3 v + m]: a side at vertex v whose ball is the m-th of the vertex; the second one seen closes the corner */
  for (i = 0; i < 3 * c->counts.vertices; ++i) passing[i] = HSP_NONE;
  for (s = 0; s < sides && broken == NULL; ++s) {
    const hsp_arc *arc = c->arcs + s / 2;
    for (e = 0; e < 2; ++e) {
      const hsp_vertex *v = c->vertices + arc->vertex[e];
      const uint32_t m = v->ball[0] == arc->ball[s % 2] ? 0 : v->ball[1] == arc->ball[s % 2] ? 1 : 2;
      uint32_t *seen = passing + 3 * arc->vertex[e] + m;
      if (*seen == HSP_NONE) {
        *seen = s;
        continue;
      }
      if (c->arcs[*seen / 2].face[*seen % 2] != arc->face[s % 2]) broken = "two arcs meet at a corner of two faces";
      classes_join(side_class, *seen, s);
    }
  }
  for (s = 0; s < sides; ++s) {
    if (classes_find(side_class, s) == s) ++loops[c->arcs[s / 2].face[s % 2]];
  }
  for (i = 0; i < c->counts.circles; ++i) {
    for (e = 0; e < 2; ++e) ++loops[c->circles[i].face[e]];
  }
  for (i = 0; i < c->counts.faces && broken == NULL; ++i) {
    all += loops[i];
    if (loops[i] != c->faces[i].loops) broken = "face: loops is not the number of its boundary loops";
  }
  if (broken == NULL && all != c->counts.loops) broken = "counts.loops is not the sum over the faces";
  free(side_class);
  free(loops);
  free(passing);
  return broken;
}

/* A loop whose arcs begin at `place` of the list. */
static const char *broken_loop_of_arcs(const computed *c, const hsp_loop *loop, uint32_t place) {
  uint32_t i;
  if (loop->arcs < 2 || loop->arcs > 2 * c->counts.arcs - place) return "loop: one arc, or more than there are";
  if (loop->side != 0) return "loop: of arcs, but with a circle's side";
  for (i = 0; i < loop->arcs; ++i) {
    const hsp_loop_arc *at = c->loop_arcs + place + i, *next = c->loop_arcs + place + (i + 1) % loop->arcs;
    const hsp_arc *arc;
    if (at->arc >= c->counts.arcs || at->side > 1) return "loop: no such arc or side";
    arc = c->arcs + at->arc;
    if (arc->face[at->side] != loop->face) return "loop: an arc's side does not border its face";
    if (at->vertex != arc->vertex[1 - at->side]) return "loop: does not come to an arc where the arc's side begins";
    if (next->vertex != arc->vertex[at->side]) {
      return "hsp_boundary_get_loop_arcs, property 1: each ends at the vertex of the next";
    }
  }
  return NULL;
}

static const char *broken_loop_of_circle(const computed *c, const hsp_loop *loop) {
  if (loop->arcs != 0) return "loop: a circle with arcs";
  if (loop->circle >= c->counts.circles || loop->side > 1) return "loop: no such circle or side";
  return c->circles[loop->circle].face[loop->side] == loop->face ? NULL : "loop: a circle's side is not its face";
}

/* The lists of loops and their arcs. With broken_loops, which counts the loops of a face, no loop is in two parts. */
static const char *broken_loop_lists(const computed *c) {
  const char *broken = NULL;
  uint32_t i, place = 0, expected = 0;
  uint8_t *seen_arc = test_zeros(2 * (size_t)c->counts.arcs, 1);
  uint8_t *seen_circle = test_zeros(2 * (size_t)c->counts.circles, 1);
  for (i = 0; i < c->counts.faces && broken == NULL; ++i) {
    if (c->faces[i].first_loop != expected) broken = "face: first_loop is not behind the loops of the faces before";
    expected += c->faces[i].loops;
  }
  for (i = 0; i < c->counts.loops && broken == NULL; ++i) {
    const hsp_loop *loop = c->loops + i;
    if (loop->face >= c->counts.faces || i - c->faces[loop->face].first_loop >= c->faces[loop->face].loops) {
      broken = "loop: not one of its face";
    } else if (loop->first_arc != place) {
      broken = "loop: first_arc is not behind the arcs of the loops before";
    } else {
      broken = loop->circle == HSP_NONE ? broken_loop_of_arcs(c, loop, place) : broken_loop_of_circle(c, loop);
    }
    place += loop->arcs;
    if (broken == NULL && loop->circle != HSP_NONE && seen_circle[2 * loop->circle + loop->side]++ != 0) {
      broken = "loops: a circle's side twice";
    }
  }
  if (broken == NULL && place != 2 * c->counts.arcs) broken = "the loops' arcs are not twice counts.arcs";
  for (i = 0; i < place && broken == NULL; ++i) {
    if (seen_arc[2 * c->loop_arcs[i].arc + c->loop_arcs[i].side]++ != 0) {
      broken = "hsp_boundary_get_loop_arcs, property 2: every arc once with either side";
    }
  }
  free(seen_arc);
  free(seen_circle);
  return broken;
}

static const char *broken_shells(const computed *c) {
  const uint32_t faces = c->counts.faces;
  int good;
  uint32_t i;
  uint32_t *face_class = classes_start(faces);
  uint32_t *label = test_zeros(faces, sizeof *label);
  for (i = 0; i < c->counts.arcs; ++i) classes_join(face_class, c->arcs[i].face[0], c->arcs[i].face[1]);
  for (i = 0; i < c->counts.circles; ++i) classes_join(face_class, c->circles[i].face[0], c->circles[i].face[1]);
  for (i = 0; i < faces; ++i) label[i] = c->faces[i].shell;
  good = labels_are_classes(face_class, faces, label, c->counts.shells);
  free(face_class);
  free(label);
  return good ? NULL : "shells are not the connected components of the boundary";
}

/* The components by a union-find over the neighbours that the library names; the properties of neighbours are checked
 * on the way. */
static const char *broken_components(const computed *c) {
  const char *broken = NULL;
  uint32_t i, j, needed, most = 0;
  int good;
  uint32_t *ball_class = classes_start(c->n);
  uint32_t *ids = test_zeros(c->n, sizeof *ids);
  uint32_t *label = test_zeros(c->n, sizeof *label);
  uint64_t balance = 0; /* sum of a hash of (i, j) minus that of (j, i) */
  for (i = 0; i < c->n && broken == NULL; ++i) {
    label[i] = c->balls[i].component;
    if (hsp_query_neighbours(c->model, i, ids, c->n, &needed) != HSP_OK) {
      broken = "hsp_query_neighbours fails with room for all balls";
      break;
    }
    if (needed > most) most = needed;
    for (j = 0; j < needed && broken == NULL; ++j) {
      const uint64_t there = ((uint64_t)i << 32 | ids[j]) * UINT64_C(0x9E3779B97F4A7C15);
      const uint64_t back = ((uint64_t)ids[j] << 32 | i) * UINT64_C(0x9E3779B97F4A7C15);
      if (ids[j] >= c->n || ids[j] == i) broken = "neighbours: an id that is no other ball";
      if (j > 0 && ids[j - 1] >= ids[j]) broken = "neighbours: not ascending without duplicates";
      if (broken == NULL) classes_join(ball_class, i, ids[j]);
      balance += (there ^ there >> 29) - (back ^ back >> 29);
    }
  }
  if (broken == NULL && balance != 0) {
    broken = "hsp_query_neighbours, property 1: j is listed for i exactly if i is listed for j";
  }
  if (broken == NULL && most != c->needed.neighbours) {
    broken = "needed.neighbours is not the largest number of balls that meet one ball";
  }
  if (broken == NULL) {
    good = labels_are_classes(ball_class, c->n, label, c->counts.components);
    if (!good) broken = "components are not the connected components of the union";
  }
  free(ball_class);
  free(ids);
  free(label);
  return broken;
}

/* The library's check of itself must agree with the checks from outside. */
static const char *broken_own_check(const computed *c) {
  uint32_t invariant = 77, id = 77;
  const int32_t status = hsp_boundary_check(c->boundary, &invariant, &id);
  return broken_by_own_check(status, invariant, id);
}

const char *broken_boundary_records(const computed *c) {
  uint32_t *ends = test_zeros(c->counts.vertices, sizeof *ends);
  const char *broken = broken_counts(c);
  if (c->enlargements > 2) broken = "hsp_boundary_compute: more than two enlargements";
  if (broken == NULL && (c->needed.balls != c->n || c->needed.vertices != c->counts.vertices ||
                         c->needed.circles != c->counts.circles || c->needed.workers != 0)) {
    broken = "hsp_boundary_compute: limits not exact after HSP_OK";
  }
  if (broken == NULL) broken = broken_vertices(c);
  if (broken == NULL) broken = broken_arcs(c, ends);
  if (broken == NULL) broken = broken_circles(c);
  if (broken == NULL) broken = broken_balls(c);
  if (broken == NULL) broken = broken_loops(c);
  if (broken == NULL) broken = broken_loop_lists(c);
  if (broken == NULL) broken = broken_shells(c);
  if (broken == NULL) broken = broken_components(c);
  free(ends);
  if (broken == NULL) broken = broken_own_check(c);
  return broken;
}
