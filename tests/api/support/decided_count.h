/* How many of its questions an invariant has decided in this program. Near a tie, or where few digits are left, it
 * decides nothing, and nothing is found broken: tests of many sets limit how often. */
#pragma once

#include <stdint.h>

typedef struct decided_count {
  uint64_t decided, all;
} decided_count;

static inline void count_decided(decided_count *count, int is_decided) {
  ++count->all;
  if (is_decided) ++count->decided;
}

/* Whether there were questions, and at least this share of them was decided. */
static inline int mostly_decided(const decided_count *count, double share) {
  return count->all > 0 && (double)count->decided >= share * (double)count->all;
}
