/* hardsphere/pores.h: free space for every probe at once: cavities, gates, tunnels, channels of crystals.
 *
 * Guide: pores.md, questions.md, exactness.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * f(x) is the radius of the largest probe that fits at the point x: the least distance of x from a ball, |x - c| - r. A
 * probe is added to the radii of the model, and fits, or passes, if it is narrower than f: what touches meets. Free
 * space for a probe p is where f > p. As p falls, parts of it appear and meet:
 *
 *   maximum   where f is largest nearby: four balls are nearest there, or more
 *   gate      where two parts of free space meet, or two ends of one: three balls are nearest there, or more
 *   class     a part of free space from its birth at a maximum to its death at a gate, where it merges into one that is
 *             older, of a wider maximum. So each maximum is a class, and classes are the nodes of a tree. The outside
 *             is a class without a maximum, HSP_PORE_OUTSIDE, older than all others. A class that meets no other above
 *             the floor is a cavity that nothing reaches
 *   level     the value of f at a maximum or a gate, a radius
 *   floor     the radius of the narrowest probe of interest: what is below it is not looked for
 *
 * Which balls have a maximum or a gate, what its two sides lead up to, and the order of levels are decided in integers,
 * ties included; points and radii are doubles of that, which may differ in their last bits where levels tie. Maxima and
 * gates are numbered from the widest on.
 *
 * In a periodic box each maximum and gate is there once for all of its copies, and nothing is outside. Two ends of one
 * part of free space may be of two copies: then it goes on for ever, in one, two or three directions: a channel. */
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
  uint32_t balls;       /**< of the model; in a box, with images of them that are near it */
  uint32_t maxima;      /**< above the floor */
  uint32_t gates;       /**< above the floor */
  uint32_t tied;        /**< balls of maxima with more than four nearest balls, and of gates with more than three */
  uint32_t candidates;  /**< scratch memory of the search */
  uint32_t neighbours;  /**< balls around a piece of a way */
  uint32_t points;      /**< of a tunnel, with those that are left out as they are near to others */
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
  double floor; /**< radius of the narrowest probe of interest, rounded down to the lattice; may be negative down to
                     where the largest ball has no radius left; default 0: what not even a point passes is closed */
  const hsp_executor *executor; /**< or NULL: whether to go on is asked of it; its threads share nothing yet */
  const hsp_pores *before; /**< or NULL: other pores, of a model of some of these balls as this one has rounded them,
                                which have all grown by one length since. Points in places that no other ball is near to
                                are taken from them, which saves time and changes nothing: as where plugs are put into
                                mouths, or one more atom into a molecule. Of no use if they are of other balls, in a
                                box, or of a floor that is higher by more than that length */
} hsp_pores_options;

/** Default options.
 *  @retval HSP_E_ARGUMENT  options is NULL
 *  @retval HSP_E_VERSION   struct_size is bad */
HSP_API int32_t HSP_CALL hsp_pores_options_init(hsp_pores_options *options, uint32_t struct_size);

/** Find all maxima and gates of a model above the floor, and the tree of their classes; options may be NULL. The model
 *  must outlive them; they can be read while it holds the same balls (RESULTS in hardsphere.h). On failure they hold no
 *  results. limits: see LIMITS in hardsphere.h; at most forty retries. points is 0 in what was needed: that depends on
 *  the tunnel.
 *  - Property 1: the order of the balls has no effect but on their numbers, unless balls are equal.
 *
 *  Cost: O(n) for sets as in Theorem 2.1, and O(m log m) for m maxima and gates; balls in one point cost O(n log n). At
 *  a point where k balls tie, O(k log k) questions in integers, and O(k^2) in doubles as a rule. More where k balls tie
 *  up to a fraction of a lattice step along a whole line, as those of a tube of rings that is some lattice steps wide,
 *  or of a crown that is some steps high with another ball on its axis.
 *  @retval HSP_E_ARGUMENT    pores or model is NULL; options->before is pores; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size of options, executor or limits, or options->reserved is not 0
 *  @retval HSP_E_CAPACITY    a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE       hsp_model_set has failed; or options->before holds no results, or their model has changed
 *  @retval HSP_E_NOT_FINITE  options->floor is a NaN or an infinity
 *  @retval HSP_E_RANGE       a way up between balls leads to probes of 2^50 lattice steps: set the model with a larger
 *                            step, ten times hsp_model_info.step or more
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it
 *  @retval HSP_E_STOPPED     the executor of the options said not to go on */
