/* Functions of the caller's run in the caller's floating-point environment, tasks of an executor in the library's on
 * any thread, whose own environment comes back: hardsphere.h, FLOATING POINT. */
#define _POSIX_C_SOURCE 200112L
#include <fenv.h>
#include <hardsphere_workspace.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "gradients.h"
#include "guarded_memory.h"
#include "host_environment.h"
#include "loops.h"

enum { WORKERS = 3 };

/* A loop whose tasks are done by turns in the caller's thread and in one that has another environment. */
typedef struct host_loop {
  int callers, threads; /* environments */
  uint32_t runs, wrong;
} host_loop;

typedef struct host_task {
  hsp_task *task;
  void *data;
  uint32_t number;
  int environment, differs;
} host_task;

static void *do_task(void *argument) {
  host_task *const t = argument;
  fenv_t own;
  fegetenv(&own);
  host_environment_set(t->environment, 1);
  t->task(t->data, t->number);
  t->differs = host_environment_differs(t->environment, 1) != NULL;
  fesetenv(&own);
  return NULL;
}

static int32_t run(void *context, uint32_t tasks, hsp_task *task, void *data) {
  host_loop *const host = context;
  uint32_t k;
  host->wrong += host_environment_differs(host->callers, host->runs == 0) != NULL;
  for (k = 0; k < tasks; ++k) {
    host_task t;
    pthread_t thread;
    memset(&t, 0, sizeof t);
    t.task = task;
    t.data = data;
    t.number = k;
    t.environment = k % 2 == 0 ? host->callers : host->threads;
    if (k % 2 == 0) {
      do_task(&t);
    } else {
      if (pthread_create(&thread, NULL, do_task, &t) != 0) exit(1);
      pthread_join(thread, NULL);
    }
    host->wrong += t.differs != 0;
  }
  /* From here on the caller's thread has no flag: that stays, too. */
  host_environment_set(host->callers, 0);
  ++host->runs;
  return 0;
}

typedef struct answers {
  hsp_boundary_counts counts;
  hsp_totals totals;
  double area[BALL_SET_MOST];
  hsp_energy energy;
  double centre[3 * BALL_SET_MOST];
} answers;

/* All by an executor, in an environment that is set here; `executor` NULL: in the program's. */
static void answer(const computed *c, hsp_boundary *boundary, const hsp_executor *executor, const host_loop *host,
                   answers *out) {
  hsp_boundary_request request = {.struct_size = sizeof request};
  hsp_measure_request measures = {.struct_size = sizeof measures};
  hsp_measure_outputs measured = {.struct_size = sizeof measured};
  hsp_gradient_request asked = {
      .struct_size = sizeof asked, .tangency = HSP_TANGENT_OVERLAP, .tension = 0.75, .pressure = 0.25};
  hsp_gradient_outputs gradient;
  int32_t status[4];
  int differs[3], k;
  fenv_t own;
  memset(out, 0, sizeof *out);
  memset(&gradient, 0, sizeof gradient);
  gradient.struct_size = (uint32_t)sizeof gradient;
  request.executor = measures.executor = asked.executor = executor;
  measured.capacity = gradient.capacity = c->n;
  measured.totals = &out->totals;
  measured.area = out->area;
  gradient.energy = &out->energy;
  gradient.d_centre = out->centre;
  fegetenv(&own);
  for (k = 0; k < 3; ++k) {
    host_loop *const fresh = executor != NULL ? executor->context : NULL;
    if (fresh != NULL) fresh->runs = 0;
    if (host != NULL) host_environment_set(host->callers, 1);
    if (k == 0) status[k] = hsp_boundary_compute_with(boundary, c->model, &request, NULL);
    if (k == 1) status[k] = hsp_boundary_get_measures(boundary, &measures, &measured);
    if (k == 2) status[k] = hsp_boundary_get_gradient(boundary, &asked, &gradient);
    /* The flag is gone with the first run, and what the library raises is not seen. */
    differs[k] = host != NULL && host_environment_differs(host->callers, host->runs == 0) != NULL;
  }
  fesetenv(&own);
  status[3] = hsp_boundary_get_counts(boundary, &out->counts);
  for (k = 0; k < 4; ++k) CHECK_EQUAL(status[k], HSP_OK);
  for (k = 0; k < 3; ++k) CHECK(!differs[k]);
}

static void by_executors(const computed *c) {
  static answers alone, shared;
  hsp_boundary_limits limits = c->needed;
  hsp_boundary *boundary = NULL;
  guarded_memory memory;
  size_t bytes = 0;
  int callers, threads;
  limits.workers = WORKERS;
  CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
  memory = guarded_take(bytes, 8, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_boundary_init(memory.block, bytes, &limits, &boundary), HSP_OK);
  answer(c, boundary, NULL, NULL, &alone);
  for (callers = HOST_default; callers < HOST_ENVIRONMENTS; ++callers) {
    for (threads = HOST_default; threads < HOST_ENVIRONMENTS; ++threads) {
      host_loop host = {callers, threads, 0, 0};
      const hsp_executor executor = executor_with(run, &host, WORKERS);
      if (!host_environment_exists(callers) || !host_environment_exists(threads)) continue;
      check_scene("a loop in the environment %s, threads in %s", host_environment_name(callers),
                  host_environment_name(threads));
      answer(c, boundary, &executor, &host, &shared);
      CHECK(host.runs > 0);
      CHECK_EQUAL(host.wrong, 0);
      CHECK_BYTES(&shared, &alone, sizeof alone);
    }
  }
  guarded_give_back(&memory);
}

