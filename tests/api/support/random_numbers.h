/* Random numbers that are the same everywhere, by the mixing function of SplitMix64.
 * Steele, Lea, Flood: "Fast splittable pseudorandom number generators" (2014). */
#pragma once

#include <stdint.h>

static inline uint64_t random_next(uint64_t *state) {
  uint64_t z = (*state += UINT64_C(0x9E3779B97F4A7C15));
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  return z ^ (z >> 31);
}

static inline int random_below(uint64_t *state, int limit) {
  return (int)(random_next(state) % (uint64_t)limit);
}

/* In [0, 1). */
static inline double random_fraction(uint64_t *state) {
  return (double)(random_next(state) >> 11) * 0x1p-53;
}
