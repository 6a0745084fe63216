/* Invariants of any computed map: what the header promises of it. Each function returns NULL, or a sentence about the
 * first one that does not hold. Later ones rely on what the earlier ones have found sound. */
#pragma once

#include "decided_count.h"
#include "map_result.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Steps, records and areas, and what hsp_map_check says. */
const char *broken_map(const map_result *m);

/* The owners that hsp_map_pick names, and those on either side of edges, against the fronts of all balls: at `samples`
 * points of every ball, chosen by seed, and beside one point of every edge. The counts are of these points, and of the
 * sides of edges. */
const char *broken_map_regions(const map_result *m, uint32_t samples, uint64_t seed);
extern decided_count map_points_decided, map_sides_decided;

/* The order of the balls has no effect but on ids. `other` has the balls of m in another order: doubles agree bit for
 * bit, and records come in the same order. */
const char *map_difference_after_permutation(const map_result *m, const map_result *other);

#ifdef __cplusplus
}
#endif
