/* hardsphere/model.h: a model: a set of balls, rounded to a lattice and hashed into cubes.
 *
 * Guide: robustness.md, guarantees.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 *   size_t bytes;                                hsp_model *model;
 *   hsp_model_bytes(n, &bytes);                  void *memory = malloc(bytes);
 *   hsp_model_init(memory, bytes, n, &model);    hsp_model_set(model, n, xyz, radius, NULL, NULL);
 */
#ifndef HARDSPHERE_MODEL_H
#define HARDSPHERE_MODEL_H

#include "executor.h"
#include "export.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The id that no ball has. */
#define HSP_NONE UINT32_C(0xFFFFFFFF)

/** The largest number of balls in one model, and the largest value of any limit, in the library of this header. It may
 *  grow with a minor version: hsp_model_max_balls tells the number of the library that was linked. */
#define HSP_MAX_BALLS UINT32_C(0x0FFFFFFF)

/** HSP_MAX_BALLS of the library that was linked. */
HSP_API uint32_t HSP_CALL hsp_model_max_balls(void);

/** A set of balls on its lattice. */
typedef struct hsp_model hsp_model;

/** Bytes that hsp_model_init needs for at most `balls` balls, alignment slack included.
 *  - Property 1: at most HSP_MODEL_BYTES(balls).
 *
 *  @retval HSP_E_ARGUMENT  bytes is NULL
 *  @retval HSP_E_RANGE     balls > HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_model_bytes(uint32_t balls, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_MODEL_BYTES(balls) ((size_t)1536 + (size_t)192 * (size_t)(balls))

/** Make an empty model (0 balls) for at most `balls` balls in caller memory of any alignment; sets *model.
 *  @retval HSP_E_ARGUMENT  memory or model is NULL
 *  @retval HSP_E_MEMORY    bytes is less than hsp_model_bytes says; nothing is written
 *  @retval HSP_E_RANGE     balls > HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_model_init(void *memory, size_t bytes, uint32_t balls, hsp_model **model);

/** How hsp_model_set reads the balls. Zero means default in every field but the first. */
typedef struct hsp_model_options {
  uint32_t struct_size; /**< sizeof(hsp_model_options); hsp_model_options_init sets it */
  uint32_t reserved;    /**< 0 */
  double probe;         /**< length, >= 0: added to every radius, for the solvent-accessible surface; default 0 */
  double step;          /**< length, > 0: the lattice step; 0: the power of ten that hsp_model_set says */
  /** length, > 0: no ball may have a radius, without the probe, above it; fixes the lattice. 0: that of the balls */
  double largest_radius;
} hsp_model_options;

/** Fill options with defaults.
 *  @retval HSP_E_ARGUMENT  options is NULL
 *  @retval HSP_E_VERSION   struct_size is bad */
HSP_API int32_t HSP_CALL hsp_model_options_init(hsp_model_options *options, uint32_t struct_size);

