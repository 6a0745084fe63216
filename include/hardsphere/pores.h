/* hardsphere/pores.h: free space for every probe at once: cavities, gates, tunnels, channels of crystals.
 *
 * Guide: pores.md, questions.md, exactness.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * f(x) is the radius of the largest probe that fits at the point x: the least distance of x from a ball, |x - c| - r.
 * The radii r include the probe of the model; p and levels come on top of that probe. A probe of radius p fits at x, or
 * passes there, if p < f(x): balls that touch meet. Free space for this probe is where f > p. As p falls, parts of free
 * space appear and merge:
 *
 *   maximum   where f is largest nearby: four balls are nearest there, or more
 *   gate      where two parts of free space meet, or two ends of one: three balls are nearest there, or more
 *   class     a part of free space from its birth at a maximum to its death at a gate, where it merges into an older
 *             class, one of a wider maximum. So each maximum has a class, and classes are the nodes of a tree. The
 *             outside is a class without a maximum, HSP_PORE_OUTSIDE, older than all others. A class that merges into
 *             no other above the floor is a cavity that nothing reaches
 *   level     the value of f at a maximum or a gate, a radius
 *   floor     the radius of the narrowest probe of interest: maxima and gates below it are not computed
 *
 * Between which balls there is a maximum or a gate, to which maxima the two sides of a gate lead up, and the order of
 * levels are decided in integers, ties included. Points and radii are rounded to doubles; where levels tie these may
 * differ in their last bits. Maxima and gates are numbered from the widest on.
 *
 * In a periodic box each maximum and gate is listed once for all of its copies, and there is no outside. A gate may
 * join a part of free space to a copy of itself: then it is a channel, which goes on for ever in one, two or three
 * directions. */
#ifndef HARDSPHERE_PORES_H
#define HARDSPHERE_PORES_H

#include "model.h"
#include "periodic.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Maxima, gates and the tree of their classes. */
typedef struct hsp_pores hsp_pores;

/** The limits that fix the memory of pores. */
typedef struct hsp_pores_limits {
  uint32_t struct_size; /**< sizeof(hsp_pores_limits) */
  uint32_t balls;       /**< balls of the model; in a box also their images near it */
  uint32_t maxima;      /**< above the floor */
  uint32_t gates;       /**< above the floor */
  uint32_t tied;        /**< balls of maxima with more than four nearest balls, and of gates with more than three */
  uint32_t candidates;  /**< scratch memory of the search, in records */
  uint32_t neighbours;  /**< most balls around a piece of a tunnel */
  uint32_t points;      /**< points of a tunnel, also those left out as they are near to others */
} hsp_pores_limits;

/** Limits that suffice for most molecules of `balls` atoms, about 1.9 kB for each: maxima 2 balls + 64, gates 4 balls +
 *  128, tied balls + 256, candidates 4 balls + 2048, neighbours balls + 16, points balls + 4096.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 2048) / 8 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_pores_limits_init(hsp_pores_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_pores_init needs.
 *  - Property 1: at most HSP_PORES_BYTES of the limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_pores_bytes(const hsp_pores_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_PORES_BYTES(balls, maxima, gates, tied, candidates, neighbours, points)                                 \
  ((size_t)65536 + (size_t)212 * (size_t)(balls) + (size_t)392 * (size_t)(maxima) + (size_t)148 * (size_t)(gates) + \
   (size_t)16 * (size_t)(tied) + (size_t)16 * (size_t)(candidates) + (size_t)168 * (size_t)(neighbours) +           \
   (size_t)144 * (size_t)(points))

/** Make pores without results in caller memory of any alignment; sets *pores.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_pores_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_pores_init(void *memory, size_t bytes, const hsp_pores_limits *limits, hsp_pores **pores);

/** Which part of free space is computed. */
typedef struct hsp_pores_options {
  uint32_t struct_size; /**< sizeof(hsp_pores_options) */
  uint32_t reserved;    /**< 0 */
  double floor; /**< radius of the narrowest probe of interest, length, rounded down to the lattice; may be negative,
                     down to minus the largest radius; above 2^51 lattice steps these; default 0: a gate that not even a
                     point passes is closed */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
  const hsp_pores *before;      /**< or NULL: other pores, of a model of some of these balls, as this model has rounded
                                them, with all radii smaller by one length, or the same. Points that no further ball is
                                near to are copied from there, which saves time and changes no result: for plugs in
                                mouths, or one more atom in a molecule. Of no use for other balls, in a box, or with a
                                floor that is higher by more than that length */
} hsp_pores_options;

