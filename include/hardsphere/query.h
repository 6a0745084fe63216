/* hardsphere/query.h: which balls contain a point, meet a ball, meet each other, are first on a ray (Section 3).
 *
 * Guide: questions.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 * Balls are closed: touching counts. Positions and radii of a query are in length units, and are rounded to the model's
 * lattice; then everything is decided exactly. Hits are the caller's ball indices, ascending, without duplicates. The
 * model's probe is part of the radii of its balls; it is not added to the radius of a query. */
#ifndef HARDSPHERE_QUERY_H
#define HARDSPHERE_QUERY_H

#include "model.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The balls that contain the point xyz [3].
 *
 *  Cost: O(1) expected for sets as in Theorem 2.1; O(c) at worst, and k log k for k hits.
 *  @retval HSP_OK            ids holds the hits; or there are none, also with capacity 0
 *  @retval HSP_E_ARGUMENT    model or xyz is NULL; ids is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    more hits than capacity: *needed is their number, and nothing is written to ids
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  a coordinate is NaN or infinite
 *  @retval HSP_E_RANGE       a coordinate is beyond 2^50 lattice steps */
HSP_API int32_t HSP_CALL hsp_query_point(const hsp_model *model, const double *xyz, uint32_t *ids, uint32_t capacity,
                                         uint32_t *needed);

/** The balls that meet the ball with centre xyz [3] and the given radius.
 *
 *  Cost: O(c) for radius <= r_max, which is O(1) for sets as in Theorem 2.1; for larger radii proportional to the
 *  number of cubes within reach, at most to n; and k log k for k hits.
 *  @retval HSP_OK            ids holds the hits; or there are none, also with capacity 0
 *  @retval HSP_E_ARGUMENT    model or xyz is NULL; ids is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    more hits than capacity: *needed is their number, and nothing is written to ids
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  a coordinate or the radius is NaN or infinite
 *  @retval HSP_E_NEGATIVE    the radius is negative
 *  @retval HSP_E_RANGE       a coordinate is beyond 2^50 lattice steps, or the radius beyond 2^51 */
HSP_API int32_t HSP_CALL hsp_query_ball(const hsp_model *model, const double *xyz, double radius, uint32_t *ids,
                                        uint32_t capacity, uint32_t *needed);

/** Whether any ball meets the ball with centre xyz [3] and the given radius: *meets becomes 1 or 0. The search stops at
 *  the first hit.
 *
 *  Cost: that of hsp_query_ball at worst, where nothing is met and many balls are near.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  a coordinate or the radius is NaN or infinite
 *  @retval HSP_E_NEGATIVE    the radius is negative
 *  @retval HSP_E_RANGE       a coordinate is beyond 2^50 lattice steps, or the radius beyond 2^51 */
HSP_API int32_t HSP_CALL hsp_query_meets(const hsp_model *model, const double *xyz, double radius, uint32_t *meets);

/** The other balls that meet ball `ball` of the model.
 *  - Property 1: j is listed for i exactly if i is listed for j.
 *
 *  Cost: O(1) expected for sets as in Theorem 2.1; O(c) at worst, and k log k for k neighbours.
 *  @retval HSP_OK          ids holds the neighbours; or there are none, also with capacity 0
 *  @retval HSP_E_ARGUMENT  model is NULL; ids is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  more neighbours than capacity: *needed is their number, and nothing is written to ids
 *  @retval HSP_E_STATE     hsp_model_set has failed
 *  @retval HSP_E_ID        the model has no ball `ball` */
HSP_API int32_t HSP_CALL hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity,
                                              uint32_t *needed);

/** Each pair of balls i < j is listed once, as j in the row of i. Without this flag it is in the rows of both. */
#define HSP_PAIRS_ONCE UINT32_C(1)

