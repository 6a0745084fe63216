/* hardsphere/measure.h: areas and volumes.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to. */
#ifndef HARDSPHERE_MEASURE_H
#define HARDSPHERE_MEASURE_H

#include "boundary.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Area and volume of the union. Frozen. */
typedef struct hsp_totals {
  double area;   /**< of the boundary, walls of voids included, length^2 */
  double volume; /**< of the union, voids not included, length^3 */
} hsp_totals;

/** Area and volume of the union, and of each ball, or those of some balls while the others only block.
 *  selected [n] holds one byte per ball, 0 or not 0; NULL selects all. Other balls count 0, and the rest is
 *  the same bit for bit. totals may be NULL; area [n] and volume [n] may each be NULL, else capacity >= n; they are
 *  in the caller's order and do not overlap; needed may be NULL and else becomes n.
 *  area[i] is the free area of ball i. volume[i] is ball i's term of the divergence theorem,
 *  (r_i area[i] + (c_i - o) . N_i) / 3 with N_i the vector area of its faces and o a centre of its component that does
 *  not depend on the order of the balls: the terms sum to the volume, single terms may be negative.
 *  Totals are summed over the balls in the caller's order by a fixed binary tree.
 *  - Property 1: area[i] and volume[i] do not depend on the order of the balls, bit for bit.
 *
 *  Accuracy: about 1e-14 of the total for molecules.
 *  Cost: O(n + what the selected balls' faces have of arcs and circles).
 *  @retval HSP_E_ARGUMENT  boundary is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals,
                                     double *area, double *volume, uint32_t capacity, uint32_t *needed);

/** The same in parts, which threads of the caller's own may share: balls first .. first + count - 1, in the caller's
 *  order, into area[first] and volume[first] and so on. The arrays are those of hsp_boundary_measure, each for all
 *  balls; they hold numbers of the library's own until hsp_boundary_measure_end. Ranges that do not overlap may be
 *  measured side by side. Threads that write one cache line wait for each other: long ranges are faster.
 *  @retval HSP_E_ARGUMENT  boundary, area or volume is NULL
 *  @retval HSP_E_ID        there are not so many balls
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t hsp_boundary_measure_range(const hsp_boundary *boundary, const uint8_t *selected, uint32_t first,
                                           uint32_t count, double *area, double *volume);

/** Make of such arrays, once all balls are in them, what hsp_boundary_measure writes; totals may be NULL.
 *  - Property 1: with whatever ranges, area, volume and totals are those of hsp_boundary_measure, bit for bit.
 *
 *  Cost: O(n), far less than measuring.
 *  @retval HSP_E_ARGUMENT  boundary, area or volume is NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t hsp_boundary_measure_end(const hsp_boundary *boundary, hsp_totals *totals, double *area,
                                         double *volume);

/** Area, and term of the volume, of each face: area [faces] and volume [faces], each may be NULL, face ids as in
 *  hsp_boundary_get_faces. A face's volume term is that of the divergence theorem about its ball's origin o (see
 *  hsp_boundary_measure). needed may be NULL and else becomes the number of faces.
 *  - Property 1: the faces of a ball sum to that ball's area and volume, up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  boundary is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is less than the number of faces; nothing but *needed is
 *                          written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume,
                                           uint32_t capacity, uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
