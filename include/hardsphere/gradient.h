/* hardsphere/gradient.h: first derivatives of areas and of the volume by centres and radii.
 *
 * Guide: robustness.md, exactness.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 * The free area A_i of ball i and the volume V of the union are functions of all centres and radii. Radii include the
 * probe. V is continuously differentiable. A_i is continuous. Its derivative jumps where two spheres begin to touch,
 * and has an unbounded slope, but no jump, where an arc appears or vanishes. Where two spheres touch, derivatives are
 * one-sided (HSP_TANGENT_*), and flags tell which balls are concerned; a ball that touches another from inside counts
 * as lying inside it with either HSP_TANGENT_*. Where balls are equal, A_i jumps and V has a kink: the ball of lowest
 * index has the derivatives that it would have alone, the others have 0, and all are flagged unless they are buried.
 * Where three spheres share a free circle, derivatives are one-sided too, without a flag: on the side that the symbolic
 * perturbation takes. The lattice's rounding is not differentiated: difference quotients agree with these derivatives
 * for steps of some 1e5 lattice steps or more, which is 1e-3 for radii between 1.08 and 10.7, whose lattice has the
 * step 1e-8. The default steps of programs that check gradients are smaller, in their units: PLUMED's --debug-forces
 * 1.5e-8, ASE 1e-6, JAX 1e-4. Give these programs larger steps. */
#ifndef HARDSPHERE_GRADIENT_H
#define HARDSPHERE_GRADIENT_H

#include "boundary.h"
#include "executor.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HSP_TANGENT_OVERLAP UINT32_C(0)  /**< as if balls that touch overlapped by an infinitely small amount */
#define HSP_TANGENT_DISJOINT UINT32_C(1) /**< as if they were apart by an infinitely small amount */

/** The ball touches another at a free point, or equals another and one of the two is exposed: its derivatives are
 *  one-sided. */
#define HSP_GRADIENT_ONE_SIDED UINT32_C(1)

/** The value of an energy of areas and volume, and its parts. Units: tension times length^2, length^2, length^3.
 *  Frozen. */
typedef struct hsp_energy {
  double value;         /**< E = tension * sum_i sigma_i A_i + pressure * V */
  double area;          /**< sum_i sigma_i A_i */
  double volume;        /**< V; NaN for a boundary of selected balls */
  double d_probe;       /**< dE/d(probe) = sum of all dE/dr_i */
  uint64_t reserved[2]; /**< 0 */
} hsp_energy;

/** Which energy: E = tension * sum_i sigma_i A_i + pressure * V, of a union, of a union in a periodic box (periodic.h),
 *  or of a smooth surface (surface.h). Zero means default in every field but the first. */
typedef struct hsp_gradient_request {
  uint32_t struct_size;         /**< sizeof(hsp_gradient_request); hsp_gradient_request_init sets it */
  uint32_t tangency;            /**< one of HSP_TANGENT_* */
  double tension;               /**< of the weighted area */
  double pressure;              /**< of the volume */
  const double *sigma;          /**< [n], or NULL for all ones: the weights of the areas; a ball with 0 only blocks */
  const hsp_executor *executor; /**< or NULL: the threads that share the work */
} hsp_gradient_request;

/** Fill a request with defaults.
 *  @retval HSP_E_ARGUMENT  request is NULL
 *  @retval HSP_E_VERSION   struct_size is bad */
HSP_API int32_t HSP_CALL hsp_gradient_request_init(hsp_gradient_request *request, uint32_t struct_size);

/** The results that are wanted, and where they go. */
typedef struct hsp_gradient_outputs {
  uint32_t struct_size; /**< sizeof(hsp_gradient_outputs) */
  uint32_t capacity;    /**< entries that each array [n] has room for */
  uint32_t needed;      /**< becomes n */
  uint32_t first_bad;   /**< becomes the first ball whose sigma is NaN or infinite, HSP_NONE if there is none */
  hsp_energy *energy;   /**< or NULL */
  double *d_centre;     /**< [n][3], or NULL: dE/dc_i */
  double *d_radius;     /**< [n], or NULL: dE/dr_i */
  uint32_t *flags;      /**< [n], or NULL: HSP_GRADIENT_* */
  double *area;         /**< [n], or NULL: free area of each ball; of a smooth surface its part on each ball */
} hsp_gradient_outputs;

/** An energy and its gradient, in one pass. request may be NULL: all defaults.
 *  For the area alone: tension 1. For the volume alone: pressure 1. With neither E and its derivatives are 0, while
 *  energy->area, energy->volume and area are computed all the same. For molecular dynamics take HSP_TANGENT_OVERLAP,
 *  the default. On failure nothing but outputs->needed and outputs->first_bad is written, except on HSP_E_EXECUTOR and
 *  HSP_E_STOPPED.
 *  - Property 1: the sums of d_centre and of c_i x d_centre are zero up to rounding (E does not change under motions).
 *  - Property 2: with all sigma equal, sum_i (r_i d_radius_i + c_i . d_centre_i) is 2 A for the area, 3 V for the
 *    volume.
 *  - Property 3: d_centre, d_radius and flags do not depend on the order of the balls, bit for bit.
 *  - Property 4: area is that of hsp_boundary_measure, bit for bit.
 *
 *  Accuracy: a derivative of A_i has an error of a few 1e-16 of r_i, and of its own size, for each arc on ball i;
 *  d_centre and d_radius add up the errors of the ball and of its neighbours. So derivatives of a ball beside one that
 *  is 1e8 times as large have eight digits.
 *  Source: M. L. Connolly 1983, T. J. Richmond 1984 for the area; dV/dc_i is the vector area of ball i's faces.
 *  Cost: O(n + vertices + circles). With flags, a look around each ball that lies in another.
 *  @retval HSP_E_ARGUMENT    boundary or outputs is NULL; unknown tangency; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    an array is given and capacity < n
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since; of selected balls, and pressure is not 0
 *  @retval HSP_E_NOT_FINITE  a sigma, tension or pressure is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_get_gradient(const hsp_boundary *boundary, const hsp_gradient_request *request,
                                                   hsp_gradient_outputs *outputs);

/** Which derivatives, of the area and of the volume apart. Zero means default in every field but the first. */
typedef struct hsp_derivatives_request {
  uint32_t struct_size;         /**< sizeof(hsp_derivatives_request) */
  uint32_t tangency;            /**< one of HSP_TANGENT_* */
  const double *sigma;          /**< [n], or NULL for all ones: the weights of the areas */
  const hsp_executor *executor; /**< or NULL: the threads that share the work */
} hsp_derivatives_request;