HSP_API int32_t HSP_CALL hsp_pores_compute(hsp_pores *pores, const hsp_model *model, const hsp_pores_options *options,
                                           hsp_pores_limits *limits);

/** The same of the balls in a periodic box, which must outlive the pores; they can be read until it computes other
 *  balls or another box. Limits for the model's balls suffice for boxes that are much larger than their pores; else
 *  images need more.
 *  Points come and go in the caller's frame, however the box is turned inside.
 *  In a turned box images lie up to a step beside their places. So balls that would tie or touch exactly there may not:
 *  one point may become several some steps apart, and a gate of radius 0 may open or close. Other vectors for the same
 *  crystal may have it otherwise.
 *  - Property 1: which image of a ball is given, which upright vectors for the same box, and the order of the balls
 *    have no effect but on numbers of balls, points and shifts, and on the numbers of what is equally wide.
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
  uint32_t maxima;      /**< above the floor: as many as classes without the outside */
  uint32_t gates;       /**< above the floor */
  uint32_t merges;      /**< gates where two classes meet; the others close a ring of free space */
  uint32_t cavities;    /**< classes that no other reaches: maxima - merges; in a box channels, too */
  uint32_t outer_balls; /**< balls that are not inside another one */
  uint32_t reserved;    /**< 0 */
} hsp_pores_counts;

/** How many maxima, gates and cavities there are.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_counts(const hsp_pores *pores, hsp_pores_counts *counts);

#define HSP_PORE_OUTSIDE UINT32_C(0xFFFFFFFE) /**< the outside, where the number of a maximum may stand */

/** A maximum and its class. Frozen. */
typedef struct hsp_pore_maximum {
  double xyz[3];    /**< the centre of the largest probe there */
  double radius;    /**< of that: the birth of the class */
  double death;     /**< radius at the gate where it merges; the floor if there is none */
  uint32_t ball[4]; /**< balls that it is between, the least of the nearest ones by position; they may be more */
  uint32_t gate;    /**< where the class merges into an older one; HSP_NONE if nothing reaches it */
  uint32_t parent;  /**< the maximum of that older one, HSP_PORE_OUTSIDE, or HSP_NONE */
} hsp_pore_maximum;

/** The maxima first .. first + count - 1, exactly count records, of hsp_pores_counts.maxima in all, the widest first;
 *  out may be NULL with count 0.
 *  - Property 1: radius >= death, as doubles: the levels that they are rounded from are different, the birth above the
 *    death. The parent has a lower number.
 *
 *  @retval HSP_E_ARGUMENT  pores is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these maxima are there */
HSP_API int32_t HSP_CALL hsp_pores_get_maxima(const hsp_pores *pores, uint32_t first, uint32_t count,
                                              hsp_pore_maximum *out);

/** A gate. Frozen. */
typedef struct hsp_pore_gate {
  double xyz[3];    /**< the centre of the widest probe that gets there */
  double radius;    /**< of that; narrower ones pass */
  uint32_t ball[3]; /**< balls that it is between, the least of the nearest ones by position; they may be more */
  uint32_t end[2];  /**< maxima that its two sides lead up to, or HSP_PORE_OUTSIDE; the first on the side from which the
                         three balls turn counter-clockwise */
  uint32_t merges;  /**< whether two classes meet, rather than two ends of one: 1 or 0 */
} hsp_pore_gate;

/** The gates first .. first + count - 1, exactly count records, of hsp_pores_counts.gates in all, the widest first; out
 *  may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  pores is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these gates are there */
HSP_API int32_t HSP_CALL hsp_pores_get_gates(const hsp_pores *pores, uint32_t first, uint32_t count,
                                             hsp_pore_gate *out);

/** How the sides of a gate lie in a periodic box, and what opens there. Shifts are multiples of the vectors of the box;
 *  without a box all is 0. Frozen. */
