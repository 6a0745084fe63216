/* hardsphere/contacts.h: which balls touch and by how much, each ball's share of the union, the dual complex.
 *
 * Guide: questions.md, coming_from.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 * The power of a point x with respect to ball i is |x - c_i|^2 - r_i^2; radii include the probe.
 *   share     of a ball: the points of the union whose power is least for this ball: the ball cut to its cell of the
 *             power diagram; convex
 *   contact   of two balls: the points that both shares have in common: a part of the disk in the radical plane that
 *             the circle of the two spheres bounds; the radical planes of other balls cut it off along straight lines
 *   simplex   one to four balls whose shares have a common point: ball, edge (a contact), triangle, tetrahedron. All
 *             simplices together are the dual complex (Edelsbrunner 1995), which has the same components, tunnels and
 *             voids as the union
 * All of it is decided exactly, as if ties were broken by infinitesimally inflated balls (hardsphere/boundary.h): balls
 * that touch have a contact of area 0. Where three spheres share a circle, the area of the disk in it is the contact of
 * two of the three balls: each ball is inflated by an infinitely small amount of its own, the largest for the ball that
 * comes first by (x, y, z, radius, index). Shares and all sums are continuous there too. */
#ifndef HARDSPHERE_CONTACTS_H
#define HARDSPHERE_CONTACTS_H

#include "boundary.h"
#include "executor.h"
#include "measure.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The contacts and shares of the balls of a boundary. */
typedef struct hsp_contacts hsp_contacts;

/** The limits that fix the memory of contacts. */
typedef struct hsp_contacts_limits {
  uint32_t struct_size; /**< sizeof(hsp_contacts_limits) */
  uint32_t balls;       /**< most balls of the model */
  uint32_t neighbours;  /**< as in hsp_boundary_limits */
  uint32_t contacts;    /**< contacts, each once */
  uint32_t triangles;   /**< triangles to keep for hsp_contacts_get_simplices; 0: they are only counted */
  uint32_t tetrahedra;  /**< tetrahedra to keep, likewise */
} hsp_contacts_limits;

/** Limits for a computed boundary that nearly always suffice for molecules: its balls and neighbours, contacts 12 balls
 *  + 64, no triangles and tetrahedra to keep.
 *  @retval HSP_E_ARGUMENT  limits or boundary is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 64) / 12 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_contacts_limits_init(hsp_contacts_limits *limits, uint32_t struct_size,
                                                  const hsp_boundary *boundary);

/** Bytes that hsp_contacts_init needs.
 *  - Property 1: at most HSP_CONTACTS_BYTES of the limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_contacts_bytes(const hsp_contacts_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_CONTACTS_BYTES(balls, neighbours, contacts, triangles, tetrahedra)        \
  ((size_t)5632 + (size_t)40 * (size_t)(balls) + (size_t)288 * (size_t)(neighbours) + \
   (size_t)80 * (size_t)(contacts) + (size_t)24 * (size_t)(triangles) + (size_t)24 * (size_t)(tetrahedra))

/** Make empty contacts in caller memory of any alignment; sets *contacts.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_contacts_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_contacts_init(void *memory, size_t bytes, const hsp_contacts_limits *limits,
                                           hsp_contacts **contacts);

/** Compute contacts, shares and dual complex of the balls of a computed boundary. Boundary and model must outlive the
 *  contacts; the contacts can be read while boundary and model hold the same (RESULTS in hardsphere.h). On failure the
 *  contacts hold no results. limits: see LIMITS in hardsphere.h; at most three retries.
 *  - Property 1: the order of the balls has no effect but on ids and on their order.
 *
 *  Cost: O(n) for sets as in Theorem 2.1; O(c) for each ball, and about O(m) for one with m neighbours where many balls
 *  are nearly the same or on a line, or for a ball with m small balls all over its sphere; O(m f) with all spheres
 *  through one point, where f others bound a ball's power cell there; O(m^2) for a ball that crosses several lines of
 *  balls, m in all, whose radical planes nearly agree; O(m^3) at worst.
 *  @retval HSP_E_ARGUMENT  contacts or boundary is NULL
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     the boundary holds no results, or its model has changed since */
HSP_API int32_t HSP_CALL hsp_contacts_compute(hsp_contacts *contacts, const hsp_boundary *boundary,
                                              hsp_contacts_limits *limits);

