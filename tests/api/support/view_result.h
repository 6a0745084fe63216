/* A view of a computed set and everything the interface tells about it, in memory of its own. */
#ifndef HSP_TESTS_VIEW_RESULT_H
#define HSP_TESTS_VIEW_RESULT_H

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct view_result {
  const computed *base; /* what it was computed from; must outlive it */
  hsp_view_options options;
  int with_boundary; /* whether the boundary was handed in */
  void *memory;
  hsp_view *view;
  hsp_view_limits needed; /* exactly */
  uint32_t enlargements;  /* how often limits had to be raised, starting from none of anything but balls */
  hsp_view_info info;
  hsp_view_piece *pieces;
  hsp_view_loop *loops;
  hsp_view_arc *arcs;
} view_result;

/* Computes and reads everything; H-pieces need the boundary. The first status that is not HSP_OK, or HSP_OK. To be
 * followed by view_result_release in either case. */
int32_t view_result_make(const computed *base, const hsp_view_options *options, int with_boundary, view_result *result);

void view_result_release(view_result *result);

/* How such handles are made; they are computed from a `view_result`, which needs but its base and options. */
extern const handle_kind view_handle;

/* Rounding of positions: parts of the set's extent and of the radius that matters. */
double view_rounding(const view_result *result, double radius);

/* NULL, or a sentence about the first invariant of the records that does not hold: the frame, how pieces, loops and
 * arcs are numbered and joined, and their order. Time is quadratic in the number of balls. */
const char *broken_view_records(const view_result *result);

/* The same for the numbers of each arc, and for the areas that arcs enclose. The records must be sound. */
const char *broken_view_arcs(const view_result *result);

/* Both, one after the other. */
const char *broken_view(const view_result *result);

/* NULL, or a sentence about where the regions that the loops enclose are not the pieces as they are defined, and about
 * where the last piece painted is not the ball that is seen. Looks at `samples` points of every ball, chosen by seed.
 */
const char *broken_view_regions(const view_result *result, uint32_t samples, uint64_t seed);

/* NULL, or a sentence about where two results differ although the balls of `other` are those of `result` in another
 * order. Everything but ids must agree, doubles bit for bit and records in their order. */
const char *view_difference_after_permutation(const view_result *result, const view_result *other);

/* NULL, or a sentence, if front parts of the boundary have another area in the view plane than back parts: two views of
 * HSP_PIECES_H and HSP_VIEW_ALL_BALLS from opposite directions. */
const char *view_difference_from_behind(const view_result *front, const view_result *back);

#ifdef __cplusplus
}
#endif

#endif
