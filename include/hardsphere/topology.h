/* hardsphere/topology.h: the boundary as quad-edges with simple faces, shells, regions (Section 4.2, Step 3).
 *
 * Guide: tutorial.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 * The boundary as one quad-edge structure (Guibas and Stolfi 1985) whose faces are simple, as the paper has them: every
 * simple face is bounded by one loop of at least two edges, every edge by two different simple faces. To this end
 *   - arcs stay as they are, each is an edge or, where a cut arc ends on it, several;
 *   - a free circle becomes at least two edges, meeting in its two points in the plane through its balls' centres that
 *     contains the direction z (the plane across x if the centres lie above each other);
 *   - a face with several loops is cut by cut arcs: pieces of great circles in planes that contain z, each through
 *     the axis of a circle on that ball, as many of these planes as it takes to join the face's loops;
 *   - a whole sphere is cut in two by the great circle across x, in its highest and lowest points.
 *
 *   vertex         0 .. vertices - 1; the boundary's own vertices come first, with the ids that they have there
 *   edge           0 .. edges - 1
 *   quarter-edge   q = 4 edge + k: the edge's four directed forms. k = 0 is the edge, k = 2 the edge the other way
 *                  (sym), k = 1 and 3 the dual edges from its right to its left face and back (rot, inverse rot)
 *   simple face    0 .. simple_faces - 1
 *   region         a connected component of the complement of the union: region 0 is the outer one, the others are the
 *                  voids, in the order of their shells
 *   shell          as in hsp_face: each shell separates one component of the union from one region
 *
 *              destination(q)                   rot(q)        runs from the right face to the left one
 *                 \   |                         sym(q)        the same edge the other way
 *     lnext(q) <-- \  |                         onext(q)      the next edge counter-clockwise about q's origin
 *                   \ ^   right                 oprev(q)      the next one clockwise
 *           left     \|                         lnext(q)      the next edge counter-clockwise about q's left face,
 *                     | q                                     from q's destination
 *     onext(q) <-- \  |                         lprev(q)      the previous one
 *                   \ |                         counter-clockwise: seen from outside the balls
 *                 origin(q)
 */
#ifndef HARDSPHERE_TOPOLOGY_H
#define HARDSPHERE_TOPOLOGY_H

#include "boundary.h"

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

/** Limits for a computed boundary that nearly always suffice: its balls, neighbours and shells, four cut arcs for every
 *  loop of a face beyond the first, and edges for its arcs, circles and whole spheres and four for every cut arc.
 *  Without a boundary, for memory that is fixed beforehand, set them by hand: for molecules of `balls` atoms, van der
 *  Waals or solvent-accessible, neighbours min(balls, 256), edges 16 balls + 96, cut_arcs 2 balls + 16 and shells 0
 *  suffice.
 *  @retval HSP_E_ARGUMENT  limits or boundary is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since */
HSP_API int32_t hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size,
                                         const hsp_boundary *boundary);

/** Bytes that hsp_topology_init needs.
 *  - Property 1: at most HSP_TOPOLOGY_BYTES of the first four limits.
 *  - Property 2: grows with each limit, shells being as many as the edges allow if they are 0.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t hsp_topology_bytes(const hsp_topology_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_TOPOLOGY_BYTES(balls, neighbours, edges, cut_arcs)                                                        \
  ((size_t)4096 + (size_t)64 * (size_t)(balls) + (size_t)192 * (size_t)(neighbours) + (size_t)112 * (size_t)(edges) + \
   (size_t)96 * (size_t)(cut_arcs))

/** Make an empty topology in caller memory of any alignment; sets *topology.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_topology_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t hsp_topology_init(void *memory, size_t bytes, const hsp_topology_limits *limits,
                                  hsp_topology **topology);

/** Compute the topology of a computed boundary. Boundary and model must outlive the topology, which can be read while
 *  these hold the same (RESULTS in hardsphere.h). On failure it holds no results. limits: see LIMITS in hardsphere.h;
 *  at most three retries.
 *  - Property 1: the order of the balls has no effect but on ids.
 *
 *  Cost: O(n) for sets as in Theorem 2.1 without voids; with voids, for every component of the union one vertical ray
 *  through the grid, at most O(n) each. A ball with m neighbours and a
 *  face of several loops takes about O(m), as on a line of balls that overlap; O(m^2) and more with m small balls that
 *  stud one.
 *  @retval HSP_E_ARGUMENT  topology or boundary is NULL
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since */
HSP_API int32_t hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary, hsp_topology_limits *limits);

