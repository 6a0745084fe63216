/* hardsphere/boundary.h: the boundary of the union: vertices, arcs, circles, faces (Section 4.2, Steps 1 and 2).
 *
 * Guide: tutorial.md, splitting_the_work.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 *   vertex   a point on three spheres outside all other balls; its three balls and a sign name it
 *   arc      a maximal free piece of the circle of two spheres between two vertices
 *   circle   a whole intersection circle that is free
 *   face     a maximal free piece of one sphere; it may have several boundary loops, or none (a whole sphere)
 *   shell    a connected component of the boundary;  void: a bounded component of the complement
 * Ties are decided as if every ball were inflated by an infinitesimal amount (simulation of simplicity). So components,
 * voids and Euler number are those of the balls as given, vertices always lie on exactly three spheres, and arcs and
 * faces may be infinitesimally small. Every ball grows in proportion to its radius: a ball that touches another from
 * outside meets it in a circle; a ball that touches another from inside, or a point on its sphere, is contained in it.
 * Of equal balls the one of lowest index contains the others. */
#ifndef HARDSPHERE_BOUNDARY_H
#define HARDSPHERE_BOUNDARY_H

#include "executor.h"
#include "model.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The boundary of the union of a model's balls. */
typedef struct hsp_boundary hsp_boundary;

/** The limits that fix a boundary's memory. */
typedef struct hsp_boundary_limits {
  uint32_t struct_size; /**< sizeof(hsp_boundary_limits) */
  uint32_t balls;       /**< most balls of the model */
  uint32_t neighbours;  /**< most balls that meet any one ball that lies inside no other */
  uint32_t vertices;    /**< vertices of the boundary */
  uint32_t circles;     /**< free circles */
  uint32_t workers;     /**< parts of the work for an executor; 0 means 1. Comes back unchanged if it suffices */
} hsp_boundary_limits;

#define HSP_MAX_WORKERS UINT32_C(1024) /**< the largest hsp_boundary_limits.workers */

/** Limits that suffice for molecules of `balls` atoms, van der Waals or solvent-accessible: neighbours min(balls, 256),
 *  vertices 8 balls + 64, circles 2 balls + 16, workers 0. If a set needs more hsp_boundary_compute returns
 *  HSP_E_CAPACITY and larger limits.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 64) / 8 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_boundary_limits_init(hsp_boundary_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_boundary_init needs.
 *  - Property 1: at most HSP_BOUNDARY_BYTES of the first four limits, and HSP_WORKER_BYTES of them for each worker but
 *    the first.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or workers than HSP_MAX_WORKERS, or the size does not
 *                          fit a size_t */
HSP_API int32_t HSP_CALL hsp_boundary_bytes(const hsp_boundary_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_BOUNDARY_BYTES(balls, neighbours, vertices, circles)                      \
  ((size_t)5120 + (size_t)64 * (size_t)(balls) + (size_t)256 * (size_t)(neighbours) + \
   (size_t)160 * (size_t)(vertices) + (size_t)80 * (size_t)(circles))
/** Bytes that every worker but the first adds to HSP_BOUNDARY_BYTES at most. */
#define HSP_WORKER_BYTES(balls, neighbours, vertices, circles)                         \
  ((size_t)18432 + (size_t)24 * (size_t)(balls) + (size_t)560 * (size_t)(neighbours) + \
   (size_t)24 * (size_t)(vertices) + (size_t)24 * (size_t)(circles))

/** Make an empty boundary in caller memory of any alignment; sets *boundary.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_boundary_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or workers than HSP_MAX_WORKERS, or the size does not
 *                          fit a size_t */
HSP_API int32_t HSP_CALL hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits,
                                           hsp_boundary **boundary);