/** Take n balls: round them to the lattice, hash them into cubes. May be called any number of times (frames of a
 *  trajectory). Afterwards results that were computed from other balls cannot be read any more (RESULTS in
 *  hardsphere.h).
 *  xyz [n][3] and radius [n], in length units, may be NULL only if n is 0; options may be NULL (defaults);
 *  first_bad may be NULL, else *first_bad becomes the index of the first ball that is refused. It becomes HSP_NONE if
 *  no ball is, if the options are at fault (also by a step that is too small for every radius), or if all lengths are
 *  too small.
 *
 *  The lattice: coordinate x becomes the integer nearest to x/step, radius r becomes the integer nearest to r/step plus
 *  the integer nearest to probe/step. The default step is a power of ten between 1e-22 and 1e22. It is chosen from the
 *  largest radius plus probe, never from coordinates, with one exception: a set of points (all radii and the probe 0,
 *  largest_radius not given). The step of such a set is the smallest power of ten with which every coordinate is below
 *  2^30 steps, where that is at most 1e-8; else the smallest one from 1e-8 on with which no coordinate has more than
 *  2^50 steps. So give the step to models that hold parts of one set of points. Limits: radius plus probe below 2^30
 *  steps, every coordinate at most 2^50 steps, a step that is given 5.6e-309 at least. A default step makes the length
 *  from which it is chosen at least 2^20 steps long: sets whose lengths are all below 1.05e-16 need other units.
 *  Centres that coincide, balls inside others, and balls that touch are all valid. With options.largest_radius lattice
 *  and cubes do not depend on the balls: models with the same options have the same grid, and a ball and its neighbours
 *  give the same bits whatever other balls there are. A ball that is larger on the lattice is HSP_E_RANGE. For given
 *  balls hsp_model_info.largest_radius less the probe is large enough.
 *
 *  On failure the model holds nothing. Until balls are taken again every function that reads the model, except
 *  hsp_model_get_info, returns HSP_E_STATE.
 *  Areas, volumes and energies are doubles in the caller's units: with steps below 1e-100 or above 1e90 they may be 0,
 *  infinite or NaN, while the structure is still right.
 *  - Property 1: the order of the balls has no effect but on the ids.
 *
 *  Cost: O(n) expected, whatever the radii and wherever the balls are; O(n log n) at worst, with many centres in one
 *  cube, as where all balls have one centre.
 *  The hash table's load is at most 1/2. The hash function is public and has no key, so somebody can choose coordinates
 *  that collide. Where a search would look at more than 64 slots, these slots become a tree, in which a search looks at
 *  194 slots at most. A library that is compiled for size has no such tree: there a search looks at all slots that
 *  collide.
 *  @retval HSP_E_ARGUMENT    model is NULL; xyz or radius is NULL with n > 0
 *  @retval HSP_E_VERSION     bad struct_size of options, or its reserved field is not 0
 *  @retval HSP_E_CAPACITY    the model has room for fewer than n balls
 *  @retval HSP_E_NOT_FINITE  a coordinate, a radius or an option is NaN or infinite
 *  @retval HSP_E_NEGATIVE    a radius or an option is negative
 *  @retval HSP_E_RANGE       a coordinate, a radius or an option lies beyond the lattice, or a radius beyond
 *                            options.largest_radius; no step is given, and all lengths are below 1.05e-16 */
HSP_API int32_t HSP_CALL hsp_model_set(hsp_model *model, uint32_t n, const double *xyz, const double *radius,
                                       const hsp_model_options *options, uint32_t *first_bad);

