/* hardsphere/surface.h: the smooth, solvent-excluded surface: area, volume and their derivatives (Section 4.3).
 *
 * Guide: smooth_surface.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * A probe, a ball of radius p, rolls over the balls. The space that it cannot reach is the solvent-excluded solid. The
 * boundary of this solid is the smooth surface, also named after Richards or Connolly. p is the probe of
 * hsp_model_options. The radii of the model contain it, so the model's boundary is the surface on which the probe's
 * centre runs. With p = 0 the smooth surface is that boundary itself.
 *
 * PATCHES   Each feature of the boundary gives a patch of one of three kinds:
 *
 *               .-------.
 *              /         \            A probe, seen from the side, touches balls A and B.
 *             |   probe   |
 *             |           |           a, b   convex patches: parts of the balls themselves, of radius r = radius - p,
 *         a    \         /    b              where the probe touches one ball. From faces
 *      .-"""-.  '-._s_.-'  .-"""-.    s      saddle patch: the side of the probe between the two points where it
 *     /       \           /       \          touches, swept as it rolls around both balls. From arcs and circles
 *    |    A    |         |    B    |         concave patch: a third ball, behind, stops the roll. The probe touches
 *     \       /           \       /          three balls, and its side between the three points is the patch.
 *      '-----'             '-----'           From vertices
 *
 * The surface may meet itself, and is exact there. A saddle patch that reaches the axis of its two balls is cut by the
 * axis, in two cusps. Probes at other vertices may cut a concave patch into several pieces, or leave nothing of it; two
 * concave patches meet in a crease.
 *
 * DECISIONS   The exact boundary decides which patches there are and where they meet. Which pieces other probes leave
 * of a concave patch is decided in doubles where error bounds allow it and all patches fit together. Otherwise all
 * these decisions are made for one set of balls in general position, which differs from the given set by far less than
 * a rounding, in floats of up to 2048 bits with error bounds. So no two patches contradict each other, and the surface
 * is closed: all of 28,000 sets full of ties and near-ties are. Should a sign stay undecided the status is
 * HSP_E_DEGENERATE; no set is known that has it. Areas are at most 1e-7 p^2 off where balls touch in a vertex.
 *
 * Sets with ties have patches, creases and corners without any size. Which of them there are depends on the set in
 * general position, areas do not. Such sets take longer: milliseconds for a few points, a fifth of a second where two
 * hundred probes meet in one place.
 *
 * NUMBERS   Patches, edges and corners are numbered by the boundary, which has F faces, A arcs, C circles and V
 * vertices; f, a, c and v are its ids. The balls 0 and 1 of an arc or circle are ball[0] and ball[1] of hsp_arc and
 * hsp_circle.
 *
 *   patch           first           meaning
 *   f               0               convex patch of face f
 *   F + a           F               saddle patch of arc a; if it has cusps, its part at ball 0
 *   F + A + c       F + A           saddle patch of circle c; likewise
 *   F + A + C + v   F + A + C       concave patch of vertex v; if it is in pieces, the first one
 *   others          F + A + C + V   the parts at ball 1 of saddle patches with cusps; further pieces
 *
 *   edge            first           meaning
 *   2 a + s         0               of arc a, between its saddle patch and the convex patch on its ball s
 *   2 A + 2 c + s   2 A             of circle c, likewise
 *   2 (A + C + a) + e   2 A + 2 C   of arc a, between its saddle patch and the concave patch at its vertex[e]; if it
 *                                   has cusps, of the part at ball 0
 *   others          4 A + 2 C       of the parts at ball 1; creases
 *
 *   corner          first           meaning
 *   3 v + t         0               of the concave patch of vertex v, on its ball number t in hsp_vertex
 *   others          3 V             two cusps of every circle that has them, shared by all of its arcs; ends of creases
 *
 * A shell is a connected component of the surface: not of the boundary, as probes on two sides of a wall may meet.
 *
 * Every edge has two directions, h = 2 edge and 2 edge + 1: the first counter-clockwise about its axis. Seen from
 * outside of the solid a patch lies on the left of its edges. */