/** How many of everything. Frozen. */
typedef struct hsp_topology_counts {
  uint32_t vertices;     /**< those of the boundary and the added ones */
  uint32_t edges;        /**< of all kinds */
  uint32_t simple_faces; /**< what the maximal faces are cut into */
  uint32_t cut_edges;    /**< of the edges, the ones that cut a face or a whole sphere */
  uint32_t shells;       /**< connected components of the boundary */
  uint32_t components;   /**< of the union */
  uint32_t regions;      /**< of the complement: 1 + voids */
  uint32_t start_face;   /**< the simple face that holds the highest point of all; HSP_NONE if there are no balls */
} hsp_topology_counts;

/** How many vertices, edges, faces, shells, components and regions there are.
 *  - Property 1: vertices - edges + simple_faces is the Euler characteristic of the boundary.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts);

/* ---- quad-edges -------------------------------------------------------------------------------------------------- */

/** The dual edge of q, from its right face to its left one. Like the next two macros this is arithmetic on the
 *  quarter-edge q = 4 edge + k, a uint32_t, which it may evaluate several times. HSP_NONE yields HSP_NONE.
 *  - Property 1: rot(rot(q)) = sym(q), sym(sym(q)) = q, inverse_rot(rot(q)) = q. */
#define HSP_QUAD_ROT(q) ((q) == HSP_NONE ? HSP_NONE : (((q) & ~UINT32_C(3)) | (((q) + 1U) & UINT32_C(3))))

/** The dual edge of q the other way, from its left face to its right one. */
#define HSP_QUAD_INVERSE_ROT(q) ((q) == HSP_NONE ? HSP_NONE : (((q) & ~UINT32_C(3)) | (((q) + 3U) & UINT32_C(3))))

/** The edge q the other way. */
#define HSP_QUAD_SYM(q) ((q) == HSP_NONE ? HSP_NONE : ((q) ^ UINT32_C(2)))

/** The next edge counter-clockwise about the origin of q; HSP_NONE if there is no such quarter-edge, or no results.
 *  - Property 1: rot(onext(rot(onext(q)))) = q.
 *  - Property 2: origin(onext(q)) = origin(q). */
HSP_API uint32_t hsp_topology_onext(const hsp_topology *topology, uint32_t q);

/** The next edge counter-clockwise about the left face of q, from where q ends; HSP_NONE if there is no such
 *  quarter-edge, or no results.
 *  - Property 1: lnext(q) = rot(onext(inverse_rot(q))).
 *  - Property 2: left(lnext(q)) = left(q), origin(lnext(q)) = origin(sym(q)). */
HSP_API uint32_t hsp_topology_lnext(const hsp_topology *topology, uint32_t q);

/** The next edge clockwise about the origin of q, the inverse of onext: rot(onext(rot(q))), which is lnext(sym(q)). q
 *  may be evaluated several times. */
#define HSP_TOPOLOGY_OPREV(topology, q) hsp_topology_lnext((topology), HSP_QUAD_SYM(q))

/** The previous edge about the left face of q, the inverse of lnext: sym(onext(q)). Both arguments may be evaluated
 *  several times, and the step taken as often; with onext(q) in a variable it is taken once. */
#define HSP_TOPOLOGY_LPREV(topology, q) HSP_QUAD_SYM(hsp_topology_onext((topology), (q)))

/** Where q starts: a vertex if q is even, a simple face if q is odd (a dual edge); HSP_NONE if there is no such
 *  quarter-edge, or no results. */
HSP_API uint32_t hsp_topology_origin(const hsp_topology *topology, uint32_t q);

/** The left side of q: a simple face if q is even, a vertex if q is odd; HSP_NONE if there is no such
 *  quarter-edge, or no results.
 *  - Property 1: left(q) = origin(inverse_rot(q)). */
HSP_API uint32_t hsp_topology_left(const hsp_topology *topology, uint32_t q);

/** The structure as two flat arrays, for the edges first .. first + count - 1: onext [count][4] and origin [count][4];
 *  all else follows by rot. Either may be NULL, with count 0 both. 0 and hsp_topology_counts.edges are all edges.
 *  - Property 1: the arrays hold what hsp_topology_onext and hsp_topology_origin say.
 *
 *  @retval HSP_E_ARGUMENT  topology is NULL; both arrays are NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these edges are there */
HSP_API int32_t hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t first, uint32_t count,
                                            uint32_t *onext, uint32_t *origin);

/* ---- vertices, edges, simple faces ------------------------------------------------------------------------------- */

#define HSP_POINT_VERTEX UINT32_C(0) /**< a vertex of the boundary; its id is the same */
#define HSP_POINT_CIRCLE UINT32_C(1) /**< an added point of an arc or circle of ball[0] < ball[1] */
#define HSP_POINT_POLE UINT32_C(2)   /**< the highest or lowest point of the sphere of ball[0] */

