#include "limit_sweep.h"

#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "output_sweep.h"

static limit_numbers exact_limits(const known_handle *known) {
  limit_numbers limits;
  memset(&limits, 0, sizeof limits);
  memcpy(&limits, known->needed, known->kind->struct_size);
  return limits;
}

/* ---- limits ---- */

/* The limits after HSP_E_CAPACITY: larger than given only where that was too small, and somewhere. */
static void check_retry(const known_handle *known, const limit_numbers *exact, const limit_numbers *given,
                        const limit_numbers *says) {
  int which, asked = 0;
  CHECK_EQUAL(says->number[0], known->kind->struct_size);
  for (which = known->kind->limits + 1; which < LIMIT_NUMBERS; ++which) {
    CHECK_EQUAL(says->number[which], given->number[which]);
  }
  for (which = 1; which <= known->kind->limits; ++which) {
    CHECK(says->number[which] >= given->number[which]);
    if (says->number[which] > given->number[which]) asked = CHECK(given->number[which] < exact->number[which]);
  }
  CHECK(asked);
  if (known->check_asked != NULL) known->check_asked(given, says, exact);
}

/* A computation with room for `limits`, which become those to retry with. Whether they were enough. */
static int try_once(const known_handle *known, limit_numbers *limits, size_t misalignment) {
  const handle_kind *kind = known->kind;
  const limit_numbers exact = exact_limits(known), given = *limits;
  size_t bytes = 0;
  guarded_memory memory;
  void *handle = NULL;
  int enough = 1, which;
  for (which = 1; which <= kind->limits; ++which) {
    if (limits->number[which] < exact.number[which]) enough = 0;
  }
  if (!CHECK_EQUAL(kind->bytes(limits, &bytes), HSP_OK)) return 1;
  memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
  CHECK_EQUAL(kind->init(memory.block, bytes, limits, &handle), HSP_OK);
  CHECK_EQUAL(kind->compute(handle, known->source, limits), enough ? HSP_OK : HSP_E_CAPACITY);
  if (enough) {
    CHECK_BYTES(limits, &exact, sizeof exact);
    known->check_results(handle, known->source);
  } else {
    check_retry(known, &exact, &given, limits);
    known->check_no_results(handle);
  }
  CHECK(guarded_clean(&memory));
  guarded_give_back(&memory);
  return enough;
}

void try_limits(const known_handle *known, const limit_numbers *from, size_t misalignment) {
  limit_numbers limits = *from;
  const uint32_t most = MOST_ENLARGEMENTS + known->kind->more_enlargements;
  uint32_t enlargements;
  for (enlargements = 0; enlargements <= most; ++enlargements) {
    if (try_once(known, &limits, misalignment)) return;
  }
  check_true(0, "as many enlargements as the header says lead to success", __FILE__, __LINE__);
}

void sweep_limits(const known_handle *known, const char *name) {
  const handle_kind *kind = known->kind;
  const limit_numbers exact = exact_limits(known);
  limit_numbers limits = exact, none;
  int which, i;
  memset(&none, 0, sizeof none);
  none.number[0] = kind->struct_size;
  check_scene("%s, all limits exact", name);
  try_limits(known, &exact, 1);
  for (which = 1; which <= kind->limits; ++which) {
    const uint32_t needed = exact.number[which];
    uint32_t values[AROUND];
    limit_numbers alone = none;
    values_around(needed, values);
    for (i = 0; i < AROUND; ++i) {
      check_scene("%s, %s %u of %u", name, kind->names[which], (unsigned)values[i], (unsigned)needed);
      limits.number[which] = values[i];
      try_limits(known, &limits, (size_t)(3 * i + which - 1));
    }
    limits.number[which] = needed;
    check_scene("%s, enough %s alone", name, kind->names[which]);
    alone.number[which] = needed;
    try_limits(known, &alone, 5);
  }
  check_scene("%s, nothing at all", name);
  try_limits(known, &none, 7);
}

