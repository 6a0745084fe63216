/* hardsphere/regions.h: regions outside the union, such as cavities, and the balls around them (Section 4.2, Step 3).
 *
 * Guide: tutorial.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 *   region         a connected component of the complement of the union: region 0 is the outer one, the others are the
 *                  voids, also called cavities, in the order of their shells
 *   shell          as in hsp_face: each shell separates one component of the union from one region
 *   component      of the union, as in hsp_ball
 * All of them are read from a handle hsp_topology. It also holds the boundary cut into simple faces, which topology.h
 * describes. */
#ifndef HARDSPHERE_REGIONS_H
#define HARDSPHERE_REGIONS_H

#include "boundary.h"
#include "executor.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The boundary as quad-edges, with shells and regions. */
typedef struct hsp_topology hsp_topology;

/** The limits that fix a topology's memory. */
typedef struct hsp_topology_limits {
  uint32_t struct_size; /**< sizeof(hsp_topology_limits) */
  uint32_t balls;       /**< most balls of the model */
  uint32_t neighbours;  /**< as in hsp_boundary_limits */
  uint32_t edges;       /**< edges; vertices and simple faces are never more */
  uint32_t cut_arcs;    /**< cut arcs that cut faces with several loops */
  uint32_t shells;      /**< shells; 0: as many as the edges allow, two for each. Fewer take less memory */
} hsp_topology_limits;

/** Limits for a computed boundary that nearly always suffice: its balls, neighbours and shells; four cut arcs for every
 *  loop of a face beyond the first, but five in a face of 2,048 loops and one more with each doubling of their number;
 *  and edges for its arcs, circles and whole spheres and four for every cut arc.
 *  Without a boundary, for memory that is fixed beforehand, set them by hand: for molecules of `balls` atoms, van der
 *  Waals or solvent-accessible, neighbours min(balls, 256), edges 16 balls + 96, cut_arcs 2 balls + 16 and shells 0
 *  suffice.
 *
 *  Cost: O(n + faces).
 *  @retval HSP_E_ARGUMENT  limits or boundary is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since */
HSP_API int32_t HSP_CALL hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size,
                                                  const hsp_boundary *boundary);

/** Bytes that hsp_topology_init needs.
 *  - Property 1: at most HSP_TOPOLOGY_BYTES of the first four limits.
 *  - Property 2: grows with each limit, shells being as many as the edges allow if they are 0.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_topology_bytes(const hsp_topology_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_TOPOLOGY_BYTES(balls, neighbours, edges, cut_arcs)                                                        \
  ((size_t)4096 + (size_t)64 * (size_t)(balls) + (size_t)192 * (size_t)(neighbours) + (size_t)112 * (size_t)(edges) + \
   (size_t)96 * (size_t)(cut_arcs))

/** Make an empty topology in caller memory of any alignment; sets *topology.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_topology_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_topology_init(void *memory, size_t bytes, const hsp_topology_limits *limits,
                                           hsp_topology **topology);

/** Compute the topology of a computed boundary, with its shells and regions. Boundary and model must outlive the
 *  topology; the topology can be read while boundary and model hold the same (RESULTS in hardsphere.h). On failure the
 *  topology holds no results. limits: see LIMITS in hardsphere.h; at most three retries.
 *  - Property 1: the order of the balls has no effect but on ids.
 *
 *  Cost: O(n) for sets as in Theorem 2.1 without voids; with voids, for every component of the union one vertical ray
 *  through the grid, at most O(n) each. A ball with m neighbours and a face of several loops takes about O(m), as on a
 *  line of balls that overlap; O(m^1.5) at most for a ball with m small balls all over its sphere, which yields some m
 *  log m edges; O(m^2) at worst.
 *  @retval HSP_E_ARGUMENT  topology or boundary is NULL
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since */
HSP_API int32_t HSP_CALL hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary,
                                              hsp_topology_limits *limits);