typedef struct hsp_pore_gate_shifts {
  int32_t ball[9];     /**< three for each of its balls: by that the ball is to be moved from where it was given */
  int32_t end[6];      /**< three for each of its ends: by that the maximum is to be moved from its point */
  uint32_t winds;      /**< whether its class can go on in a direction, or to a copy, as it could not before: 1 or 0 */
  uint32_t directions; /**< 0 to 3: in how many independent directions its class goes on for ever, from here on */
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

/** How wide a probe gets through a periodic box for ever. Without a box no probe does. Frozen. */
typedef struct hsp_pore_percolation {
  double largest;    /**< radius of the widest probe that fits anywhere; the floor if none above it does */
  double through[3]; /**< of the widest one that goes on for ever in one, two and three independent directions: narrower
                           ones do; the floor if none above it does */
  double included[3];  /**< of the widest one that fits in the channel that does so; the floor likewise */
  double along[3];     /**< of the widest one that comes to a copy which lies other than 0 times the first, the second
                           and the third vector of the box away; the floor likewise */
  uint32_t gate[3];    /**< that stops wider ones than `through`; HSP_NONE if none above the floor gets through */
  uint32_t maximum[3]; /**< the widest one of that channel, HSP_NONE likewise */
  uint32_t gate_along[3]; /**< that stops wider ones than `along`, HSP_NONE likewise */
  uint32_t reserved;      /**< 0 */
} hsp_pore_percolation;

/** The widest probes that get through a box; *percolation becomes the record. Twice `largest` is the largest cavity
 *  diameter of frameworks, twice through[0] their pore-limiting diameter, twice included[0] that of the largest cavity
 *  on the way.
 *  - Property 1: through[0] >= through[1] >= through[2], and through[0] is the largest of `along`; up to the last bits
 *    where gates tie, whose radii may be rounded in several ways.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_percolation(const hsp_pores *pores, hsp_pore_percolation *percolation);

/** A part of free space for one probe, and where it leads. Frozen. */
typedef struct hsp_pore_channel {
  double radius;       /**< of the widest probe that fits in it */
  uint32_t maximum;    /**< where that is: its oldest maximum */
  uint32_t maxima;     /**< how many are in it */
  uint32_t directions; /**< as in hsp_winding: 0 to 3; 0: a cavity that ends on all sides */
  uint32_t copies;     /**< as in hsp_winding */
  int32_t row[9];      /**< as in hsp_winding */
  uint32_t reserved;   /**< 0 */
} hsp_pore_channel;

/** All parts of free space for a probe of this radius but the outside, that of the widest maximum first. Uses memory of
 *  the handle.
 *  - Property 1: in a box, for a radius below through[k] of hsp_pore_percolation one of them at least has more than k
 *    directions, for others none.
 *
 *  Cost: O(maxima + gates), up to a factor that hardly grows.
 *  @retval HSP_E_ARGUMENT    pores is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  radius is a NaN or an infinity
 *  @retval HSP_E_RANGE       radius is below the floor, or above 2^51 lattice steps */
HSP_API int32_t HSP_CALL hsp_pores_get_channels(hsp_pores *pores, double radius, hsp_pore_channel *out,
                                                uint32_t capacity, uint32_t *needed);

/** The part of free space that a maximum is in for a probe: *member becomes the oldest maximum of that part, or
 *  HSP_PORE_OUTSIDE; HSP_NONE if the probe does not fit at the maximum. `maximum` may be HSP_PORE_OUTSIDE. Two maxima
 *  are in one part if they have the same class.
 *
 *  Cost: O(depth of the tree).
 *  @retval HSP_E_ARGUMENT    pores or member is NULL
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_ID          there is no such maximum
 *  @retval HSP_E_NOT_FINITE  radius is a NaN or an infinity
 *  @retval HSP_E_RANGE       radius is below the floor, or above 2^51 lattice steps */
HSP_API int32_t HSP_CALL hsp_pores_class_at(const hsp_pores *pores, uint32_t maximum, double radius, uint32_t *member);

/** The gate where the classes of two maxima meet, either of which may be HSP_PORE_OUTSIDE: *gate becomes the tightest
 *  gate of the widest path between them, of which narrower probes get from one to the other. HSP_NONE if they do not
 *  meet above the floor, or are the same. In a box the path may lead to any copy of the second one.
 *
 *  Cost: O(depth of the tree).
 *  @retval HSP_E_ARGUMENT  pores or gate is NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such maximum */
HSP_API int32_t HSP_CALL hsp_pores_gate_between(const hsp_pores *pores, uint32_t maximum, uint32_t other,
                                                uint32_t *gate);

/** Where a point is. Frozen. */
typedef struct hsp_pore_place {
  double radius;    /**< of the largest probe there; below 0 in a ball, infinite without balls */
  uint32_t ball;    /**< a nearest one; HSP_NONE without balls */
  uint32_t maximum; /**< that a way up leads to, or HSP_PORE_OUTSIDE; HSP_NONE if the radius is not above the floor */
} hsp_pore_place;

/** Where the point xyz [3] is, rounded to the lattice: *place becomes its record. With the floor 0 whether it is
 *  in a ball is exact. In a periodic box it may lie in any copy of it, and HSP_PORE_OUTSIDE is the answer only without
 *  balls.
 *  - Property 1: for any probe that is narrower than radius by a lattice step, the point is in the same part of free
 *    space as the maximum. Which maximum of that part it is, is one of several answers.
 *
 *  Cost: O(n + maxima + gates), most of it for comparing places.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  xyz holds a NaN or an infinity
 *  @retval HSP_E_RANGE       xyz lies beyond 2^50 lattice steps, or more than 2^17 boxes away; or a way up is lost
 *                            between balls that are more than 2^35 lattice steps apart
 *  @retval HSP_E_CHECK       a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_locate(const hsp_pores *pores, const double *xyz, hsp_pore_place *place);

/** Which copies a place is beside, in a periodic box; without one, and where there is neither ball nor maximum, all is
 *  0. Frozen. */
typedef struct hsp_pore_place_shifts {
  int32_t ball[3];    /**< by that the ball is to be moved from where it was given */
  int32_t maximum[3]; /**< by that the maximum is to be moved from its point */
} hsp_pore_place_shifts;

/** The same, with the copies of the ball and of the maximum: *shifts becomes their record, too.
 *  - Property 1: at a point moved by vectors of the box the shifts are so much larger, but for one of several answers.
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
  double radius;     /**< wider ones do not get through; 0 if none above the floor does, infinite without balls */
  uint32_t passes;   /**< whether any above the floor does: 1 or 0 */
  uint32_t gate;     /**< that stops wider ones; HSP_NONE if that is an end, or if none passes */
  uint32_t ball;     /**< that stops wider ones at an end; HSP_NONE if that is a gate, or if none passes */
  uint32_t at[2];    /**< the maxima above the two points as hsp_pores_locate says; with `to` NULL the outside, in a
                          box the first one again */
  uint32_t reserved; /**< 0 */
} hsp_pore_passage;

