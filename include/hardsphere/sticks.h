/* hardsphere/sticks.h: balls and sticks as a picture, with hidden parts removed, and as a visibility map.
 *
 * Guide: gallery.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * A stick is a solid cylinder between the centres of two balls. View coordinates are those of view.h: x to the right, y
 * up, z towards the viewer. A picture consists of balls, without their parts inside sticks, and halves of sticks: the
 * part of a stick outside its two balls is cut in the middle, and each half belongs to one ball, whose colour it has.
 * Balls and halves are painted one over the other; one that covers a part of another is painted after it. This order is
 * not a sort by depth, which is wrong for sticks: it follows from all pairs of which one covers a part of the other.
 *
 * There is no such order where balls meet, or where balls and sticks cover each other in a cycle, like the flaps of a
 * carton. Then the visible part of each is computed instead: no two paths overlap, and each line between them is drawn
 * once. The result is a visibility map of balls and halves of sticks; hsp_sticks_compute_map makes it also where there
 * is an order. Like a map of balls (map.h) it rests on floating-point roots, and labels link it; where labels do not
 * fit together, all balls are moved by less than 2^-13 of their radii.
 *
 * Sticks meet nothing outside the balls at their ends:
 *   a stick         is thinner than both its balls, and meets no other ball and no other stick
 *   two sticks      that end in one ball do not meet outside it: the ball's radius is at least the radius of either
 *                   stick divided by the sine of half the angle between them; at 60 degrees twice the thicker stick's
 *                   radius
 * All these rules are checked. If one fails hsp_sticks_conflict names it, and there is no picture. A stick between
 * balls that meet may lie inside them; then no rule applies to it. Where a rule holds or fails by less than about 2^-50
 * of all lengths, roundings decide. */
#ifndef HARDSPHERE_STICKS_H
#define HARDSPHERE_STICKS_H

#include "map.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The balls and sticks as they are seen from one direction. */
typedef struct hsp_sticks hsp_sticks;

/** The limits that fix the memory of balls and sticks. */
typedef struct hsp_sticks_limits {
  uint32_t struct_size; /**< sizeof(hsp_sticks_limits) */
  uint32_t balls;       /**< of the model */
  uint32_t sticks;      /**< most sticks */
  uint32_t pairs;       /**< pairs of balls and halves of sticks of which one may cover a part of the other; balls
                                that meet count twice */
  uint32_t edges;       /**< edges of the map, if a map is made */
} hsp_sticks_limits;

/** Limits that suffice for most molecules of `balls` atoms whose balls do not meet: sticks 2 balls, pairs 64 balls +
 *  64, edges 0.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 64) / 64 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_sticks_limits_init(hsp_sticks_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_sticks_init needs.
 *  - Property 1: at most HSP_STICKS_BYTES of the four limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_sticks_bytes(const hsp_sticks_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_STICKS_BYTES(balls, sticks, pairs, edges)                                                              \
  ((size_t)16384 + (size_t)192 * (size_t)(balls) + (size_t)384 * (size_t)(sticks) + (size_t)20 * (size_t)(pairs) + \
   (size_t)400 * (size_t)(edges))

/** Make balls and sticks without results in caller memory of any alignment; sets *sticks.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_sticks_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_sticks_init(void *memory, size_t bytes, const hsp_sticks_limits *limits,
                                         hsp_sticks **sticks);

/** A stick that is not cut in two: all of it belongs to ball[0]. For balls of one colour, as there is a line between
 *  two halves. */
#define HSP_STICK_WHOLE UINT32_C(1)

/** A double bond. A stick has at most one of these three kinds. Pictures that are painted in an order show a double
 *  bond as two strands, parts of the stick side by side that face the viewer; between them the background of the stick
 *  is seen. A triple bond has three strands; an aromatic bond has two, of which the right one, seen from ball[0] to
 *  ball[1], is dashed. Such a stick is 1.5 times as thick as others. For rules, order and map it is one stick of that
 *  thickness; pictures of a map have lines where strands begin and end on it. */
#define HSP_STICK_DOUBLE UINT32_C(2)
#define HSP_STICK_TRIPLE UINT32_C(4)   /**< three strands */
#define HSP_STICK_AROMATIC UINT32_C(8) /**< two strands, one of them dashed */

/** A stick. Frozen. */
typedef struct hsp_stick {
  uint32_t ball[2];  /**< its ends, the caller's indices */
  uint32_t flags;    /**< HSP_STICK_* */
  uint32_t reserved; /**< 0 */
} hsp_stick;

#define HSP_STICKS_NO_CONFLICT UINT32_C(0) /**< there is none */
#define HSP_STICKS_BALLS_MEET UINT32_C(1)  /**< two balls that meet: no order, but HSP_OK */
#define HSP_STICKS_NO_BALL UINT32_C(2)     /**< a stick, and its end, which is no ball */
#define HSP_STICKS_SAME_ENDS UINT32_C(3) /**< two sticks between the same balls; or a stick twice, whose ends are one */
#define HSP_STICKS_THIN_BALL UINT32_C(4) /**< a stick, and the ball at its end, which is not thicker */
#define HSP_STICKS_SHARP_ANGLE UINT32_C(5)   /**< two sticks that meet outside the ball in which both end */
#define HSP_STICKS_MEET UINT32_C(6)          /**< two other sticks that meet */
#define HSP_STICKS_STICK_IN_BALL UINT32_C(7) /**< a stick, and a ball that it meets and does not end in */
#define HSP_STICKS_CYCLE \
  UINT32_C(8) /**< a stick in a cycle of balls and halves of sticks, each of which covers
                                                  a part of the next; and the length of the cycle:
                                                  no order, but HSP_OK */

