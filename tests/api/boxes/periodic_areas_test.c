/* Periodic boxes as a request says: areas and their derivatives alone have the bits of those with everything else, for
 * any number of workers, and nothing else can be read then. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "loops.h"
#include "random_numbers.h"

enum { MOST = 400 };

typedef struct answers {
  hsp_periodic_totals totals;
  hsp_energy energy;
  double area[MOST], area_too[MOST], centre[3 * MOST], radius[MOST], strain[9], box[9];
  uint32_t flags[MOST];
} answers;

typedef struct crystal {
  uint32_t n;
  double xyz[3 * MOST], radius[MOST], sigma[MOST], box[9];
} crystal;

/* In a memory of its own, made larger until it suffices; the number of retries. */
static int computed_with(const crystal *set, const hsp_periodic_request *request, uint32_t workers, hsp_periodic **out,
                         void **memory) {
  hsp_periodic_limits limits = {.struct_size = sizeof limits, .balls = set->n, .workers = workers};
  int retries;
  for (retries = 0;; ++retries) {
    uint32_t bad = 0;
    size_t bytes = 0;
    int32_t status;
    CHECK_EQUAL(hsp_periodic_bytes(&limits, &bytes), HSP_OK);
    CHECK(bytes <=
          HSP_PERIODIC_BYTES(limits.balls, limits.images, limits.neighbours, limits.vertices, limits.circles,
                             limits.contacts) +
              (limits.workers > 1 ? limits.workers - 1 : 0) *
                  HSP_WORKER_BYTES(limits.balls + limits.images, limits.neighbours, limits.vertices, limits.circles));
    *memory = malloc(bytes);
    if (*memory == NULL) exit(2);
    CHECK_EQUAL(hsp_periodic_init(*memory, bytes, &limits, out), HSP_OK);
    status = hsp_periodic_compute_with(*out, set->n, set->xyz, set->radius, set->box, request, &limits, &bad);
    CHECK_EQUAL(bad, HSP_NONE);
    if (status == HSP_OK) return retries;
    free(*memory);
    if (!CHECK_EQUAL(status, HSP_E_CAPACITY) || !CHECK(retries < 7)) exit(1);
  }
}

static void read_answers(const hsp_periodic *periodic, const crystal *set, double pressure, answers *found) {
  const hsp_gradient_request asked = {
      .struct_size = sizeof asked, .tension = 0.7, .pressure = pressure, .sigma = set->sigma};
  hsp_periodic_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = set->n};
  memset(found, 0x5A, sizeof *found);
  outputs.energy = &found->energy;
  outputs.d_centre = found->centre;
  outputs.d_radius = found->radius;
  outputs.flags = found->flags;
  outputs.d_strain = found->strain;
  outputs.d_box = found->box;
  outputs.area = found->area_too;
  CHECK_EQUAL(hsp_periodic_measure(periodic, &found->totals, found->area, NULL, set->n, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_get_gradient(periodic, &asked, &outputs), HSP_OK);
  CHECK_BYTES(found->area, found->area_too, set->n * sizeof *found->area);
}