#ifndef HARDSPHERE_SURFACE_H
#define HARDSPHERE_SURFACE_H

#include "boundary.h"
#include "gradient.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The solvent-excluded surface over a boundary. */
typedef struct hsp_surface hsp_surface;

/** The limits that fix a surface's memory. */
typedef struct hsp_surface_limits {
  uint32_t struct_size;    /**< sizeof(hsp_surface_limits) */
  uint32_t vertices;       /**< vertices of the boundary */
  uint32_t faces;          /**< faces of the boundary */
  uint32_t neighbours;     /**< most probes at other vertices that may cut any one concave patch */
  uint32_t pieces;         /**< pieces that are left of cut concave patches: at least one for each of these */
  uint32_t arcs;           /**< arcs that bound these pieces */
  uint32_t cusped_circles; /**< circles whose saddle patches reach their axis */
} hsp_surface_limits;

/** Limits for a computed boundary with V vertices and C circles that suffice for molecules and usual probes: its
 *  vertices and faces, 64 neighbours, pieces V / 4 + 16, arcs 5 V / 4 + 64, cusped_circles V / 8 + C + 16. Without a
 *  boundary, for memory that is fixed beforehand, set them by hand, with the vertices and circles of
 *  hsp_boundary_limits.
 *  @retval HSP_E_ARGUMENT  limits or boundary is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since */
HSP_API int32_t HSP_CALL hsp_surface_limits_init(hsp_surface_limits *limits, uint32_t struct_size,
                                                 const hsp_boundary *boundary);

/** Bytes that hsp_surface_init needs. With limits that just suffice 157 per ball for haemoglobin (4HHB, 4384 atoms,
 *  radii of HSP_RADII_BONDI) and a probe of 1.4; with those of hsp_surface_limits_init 189.
 *  - Property 1: at most HSP_SURFACE_BYTES of the six limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_surface_bytes(const hsp_surface_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_SURFACE_BYTES(vertices, faces, neighbours, pieces, arcs, cusped_circles)                    \
  ((size_t)8448 + (size_t)54 * (size_t)(vertices) + (size_t)9 * (size_t)(faces) +                       \
   (size_t)1152 * (size_t)(neighbours) + (size_t)106 * (size_t)(pieces) + (size_t)33 * (size_t)(arcs) + \
   (size_t)16 * (size_t)(cusped_circles))

/** Make an empty surface in caller memory of any alignment; sets *surface.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_surface_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_surface_init(void *memory, size_t bytes, const hsp_surface_limits *limits,
                                          hsp_surface **surface);

/** Compute the smooth surface over a computed boundary. Boundary and model must outlive the surface; the surface can be
 *  read while boundary and model hold the same (RESULTS in hardsphere.h). On failure the surface holds no results.
 *  limits: see LIMITS in hardsphere.h; at most six retries.
 *  - Property 1: the order of the balls has no effect.
 *
 *  Cost: O(vertices) for sets as in Theorem 2.1 with probes no larger than balls; O(m^3) per vertex with m probes that
 *  cut its patch at worst.
 *  @retval HSP_E_ARGUMENT  surface or boundary is NULL
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since
 *  @retval HSP_E_DEGENERATE  a sign stays undecided: DECISIONS above */
HSP_API int32_t HSP_CALL hsp_surface_compute(hsp_surface *surface, const hsp_boundary *boundary,
                                             hsp_surface_limits *limits);

