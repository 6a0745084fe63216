/* hardsphere/surface.h: the smooth molecular surface (Section 4.3): area and volume of the solvent-excluded surface,
 * and their derivatives.
 *
 * Richards' surface: a probe, a ball of radius p, rolls over the balls; what it cannot reach is the solvent-excluded
 * solid, and its boundary is the surface. p is the probe of hsp_model_options, which the radii of the model contain, so
 * that the boundary is the surface on which the centre of the probe runs. Each of its features yields a patch:
 *   face          a convex patch, where the probe touches one ball, of radius r = radius - p
 *   arc, circle   a saddle patch, where it touches two. Where it reaches the axis of the two balls its axis cuts it
 *   vertex        a concave patch, where it touches three. Probes at other vertices may cut it, or leave nothing of it
 * The surface is exact where it meets itself. With p = 0 it is the boundary itself.
 *
 * What cuts what follows from the exact boundary. Which pieces other probes leave of a concave patch is decided in
 * doubles, where their error bounds leave no doubt; else in integers, exactly, after directions have been rounded to 29
 * bits, which moves a border by about 1e-9 of p; else the status is HSP_E_CHECK. Vertices of the boundary that are
 * closer to each other than 2^-25 p count as one point.
 *
 * Where patches meet each of them is decided on its own. If one finds a corner or a crease that another does not, which
 * takes vertices that count as one point, or four probes that meet in one up to rounding, the joint is open: areas and
 * volumes hold nevertheless. */
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
  uint32_t neighbours;     /**< most probes at other vertices that may cut any one concave patch */
  uint32_t pieces;         /**< what is left of the concave patches that are cut: at least one for each of them */
  uint32_t arcs;           /**< that bound these pieces */
  uint32_t cusped_circles; /**< circles whose saddle patches reach their axis */
} hsp_surface_limits;

/** Limits for a computed boundary with V vertices and C circles that suffice for molecules and usual probes: its
 *  vertices, 64 neighbours, pieces V / 4 + 16, arcs 5 V / 4 + 64, cusped_circles V / 8 + C + 16. Without a boundary,
 *  for memory that is fixed beforehand, set them by hand, with the vertices and circles of hsp_boundary_limits.
 *  @retval HSP_E_ARGUMENT  limits or boundary is NULL; struct_size is bad
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since */
HSP_API int32_t hsp_surface_limits_init(hsp_surface_limits *limits, uint32_t struct_size, const hsp_boundary *boundary);

/** Bytes that hsp_surface_init needs.
 *  - Property 1: at most HSP_SURFACE_BYTES of the five limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer; bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t hsp_surface_bytes(const hsp_surface_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_SURFACE_BYTES(vertices, neighbours, pieces, arcs, cusped_circles)              \
  ((size_t)8192 + (size_t)104 * (size_t)(vertices) + (size_t)1152 * (size_t)(neighbours) + \
   (size_t)56 * (size_t)(pieces) + (size_t)24 * (size_t)(arcs) + (size_t)12 * (size_t)(cusped_circles))

/** Make an empty surface in caller memory of any alignment; sets *surface.
 *  @retval HSP_E_ARGUMENT  a null pointer; bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_surface_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t hsp_surface_init(void *memory, size_t bytes, const hsp_surface_limits *limits, hsp_surface **surface);

/** Compute the surface over a computed boundary. Boundary and model must outlive the surface; after hsp_model_set or
 *  hsp_boundary_compute what reads the surface yields HSP_E_STATE until it is computed again. On failure it holds no
 *  results. limits: see LIMITS in hardsphere.h; at most three retries.
 *  - Property 1: the order of the balls has no effect.
 *
 *  Cost: O(vertices) for sets as in Theorem 2.1 with probes no larger than balls; O(m^3) per vertex with m probes that
 *  cut its patch at worst.
 *  @retval HSP_E_ARGUMENT  surface or boundary is NULL; bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since
 *  @retval HSP_E_CHECK     no decision about a concave patch is consistent: please report it */
HSP_API int32_t hsp_surface_compute(hsp_surface *surface, const hsp_boundary *boundary, hsp_surface_limits *limits);

/** How many of everything. Frozen. */
typedef struct hsp_surface_counts {
  uint32_t convex_patches;  /**< faces of the boundary */
  uint32_t saddle_patches;  /**< arcs and circles of the boundary */
  uint32_t concave_patches; /**< vertices of the boundary */
  uint32_t cusped_patches;  /**< of the saddle patches, those that their axis cuts */
  uint32_t cut_patches;     /**< of the concave patches, those that other probes cut */
  uint32_t hidden_patches;  /**< of these, those of which nothing is left */
  uint32_t rounded_patches; /**< of the concave patches, those decided in integers after rounding */
  uint32_t open_joints;     /**< corners and creases that one cut patch has and another lacks: see above */
} hsp_surface_counts;

