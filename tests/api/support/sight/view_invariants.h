/* Invariants of any computed view: what the header promises of it. Each function returns NULL, or a sentence about the
 * first one that does not hold. Later ones rely on what the earlier ones have found sound. */
#pragma once

#include "decided_count.h"
#include "view_result.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The records, then the arcs. */
const char *broken_view(const view_result *v);

/* The frame, how pieces, loops and arcs are numbered and joined, and their order. Time is quadratic in the number of
 * balls. */
const char *broken_view_records(const view_result *v);

/* The numbers of each arc, and the areas that arcs enclose. */
const char *broken_view_arcs(const view_result *v);

/* The regions that loops enclose against the definition of a piece, and the last piece painted against the ball that is
 * seen, at `samples` points of every ball, chosen by seed. The counts are of points of pieces, and of points at which a
 * ball is seen. */
const char *broken_view_regions(const view_result *v, uint32_t samples, uint64_t seed);
extern decided_count view_pieces_decided, view_sights_decided;

/* The order of the balls has no effect but on ids. `other` has the balls of v in another order: doubles agree bit for
 * bit, and records come in the same order. */
const char *view_difference_after_permutation(const view_result *v, const view_result *other);

/* Front parts of the boundary have the same area in the view plane as back parts: two views of HSP_PIECES_OUTSIDE_ALL
 * and HSP_VIEW_ALL_BALLS from opposite directions. */
const char *view_difference_from_behind(const view_result *front, const view_result *back);

/* The allowed error of a position: parts of the set's extent and of `radius`. */
double view_rounding(const view_result *v, double radius);

#ifdef __cplusplus
}
#endif