/** Fill options with defaults.
 *  @retval HSP_E_ARGUMENT  options is NULL
 *  @retval HSP_E_VERSION   struct_size is bad */
HSP_API int32_t HSP_CALL hsp_pores_options_init(hsp_pores_options *options, uint32_t struct_size);

/** Find all maxima and gates of a model above the floor, and the tree of their classes; options may be NULL. The model
 *  must outlive the pores; the pores can be read while the model holds the same balls (RESULTS in hardsphere.h). On
 *  failure the pores hold no results. limits: see LIMITS in hardsphere.h; at most forty retries. On HSP_OK
 *  limits->points becomes 0: how many points are needed depends on the tunnel.
 *  - Property 1: the order of the balls has no effect but on their numbers, unless balls are equal.
 *
 *  Cost: O(n) for sets as in Theorem 2.1, and O(m log m) for m maxima and gates; balls in one point cost O(n log n). At
 *  a point where k balls tie, O(k log k) questions in integers, and O(k^2) in doubles as a rule. More where k balls tie
 *  up to a fraction of a lattice step along a whole line, as in a tube of rings that is some lattice steps wide, or in
 *  a crown that is some steps high with another ball on its axis.
 *  @retval HSP_E_ARGUMENT    pores or model is NULL; options->before is pores; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size of options, executor or limits, or options->reserved is not 0
 *  @retval HSP_E_CAPACITY    a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE       hsp_model_set has failed; or options->before holds no results, or their model has changed
 *  @retval HSP_E_NOT_FINITE  options->floor is a NaN or an infinity
 *  @retval HSP_E_RANGE       a way up between balls leads to probes of 2^50 lattice steps: set the model with a larger
 *                            step, at least ten times hsp_model_info.step
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it
 *  @retval HSP_E_STOPPED     the executor of the options said not to go on */
HSP_API int32_t HSP_CALL hsp_pores_compute(hsp_pores *pores, const hsp_model *model, const hsp_pores_options *options,
                                           hsp_pores_limits *limits);

/** The same as hsp_pores_compute, for the balls in a periodic box. The box must outlive the pores; they can be read
 *  until it computes other balls or another box. Default limits for its balls suffice for boxes that are much larger
 *  than their pores; else images need more. Points are given and come back in the caller's frame, also where the
 *  library turns the box (periodic.h). In a turned box images lie up to a lattice step beside their places. So balls
 *  that would tie or touch exactly may not do so: one point may become several points some steps apart, and a gate of
 *  radius 0 may open or close. This may differ between two sets of vectors for the same crystal.
 *  - Property 1: which image of a ball is given, which upright vectors are given for the same copies, and the order of
 *    the balls have no effect but on numbers of balls, on points and shifts, and on the order of maxima or gates of
 *    equal width.
 *  - Property 2: an upright box of m copies has m times each maximum and gate, of the same radii bit for bit, if these
 *    are not a hundred times the largest ball's.
 *
 *  Cost: that of hsp_pores_compute for balls and images.
 *  @retval HSP_E_ARGUMENT    pores or periodic is NULL; options->before is pores; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size of options, executor or limits, or options->reserved is not 0
 *  @retval HSP_E_CAPACITY    a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE       the box holds no results, or areas alone; or options->before holds none
 *  @retval HSP_E_NOT_FINITE  options->floor is a NaN or an infinity
 *  @retval HSP_E_RANGE       the box is more than a hundred times longer than wide, or a way leads farther than 511
 *                            boxes
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it
 *  @retval HSP_E_STOPPED     the executor of the options said not to go on */