/** A vertex: one of the boundary, or one that was added where edges are cut. Frozen. */
typedef struct hsp_topology_vertex {
  double xyz[3];     /**< position, length */
  uint32_t ball[3];  /**< the balls whose spheres meet there, ascending, HSP_NONE for those there are not */
  uint32_t kind;     /**< HSP_POINT_* */
  uint32_t q;        /**< a quarter-edge that starts there */
  uint32_t reserved; /**< 0 */
} hsp_topology_vertex;

#define HSP_EDGE_ARC UINT32_C(0)    /**< an arc of hsp_boundary_get_arcs or a piece of one */
#define HSP_EDGE_CIRCLE UINT32_C(1) /**< a piece of a free circle */
#define HSP_EDGE_CUT UINT32_C(2)    /**< a piece of a great circle that cuts a face; both sides lie on one ball */

/** An edge: a piece of a circle between two vertices and two simple faces. Frozen. */
typedef struct hsp_topology_edge {
  double centre[3]; /**< of its circle, length */
  double axis[3];   /**< unit vector; the edge runs counter-clockwise about it, its left face lies on the axis's side */
  double radius;    /**< of its circle, length */
  double angle;     /**< from origin to destination, in [0, 2 pi] */
  uint32_t vertex[2]; /**< origin and destination */
  uint32_t face[2];   /**< simple faces on its left and right */
  uint32_t ball[2];   /**< balls of these faces */
  uint32_t kind;      /**< HSP_EDGE_* */
  uint32_t source;    /**< id of the boundary's arc or circle it is a piece of; HSP_NONE for cut edges */
} hsp_topology_edge;

/** A simple face: a part of a maximal face with one loop of edges. Frozen. */
typedef struct hsp_simple_face {
  uint32_t ball;     /**< the ball it lies on */
  uint32_t face;     /**< the maximal face of hsp_boundary_get_faces that it is a part of */
  uint32_t edges;    /**< on its loop, at least 2 */
  uint32_t q;        /**< the quarter-edge, even, of one of them, with this face on its left */
  uint32_t shell;    /**< the shell it belongs to */
  uint32_t reserved; /**< 0 */
} hsp_simple_face;

/** The vertices first .. first + count - 1, exactly count records, of hsp_topology_counts.vertices in all; out may be
 *  NULL with count 0.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these vertices are there */
HSP_API int32_t hsp_topology_get_vertices(const hsp_topology *topology, uint32_t first, uint32_t count,
                                          hsp_topology_vertex *out);

/** The edges first .. first + count - 1, exactly count records, of hsp_topology_counts.edges in all; out may be NULL
 *  with count 0.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these edges are there */
HSP_API int32_t hsp_topology_get_edges(const hsp_topology *topology, uint32_t first, uint32_t count,
                                       hsp_topology_edge *out);

/** The simple faces first .. first + count - 1, exactly count records, of hsp_topology_counts.simple_faces in all; out
 *  may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these simple faces are there */
HSP_API int32_t hsp_topology_get_simple_faces(const hsp_topology *topology, uint32_t first, uint32_t count,
                                              hsp_simple_face *out);

/* ---- shells, components, regions --------------------------------------------------------------------------------- */

#define HSP_SHELL_OUTER UINT32_C(0) /**< bounds its component from outside */
#define HSP_SHELL_VOID UINT32_C(1)  /**< bounds a void inside its component */

/** A shell: a connected component of the boundary. Frozen. */
typedef struct hsp_shell {
  double area;           /**< length^2 */
  double volume;         /**< of the space it encloses, whatever lies in it, length^3 */
  double point[3];       /**< a point of it, length */
  int32_t euler;         /**< Euler characteristic: vertices - edges + simple faces */
  uint32_t genus;        /**< 1 - euler/2: number of handles */
  uint32_t kind;         /**< HSP_SHELL_* */
  uint32_t component;    /**< of the union, as in hsp_ball */
  uint32_t region;       /**< of the complement, on its other side */
  uint32_t faces;        /**< maximal faces */
  uint32_t simple_faces; /**< and what they are cut into */
  uint32_t edges;        /**< edges of its simple faces */
  uint32_t vertices;     /**< vertices of these edges */
  uint32_t start_face;   /**< simple face where its scan starts: of an outer shell the one with its highest point, of a
                            void the first one on its ball of lowest rank (x, y, z, radius) */
} hsp_shell;