/** The widest probe that gets from one point to another, from [3] and to [3], or to the outside if `to` is NULL. The
 *  points are rounded to the lattice. In a periodic box it may get to any copy of `to`; and as nothing is outside
 *  there, `to` NULL is another copy of `from`: the probe goes on for ever. Without balls that is as without a box.
 *  - Property 1: a probe narrower by one lattice step has a path between the two points, as hsp_paths_find finds it,
 *    and one wider by one has none.
 *  - Property 2: in a box, with `to` NULL, it is at most through[0] of hsp_pore_percolation, and that at one of the
 *    maxima at least.
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
  uint32_t gate;     /**< its tightest one; HSP_NONE if it passes none */
  uint32_t gates;    /**< how many it passes */
  uint32_t points;   /**< of the polyline; 0 if there is no tunnel */
  uint32_t outside;  /**< whether it comes to the outside: 1 or 0, which is 0 in a box with balls. If it comes back from
                          there the polyline leaps */
  uint32_t reserved; /**< 0 */
} hsp_tunnel;

/** Find the tunnel from one point to another, or to the outside, that the widest probe gets through without the gates
 *  to be avoided. To avoid the tightest gates of tunnels before finds the next best one that has another bottleneck. It
 *  leads through maxima and gates, and each part of it is as wide as any path between its ends; of gates as wide it
 *  takes that which is nearer by straight lines from its start. Its points stay until the next call; on failure there
 *  are none. So a probe gets from one point to the other if it is narrower than the tunnel: then that is a path for it.
 *
 *  In a periodic box it leads to that copy of `to` which is best; and as nothing is outside there, `to` NULL is another
 *  copy of `from`, where the way begins anew, for ever. hsp_pores_get_tunnel_route has the vector. Its points are those
 *  of one way through the copies, from where `from` was given. Without balls that is as without a box.
 *  - Property 1: without avoided gates its radius is that of hsp_pores_widest.
 *  - Property 2: the largest probe at a gate is narrower than at the points beside it: the way rises from there.
 *
 *  @param[in,out] pores  of which no other tunnel is needed any more
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

/** The same with the tunnel of the least cost, which weighs how wide a way is against how long. Between the maxima of
 *  its ends, a straight line from a maximum to a gate beside it, or back, costs its length over the product of the
 *  radii at both: the integral of 1/r^2 along it, if r changes evenly. The way from a gate to the outside costs
 *  nothing, and gates that are no wider than 0 are not passed. Of the same cost it is one of several.
 *  - Property 1: its cost is no higher than that of hsp_pores_find_tunnel with the same arguments.
 *
 *  Cost: that of hsp_pores_find_tunnel.
 *  @param[in,out] pores  of which no other tunnel is needed any more
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
  const hsp_executor *executor; /**< or NULL: whether to go on is asked of it; its threads share nothing yet */
} hsp_tunnel_request;