HSP_API int32_t HSP_CALL hsp_pores_compute_periodic(hsp_pores *pores, const hsp_periodic *periodic,
                                                    const hsp_pores_options *options, hsp_pores_limits *limits);

/** How many of everything. Frozen. */
typedef struct hsp_pores_counts {
  uint32_t maxima;      /**< above the floor: as many as classes other than the outside */
  uint32_t gates;       /**< above the floor */
  uint32_t merges;      /**< gates where two classes merge; the others close a ring of free space */
  uint32_t cavities;    /**< classes that merge into no other: maxima - merges; in a box channels, too */
  uint32_t outer_balls; /**< balls that are not inside another one */
  uint32_t reserved;    /**< 0 */
} hsp_pores_counts;

/** How many maxima, gates and cavities there are.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_counts(const hsp_pores *pores, hsp_pores_counts *counts);

#define HSP_PORE_OUTSIDE UINT32_C(0xFFFFFFFE) /**< the outside, in place of the number of a maximum */

/** A maximum and its class. Frozen. */
typedef struct hsp_pore_maximum {
  double xyz[3];    /**< the centre of the largest probe there */
  double radius;    /**< radius of this probe, length: the birth of the class */
  double death;     /**< radius at the gate where the class merges; the floor if there is none */
  uint32_t ball[4]; /**< balls that it is between; if more are nearest, the first of them by position */
  uint32_t gate;    /**< gate where the class merges into an older one; HSP_NONE if nothing reaches it */
  uint32_t parent;  /**< the maximum of that older class, HSP_PORE_OUTSIDE, or HSP_NONE */
} hsp_pore_maximum;

/** The maxima first .. first + count - 1, exactly count records, of hsp_pores_counts.maxima in all, the widest first;
 *  out may be NULL with count 0.
 *  - Property 1: radius >= death. Before they are rounded to doubles the birth is above the death. The parent has a
 *    lower number.
 *
 *  @retval HSP_E_ARGUMENT  pores is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these maxima are there */
HSP_API int32_t HSP_CALL hsp_pores_get_maxima(const hsp_pores *pores, uint32_t first, uint32_t count,
                                              hsp_pore_maximum *out);

/** A gate. Frozen. */
typedef struct hsp_pore_gate {
  double xyz[3];    /**< the centre of the widest probe that gets there */
  double radius;    /**< radius of this probe, length; narrower probes pass */
  uint32_t ball[3]; /**< balls that it is between; if more are nearest, the first of them by position */
  uint32_t end[2];  /**< maxima to which its two sides lead up, or HSP_PORE_OUTSIDE; the first on the side from which
                         its three balls are in counter-clockwise order */
  uint32_t merges;  /**< 1 if two classes merge here, 0 if both sides are of one class */
} hsp_pore_gate;

/** The gates first .. first + count - 1, exactly count records, of hsp_pores_counts.gates in all, the widest first; out
 *  may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  pores is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these gates are there */
HSP_API int32_t HSP_CALL hsp_pores_get_gates(const hsp_pores *pores, uint32_t first, uint32_t count,
                                             hsp_pore_gate *out);

/** How the sides of a gate lie in a periodic box, and in how many directions the gate opens a channel. Shifts are
 *  multiples of the vectors of the box; without a box all is 0. Frozen. */
typedef struct hsp_pore_gate_shifts {
  int32_t ball[9];     /**< three for each of its balls: the ball is moved by them from where it was given */
  int32_t end[6];      /**< three for each of its ends: the maximum is moved by them from its point */
  uint32_t winds;      /**< 1 if through it its class reaches a direction or a copy for the first time, else 0 */
  uint32_t directions; /**< 0 to 3: in how many independent directions its class goes on for ever for narrower probes */
} hsp_pore_gate_shifts;

/** The shifts of the gates first .. first + count - 1, exactly count records; out may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  pores is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these gates are there */
HSP_API int32_t HSP_CALL hsp_pores_get_gate_shifts(const hsp_pores *pores, uint32_t first, uint32_t count,
                                                   hsp_pore_gate_shifts *out);