/** The same as hsp_surface_compute, for a chosen part of the boundary: its shells [count], numbered as in
 *  hsp_face.shell, in any order. With the shells of one region of the complement (hsp_topology_get_region_shells) the
 *  probe stays in that region. With the shells of region 0 it comes from outside: voids are filled, and everything in
 *  them is left out.
 *
 *  The chosen part and the rest of the boundary have a surface each. hsp_surface_measure and hsp_surface_get_gradient
 *  are of the chosen surface alone; patches, edges, corners, shells and hsp_surface_counts are of both, and
 *  hsp_surface_shell.chosen says to which surface a shell belongs. No probe at a vertex of one part cuts a patch of the
 *  other. So the chosen shells may differ from the shells that hsp_surface_compute finds there.
 *  - Property 1: with all shells of the boundary the same as hsp_surface_compute.
 *
 *  @retval HSP_E_ARGUMENT  surface or boundary is NULL; shells is NULL with a count above 0
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since
 *  @retval HSP_E_ID        the boundary has not all of these shells
 *  @retval HSP_E_DEGENERATE  a sign stays undecided: DECISIONS above */
HSP_API int32_t HSP_CALL hsp_surface_compute_shells(hsp_surface *surface, const hsp_boundary *boundary,
                                                    const uint32_t *shells, uint32_t count, hsp_surface_limits *limits);

/** How a surface is computed. Zero means default in every field but the first. */
typedef struct hsp_surface_request {
  uint32_t struct_size;         /**< sizeof(hsp_surface_request) */
  uint32_t count;               /**< how many shells are chosen */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
  const uint32_t *shells;       /**< [count] as of hsp_surface_compute_shells, or NULL for all of the boundary */
} hsp_surface_request;

/** The same as hsp_surface_compute or hsp_surface_compute_shells, with an executor that may stop it; request may be
 *  NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  surface or boundary is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request, executor or limits
 *  @retval HSP_E_CAPACITY  as hsp_surface_compute
 *  @retval HSP_E_STATE     as hsp_surface_compute
 *  @retval HSP_E_ID        the boundary has not all of these shells
 *  @retval HSP_E_DEGENERATE  as hsp_surface_compute
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_surface_compute_with(hsp_surface *surface, const hsp_boundary *boundary,
                                                  const hsp_surface_request *request, hsp_surface_limits *limits);

/** How many of everything. Frozen. */
typedef struct hsp_surface_counts {
  uint32_t convex_patches;  /**< faces of the boundary */
  uint32_t saddle_patches;  /**< arcs and circles of the boundary */
  uint32_t concave_patches; /**< vertices of the boundary */
  uint32_t cusped_patches;  /**< saddle patches that their axis cuts */
  uint32_t cut_patches;     /**< concave patches that other probes cut */
  uint32_t hidden_patches;  /**< 0: something is left of every patch, its corners at least */
  uint32_t rounded_patches; /**< concave patches whose pieces were not decided in doubles */
  uint32_t open_joints;     /**< 0: every surface is closed */
} hsp_surface_counts;

/** How many patches of each kind there are, and how many meet themselves or others. Without a probe all patches but the
 *  convex ones are empty, and none is cut.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_surface_get_counts(const hsp_surface *surface, hsp_surface_counts *counts);

/** Areas by kind of patch, and volume, of the whole surface or of one ball's share. Frozen. */
typedef struct hsp_surface_totals {
  double area;         /**< of all patches, length^2 */
  double volume;       /**< inside the surface, voids not included, length^3; of a ball, its term of the volume */
  double convex_area;  /**< length^2 */
  double saddle_area;  /**< length^2 */
  double concave_area; /**< length^2 */
} hsp_surface_totals;