/** The results that are wanted, and where they go: derivatives of S = sum_i sigma_i A_i and of the volume V. */
typedef struct hsp_derivatives_outputs {
  uint32_t struct_size;  /**< sizeof(hsp_derivatives_outputs) */
  uint32_t capacity;     /**< entries that each array [n] has room for */
  uint32_t needed;       /**< becomes n */
  uint32_t first_bad;    /**< becomes the first ball whose sigma is NaN or infinite, HSP_NONE if there is none */
  double *area_centre;   /**< [n][3], or NULL: dS/dc_i */
  double *area_radius;   /**< [n], or NULL: dS/dr_i */
  double *volume_centre; /**< [n][3], or NULL: dV/dc_i, the vector area of ball i's faces */
  double *volume_radius; /**< [n], or NULL: dV/dr_i, ball i's free area */
  uint32_t *flags;       /**< [n], or NULL: HSP_GRADIENT_* */
} hsp_derivatives_outputs;

/** The two parts of an energy's gradient, each on its own: the derivatives of the weighted area and of the volume.
 *  request may be NULL: all defaults. On failure nothing but outputs->needed and outputs->first_bad is written, except
 *  on HSP_E_EXECUTOR and HSP_E_STOPPED.
 *  - Property 1: tension times the derivatives of the area plus pressure times those of the volume are the derivatives
 *    of hsp_boundary_get_gradient, up to rounding; bit for bit with tension 1 and pressure 0, or 0 and 1, and finite
 *    numbers.
 *
 *  Cost: O(n + vertices + circles). With flags, a look around each ball that lies in another.
 *  @retval HSP_E_ARGUMENT    boundary or outputs is NULL; unknown tangency; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    an array is given and capacity < n
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since; of selected balls, and an array of the
 *                            volume is given
 *  @retval HSP_E_NOT_FINITE  a sigma is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_get_derivatives(const hsp_boundary *boundary,
                                                      const hsp_derivatives_request *request,
                                                      hsp_derivatives_outputs *outputs);

/** One entry of a ball's row of the area's Jacobian. Frozen. */
typedef struct hsp_area_derivative {
  double centre[3]; /**< dA_i/dc_j, length */
  double radius;    /**< dA_i/dr_j, length */
  double angle;     /**< sum of the angles of the free arcs of i's and j's circle that count; 0 for j = i */
  uint32_t ball;    /**< j */
  uint32_t flags;   /**< HSP_GRADIENT_ONE_SIDED if i and j touch; for j = i if another entry has it */
} hsp_area_derivative;

/** The derivatives of one ball's free area A_i, i = ball: an entry for i itself and one for every j whose circle on i
 *  has a free piece, ascending in j; all others are 0. No entries if ball i has no face. tangency is one of
 *  HSP_TANGENT_*.
 *  - Property 1: the centre entries of a row sum to 0 up to rounding.
 *  - Property 2: dA_i/dr_j = dA_j/dr_i up to rounding.
 *
 *  Cost: O(m log m) for m arcs on the ball.
 *  @retval HSP_E_ARGUMENT  boundary is NULL, or out with a capacity above 0; unknown tangency
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        no such ball */
HSP_API int32_t HSP_CALL hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
                                                   hsp_area_derivative *out, uint32_t capacity, uint32_t *needed);

/** The whole Jacobian of the areas as compressed rows: the row of ball i has the entries first[i] to first[i + 1] - 1.
 *  ball [needed] holds the columns j, ascending in each row, d_centre [needed][3] holds sigma_i dA_i/dc_j, and d_radius
 *  [needed], which may be NULL, sigma_i dA_i/dr_j. first [n + 1] begins with 0 and ends with the number of all entries;
 *  *needed becomes the same number. first is written on HSP_OK and on HSP_E_CAPACITY: with capacity 0 this function
 *  only counts, which takes little time. There are at most exposed_balls + 2 (arcs + circles) entries of
 *  hsp_boundary_counts. request may be NULL: all defaults; a sigma weighs the row of its ball.
 *  - Property 1: row i has the bits of hsp_boundary_get_area_row, times sigma_i.
 *  - Property 2: the sums of columns are area_centre and area_radius of hsp_boundary_get_derivatives, up to rounding.
 *
 *  Cost: O(n + vertices + circles), times the logarithm of the arcs on a ball.
 *  @retval HSP_OK            all rows are there; or there is no entry, also with capacity 0
 *  @retval HSP_E_ARGUMENT    boundary or first is NULL; ball or d_centre is NULL with a capacity above 0; unknown
 *                            tangency; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than the number of entries: first and *needed are set, nothing else
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  a sigma is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_boundary_get_area_rows(const hsp_boundary *boundary,
                                                    const hsp_derivatives_request *request, uint32_t *first,
                                                    uint32_t *ball, double *d_centre, double *d_radius,
                                                    uint32_t capacity, uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