/** All balls that are nearest at a maximum, in ascending order; in a box once for each image that is.
 *  - Property 1: exact: all of these touch the largest probe, and no others.
 *
 *  @retval HSP_E_ARGUMENT  pores is NULL; balls is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such maximum */
HSP_API int32_t HSP_CALL hsp_pores_get_maximum_balls(const hsp_pores *pores, uint32_t maximum, uint32_t *balls,
                                                     uint32_t capacity, uint32_t *needed);

/** All balls that are nearest at a gate, in ascending order; in a box once for each image that is.
 *  @retval HSP_E_ARGUMENT  pores is NULL; balls is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such gate */
HSP_API int32_t HSP_CALL hsp_pores_get_gate_balls(const hsp_pores *pores, uint32_t gate, uint32_t *balls,
                                                  uint32_t capacity, uint32_t *needed);

/** All images of balls that are nearest at a maximum, ascending in balls and shifts; without a box shifts are 0.
 *  @retval HSP_E_ARGUMENT  pores is NULL; images is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such maximum */
HSP_API int32_t HSP_CALL hsp_pores_get_maximum_images(const hsp_pores *pores, uint32_t maximum, hsp_image *images,
                                                      uint32_t capacity, uint32_t *needed);

/** All images of balls that are nearest at a gate, ascending in balls and shifts; without a box shifts are 0.
 *  @retval HSP_E_ARGUMENT  pores is NULL; images is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such gate */
HSP_API int32_t HSP_CALL hsp_pores_get_gate_images(const hsp_pores *pores, uint32_t gate, hsp_image *images,
                                                   uint32_t capacity, uint32_t *needed);

/** How wide a probe can be to go on through a periodic box for ever. Without a box no probe does. Frozen. */
typedef struct hsp_pore_percolation {
  double largest;     /**< radius of the widest probe that fits anywhere; the floor if none above it does */
  double through[3];  /**< narrower probes go on for ever in one, two and three independent directions; the floor if no
                           probe above it does */
  double included[3]; /**< radius of the widest probe that fits in that channel; the floor likewise */
  double along[3];    /**< narrower probes reach a copy of their place that differs by a multiple other than 0 of the
                           first, the second and the third vector of the box; the floor likewise */
  uint32_t gate[3];   /**< gate that stops probes wider than `through`; HSP_NONE if none above the floor gets through */
  uint32_t maximum[3];    /**< the widest maximum of that channel, HSP_NONE likewise */
  uint32_t gate_along[3]; /**< gate that stops probes wider than `along`, HSP_NONE likewise */
  uint32_t reserved;      /**< 0 */
} hsp_pore_percolation;

/** The widest probes that get through a box; *percolation becomes the record. For frameworks twice `largest` is the
 *  largest cavity diameter, twice through[0] the pore-limiting diameter, and twice included[0] the diameter of the
 *  largest cavity along the path.
 *  - Property 1: through[0] >= through[1] >= through[2], and through[0] is the largest of `along`; up to the last bits
 *    where gates tie, as their radii may be rounded differently.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_percolation(const hsp_pores *pores, hsp_pore_percolation *percolation);

/** A part of free space for one probe, and where it leads. Frozen. */
typedef struct hsp_pore_channel {
  double radius;       /**< of the widest probe that fits in it */
  uint32_t maximum;    /**< where this probe fits: its oldest maximum */
  uint32_t maxima;     /**< how many maxima are in it */
  uint32_t directions; /**< as in hsp_winding: 0 to 3; 0: a cavity that ends on all sides */
  uint32_t copies;     /**< as in hsp_winding */
  int32_t row[9];      /**< as in hsp_winding */
  uint32_t reserved;   /**< 0 */
} hsp_pore_channel;

/** All parts of free space for a probe of this radius, without the outside, the part with the widest maximum first.
 *  Uses memory of the handle, hence not const.
 *  - Property 1: in a box at least one of them has more than k directions if the radius is below through[k] of
 *    hsp_pore_percolation, else none has.
 *
 *  Cost: O(maxima + gates), times the inverse Ackermann function of a union-find structure.
 *  @retval HSP_E_ARGUMENT    pores is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  radius is a NaN or an infinity
 *  @retval HSP_E_RANGE       radius is below the floor, or above 2^51 lattice steps */
