/* hardsphere/topology.h: the boundary as quad-edges with simple faces (Section 4.2, Step 3).
 *
 * Guide: tutorial.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 * The boundary as one quad-edge structure (Guibas and Stolfi 1985) whose faces are simple, as the paper has them: every
 * simple face is bounded by one loop of at least two edges, every edge lies between two different simple faces.
 * Therefore
 *   - arcs stay as they are, each is an edge or, where a cut arc ends on it, several;
 *   - a free circle becomes at least two edges. They meet in the circle's two points in the plane that contains both
 *     balls' centres and the direction z (if the centres lie above each other, the plane across x);
 *   - a face with several loops is cut by cut arcs: pieces of great circles in planes that contain the direction z.
 *     Each plane goes through the axis of a circle on that ball; there are as many planes as it takes to join the
 *     face's loops;
 *   - a whole sphere is cut in two by the great circle across x, whose two edges meet in its highest and lowest points.
 * These rules hold for every structure and are stable. *Which* cut arcs and subdivisions there are, of the many that
 * make faces simple, may change with a minor version, which then raises HSP_NUMERICS_NUMBER. In regions.h only
 * start_face and the counts of simple faces, their edges and vertices, in hsp_shell and hsp_topology_counts, depend on
 * it.
 *
 *   vertex         0 .. vertices - 1; vertices of the boundary come first, with their ids of hsp_boundary_get_vertices
 *   edge           0 .. edges - 1
 *   quarter-edge   q = 4 edge + k: the edge's four directed forms. k = 0 is the edge, k = 2 the edge the other way
 *                  (sym), k = 1 the dual edge from its right to its left face (rot), k = 3 the dual edge back (inverse
 *                  rot)
 *   simple face    0 .. simple_faces - 1
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

#include "regions.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- quad-edges -------------------------------------------------------------------------------------------------- */

/** The dual edge of q, from its right face to its left one. Like the next two macros this one is arithmetic on the
 *  quarter-edge q = 4 edge + k, a uint32_t, and may evaluate q several times. HSP_NONE yields HSP_NONE.
 *  - Property 1: rot(rot(q)) = sym(q), sym(sym(q)) = q, inverse_rot(rot(q)) = q. */
#define HSP_QUAD_ROT(q) ((q) == HSP_NONE ? HSP_NONE : (((q) & ~UINT32_C(3)) | (((q) + 1U) & UINT32_C(3))))

/** The dual edge of q the other way, from its left face to its right one. */
#define HSP_QUAD_INVERSE_ROT(q) ((q) == HSP_NONE ? HSP_NONE : (((q) & ~UINT32_C(3)) | (((q) + 3U) & UINT32_C(3))))

/** The edge q the other way. */
#define HSP_QUAD_SYM(q) ((q) == HSP_NONE ? HSP_NONE : ((q) ^ UINT32_C(2)))

/** The next edge counter-clockwise about the origin of q; HSP_NONE if there is no such quarter-edge, or no results.
 *  - Property 1: rot(onext(rot(onext(q)))) = q.
 *  - Property 2: origin(onext(q)) = origin(q). */
HSP_API uint32_t HSP_CALL hsp_topology_onext(const hsp_topology *topology, uint32_t q);

/** The next edge counter-clockwise about the left face of q, from where q ends; HSP_NONE if there is no such
 *  quarter-edge, or no results.
 *  - Property 1: lnext(q) = rot(onext(inverse_rot(q))).
 *  - Property 2: left(lnext(q)) = left(q), origin(lnext(q)) = origin(sym(q)). */
HSP_API uint32_t HSP_CALL hsp_topology_lnext(const hsp_topology *topology, uint32_t q);

/** The next edge clockwise about the origin of q, the inverse of onext: rot(onext(rot(q))), which is lnext(sym(q)). q
 *  may be evaluated several times. */
#define HSP_TOPOLOGY_OPREV(topology, q) hsp_topology_lnext((topology), HSP_QUAD_SYM(q))

/** The previous edge about the left face of q, the inverse of lnext: sym(onext(q)). Both arguments may be evaluated
 *  several times, and the function called as often; HSP_QUAD_SYM of a variable that holds onext(q) calls it once. */
#define HSP_TOPOLOGY_LPREV(topology, q) HSP_QUAD_SYM(hsp_topology_onext((topology), (q)))

/** Where q starts: a vertex if q is even, a simple face if q is odd (a dual edge); HSP_NONE if there is no such
 *  quarter-edge, or no results. */
HSP_API uint32_t HSP_CALL hsp_topology_origin(const hsp_topology *topology, uint32_t q);