/** How balls are taken. Zero means default in every field but the first. */
typedef struct hsp_model_request {
  uint32_t struct_size;             /**< sizeof(hsp_model_request) */
  uint32_t reserved;                /**< 0 */
  const hsp_model_options *options; /**< or NULL: how balls are read */
  const hsp_executor *executor;     /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_model_request;

/** The same as hsp_model_set, with options and an executor in a request; request and first_bad may be NULL.
 *  @retval HSP_E_ARGUMENT    model is NULL; xyz or radius is NULL with n > 0; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size of request, options or executor, or a reserved field is not 0
 *  @retval HSP_E_CAPACITY    as hsp_model_set
 *  @retval HSP_E_NOT_FINITE  as hsp_model_set
 *  @retval HSP_E_NEGATIVE    as hsp_model_set
 *  @retval HSP_E_RANGE       as hsp_model_set
 *  @retval HSP_E_STOPPED     the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_model_set_with(hsp_model *model, uint32_t n, const double *xyz, const double *radius,
                                            const hsp_model_request *request, uint32_t *first_bad);

/** A description of the model. table_slots and longest_probe may change with a minor version. Frozen. */
typedef struct hsp_model_info {
  uint32_t balls;         /**< number of balls */
  uint32_t cubes;         /**< cubes of side 2 r_max that hold a centre (Section 3) */
  uint32_t table_slots;   /**< slots of the open-addressing table; at least twice the number of cubes */
  uint32_t longest_probe; /**< most slots looked at to find a cube that is there */
  double step;            /**< the lattice step, length */
  double probe;           /**< the probe as rounded to the lattice, length */
  double largest_radius;  /**< r_max, probe included, as rounded to the lattice, length */
  /** half a step divided by the smallest radius above 0, probe included: a bound for how far rounding moves a
   *  coordinate, or without a probe a radius, relative to that radius. 1 if a radius above 0 is rounded to 0; 0 if no
   *  radius is above 0 */
  double largest_rounding;
  uint64_t reserved[2]; /**< 0 */
} hsp_model_info;

/** Describe the model: how many balls and cubes it has, its lattice, and how coarse that is. Without balls the step is
 *  the one that hsp_model_set was given, else the one that largest_radius and probe make, 1e-8 without these and after
 *  a failure. One large radius makes a coarse lattice for all: look at largest_rounding, some 1e-9 for molecules, where
 *  radii differ a lot.
 *  @retval HSP_E_ARGUMENT  a null pointer */
HSP_API int32_t HSP_CALL hsp_model_get_info(const hsp_model *model, hsp_model_info *info);

/** The balls as rounded to the lattice, in the caller's order: xyz [n][3] and radius [n], length, probe included.
 *  Either may be NULL; *needed becomes n.
 *  - Property 1: coordinates differ from those that hsp_model_set was given by half a step at most; radii differ from
 *    the given radius plus probe by half a step at most without a probe, and by a step at most with one. Numbers with
 *    no more decimals than the lattice do not change at all, if the step is a power of ten from 1e-22 to 1e22.
 *  - Property 2: a model that is made of them with the same step and no probe decides everything alike.
 *
 *  @retval HSP_E_ARGUMENT  model is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     hsp_model_set has failed */
HSP_API int32_t HSP_CALL hsp_model_get_balls(const hsp_model *model, double *xyz, double *radius, uint32_t capacity,
                                             uint32_t *needed);

#define HSP_PACKING_ZERO_RADIUS UINT32_C(1) /**< a ball has radius 0 (probe included): k has no value */
#define HSP_PACKING_COINCIDENT UINT32_C(2)  /**< two centres coincide: rho is 0 */
#define HSP_PACKING_NO_PAIR UINT32_C(4)     /**< fewer than two balls, or all radii 0: rho has no value */

/** The figures by which the paper's Section 2 bounds how many balls meet one, of the balls on the lattice. Frozen. */
typedef struct hsp_packing {
  double k;               /**< r_max / r_min; 0 where it has no value (no balls, HSP_PACKING_ZERO_RADIUS) */
  double rho;             /**< min over pairs of |c_i - c_j| / max(r_i, r_j); 0 where it has no value */
  double mean_overlaps;   /**< mean over balls i of the number of others with |c_i - c_j| < r_i + r_j; 0 if n = 0 */
  double neighbour_bound; /**< 216 (k/rho)^3 of Theorem 2.1: no ball meets more others; 0 where it says nothing */
  uint32_t max_overlaps;  /**< the largest of those numbers */
  uint32_t flags;         /**< HSP_PACKING_*; 0 means that Theorem 2.1 holds with this k and rho */
  uint64_t reserved[2];   /**< 0 */
} hsp_packing;

/** The figures of Section 2, and by flags whether the set meets the conditions of Theorem 2.1 at all. A set that does
 *  not meet them is still handled exactly; only the bounds of time and memory are lost. Uses the model's scratch
 *  memory, hence not const.
 *
 *  Cost: O(n) for sets with bounded figures, and for small balls and a few much larger ones, as of a colloid in its
 *  solvent; O(n c) at worst, with all centres in a few cubes.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     hsp_model_set has failed */
HSP_API int32_t HSP_CALL hsp_model_get_packing(hsp_model *model, hsp_packing *figures);

#ifdef __cplusplus
}
#endif

#endif