HSP_API int32_t HSP_CALL hsp_pores_get_channels(hsp_pores *pores, double radius, hsp_pore_channel *out,
                                                uint32_t capacity, uint32_t *needed);

/** The part of free space that a maximum is in for a probe of this radius: *member becomes the oldest maximum of that
 *  part, or HSP_PORE_OUTSIDE; HSP_NONE if the probe does not fit at the maximum. `maximum` may be HSP_PORE_OUTSIDE. Two
 *  maxima are in one part exactly if *member is the same for both and not HSP_NONE.
 *
 *  Cost: O(depth of the tree).
 *  @retval HSP_E_ARGUMENT    pores or member is NULL
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_ID          there is no such maximum
 *  @retval HSP_E_NOT_FINITE  radius is a NaN or an infinity
 *  @retval HSP_E_RANGE       radius is below the floor, or above 2^51 lattice steps */
HSP_API int32_t HSP_CALL hsp_pores_class_at(const hsp_pores *pores, uint32_t maximum, double radius, uint32_t *member);

/** The gate where the classes of two maxima merge; either maximum may be HSP_PORE_OUTSIDE. *gate becomes the tightest
 *  gate of the widest path between the two: exactly the probes narrower than this gate get from one to the other. It
 *  becomes HSP_NONE if the classes do not merge above the floor, or the two maxima are the same. In a box the path may
 *  lead to any copy of the second one.
 *
 *  Cost: O(depth of the tree).
 *  @retval HSP_E_ARGUMENT  pores or gate is NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such maximum */
HSP_API int32_t HSP_CALL hsp_pores_gate_between(const hsp_pores *pores, uint32_t maximum, uint32_t other,
                                                uint32_t *gate);

/** Where a point is. Frozen. */
typedef struct hsp_pore_place {
  double radius;    /**< of the largest probe there, length; below 0 in a ball, infinite without balls */
  uint32_t ball;    /**< a nearest ball; HSP_NONE without balls */
  uint32_t maximum; /**< that a way up leads to, HSP_PORE_OUTSIDE, or HSP_NONE if radius is not above the floor */
} hsp_pore_place;

/** Where the point xyz [3] is, rounded to the lattice: *place becomes the record. A way up follows growing f from the
 *  point to a maximum. With the floor 0 it is exact whether the point is in a ball. In a periodic box the point may lie
 *  in any copy of the box, and place->maximum is HSP_PORE_OUTSIDE only without balls.
 *  - Property 1: for any probe that is narrower than place->radius by at least a lattice step the point is in the same
 *    part of free space as the maximum. Several maxima of that part may satisfy this; place->maximum is one of them.
 *
 *  Cost: O(n + maxima + gates), most of it for comparing places.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  xyz holds a NaN or an infinity
 *  @retval HSP_E_RANGE       xyz lies beyond 2^50 lattice steps, or more than 2^17 boxes away; or a way up is lost
 *                            between balls that are more than 2^35 lattice steps apart
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_locate(const hsp_pores *pores, const double *xyz, hsp_pore_place *place);

/** Which copies of its ball and its maximum a place is beside, in a periodic box. Without a box, and for a ball or
 *  maximum that is HSP_NONE or HSP_PORE_OUTSIDE, the shifts are 0. Frozen. */
typedef struct hsp_pore_place_shifts {
  int32_t ball[3];    /**< the ball is moved by it from where it was given */
  int32_t maximum[3]; /**< the maximum is moved by it from its point */
} hsp_pore_place_shifts;

