/* hardsphere/pockets.h: pockets between two probes, their mouths, areas and volumes; regions of free space.
 *
 * Guide: pores.md, questions.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * These are read from the maxima and gates of hardsphere/pores.h:
 *
 *   pocket   a part of free space where a narrow probe fits, and that a wide probe does not reach from the outside
 *   mouth    a gate through which the narrow probe gets out of a pocket to a place that the wide probe reaches, too
 *   plug     a ball that closes a mouth. Behind its plugs a pocket has a volume and an area
 *   region   a connected part of free space as the balls leave it
 *   leak     a gate through which the narrow probe gets past a plug */
#ifndef HARDSPHERE_POCKETS_H
#define HARDSPHERE_POCKETS_H

#include "boundary.h"
#include "pores.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A pocket. Frozen. */
typedef struct hsp_pore_pocket {
  double radius;     /**< of the widest probe that fits in it */
  double mouth;      /**< of the widest probe that passes one of its mouths; the floor without mouths */
  uint32_t maximum;  /**< the widest maximum in it */
  uint32_t gate;     /**< its widest mouth; HSP_NONE if it is a cavity that the narrow probe cannot leave */
  uint32_t maxima;   /**< how many maxima are in it */
  uint32_t mouths;   /**< how many mouths it has */
  uint32_t balls;    /**< how many balls line it */
  uint32_t reserved; /**< 0 */
} hsp_pore_pocket;

/** Find pockets: places where a probe of the radius `narrow` fits, and that a probe of the radius `wide` does not reach
 *  from the outside. A pocket is made up of maxima wider than `narrow`, joined by gates wider than `narrow`; its mouths
 *  are gates of that width to places that the wide probe reaches. In a periodic box the wide probe reaches the places
 *  where it goes on for ever; a wide probe that fits nowhere reaches nothing. *pockets becomes the number of pockets;
 *  they stay until the next call, and on failure there are none.
 *  - Property 1: with narrow = wide pockets are the cavities of that probe: the regions of hsp_cells for balls that are
 *    grown by the probe, without the outside; in a box the channels of hsp_pores_get_channels without directions.
 *
 *  Cost: O(maxima + gates), and sorting the balls of each pocket.
 *  @retval HSP_E_ARGUMENT    pores or pockets is NULL; wide is less than narrow
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  narrow or wide is a NaN or an infinity
 *  @retval HSP_E_RANGE       narrow is below the floor, or narrow or wide is above 2^51 lattice steps */
HSP_API int32_t HSP_CALL hsp_pores_find_pockets(hsp_pores *pores, double narrow, double wide, uint32_t *pockets);

/** The pockets first .. first + count - 1 of the last hsp_pores_find_pockets, exactly count records, the pocket with
 *  the widest maximum first; out may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  pores is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these pockets are there */
HSP_API int32_t HSP_CALL hsp_pores_get_pockets(const hsp_pores *pores, uint32_t first, uint32_t count,
                                               hsp_pore_pocket *out);

/** The maxima of a pocket, the widest first.
 *  @retval HSP_E_ARGUMENT  pores is NULL; maxima is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such pocket */
HSP_API int32_t HSP_CALL hsp_pores_get_pocket_maxima(const hsp_pores *pores, uint32_t pocket, uint32_t *maxima,
                                                     uint32_t capacity, uint32_t *needed);

/** The mouths of a pocket, the widest first: numbers of gates.
 *  @retval HSP_E_ARGUMENT  pores is NULL; gates is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such pocket */
HSP_API int32_t HSP_CALL hsp_pores_get_pocket_mouths(const hsp_pores *pores, uint32_t pocket, uint32_t *gates,
                                                     uint32_t capacity, uint32_t *needed);

/** The balls that line a pocket, in ascending order: the nearest balls of its maxima, of the gates between these and of
 *  its mouths.
 *  @retval HSP_E_ARGUMENT  pores is NULL; balls is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such pocket */
HSP_API int32_t HSP_CALL hsp_pores_get_pocket_balls(const hsp_pores *pores, uint32_t pocket, uint32_t *balls,
                                                    uint32_t capacity, uint32_t *needed);

/** Balls for hsp_pores_measure_pockets: the balls as rounded to the lattice, grown by the narrow probe of the last
 *  hsp_pores_find_pockets, and then a plug for each mouth: xyz [needed][3] and radius [needed], length; either may be
 *  NULL. Balls keep their numbers; plugs come after them, in the order of pockets and of their mouths. Of pores that
 *  were the `plugged` of hsp_pores_measure_pockets these are the balls as they are, and a plug for each leak that it
 *  found. Before both calls they are the balls as they are.
 *
 *  A plug is a ball around the point of a mouth. The grown balls that are nearest to this point leave a part of their
 *  plane open. The corners of this part are the points where two neighbouring balls meet or, if they do not meet, the
 *  ends of the gap between them. The plug is the smallest ball that holds all corners, up to a part in 10^6 and some
 *  lattice steps. The radius of the probe is rounded up to the lattice. A ball that a negative probe would leave no
 *  radius keeps the radius 0. In a periodic box each ball may come back as another image than was given.
 *
 *  Cost: O(n), and O(k^2) for a mouth where k balls tie.
 *  @retval HSP_E_ARGUMENT  pores is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is smaller than *needed; nothing but that is written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_plugged_balls(const hsp_pores *pores, double *xyz, double *radius,
                                                     uint32_t capacity, uint32_t *needed);

/** How much of free space a probe reaches from the outside, or in a box goes on through for ever, and how much not.
 *  Frozen. */