void sweep_every_limit(const known_handle *known, const char *name) {
  const limit_numbers exact = exact_limits(known);
  int which;
  for (which = 1; which <= known->kind->limits; ++which) {
    limit_numbers limits = exact;
    uint32_t value;
    for (value = 0; value < exact.number[which]; ++value) {
      check_scene("%s, %s %u of %u", name, known->kind->names[which], (unsigned)value, (unsigned)exact.number[which]);
      limits.number[which] = value;
      try_limits(known, &limits, value % 16);
    }
  }
}

/* ---- memory ---- */

void sweep_alignments(const known_handle *known, void (*more)(void *handle, const void *source)) {
  const handle_kind *kind = known->kind;
  const limit_numbers exact = exact_limits(known);
  size_t misalignment, bytes = 0;
  CHECK_EQUAL(kind->bytes(&exact, &bytes), HSP_OK);
  for (misalignment = 0; misalignment < 16; ++misalignment) {
    guarded_memory memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
    guarded_memory less = guarded_take(bytes - 1, misalignment, GUARDED_PATTERN);
    void *handle = NULL;
    check_scene("misalignment %u", (unsigned)misalignment);
    CHECK_EQUAL(kind->init(less.block, bytes - 1, &exact, &handle), HSP_E_MEMORY);
    CHECK(handle == NULL);
    CHECK(guarded_untouched(&less, GUARDED_PATTERN) && guarded_clean(&less));
    CHECK_EQUAL(kind->init(memory.block, bytes, &exact, &handle), HSP_OK);
    CHECK((unsigned char *)handle >= memory.block && (unsigned char *)handle < memory.block + bytes);
    CHECK_EQUAL(kind->compute(handle, known->source, NULL), HSP_OK);
    known->check_results(handle, known->source);
    if (more != NULL) {
      more(handle, known->source);
      known->check_results(handle, known->source);
    }
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
    guarded_give_back(&less);
  }
  check_scene("%s", "");
}

size_t size_of(const handle_kind *kind, const size_bound *bound, const limit_numbers *limits) {
  double most = bound->factors[0];
  size_t bytes = 0;
  int which;
  if (kind->bytes(limits, &bytes) == HSP_OK) return bytes;
  CHECK_EQUAL(kind->bytes(limits, &bytes), HSP_E_RANGE);
  for (which = 1; which <= kind->limits; ++which) most += bound->factors[which] * limits->number[which];
  CHECK(most > (double)(SIZE_MAX / 2) || (bound->too_many_items > 0 && most > bound->too_many_items));
  return SIZE_MAX;
}

void sweep_sizes(const handle_kind *kind, const size_bound *bound, const uint32_t *values, int count) {
  int place[LIMIT_NUMBERS] = {0}; /* in `values`, of every limit; counts up like the digits of a number */
  int which;
  do {
    limit_numbers limits;
    size_t bytes;
    memset(&limits, 0, sizeof limits);
    limits.number[0] = kind->struct_size;
    for (which = 1; which <= kind->limits; ++which) limits.number[which] = values[place[which]];
    check_scene("limits %u %u %u %u", (unsigned)limits.number[1], (unsigned)limits.number[2],
                (unsigned)limits.number[3], (unsigned)limits.number[4]);
    bytes = size_of(kind, bound, &limits);
    CHECK(bytes > 0 && (bytes == SIZE_MAX || bytes <= bound->macro(&limits)));
    for (which = 1; which <= kind->limits; ++which) {
      limit_numbers less = limits;
      if (place[which] == 0) continue;
      less.number[which] = values[place[which] - 1];
      CHECK(bytes >= size_of(kind, bound, &less));
    }
    for (which = kind->limits; which > 0 && ++place[which] == count; --which) place[which] = 0;
  } while (which > 0);
  check_scene("%s", "");
}
