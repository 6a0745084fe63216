/* The life of a handle: initialising again resets it, results depend on nothing but the input, reading changes nothing,
 * and several boundaries may read one model. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "guarded_memory.h"

/* Whether results are checked by the library itself before they are read. */
static int all_are_checked;

/* All results of one computation as one run of bytes. */
typedef struct snapshot {
  unsigned char *bytes;
  size_t size;
} snapshot;

static void append(snapshot *to, const void *from, size_t bytes) {
  unsigned char *more = realloc(to->bytes, to->size + bytes + 1);
  if (more == NULL) exit(2);
  to->bytes = more;
  memcpy(to->bytes + to->size, from, bytes);
  to->size += bytes;
}

/* What the library computes on request. */
static void append_derived(snapshot *to, const hsp_boundary *boundary, uint32_t faces, uint32_t n) {
  double *numbers = malloc((2 * (size_t)faces + 4 * (size_t)n + 1) * sizeof *numbers);
  uint32_t *flags = malloc(((size_t)n + 1) * sizeof *flags);
  hsp_area_derivative *row = malloc(((size_t)n + 1) * sizeof *row);
  hsp_energy energy;
  uint32_t i, count = 0;
  if (numbers == NULL || flags == NULL || row == NULL) exit(2);
  CHECK_EQUAL(hsp_boundary_measure_faces(boundary, numbers, numbers + faces, faces), HSP_OK);
  append(to, numbers, 2 * (size_t)faces * sizeof *numbers);
  CHECK_EQUAL(hsp_boundary_gradient(boundary, NULL, 1, 0.5, HSP_TANGENT_MEETING, &energy, numbers,
                                    numbers + 3 * (size_t)n, flags, n),
              HSP_OK);
  append(to, &energy, sizeof energy);
  append(to, numbers, 4 * (size_t)n * sizeof *numbers);
  append(to, flags, n * sizeof *flags);
  for (i = 0; i < n; i += 1 + n / 4) {
    CHECK_EQUAL(hsp_boundary_get_area_row(boundary, i, HSP_TANGENT_APART, row, n, &count), HSP_OK);
    append(to, row, count * sizeof *row);
  }
  free(numbers);
  free(flags);
  free(row);
}

static snapshot read_everything(hsp_boundary *boundary, uint32_t n) {
  snapshot all = {NULL, 0};
  uint32_t law = 77, where = 77;
  hsp_boundary_counts counts;
  hsp_boundary_limits needed;
  hsp_totals totals;
  uint32_t count = 0;
  size_t largest;
  void *records;
  double *area = malloc((2 * (size_t)n + 1) * sizeof *area);
  /* uses the scratch memory; what is read afterwards must be the same */
  if (all_are_checked) {
    CHECK_EQUAL(hsp_boundary_check(boundary, &law, &where), HSP_OK);
    CHECK_EQUAL(law, 0);
  }
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_needed(boundary, &needed), HSP_OK);
  append(&all, &counts, sizeof counts);
  append(&all, &needed, sizeof needed);
  largest = (size_t)counts.vertices + counts.arcs + counts.circles + counts.faces + n + 1;
  records = malloc(largest * sizeof(hsp_circle));
  if (records == NULL || area == NULL) exit(2);
  CHECK_EQUAL(hsp_boundary_get_vertices(boundary, records, counts.vertices, &count), HSP_OK);
  append(&all, records, count * sizeof(hsp_vertex));
  CHECK_EQUAL(hsp_boundary_get_arcs(boundary, records, counts.arcs, &count), HSP_OK);
  append(&all, records, count * sizeof(hsp_arc));
  CHECK_EQUAL(hsp_boundary_get_circles(boundary, records, counts.circles, &count), HSP_OK);
  append(&all, records, count * sizeof(hsp_circle));
  CHECK_EQUAL(hsp_boundary_get_faces(boundary, records, counts.faces, &count), HSP_OK);
  append(&all, records, count * sizeof(hsp_face));
  CHECK_EQUAL(hsp_boundary_get_balls(boundary, records, n, &count), HSP_OK);
  append(&all, records, count * sizeof(hsp_ball));
  CHECK_EQUAL(hsp_boundary_measure(boundary, &totals, area, area + n, n), HSP_OK);
  append(&all, &totals, sizeof totals);
  append(&all, area, 2 * (size_t)n * sizeof *area);
  append_derived(&all, boundary, counts.faces, n);
  free(records);
  free(area);
  return all;
}

static void check_same(const snapshot *a, const snapshot *b) {
  if (CHECK_EQUAL(a->size, b->size)) CHECK_BYTES(a->bytes, b->bytes, a->size);
}