/** Compute the boundary of the union of the model's balls. The model must outlive the boundary; the boundary can be
 *  read while the model holds the same balls (RESULTS in hardsphere.h). On failure the boundary holds no results.
 *  limits: see LIMITS in hardsphere.h. The limits of vertices and circles become known once that of neighbours
 *  suffices: at most three retries.
 *  - Property 1: the order of the balls has no effect but on ids.
 *
 *  Cost: O(n) for sets as in Theorem 2.1; O(c) for each ball, and about O(m) for one with m neighbours where many balls
 *  are nearly the same or on a line; O(m log m) for a ball with m small balls all over its sphere; about O(m^1.5) for a
 *  ball beside a line of m balls that each have an arc on it between the next two; O(m f) with all spheres through one
 *  point or two, where f others bound a ball's power cell there; O(m^3) at worst, which no set is known to reach.
 *  @retval HSP_E_ARGUMENT  boundary or model is NULL
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small
 *  @retval HSP_E_STATE     hsp_model_set has failed */
HSP_API int32_t HSP_CALL hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model,
                                              hsp_boundary_limits *limits);

/** How a boundary is computed. Zero means default in every field but the first. */
typedef struct hsp_boundary_request {
  uint32_t struct_size;         /**< sizeof(hsp_boundary_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: the threads that share the work */
  const uint8_t *selected;      /**< [n], or NULL for all balls of the model: a ball with 0 only blocks */
} hsp_boundary_request;

/** The same as hsp_boundary_compute, with threads or for selected balls alone; request may be NULL: all defaults.
 *  With an executor of more than one worker the work falls into hsp_boundary_limits.workers parts. Each part has memory
 *  of its own and about as many balls as every other part, which lie together. Set workers to the number of the
 *  executor's workers, or to a few times that number if other programs may slow some threads down. If there are fewer
 *  parts than workers the status is HSP_E_CAPACITY, and *limits becomes limits with one part for each worker,
 *  HSP_MAX_WORKERS at most. The executor runs a few times, one after the other.
 *  With `selected` only what lies on the selected balls is computed, in the time that these take: for codes with ghost
 *  atoms. The boundary then answers hsp_boundary_get_measures, hsp_boundary_get_gradient, hsp_boundary_get_derivatives,
 *  hsp_boundary_get_area_row, hsp_boundary_get_area_rows and hsp_boundary_get_hessian_product (hessian.h) alone, for
 *  these balls; all other functions return HSP_E_STATE. So do these if asked for terms of the volume, for first
 *  derivatives of the volume, or with a pressure, as the volume takes all balls, but for second derivatives, which take
 *  a ball's own arcs; hsp_totals.volume and hsp_energy.volume are NaN. hsp_energy.value and .area are sums over the
 *  selected balls. But d_centre and d_radius of a selected ball are derivatives of the energy of all balls; those of
 *  the other balls are 0, and d_probe is the sum of these d_radius. So d_centre is not the gradient of value; d_centre
 *  of several selections that make up all balls adds up to the gradient of the whole.
 *  - Property 1: all that can be read afterwards is the same for every number of workers and parts, bit for bit.
 *  - Property 2: areas, derivatives and flags of selected balls are those of the whole boundary, bit for bit; but
 *    the flag of a selected ball that equals one that is not selected may be set although it need not be.
 *
 *  Cost: that of hsp_boundary_compute; with `selected` that of the selected balls, and O(n).
 *  @retval HSP_E_ARGUMENT  boundary or model is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY  a limit is too small, as for hsp_boundary_compute, or workers is
 *  @retval HSP_E_STATE     hsp_model_set has failed
 *  @retval HSP_E_EXECUTOR  the executor did not call every task exactly once
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_boundary_compute_with(hsp_boundary *boundary, const hsp_model *model,
                                                   const hsp_boundary_request *request, hsp_boundary_limits *limits);

/* ---- what there is ---------------------------------------------------------------------------------------------- */

/** How many of everything. Frozen. */
typedef struct hsp_boundary_counts {
  uint32_t balls;           /**< balls of the model */
  uint32_t exposed_balls;   /**< balls with at least one face */
  uint32_t contained_balls; /**< balls inside one other ball (of several equal balls, all but one) */
  uint32_t vertices;        /**< points where three spheres meet */
  uint32_t arcs;            /**< between two vertices, each counted once */
  uint32_t circles;         /**< whole circles that are free */
  uint32_t faces;           /**< maximal free pieces of spheres */
  uint32_t loops;           /**< boundary loops of all faces */
  uint32_t shells;          /**< connected components of the boundary */
  uint32_t components;      /**< connected components of the union */
  uint32_t voids;           /**< bounded components of the complement of the union */
  uint32_t tied_vertices;   /**< vertices with HSP_VERTEX_TIED */
  int64_t euler;            /**< Euler characteristic of the boundary, summed over its shells */
  uint64_t reserved[2];     /**< 0 */
} hsp_boundary_counts;