/** The left side of q: a simple face if q is even, a vertex if q is odd; HSP_NONE if there is no such
 *  quarter-edge, or no results.
 *  - Property 1: left(q) = origin(inverse_rot(q)). */
HSP_API uint32_t HSP_CALL hsp_topology_left(const hsp_topology *topology, uint32_t q);

/** The quad-edge structure as two flat arrays, for the edges first .. first + count - 1: onext [count][4] and origin
 *  [count][4], by quarter-edge; all else follows by rot. Either may be NULL, with count 0 both. first 0 and count
 *  hsp_topology_counts.edges are all edges.
 *  - Property 1: the arrays hold what hsp_topology_onext and hsp_topology_origin say.
 *
 *  @retval HSP_E_ARGUMENT  topology is NULL; both arrays are NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these edges are there */
HSP_API int32_t HSP_CALL hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t first, uint32_t count,
                                                     uint32_t *onext, uint32_t *origin);

/* ---- vertices, edges, simple faces ------------------------------------------------------------------------------- */

#define HSP_POINT_VERTEX UINT32_C(0) /**< a vertex of the boundary; its id is the same */
#define HSP_POINT_CIRCLE UINT32_C(1) /**< an added point of an arc or circle of ball[0] < ball[1] */
#define HSP_POINT_POLE UINT32_C(2)   /**< the highest or lowest point of the sphere of ball[0] */

/** A vertex: one of the boundary, or one that was added where edges are cut. Frozen. */
typedef struct hsp_topology_vertex {
  double xyz[3];     /**< position, length */
  uint32_t ball[3];  /**< the one to three balls whose spheres meet there, ascending, then HSP_NONE */
  uint32_t kind;     /**< HSP_POINT_* */
  uint32_t q;        /**< a quarter-edge that starts there */
  uint32_t reserved; /**< 0 */
} hsp_topology_vertex;

#define HSP_EDGE_ARC UINT32_C(0)    /**< an arc of hsp_boundary_get_arcs or a piece of one */
#define HSP_EDGE_CIRCLE UINT32_C(1) /**< a piece of a free circle */
#define HSP_EDGE_CUT UINT32_C(2)    /**< a piece of a great circle that cuts a face; both sides lie on one ball */

/** An edge: a piece of a circle between two vertices and two simple faces. Frozen. */
typedef struct hsp_topology_edge {
  double centre[3];   /**< of its circle, length */
  double axis[3];     /**< unit vector towards its left face; the edge runs counter-clockwise about it */
  double radius;      /**< of its circle, length */
  double angle;       /**< from origin to destination, in [0, 2 pi] */
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
  uint32_t q;        /**< an even quarter-edge of one of its edges, with this face on its left */
  uint32_t shell;    /**< the shell it belongs to */
  uint32_t reserved; /**< 0 */
} hsp_simple_face;

/** The vertices first .. first + count - 1, exactly count records, of hsp_topology_counts.vertices in all; out may be
 *  NULL with count 0.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these vertices are there */
HSP_API int32_t HSP_CALL hsp_topology_get_vertices(const hsp_topology *topology, uint32_t first, uint32_t count,
                                                   hsp_topology_vertex *out);

/** The edges first .. first + count - 1, exactly count records, of hsp_topology_counts.edges in all; out may be NULL
 *  with count 0.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these edges are there */
HSP_API int32_t HSP_CALL hsp_topology_get_edges(const hsp_topology *topology, uint32_t first, uint32_t count,
                                                hsp_topology_edge *out);

/** The simple faces first .. first + count - 1, exactly count records, of hsp_topology_counts.simple_faces in all; out
 *  may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  topology is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        not all of these simple faces are there */
HSP_API int32_t HSP_CALL hsp_topology_get_simple_faces(const hsp_topology *topology, uint32_t first, uint32_t count,
                                                       hsp_simple_face *out);

/* ---- the scan of a shell ----------------------------------------------------------------------------------------- */

/** The paper's scan of one shell: the simple faces of the shell in the order of a depth-first search from start_face.
 *  The search goes around each face counter-clockwise from the edge by which it entered the face (hsp_simple_face.q for
 *  start_face), and enters every neighbour not visited before at once. With the shell of hsp_topology_counts.start_face
 *  it scans the outer boundary component from the topmost ball.
 *
 *  Cost: O(1) for each simple face of the shell.
 *  @retval HSP_E_ARGUMENT  topology is NULL; faces is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        there is no such shell */
HSP_API int32_t HSP_CALL hsp_topology_get_traversal(const hsp_topology *topology, uint32_t shell, uint32_t *faces,
                                                    uint32_t capacity, uint32_t *needed);

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
HSP_API int32_t HSP_CALL hsp_topology_check(hsp_topology *topology, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