/* What the memory held before makes no difference; computing twice gives the same bytes; init again resets. */
static void same_bytes(const ball_set *set, const ball_set *other) {
  static const int fills[3] = {0x00, 0xFF, GUARDED_RANDOM};
  snapshot first = {NULL, 0};
  computed sizes;
  int f;
  const uint32_t room = set->n > other->n ? set->n : other->n;
  size_t model_bytes = 0, bytes = 0;
  hsp_boundary_limits limits;
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &sizes), HSP_OK);
  limits = sizes.needed;
  computed_release(&sizes);
  CHECK_EQUAL(computed_make(other->n, other->xyz, other->radius, NULL, &sizes), HSP_OK);
  if (sizes.needed.balls > limits.balls) limits.balls = sizes.needed.balls;
  if (sizes.needed.neighbours > limits.neighbours) limits.neighbours = sizes.needed.neighbours;
  if (sizes.needed.vertices > limits.vertices) limits.vertices = sizes.needed.vertices;
  if (sizes.needed.circles > limits.circles) limits.circles = sizes.needed.circles;
  computed_release(&sizes);
  CHECK_EQUAL(hsp_model_bytes(room, &model_bytes), HSP_OK);
  CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);

  for (f = 0; f < 3; ++f) {
    guarded_memory model_memory = guarded_take(model_bytes, (size_t)f, fills[f]);
    guarded_memory memory = guarded_take(bytes, (size_t)f, fills[f]);
    hsp_model *model = NULL;
    hsp_boundary *boundary = NULL;
    hsp_boundary_counts counts;
    hsp_model_info info;
    snapshot again;
    int round;
    CHECK_EQUAL(hsp_model_init(model_memory.block, model_bytes, room, &model), HSP_OK);
    CHECK_EQUAL(hsp_boundary_init(memory.block, bytes, &limits, &boundary), HSP_OK);
    for (round = 0; round < 3; ++round) {
      CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, NULL, NULL), HSP_OK);
      CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
      again = read_everything(boundary, set->n);
      if (first.bytes == NULL) {
        first = again;
      } else {
        check_same(&first, &again);
        free(again.bytes);
      }
      /* checking changes no result */
      all_are_checked = 1;
      again = read_everything(boundary, set->n);
      check_same(&first, &again);
      free(again.bytes);
      all_are_checked = 0;
      /* reading is repeatable, and so is computing without setting the model again */
      CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
      again = read_everything(boundary, set->n);
      check_same(&first, &again);
      free(again.bytes);
      /* another set in between leaves no trace */
      CHECK_EQUAL(hsp_model_set(model, other->n, other->xyz, other->radius, NULL, NULL), HSP_OK);
      CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
    }
    CHECK_EQUAL(hsp_model_init(model_memory.block, model_bytes, room, &model), HSP_OK);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK_EQUAL(info.balls, 0);
    CHECK_EQUAL(info.cubes, 0);
    CHECK_EQUAL(hsp_boundary_init(memory.block, bytes, &limits, &boundary), HSP_OK);
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
    CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
    again = read_everything(boundary, set->n);
    check_same(&first, &again);
    free(again.bytes);
    CHECK(guarded_clean(&model_memory) && guarded_clean(&memory));
    guarded_give_back(&model_memory);
    guarded_give_back(&memory);
  }
  free(first.bytes);
}

/* Two boundaries of one model, and one boundary of two models in turn. */
static void several_handles(void) {
  static ball_set one_set, other_set;
  computed one, other;
  hsp_boundary_counts counts;
  ball_set_start(&one_set, "one", 1e-8);
  ball_set_add_chain(&one_set, 30, 31);
  ball_set_start(&other_set, "other", 1e-8);
  ball_set_add_chain(&other_set, 30, 32);
  CHECK_EQUAL(computed_make(one_set.n, one_set.xyz, one_set.radius, NULL, &one), HSP_OK);
  CHECK_EQUAL(computed_make(other_set.n, other_set.xyz, other_set.radius, NULL, &other), HSP_OK);
  if (one.needed.vertices > other.needed.vertices || one.needed.neighbours > other.needed.neighbours ||
      one.needed.circles > other.needed.circles) {
    /* the boundary of `other` may be too small for `one`; then it says so and recovers */
    const int32_t status = hsp_boundary_compute(other.boundary, one.model);
    CHECK(status == HSP_E_CAPACITY || status == HSP_OK);
  } else {
    CHECK_EQUAL(hsp_boundary_compute(other.boundary, one.model), HSP_OK);
    CHECK_EQUAL(hsp_boundary_get_counts(other.boundary, &counts), HSP_OK);
    CHECK_BYTES(&counts, &one.counts, sizeof counts);
  }
  CHECK_EQUAL(hsp_boundary_compute(other.boundary, other.model), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(other.boundary, &counts), HSP_OK);
  CHECK_BYTES(&counts, &other.counts, sizeof counts);
  /* what happens to the other model is no matter to results of this one */
  CHECK_EQUAL(hsp_model_set(one.model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(other.boundary, &counts), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(one.boundary, &counts), HSP_E_STATE);
  computed_release(&one);
  computed_release(&other);
}

int main(void) {
  static ball_set set, other;
  uint32_t which;
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &set);
    ball_set_make((which + 7) % ball_set_count(), &other);
    check_scene("%s, then %s", set.name, other.name);
    same_bytes(&set, &other);
  }
  check_scene("%s", "several handles");
  several_handles();
  return check_report();
}