/* A sink that changes the environment, as it may. */
typedef struct host_sink {
  int callers;
  uint32_t calls, wrong;
  uint64_t bytes, hash;
} host_sink;

static int32_t take(void *context, const char *bytes, size_t count) {
  host_sink *const sink = context;
  size_t k;
  sink->wrong += host_environment_differs(sink->callers, sink->calls == 0) != NULL;
  for (k = 0; k < count; ++k) sink->hash = (sink->hash ^ (unsigned char)bytes[k]) * UINT64_C(0x100000001B3);
  sink->bytes += count;
  ++sink->calls;
  host_environment_set(sink->callers, 0);
  return 0;
}

/* The pictures that there are, each by one call. */
static int32_t write_view(void *view, void *sink) {
  return hsp_picture_write(view, NULL, NULL, "title", NULL, take, sink, NULL);
}
static int32_t write_map(void *map, void *sink) {
  return hsp_picture_write_map(map, NULL, NULL, "title", NULL, take, sink, NULL);
}
static int32_t write_sticks(void *sticks, void *sink) {
  return hsp_picture_write_sticks(sticks, NULL, NULL, "title", NULL, take, sink, NULL);
}

static void by_sink(const char *of, int32_t (*draw)(void *handle, void *sink), void *handle) {
  uint64_t expected = 0;
  int callers;
  for (callers = HOST_default; callers < HOST_ENVIRONMENTS; ++callers) {
    host_sink sink = {HOST_default, 0, 0, 0, UINT64_C(0xCBF29CE484222325)};
    int32_t status;
    int differs;
    fenv_t own;
    if (!host_environment_exists(callers)) continue;
    check_scene("a sink of %s in the environment %s", of, host_environment_name(callers));
    sink.callers = callers;
    fegetenv(&own);
    host_environment_set(callers, 1);
    status = draw(handle, &sink);
    differs = host_environment_differs(callers, 0) != NULL;
    fesetenv(&own);
    CHECK_EQUAL(status, HSP_OK);
    CHECK(!differs);
    CHECK(sink.calls > 2);
    CHECK_EQUAL(sink.wrong, 0);
    if (callers == HOST_default) expected = sink.hash;
    CHECK(sink.hash == expected);
  }
}

enum { LINKS = 30, PAIRS = 64 * (LINKS + 1) };

/* Balls in a row, joined by sticks. */
static void by_sink_of_sticks(hsp_workspace *work) {
  static unsigned char memory[HSP_STICKS_BYTES(LINKS + 1, LINKS, PAIRS, 0)];
  static double xyz[3 * (LINKS + 1)], radius[LINKS + 1];
  static hsp_stick stick[LINKS];
  const hsp_sticks_limits limits = {(uint32_t)sizeof limits, LINKS + 1, LINKS, PAIRS, 0};
  hsp_sticks *sticks = NULL;
  uint32_t k;
  for (k = 0; k <= LINKS; ++k) {
    xyz[3 * k] = 3.3 * k;
    xyz[3 * k + 2] = 0.7 * k;
    radius[k] = 1;
  }
  for (k = 0; k < LINKS; ++k) {
    stick[k].ball[0] = k;
    stick[k].ball[1] = k + 1;
  }
  check_scene("sticks");
  CHECK_EQUAL(hsp_workspace_set(work, LINKS + 1, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_init(memory, sizeof memory, &limits, &sticks), HSP_OK);
  CHECK_EQUAL(hsp_sticks_compute(sticks, work->model, NULL, stick, LINKS, 0.3, NULL, NULL), HSP_OK);
  by_sink("sticks", write_sticks, sticks);
}

static void by_sinks(const ball_set *set) {
  hsp_workspace work;
  memset(&work, 0, sizeof work);
  check_scene("pictures");
  CHECK_EQUAL(hsp_workspace_set(&work, set->n, set->xyz, set->radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_view(&work, 0, NULL), HSP_OK);
  by_sink("a view", write_view, work.view);
  CHECK_EQUAL(hsp_workspace_map(&work, NULL), HSP_OK);
  by_sink("a map", write_map, work.map);
  by_sink_of_sticks(&work);
  hsp_workspace_free(&work);
}

int main(void) {
  static ball_set set;
  computed c;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 200, 77);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  by_executors(&c);
  by_sinks(&set);
  computed_release(&c);
  return check_report();
}