/** Why there is no picture, or no order in which to paint it. Frozen. */
typedef struct hsp_sticks_conflict {
  uint32_t kind;     /**< HSP_STICKS_* */
  uint32_t first;    /**< number of a ball or stick, as HSP_STICKS_* says; HSP_NONE without conflict */
  uint32_t second;   /**< likewise */
  uint32_t reserved; /**< 0 */
} hsp_sticks_conflict;

/** Find balls and halves of sticks in painting order for one direction, or, where there is no order, their map; any
 *  number of times. options: the direction, as for hsp_view_compute, NULL for the defaults; its pieces and flags must
 *  be valid and have no effect. stick [count]: may be NULL if count is 0. radius: length, of all sticks other than
 *  double, triple and aromatic bonds. The model must outlive the handle; the handle can be read while the model holds
 *  the same balls (RESULTS in hardsphere.h). conflict may be NULL; it is written on HSP_OK and HSP_E_CONFLICT: on
 *  HSP_OK it tells whether there is an order, and why not. If there are several conflicts the direction decides which
 *  one is named. limits: see LIMITS in hardsphere.h; at most 21 retries. On
 *  failure the handle holds no results.
 *
 *  Cost: O(m log m) for m balls and halves of sticks, and for each of them the number of those that share a vertical
 *  line of the view plane with it; without an order also for each the time to sort those that may cover a part of it.
 *  @retval HSP_E_ARGUMENT    sticks or model is NULL; unknown pieces or flags; stick is NULL and count is not 0; an
 *                            unknown flag, two kinds of bond or a reserved field of a stick that is not 0; an executor
 *                            with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size of options, executor or limits, or reserved of the options is not 0, or
 *                            unused not NULL
 *  @retval HSP_E_CAPACITY    a limit is too small
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  radius or a component of towards or up is NaN or infinite
 *  @retval HSP_E_NEGATIVE    radius is negative
 *  @retval HSP_E_RANGE       radius is 0
 *  @retval HSP_E_CONFLICT    balls and sticks that cannot be painted; see conflict
 *  @retval HSP_E_DEGENERATE  roundings could not be overcome by moving balls six times
 *  @retval HSP_E_STOPPED     the executor of the options said not to go on */
HSP_API int32_t HSP_CALL hsp_sticks_compute(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options,
                                            const hsp_stick *stick, uint32_t count, double radius,
                                            hsp_sticks_conflict *conflict, hsp_sticks_limits *limits);

/** The same as hsp_sticks_compute, but with a map also where there is an order to paint (*conflict tells whether there
 *  is). Pictures then show the visible parts side by side.
 *  - Property 1: hsp_sticks_check finds nothing.
 *
 *  Cost: as for hsp_sticks_compute without an order.
 *  @retval HSP_E_ARGUMENT    sticks or model is NULL; unknown pieces or flags; stick is NULL and count is not 0; an
 *                            unknown flag, two kinds of bond or a reserved field of a stick that is not 0; an executor
 *                            with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size of options, executor or limits, or reserved of the options is not 0, or
 *                            unused not NULL
 *  @retval HSP_E_CAPACITY    a limit is too small
 *  @retval HSP_E_STATE       hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  radius or a component of towards or up is NaN or infinite
 *  @retval HSP_E_NEGATIVE    radius is negative
 *  @retval HSP_E_RANGE       radius is 0
 *  @retval HSP_E_CONFLICT    balls and sticks that cannot be painted; see conflict
 *  @retval HSP_E_DEGENERATE  roundings could not be overcome by moving balls six times
 *  @retval HSP_E_STOPPED     the executor of the options said not to go on */
HSP_API int32_t HSP_CALL hsp_sticks_compute_map(hsp_sticks *sticks, const hsp_model *model,
                                                const hsp_view_options *options, const hsp_stick *stick, uint32_t count,
                                                double radius, hsp_sticks_conflict *conflict,
                                                hsp_sticks_limits *limits);

/** Counts, box and frame of a picture. Frozen. */
typedef struct hsp_sticks_info {
  double origin[3];  /**< the point with view coordinates 0 0 0: the middle of the balls' centres, length */
  double right[3];   /**< unit vector: the x axis of the view coordinates */
  double up[3];      /**< unit vector: the y axis */
  double towards[3]; /**< unit vector: the z axis */
  double low[2];     /**< lower corner of the box of the painted or seen balls in the view plane, length; 0 0 without */
  double high[2];    /**< upper corner of the same box */
  uint32_t paths;    /**< balls and halves of sticks that are painted; without an order, that are seen */
  uint32_t balls;    /**< how many of these are balls */
  uint32_t sticks;   /**< as given */
  uint32_t arcs;     /**< parts of circles, ellipses and lines around all paths */
} hsp_sticks_info;

