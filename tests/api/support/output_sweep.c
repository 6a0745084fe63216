#include "output_sweep.h"

#include <hardsphere.h>

#include "check.h"
#include "guarded_memory.h"

void values_around(uint32_t needed, uint32_t values[AROUND]) {
  values[0] = 0;
  values[1] = 1;
  values[2] = needed == 0 ? 0 : needed - 1;
  values[3] = needed;
  values[4] = needed + 1;
}

void sweep_output(asking ask, const void *question, size_t record, uint32_t expected) {
  uint32_t capacities[AROUND], i, needed = 12345;
  values_around(expected, capacities);
  CHECK_EQUAL(ask(question, NULL, 0, &needed), expected == 0 ? HSP_OK : HSP_E_CAPACITY);
  CHECK_EQUAL(needed, expected);
  for (i = 0; i < AROUND; ++i) {
    const uint32_t capacity = capacities[i];
    /* records are aligned as their type wants, hence a misalignment of 0 */
    guarded_memory out = guarded_take(capacity * record, 0, GUARDED_PATTERN);
    needed = 12345;
    if (capacity < expected) {
      CHECK_EQUAL(ask(question, out.block, capacity, &needed), HSP_E_CAPACITY);
      CHECK(guarded_untouched(&out, GUARDED_PATTERN));
    } else {
      /* all of every record is written, and nothing behind the last */
      guarded_memory again = guarded_take(capacity * record, 0, 0x11);
      CHECK_EQUAL(ask(question, out.block, capacity, &needed), HSP_OK);
      CHECK_EQUAL(ask(question, again.block, capacity, &needed), HSP_OK);
      CHECK_BYTES(out.block, again.block, expected * record);
      CHECK(capacity == expected || out.block[expected * record] == GUARDED_PATTERN);
      CHECK(capacity == expected || again.block[capacity * record - 1] == 0x11);
      CHECK(guarded_clean(&again));
      guarded_give_back(&again);
    }
    CHECK_EQUAL(needed, expected);
    CHECK(guarded_clean(&out));
    guarded_give_back(&out);
  }
}