typedef struct hsp_pore_access {
  double accessible_area;   /**< of the boundary beside accessible regions, length^2 */
  double accessible_volume; /**< length^3; infinite without a box */
  double blocked_area;      /**< of the boundary beside the other regions, cavities that end on all sides, length^2 */
  double blocked_volume;    /**< of these regions, length^3 */
  uint32_t accessible;      /**< how many regions are accessible */
  uint32_t blocked;         /**< how many regions are not */
} hsp_pore_access;

/** Find the regions of free space outside the balls of the model or box, whose radii include its probe: the regions
 *  where this probe's centre can move, with area and volume of each. The tree of classes says which regions there are,
 *  so its floor must not be above 0. The boundary of the union is their surface; each of its shells belongs to the
 *  region to which a way up from the shell leads. The regions stay until the next call, and on failure there are none.
 *
 *  A region is accessible if it is the outside or, in a box, has directions. A box without balls is one region in three
 *  directions.
 *  - Property 1: regions other than the outside are the channels of hsp_pores_get_channels with the radius 0. Without a
 *    box the regions are those of hsp_topology_get_regions, in another order.
 *  - Property 2: areas sum to the area of the union; in a box volumes to free_volume of hsp_periodic_totals.
 *
 *  Source: in a box volumes come from surfaces alone, for regions that go on for ever up to whole boxes: as a product
 *  of three phases (lib/boxes/periodic/surface_volume.hpp). Accuracy: about 1e-14 of the box.
 *  Cost: O(size of the boundary), and that of hsp_pores_locate for each shell.
 *  @param[in,out] pores   whose regions are replaced
 *  @param[in] boundary    of the model that the pores were computed of; NULL in a box, which has its own
 *  @param[out] access     or NULL: the sums over accessible and blocked regions
 *  @param[out] regions    or NULL: how many there are
 *  @retval HSP_E_ARGUMENT  pores is NULL; boundary is NULL without a box, of another model, or given with one
 *  @retval HSP_E_STATE     nothing computed, or the model, box or boundary has changed since
 *  @retval HSP_E_RANGE     the floor is above 0; or it is not certain where a way up from a shell leads: free space is
 *                          only some lattice steps wide around every vertex of the shell and up to 25 points of each of
 *                          its balls of more than 64 steps, or the way is lost between balls that are more than 2^35
 *                          steps apart
 *  @retval HSP_E_CHECK     a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_find_regions(hsp_pores *pores, const hsp_boundary *boundary, hsp_pore_access *access,
                                                uint32_t *regions);

/** How regions are found and pockets measured. Zero means default in every field but the first. */
typedef struct hsp_pores_request {
  uint32_t struct_size;         /**< sizeof(hsp_pores_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_pores_request;

/** The same as hsp_pores_find_regions, with an executor that may stop it; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  pores is NULL; boundary is NULL without a box, of another model, or given with one; an
 *                          executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request or executor, or reserved is not 0
 *  @retval HSP_E_STATE     as hsp_pores_find_regions
 *  @retval HSP_E_RANGE     as hsp_pores_find_regions
 *  @retval HSP_E_CHECK     as hsp_pores_find_regions
 *  @retval HSP_E_STOPPED   the executor said not to go on: there are no regions */
HSP_API int32_t HSP_CALL hsp_pores_find_regions_with(hsp_pores *pores, const hsp_boundary *boundary,
                                                     const hsp_pores_request *request, hsp_pore_access *access,
                                                     uint32_t *regions);

/** A region of free space. Frozen. */
typedef struct hsp_pore_region {
  double radius;       /**< of the widest probe that fits in it, in addition to the model's; infinite outside */
  double area;         /**< of its boundary, length^2 */
  double volume;       /**< length^3; infinite outside */
  uint32_t maximum;    /**< where the widest probe fits, or HSP_PORE_OUTSIDE */
  uint32_t maxima;     /**< how many maxima are in it */
  uint32_t shells;     /**< how many shells of the boundary bound it */
  uint32_t accessible; /**< whether it is accessible: 1 or 0 */
  uint32_t directions; /**< as in hsp_winding: 0 to 3 */
  uint32_t copies;     /**< as in hsp_winding */
  int32_t row[9];      /**< as in hsp_winding */
  uint32_t reserved;   /**< 0 */
} hsp_pore_region;

/** The regions first .. first + count - 1 of the last hsp_pores_find_regions, exactly count records: the outside first,
 *  which a box with balls does not have, then that of the widest maximum; out may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  pores is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these regions are there */
HSP_API int32_t HSP_CALL hsp_pores_get_regions(const hsp_pores *pores, uint32_t first, uint32_t count,
                                               hsp_pore_region *out);

/** The size of a pocket, cut off at its mouths by plugs. Frozen. */
typedef struct hsp_pore_pocket_size {
  double volume;    /**< of the space where the narrow probe's centre gets, length^3; NaN if it is not closed */
  double area;      /**< of the grown balls beside it, length^2; NaN likewise */
  double plug_area; /**< of the plugs beside it, length^2; NaN likewise */
  uint32_t regions; /**< how many parts it falls into; 0 if the plugs fill it, or do not close it */
  uint32_t closed;  /**< whether the plugs close it: 1 or 0 */
} hsp_pore_pocket_size;

/** Measure all pockets of the last hsp_pores_find_pockets: out gets a record for each, in their order. `plugged` are
 *  pores of the balls that hsp_pores_get_plugged_balls gives, with a floor that is not above 0, without a probe, and in
 *  the same box if there is one. Set their model with the lattice step of the model of `pores`, as the default step may
 *  be finer; or with a coarser step if a plug is too large for that one. Further balls after these count as plugs, too.
 *
 *  The volume of a pocket is that of the regions of `plugged` in which the pocket's maxima lie. The pocket is closed if
 *  none of these regions is accessible, and none holds a maximum wider than the narrow probe that belongs to no pocket
 *  or to another one; maxima inside plugs are in no region. So the tree decides whether a pocket is closed, and no
 *  tolerance does. A plug may fill a dent that is hardly wider than its mouth: the pocket is closed then, and has no
 *  volume. The plugs of all mouths are present at once. So a plug may also take space from a pocket or cavity beside
 *  its own, or fill it.
 *
 *  A pocket may be open at first, as the narrow probe slips past a plug where balls beside the mouth do not meet. Such
 *  leaks are gates of `plugged`. The call stores them in `plugged` as mouths, in place of pockets that `plugged` may
 *  have had: hsp_pores_get_plugged_balls of `plugged` has a plug for each leak, too. Compute pores of those balls and
 *  call again, with the same first argument. Molecules need up to three rounds. If there is no leak, and so no further
 *  ball, an open pocket stays open: in a box, where the pocket, or what it opens to, goes on for ever; or where a plug
 *  turns the only way up from one of its maxima to the outside, or to where a way up from elsewhere leads.
 *  - Property 1: with narrow = wide, when there are no mouths, sizes are those of the blocked regions of the grown
 *    balls.
 *  - Property 2: if the first plugs close a pocket, and so do flat lids, in the plane of the three balls of each mouth,
 *    the volume behind these is no less than `volume`. The volume behind the lids is at most `volume` plus the free
 *    half of each plug on this side of its lid, the space that plugs of other pockets take, and free parts without a
 *    maximum that a plug cuts off.
 *
 *  Cost: that of hsp_pores_find_regions, and of hsp_pores_locate for each maximum that is wider than the narrow probe.
 *  @param[in,out] pores    with pockets that were found; its memory is used
 *  @param[in,out] plugged  its regions become those that hsp_pores_find_regions finds. On HSP_E_ARGUMENT,
 *                          HSP_E_CAPACITY, HSP_E_STATE and HSP_E_VERSION nothing changes, nor where its floor is
 *                          refused; on other failures it has no regions and no leaks. May be `pores` itself if no
 *                          ball is grown and no mouth has a plug
 *  @param[in] boundary     of the model that `plugged` were computed of; NULL in a box
 *  @param[out] out         a record for each pocket, or NULL with capacity = 0
 *  @param[in] capacity     how many records there is room for
 *  @param[out] needed      or NULL: how many pockets there are
 *  @retval HSP_E_ARGUMENT  pores or plugged is NULL; out is NULL with a capacity above 0; `plugged` are of other balls
 *                          or of another box; boundary is NULL without a box, of another model, or given with one
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or a model, box or boundary has changed since
 *  @retval HSP_E_RANGE     as of hsp_pores_find_regions; or maxima lie beyond the lattice of `plugged`
 *  @retval HSP_E_CHECK     a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_measure_pockets(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary,
                                                   hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed);

/** The same as hsp_pores_measure_pockets, with an executor that may stop it; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  pores or plugged is NULL; out is NULL with a capacity above 0; `plugged` are of other balls
 *                          or of another box; boundary is NULL without a box, of another model, or given with one; an
 *                          executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request or executor, or reserved is not 0
 *  @retval HSP_E_CAPACITY  as hsp_pores_measure_pockets
 *  @retval HSP_E_STATE     as hsp_pores_measure_pockets
 *  @retval HSP_E_RANGE     as hsp_pores_measure_pockets
 *  @retval HSP_E_CHECK     as hsp_pores_measure_pockets
 *  @retval HSP_E_STOPPED   the executor said not to go on: `plugged` has no regions and no leaks, nothing is written to
 *                          out */
HSP_API int32_t HSP_CALL hsp_pores_measure_pockets_with(hsp_pores *pores, hsp_pores *plugged,
                                                        const hsp_boundary *boundary, const hsp_pores_request *request,
                                                        hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
