/* hsp_executor.proceed: a computation that is stopped at its questions in turn says HSP_E_STOPPED, leaves its
 * handle without results and its limits as they were, and afterwards gives the same as before; one that reads results
 * leaves these. In a sweep over forty sets for boundaries, one for all else, by one worker and by three. */
#include <hardsphere.h>
#include <hardsphere_workspace.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "loops.h"

enum { SETS = 40, SETS_FOR_ALL = 1, BALLS = 60, BALLS_FOR_ALL = 300, STOPS = 6, WORKERS = 3 };

/* The loop comes first, as it is the context of what runs it. */
typedef struct stopper {
  loop own;
  uint32_t asked, stop_at;
} stopper;

static int32_t proceed(void *context) {
  stopper *const own = context;
  return __atomic_fetch_add(&own->asked, 1, __ATOMIC_RELAXED) >= own->stop_at ? 7 : 0;
}

typedef struct scene {
  hsp_workspace work;
  uint32_t n;
  double area[BALL_SET_MOST], d_centre[3 * BALL_SET_MOST];
  uint32_t first[BALL_SET_MOST + 1];
  double box[9];
  const ball_set *set;
} scene;

/* ---- what is asked: `read` tells of the handle's results ------------------------------------------------------- */

typedef struct question {
  const char *name;
  int32_t (*ask)(scene *s, const hsp_executor *executor);
  int32_t (*read)(scene *s, void *counts, size_t *bytes); /* NULL: the function only reads */
  uint32_t least;                                         /* questions that it has to ask of such a set */
} question;

static int32_t ask_boundary(scene *s, const hsp_executor *executor) {
  const hsp_boundary_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_boundary_limits limits = s->work.boundary_limits;
  const int32_t status = hsp_boundary_compute_with(s->work.boundary, s->work.model, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.boundary_limits, sizeof limits);
  return status;
}
static int32_t read_boundary(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_boundary_counts);
  return hsp_boundary_get_counts(s->work.boundary, counts);
}

static int32_t ask_measures(scene *s, const hsp_executor *executor) {
  const hsp_measure_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_measure_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .area = s->area};
  return hsp_boundary_get_measures(s->work.boundary, &request, &outputs);
}
static int32_t ask_gradient(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_boundary_get_gradient(s->work.boundary, &request, &outputs);
}
static int32_t ask_derivatives(scene *s, const hsp_executor *executor) {
  const hsp_derivatives_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .area_centre = s->d_centre};
  return hsp_boundary_get_derivatives(s->work.boundary, &request, &outputs);
}
static int32_t ask_rows(scene *s, const hsp_executor *executor) {
  static uint32_t ball[64 * BALL_SET_MOST];
  static double d_centre[3 * 64 * BALL_SET_MOST];
  const hsp_derivatives_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_boundary_get_area_rows(s->work.boundary, &request, s->first, ball, d_centre, NULL, 64 * BALL_SET_MOST,
                                    NULL);
}
static int32_t ask_morphometry(scene *s, const hsp_executor *executor) {
  const hsp_morphometry_request request = {.struct_size = sizeof request, .bending = 1, .executor = executor};
  hsp_morphometry_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_boundary_get_morphometry(s->work.boundary, &request, &outputs);
}
static int32_t ask_hessian_rows(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  static uint32_t first[BALLS_FOR_ALL + 1], ball[32 * BALLS_FOR_ALL], flags[BALLS_FOR_ALL + 1];
  static double block[9 * 32 * BALLS_FOR_ALL];
  return hsp_boundary_get_hessian_rows(s->work.boundary, &request, first, ball, block, flags, 32 * BALLS_FOR_ALL, NULL);
}
static int32_t ask_hessian_product(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  static double product[3 * BALLS_FOR_ALL];
  return hsp_boundary_get_hessian_product(s->work.boundary, &request, s->set->xyz, product, NULL, s->n, NULL);
}
static int32_t ask_surface_gradient(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_surface_get_gradient(s->work.surface, &request, &outputs);
}