/** The same as hsp_pores_locate, with the copies of the ball and of the maximum: *shifts becomes their record, too.
 *  - Property 1: if the point is moved by vectors of the box the same multiples are added to the shifts, unless another
 *    of several possible maxima is found.
 *
 *  Cost: that of hsp_pores_locate.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  xyz holds a NaN or an infinity
 *  @retval HSP_E_RANGE       xyz lies beyond 2^50 lattice steps, or more than 2^17 boxes away; or a way up is lost
 *                            between balls that are more than 2^35 lattice steps apart
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_locate_with_shifts(const hsp_pores *pores, const double *xyz, hsp_pore_place *place,
                                                      hsp_pore_place_shifts *shifts);

/** The widest probe between two points. Frozen. */
typedef struct hsp_pore_passage {
  double radius;     /**< wider probes do not get through; 0 if none above the floor does, infinite without balls */
  uint32_t passes;   /**< whether any probe above the floor gets through: 1 or 0 */
  uint32_t gate;     /**< gate that stops wider ones; HSP_NONE if an end stops them, or if none passes */
  uint32_t ball;     /**< ball that stops wider ones at an end; HSP_NONE if a gate stops them, or if none passes */
  uint32_t at[2];    /**< the maxima of the two points as hsp_pores_locate says; with `to` NULL the second is the
                          outside, in a box the first maximum again */
  uint32_t reserved; /**< 0 */
} hsp_pore_passage;

/** The widest probe that gets from one point to another, from [3] and to [3], or to the outside if `to` is NULL. The
 *  points are rounded to the lattice. In a periodic box the probe may get to any copy of `to`. As there is no outside
 *  in a box, `to` NULL means another copy of `from`: the probe goes on for ever. A box without balls is treated as no
 *  box.
 *  - Property 1: a probe narrower than passage->radius by one lattice step has a path between the two points, as
 *    hsp_paths_find finds it; a probe wider by one lattice step has none.
 *  - Property 2: in a box, with `to` NULL, passage->radius is at most through[0] of hsp_pore_percolation, and equals it
 *    for at least one maximum as `from`.
 *
 *  Cost: that of hsp_pores_locate, twice.
 *  @retval HSP_E_ARGUMENT    pores, from or passage is NULL
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  a point holds a NaN or an infinity
 *  @retval HSP_E_RANGE       a point lies beyond 2^50 lattice steps, or more than 2^17 boxes away; or a way up is lost
 *                            between balls that are more than 2^35 lattice steps apart
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_widest(const hsp_pores *pores, const double *from, const double *to,
                                          hsp_pore_passage *passage);

/** A tunnel. Frozen. */
typedef struct hsp_tunnel {
  double radius;     /**< of the widest probe that gets through; 0 if there is no tunnel, infinite without balls */
  double length;     /**< of the polyline through its points; 0 if there is no tunnel */
  uint32_t there;    /**< whether there is a tunnel: 1 or 0 */
  uint32_t gate;     /**< its tightest gate; HSP_NONE if it passes none */
  uint32_t gates;    /**< how many gates it passes */
  uint32_t points;   /**< of the polyline; 0 if there is no tunnel */
  uint32_t outside;  /**< whether it leads to or through the outside: 1 or 0; always 0 in a box with balls. If it comes
                          back from the outside one segment of the polyline leaps across it */
  uint32_t reserved; /**< 0 */
} hsp_tunnel;

