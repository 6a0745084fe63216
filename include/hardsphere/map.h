/* hardsphere/map.h: the visibility map: the visible parts of balls as faces of the view plane (Section 5.2).
 *
 * Guide: questions.md, gallery.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * A view (view.h) is for painting, and its pieces overlap; a map has the visible parts themselves. View coordinates are
 * those of view.h: x to the right, y up, z towards the viewer. Edges cut the view plane into faces, each of which shows
 * one ball or the background:
 *   silhouette   an edge on the outline of a ball, a part of a circle: that ball is on its left, a farther ball or the
 *                background on its right
 *   crease       an edge where two spheres meet, a part of an ellipse: the ball with the nearer centre is on its left,
 *                the other ball on its right
 * Edges end at vertices:
 *   triple       three creases where three spheres meet
 *   T            a curve, the stem, goes behind a nearer ball, on that ball's silhouette
 *   tangency     a crease continues as the silhouette of the nearer ball
 *   plain        an arbitrary point of a closed curve that has no other vertex
 * Directed edges are numbers: edge e is 2e along its curve and 2e + 1 against it; HSP_MAP_TWIN turns one around. Each
 * directed edge bounds the face on its left. A face has one outer loop, counter-clockwise, and any number of holes,
 * clockwise; face 0 is the unbounded one and has holes only. Other faces may show the background, too. Faces of one
 * ball have consecutive numbers, faces of the background come first.
 *
 * A map rests on floating-point roots. Edges are linked by labels, the balls that they belong to, not by positions.
 * Labels that do not fit together are noticed while edges are linked. Then every ball is moved by a tiny part of its
 * radius, the same ball always by the same, and the map of the moved balls is made; hsp_map_info.perturbation says how
 * far. Where many balls are in one place, balls whose spheres are covered before the move stay hidden. So either there
 * is a map that satisfies all invariants of hsp_map_check, or a status and no map. The same input yields the same bytes
 * on every machine. */
#ifndef HARDSPHERE_MAP_H
#define HARDSPHERE_MAP_H

#include "view.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A map of the balls from one direction. */
typedef struct hsp_map hsp_map;

/** The limits that fix a map's memory. */
typedef struct hsp_map_limits {
  uint32_t struct_size; /**< sizeof(hsp_map_limits) */
  uint32_t balls;       /**< of the model */
  uint32_t neighbours;  /**< most balls whose discs meet any one ball's disc and that reach higher than its centre */
  uint32_t edges;       /**< of the map */
} hsp_map_limits;

/** Limits that suffice for most molecules of `balls` atoms: neighbours min(balls, 256), edges 12 balls + 64.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 64) / 12 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_map_limits_init(hsp_map_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_map_init needs.
 *  - Property 1: at most HSP_MAP_BYTES of the three limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_map_bytes(const hsp_map_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_MAP_BYTES(balls, neighbours, edges) \
  ((size_t)32768 + (size_t)288 * (size_t)(balls) + (size_t)248 * (size_t)(neighbours) + (size_t)352 * (size_t)(edges))

/** Make an empty map in caller memory of any alignment; sets *map.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_map_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_map_init(void *memory, size_t bytes, const hsp_map_limits *limits, hsp_map **map);

/** Find the visible parts from one direction; any number of times, from any directions. options: the direction, as for
 *  hsp_view_compute, NULL for the defaults; its pieces and flags must be valid and have no effect. The model must
 *  outlive the map; the map can be read while the model holds the same balls (RESULTS in hardsphere.h). On failure the
 *  map holds no results. limits: see LIMITS in hardsphere.h; at most 39 retries.
 *  - Property 1: the order of the balls has no effect but on the numbers of balls.
 *  - Property 2: hsp_map_check finds nothing.
 *
 *  Cost: O(n log n), and for each ball that may be seen the number of balls whose discs meet its disc and that reach
 *  higher: O(n + k) expected for k edges of molecules; at worst, with all discs in one place, O(n^2) and O(e^3) for e
 *  balls that have a free point.
 *  @retval HSP_E_ARGUMENT    map or model is NULL; unknown pieces or flags; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size of options, executor or limits, or reserved of the options is not 0, or
 *                            unused not NULL
 *  @retval HSP_E_CAPACITY    a limit is too small
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  a component of towards or up is NaN or infinite
 *  @retval HSP_E_DEGENERATE  roundings could not be overcome by moving balls six times
 *  @retval HSP_E_STOPPED     the executor of the options said not to go on */
HSP_API int32_t HSP_CALL hsp_map_compute(hsp_map *map, const hsp_model *model, const hsp_view_options *options,
                                         hsp_map_limits *limits);

/** Counts, box and frame of a map. Frozen. */
typedef struct hsp_map_info {
  double origin[3];    /**< the point with view coordinates 0 0 0: the middle of the balls' centres, length */
  double right[3];     /**< unit vector: the x axis of the view coordinates */
  double up[3];        /**< unit vector: the y axis */
  double towards[3];   /**< unit vector: the z axis */
  double area;         /**< of the part of the view plane that balls cover, length^2 */
  double perturbation; /**< bound for how far centres were moved, length; 0 unless roundings had to be overcome */
  uint32_t vertices;   /**< of the map */
  uint32_t edges;      /**< of the map */
  uint32_t faces;      /**< of the map, the unbounded one included */
  uint32_t components; /**< connected parts of the edges */
  uint32_t balls;      /**< how many balls are seen */
  uint32_t reserved;   /**< 0 */
} hsp_map_info;