/** How contacts are computed. Zero means default in every field but the first. */
typedef struct hsp_contacts_request {
  uint32_t struct_size;         /**< sizeof(hsp_contacts_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_contacts_request;

/** The same as hsp_contacts_compute, with an executor that may stop it; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  contacts or boundary is NULL; an executor with several workers and
 *                          without run
 *  @retval HSP_E_VERSION   bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY  as hsp_contacts_compute
 *  @retval HSP_E_STATE     as hsp_contacts_compute
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_contacts_compute_with(hsp_contacts *contacts, const hsp_boundary *boundary,
                                                   const hsp_contacts_request *request, hsp_contacts_limits *limits);

/* ---- contacts ---------------------------------------------------------------------------------------------------- */

#define HSP_CONTACT_TOUCHING UINT32_C(1) /**< the spheres only touch: area 0 */
#define HSP_CONTACT_BURIED UINT32_C(2)   /**< no part of its border is on the boundary of the union */
#define HSP_CONTACT_CIRCLE UINT32_C(4)   /**< the whole disk, with all of its border on the boundary */

/** A contact of two balls. Frozen. */
typedef struct hsp_contact {
  double area;          /**< length^2 */
  double rim;           /**< length of the part of its border on the boundary of the union */
  double distance;      /**< of the two centres, length */
  uint32_t ball[2];     /**< its two balls a < b */
  uint32_t chords;      /**< number of its straight sides */
  uint32_t flags;       /**< HSP_CONTACT_* */
  uint32_t reserved[2]; /**< 0 */
} hsp_contact;

/** All contacts, ascending in their balls.
 *  - Property 1: 3 V = sum_i r_i A_i + the sum of distance times area over all contacts, up to rounding.
 *
 *  Accuracy: for each of its sides an area has an error of some 1e-15 of the square of the smaller of the two radii,
 *  up to 1e-12 where centres lie nearly on a line or in a plane; for each of its arcs a rim has one of some 1e-15 of
 *  the radius of the circle.
 *  @retval HSP_E_ARGUMENT  contacts is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_contacts_get_pairs(const hsp_contacts *contacts, hsp_contact *out, uint32_t capacity,
                                                uint32_t *needed);

/** The contacts of one ball, ascending in the other one.
 *  - Property 1: the records are those of hsp_contacts_get_pairs, bit for bit.
 *
 *  @retval HSP_E_ARGUMENT  contacts is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID        no such ball */
HSP_API int32_t HSP_CALL hsp_contacts_get_row(const hsp_contacts *contacts, uint32_t ball, hsp_contact *out,
                                              uint32_t capacity, uint32_t *needed);

/** Of each ball the volume of its share and the area of all its contacts; share_volume [n] and contact_area [n] may
 *  each be NULL and else hold capacity >= n entries. *totals, if not NULL, becomes the area of all contacts, each
 *  counted once, and the volume of all shares. needed may be NULL and else becomes n.
 *  - Property 1: the shares sum to the volume of the union.
 *  - Property 2: share_volume and contact_area do not depend on the order of the balls, bit for bit.
 *
 *  Cost: O(n + contacts).
 *  @retval HSP_E_ARGUMENT  contacts is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_contacts_measure(const hsp_contacts *contacts, hsp_totals *totals, double *share_volume,
                                              double *contact_area, uint32_t capacity, uint32_t *needed);

/** The contact of two groups of balls. Frozen. */
typedef struct hsp_group_contact {
  double area;       /**< of all contacts between them, length^2 */
  double rim;        /**< length of their borders on the boundary of the union */
  uint32_t group[2]; /**< the groups g < h */
  uint32_t contacts; /**< how many */
  uint32_t reserved; /**< 0 */
} hsp_group_contact;

/** Sums over the contacts between groups of balls, such as residues or chains: one record for every two different
 *  groups that have a contact, ascending. group [n] holds the number of each ball's group, any uint32_t; balls with
 *  HSP_NONE belong to no group. Uses memory of the handle, hence not const.
 *
 *  Cost: O(k log k) for k contacts.
 *  @retval HSP_E_ARGUMENT  contacts or group is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_contacts_group(hsp_contacts *contacts, const uint32_t *group, hsp_group_contact *out,
                                            uint32_t capacity, uint32_t *needed);

/* ---- the dual complex -------------------------------------------------------------------------------------------- */

#define HSP_SIMPLEX_SINGULAR UINT32_C(0) /**< on the boundary of the union, and in no larger simplex */
#define HSP_SIMPLEX_REGULAR UINT32_C(1)  /**< on the boundary, and in a larger simplex; triangles: on one side only */
#define HSP_SIMPLEX_INTERIOR UINT32_C(2) /**< not on the boundary */

/** How many simplices there are, and the topology of the union. Frozen. */
typedef struct hsp_complex {
  uint32_t singular[4]; /**< simplices of HSP_SIMPLEX_SINGULAR: balls, edges, triangles, tetrahedra */
  uint32_t regular[4];  /**< of HSP_SIMPLEX_REGULAR */
  uint32_t interior[4]; /**< of HSP_SIMPLEX_INTERIOR */
  int64_t euler;        /**< balls - edges + triangles - tetrahedra */
  uint32_t betti[3];    /**< of the union: components, independent tunnels, voids */
  uint32_t reserved[5]; /**< 0 */
} hsp_complex;

/** The simplices of the dual complex by dimension and kind.
 *  A ball is singular without contacts and interior without a face; an edge is singular with a whole free circle,
 *  regular with free arcs; a triangle is singular with two free vertices, regular with one.
 *  - Property 1: euler = betti[0] - betti[1] + betti[2], half of that of the boundary.
 *  - Property 2: the boundary has as many vertices as regular and twice singular triangles, and as many circles as
 *    singular edges.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_contacts_get_complex(const hsp_contacts *contacts, hsp_complex *counts);

/** A triangle or tetrahedron of the dual complex. Frozen. */
typedef struct hsp_simplex {
  uint32_t ball[4];  /**< ascending; ball[3] of a triangle is HSP_NONE */
  uint32_t kind;     /**< HSP_SIMPLEX_* */
  uint32_t reserved; /**< 0 */
} hsp_simplex;

/** The triangles (dimension 2) or tetrahedra (3), in no particular order. Those of dimension 0 and 1 are balls and
 *  contacts.
 *  @retval HSP_E_ARGUMENT  contacts is NULL; out is NULL with a capacity above 0; another dimension
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since; or those of this dimension were only
 *                          counted, as hsp_contacts_limits said, and there are some */
HSP_API int32_t HSP_CALL hsp_contacts_get_simplices(const hsp_contacts *contacts, uint32_t dimension, hsp_simplex *out,
                                                    uint32_t capacity, uint32_t *needed);

/* ---- self-check -------------------------------------------------------------------------------------------------- */

/** Check contacts and shares against laws that hold for every set of balls. *invariant becomes 0 or the number of the
 *  first law that is violated, *id the contact or ball concerned.
 *    1  each contact is listed at both of its balls, with numbers that it may have
 *    2  the Euler characteristic of the dual complex is half of that of the boundary
 *    3  faces and contacts of each ball close its share: their vector areas sum to 0
 *    4  the shares sum to the volume of the union
 *
 *  Cost: O(n + vertices + circles + contacts).
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since
 *  @retval HSP_E_CHECK     an invariant is violated: please report it */
HSP_API int32_t HSP_CALL hsp_contacts_check(hsp_contacts *contacts, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
