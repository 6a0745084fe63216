/* The section LIMITS of hardsphere.h: a computation succeeds with exactly the limits that come back from a success, and
 * fails if any of them is one less. Then the limits that come back lead to success in a few steps; in each step no
 * limit becomes smaller and at least one becomes larger. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fenced_memory.h"
#include "handle_kind.h"
#include "law.h"

enum { NUMBERS = LIMIT_BYTES / 4, MOST_RETRIES = 40 };

/* The place of the limits if the law applies to f, else -1. Functions that continue with the contents of a handle have
 * tests of their own. */
static int limits_of(const function *f) {
  const int place = place_of(f, "limits");
  if (place <= 0 || f->arguments[place].kind != KIND_sized || f->arguments[0].kind != KIND_handle) return -1;
  return strstr(f->name, "_compute") != NULL || strstr(f->name, "hsp_moving_set") != NULL ? place : -1;
}

/* The name of limit k of f. */
static const char *name_of_limit(const function *f, int k) {
  const char *const base = f->arguments[limits_of(f)].base;
  size_t d;
  for (d = 0; d < registry_fields_size; ++d) {
    const field *const part = &registry_fields[d];
    if (strcmp(part->of, base) == 0 && part->offset == 4 * (size_t)k) return part->name;
  }
  return "";
}

/* Limits for which 0 has a meaning of its own: one worker, and simplices that are only counted. */
static int may_be_0(const char *limit) {
  return strcmp(limit, "workers") == 0 || strcmp(limit, "triangles") == 0 || strcmp(limit, "tetrahedra") == 0;
}

/* Whether f needs nothing of this limit with base arguments. All others have to come back from a success, so that none
 * stays 0 because the function forgets it. The first row that suits is valid. */
static int is_unneeded(const function *f, const char *limit) {
  static const char *const rows[][2] = {{"hsp_boundary_compute_with", "|neighbours|vertices|circles|"},
                                        {"hsp_contacts_", "|tetrahedra|"},
                                        {"hsp_periodic_", "|vertices|"},
                                        {"hsp_surface_", "|neighbours|pieces|arcs|cusped_circles|"},
                                        {"hsp_paths_", "|points|"},
                                        {"hsp_pores_compute_periodic", "|points|"},
                                        {"hsp_pores_", "|gates|points|"}};
  char between[64];
  size_t k;
  snprintf(between, sizeof between, "|%s|", limit);
  for (k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
    if (strncmp(f->name, rows[k][0], strlen(rows[k][0])) == 0) return strstr(rows[k][1], between) != NULL;
  }
  return 0;
}

/* Whether a limit is of no use to f: room for workers, in a function without an executor. */
static int is_of_no_use(const function *f, const char *limit) {
  return strcmp(limit, "workers") == 0 && !has_status(f, HSP_E_EXECUTOR);
}

/* Calls f with a new handle made with these limits; *limits becomes what comes back. */
static int32_t compute_with(const function *f, uint32_t capacity, uint32_t *limits) {
  const int noun = f->arguments[0].noun, place = limits_of(f);
  void *memory, *handle = NULL;
  size_t bytes = 0;
  call c;
  call_prepare(&c, f, capacity);
  CHECK_EQUAL(handle_bytes(noun, limits, &bytes), HSP_OK);
  memory = test_zeros(bytes, 1);
  CHECK_EQUAL(handle_init(noun, memory, bytes, limits, &handle), HSP_OK);
  c.v[0].p = handle;
  memcpy(c.v[place].p, limits, f->arguments[place].size);
  law_run(&c, "limits", "");
  memcpy(limits, fence_data(place), f->arguments[place].size);
  free(memory);
  return (int32_t)c.result;
}

static void check_growth(const uint32_t *own, const uint32_t *back, int numbers) {
  int k, larger = 0;
  for (k = 1; k < numbers; ++k) {
    CHECK(back[k] >= own[k]);
    larger |= back[k] > own[k];
  }
  CHECK(larger);
}

static void grow(const function *f, uint32_t capacity, const uint32_t *from, const uint32_t *needed, int numbers) {
  uint32_t limits[NUMBERS];
  int retries, k;
  memcpy(limits, from, sizeof limits);
  for (retries = 0; retries <= MOST_RETRIES; ++retries) {
    uint32_t own[NUMBERS];
    int32_t status;
    memcpy(own, limits, sizeof own);
    status = compute_with(f, capacity, limits);
    if (status == HSP_OK) break;
    CHECK_EQUAL(status, HSP_E_CAPACITY);
    check_growth(own, limits, numbers);
  }
  CHECK(retries <= MOST_RETRIES);
  for (k = 1; k < numbers; ++k) CHECK(limits[k] == needed[k] || (limits[k] == 0 && may_be_0(name_of_limit(f, k))));
}

static void limits(const function *f, uint32_t capacity) {
  const int place = limits_of(f), numbers = place < 0 ? 0 : (int)f->arguments[place].size / 4;
  uint32_t needed[NUMBERS] = {0}, again[NUMBERS];
  int k;
  call c;
  if (place < 0) return;
  call_prepare(&c, f, capacity);
  law_succeeds(&c, "limits that are large enough", "");
  memcpy(needed, fence_data(place), f->arguments[place].size);
  memcpy(again, needed, sizeof needed);
  CHECK_EQUAL(compute_with(f, capacity, again), HSP_OK);
  CHECK_BYTES(again, needed, sizeof needed);
  for (k = 1; k < numbers; ++k) CHECK_EQUAL(needed[k] == 0, is_unneeded(f, name_of_limit(f, k)));
  for (k = 1; k < numbers; ++k) {
    uint32_t less[NUMBERS], back[NUMBERS];
    int32_t status;
    if (needed[k] == 0 || is_of_no_use(f, name_of_limit(f, k))) continue;
    memcpy(less, needed, sizeof less);
    --less[k];
    memcpy(back, less, sizeof back);
    status = compute_with(f, capacity, back);
    if (less[k] == 0 && status == HSP_OK && may_be_0(name_of_limit(f, k))) continue;
    CHECK_EQUAL(status, HSP_E_CAPACITY);
    check_growth(less, back, numbers);
    grow(f, capacity, less, needed, numbers);
  }
  memset(again, 0, sizeof again);
  again[0] = needed[0];
  if (needed[1] > 0) grow(f, capacity, again, needed, numbers);
}

int main(void) {
  return check_law(limits);
}
