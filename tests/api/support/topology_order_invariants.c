/* "The order of the balls has no effect but on ids": two topologies are brought into a form without ids, named by
 * positions, sorted, and compared. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "topology_invariants.h"

enum { WORDS = 16 };

/* A record without ids; unused words stay 0. */
typedef struct plain_record {
  uint64_t word[WORDS];
  double size[2]; /* a shell's area and volume, the same up to rounding only */
} plain_record;

typedef struct plain_form {
  plain_record *vertices, *edges, *faces, *shells;
  uint64_t start; /* the simple face where the scan of the outermost highest shell starts */
} plain_form;

static int by_words(const void *a, const void *b) {
  return memcmp(((const plain_record *)a)->word, ((const plain_record *)b)->word, sizeof(uint64_t) * WORDS);
}

/* The bits of x, the same for both zeros. */
static uint64_t bits(double x) {
  uint64_t word;
  const double plain = x == 0 ? 0.0 : x;
  memcpy(&word, &plain, sizeof word);
  return word;
}

static uint64_t mixed(uint64_t hash, uint64_t word) {
  hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
  return hash ^ hash >> 29;
}

/* Equal balls have equal names. */
static uint64_t ball_name(const computed *c, uint32_t ball) {
  uint64_t hash = 1;
  uint32_t axis;
  if (ball == HSP_NONE) return 0;
  for (axis = 0; axis < 3; ++axis) hash = mixed(hash, bits(c->xyz[3 * ball + axis]));
  return mixed(hash, bits(c->radius[ball]));
}

static uint64_t vertex_name(const computed *c, const hsp_topology_vertex *v) {
  uint64_t hash = v->kind + 1;
  int axis;
  for (axis = 0; axis < 3; ++axis) hash = mixed(hash, bits(v->xyz[axis]));
  return mixed(hash, ball_name(c, v->ball[0]) + ball_name(c, v->ball[1]) + ball_name(c, v->ball[2]));
}

/* A simple face's name: from its ball and the ends of its edges. */
static uint64_t face_name(const topology_result *t, const hsp_simple_face *f, const uint64_t *names) {
  uint32_t q = f->q;
  uint64_t loop = 0;
  do {
    const uint32_t next = hsp_topology_lnext(t->topology, q);
    loop += mixed(names[t->origin[q]], names[t->origin[next]]);
    q = next;
  } while (q != f->q);
  return mixed(loop, ball_name(t->base, f->ball));
}

/* A shell's name: from the order in which its scan meets simple faces. */
static uint64_t scan_name(const topology_result *t, uint32_t shell, const uint64_t *face_names) {
  const uint32_t count = t->shells[shell].simple_faces;
  uint32_t needed = 0, k;
  uint64_t hash = 1;
  uint32_t *faces = test_zeros(count, sizeof *faces);
  if (hsp_topology_get_traversal(t->topology, shell, faces, count, &needed) != HSP_OK) hash = 0;
  for (k = 0; k < count; ++k) hash = mixed(hash, face_names[faces[k]]);
  free(faces);
  return hash;
}

static void plain_edge(const computed *c, const hsp_topology_edge *edge, const uint64_t *names, plain_record *plain) {
  /* Which ball is on the left depends on ids. So the edge is named in the sense in which its axis points to greater x,
   * y, z. */
  const double *u = edge->axis;
  const int turned = u[0] != 0 ? u[0] < 0 : u[1] != 0 ? u[1] < 0 : u[2] < 0;
  int axis;
  plain->word[0] = edge->kind;
  plain->word[1] = names[edge->vertex[turned]];
  plain->word[2] = names[edge->vertex[1 - turned]];
  plain->word[3] = bits(edge->angle);
  plain->word[4] = bits(edge->radius);
  for (axis = 0; axis < 3; ++axis) {
    plain->word[5 + axis] = bits(edge->centre[axis]);
    plain->word[8 + axis] = bits(turned ? -u[axis] : u[axis]);
  }
  plain->word[11] = ball_name(c, edge->ball[turned]);
  plain->word[12] = ball_name(c, edge->ball[1 - turned]);
}

static void plain_shell(const topology_result *t, uint32_t id, const uint64_t *face_names, plain_record *plain) {
  const hsp_shell *s = t->shells + id;
  const hsp_component *component = t->components + s->component;
  const uint32_t enclosing = t->regions[s->region].enclosing_shell;
  plain->word[0] = s->kind;
  plain->word[1] = (uint64_t)(int64_t)s->euler;
  plain->word[2] = s->faces;
  plain->word[3] = s->simple_faces;
  plain->word[4] = s->edges;
  plain->word[5] = s->vertices;
  plain->word[6] = s->region == 0;
  plain->word[7] = component->shells;
  plain->word[8] = scan_name(t, id, face_names);
  plain->word[9] = ball_name(t->base, component->top_ball);
  plain->word[10] = enclosing == HSP_NONE ? 0 : face_names[t->shells[enclosing].start_face];
  plain->size[0] = s->area;
  plain->size[1] = s->volume;
}

