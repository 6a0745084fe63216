/* hsp_areas and hsp_workspace_areas: what model, boundary and measures say one after the other, from memory of any
 * alignment that grows until it suffices; and what is refused. */
#include <hardsphere_workspace.h>
#include <math.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "guarded_memory.h"

enum { MOST_CALLS = 5 };

typedef struct areas {
  double area[BALL_SET_MOST];
  hsp_totals totals;
} areas;

/* Answers of the functions for each step. */
static void expected_of(const ball_set *set, double probe, areas *expected) {
  hsp_model_options options;
  computed c;
  memset(expected, 0, sizeof *expected);
  CHECK_EQUAL(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.probe = probe;
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK)) {
    CHECK_EQUAL(hsp_boundary_measure(c.boundary, NULL, &expected->totals, expected->area, NULL, set->n, NULL), HSP_OK);
  }
  computed_release(&c);
}

/* From no bytes on, in memory that is not aligned; how many calls it takes. */
static int grown(const ball_set *set, double probe, const areas *expected) {
  areas found;
  size_t bytes = 0, before;
  int calls = 1;
  memset(&found, 0, sizeof found);
  CHECK_EQUAL(hsp_areas(set->n, set->xyz, set->radius, probe, NULL, &bytes, &found.totals, found.area), HSP_E_CAPACITY);
  for (; calls < MOST_CALLS; ++calls) {
    guarded_memory memory = guarded_take(bytes, 13, GUARDED_RANDOM);
    int32_t status;
    before = bytes;
    status = hsp_areas(set->n, set->xyz, set->radius, probe, memory.block, &bytes, &found.totals, found.area);
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
    if (status == HSP_OK) break;
    CHECK_EQUAL(status, HSP_E_CAPACITY);
    CHECK(bytes > before);
  }
  CHECK(calls < MOST_CALLS && bytes == before);
  CHECK_BYTES(&found, expected, sizeof found);
  return calls;
}

static void every_way(const ball_set *set, hsp_workspace *work, int most_calls) {
  static const double probes[] = {0, 1.4};
  int k;
  for (k = 0; k < 2; ++k) {
    areas expected, found;
    size_t bytes = 0, less;
    guarded_memory memory;
    check_scene("%s, probe %g", set->name, probes[k]);
    expected_of(set, probes[k], &expected);
    CHECK(grown(set, probes[k], &expected) <= most_calls);
    memset(&found, 0, sizeof found);
    CHECK_EQUAL(hsp_workspace_areas(work, set->n, set->xyz, set->radius, probes[k], &found.totals, found.area), HSP_OK);
    CHECK_BYTES(&found, &expected, sizeof found);
    CHECK(work->boundary != NULL);

    CHECK_EQUAL(hsp_areas_bytes(set->n, &bytes), HSP_OK);
    CHECK(bytes <= HSP_AREAS_BYTES(set->n)); /* hsp_areas_bytes, property 1 */
    less = bytes - 1;
    memory = guarded_take(bytes, 0, GUARDED_RANDOM);
    memset(&found, 0, sizeof found);
    CHECK_EQUAL(hsp_areas(set->n, set->xyz, set->radius, probes[k], memory.block, &less, &found.totals, found.area),
                HSP_E_CAPACITY);
    CHECK_EQUAL(less, bytes);
    CHECK(found.totals.area == 0 && found.area[0] == 0);
    if (most_calls == 1) {
      CHECK_EQUAL(hsp_areas(set->n, set->xyz, set->radius, probes[k], memory.block, &bytes, &found.totals, NULL),
                  HSP_OK);
      CHECK_EQUAL(hsp_areas(set->n, set->xyz, set->radius, probes[k], memory.block, &bytes, NULL, found.area), HSP_OK);
      CHECK_BYTES(&found, &expected, sizeof found);
      CHECK_EQUAL(hsp_areas(set->n, set->xyz, set->radius, probes[k], memory.block, &bytes, NULL, NULL), HSP_OK);
    }
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
}

static void refused(void) {
  static unsigned char memory[HSP_AREAS_BYTES(THREE_BALLS)];
  static const double bad[3 * THREE_BALLS] = {0, 0, 0, 1, NAN, 0, 0, 0, 0}, negative[THREE_BALLS] = {1, -1, 1};
  const double *const xyz = three_balls_xyz, *const radius = three_balls_radius;
  hsp_totals totals = {-7, -7, {0, 0}};
  size_t bytes = sizeof memory;
  check_scene("refused");
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, radius, 0, NULL, &bytes, &totals, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, radius, 0, memory, NULL, &totals, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, NULL, radius, 0, memory, &bytes, &totals, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, NULL, 0, memory, &bytes, &totals, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, bad, radius, 0, memory, &bytes, &totals, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, radius, INFINITY, memory, &bytes, &totals, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, radius, -1, memory, &bytes, &totals, NULL), HSP_E_NEGATIVE);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, negative, 0, memory, &bytes, &totals, NULL), HSP_E_NEGATIVE);
  CHECK_EQUAL(hsp_areas(HSP_MAX_BALLS / 8, xyz, radius, 0, memory, &bytes, &totals, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_areas_bytes(HSP_MAX_BALLS / 8, &bytes), HSP_E_RANGE);
  CHECK_EQUAL(hsp_areas_bytes(THREE_BALLS, NULL), HSP_E_ARGUMENT);
  CHECK(totals.area == -7 && totals.volume == -7 && bytes == sizeof memory);
  bytes = 1;
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, radius, 0, NULL, &bytes, &totals, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(bytes, 1);
  bytes = 0; /* a null pointer comes before what there is no room for */
  CHECK_EQUAL(hsp_areas(THREE_BALLS, NULL, radius, 0, NULL, &bytes, &totals, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_areas(THREE_BALLS, xyz, NULL, 0, NULL, &bytes, &totals, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(bytes, 0);
  bytes = sizeof memory;
  CHECK_EQUAL(hsp_areas(0, NULL, NULL, 0, memory, &bytes, &totals, NULL), HSP_OK);
  CHECK(totals.area == 0 && totals.volume == 0);
}

/* One ball with more neighbours than the first limits allow. */
static void many_neighbours(hsp_workspace *work) {
  static ball_set set;
  uint32_t i;
  ball_set_start(&set, "hedgehog", 1e-6);
  ball_set_add(&set, 0, 0, 0, 10);
  for (i = 0; i + 1 < BALL_SET_MOST; ++i) {
    const double z = 1 - (2.0 * i + 1) / (BALL_SET_MOST - 1), along = 2.399963 * i, across = sqrt(1 - z * z);
    ball_set_add(&set, floor(1e7 * across * cos(along)) / 1e6, floor(1e7 * across * sin(along)) / 1e6,
                 floor(1e7 * z) / 1e6, 0.75);
  }
  every_way(&set, work, 3);
}

int main(void) {
  static ball_set set;
  hsp_workspace work;
  uint32_t which;
  memset(&work, 0, sizeof work);
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &set);
    every_way(&set, &work, 1);
  }
  many_neighbours(&work);
  refused();
  hsp_workspace_free(&work);
  return check_report();
}
