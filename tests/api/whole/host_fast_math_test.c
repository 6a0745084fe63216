/* A program that is linked with -ffast-math: compilers add code that flushes subnormal numbers from its first line on.
 * Balls on integers, many of which tie, have the same contacts and complex as where nothing is flushed, in free space
 * and in a box. */
#include <fenv.h>
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "host_environment.h"

enum { MOST = 40, SETS = 1200 };

static uint64_t state = 1;
static uint32_t below(uint32_t n) {
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (uint32_t)(state >> 33) % n;
}

typedef struct balls {
  uint32_t n;
  double xyz[3 * MOST], radius[MOST];
} balls;

/* Radii of up to `largest`, in a cube of this side. */
static void make(balls *set, uint32_t side, uint32_t largest) {
  uint32_t i;
  set->n = 2 + below(MOST - 1);
  for (i = 0; i < 3 * set->n; ++i) set->xyz[i] = (double)below(side);
  for (i = 0; i < set->n; ++i) set->radius[i] = (double)(1 + below(largest));
}

typedef struct answers {
  int32_t status, check;
  hsp_complex complex;
  uint32_t pairs;
  double area[MOST], share[MOST];
} answers;

static void in_space(hsp_workspace *work, const balls *set, answers *out) {
  uint32_t invariant = 0, id = 0;
  memset(out, 0, sizeof *out);
  out->status = hsp_workspace_set(work, set->n, set->xyz, set->radius, NULL, NULL);
  if (out->status == HSP_OK) out->status = hsp_workspace_boundary(work);
  if (out->status == HSP_OK) out->status = hsp_workspace_contacts(work);
  if (out->status == HSP_OK) out->status = hsp_contacts_get_complex(work->contacts, &out->complex);
  if (out->status == HSP_OK) hsp_contacts_get_pairs(work->contacts, NULL, 0, &out->pairs);
  if (out->status == HSP_OK) out->check = hsp_contacts_check(work->contacts, &invariant, &id);
}

static void in_a_box(hsp_workspace *work, const balls *set, answers *out) {
  static const double box[9] = {4, 0, 0, 0, 4, 0, 0, 0, 4};
  memset(out, 0, sizeof *out);
  out->status = hsp_workspace_periodic(work, set->n, set->xyz, set->radius, box, NULL, NULL);
  if (out->status == HSP_OK) {
    out->status = hsp_periodic_measure(work->periodic, NULL, out->area, out->share, set->n, NULL);
  }
  if (out->status == HSP_OK) hsp_periodic_get_contacts(work->periodic, NULL, 0, &out->pairs);
}

int main(void) {
  hsp_workspace work = {0};
  static answers flushed, plain;
  int k;
  if (host_environment_differs(HOST_flushing, 0) != NULL) {
    printf("skipped: this compiler makes no program that flushes\n");
    return 77;
  }
  for (k = 0; k < SETS; ++k) {
    balls set;
    void (*const ask)(hsp_workspace *, const balls *, answers *) = k % 4 == 0 ? in_a_box : in_space;
    make(&set, ask == in_a_box ? 4 : 5, 1 + (uint32_t)k % 3);
    if (ask == in_a_box && set.n > 11) set.n = 11;
    check_scene("set %d", k);
    ask(&work, &set, &flushed);
    CHECK(host_environment_differs(HOST_flushing, 0) == NULL);
    host_environment_set(HOST_default, 0);
    ask(&work, &set, &plain);
    host_environment_set(HOST_flushing, 0);
    CHECK_EQUAL(flushed.status, HSP_OK);
    CHECK_BYTES(&flushed, &plain, sizeof plain);
  }
  hsp_workspace_free(&work);
  return check_report();
}
