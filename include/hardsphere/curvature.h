/* hardsphere/curvature.h: integrated mean and Gaussian curvature of the union's boundary, and energies with them.
 *
 * Guide: questions.md, exactness.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * Faces of ball i have the mean curvature 1 / r_i and the Gaussian curvature 1 / r_i^2. An edge counts as the limit of
 * rounded concave edges: across an arc of length l the normal turns by beta, the angle between the outward normals of
 * its two faces.
 *   M = sum_i A_i / r_i - 1/2 sum over arcs and circles of l beta
 *   G = 2 pi * the Euler characteristic of the boundary
 * So the layer of small width t inside the union has the volume A t - M t^2 + G t^3 / 3 (Steiner). A morphometric
 * solvation energy is a sum of V, A, M and G with factors. Radii include the probe. */
#ifndef HARDSPHERE_CURVATURE_H
#define HARDSPHERE_CURVATURE_H

#include "boundary.h"
#include "executor.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Integrated curvatures of the boundary. Frozen. */
typedef struct hsp_curvatures {
  double mean;  /**< M, length */
  double gauss; /**< G = pi/3 times the sum of gauss_thirds, a number */
} hsp_curvatures;

/** Integrated curvatures, in all and by ball: mean [n] and gauss_thirds [n] may each be NULL and else hold capacity >=
 *  n entries. mean[i] is ball i's part of M, length; gauss_thirds[i] its part of G in units of pi/3. An edge counts
 *  half for each of its two balls, a vertex a third for each of its three: gauss_thirds[i] = 6 (2 faces - loops) -
 *  vertices, with the faces, loops and vertices of ball i. totals and needed may be NULL; *needed becomes n.
 *  - Property 1: the sum of gauss_thirds is 6 times the Euler characteristic of the boundary.
 *  - Property 2: mean and gauss_thirds do not depend on the order of the balls, bit for bit.
 *
 *  Cost: O(n + vertices + circles).
 *  @retval HSP_E_ARGUMENT  boundary is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_curvature(const hsp_boundary *boundary, hsp_curvatures *totals, double *mean,
                                                int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed);

/** How curvatures are summed. Zero means default in every field but the first. */
typedef struct hsp_curvature_request {
  uint32_t struct_size;         /**< sizeof(hsp_curvature_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_curvature_request;

/** The same as hsp_boundary_curvature, with an executor that may stop it; request may be NULL: all defaults. totals,
 *  mean [n], gauss_thirds [n] and needed may be NULL.
 *  @retval HSP_E_ARGUMENT  boundary is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request or executor, or reserved is not 0
 *  @retval HSP_E_CAPACITY  as hsp_boundary_curvature
 *  @retval HSP_E_STATE     as hsp_boundary_curvature
 *  @retval HSP_E_STOPPED   the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_curvature_with(const hsp_boundary *boundary, const hsp_curvature_request *request,
                                                     hsp_curvatures *totals, double *mean, int32_t *gauss_thirds,
                                                     uint32_t capacity, uint32_t *needed);

/** Which energy: a morphometric one, of a union or of a union in a periodic box (periodic.h). Zero means default in
 *  every field but the first. */
typedef struct hsp_morphometry_request {
  uint32_t struct_size;         /**< sizeof(hsp_morphometry_request) */
  uint32_t reserved;            /**< 0 */
  double pressure;              /**< of the volume */
  double tension;               /**< of the weighted area */
  double bending;               /**< of the weighted mean curvature */
  double gaussian;              /**< of the Gaussian curvature */
  const double *sigma;          /**< [n], or NULL for all ones: the weights of area and mean curvature */
  const hsp_executor *executor; /**< or NULL: the threads that share the work */
} hsp_morphometry_request;

/** A morphometric energy and its parts. Frozen. */
typedef struct hsp_morphometric_energy {
  double value;   /**< pressure V + tension sum sigma_i A_i + bending M(sigma) + gaussian G */
  double volume;  /**< V */
  double area;    /**< sum sigma_i A_i */
  double mean;    /**< M(sigma) = sum sigma_i A_i / r_i - 1/2 sum of l beta (sigma_i + sigma_j) / 2 over the edges */
  double gauss;   /**< G */
  double d_probe; /**< the derivative by the probe, the sum of all d_radius */
} hsp_morphometric_energy;

/** The derivatives by this ball are one-sided, or do not exist: in the cases of HSP_GRADIENT_ONE_SIDED, and where four
 *  or more spheres meet in a vertex of the ball, or two circles only touch in a vertex of the ball. */
#define HSP_CURVATURE_ONE_SIDED UINT32_C(1)

/** The results that are wanted, and where they go. */
typedef struct hsp_morphometry_outputs {
  uint32_t struct_size; /**< sizeof(hsp_morphometry_outputs) */
  uint32_t capacity;    /**< entries that each array [n] has room for */
  uint32_t needed;      /**< becomes n */
  uint32_t first_bad;   /**< becomes the first ball whose sigma is NaN or infinite, HSP_NONE if there is none */
  hsp_morphometric_energy *energy; /**< or NULL */
  double *d_centre;                /**< [n][3], or NULL: by the centres */
  double *d_radius;                /**< [n], or NULL: by the radii */
  uint32_t *flags;                 /**< [n], or NULL: HSP_CURVATURE_ONE_SIDED */
  double *area;                    /**< [n], or NULL: free area of each ball */
} hsp_morphometry_outputs;

/** A morphometric energy and its gradient in one pass; balls that touch count as overlapping. request may be NULL: all
 *  defaults. If all factors are 0 so are E and its derivatives, while the parts of energy are computed all the same.
 *  M is continuous; its slope is unbounded where an arc appears or vanishes and where balls begin to touch. G is
 *  piecewise constant. On failure nothing but outputs->needed and outputs->first_bad is written, except on
 *  HSP_E_EXECUTOR and HSP_E_STOPPED.
 *  - Property 1: the sum of d_centre is zero up to rounding.
 *  - Property 2: with only bending not 0, sum_i (r_i d_radius_i + c_i . d_centre_i) is M(sigma).
 *  - Property 3: d_centre, d_radius and flags do not depend on the order of the balls, bit for bit.
 *  - Property 4: area is that of hsp_boundary_measure, bit for bit.
 *
 *  Cost: O(n + vertices + circles).
 *  @retval HSP_E_ARGUMENT    boundary or outputs is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size, an unknown part or reserved is not 0
 *  @retval HSP_E_CAPACITY    an array is given and capacity < n
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  a sigma or a factor is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_get_morphometry(const hsp_boundary *boundary,
                                                      const hsp_morphometry_request *request,
                                                      hsp_morphometry_outputs *outputs);

#ifdef __cplusplus
}
#endif

#endif