/** The shells: hsp_topology_counts.shells records.
 *  - Property 1: areas sum to the area of the union; volumes of outer shells less those of voids to its volume, up to
 *    rounding.
 *
 *  Not const, like hsp_topology_get_regions, hsp_topology_get_region_balls and hsp_topology_get_traversal: after
 *  hsp_topology_compute the first of them that succeeds scans the shells. From then on any number of threads may call
 *  them at a time.
 *
 *  Cost: O(edges) for the first of them, and then O(shells).
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t hsp_topology_get_shells(hsp_topology *topology, hsp_shell *out, uint32_t capacity, uint32_t *needed);

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
HSP_API int32_t hsp_topology_get_components(const hsp_topology *topology, hsp_component *out, uint32_t capacity,
                                            uint32_t *needed);

/** A region: a connected component of the complement of the union. Frozen. */
typedef struct hsp_region {
  double area;              /**< of all its shells, length^2 */
  double volume;            /**< of the region itself, what lies in it left out, length^3; of region 0: 0 */
  uint32_t enclosing_shell; /**< the shell of kind HSP_SHELL_VOID around it; HSP_NONE for region 0 */
  uint32_t components;      /**< components of the union that lie in it */
  uint32_t shells;          /**< shells that bound it */
  uint32_t reserved;        /**< 0 */
} hsp_region;

/** The regions of the complement: hsp_topology_counts.regions records. Not const, as hsp_topology_get_shells.
 *
 *  Cost: that of hsp_topology_get_shells.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t hsp_topology_get_regions(hsp_topology *topology, hsp_region *out, uint32_t capacity, uint32_t *needed);

/** The shells that bound a region, ascending: its enclosing shell, and the outer shell of every component in it. Cost:
 *  O(shells).
 *  @retval HSP_E_ARGUMENT  topology is NULL; shells is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        there is no such region */
HSP_API int32_t hsp_topology_get_region_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells,
                                               uint32_t capacity, uint32_t *needed);

/** The balls that line a region, ascending: those with a face on one of its shells. Of a cavity these are the balls
 *  around it and the exposed ones of what lies in it. Not const, as hsp_topology_get_shells.
 *  - Property 1: an exposed ball lines one region at least, a buried one none.
 *
 *  Cost: O(shells + k log k) for k simple faces on the region, for sets as in Theorem 2.1.
 *  @retval HSP_E_ARGUMENT  topology is NULL; balls is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        there is no such region */
HSP_API int32_t hsp_topology_get_region_balls(hsp_topology *topology, uint32_t region, uint32_t *balls,
                                              uint32_t capacity, uint32_t *needed);

/** The paper's scan of one shell: its simple faces in the order in which its recursion from start_face visits them,
 *  around each face counter-clockwise from the edge by which it was entered (hsp_simple_face.q for start_face) and
 *  at once into every neighbour not visited before. With the shell of hsp_topology_counts.start_face it is the outer
 *  boundary component from the topmost ball. Not const, as hsp_topology_get_shells.
 *
 *  Cost: that of hsp_topology_get_shells, and O(1) for each simple face of the shell.
 *  @retval HSP_E_ARGUMENT  topology is NULL; faces is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        there is no such shell */
HSP_API int32_t hsp_topology_get_traversal(hsp_topology *topology, uint32_t shell, uint32_t *faces, uint32_t capacity,
                                           uint32_t *needed);

/* ---- point location ---------------------------------------------------------------------------------------------- */

/** Where the point xyz [3] lies: *region becomes its region, or HSP_NONE if it lies in a ball. Exact; the point is
 *  rounded to the lattice. A point can move from one place to another without entering a ball if both lie in one
 *  region; with a model grown by a probe, so can the probe. hsp_query_point tells which balls a point lies in.
 *  Cost: one vertical ray: O(1) expected for each cube it passes, at most O(n).
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or model or boundary changed since
 *  @retval HSP_E_NOT_FINITE  xyz holds a NaN or an infinity
 *  @retval HSP_E_RANGE       xyz lies beyond 2^50 lattice steps */
HSP_API int32_t hsp_topology_locate(const hsp_topology *topology, const double *xyz, uint32_t *region);

/* ---- self-check -------------------------------------------------------------------------------------------------- */

/** Check the invariants of a computed topology. If all hold, *invariant becomes 0 and *id HSP_NONE. Else *invariant
 *  becomes the number of the first that is violated, and *id that of the quarter-edge, vertex, simple face, shell or
 *  component concerned:
 *  1. the quad-edge algebra: the properties of rot, onext, lnext and left above
 *  2. origins are vertices, and every vertex starts an edge and is one ring of onext
 *  3. every simple face is one ring of at least two edges, on one ball, and no edge has it on both sides
 *  4. sides of arcs and circles lie on their balls, sides of cut edges on one
 *  5. vertices - edges + simple faces of each shell is the Euler characteristic that its maximal faces give
 *  6. the scan visits every simple face of a shell once and no other
 *  7. every component has one outer shell, every other shell encloses one void, and the regions nest without cycles
 *  8. outer shells enclose a positive volume, voids' shells a negative one, up to rounding
 *
 *  Uses the topology's scratch memory, hence not const; results stay valid.
 *
 *  Cost: O(edges + n).
 *  @retval HSP_OK          all hold
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_CHECK     one is violated: please report it */
HSP_API int32_t hsp_topology_check(hsp_topology *topology, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