/** How a topology is computed. Zero means default in every field but the first. */
typedef struct hsp_topology_request {
  uint32_t struct_size;         /**< sizeof(hsp_topology_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_topology_request;

/** The same as hsp_topology_compute, with an executor that may stop it; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  topology or boundary is NULL; an executor with several workers and
 *                          without run
 *  @retval HSP_E_VERSION   bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY  as hsp_topology_compute
 *  @retval HSP_E_STATE     as hsp_topology_compute
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_topology_compute_with(hsp_topology *topology, const hsp_boundary *boundary,
                                                   const hsp_topology_request *request, hsp_topology_limits *limits);

/** How many of everything. Frozen. */
typedef struct hsp_topology_counts {
  uint32_t vertices;     /**< of the boundary, and those that were added */
  uint32_t edges;        /**< of all kinds */
  uint32_t simple_faces; /**< what the maximal faces are cut into */
  uint32_t cut_edges;    /**< edges that cut a face or a whole sphere */
  uint32_t shells;       /**< connected components of the boundary */
  uint32_t components;   /**< of the union */
  uint32_t regions;      /**< of the complement: 1 + voids */
  uint32_t start_face;   /**< the simple face that holds the highest point of all; HSP_NONE if there are no balls */
  uint32_t reserved[4];  /**< 0 */
} hsp_topology_counts;

/** How many vertices, edges, faces, shells, components and regions there are.
 *  - Property 1: vertices - edges + simple_faces is the Euler characteristic of the boundary.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts);

/* ---- shells, components, regions --------------------------------------------------------------------------------- */

#define HSP_SHELL_OUTER UINT32_C(0) /**< bounds its component from outside */
#define HSP_SHELL_VOID UINT32_C(1)  /**< bounds a void inside its component */

/** A shell: a connected component of the boundary. simple_faces, edges, vertices and start_face depend on how faces are
 *  cut, which a minor version may change (topology.h). Frozen. */
typedef struct hsp_shell {
  double area;           /**< length^2 */
  double volume;         /**< of the space that it encloses, with whatever lies in it, length^3 */
  double point[3];       /**< a point on it, length */
  int64_t euler;         /**< Euler characteristic: vertices - edges + simple faces */
  uint32_t genus;        /**< 1 - euler/2: number of handles */
  uint32_t kind;         /**< HSP_SHELL_* */
  uint32_t component;    /**< of the union, as in hsp_ball */
  uint32_t region;       /**< the region of the complement on its other side */
  uint32_t faces;        /**< maximal faces */
  uint32_t simple_faces; /**< simple faces that its maximal faces are cut into */
  uint32_t edges;        /**< edges of its simple faces */
  uint32_t vertices;     /**< vertices of these edges */
  uint32_t start_face;   /**< simple face where its scan starts: of an outer shell the one with its highest point, of a
                            void the first one on its ball of lowest rank (x, y, z, radius) */
  uint32_t reserved;     /**< 0 */
} hsp_shell;

/** The shells: hsp_topology_counts.shells records.
 *  - Property 1: up to rounding, areas sum to the area of the union, and the volumes of outer shells less those of
 *    shells of voids to its volume.
 *
 *  Accuracy: an area has an error of a few 1e-16 of r^2 for each arc and circle on a ball of radius r, and a volume
 *  has one of a few 1e-16 of r^2 (r + d), with d the distance of that ball's centre from o (hsp_boundary_measure). So
 *  of a void beside a ball that is 10,000 times as large as the void two or three digits of the volume are right, and
 *  beside a ball that is 100,000 times as large the volume may be negative.
 *  Cost: O(edges).
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_topology_get_shells(const hsp_topology *topology, hsp_shell *out, uint32_t capacity,
                                                 uint32_t *needed);

/** A connected component of the union. Frozen. */
typedef struct hsp_component {
  uint32_t balls;       /**< how many it consists of */
  uint32_t top_ball;    /**< the ball with its highest point */
  uint32_t outer_shell; /**< the one shell of kind HSP_SHELL_OUTER */
  uint32_t shells;      /**< outer shell and voids */
  uint32_t region;      /**< the region it lies in: 0 or a void of another component */
  uint32_t reserved;    /**< 0 */
} hsp_component;

/** The connected components of the union, as numbered in hsp_ball: hsp_topology_counts.components records.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_topology_get_components(const hsp_topology *topology, hsp_component *out,
                                                     uint32_t capacity, uint32_t *needed);

/** A region: a connected component of the complement of the union. Frozen. */
typedef struct hsp_region {
  double area;              /**< of all shells that bound it, length^2 */
  double volume;            /**< of the region itself, without what lies in it, length^3; 0 for region 0 */
  uint32_t enclosing_shell; /**< the shell of kind HSP_SHELL_VOID around it; HSP_NONE for region 0 */
  uint32_t components;      /**< components of the union that lie in it */
  uint32_t shells;          /**< shells that bound it */
  uint32_t reserved;        /**< 0 */
} hsp_region;

/** The regions of the complement: hsp_topology_counts.regions records.
 *
 *  Accuracy: that of the shells around them, hsp_topology_get_shells.
 *  Cost: O(edges).
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_topology_get_regions(const hsp_topology *topology, hsp_region *out, uint32_t capacity,
                                                  uint32_t *needed);

/** The shells that bound a region, ascending: its enclosing shell, and the outer shell of every component in it. Cost:
 *  O(shells).
 *  @retval HSP_E_ARGUMENT  topology is NULL; shells is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        there is no such region */
HSP_API int32_t HSP_CALL hsp_topology_get_region_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells,
                                                        uint32_t capacity, uint32_t *needed);

/** The balls that line a region, ascending: those with a face on one of its shells. For a cavity these are the balls
 *  around it and the exposed balls of components that lie in it.
 *  - Property 1: an exposed ball lines at least one region, a buried ball none.
 *
 *  Cost: O(shells + k log k) for k simple faces on the region, for sets as in Theorem 2.1.
 *  @retval HSP_E_ARGUMENT  topology is NULL; balls is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        there is no such region */
HSP_API int32_t HSP_CALL hsp_topology_get_region_balls(const hsp_topology *topology, uint32_t region, uint32_t *balls,
                                                       uint32_t capacity, uint32_t *needed);

/* ---- point location ---------------------------------------------------------------------------------------------- */

/** Where the point xyz [3] lies: *region becomes its region, or HSP_NONE if it lies in a ball. Exact; the point is
 *  rounded to the lattice. A point can move from one place to another without entering a ball exactly if both places
 *  lie in one region. In a model with a probe the same holds of the probe's centre. hsp_query_point tells which balls a
 *  point lies in.
 *  Cost: one vertical ray: O(1) for each cube that it passes, with at most 194 slots of the hash table for each cube
 *  (hsp_model_set), and O(1) for each ball near it; at most O(n).
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or model or boundary changed since
 *  @retval HSP_E_NOT_FINITE  xyz holds a NaN or an infinity
 *  @retval HSP_E_RANGE       xyz lies beyond 2^50 lattice steps */
HSP_API int32_t HSP_CALL hsp_topology_locate(const hsp_topology *topology, const double *xyz, uint32_t *region);

#ifdef __cplusplus
}
#endif

#endif