static plain_form plain_form_of(const topology_result *t) {
  plain_form form;
  const hsp_topology_counts *k = &t->counts;
  uint32_t i;
  int axis;
  uint64_t *names = test_zeros(k->vertices, sizeof *names);
  uint64_t *face_names = test_zeros(k->simple_faces, sizeof *face_names);
  form.vertices = test_zeros(k->vertices, sizeof(plain_record));
  form.edges = test_zeros(k->edges, sizeof(plain_record));
  form.faces = test_zeros(k->simple_faces, sizeof(plain_record));
  form.shells = test_zeros(k->shells, sizeof(plain_record));
  for (i = 0; i < k->vertices; ++i) {
    const hsp_topology_vertex *v = t->vertices + i;
    names[i] = vertex_name(t->base, v);
    form.vertices[i].word[0] = names[i];
    for (axis = 0; axis < 3; ++axis) form.vertices[i].word[1 + axis] = bits(v->xyz[axis]);
  }
  for (i = 0; i < k->edges; ++i) plain_edge(t->base, t->edges + i, names, form.edges + i);
  for (i = 0; i < k->simple_faces; ++i) {
    const hsp_simple_face *f = t->faces + i;
    face_names[i] = face_name(t, f, names);
    form.faces[i].word[0] = f->edges;
    form.faces[i].word[1] = face_names[i];
  }
  for (i = 0; i < k->shells; ++i) plain_shell(t, i, face_names, form.shells + i);
  form.start = k->start_face == HSP_NONE ? 0 : face_names[k->start_face];
  free(names);
  free(face_names);
  qsort(form.vertices, k->vertices, sizeof(plain_record), by_words);
  qsort(form.edges, k->edges, sizeof(plain_record), by_words);
  qsort(form.faces, k->simple_faces, sizeof(plain_record), by_words);
  qsort(form.shells, k->shells, sizeof(plain_record), by_words);
  return form;
}

static void plain_form_release(plain_form *form) {
  free(form->vertices);
  free(form->edges);
  free(form->faces);
  free(form->shells);
}

static int same(const plain_record *a, const plain_record *b, uint32_t count) {
  uint32_t i;
  for (i = 0; i < count; ++i) {
    if (by_words(a + i, b + i) != 0) return 0;
  }
  return 1;
}

static int close_to(double a, double b, double rounding) {
  return fabs(a - b) <= 1e-11 * (fabs(a) + fabs(b)) + rounding;
}

const char *topology_difference_after_permutation(const topology_result *a, const topology_result *b) {
  const hsp_topology_counts *k = &a->counts, *l = &b->counts;
  const char *what = NULL;
  const double r = a->base->info.largest_radius, rounding = 1e-12 * r * r * (1 + a->base->counts.faces);
  plain_form form_a, form_b;
  uint32_t i;
  if (k->vertices != l->vertices || k->edges != l->edges || k->simple_faces != l->simple_faces ||
      k->cut_edges != l->cut_edges || k->shells != l->shells || k->components != l->components ||
      k->regions != l->regions) {
    return "the topology's counts differ";
  }
  if (memcmp(&a->needed, &b->needed, sizeof a->needed) != 0) return "the topology's needed limits differ";
  form_a = plain_form_of(a);
  form_b = plain_form_of(b);
  if (!same(form_a.vertices, form_b.vertices, k->vertices)) what = "the topology's vertices differ";
  if (what == NULL && !same(form_a.edges, form_b.edges, k->edges)) what = "the topology's edges differ";
  if (what == NULL && !same(form_a.faces, form_b.faces, k->simple_faces)) what = "the simple faces differ";
  if (what == NULL && !same(form_a.shells, form_b.shells, k->shells)) what = "the shells differ";
  if (what == NULL && form_a.start != form_b.start) what = "the start faces differ";
  for (i = 0; i < k->shells && what == NULL; ++i) {
    if (!close_to(form_a.shells[i].size[0], form_b.shells[i].size[0], rounding) ||
        !close_to(form_a.shells[i].size[1], form_b.shells[i].size[1], rounding * r)) {
      what = "areas or volumes of shells differ";
    }
  }
  plain_form_release(&form_a);
  plain_form_release(&form_b);
  return what;
}