/** Describe the map: its frame, how far balls were moved and how many records it has.
 *  - Property 1: vertices - edges + faces = 1 + components.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_map_get_info(const hsp_map *map, hsp_map_info *info);

/* ---- steps ------------------------------------------------------------------------------------------------------- */

/** The directed edge h, a uint32_t, the other way. h may be evaluated several times. HSP_NONE yields HSP_NONE. */
#define HSP_MAP_TWIN(h) ((h) == HSP_NONE ? HSP_NONE : ((h) ^ UINT32_C(1)))

/** The next directed edge around the face on the left of h, from where h ends; h itself if it is a whole curve. This
 *  function and the next four return HSP_NONE if there is no such directed edge or there are no results.
 *  - Property 1: left(next(h)) = left(h), origin(next(h)) = origin(twin(h)). */
HSP_API uint32_t HSP_CALL hsp_map_next(const hsp_map *map, uint32_t h);

/** The previous directed edge around the face on the left of h: the inverse of hsp_map_next. */
HSP_API uint32_t HSP_CALL hsp_map_previous(const hsp_map *map, uint32_t h);

/** A directed edge of the next loop around the face on the left of h; of the first loop after the last. So all loops of
 *  a face are reached from `h` of its hsp_map_face. */
HSP_API uint32_t HSP_CALL hsp_map_next_loop(const hsp_map *map, uint32_t h);

/** The vertex where h starts. */
HSP_API uint32_t HSP_CALL hsp_map_origin(const hsp_map *map, uint32_t h);

/** The face on the left of h. */
HSP_API uint32_t HSP_CALL hsp_map_left(const hsp_map *map, uint32_t h);

/* ---- records ----------------------------------------------------------------------------------------------------- */

#define HSP_MAP_PLAIN UINT32_C(0)    /**< on a closed curve without other vertices */
#define HSP_MAP_TRIPLE UINT32_C(1)   /**< where three creases meet */
#define HSP_MAP_T UINT32_C(2)        /**< where a curve goes behind a silhouette */
#define HSP_MAP_TANGENCY UINT32_C(3) /**< where a crease continues as a silhouette */
#define HSP_MAP_HALVES UINT32_C(4)   /**< where halves of a stick meet at their outline; in sticks.h only */

/** A vertex. Frozen. */
typedef struct hsp_map_vertex {
  double xyz[3];     /**< view coordinates, length; of a T those of the point on the stem, which is behind */
  uint32_t kind;     /**< HSP_MAP_* */
  uint32_t h;        /**< a directed edge that starts here, of a T the stem; the next one is next(twin(h)), and so on */
  uint32_t ball[3];  /**< whose curves meet here. T: the stem's one or two balls, and in ball[2] the nearer ball;
                          triple: in any order; tangency: the farther one, the nearer one; else HSP_NONE */
  uint32_t reserved; /**< 0 */
} hsp_map_vertex;

/** An edge: the points centre + cos(t) first + sin(t) second of the view plane for t from `from` to `to`. first and
 *  second stand at right angles, their lengths are the semi-axes; second is a quarter turn ahead of first. Frozen. */
typedef struct hsp_map_edge {
  double centre[2];   /**< of its circle or ellipse, length */
  double first[2];    /**< length */
  double second[2];   /**< length */
  double from;        /**< in [-3 pi, pi] */
  double to;          /**< not below `from`, and at most 2 pi above it */
  uint32_t ball[2];   /**< silhouette: the ball, HSP_NONE; crease: the nearer ball, the farther one */
  uint32_t face[2];   /**< on its left and on its right */
  uint32_t vertex[2]; /**< where it starts and ends */
  uint32_t next[2];   /**< after 2 edge around face[0], after 2 edge + 1 around face[1] */
} hsp_map_edge;

/** A face: a part of the view plane where one ball is seen, or the background. Frozen. */
typedef struct hsp_map_face {
  double area;       /**< in the view plane, length^2; 0 for the unbounded one */
  uint32_t ball;     /**< the caller's index; HSP_NONE: the background */
  uint32_t h;        /**< a directed edge of its outer loop, of any hole for face 0; HSP_NONE if there are no edges */
  uint32_t loops;    /**< loops around it, holes included */
  uint32_t reserved; /**< 0 */
} hsp_map_face;

/** The vertices first .. first + count - 1, exactly count records, of hsp_map_info.vertices in all; out may be NULL
 *  with count 0.
 *  @retval HSP_E_ARGUMENT  map is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these vertices are there */
HSP_API int32_t HSP_CALL hsp_map_get_vertices(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_vertex *out);

/** The edges first .. first + count - 1, exactly count records, of hsp_map_info.edges in all; out may be NULL with
 *  count 0.
 *  - Property 1: edges end at their vertices up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  map is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these edges are there */
