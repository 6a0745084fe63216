/* hardsphere/view.h: hidden surface removal: pieces of balls in the order to paint them (Section 5.1).
 *
 * Guide: gallery.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * A view looks at the balls from infinitely far away. View coordinates: x to the right, y up, z towards the viewer, so
 * that a larger z is nearer; (x, y) is the view plane. Each ball is painted as a piece of its front hemisphere:
 *   HSP_PIECES_OUTSIDE_FARTHER   G-pieces: outside all farther balls (Lemma 5.3)
 *   HSP_PIECES_OUTSIDE_ALL       H-pieces: outside all other balls, the front part of the ball's faces (Theorem 5.1)
 * Of two balls the one whose centre has the smaller z is farther, exactly; if both z are equal, the one that comes
 * first by (x, y, z, radius) in the caller's coordinates. Painting whole pieces from the farthest ball to the nearest
 * shows exactly what is visible. (The paper's theorem says "decreasing z" with viewing direction -z; back to front is
 * increasing z when the viewer is at z = +infinity.) G-pieces have fewer arcs. As a farther ball goes on under a nearer
 * one, no background shows through the seams of anti-aliased pictures.
 *
 *   piece     the painted part of one ball; its loops together are one path, to be filled by either fill rule
 *   loop      a closed boundary of a piece, with the piece on its left: outer loops run counter-clockwise in the view
 *             plane (x right, y up), holes clockwise
 *   view arc  a part of the sphere's own silhouette, which is a circle in the view plane, or of its intersection with
 *             another sphere, which is an ellipse there
 * Silhouettes are cut by the same exact predicates as all circles: the half-space behind the centre is one more plane.
 * Ties are decided as in boundary.h. A ball of radius 0 and a ball inside another one have no piece. */
#ifndef HARDSPHERE_VIEW_H
#define HARDSPHERE_VIEW_H

#include "boundary.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The balls as they are seen from one direction. */
typedef struct hsp_view hsp_view;

/** The limits that fix a view's memory. */
typedef struct hsp_view_limits {
  uint32_t struct_size; /**< sizeof(hsp_view_limits) */
  uint32_t balls;       /**< most balls of the model */
  uint32_t neighbours;  /**< most balls that meet any one ball that is not left out and lies inside no other */
  uint32_t arcs;        /**< arcs of all pieces; pieces and loops are never more */
} hsp_view_limits;

/** Limits that suffice for molecules of `balls` atoms: neighbours min(balls, 256), arcs 12 balls + 64.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 64) / 12 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_view_init needs.
 *  - Property 1: at most HSP_VIEW_BYTES of the three limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_VIEW_BYTES(balls, neighbours, arcs) \
  ((size_t)32768 + (size_t)192 * (size_t)(balls) + (size_t)384 * (size_t)(neighbours) + (size_t)64 * (size_t)(arcs))

/** Make an empty view in caller memory of any alignment; sets *view.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_view_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view);

#define HSP_PIECES_OUTSIDE_FARTHER UINT32_C(0) /**< front hemispheres outside farther balls; needs no boundary */
#define HSP_PIECES_OUTSIDE_ALL UINT32_C(1)     /**< front hemispheres outside all balls; cut from a computed boundary */

/** Also give a piece to balls that are completely hidden behind others. Without this flag most of these balls are left
 *  out, which changes nothing that is seen; G-pieces are then cut by the remaining balls only. */
#define HSP_VIEW_ALL_BALLS UINT32_C(1)

/** From where to look, and what to cut. Zero means default in every field but the first. */
typedef struct hsp_view_options {
  uint32_t struct_size; /**< sizeof(hsp_view_options); hsp_view_options_init sets it */
  uint32_t pieces;      /**< HSP_PIECES_* */
  uint32_t flags;       /**< HSP_VIEW_* */
  uint32_t reserved;    /**< 0 */
  double towards[3];    /**< from the balls towards the viewer, of any length; default 0 0 1 */
  double up[3]; /**< what appears upwards, of any length, not necessarily across towards; default, and if it is parallel
                     to towards: 0 1 0, or 0 0 1 if towards is parallel to that */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
  const void *unused;           /**< NULL */
} hsp_view_options;

/** Fill options with defaults.
 *  @retval HSP_E_ARGUMENT  options is NULL
 *  @retval HSP_E_VERSION   struct_size is bad */
HSP_API int32_t HSP_CALL hsp_view_options_init(hsp_view_options *options, uint32_t struct_size);

/** Set towards and up so that the balls appear turned: by x degrees about the x axis (right), then by y degrees about
 *  the y axis (up), then by z degrees about the z axis (towards the viewer), each counter-clockwise seen from the
 *  axis's positive end. In degrees, so that quarter turns are exact. On failure nothing is written.
 *  @retval HSP_E_ARGUMENT    options is NULL
 *  @retval HSP_E_VERSION     its struct_size is bad
 *  @retval HSP_E_NOT_FINITE  an angle is NaN or infinite
 *  @retval HSP_E_RANGE       an angle is beyond 1e6 */
HSP_API int32_t HSP_CALL hsp_view_options_turn(hsp_view_options *options, double x, double y, double z);