/** Describe what is painted: the frame, the box and how many records there are.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_sticks_get_info(const hsp_sticks *sticks, hsp_sticks_info *info);

/* ---- the map ----------------------------------------------------------------------------------------------------- */

/* After hsp_sticks_compute_map, and after hsp_sticks_compute where there is no order to paint, there is a map of balls
 * and halves of sticks. Its records are those of map.h, and all that map.h says of vertices, edges and faces holds,
 * with these differences:
 *   balls        are numbers of balls, or of halves of sticks by HSP_STICKS_HALF; a whole stick is its half 0
 *   silhouettes  are also the two lines along each half, ellipses with a second axis of 0
 *   creases      are also the half circles where a stick leaves its balls, and where its halves meet
 *   tangencies   are also where such a half circle continues as one of these lines, or as the silhouette of the nearer
 *                ball; halves in the middle of sticks meet at vertices of their own kind, HSP_MAP_HALVES
 *   faces        of farther balls and halves come first */

/** The number of a half of a stick in a map of `balls` balls: half 0 belongs to its ball[0], half 1 to its ball[1]. */
#define HSP_STICKS_HALF(balls, stick, half) ((balls) + UINT32_C(2) * (stick) + (half))

/** Describe the map; `balls` are balls that are seen, without sticks.
 *  - Property 1: vertices - edges + faces = 1 + components.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_sticks_get_map_info(const hsp_sticks *sticks, hsp_map_info *info);

/** The vertices first .. first + count - 1 of the map, exactly count records; out may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  sticks is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_ID        not all of these vertices are there */
HSP_API int32_t HSP_CALL hsp_sticks_get_vertices(const hsp_sticks *sticks, uint32_t first, uint32_t count,
                                                 hsp_map_vertex *out);

/** The edges first .. first + count - 1 of the map, exactly count records; out may be NULL with count 0.
 *  - Property 1: edges end at their vertices up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  sticks is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_ID        not all of these edges are there */
HSP_API int32_t HSP_CALL hsp_sticks_get_edges(const hsp_sticks *sticks, uint32_t first, uint32_t count,
                                              hsp_map_edge *out);

/** The faces first .. first + count - 1 of the map, exactly count records; out may be NULL with count 0.
 *  - Property 1: the areas of all faces with a ball or half of a stick sum to hsp_map_info.area, up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  sticks is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_ID        not all of these faces are there */
HSP_API int32_t HSP_CALL hsp_sticks_get_faces(const hsp_sticks *sticks, uint32_t first, uint32_t count,
                                              hsp_map_face *out);

/** How much of each ball and then of each half of a stick is seen, by their numbers in the map: areas in the view
 *  plane, length^2; 0 for hidden ones and for the second half of a whole stick.
 *  @retval HSP_E_ARGUMENT  sticks is NULL; area is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, the number of balls and twice that of sticks
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity,
                                              uint32_t *needed);

/** The ball or half of a stick that is seen at (x, y), in view coordinates, its depth and its face: *sight becomes the
 *  record.
 *
 *  Cost: O(balls and sticks), and O(edges around the faces of the ball or half) for the face.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  x or y is NaN or infinite */
HSP_API int32_t HSP_CALL hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight);

/** The visible outline of a ball or half of a stick, by its number in the map: one directed edge of every loop around
 *  its visible parts. hsp_map_edge.next leads around each loop, with the visible part on the left. Directed edge h runs
 *  along edge h / 2 if h is even, against it if h is odd; the face is face[h % 2] of the edge.
 *
 *  Cost: O(loops around its visible parts).
 *  @retval HSP_E_ARGUMENT  sticks is NULL; h is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_ID        no such ball or half of a stick */
HSP_API int32_t HSP_CALL hsp_sticks_get_outline(const hsp_sticks *sticks, uint32_t ball, uint32_t *h, uint32_t capacity,
                                                uint32_t *needed);

/** The point of an edge at parameter t, between hsp_map_edge.from and .to, and the gaps beside it, as hsp_map_get_point
 *  has them.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_ID          no such edge
 *  @retval HSP_E_NOT_FINITE  t is NaN or infinite
 *  @retval HSP_E_RANGE       t is beyond the edge */
HSP_API int32_t HSP_CALL hsp_sticks_get_point(const hsp_sticks *sticks, uint32_t edge, double t, hsp_map_point *point);

/** The pole of inaccessibility of a face, where a label has most room, as hsp_map_get_pole has it.
 *
 *  Cost: O(edges around the face), times the points that are looked at: some hundred for most faces.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_ID        no such face, or the unbounded one */
HSP_API int32_t HSP_CALL hsp_sticks_get_pole(const hsp_sticks *sticks, uint32_t face, hsp_map_pole *pole);

/** Check the invariants of the map, those of hsp_map_check. Works in the handle's memory, hence not const. Cost: O(size
 *  of the map).
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_CHECK     an invariant is violated: please report it */
HSP_API int32_t HSP_CALL hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
