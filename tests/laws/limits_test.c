/* The section LIMITS of hardsphere.h: a computation succeeds with exactly the limits that come back from a success, and
 * fails if any of them is one less. Then the limits that come back lead to success in a few steps; in each step no
 * limit becomes smaller and at least one becomes larger. */
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
  for (k = 1; k < numbers; ++k) CHECK(limits[k] == needed[k] || limits[k] == 0); /* 0: for something else */
}

/* Whether limit k is of no use to f: room for workers, in a function without an executor. */
static int is_of_no_use(const function *f, const char *base, int k) {
  size_t d;
  for (d = 0; d < registry_fields_size; ++d) {
    const field *const part = &registry_fields[d];
    if (strcmp(part->of, base) == 0 && part->offset == 4 * (size_t)k)
      return strcmp(part->name, "workers") == 0 && !has_status(f, HSP_E_EXECUTOR);
  }
  return 0;
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
  for (k = 1; k < numbers; ++k) {
    uint32_t less[NUMBERS], back[NUMBERS];
    int32_t status;
    if (needed[k] == 0 || is_of_no_use(f, f->arguments[place].base, k)) continue;
    memcpy(less, needed, sizeof less);
    --less[k];
    memcpy(back, less, sizeof back);
    status = compute_with(f, capacity, back);
    if (less[k] == 0 && status == HSP_OK) continue; /* a limit for which 0 has a meaning of its own */
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