/** Cut and sort the pieces for one direction; any number of times, from any directions. boundary: one computed from the
 *  same model, so that a new direction costs only the cut and the sort. It may be NULL for G-pieces, which then come
 *  from the model alone; with a boundary balls without faces are skipped. options may be NULL (defaults). The model
 *  must outlive the view; the view can be read while the model holds the same balls (RESULTS in hardsphere.h). The
 *  boundary is not needed after the call.
 *  towards is rounded to integers with a largest component of 2^28, so that axes and diagonals are exact.
 *  limits: see LIMITS in hardsphere.h; at most three retries. On failure the view holds no results.
 *  - Property 1: the order of the balls has no effect but on ids.
 *
 *  Cost: O(n) to leave out hidden balls, O(m log m) to sort the m that are left, and for each of these, if k balls meet
 *  it, O(k) for an H-piece and O(k^2) expected for a G-piece.
 *  @retval HSP_E_ARGUMENT    view or model is NULL; unknown pieces or flags; H-pieces without a boundary; a boundary of
 *                            another model; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size of options, executor or limits, or reserved of the options is not 0, or
 *                            unused not NULL
 *  @retval HSP_E_CAPACITY    a limit is too small
 *  @retval HSP_E_STATE       the boundary holds no results, or the model has changed since; hsp_model_set has failed
 *  @retval HSP_E_NOT_FINITE  a component of towards or up is NaN or infinite
 *  @retval HSP_E_STOPPED     the executor of the options said not to go on */
HSP_API int32_t HSP_CALL hsp_view_compute(hsp_view *view, const hsp_model *model, const hsp_boundary *boundary,
                                          const hsp_view_options *options, hsp_view_limits *limits);

/** Counts, box and frame of a view. Frozen. */
typedef struct hsp_view_info {
  double origin[3];  /**< the point with view coordinates 0 0 0: the middle of the balls' centres, length */
  double right[3];   /**< unit vector: the x axis of the view coordinates */
  double up[3];      /**< unit vector: the y axis */
  double towards[3]; /**< unit vector: the z axis */
  double low[2];     /**< lower corner of the box of all pieces' balls in the view plane, length; 0 0 without pieces */
  double high[2];    /**< upper corner of the same box */
  double depth_low;  /**< z of the farthest centre with a piece, length */
  double depth_high; /**< z of the nearest centre with a piece, length */
  uint32_t pieces;   /**< number of pieces */
  uint32_t loops;    /**< of all pieces */
  uint32_t arcs;     /**< of all loops */
  uint32_t kind;     /**< HSP_PIECES_* */
} hsp_view_info;

/** Describe the view: its frame, its box and how many records it has.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_view_get_info(const hsp_view *view, hsp_view_info *info);

/** A piece: the painted part of one ball. Frozen. */
typedef struct hsp_view_piece {
  double centre[2];    /**< of the ball, in the view plane, length */
  double depth;        /**< z of the ball's centre, length; rounded, while the order of the pieces is exact */
  double radius;       /**< of the ball, length */
  uint32_t ball;       /**< the caller's index */
  uint32_t first_loop; /**< its loops are first_loop .. first_loop + loops - 1 */
  uint32_t loops;      /**< at least 1 */
  uint32_t first_arc;  /**< its arcs are first_arc .. first_arc + arcs - 1, loop after loop */
  uint32_t arcs;       /**< at least 1 */
  uint32_t reserved;   /**< 0 */
} hsp_view_piece;

/** The pieces in drawing order, farthest first; pieces without arcs (nothing to draw) are left out.
 *  @retval HSP_E_ARGUMENT  view is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_view_get_pieces(const hsp_view *view, hsp_view_piece *out, uint32_t capacity,
                                             uint32_t *needed);

/** A closed boundary of a piece. Frozen. */
typedef struct hsp_view_loop {
  uint32_t piece;     /**< index in hsp_view_get_pieces */
  uint32_t first_arc; /**< its arcs are first_arc .. first_arc + arcs - 1, each beginning where the one before ends */
  uint32_t arcs;      /**< at least 1: a whole circle or ellipse is one arc */
  uint32_t reserved;  /**< 0 */
} hsp_view_loop;

/** The loops, piece after piece.
 *  @retval HSP_E_ARGUMENT  view is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_view_get_loops(const hsp_view *view, hsp_view_loop *out, uint32_t capacity,
                                            uint32_t *needed);

/** An arc of a circle or ellipse in the view plane: the points
 *      centre + semi_axis[0] cos(t) (cos rotation, sin rotation) + semi_axis[1] sin(t) (-sin rotation, cos rotation)
 *  for t from `from` to `to`; to > from: counter-clockwise, to < from: clockwise. Frozen. */
typedef struct hsp_view_arc {
  double centre[2];    /**< length */
  double semi_axis[2]; /**< the larger and the smaller one, length; the smaller is 0 for a circle seen edge on */
  double rotation;     /**< angle of the larger one from the x axis, in (-pi, pi] */
  double from;         /**< in [-2 pi, 2 pi] */
  double to;           /**< at most 2 pi away from `from`; exactly 2 pi for a whole circle or ellipse */
  double start[2];     /**< the point at `from`, length; it is the end of the arc before, bit for bit */
  double end[2];       /**< the point at `to`, length */
  uint32_t piece;      /**< index in hsp_view_get_pieces */
  uint32_t other_ball; /**< the ball whose sphere it lies on too, the caller's index; HSP_NONE on the silhouette */
} hsp_view_arc;

/** The arcs, loop after loop.
 *  - Property 1: the arcs of a loop are closed: the end of each is the start of the next.
 *  - Property 2: start and end agree with centre, semi-axes, rotation and parameters up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  view is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_view_get_arcs(const hsp_view *view, hsp_view_arc *out, uint32_t capacity,
                                           uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
