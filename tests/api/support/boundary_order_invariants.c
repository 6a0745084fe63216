/* "The order of the balls has no effect but on the ids": two results are brought into a form without ids and compared
 * byte for byte. In this form a ball is named by the first ball of `result` with the same centre and radius, and
 * records are sorted. */
#include <stdlib.h>
#include <string.h>

#include "boundary_invariants.h"

/* Everything about one vertex, arc, circle, face or ball; fields that a kind of record does not have stay 0. */
typedef struct plain_record {
  uint32_t name[12];
  double number[14];
} plain_record;

typedef struct plain_form {
  plain_record *vertices;
  plain_record *arcs;
  plain_record *circles;
  plain_record *faces;
  plain_record *balls;
} plain_form;

static int by_bytes(const void *a, const void *b) {
  return memcmp(a, b, sizeof(plain_record));
}

static uint32_t class_of(const computed *c, uint32_t ball) {
  uint32_t i;
  for (i = 0; i < ball; ++i) {
    if (c->radius[i] == c->radius[ball] && c->xyz[3 * i] == c->xyz[3 * ball] &&
        c->xyz[3 * i + 1] == c->xyz[3 * ball + 1] && c->xyz[3 * i + 2] == c->xyz[3 * ball + 2]) {
      return i;
    }
  }
  return ball;
}

/* +0 for both zeros: negating a coordinate must not make a difference. */
static double number(double x) {
  return x == 0 ? 0.0 : x;
}

static void plain_vertex(const hsp_vertex *v, const uint32_t *class_of_ball, plain_record *plain) {
  uint32_t m[3];
  int32_t sign = v->sign;
  int i, j;
  for (i = 0; i < 3; ++i) m[i] = class_of_ball[v->ball[i]];
  for (i = 0; i < 2; ++i) {
    for (j = 0; j < 2 - i; ++j) {
      if (m[j] > m[j + 1]) {
        const uint32_t kept = m[j];
        m[j] = m[j + 1];
        m[j + 1] = kept;
        sign = -sign; /* an odd permutation turns the plane's normal round */
      }
    }
  }
  for (i = 0; i < 3; ++i) plain->name[i] = m[i];
  plain->name[3] = sign > 0;
  plain->name[4] = v->flags;
  for (i = 0; i < 3; ++i) plain->number[i] = number(v->xyz[i]);
}