static void answers_nothing_else(hsp_periodic *periodic, const crystal *set) {
  static double volume[MOST];
  hsp_periodic_counts counts;
  uint32_t number, id;
  hsp_image image;
  const hsp_gradient_request pressed = {.struct_size = sizeof pressed, .pressure = 1};
  hsp_energy energy;
  CHECK_EQUAL(hsp_periodic_get_counts(periodic, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_measure(periodic, NULL, NULL, volume, MOST, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_get_gradient(periodic, &pressed, SIZED(hsp_periodic_gradient_outputs, .energy = &energy)),
              HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, NULL, 0, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_get_windings(periodic, NULL, 0, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_get_faces(periodic, NULL, 0, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_curvature(periodic, NULL, NULL, NULL, 0, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_query_point(periodic, set->xyz, &image, 0, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_check(periodic, &number, &id), HSP_E_STATE);
}

static void same_records(const hsp_periodic *p, const hsp_periodic *q) {
  hsp_periodic_counts of_p, of_q;
  uint32_t k, number;
  hsp_periodic_vertex *v[2];
  hsp_periodic_face *f[2];
  CHECK_EQUAL(hsp_periodic_get_counts(p, &of_p), HSP_OK);
  CHECK_EQUAL(hsp_periodic_get_counts(q, &of_q), HSP_OK);
  CHECK_BYTES(&of_p, &of_q, sizeof of_p);
  for (k = 0; k < 2; ++k) {
    v[k] = calloc(of_p.vertices + 1, sizeof *v[k]);
    f[k] = calloc(of_p.faces + 1, sizeof *f[k]);
    if (v[k] == NULL || f[k] == NULL) exit(2);
    CHECK_EQUAL(hsp_periodic_get_vertices(k == 0 ? p : q, v[k], of_p.vertices, &number), HSP_OK);
    CHECK_EQUAL(hsp_periodic_get_faces(k == 0 ? p : q, f[k], of_p.faces, &number), HSP_OK);
  }
  CHECK_BYTES(v[0], v[1], of_p.vertices * sizeof *v[0]);
  CHECK_BYTES(f[0], f[1], of_p.faces * sizeof *f[0]);
  for (k = 0; k < 2; ++k) {
    free(v[k]);
    free(f[k]);
  }
}

static void compare(const crystal *set) {
  static answers whole, alone;
  void *memory[2];
  hsp_periodic *periodic, *other;
  uint32_t workers;
  computed_with(set, NULL, 0, &periodic, &memory[0]);
  read_answers(periodic, set, 0, &whole);
  for (workers = 0; workers <= 4; ++workers) {
    loop own = loop_of(LOOP_SHUFFLED);
    hsp_executor executor = executor_of(&own, workers);
    hsp_periodic_request request = {.struct_size = sizeof request, .areas_alone = 1};
    request.executor = workers == 0 ? NULL : &executor;
    check_scene("%u balls by %u workers", (unsigned)set->n, (unsigned)workers);
    computed_with(set, &request, workers / 2, &other, &memory[1]);
    read_answers(other, set, 0, &alone);
    CHECK(alone.totals.volume == 0 && alone.totals.free_volume == 0 && alone.totals.contact_area == 0);
    CHECK(alone.totals.area == whole.totals.area && alone.totals.box_volume == whole.totals.box_volume);
    CHECK_BYTES(&alone.energy.value, &whole.energy.value, sizeof(double));
    CHECK(alone.energy.volume == 0);
    CHECK_BYTES(alone.area, whole.area, sizeof whole - offsetof(answers, area));
    answers_nothing_else(other, set);
    free(memory[1]);
    request.areas_alone = 0;
    computed_with(set, &request, 1 + workers, &other, &memory[1]);
    same_records(periodic, other);
    read_answers(other, set, 0, &alone);
    CHECK_BYTES(&alone, &whole, sizeof whole);
    CHECK_EQUAL(own.runs > 0, workers > 1);
    free(memory[1]);
  }
  free(memory[0]);
}

static void refused(const crystal *set) {
  loop own = loop_of(LOOP_DOES_NOTHING);
  hsp_executor executor = executor_of(&own, 2);
  hsp_periodic_request request = {.struct_size = sizeof request, .areas_alone = 2};
  hsp_periodic_limits limits = {.struct_size = sizeof limits};
  hsp_periodic_counts counts;
  hsp_periodic *periodic;
  void *memory;
  check_scene("requests that are refused");
  computed_with(set, NULL, 2, &periodic, &memory);
  CHECK_EQUAL(hsp_periodic_compute_with(periodic, set->n, set->xyz, set->radius, set->box, &request, NULL, NULL),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_periodic_get_counts(periodic, &counts), HSP_E_STATE);
  request.areas_alone = 0;
  request.executor = &executor;
  CHECK_EQUAL(hsp_periodic_compute_with(periodic, set->n, set->xyz, set->radius, set->box, &request, NULL, NULL),
              HSP_E_EXECUTOR);
  CHECK_EQUAL(hsp_periodic_get_counts(periodic, &counts), HSP_E_STATE);
  executor = executor_of(&own, 3);
  CHECK_EQUAL(hsp_periodic_compute_with(periodic, set->n, set->xyz, set->radius, set->box, &request, &limits, NULL),
              HSP_E_CAPACITY);
  CHECK_EQUAL(limits.workers, 3);
  executor.run = NULL;
  CHECK_EQUAL(hsp_periodic_compute_with(periodic, set->n, set->xyz, set->radius, set->box, &request, NULL, NULL),
              HSP_E_ARGUMENT);
  limits.workers = HSP_MAX_WORKERS + 1;
  CHECK_EQUAL(hsp_periodic_bytes(&limits, &(size_t){0}), HSP_E_RANGE);
  free(memory);
}

int main(void) {
  static crystal set;
  uint64_t seed = 45;
  int which;
  for (which = 0; which < 14; ++which) {
    /* Dense and loose, skew and straight, thin ones in which balls meet several images, one without images. */
    const double side = which % 5 == 4 ? 3.5 : which == 12 ? 60 : 12;
    const int lattice = which % 4 == 3; /* on whole numbers, with ties */
    uint32_t i;
    set.n = which == 13 ? 1 : which % 5 == 4 ? 12 : which == 12 ? 30 : which % 2 == 0 ? MOST : 120;
    memset(set.box, 0, sizeof set.box);
    set.box[0] = set.box[4] = set.box[8] = side;
    if (which % 3 == 1) {
      set.box[3] = 1.25;
      set.box[6] = -1.5;
      set.box[7] = 0.75;
    }
    for (i = 0; i < 3 * set.n; ++i) {
      const double x = side * (2 * random_fraction(&seed) - 0.5);
      set.xyz[i] = lattice ? (double)(int)x : which == 12 ? 25 + 0.15 * x : x;
    }
    for (i = 0; i < set.n; ++i) {
      set.radius[i] = lattice ? 1 : 0.5 + random_fraction(&seed);
      set.sigma[i] = i % 7 == 3 ? 0 : 2 * random_fraction(&seed) - 0.5;
    }
    compare(&set);
  }
  set.n = 0;
  compare(&set);
  set.n = 40;
  refused(&set);
  return check_report();
}