/** How many patches of each kind there are, and how many meet themselves or others. Without a probe all patches but the
 *  convex ones are empty, and none is cut.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t hsp_surface_get_counts(const hsp_surface *surface, hsp_surface_counts *counts);

/** Areas by kind of patch, and volume, of the whole or of one ball's share. Frozen. */
typedef struct hsp_surface_totals {
  double area;         /**< of all patches, length^2 */
  double volume;       /**< inside the surface, voids not included, length^3 */
  double convex_area;  /**< length^2 */
  double saddle_area;  /**< length^2 */
  double concave_area; /**< length^2 */
} hsp_surface_totals;

/** Area and volume of the surface, and each ball's share of them. totals may be NULL; balls may be NULL, else it holds
 *  capacity >= n entries, in the caller's order; needed may be NULL and else becomes n.
 *  A ball's share are its convex patches; of every saddle patch the part on its side of the narrowest place, where the
 *  probe's profile turns, which may be all or nothing of it; and a third of every concave patch of its vertices.
 *  Its volume is the term of the divergence theorem that belongs to these, about the same centre as in
 *  hsp_boundary_measure: the terms sum to the volume, single ones may be negative.
 *  Voids of the boundary are outside like everything else that a probe finds room in, reached or not. Totals are summed
 *  over the balls in the caller's order by a fixed binary tree.
 *  - Property 1: a ball's share does not depend on the order of the balls, bit for bit.
 *  - Property 2: area = convex_area + saddle_area + concave_area, up to rounding.
 *
 *  Accuracy: about 1e-13 of the total for molecules.
 *  Cost: O(n + size of the boundary).
 *  @retval HSP_E_ARGUMENT  surface is NULL
 *  @retval HSP_E_CAPACITY  balls is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t hsp_surface_measure(const hsp_surface *surface, hsp_surface_totals *totals, hsp_surface_totals *balls,
                                    uint32_t capacity, uint32_t *needed);

/** The ball has a vertex of more than three spheres, or of three that its probe just fits between; or another ball is
 *  equal to it. */
#define HSP_SURFACE_DEGENERATE UINT32_C(1)

/** E = tension * A + pressure * V of the smooth surface and its gradient, in one pass.
 *  energy may be NULL. d_centre [n][3] = dE/dc_i, d_radius [n] = dE/dr_i for radii without the probe, and flags [n] =
 *  HSP_SURFACE_* may each be NULL and else hold capacity >= n entries. energy->d_probe is the derivative by the probe,
 *  at the same radii. For the area alone: tension 1, pressure 0; for the volume alone: tension 0, pressure 1. needed
 *  may be NULL and else becomes n. On failure nothing but *needed is written.
 *  - Property 1: the sums of d_centre and of c_i x d_centre are zero up to rounding (E does not change under motions).
 *  - Property 2: sum_i (r_i d_radius_i + c_i . d_centre_i) + probe d_probe is 2 A for the area, 3 V for the volume.
 *  - Property 3: d_centre, d_radius and flags do not depend on the order of the balls, bit for bit.
 *  - Property 4: energy->area and energy->volume are those of hsp_surface_measure up to rounding.
 *
 *  V is continuously differentiable and A continuous, but where a piece of the outside is born. A is differentiable but
 *  where arcs and vertices come or go at an angle, which takes what HSP_SURFACE_DEGENERATE flags; there derivatives are
 *  those on one side at best. Without a probe balls that touch are flagged, too (gradient.h). The slope of a derivative
 *  may be unbounded elsewhere, where an arc or a vertex is born. The lattice's rounding is not differentiated.
 *  Cost: O(n + size of the boundary).
 *  @retval HSP_E_ARGUMENT    surface is NULL
 *  @retval HSP_E_CAPACITY    an array is given and capacity < n
 *  @retval HSP_E_STATE       nothing computed, or model or boundary changed since
 *  @retval HSP_E_NOT_FINITE  tension or pressure is NaN or infinite */
HSP_API int32_t hsp_surface_gradient(const hsp_surface *surface, double tension, double pressure, hsp_energy *energy,
                                     double *d_centre, double *d_radius, uint32_t *flags, uint32_t capacity,
                                     uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