/** The same as hsp_pores_find_tunnel or hsp_pores_find_cheapest_tunnel, as a request says; request may be NULL: all
 *  defaults. Where it is stopped there is no tunnel.
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

/** The cost of a tunnel, and where it leads. Frozen. */
typedef struct hsp_tunnel_route {
  double cost;       /**< as of hsp_pores_find_cheapest_tunnel, for both kinds, in 1/length; 0 without gates, infinite
                          through a gate that is no wider than 0 */
  int32_t shift[3];  /**< times the vectors of the box by that `to` is to be moved, or `from` if that was NULL, to where
                          the tunnel ends; 0 without a box */
  uint32_t reserved; /**< 0 */
} hsp_tunnel_route;

/** The cost of the last tunnel and its vector: *route becomes the record, all 0 if there was none.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_tunnel_route(const hsp_pores *pores, hsp_tunnel_route *route);

/** A point of a tunnel. Frozen. */
typedef struct hsp_tunnel_point {
  double xyz[3];    /**< where it lies */
  double radius;    /**< of the largest probe there */
  uint32_t ball[4]; /**< nearest ones, then HSP_NONE: four at a maximum, three at a gate, else one to three */
  uint32_t gate;    /**< that it is, or HSP_NONE */
  uint32_t maximum; /**< that it is, or HSP_NONE */
} hsp_tunnel_point;

/** The points [needed] of the last tunnel, from its start to its end; none if there was none. Between two of them the
 *  way is a curve of points equally far from two or three balls, or a straight line away from one, or two of these
 *  where one is short: nearer to the one before than 1/256 of its radius are gates, maxima and ends alone. An end
 *  within two lattice steps of a maximum or gate is that as well, and has its record but for the place.
 *  - Property 1: two of them are no farther apart than a tenth of the distance of either from the centre of a ball that
 *    is nearest to both, or to either if none is to both, or than 40 lattice steps; but for a leap from the outside,
 *    and for parts of curves that doubles do not know to 64 lattice steps, which have no points. Else, if a ball is
 *    nearest to both, the radius halfway between them is no more than the mean of theirs, and less than 1/800 of that
 *    distance below it, up to some lattice steps.
 *
 *  @retval HSP_E_ARGUMENT  pores is NULL; points is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_tunnel_points(const hsp_pores *pores, hsp_tunnel_point *points,
                                                     uint32_t capacity, uint32_t *needed);

/** Which copies a point of a tunnel is beside, in a periodic box; without one all is 0. Frozen. */
typedef struct hsp_tunnel_point_shifts {
  int32_t ball[12]; /**< three for each of its balls: by that the ball is to be moved from where it was given */
  int32_t at[3];    /**< by that the gate or maximum is to be moved from its point; 0 between those */
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