HSP_API int32_t HSP_CALL hsp_map_get_edges(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_edge *out);

/** The faces first .. first + count - 1, exactly count records, of hsp_map_info.faces in all; out may be NULL with
 *  count 0.
 *  - Property 1: the areas of all faces with a ball sum to hsp_map_info.area, up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  map is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these faces are there */
HSP_API int32_t HSP_CALL hsp_map_get_faces(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_face *out);

/** How much of each ball is seen: areas in the view plane, length^2, in the caller's order; 0 for hidden balls.
 *  @retval HSP_E_ARGUMENT  map is NULL; area is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, the number of balls
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_map_get_areas(const hsp_map *map, double *area, uint32_t capacity, uint32_t *needed);

/** The visible outline of a ball: one directed edge of every loop around the ball's visible parts. Follow each with
 *  hsp_map_next until it comes back; the visible part is on the left.
 *
 *  Cost: O(loops around the ball's visible parts).
 *  @retval HSP_E_ARGUMENT  map is NULL; h is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        no such ball */
HSP_API int32_t HSP_CALL hsp_map_get_outline(const hsp_map *map, uint32_t ball, uint32_t *h, uint32_t capacity,
                                             uint32_t *needed);

/* ---- questions --------------------------------------------------------------------------------------------------- */

/** The ball that is seen at a point of the view plane. Frozen. */
typedef struct hsp_map_sight {
  double depth;  /**< z of the ball's front there, length; -infinity for the background */
  uint32_t ball; /**< the caller's index; HSP_NONE: the background */
  uint32_t face; /**< the face there; HSP_NONE if the point is so close to an edge that roundings decide */
} hsp_map_sight;

/** The ball that is seen at (x, y), in view coordinates: *sight becomes its record.
 *
 *  Cost: O(balls whose discs are near), and O(edges around the ball's faces) for the face.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  x or y is NaN or infinite */
HSP_API int32_t HSP_CALL hsp_map_pick(const hsp_map *map, double x, double y, hsp_map_sight *sight);

/** A point of an edge. Frozen. */
typedef struct hsp_map_point {
  double xyz[3]; /**< view coordinates, length */
  double gap[2]; /**< how far behind it the ball on its left and on its right is, length; infinite: background */
} hsp_map_point;

/** The point of an edge at parameter t, between hsp_map_edge.from and .to, and the gaps beside it: of a silhouette the
 *  gap on the left is 0, of a crease both are.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_ID          no such edge
 *  @retval HSP_E_NOT_FINITE  t is NaN or infinite
 *  @retval HSP_E_RANGE       t is beyond the edge */
HSP_API int32_t HSP_CALL hsp_map_get_point(const hsp_map *map, uint32_t edge, double t, hsp_map_point *point);

/** The point of a face that is farthest from its edges, where a label has most room. Frozen. */
typedef struct hsp_map_pole {
  double centre[2]; /**< view coordinates, length */
  double radius;    /**< how far the nearest edge is from there, length */
  double bound;     /**< no point of the face is farther from the edges, length; not below `radius` */
} hsp_map_pole;

/** The pole of inaccessibility of a face: the centre of a circle in the face that is nearly the largest one. bound is
 *  at most radius (1 + 1/64), unless the face is so long and thin that 4096 points do not suffice to prove it; then
 *  bound is the best proven one. All are up to rounding.
 *
 *  Cost: O(edges around the face), times the points that are looked at: some hundred for most faces.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        no such face, or the unbounded one */
HSP_API int32_t HSP_CALL hsp_map_get_pole(const hsp_map *map, uint32_t face, hsp_map_pole *pole);

/* ---- self-check -------------------------------------------------------------------------------------------------- */

/** Check the invariants of a computed map. If all hold, *invariant becomes 0 and *id HSP_NONE. Else *invariant becomes
 *  the number of the first that is violated, and *id that of the vertex, edge, directed edge, loop or face where it
 *  fails, HSP_NONE if it is about the whole:
 *    1  vertices: their kinds tell how many edges they have, and they name a directed edge that starts there
 *    2  edges: parameters ascend by a whole turn at most, and the balls of both ends are those of the edge
 *    3  next is one to one, from where a directed edge ends
 *    4  all edges around a loop name one ball on that side, that of its face
 *    5  faces: each but the unbounded one has one outer loop, of positive area; holes have negative areas; faces of one
 *       ball have consecutive numbers; the unbounded face has a hole if there is a ball that may be seen
 *    6  vertices - edges + faces = 1 + components
 *    7  positions: edges end at their vertices, and every T lies on its silhouette
 *    8  areas: a face has the area of its loops, and all together have the area within the outermost edges; the visible
 *       area of a ball is at least 0 and at most its disc, up to how far edges end from their vertices
 *    9  sides: the balls on both sides of an edge have fronts at the middle of the edge, and none in front of it
 *  Works in the map's memory, hence not const. Cost: O(size of the map).
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_CHECK     an invariant is violated: please report it */
HSP_API int32_t HSP_CALL hsp_map_check(hsp_map *map, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