/** How many of everything the boundary has.
 *  - Property 1: euler = vertices - arcs + 2 faces - loops.
 *  - Property 2: voids = shells - components.
 *  - Property 3: 2 arcs = 3 vertices.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_counts(const hsp_boundary *boundary, hsp_boundary_counts *counts);

/** A tie was decided at this vertex: a further sphere goes through it (of a ball that lies inside no other), or two of
 * its circles only touch there. */
#define HSP_VERTEX_TIED UINT32_C(1)

/** A vertex of the boundary. Frozen. */
typedef struct hsp_vertex {
  double xyz[3];     /**< position, length */
  uint32_t ball[3];  /**< its balls a < b < c */
  int32_t sign;      /**< +1 or -1: its side of the plane of the centres; +1 is along (c_b - c_a) x (c_c - c_a) */
  uint32_t flags;    /**< HSP_VERTEX_* */
  uint32_t reserved; /**< 0 */
} hsp_vertex;

/** The vertices; index in the array = vertex id used by hsp_arc.
 *  - Property 1: each vertex ends exactly three arcs.
 *
 *  Accuracy: a position is off by a few 1e-16 of its distance from 0 0 0 and of the largest radius of its balls.
 *  @retval HSP_E_ARGUMENT  boundary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_vertices(const hsp_boundary *boundary, hsp_vertex *out, uint32_t capacity,
                                                   uint32_t *needed);

/** An arc runs counter-clockwise about its axis, from vertex[0] to vertex[1]. Seen from outside the balls, face[1] lies
 *  on its left and face[0] on its right. Frozen. */
typedef struct hsp_arc {
  double centre[3];   /**< of its circle, length */
  double axis[3];     /**< unit vector from c_a towards c_b */
  double radius;      /**< of its circle, length */
  double angle;       /**< from vertex[0] to vertex[1], in [0, 2 pi] */
  uint32_t ball[2];   /**< its two balls a < b */
  uint32_t vertex[2]; /**< where it starts and where it ends */
  uint32_t face[2];   /**< the face on ball a and the face on ball b */
} hsp_arc;

/** The arcs, each once; index in the array = arc id used by hsp_loop_arc.
 *
 *  Accuracy: a centre is off by a few 1e-16 of its distance from 0 0 0 and of the larger radius of its balls, an angle
 *  by some 1e-15, however small it is.
 *  @retval HSP_E_ARGUMENT  boundary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity,
                                               uint32_t *needed);

/** A whole circle that is free. Counter-clockwise about the axis, face[1] lies on its left and face[0] on its right, as
 *  at arcs. Frozen. */
typedef struct hsp_circle {
  double centre[3]; /**< length */
  double axis[3];   /**< unit vector from c_a towards c_b */
  double radius;    /**< length */
  uint32_t ball[2]; /**< its two balls a < b */
  uint32_t face[2]; /**< the face on ball a and the face on ball b */
} hsp_circle;

/** The free circles; index in the array = circle id used by hsp_loop.
 *  @retval HSP_E_ARGUMENT  boundary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity,
                                                  uint32_t *needed);

/** A face of the boundary. Frozen. */
typedef struct hsp_face {
  uint32_t ball;       /**< the ball it lies on */
  uint32_t loops;      /**< its boundary loops; 0 for a whole sphere */
  uint32_t shell;      /**< 0 .. shells - 1 */
  uint32_t first_loop; /**< its loops are first_loop .. first_loop + loops - 1 of hsp_boundary_get_loops */
} hsp_face;

/** The faces; index in the array = face id; faces of one ball are consecutive.
 *  @retval HSP_E_ARGUMENT  boundary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity,
                                                uint32_t *needed);

/** A boundary loop of a face: a closed chain of arcs, or a whole circle. Seen from outside the ball, it keeps its face
 *  on its left. Frozen. */