/** Area and volume of the surface, and each ball's share of them. totals may be NULL; balls may be NULL, else it holds
 *  capacity >= n entries, in the caller's order; needed may be NULL and else becomes n.
 *  A ball's share of the surface consists of its convex patches; of every saddle patch's part on the ball's side of the
 *  narrowest place, where the probe's profile turns (this may be all or nothing of the patch); and of a third of every
 *  concave patch of its vertices.
 *  Its volume is the term of the divergence theorem of this share, about the same centre as in hsp_boundary_measure:
 *  the terms sum to the volume, single ones may be negative.
 *  Voids of the boundary count as outside, like all space in which a probe has room, whether or not it can get there.
 *  Totals are summed over the balls in the caller's order by a fixed binary tree.
 *  - Property 1: a ball's share does not depend on the order of the balls, bit for bit.
 *  - Property 2: area = convex_area + saddle_area + concave_area, up to rounding.
 *
 *  Accuracy: about 1e-13 of the total for molecules.
 *  Cost: O(n + size of the boundary).
 *  @retval HSP_E_ARGUMENT      surface is NULL
 *  @retval HSP_E_CAPACITY      balls is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE         nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_surface_measure(const hsp_surface *surface, hsp_surface_totals *totals,
                                             hsp_surface_totals *balls, uint32_t capacity, uint32_t *needed);

/** How the surface is measured. Zero means default in every field but the first. */
typedef struct hsp_surface_measure_request {
  uint32_t struct_size;         /**< sizeof(hsp_surface_measure_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_surface_measure_request;

/** The same as hsp_surface_measure, with an executor that may stop it; request may be NULL: all defaults. totals, balls
 *  and needed may be NULL.
 *  @retval HSP_E_ARGUMENT      surface is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION       bad struct_size of request or executor, or reserved is not 0
 *  @retval HSP_E_CAPACITY      as hsp_surface_measure
 *  @retval HSP_E_STATE         as hsp_surface_measure
 *  @retval HSP_E_STOPPED       the executor said not to go on; balls may have been written */
HSP_API int32_t HSP_CALL hsp_surface_measure_with(const hsp_surface *surface,
                                                  const hsp_surface_measure_request *request,
                                                  hsp_surface_totals *totals, hsp_surface_totals *balls,
                                                  uint32_t capacity, uint32_t *needed);

/** The derivatives by this ball may be one-sided or not exist, in one of these cases. The ball has a vertex of more
 *  than three spheres, or of three that the probe just fits between. Another ball is equal to it. Its sphere passes
 *  through a vertex or a whole circle of other balls. The probe at one of its vertices touches another probe in a point
 *  of the concave patch: exactly if the other probe is on the other side of the same three balls, else up to rounding.
 *  Or, where weights differ: the plane of a saddle's narrowest place passes through a ball's centre; one of two balls
 *  touches the other from inside; or probes at two vertices that coincide up to rounding meet, but not from cusp to
 *  cusp. */
#define HSP_SURFACE_DEGENERATE UINT32_C(1)

/** E = tension * sum_i sigma_i A_i + pressure * V of the smooth surface and its gradient, in one pass, with A_i ball
 *  i's share of the area as hsp_surface_measure has it. request may be NULL: all defaults. outputs->d_radius is for
 *  radii without the probe, outputs->flags are HSP_SURFACE_*, and energy->d_probe is the derivative by the probe, at
 *  the same radii. For the area alone: tension 1. For the volume alone: pressure 1. On failure nothing but
 *  outputs->needed and outputs->first_bad is written, except on HSP_E_EXECUTOR and HSP_E_STOPPED.
 *  - Property 1: the sums of d_centre and of c_i x d_centre are zero up to rounding (E does not change under motions),
 *    if no ball is flagged.
 *  - Property 2: likewise sum_i (r_i d_radius_i + c_i . d_centre_i) + probe d_probe is 2 sum_i sigma_i A_i for the
 *    area, 3 V for the volume, with radii r_i without the probe.
 *  - Property 3: d_centre, d_radius and flags do not depend on the order of the balls, bit for bit.
 *  - Property 4: without sigma energy->area and energy->volume are those of hsp_surface_measure up to rounding; with
 *    one sigma for all balls area and its derivatives are multiplied by it, up to rounding.
 *
 *  A and V are continuous, except where a piece of the outside appears. V is continuously differentiable, except where
 *  more than three spheres pass through a vertex, or three through a circle. A is continuously differentiable, except
 *  where arcs and vertices appear or vanish at an angle. All these exceptions are flagged with HSP_SURFACE_DEGENERATE;
 *  there derivatives are one-sided at best. Without a probe balls that touch are flagged, too, and circles of three
 *  spheres are not (gradient.h). Elsewhere the slope of a derivative may be unbounded where an arc or a vertex appears.
 *  The lattice's rounding is not differentiated. Shares of balls are less smooth than their sum. Where an arc or a
 *  vertex appears area passes from one ball to another with a square root: near it derivatives of shares grow without
 *  bound. Where the plane of an arc or a circle passes through a ball's centre, or a ball touches another from inside,
 *  they jump, which HSP_SURFACE_DEGENERATE flags.
 *  Accuracy: the sums of Properties 1 and 2 have an error of some 1e-15, times radii with the probe, for the volume
 *  their squares, and times the sizes of the derivatives; 1e-12 in nearly tied sets, 1e-9 where balls are a few lattice
 *  steps apart. The error of a single derivative is about what moving centres by 2^-53 of the radii would do to it: of
 *  two balls a few lattice steps apart that share a vertex with a third ball, derivatives have eight digits.
 *  Cost: O(n + size of the boundary).
 *  @retval HSP_E_ARGUMENT    surface or outputs is NULL; tangency is not HSP_TANGENT_OVERLAP; an executor with several
 *                            workers and without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    an array is given and capacity < n
 *  @retval HSP_E_STATE       nothing computed, or model or boundary changed since
 *  @retval HSP_E_NOT_FINITE  a sigma, tension or pressure is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_surface_get_gradient(const hsp_surface *surface, const hsp_gradient_request *request,
                                                  hsp_gradient_outputs *outputs);

/* ---- patches, edges, corners ------------------------------------------------------------------------------------- */

/** How many parts the surface has. Frozen. */
typedef struct hsp_surface_part_counts {
  uint32_t patches;   /**< of all kinds */
  uint32_t edges;     /**< of all kinds */
  uint32_t corners;   /**< of all kinds */
  uint32_t shells;    /**< connected components of the surface */
  uint32_t cusps;     /**< corners that are cusps */
  uint32_t junctions; /**< corners where three creases meet */
  uint32_t creases;   /**< edges that are creases */
  uint32_t reserved;  /**< 0 */
} hsp_surface_part_counts;

/** How many patches, edges, corners and shells there are.
 *  @retval HSP_E_ARGUMENT      a null pointer
 *  @retval HSP_E_STATE         nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_surface_get_part_counts(const hsp_surface *surface, hsp_surface_part_counts *counts);

/** The directed edge h, a uint32_t, the other way. h may be evaluated several times. HSP_NONE yields HSP_NONE. */
#define HSP_SURFACE_TWIN(h) ((h) == HSP_NONE ? HSP_NONE : ((h) ^ UINT32_C(1)))

/** The next directed edge around the patch on the left of h, from where h ends; h itself if it is a whole circle. This
 *  function and the next four return HSP_NONE if there is no such directed edge or there are no results.
 *  - Property 1: left(next(h)) = left(h), origin(next(h)) = origin(twin(h)). */
HSP_API uint32_t HSP_CALL hsp_surface_next(const hsp_surface *surface, uint32_t h);

/** The previous directed edge around the patch on the left of h: the inverse of hsp_surface_next. */
HSP_API uint32_t HSP_CALL hsp_surface_previous(const hsp_surface *surface, uint32_t h);

/** A directed edge of the next loop around the patch on the left of h; of the first loop after the last. So all loops
 *  of a patch are reached from `h` of its hsp_surface_patch. */
HSP_API uint32_t HSP_CALL hsp_surface_next_loop(const hsp_surface *surface, uint32_t h);

/** The corner where h starts; HSP_NONE also if it is a whole circle. */
HSP_API uint32_t HSP_CALL hsp_surface_origin(const hsp_surface *surface, uint32_t h);

/** The patch on the left of h. */
HSP_API uint32_t HSP_CALL hsp_surface_left(const hsp_surface *surface, uint32_t h);

#define HSP_PATCH_CONVEX UINT32_C(0)        /**< of a face */
#define HSP_PATCH_SADDLE UINT32_C(1)        /**< of an arc */
#define HSP_PATCH_CONCAVE UINT32_C(2)       /**< of a vertex */
#define HSP_PATCH_CIRCLE_SADDLE UINT32_C(3) /**< of a circle */

/** A patch. Frozen. */
typedef struct hsp_surface_patch {
  double area;       /**< length^2 */
  uint32_t kind;     /**< HSP_PATCH_* */
  uint32_t source;   /**< face, arc, circle or vertex of the boundary */
  uint32_t part;     /**< of a saddle patch with cusps, 0 at ball 0, 1 at ball 1; of a cut patch, the piece 0, 1, ... */
  uint32_t shell;    /**< HSP_NONE if nothing is left of it */
  uint32_t loops;    /**< loops of edges around it; 0 for a whole sphere, and if nothing is left of it */
  uint32_t edges;    /**< of all its loops */
  uint32_t h;        /**< a directed edge with this patch on its left; HSP_NONE if it has none */
  uint32_t reserved; /**< 0 */
} hsp_surface_patch;

#define HSP_SURFACE_RIM UINT32_C(0)        /**< between the patches of a face and an arc */
#define HSP_SURFACE_CIRCLE_RIM UINT32_C(1) /**< between the patches of a face and a circle */
#define HSP_SURFACE_SIDE UINT32_C(2)       /**< between the patches of an arc and a vertex */
#define HSP_SURFACE_CREASE UINT32_C(3)     /**< between the patches of two vertices */

/** An edge: a piece of a circle. Frozen. */
typedef struct hsp_surface_edge {
  double centre[3];     /**< of its circle, length */
  double axis[3];       /**< unit vector; 0 if the circle or the edge has no size */
  double radius;        /**< of its circle, length */
  double angle;         /**< counter-clockwise about the axis, in [0, 2 pi] */
  uint32_t patch[2];    /**< the patches on its left and on its right */
  uint32_t corner[2];   /**< where it starts and ends; HSP_NONE for a whole circle */
  uint32_t next[2];     /**< after 2 edge around patch[0], after 2 edge + 1 around patch[1] */
  uint32_t previous[2]; /**< likewise the directed edges before 2 edge and 2 edge + 1 */
  uint32_t kind;        /**< HSP_SURFACE_* */
  uint32_t source;      /**< arc or circle of the boundary; of a crease, HSP_NONE */
} hsp_surface_edge;

#define HSP_CORNER_BALL UINT32_C(0)   /**< of a convex, a concave and two saddle patches */
#define HSP_CORNER_CUSP UINT32_C(1)   /**< where saddle patches meet their axis */
#define HSP_CORNER_CREASE UINT32_C(2) /**< of three concave patches */

/** A corner: a point where edges end. A cusp of a whole circle is the tip of its saddle patch, no edge ends there.
 *  Frozen. */
typedef struct hsp_surface_corner {
  double xyz[3]; /**< position, length */
  uint32_t kind; /**< HSP_CORNER_* */
  uint32_t
      ball[2]; /**< the ball it lies on; of a cusp, those of its circle, the one on its side first; else HSP_NONE */
  uint32_t vertex[3]; /**< the vertex, or the three of its concave patches; else HSP_NONE */
  uint32_t shell;     /**< HSP_NONE for the cusp of a whole circle; a cusp may be one of a shell of each part */
  uint32_t reserved;  /**< 0 */
} hsp_surface_corner;

/** A shell: a connected component of the surface. Frozen. */
typedef struct hsp_surface_shell {
  double area;       /**< length^2 */
  double volume;     /**< of the space that it encloses, length^3; negative if this lies outside the solid */
  int64_t euler;     /**< Euler characteristic */
  uint32_t genus;    /**< 1 - euler/2: number of handles */
  uint32_t patches;  /**< how many it consists of */
  uint32_t chosen;   /**< 1 if it is of the chosen part, 0 if of the rest (hsp_surface_compute_shells) */
  uint32_t reserved; /**< 0 */
} hsp_surface_shell;

/** The patches first .. first + count - 1, exactly count records, of hsp_surface_part_counts.patches in all; out may be
 *  NULL with count 0.
 *  - Property 1: areas of all patches in chosen shells sum to the area of hsp_surface_measure, up to rounding.
 *
 *  @retval HSP_E_ARGUMENT      surface is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE         nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID            not all of these patches are there */
HSP_API int32_t HSP_CALL hsp_surface_get_patches(const hsp_surface *surface, uint32_t first, uint32_t count,
                                                 hsp_surface_patch *out);

/** The edges first .. first + count - 1, exactly count records, of hsp_surface_part_counts.edges in all; out may be
 *  NULL with count 0.
 *  @retval HSP_E_ARGUMENT      surface is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE         nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID            not all of these edges are there */
HSP_API int32_t HSP_CALL hsp_surface_get_edges(const hsp_surface *surface, uint32_t first, uint32_t count,
                                               hsp_surface_edge *out);

/** The corners first .. first + count - 1, exactly count records, of hsp_surface_part_counts.corners in all; out may be
 *  NULL with count 0.
 *  @retval HSP_E_ARGUMENT      surface is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE         nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID            not all of these corners are there */
HSP_API int32_t HSP_CALL hsp_surface_get_corners(const hsp_surface *surface, uint32_t first, uint32_t count,
                                                 hsp_surface_corner *out);

/** The shells: hsp_surface_part_counts.shells records.
 *  - Property 1: areas and volumes of the chosen ones sum to those of hsp_surface_measure, up to rounding.
 *
 *  Cost: O(size of the surface).
 *  @retval HSP_E_ARGUMENT      surface is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY      capacity is smaller than *needed
 *  @retval HSP_E_STATE         nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_surface_get_shells(const hsp_surface *surface, hsp_surface_shell *out, uint32_t capacity,
                                                uint32_t *needed);

/* ---- self-check -------------------------------------------------------------------------------------------------- */

/** Check the invariants of a computed surface. If all hold, *invariant becomes 0 and *id HSP_NONE. Else *invariant
 *  becomes the number of the first that is violated, and *id that of what is concerned: a directed edge for 1, 2, 4 and
 *  5, a patch for 3 and 8, a shell for 6, a patch with a negative area or the vertex of the pieces for 7; HSP_NONE if
 *  the whole is, as always for 9:
 *  1. the edges around each corner are one ring, in a cusp one for each part of the boundary: four at a corner of the
 *     boundary, three where creases meet; in a cusp a crease lies between the sides at the ends of each covered gap
 *  2. next and previous are inverse, keep to one patch and go from corner to corner
 *  3. the loops of all patches together are every directed edge once
 *  4. a crease has the same length in both of its patches, and those of the same two patches do not overlap
 *  5. every corner lies on the circles of its edges
 *  6. the Euler characteristic of each shell is even and at most 2
 *  7. no area is negative, and the pieces of a concave patch sum to what is left of it, up to rounding
 *  8. area and volume of convex and concave patches agree with the integral along their edges: the surface is closed
 *  9. areas and volumes of all patches, in chosen shells, sum to those of hsp_surface_measure, up to rounding
 *
 *  Cost: O(size of the surface).
 *  @retval HSP_OK              all hold
 *  @retval HSP_E_ARGUMENT      a null pointer
 *  @retval HSP_E_STATE         nothing computed, or model or boundary changed since
 *  @retval HSP_E_CHECK         one is violated: please report it */
HSP_API int32_t HSP_CALL hsp_surface_check(hsp_surface *surface, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
