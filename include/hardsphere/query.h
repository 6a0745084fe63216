/* hardsphere/query.h: which balls contain a point, meet a ball, meet each other (Section 3).
 *
 * Balls are closed: touching counts. Query positions and radii are rounded to the model's lattice, then decided
 * exactly. Hits are the caller's ball indices, ascending, without duplicates. Radii include the model's probe. All
 * return HSP_E_ARGUMENT for a null pointer (ids may be NULL with capacity 0), HSP_E_NOT_FINITE for NaN or infinities,
 * HSP_E_RANGE for a position beyond 2^50 lattice steps or a radius beyond 2^51, HSP_E_CAPACITY as described above. */
#ifndef HARDSPHERE_QUERY_H
#define HARDSPHERE_QUERY_H

#include "model.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The balls that contain the point xyz [3]. Cost: O(1) expected for sets as in Theorem 2.1. */
HSP_API int32_t hsp_query_point(const hsp_model *model, const double *xyz, uint32_t *ids, uint32_t capacity,
                                uint32_t *needed);

/** The balls that meet the ball with centre xyz [3] and the given radius (>= 0, else HSP_E_NEGATIVE).
 *  Cost: O(1) expected for radius <= r_max; for larger radii proportional to the cubes within reach, at most to n. */
HSP_API int32_t hsp_query_ball(const hsp_model *model, const double *xyz, double radius, uint32_t *ids,
                               uint32_t capacity, uint32_t *needed);

/** Whether any ball meets that query ball: *meets becomes 1 or 0. Stops at the first hit. Cost as hsp_query_ball. */
HSP_API int32_t hsp_query_meets(const hsp_model *model, const double *xyz, double radius, int32_t *meets);

/** The other balls that meet ball `ball` of the model. HSP_E_ID: no such ball. Cost: O(1) expected.
 *  Property 1: j is listed for i exactly if i is listed for j. */
HSP_API int32_t hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity,
                                     uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