typedef struct hsp_loop {
  uint32_t face;      /**< the face that it bounds */
  uint32_t circle;    /**< the free circle that it is, whose face[side] is `face`; HSP_NONE if it consists of arcs */
  uint32_t side;      /**< 1: a circle counter-clockwise about its axis; 0: a circle clockwise, or arcs */
  uint32_t first_arc; /**< its arcs are first_arc .. first_arc + arcs - 1 of hsp_boundary_get_loop_arcs */
  uint32_t arcs;      /**< at least 2; 0 for a circle */
} hsp_loop;

/** The loops, face after face: counts.loops records.
 *  @retval HSP_E_ARGUMENT  boundary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_loops(const hsp_boundary *boundary, hsp_loop *out, uint32_t capacity,
                                                uint32_t *needed);

/** An arc as a part of a loop. Frozen. */
typedef struct hsp_loop_arc {
  uint32_t arc;    /**< index in hsp_boundary_get_arcs */
  uint32_t side;   /**< 1: the loop runs along it, 0: against it; its face[side] is that of the loop */
  uint32_t vertex; /**< where the loop enters it: vertex[1 - side] of the arc; it leaves at vertex[side] */
} hsp_loop_arc;

/** The arcs of all loops, loop after loop, and within a loop in walking order: 2 counts.arcs records.
 *  - Property 1: the arcs of a loop are closed: each ends at the vertex of the next, the last at that of the first.
 *  - Property 2: every arc occurs once with side 0 and once with side 1.
 *
 *  Cost: O(vertices).
 *  @retval HSP_E_ARGUMENT  boundary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_loop_arcs(const hsp_boundary *boundary, hsp_loop_arc *out, uint32_t capacity,
                                                    uint32_t *needed);

#define HSP_BALL_CONTAINED UINT32_C(1) /**< the ball lies inside one other ball */

/** Faces and component of a ball. Frozen. */
typedef struct hsp_ball {
  uint32_t faces;      /**< number of its faces; 0: the ball is buried */
  uint32_t first_face; /**< id of the first of them, HSP_NONE if there is none */
  uint32_t component;  /**< connected component of the union, 0 .. components - 1 */
  uint32_t flags;      /**< HSP_BALL_* */
} hsp_ball;

/** Faces and component of each ball: one record per ball, in the caller's order.
 *  @retval HSP_E_ARGUMENT  boundary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_boundary_get_balls(const hsp_boundary *boundary, hsp_ball *out, uint32_t capacity,
                                                uint32_t *needed);

/* ---- self-check ------------------------------------------------------------------------------------------------ */

/** Check the invariants of a computed boundary, for fuzzers and careful callers. If all hold, *invariant becomes
 *  0 and *id HSP_NONE. Else *invariant becomes the number of the first that is violated, and
 *  *id that of the vertex, arc end, loop, face, shell or ball concerned:
 *     1  a vertex lies on three different balls, none of them inside another
 *     2  each of its balls is visited by exactly one loop there, between the two circles that its sign gives
 *     3  an arc ends on the ball and circle it started on
 *     4  every arc is walked once on each of its two balls, in opposite directions
 *     5  loops keep to one ball and have at least two arcs, or are one circle
 *     6  every loop bounds one face of its own ball; only a whole sphere has a face without loops
 *     7  the faces on both sides of an arc or circle belong to one shell
 *     8  the Euler characteristic of each shell is even and at most 2, and there are no fewer shells than components
 *     9  every vertex lies on its three spheres, up to rounding
 *    10  no ball's area is negative or beyond its sphere, and it equals the area from angles between positions
 *    11  the volume equals the volume about another origin from positions: every component's surface is closed
 *
 *  Uses the boundary's scratch memory, hence not const; results stay valid.
 *
 *  Cost: O(n + vertices + circles).
 *  @retval HSP_OK          all hold
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_CHECK     one is violated: please report it */
HSP_API int32_t HSP_CALL hsp_boundary_check(hsp_boundary *boundary, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