static int32_t ask_contacts(scene *s, const hsp_executor *executor) {
  const hsp_contacts_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_contacts_limits limits = s->work.contacts_limits;
  const int32_t status = hsp_contacts_compute_with(s->work.contacts, s->work.boundary, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.contacts_limits, sizeof limits);
  return status;
}
static int32_t read_contacts(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_complex);
  return hsp_contacts_get_complex(s->work.contacts, counts);
}

static int32_t ask_topology(scene *s, const hsp_executor *executor) {
  const hsp_topology_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_topology_limits limits = s->work.topology_limits;
  const int32_t status = hsp_topology_compute_with(s->work.topology, s->work.boundary, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.topology_limits, sizeof limits);
  return status;
}
static int32_t read_topology(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_topology_counts);
  return hsp_topology_get_counts(s->work.topology, counts);
}

static int32_t ask_mesh(scene *s, const hsp_executor *executor) {
  const hsp_mesh_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_mesh_compute_with(s->work.mesh, s->work.boundary, 0.4, &request, NULL);
}
static int32_t ask_smooth_mesh(scene *s, const hsp_executor *executor) {
  const hsp_mesh_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_mesh_compute_surface_with(s->work.mesh, s->work.surface, 0.4, &request, NULL);
}
static int32_t read_mesh(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_mesh_counts);
  return hsp_mesh_get_counts(s->work.mesh, counts);
}

static int32_t ask_periodic(scene *s, const hsp_executor *executor) {
  const hsp_periodic_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_periodic_compute_with(s->work.periodic, s->n, s->set->xyz, s->set->radius, s->box, &request, NULL, NULL);
}
static int32_t read_periodic(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_periodic_counts);
  return hsp_periodic_get_counts(s->work.periodic, counts);
}
static int32_t ask_periodic_gradient(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_periodic_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_periodic_get_gradient(s->work.periodic, &request, &outputs);
}
static int32_t ask_periodic_morphometry(scene *s, const hsp_executor *executor) {
  const hsp_morphometry_request request = {.struct_size = sizeof request, .bending = 1, .executor = executor};
  hsp_periodic_morphometry_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_periodic_get_morphometry(s->work.periodic, &request, &outputs);
}

/* Of two bricks the first, with every second ball. */
static int32_t ask_brick(scene *s, const hsp_executor *executor) {
  static uint8_t summary[1000000];
  static uint64_t id[BALL_SET_MOST];
  static uint32_t owner[BALL_SET_MOST];
  const hsp_brick_request request = {sizeof request, 0, 2, 0, id, owner, executor};
  size_t bytes = sizeof summary;
  uint32_t i;
  for (i = 0; i < s->n; ++i) {
    id[i] = i;
    owner[i] = i % 2;
  }
  return hsp_brick_summarise(s->work.boundary, &request, summary, &bytes, NULL);
}

static const question of_boundaries = {"boundary", ask_boundary, read_boundary, 3};
static const question questions[] = {
    {"measures", ask_measures, NULL, 3},
    {"gradient", ask_gradient, NULL, 3},
    {"derivatives", ask_derivatives, NULL, 3},
    {"area rows", ask_rows, NULL, 3},
    {"morphometry", ask_morphometry, NULL, 3},
    {"second derivatives", ask_hessian_rows, NULL, 3},
    {"second derivatives times a direction", ask_hessian_product, NULL, 3},
    {"gradient of a smooth surface", ask_surface_gradient, NULL, 3},
    {"summary of a brick", ask_brick, NULL, 3},
    {"contacts", ask_contacts, read_contacts, 3},
    {"topology", ask_topology, read_topology, 3},
    {"mesh", ask_mesh, read_mesh, 3},
    {"mesh of a smooth surface", ask_smooth_mesh, read_mesh, 3},
    {"periodic", ask_periodic, read_periodic, 3},
    {"gradient in a box", ask_periodic_gradient, NULL, 3},
    {"morphometry in a box", ask_periodic_morphometry, NULL, 3},
};
enum { QUESTIONS = sizeof questions / sizeof questions[0] };

/* ---- the sweep ---- */

/* Asks so many times to go on, and counts. */
static int32_t ask_until(const question *q, scene *s, uint32_t workers, uint32_t stop_at, uint32_t *asked) {
  stopper own;
  hsp_executor executor;
  int32_t status;
  own.own = loop_of(LOOP_IN_ORDER);
  own.asked = 0;
  own.stop_at = stop_at;
  executor = executor_of(&own.own, workers);
  executor.context = &own;
  executor.proceed = proceed;
  status = q->ask(s, &executor);
  *asked = own.asked;
  return status;
}

