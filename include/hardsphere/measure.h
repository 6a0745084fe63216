/* hardsphere/measure.h: areas and volumes of the union, of each ball and of each face.
 *
 * Guide: tutorial.md, exactness.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to. */
#ifndef HARDSPHERE_MEASURE_H
#define HARDSPHERE_MEASURE_H

#include "boundary.h"
#include "executor.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Area and volume of the union. Frozen. */
typedef struct hsp_totals {
  double area;          /**< of the boundary, walls of voids included, length^2 */
  double volume;        /**< of the union, voids not included, length^3 */
  uint64_t reserved[2]; /**< 0 */
} hsp_totals;

/** Bytes of memory that suffice for hsp_areas of most molecules of n balls: a model, and a boundary with the limits of
 *  hsp_boundary_limits_init.
 *  - Property 1: at most HSP_AREAS_BYTES(n).
 *
 *  @retval HSP_E_ARGUMENT  bytes is NULL
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 64) / 8 balls, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_areas_bytes(uint32_t n, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays of some hundred balls at most: for
 *  larger sets it is more than need be. */
#define HSP_AREAS_BYTES(balls) ((size_t)18432 + (size_t)1952 * (size_t)(balls))

/** Areas and volume of n balls in one call: the solvent-accessible area of each ball, and area and volume of the union.
 *  The balls have centres xyz [n][3] and radii radius [n] + probe. memory has *bytes bytes of any alignment, in which a
 *  model and a boundary are made; nothing of it is needed afterwards. If it does not suffice, *bytes becomes a larger
 *  number: call again with so many bytes, four times at most. memory may be NULL with *bytes 0. totals and area [n] may
 *  each be NULL.
 *  - Property 1: area and totals are those of hsp_boundary_measure, bit for bit.
 *
 *  Cost: that of hsp_model_set, hsp_boundary_compute and hsp_boundary_measure; where hsp_areas_bytes does not suffice,
 *  some of it several times.
 *  @retval HSP_E_ARGUMENT    bytes is NULL, or memory with *bytes above 0; xyz or radius is NULL with n > 0
 *  @retval HSP_E_CAPACITY    the memory does not suffice; nothing but *bytes and the memory is written
 *  @retval HSP_E_NOT_FINITE  a coordinate, a radius or the probe is NaN or infinite; hsp_model_set names the ball
 *  @retval HSP_E_NEGATIVE    a radius or the probe is negative
 *  @retval HSP_E_RANGE       a coordinate or radius lies beyond the lattice, or all lengths are below 1.05e-16; more
 *                            balls than hsp_areas_bytes allows */
HSP_API int32_t HSP_CALL hsp_areas(uint32_t n, const double *xyz, const double *radius, double probe, void *memory,
                                   size_t *bytes, hsp_totals *totals, double *area);

/** Area and volume of the union, and each ball's terms of both, or those of some balls while the others only block.
 *  selected [n] holds one byte per ball, 0 or not 0; NULL selects all. Other balls count 0; the selected ones have the
 *  same bits as without a selection. totals may be NULL; area [n] and volume_term [n] may each be NULL, else capacity
 *  >= n; they are in the caller's order; needed may be NULL and else becomes n.
 *  area[i] is the free area of ball i. volume_term[i] is ball i's term of the divergence theorem,
 *  (r_i area[i] + (c_i - o) . N_i) / 3 with N_i the vector area of its faces and o a centre of its component that does
 *  not depend on the order of the balls: the terms sum to the volume, single terms may be negative. The volume of an
 *  atom is that of its share of the union: hsp_contacts_measure.
 *  Totals are summed over the balls in the caller's order by a fixed binary tree. Totals of bricks.h are sums of
 *  integers, and differ in the last bits.
 *  - Property 1: area[i] and volume_term[i] do not depend on the order of the balls, bit for bit.
 *
 *  Accuracy: about 1e-14 of the total for molecules. In general an area has an error of a few 1e-16 of r^2, and of its
 *  own size, for each of its arcs and circles. A volume term has r times that error, and some 1e-16 of area[i] times
 *  the distance from o. A total of n terms adds up the errors of its terms, and log2(n) 1e-16 of the sum of their
 *  magnitudes.
 *  Cost: O(n + arcs and circles of the selected balls' faces).
 *  @retval HSP_E_ARGUMENT  boundary is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals,
                                              double *area, double *volume_term, uint32_t capacity, uint32_t *needed);

/** Which balls count, and threads. Zero means default in every field but the first. */
typedef struct hsp_measure_request {
  uint32_t struct_size;         /**< sizeof(hsp_measure_request) */
  uint32_t reserved;            /**< 0 */
  const uint8_t *selected;      /**< [n], or NULL for all: 0 for balls that only block */
  const hsp_executor *executor; /**< or NULL: the threads that share the work */
} hsp_measure_request;

/** The results that are wanted, and where they go. */
typedef struct hsp_measure_outputs {
  uint32_t struct_size; /**< sizeof(hsp_measure_outputs) */
  uint32_t capacity;    /**< entries that each array [n] has room for */
  uint32_t needed;      /**< becomes n */
  uint32_t reserved;    /**< 0 */
  hsp_totals *totals;   /**< or NULL; volume is NaN for a boundary of selected balls */
  double *area;         /**< [n], or NULL: free area of each ball */
  double *volume_term;  /**< [n], or NULL: each ball's term of the volume, which is no volume of an atom */
} hsp_measure_outputs;

/** The same as hsp_boundary_measure, with a selection and threads in a request; request may be NULL: all defaults.
 *  - Property 1: totals, area and volume_term are those of hsp_boundary_measure for every number of workers, bit for
 *    bit.
 *
 *  Cost: O(n + arcs and circles of the selected balls' faces).
 *  @retval HSP_E_ARGUMENT  boundary or outputs is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request, outputs or executor, or reserved is not 0
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but outputs->needed is written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since; of selected balls, and volume_term is
 *                          given
 *  @retval HSP_E_EXECUTOR  the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED   the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_get_measures(const hsp_boundary *boundary, const hsp_measure_request *request,
                                                   hsp_measure_outputs *outputs);

/** Area, and term of the volume, of each face: area [faces] and volume_term [faces], each may be NULL, face ids as in
 *  hsp_boundary_get_faces. A face's volume term is its term of the divergence theorem about the origin o of its ball's
 *  component (hsp_boundary_measure). needed may be NULL and else becomes the number of faces.
 *  - Property 1: the faces of a ball sum to that ball's area and volume_term, up to rounding.
 *
 *  Accuracy: that of hsp_boundary_measure; of a small face on a large ball it is coarse.
 *  Cost: O(n + vertices + circles).
 *  @retval HSP_E_ARGUMENT  boundary is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is less than the number of faces; nothing but *needed is
 *                          written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume_term,
                                                    uint32_t capacity, uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
