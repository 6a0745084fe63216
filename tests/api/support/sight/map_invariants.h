/* Invariants of any computed map: what the header promises of it. Each function returns NULL, or a sentence about the
 * first one that does not hold. Later ones rely on what the earlier ones have found sound. */
#pragma once

#include "map_result.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Steps, records and areas, and what hsp_map_check says. */
const char *broken_map(const map_result *m);

/* The answers of hsp_map_pick, and what edges have on either side, are what is seen: looks at `samples` points of every
 * ball, chosen by seed, and at one of every edge. */
const char *broken_map_regions(const map_result *m, uint32_t samples, uint64_t seed);

/* The order of the balls has no effect but on ids: those of `other` are those of m in another order. Doubles agree bit
 * for bit, and records in their order. */
const char *map_difference_after_permutation(const map_result *m, const map_result *other);

#ifdef __cplusplus
}
#endif
