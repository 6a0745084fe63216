/* hardsphere/sticks.h: balls and sticks as a picture, with hidden parts removed, and as a visibility map.
 *
 * Guide: gallery.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * A stick is a solid cylinder between the centres of two balls. View coordinates are those of view.h: x to the right, y
 * up, z towards the viewer. A picture has balls, without what of them is inside sticks, and halves of sticks: the
 * part of a stick that is outside its two balls is cut in the middle, and each half belongs to its ball, whose colour
 * it has. They are painted one over the other; whatever covers a part of something comes later. This order is not a
 * sort by depth, which is wrong for sticks: it follows from all pairs of which one covers a part of the other.
 *
 * There is no such order where balls meet, or where balls and sticks cover each other around a circle, like the flaps
 * of a carton. Then what is seen of each is found instead, as for a visibility map: no two paths overlap, and each line
 * between them is drawn once. That is a visibility map of balls and halves of sticks, which can also be had where there
 * is an order, and read. Like a map of balls it rests on floating-point roots and labels that hold it together; where
 * roundings decide differently about the same thing, all balls are moved by less than 2^-13 of their radii.
 *
 * Sticks meet nothing outside the balls at their ends:
 *   a stick         is thinner than both its balls, and meets no other ball and no other stick
 *   two sticks      that end in one ball do not meet outside of it: its radius is at least that of either one divided
 *                   by the sine of half the angle between them; at 60 degrees twice that of the thicker
 * All of this is checked. A rule that fails is named, and there is no picture then, rather than a wrong one. A stick
 * between balls that meet may be inside them; then nothing is asked of it. Roundings of about 2^-50 of all lengths
 * decide where it holds or fails by less than that. */
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
  uint32_t pairs;       /**< of balls and halves of sticks of which one may cover a part of the other; two if they
                                are balls that meet */
  uint32_t edges;       /**< of the map, where there is one */
} hsp_sticks_limits;

/** Limits that suffice for most molecules of `balls` atoms of which the balls do not meet: sticks 2 balls, pairs
 *  64 balls + 64, edges 0.
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

/** A stick that is not cut in two: all of it belongs to ball[0]. For halves of the same colour, which else have a line
 *  between them. */
#define HSP_STICK_WHOLE UINT32_C(1)

/** The kind of bond that a stick is, one of these at most. Pictures that are painted in an order show it as strands,
 *  parts of the stick side by side that face the viewer, with what is behind it seen between them: two of them, three,
 *  or two of which the right one, on the way from ball[0] to ball[1], is dashed. Such a stick is half as thick again as
 *  others. In all else, rules, order and map, it is one stick of that thickness; pictures of what is seen of each, side
 *  by side, have lines where strands begin and end on it. */
#define HSP_STICK_DOUBLE UINT32_C(2)
#define HSP_STICK_TRIPLE UINT32_C(4)   /**< three strands */
#define HSP_STICK_AROMATIC UINT32_C(8) /**< two, one of them dashed */

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
  UINT32_C(8) /**< a stick of a circle of balls and halves of sticks, each of which covers
                                                  a part of the next; and how many they are: no
                                                  order, but HSP_OK */

/** Why there is no picture, or no order in which to paint it. Frozen. */
typedef struct hsp_sticks_conflict {
  uint32_t kind;     /**< HSP_STICKS_* */
  uint32_t first;    /**< a number of a ball or stick as said there; HSP_NONE without conflict */
  uint32_t second;   /**< likewise */
  uint32_t reserved; /**< 0 */
} hsp_sticks_conflict;

/** Find what is painted from one direction; any number of times. options: where to look from, as for hsp_view_compute,
 *  NULL for the defaults; pieces and flags have to be good there and have no effect here. stick [count]: may be NULL
 *  if count is 0. radius: of all sticks that are no bonds of several strands. The model must outlive the handle, which
 *  can be read while the model holds the same balls (RESULTS in hardsphere.h). conflict may be NULL; it is written on
 *  HSP_OK and HSP_E_CONFLICT: on HSP_OK it tells whether there is an order to paint, or why none. Which one of several
 *  conflicts it is depends on the direction. limits: see LIMITS in hardsphere.h; at most 21 retries. On
 *  failure the handle holds no results.
 *
 *  Cost: O(m log m) for m balls and halves of sticks, and for each those that share a vertical line of the view plane
 *  with it; without an order also for each those that may cover a part of it, sorted.
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

/** The same with a map in any case: also where there is an order to paint, which the conflict then tells. Pictures show
 *  what is seen of each, side by side.
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
  double low[2];     /**< of the box of all balls in the view plane, length; 0 0 without balls */
  double high[2];    /**< of the same box */
  uint32_t paths;    /**< balls and halves of sticks that are painted; without an order those that are seen */
  uint32_t balls;    /**< of these */
  uint32_t sticks;   /**< as given */
  uint32_t arcs;     /**< parts of circles, ellipses and lines around all paths */
} hsp_sticks_info;

/** Describe what is painted.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_sticks_get_info(const hsp_sticks *sticks, hsp_sticks_info *info);

/* ---- the map ----------------------------------------------------------------------------------------------------- */

/* After hsp_sticks_compute_map, and after hsp_sticks_compute where there is no order to paint, there is a map of balls
 * and halves of sticks. Its records are those of map.h, and all that is said there of vertices, edges and faces holds,
 * but that
 *   balls        are balls by their numbers and halves of sticks by HSP_STICKS_HALF; a whole stick is its half 0
 *   silhouettes  are also the two lines along each half, ellipses with a second axis of 0
 *   creases      are also the half circles where a stick leaves its balls, and where its halves meet
 *   tangencies   are also where such a half circle goes over into the lines, or into the silhouette of the nearer ball;
 *                halves in the middle of sticks meet at vertices of their own kind, HSP_MAP_HALVES
 *   faces        of what is farther away come first */

/** The number of a half of a stick in a map of so many balls: half 0 is that of its ball[0], half 1 that of ball[1]. */
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
 *  plane, length^2; 0 of what is hidden and of the second half of a whole stick.
 *  @retval HSP_E_ARGUMENT  sticks is NULL; area is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, the number of balls and twice that of sticks
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity,
                                              uint32_t *needed);

/** The ball or half of a stick that is seen at (x, y), in view coordinates, its depth and the face:
 *  *sight becomes that record.
 *
 *  Cost: O(balls and sticks), and O(edges around the faces of what is seen) for the face.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  x or y is NaN or infinite */
HSP_API int32_t HSP_CALL hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight);

/** The visible outline of a ball or half of a stick, by its number in the map: a directed edge of every loop around
 *  what is seen of it. `next` of the edges goes around each, with what is seen on the left. Directed edge h runs along
 *  edge h / 2 if h is even, against it if h is odd; the face is face[h % 2] of the edge.
 *
 *  Cost: O(loops around what is seen of it).
 *  @retval HSP_E_ARGUMENT  sticks is NULL; h is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_ID        no such ball or half of a stick */
HSP_API int32_t HSP_CALL hsp_sticks_get_outline(const hsp_sticks *sticks, uint32_t ball, uint32_t *h, uint32_t capacity,
                                                uint32_t *needed);

/** The point of an edge at parameter t, from `from` to `to` of its hsp_map_edge, and the gaps beside it, as
 *  hsp_map_get_point has them.
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

/** Check the invariants of the map, those of hsp_map_check. sticks may not be used by others meanwhile. Cost: O(size of
 *  the map).
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or an order to paint and no map, or the model has changed since
 *  @retval HSP_E_CHECK     an invariant is violated: please report it */
HSP_API int32_t HSP_CALL hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
