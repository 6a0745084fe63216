/* hardsphere/periodic_boundary.h: the boundary of a union in a periodic box: vertices, arcs, circles, faces, loops.
 *
 * Guide: periodic_boxes.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * Vertices, arcs, circles, faces and loops are defined as in hardsphere/boundary.h. Each is listed once, also where it
 * crosses faces of the box or lies on several images. Its copies fill space; the record describes one copy, and says
 * which images of its balls belong to it:
 *
 *   place    every ball has one image with 0 <= x < a_x, 0 <= y < b_y and 0 <= z < c_z, once the box is turned and none
 *            of its vectors points to the other side (hardsphere/periodic.h): its place in the box
 *   record   in the copy that is listed, the first ball of a vertex, arc or circle is at its place, and the ball of a
 *            face is. Balls are in the caller's order, images of one ball in the order of their positions: by z, then
 *            y, then x, lower ones first
 *   shifts   hsp_image says how a ball is moved from where it was given, hsp_periodic_id how another record is moved
 *            from where it is listed
 *
 * So records, their numbers and everything in them except shifts of hsp_image are the same bit for bit, whichever
 * images of the balls were given. With other vectors for the same box shifts are multiples of those vectors. */
#ifndef HARDSPHERE_PERIODIC_BOUNDARY_H
#define HARDSPHERE_PERIODIC_BOUNDARY_H

#include "boundary.h"
#include "periodic.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A record of one of the lists below, and the copy of it that is meant. Frozen. */
typedef struct hsp_periodic_id {
  uint32_t id;      /**< index in its list */
  int32_t shift[3]; /**< multiples of the box vectors by which it is moved from where it is listed */
} hsp_periodic_id;

/** A vertex of the boundary. Frozen. */
typedef struct hsp_periodic_vertex {
  double xyz[3];      /**< position, length */
  hsp_image image[3]; /**< its balls a, b, c, the first one at its place */
  int32_t sign;       /**< +1 or -1: its side of the plane of the centres; +1 is along (c_b - c_a) x (c_c - c_a) */
  uint32_t flags;     /**< HSP_VERTEX_* of hardsphere/boundary.h */
} hsp_periodic_vertex;

/** The vertices: counts.vertices records.
 *  - Property 1: each vertex ends exactly three arcs.
 *
 *  Cost: O(vertices).
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_vertices(const hsp_periodic *periodic, hsp_periodic_vertex *out,
                                                   uint32_t capacity, uint32_t *needed);

/** An arc runs counter-clockwise about its axis, from vertex[0] to vertex[1]. Seen from outside the balls, face[1] lies
 *  on its left and face[0] on its right. Frozen. */
typedef struct hsp_periodic_arc {
  double centre[3];          /**< of its circle, length */
  double axis[3];            /**< unit vector from c_a towards c_b */
  double radius;             /**< of its circle, length */
  double angle;              /**< from vertex[0] to vertex[1], in [0, 2 pi] */
  hsp_image image[2];        /**< its balls a and b, the first one at its place */
  hsp_periodic_id vertex[2]; /**< where it starts and where it ends */
  hsp_periodic_id face[2];   /**< the face on ball a and the face on ball b */
} hsp_periodic_arc;

/** The arcs: counts.arcs records.
 *
 *  Cost: O(arcs); for those across the faces of the box times the arcs of a ball.
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_arcs(const hsp_periodic *periodic, hsp_periodic_arc *out, uint32_t capacity,
                                               uint32_t *needed);

/** A whole circle that is free. Counter-clockwise about the axis, face[1] lies on its left and face[0] on its right, as
 *  at arcs. Frozen. */
typedef struct hsp_periodic_circle {
  double centre[3];        /**< length */
  double axis[3];          /**< unit vector from c_a towards c_b */
  double radius;           /**< length */
  hsp_image image[2];      /**< its balls a and b, the first one at its place */
  hsp_periodic_id face[2]; /**< the face on ball a and the face on ball b */
} hsp_periodic_circle;

/** The free circles: counts.circles records.
 *
 *  Cost: O(circles); for those across the faces of the box times the circles of a ball.
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_circles(const hsp_periodic *periodic, hsp_periodic_circle *out,
                                                  uint32_t capacity, uint32_t *needed);

/** A face of the boundary. Frozen. */
typedef struct hsp_periodic_face {
  hsp_image image;     /**< the ball it lies on, at its place */
  uint32_t loops;      /**< its boundary loops; 0 for a whole sphere */
  uint32_t shell;      /**< 0 .. counts.shells - 1, in the order of their first faces */
  uint32_t first_loop; /**< its loops are first_loop .. first_loop + loops - 1 of hsp_periodic_get_loops */
  uint32_t reserved;   /**< 0 */
} hsp_periodic_face;

/** The faces: counts.faces records; faces of one ball are consecutive.
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_faces(const hsp_periodic *periodic, hsp_periodic_face *out, uint32_t capacity,
                                                uint32_t *needed);

/** A boundary loop of a face: a closed chain of arcs, or a whole circle. Seen from outside the ball, it keeps its face
 *  on its left. Frozen. */
typedef struct hsp_periodic_loop {
  hsp_periodic_id circle; /**< the circle that it is, at the listed face; id HSP_NONE if it consists of arcs */
  uint32_t face;          /**< the face that it bounds */
  uint32_t side;          /**< 1: a circle counter-clockwise about its axis; 0: a circle clockwise, or arcs */
  uint32_t first_arc;     /**< its arcs are first_arc .. first_arc + arcs - 1 of hsp_periodic_get_loop_arcs */
  uint32_t arcs;          /**< at least 2; 0 for a circle */
} hsp_periodic_loop;

/** The loops, face after face: counts.loops records.
 *
 *  Cost: O(loops); for circles across the faces of the box times the circles of a ball.
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_loops(const hsp_periodic *periodic, hsp_periodic_loop *out, uint32_t capacity,
                                                uint32_t *needed);

/** An arc as a part of a loop; shifts are for the face of the loop where it is listed. Frozen. */
typedef struct hsp_periodic_loop_arc {
  hsp_periodic_id arc;    /**< of hsp_periodic_get_arcs */
  hsp_periodic_id vertex; /**< where the loop enters it: vertex[1 - side] of the arc, moved with it */
  uint32_t side;          /**< 1: the loop runs along it, 0: against it; its face[side] is that of the loop */
  uint32_t reserved;      /**< 0 */
} hsp_periodic_loop_arc;

/** The arcs of all loops, loop after loop, and within a loop in walking order: 2 counts.arcs records.
 *  - Property 1: the arcs of a loop are closed: each ends at the vertex of the next, the last at that of the first, at
 *    the same copy of the box.
 *  - Property 2: every arc occurs once with side 0 and once with side 1.
 *
 *  Cost: O(arcs); for those across the faces of the box times the arcs of a ball.
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_loop_arcs(const hsp_periodic *periodic, hsp_periodic_loop_arc *out,
                                                    uint32_t capacity, uint32_t *needed);

/** Faces and component of each ball, as hsp_boundary_get_balls: one record per ball, in the caller's order. A ball may
 *  be contained in an image of another one; component is that of hsp_periodic_get_components.
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_balls(const hsp_periodic *periodic, hsp_ball *out, uint32_t capacity,
                                                uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
