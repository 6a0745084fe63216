/* hardsphere/moving.h: areas, volume and gradients while a few balls move at a time.
 *
 * Guide: moving_balls.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 *   hsp_moving_limits_init(&limits, sizeof limits, n);
 *   hsp_moving_bytes(&limits, &bytes);                      hsp_moving *moving;
 *   hsp_moving_init(memory, bytes, &limits, &moving);
 *   hsp_moving_set(moving, model, sigma, tension, pressure, HSP_TANGENT_OVERLAP, NULL, NULL);
 *   hsp_moving_move(moving, 1, &ball, xyz, NULL, NULL, NULL);
 *   hsp_moving_gradient(moving, &energy, NULL, NULL, NULL, 0, NULL);
 *   if (!accepted) hsp_moving_undo(moving);
 *
 * Areas, volume, an energy of them and its derivatives are known at all times. A move computes these balls again: those
 * that moved, those that a moved ball met before, and those that it meets afterwards. Then it adds up totals along a
 * fixed tree. Its cost depends on how many balls there are only by the depth of that tree, and beside a few balls that
 * are far larger than most only by what these meet.
 *
 * SAME BITS   Every number is, bit for bit, what hsp_boundary_compute, hsp_boundary_measure and
 * hsp_boundary_get_gradient give for a new model of the balls as they are, whatever moves led there. The new model has
 * the same lattice step, probe and largest radius less the probe (hsp_model_options; hsp_moving_get_info tells them),
 * or comes from hsp_moving_get_model. Compute from that model what only a boundary has: ids of vertices, arcs and
 * faces, shells, voids and all that follows.
 *
 * REFUSED   The lattice and the largest radius are those of the model; twice the largest radius is the side of the
 * cubes in which balls are looked up. A move of a ball beyond the lattice, or to a larger radius, is refused. Set
 * hsp_model_options.largest_radius to leave room for balls that grow. A move that is refused or fails leaves everything
 * as it was. */
#ifndef HARDSPHERE_MOVING_H
#define HARDSPHERE_MOVING_H

#include "gradient.h"
#include "measure.h"
#include "model.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Balls that move, with what is known of their union. */
typedef struct hsp_moving hsp_moving;

/** The limits that fix the memory. */
typedef struct hsp_moving_limits {
  uint32_t struct_size; /**< sizeof(hsp_moving_limits) */
  uint32_t balls;       /**< most balls */
  uint32_t neighbours;  /**< most balls that meet any one ball that lies inside no other */
} hsp_moving_limits;