/** Find the widest tunnel from one point to another, or to the outside, that uses none of the gates to be avoided. To
 *  find the next best tunnel with another bottleneck avoid the tightest gates of the tunnels found before. The tunnel
 *  leads through maxima and gates, and each part of it is as wide as any path between the ends of that part; of gates
 *  of equal width it takes the one that is nearer to its start along straight lines. Its points stay until the next
 *  call; on failure there are none. Any probe narrower than the tunnel gets from one point to the other along it.
 *
 *  In a periodic box the tunnel leads to the best copy of `to`. As there is no outside in a box, `to` NULL means
 *  another copy of `from`, from where the tunnel repeats for ever. hsp_pores_get_tunnel_route tells which copy. The
 *  points of the tunnel run through the copies without a break, from where `from` was given. A box without balls is
 *  treated as no box.
 *  - Property 1: without avoided gates its radius is that of hsp_pores_widest.
 *  - Property 2: the largest probe at a gate is narrower than at the points next to it.
 *
 *  @param[in,out] pores  their last tunnel is replaced
 *  @param[in] from       [3]
 *  @param[in] to         [3], or NULL: the outside, in a box another copy of `from`
 *  @param[in] avoided    [count], or NULL with count = 0: ids of gates
 *  @param[in] count      of avoided gates
 *  @param[out] tunnel    the tunnel, or that there is none
 *  @param[out] limits    or NULL: what was needed for pores and the tunnel, or limits to retry with, for new pores; its
 *                        struct_size has to be set
 *
 *  Cost: O((maxima + gates) log maxima + gates count), and that of hsp_pores_locate.
 *  @retval HSP_E_ARGUMENT    pores, from or tunnel is NULL; avoided is NULL with a count above 0
 *  @retval HSP_E_VERSION     bad struct_size of limits
 *  @retval HSP_E_CAPACITY    limits.points or limits.neighbours is too small; the pores keep their results
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_ID          an avoided gate is not there
 *  @retval HSP_E_NOT_FINITE  a point holds a NaN or an infinity
 *  @retval HSP_E_RANGE       a point lies beyond 2^50 lattice steps, or more than 2^17 boxes away, or the tunnel leads
 *                            so far; or a way up is lost between balls that are more than 2^35 lattice steps apart
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_find_tunnel(hsp_pores *pores, const double *from, const double *to,
                                               const uint32_t *avoided, uint32_t count, hsp_tunnel *tunnel,
                                               hsp_pores_limits *limits);

/** The same as hsp_pores_find_tunnel, for the tunnel of the least cost, which weighs width against length. Between the
 *  maxima of its ends, a straight line from a maximum to a gate beside it, or back, costs its length divided by the
 *  product of the radii at both: the integral of 1/r^2 along it, if r changes linearly. The way from a gate to the
 *  outside costs nothing. Gates of radius 0 or less are not passed. If several tunnels have the least cost it is one of
 *  them.
 *  - Property 1: its cost is no higher than that of hsp_pores_find_tunnel with the same arguments.
 *
 *  Cost: that of hsp_pores_find_tunnel.
 *  @param[in,out] pores  their last tunnel is replaced
 *  @param[in] from       [3]
 *  @param[in] to         [3], or NULL: the outside, in a box another copy of `from`
 *  @param[in] avoided    [count], or NULL with count = 0: ids of gates
 *  @param[in] count      of avoided gates
 *  @param[out] tunnel    the tunnel, or that there is none
 *  @param[out] limits    or NULL: as of hsp_pores_find_tunnel
 *  @retval HSP_E_ARGUMENT    pores, from or tunnel is NULL; avoided is NULL with a count above 0
 *  @retval HSP_E_VERSION     bad struct_size of limits
 *  @retval HSP_E_CAPACITY    limits.points or limits.neighbours is too small; the pores keep their results
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_ID          an avoided gate is not there
 *  @retval HSP_E_NOT_FINITE  a point holds a NaN or an infinity
 *  @retval HSP_E_RANGE       a point lies beyond 2^50 lattice steps, or more than 2^17 boxes away, or the tunnel leads
 *                            so far; or a way up is lost between balls that are more than 2^35 lattice steps apart
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_find_cheapest_tunnel(hsp_pores *pores, const double *from, const double *to,
                                                        const uint32_t *avoided, uint32_t count, hsp_tunnel *tunnel,
                                                        hsp_pores_limits *limits);

/** Which tunnel is found, and how. Zero means default in every field but the first. */
typedef struct hsp_tunnel_request {
  uint32_t struct_size;         /**< sizeof(hsp_tunnel_request) */
  uint32_t cheapest;            /**< 1: that of hsp_pores_find_cheapest_tunnel; 0: that of hsp_pores_find_tunnel */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_tunnel_request;

/** The same as hsp_pores_find_tunnel or hsp_pores_find_cheapest_tunnel, with an executor that may stop it; request may
 *  be NULL: all defaults. Where it is stopped there is no tunnel.
 *  @retval HSP_E_ARGUMENT    pores, from or tunnel is NULL; avoided is NULL with a count above 0; cheapest is neither 0
 *                            nor 1; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size of request, executor or limits
 *  @retval HSP_E_CAPACITY    as hsp_pores_find_tunnel
 *  @retval HSP_E_STATE       as hsp_pores_find_tunnel
 *  @retval HSP_E_ID          as hsp_pores_find_tunnel
 *  @retval HSP_E_CHECK       as hsp_pores_find_tunnel
 *  @retval HSP_E_NOT_FINITE  as hsp_pores_find_tunnel
 *  @retval HSP_E_RANGE       as hsp_pores_find_tunnel
 *  @retval HSP_E_STOPPED     the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_pores_find_tunnel_with(hsp_pores *pores, const double *from, const double *to,
                                                    const uint32_t *avoided, uint32_t count,
                                                    const hsp_tunnel_request *request, hsp_tunnel *tunnel,
                                                    hsp_pores_limits *limits);

/** The cost of a tunnel, and the copy of its end to which it leads. Frozen. */
typedef struct hsp_tunnel_route {
  double cost;       /**< as of hsp_pores_find_cheapest_tunnel, for both kinds, in 1/length; 0 without gates, infinite
                          through a gate that is no wider than 0 */
  int32_t shift[3];  /**< multiples of the box vectors by which `to`, or `from` if `to` was NULL, is moved to where the
                          tunnel ends; 0 without a box */
  uint32_t reserved; /**< 0 */
} hsp_tunnel_route;

/** The cost of the last tunnel and the copy to which it leads: *route becomes the record, all 0 if there was no tunnel.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_tunnel_route(const hsp_pores *pores, hsp_tunnel_route *route);

/** A point of a tunnel. Frozen. */
typedef struct hsp_tunnel_point {
  double xyz[3];    /**< position, length */
  double radius;    /**< of the largest probe there, length */
  uint32_t ball[4]; /**< nearest balls, then HSP_NONE: four at a maximum, three at a gate, else one to three */
  uint32_t gate;    /**< the gate that it is, or HSP_NONE */
  uint32_t maximum; /**< the maximum that it is, or HSP_NONE */
} hsp_tunnel_point;

/** The points [needed] of the last tunnel, from its start to its end; none if there was no tunnel. Between two
 *  consecutive points the tunnel follows a curve equally far from two or three balls, or a straight line away from one
 *  ball, or two such pieces where one is short. A point that is nearer to the one before than 1/256 of its radius is a
 *  gate, a maximum or an end. An end within two lattice steps of a maximum or gate has the record of that maximum or
 *  gate, but its own position.
 *  - Property 1: two consecutive points are no farther apart than a tenth of the distance of either from the centre of
 *    a ball that is nearest to both (to either, if none is nearest to both), or than 40 lattice steps. Exceptions are a
 *    segment through the outside, and parts of curves that doubles do not resolve to 64 lattice steps, which have no
 *    points. Otherwise, if a ball is nearest to both, the radius halfway between them is no more than the mean of their
 *    radii, and less than 1/800 of that distance below it, up to some lattice steps.
 *
 *  @retval HSP_E_ARGUMENT  pores is NULL; points is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_tunnel_points(const hsp_pores *pores, hsp_tunnel_point *points,
                                                     uint32_t capacity, uint32_t *needed);

/** Which copies of its balls, gate or maximum a point of a tunnel is beside, in a periodic box; without a box all is 0.
 *  Frozen. */
typedef struct hsp_tunnel_point_shifts {
  int32_t ball[12]; /**< three for each of its balls: the ball is moved by them from where it was given */
  int32_t at[3];    /**< the gate or maximum is moved by it from its point; 0 at other points */
} hsp_tunnel_point_shifts;

/** The shifts of the points [needed] of the last tunnel, in the same order.
 *  @retval HSP_E_ARGUMENT  pores is NULL; points is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_tunnel_point_shifts(const hsp_pores *pores, hsp_tunnel_point_shifts *points,
                                                           uint32_t capacity, uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