/** All pairs of balls that meet, as rows of one array: the neighbours of ball i are ids[first[i]] to
 *  ids[first[i + 1] - 1], ascending. flags is 0 or HSP_PAIRS_ONCE. first [n + 1] begins with 0 and ends with the number
 *  of ids; *needed becomes the same number. first is written on HSP_OK and on HSP_E_CAPACITY: with ids NULL and
 *  capacity 0 this function counts the neighbours of each ball, and a second call with capacity first[n] then lists
 *  them.
 *
 *  For a list of all pairs of centres at most a cutoff apart, pairs at exactly the cutoff included, give hsp_model_set
 *  radii that are all 0 and the probe cutoff / 2. The cutoff is then twice the rounded probe, hsp_model_info.probe.
 *  - Property 1: without flags, row i is what hsp_query_neighbours lists for ball i.
 *  - Property 2: with HSP_PAIRS_ONCE, row i holds the ids of that row that are larger than i.
 *
 *  Cost: O(n) expected for sets as in Theorem 2.1, and with a few large balls among small ones; O(n c) at worst, with
 *  all centres in a few cubes, and O(log m) for each id in rows of thousands. That is less than hsp_query_neighbours
 *  for each ball.
 *  @retval HSP_OK          ids holds all rows; or there is no pair, also with capacity 0
 *  @retval HSP_E_ARGUMENT  model or first is NULL; ids is NULL with a capacity above 0; unknown flag
 *  @retval HSP_E_CAPACITY  more ids than capacity: first and *needed are set, and nothing is written to ids
 *  @retval HSP_E_STATE     hsp_model_set has failed
 *  @retval HSP_E_RANGE     more than 2^32 - 1 ids; first becomes 0 everywhere */
HSP_API int32_t HSP_CALL hsp_query_pairs(const hsp_model *model, uint32_t flags, uint32_t *first, uint32_t *ids,
                                         uint32_t capacity, uint32_t *needed);

/** Which pairs are listed, and how. Zero means default in every field but the first. */
typedef struct hsp_pairs_request {
  uint32_t struct_size;         /**< sizeof(hsp_pairs_request) */
  uint32_t flags;               /**< 0 or HSP_PAIRS_ONCE */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_pairs_request;

/** The same as hsp_query_pairs, with flags and an executor in a request; request may be NULL: all defaults.
 *  first [n + 1].
 *  @retval HSP_OK          as hsp_query_pairs
 *  @retval HSP_E_ARGUMENT  model or first is NULL; ids is NULL with a capacity above 0; unknown flag; an executor with
 *                          several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request or executor
 *  @retval HSP_E_CAPACITY  as hsp_query_pairs
 *  @retval HSP_E_STATE     as hsp_query_pairs
 *  @retval HSP_E_RANGE     as hsp_query_pairs
 *  @retval HSP_E_STOPPED   the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_query_pairs_with(const hsp_model *model, const hsp_pairs_request *request, uint32_t *first,
                                              uint32_t *ids, uint32_t capacity, uint32_t *needed);

/** Where a ray first meets a ball. Frozen. */
typedef struct hsp_ray_hit {
  double xyz[3];     /**< the point, length; 0 if there is none */
  double distance;   /**< from the origin to the point, length; infinite if there is none */
  uint32_t ball;     /**< the caller's index; HSP_NONE: the ray meets no ball */
  uint32_t reserved; /**< 0 */
} hsp_ray_hit;

/** The first ball on the ray from origin [3] along direction [3], a vector of any length but 0: the ball that has the
 *  first point of the ray that lies in any ball; of several such balls the one with the lowest index. A ray that
 *  touches a ball meets it. If the origin lies in balls, the one with the lowest index is first, at distance 0.
 *
 *  The direction is rounded too, to integers times a power of two: by at most 2^-53 of its largest component. The first
 *  ball on the rounded ray is decided exactly. The distance then has a relative error of at most 2^-49. Each coordinate
 *  of the point is off by at most 2^-49 times the sum of the origin's and the point's distances from (0, 0, 0).
 *  - Property 1: the order of the balls has no effect but on indices.
 *
 *  Cost: proportional to the number of layers of cubes that the ray crosses up to the hit, at most to n; O(n^(1/3))
 *  expected for sets as in Theorem 2.1 that fill their box.
 *  @retval HSP_OK            *hit is set, whether or not there is one
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  a coordinate or a component is NaN or infinite
 *  @retval HSP_E_RANGE       a coordinate is beyond 2^50 lattice steps, or the direction is 0 0 0 */
HSP_API int32_t HSP_CALL hsp_query_ray(const hsp_model *model, const double *origin, const double *direction,
                                       hsp_ray_hit *hit);

#ifdef __cplusplus
}
#endif

#endif