static void check_results(const question *q, scene *s, const unsigned char *expected, int32_t status) {
  unsigned char found[256] = {0};
  size_t bytes = 0;
  if (q->read == NULL) return;
  CHECK_EQUAL(q->read(s, found, &bytes), status);
  if (status == HSP_OK) CHECK_BYTES(found, expected, bytes);
}

static void sweep(const question *q, scene *s, uint32_t workers) {
  unsigned char counts[256] = {0};
  size_t bytes;
  uint32_t questions_asked, asked, k;
  check_scene("%s by %u workers", q->name, (unsigned)workers);
  CHECK_EQUAL(ask_until(q, s, workers, UINT32_MAX, &questions_asked), HSP_OK);
  CHECK(questions_asked >= q->least);
  if (q->read != NULL) CHECK_EQUAL(q->read(s, counts, &bytes), HSP_OK);
  /* Of boundaries at each, of all else at some. */
  for (k = 0; k < questions_asked; k += q == &of_boundaries ? 1 : 1 + questions_asked / STOPS) {
    check_scene("%s by %u workers, stopped at question %u", q->name, (unsigned)workers, (unsigned)k);
    CHECK_EQUAL(ask_until(q, s, workers, k, &asked), HSP_E_STOPPED);
    CHECK(asked > k && asked <= k + WORKERS);
    check_results(q, s, counts, HSP_E_STATE);
  }
  CHECK_EQUAL(ask_until(q, s, workers, UINT32_MAX, &asked), HSP_OK);
  check_results(q, s, counts, HSP_OK);
}

/* Handles with room for three workers. */
static int make(scene *s, const ball_set *set, int all) {
  stopper own;
  hsp_executor executor;
  hsp_boundary_request request = {.struct_size = sizeof request};
  const hsp_model_options options = {.struct_size = sizeof options, .probe = 0.4};
  hsp_periodic_request in_box = {.struct_size = sizeof in_box};
  double low = 1e9, high = -1e9;
  uint32_t k;
  memset(s, 0, sizeof *s);
  s->set = set;
  s->n = set->n;
  for (k = 0; k < 3 * set->n; ++k) {
    if (set->xyz[k] < low) low = set->xyz[k];
    if (set->xyz[k] > high) high = set->xyz[k];
  }
  s->box[0] = s->box[4] = s->box[8] = high - low + 1.5;
  own.own = loop_of(LOOP_IN_ORDER);
  executor = executor_of(&own.own, WORKERS);
  request.executor = &executor;
  in_box.executor = &executor;
  if (!CHECK_EQUAL(hsp_workspace_set(&s->work, set->n, set->xyz, set->radius, &options, NULL), HSP_OK)) return 0;
  if (!CHECK_EQUAL(hsp_workspace_boundary_with(&s->work, &request), HSP_OK)) return 0;
  if (!all) return 1;
  return CHECK_EQUAL(hsp_workspace_contacts(&s->work), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_topology(&s->work), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_surface(&s->work), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_mesh(&s->work, 0, 0.4), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_mesh(&s->work, 1, 0.4), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_periodic_with(&s->work, set->n, set->xyz, set->radius, s->box, &in_box, NULL),
                     HSP_OK);
}

int main(void) {
  static ball_set set;
  static scene s;
  uint32_t k, q, workers;
  for (k = 0; k < SETS; ++k) {
    ball_set_start(&set, "chain", 1e-3);
    ball_set_add_chain(&set, k < SETS_FOR_ALL ? BALLS_FOR_ALL : BALLS + 5 * (k % 10), 500 + k);
    if (!make(&s, &set, k < SETS_FOR_ALL)) return check_report();
    for (workers = 1; workers <= WORKERS; workers += WORKERS - 1) {
      sweep(&of_boundaries, &s, workers);
      for (q = 0; k < SETS_FOR_ALL && q < QUESTIONS; ++q) sweep(&questions[q], &s, workers);
    }
    hsp_workspace_free(&s.work);
  }
  return check_report();
}