/** Limits that suffice for molecules of `balls` atoms, van der Waals or solvent-accessible: neighbours
 *  min(balls, 256).
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than HSP_MAX_BALLS balls */
HSP_API int32_t HSP_CALL hsp_moving_limits_init(hsp_moving_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_moving_init needs.
 *  - Property 1: at most HSP_MOVING_BYTES of the limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_moving_bytes(const hsp_moving_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_MOVING_BYTES(balls, neighbours) \
  ((size_t)196608 + (size_t)672 * (size_t)(balls) + (size_t)1280 * (size_t)(neighbours))

/** Make a handle without balls in caller memory of any alignment; sets *moving.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_moving_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_moving_init(void *memory, size_t bytes, const hsp_moving_limits *limits,
                                         hsp_moving **moving);

/** Take the balls of a model, and the energy that is to be known: sigma [n], NULL for all ones, tension, pressure and
 *  tangency are those of hsp_gradient_request. Computes everything; neither the model nor sigma is needed afterwards.
 *  May be called any number of times. On failure the handle holds no results. limits: see LIMITS in hardsphere.h; at
 *  most two retries. first_bad may be NULL and else becomes the first ball whose sigma is NaN or infinite, HSP_NONE if
 *  there is none.
 *  - Property 1: the order of the balls has no effect but on ids, and on the last bits of sums over all balls.
 *
 *  Cost: about that of hsp_boundary_compute and hsp_boundary_get_gradient.
 *  @retval HSP_E_ARGUMENT    moving or model is NULL; unknown tangency
 *  @retval HSP_E_VERSION     bad struct_size of limits
 *  @retval HSP_E_CAPACITY    a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  a sigma, tension or pressure is NaN or infinite */
HSP_API int32_t HSP_CALL hsp_moving_set(hsp_moving *moving, const hsp_model *model, const double *sigma, double tension,
                                        double pressure, uint32_t tangency, hsp_moving_limits *limits,
                                        uint32_t *first_bad);

/** The same as hsp_moving_set, with the energy and an executor in a request; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT    moving or model is NULL; unknown tangency; an executor with several workers and without
 *                            run
 *  @retval HSP_E_VERSION     bad struct_size of request, executor or limits
 *  @retval HSP_E_CAPACITY    as hsp_moving_set
 *  @retval HSP_E_STATE       as hsp_moving_set
 *  @retval HSP_E_NOT_FINITE  as hsp_moving_set
 *  @retval HSP_E_STOPPED     the executor said not to go on. Its threads share no work */
HSP_API int32_t HSP_CALL hsp_moving_set_with(hsp_moving *moving, const hsp_model *model,
                                             const hsp_gradient_request *request, hsp_moving_limits *limits,
                                             uint32_t *first_bad);

/** Move some balls: ball [count] to the centres xyz [count][3], with the radii radius [count], the probe not included.
 *  xyz may be NULL, and all centres stay; radius may be NULL, and all radii stay. Coordinates and radii are rounded as
 *  hsp_model_set does. first_bad may be NULL and else becomes the position in `ball` of the first move that is refused,
 *  or HSP_NONE. limits may be NULL and else become what this move needed, or after HSP_E_CAPACITY what to retry with:
 *  take the balls from hsp_moving_get_model into a larger handle. On failure everything is as before, with one
 *  exception: after HSP_E_CAPACITY the previous move cannot be taken back any more.
 *  - Property 1: afterwards every number has the bits of a fresh computation, as said above.
 *  - Property 2: moves of different balls may be made in one call or in several, in any order.
 *
 *  Cost: O(m) boundaries of single balls for m balls that moved or that meet, or met, a ball that moved, each of which
 *  takes O(c), and O(m log n) for totals. Where a component may have come apart, it is searched from all of its
 *  possible pieces side by side, until all but the largest piece are known.
 *  @retval HSP_E_ARGUMENT    moving is NULL; ball is NULL with count > 0
 *  @retval HSP_E_VERSION     bad struct_size of limits
 *  @retval HSP_E_CAPACITY    a ball would have more neighbours than the limit allows
 *  @retval HSP_E_STATE       no balls: no hsp_moving_set before, or it failed
 *  @retval HSP_E_ID          no such ball, or one that is listed twice
 *  @retval HSP_E_NOT_FINITE  a coordinate or a radius is NaN or infinite
 *  @retval HSP_E_NEGATIVE    a radius is negative
 *  @retval HSP_E_RANGE       a ball would leave the lattice, or be larger than the largest radius */
HSP_API int32_t HSP_CALL hsp_moving_move(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz,
                                         const double *radius, hsp_moving_limits *limits, uint32_t *first_bad);

/** How balls are moved. Zero means default in every field but the first. */
typedef struct hsp_moving_request {
  uint32_t struct_size;         /**< sizeof(hsp_moving_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_moving_request;

/** The same as hsp_moving_move, with an executor that may stop it; request may be NULL: all defaults. Where it is
 *  stopped everything is as before, except that the previous move cannot be taken back any more.
 *  @retval HSP_E_ARGUMENT    moving is NULL; ball is NULL with count > 0; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY    as hsp_moving_move
 *  @retval HSP_E_STATE       as hsp_moving_move
 *  @retval HSP_E_ID          as hsp_moving_move
 *  @retval HSP_E_NOT_FINITE  as hsp_moving_move
 *  @retval HSP_E_NEGATIVE    as hsp_moving_move
 *  @retval HSP_E_RANGE       as hsp_moving_move
 *  @retval HSP_E_STOPPED     the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_moving_move_with(hsp_moving *moving, uint32_t count, const uint32_t *ball,
                                              const double *xyz, const double *radius,
                                              const hsp_moving_request *request, hsp_moving_limits *limits,
                                              uint32_t *first_bad);

/** Take the last move back: all numbers become what they were before it, bit for bit. Only one move can be taken back.
 *  Cost: copies what the move changed, and adds up totals: far less than the move.
 *  @retval HSP_E_ARGUMENT  moving is NULL
 *  @retval HSP_E_STATE     no move since hsp_moving_set; it was taken back already, or another one has failed with
 *                          HSP_E_CAPACITY since */
HSP_API int32_t HSP_CALL hsp_moving_undo(hsp_moving *moving);

/** Lattice and counts. Frozen. */
typedef struct hsp_moving_info {
  double step;              /**< the lattice step, length */
  double probe;             /**< as rounded to the lattice, length */
  double largest_radius;    /**< the largest radius that a ball may have, probe included, length */
  uint64_t vertices;        /**< points where three spheres meet, as all counts here as in hsp_boundary_counts */
  uint64_t arcs;            /**< between two vertices, each counted once */
  uint64_t circles;         /**< whole circles that are free */
  uint64_t faces;           /**< maximal free pieces of spheres */
  uint64_t loops;           /**< boundary loops of all faces */
  uint32_t balls;           /**< number of balls */
  uint32_t exposed_balls;   /**< balls with at least one face */
  uint32_t contained_balls; /**< balls inside one other ball (of several equal balls, all but one) */
  uint32_t components;      /**< connected components of the union */
  uint32_t changed;         /**< how many balls hsp_moving_get_changed lists */
  uint32_t reserved;        /**< 0 */
} hsp_moving_info;

/** How many vertices, arcs, faces, components there are, and the lattice.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     no balls: no hsp_moving_set before, or it failed */
HSP_API int32_t HSP_CALL hsp_moving_get_info(const hsp_moving *moving, hsp_moving_info *info);

/** Area and volume of the union, and each ball's terms of both, always of all balls: arguments as those of
 *  hsp_boundary_measure.
 *  Cost: O(log n) for the totals, O(n) for the arrays.
 *  @retval HSP_E_ARGUMENT  moving is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     no balls: no hsp_moving_set before, or it failed */
HSP_API int32_t HSP_CALL hsp_moving_measure(const hsp_moving *moving, hsp_totals *totals, double *area,
                                            double *volume_term, uint32_t capacity, uint32_t *needed);

/** The energy that hsp_moving_set was given, and its derivatives as those of hsp_boundary_get_gradient: d_centre
 *  [n][3], d_radius [n] and flags [n] may each be NULL and else hold capacity >= n entries. energy and needed may be
 *  NULL.
 *  Cost: O(log n) for the energy, O(n) for the arrays.
 *  @retval HSP_E_ARGUMENT  moving is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     no balls: no hsp_moving_set before, or it failed */
HSP_API int32_t HSP_CALL hsp_moving_gradient(const hsp_moving *moving, hsp_energy *energy, double *d_centre,
                                             double *d_radius, uint32_t *flags, uint32_t capacity, uint32_t *needed);

/** All that is known of a ball. Frozen. */
typedef struct hsp_moving_ball {
  double centre[3];        /**< as rounded to the lattice, length */
  double radius;           /**< likewise, probe included */
  double area;             /**< its free area, length^2 */
  double volume_term;      /**< its term of the volume, see hsp_boundary_measure */
  double d_centre[3];      /**< derivative of the energy by its centre */
  double d_radius;         /**< and by its radius */
  uint32_t faces;          /**< number of its faces; 0: the ball is buried */
  uint32_t flags;          /**< HSP_BALL_* */
  uint32_t gradient_flags; /**< HSP_GRADIENT_* */
  uint32_t reserved;       /**< 0 */
} hsp_moving_ball;

/** All that is known of some balls: out [count] of the balls ball [count], in this order; a ball may be listed again.
 *  @retval HSP_E_ARGUMENT  moving is NULL; ball or out is NULL with count > 0
 *  @retval HSP_E_STATE     no balls: no hsp_moving_set before, or it failed
 *  @retval HSP_E_ID        no such ball; nothing is written */
HSP_API int32_t HSP_CALL hsp_moving_get_balls(const hsp_moving *moving, uint32_t count, const uint32_t *ball,
                                              hsp_moving_ball *out);

/** The balls of which anything may have changed by the last move, or by taking it back, ascending: balls that moved,
 *  balls that these met or meet, and balls whose terms of the volume are about another origin than before. None after
 *  hsp_moving_set, and after a move that failed with HSP_E_CAPACITY.
 *  @retval HSP_E_ARGUMENT  moving is NULL; balls is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     no balls: no hsp_moving_set before, or it failed */
HSP_API int32_t HSP_CALL hsp_moving_get_changed(const hsp_moving *moving, uint32_t *balls, uint32_t capacity,
                                                uint32_t *needed);

/** Put the balls as they are into a model, as hsp_model_set would with the same lattice and largest radius: for a
 *  boundary with ids, shells and topology, for queries and views. Results that were computed from other balls of the
 *  model cannot be read afterwards. On failure the model stays as it is.
 *  Cost: O(n).
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_CAPACITY  the model has room for fewer balls
 *  @retval HSP_E_STATE     no balls: no hsp_moving_set before, or it failed */
HSP_API int32_t HSP_CALL hsp_moving_get_model(const hsp_moving *moving, hsp_model *model);

#ifdef __cplusplus
}
#endif

#endif