static plain_form plain_form_of(const computed *c, const uint32_t *class_of_ball) {
  plain_form form;
  uint32_t i, e;
  uint32_t *faces_of_shell = test_zeros(c->counts.shells, sizeof *faces_of_shell);
  form.vertices = test_zeros(c->counts.vertices, sizeof(plain_record));
  form.arcs = test_zeros(c->counts.arcs, sizeof(plain_record));
  form.circles = test_zeros(c->counts.circles, sizeof(plain_record));
  form.faces = test_zeros(c->counts.faces, sizeof(plain_record));
  form.balls = test_zeros(c->n, sizeof(plain_record));
  for (i = 0; i < c->counts.vertices; ++i) plain_vertex(c->vertices + i, class_of_ball, form.vertices + i);
  for (i = 0; i < c->counts.arcs; ++i) {
    const hsp_arc *arc = c->arcs + i;
    const uint32_t a = class_of_ball[arc->ball[0]], b = class_of_ball[arc->ball[1]];
    const uint32_t swapped = a > b; /* then the axis points the other way and the arc runs backwards */
    plain_record *plain = form.arcs + i;
    plain->name[0] = swapped ? b : a;
    plain->name[1] = swapped ? a : b;
    for (e = 0; e < 2; ++e) {
      const uint32_t there = swapped ? 1 - e : e;
      plain_record end;
      memset(&end, 0, sizeof end);
      plain_vertex(c->vertices + arc->vertex[there], class_of_ball, &end);
      memcpy(plain->name + 2 + 4 * e, end.name, 4 * sizeof end.name[0]);
      memcpy(plain->number + 3 * e, end.number, 3 * sizeof end.number[0]);
      plain->name[10 + e] = c->faces[arc->face[there]].loops;
    }
    plain->number[6] = number(arc->angle);
    for (e = 0; e < 3; ++e) {
      plain->number[7 + e] = number(arc->centre[e]);
      plain->number[10 + e] = number(swapped ? -arc->axis[e] : arc->axis[e]);
    }
    plain->number[13] = number(arc->radius);
  }
  for (i = 0; i < c->counts.circles; ++i) {
    const hsp_circle *circle = c->circles + i;
    const uint32_t a = class_of_ball[circle->ball[0]], b = class_of_ball[circle->ball[1]];
    plain_record *plain = form.circles + i;
    plain->name[0] = a < b ? a : b;
    plain->name[1] = a < b ? b : a;
    for (e = 0; e < 3; ++e) {
      plain->number[e] = number(circle->centre[e]);
      plain->number[3 + e] = number(a < b ? circle->axis[e] : -circle->axis[e]);
    }
    plain->number[6] = number(circle->radius);
  }
  for (i = 0; i < c->counts.faces; ++i) ++faces_of_shell[c->faces[i].shell];
  for (i = 0; i < c->counts.faces; ++i) {
    form.faces[i].name[0] = class_of_ball[c->faces[i].ball];
    form.faces[i].name[1] = c->faces[i].loops;
    form.faces[i].name[2] = faces_of_shell[c->faces[i].shell];
  }
  for (i = 0; i < c->n; ++i) {
    form.balls[i].name[0] = class_of_ball[i];
    form.balls[i].name[1] = c->balls[i].faces;
    form.balls[i].name[2] = c->balls[i].flags;
    form.balls[i].number[0] = c->area[i];
    form.balls[i].number[1] = c->volume[i];
  }
  qsort(form.vertices, c->counts.vertices, sizeof(plain_record), by_bytes);
  qsort(form.arcs, c->counts.arcs, sizeof(plain_record), by_bytes);
  qsort(form.circles, c->counts.circles, sizeof(plain_record), by_bytes);
  qsort(form.faces, c->counts.faces, sizeof(plain_record), by_bytes);
  qsort(form.balls, c->n, sizeof(plain_record), by_bytes);
  free(faces_of_shell);
  return form;
}

static void plain_form_release(plain_form *form) {
  free(form->vertices);
  free(form->arcs);
  free(form->circles);
  free(form->faces);
  free(form->balls);
}

static int same(const plain_record *a, const plain_record *b, uint32_t count) {
  return memcmp(a, b, count * sizeof *a) == 0;
}

const char *boundary_difference_after_permutation(const computed *a, const computed *b, const uint32_t *order) {
  const char *what = NULL;
  plain_form form_a, form_b;
  uint32_t i;
  uint32_t *class_a = test_zeros(a->n, sizeof *class_a);
  uint32_t *class_b = test_zeros(a->n, sizeof *class_b);
  if (a->n != b->n || memcmp(&a->counts, &b->counts, sizeof a->counts) != 0) {
    free(class_a);
    free(class_b);
    return "the counts differ";
  }
  for (i = 0; i < a->n; ++i) class_a[i] = class_of(a, i);
  for (i = 0; i < a->n; ++i) class_b[i] = class_a[order[i]];
  form_a = plain_form_of(a, class_a);
  form_b = plain_form_of(b, class_b);
  if (!same(form_a.vertices, form_b.vertices, a->counts.vertices)) what = "the vertices differ";
  if (what == NULL && !same(form_a.arcs, form_b.arcs, a->counts.arcs)) what = "the arcs differ";
  if (what == NULL && !same(form_a.circles, form_b.circles, a->counts.circles)) what = "the circles differ";
  if (what == NULL && !same(form_a.faces, form_b.faces, a->counts.faces)) what = "the faces differ";
  if (what == NULL && !same(form_a.balls, form_b.balls, a->n)) what = "the balls' areas, volumes or flags differ";
  plain_form_release(&form_a);
  plain_form_release(&form_b);
  free(class_a);
  free(class_b);
  return what;
}
