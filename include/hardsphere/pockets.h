/* hardsphere/pockets.h: pockets of pores, with mouths, and their sizes; regions of free space.
 *
 * Guide: pores.md, questions.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * These are read from the maxima and gates of hardsphere/pores.h:
 *
 *   pocket   where a narrow probe gets, and a wide one does not get from the outside
 *   mouth    a gate where the narrow probe gets out of a pocket to where the wide one gets, too
 *   plug     a ball that closes a mouth. Behind its plugs a pocket has a volume and an area
 *   region   a connected part of free space as the balls leave it
 *   leak     where the narrow probe gets past a plug */
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
  double radius;     /**< of the widest probe that fits in it: its depth */
  double mouth;      /**< of the widest probe that passes one of its mouths; the floor without mouths */
  uint32_t maximum;  /**< the widest one in it */
  uint32_t gate;     /**< its widest mouth; HSP_NONE if it is a cavity that the narrow probe does not get out of */
  uint32_t maxima;   /**< how many are in it */
  uint32_t mouths;   /**< how many it has */
  uint32_t balls;    /**< how many line it */
  uint32_t reserved; /**< 0 */
} hsp_pore_pocket;

/** Find pockets: where a probe of the radius `narrow` fits, and one of the radius `wide` does not get to from the
 *  outside. A pocket is made up of maxima wider than `narrow`, joined by gates wider than that; its mouths are such
 *  gates to where the wide probe gets. A wide probe that fits nowhere gets nowhere. In a periodic box it gets to where
 *  it goes on for ever, instead of the outside. *pockets becomes how many there are; they stay until the next call.
 *  - Property 1: with narrow = wide pockets are the cavities of that probe: the regions of hsp_cells of balls that are
 *    grown by it, without the outside; in a box the channels of hsp_pores_get_channels without directions.
 *
 *  Cost: O(maxima + gates), and sorting the balls of each pocket.
 *  @retval HSP_E_ARGUMENT    pores or pockets is NULL; wide is less than narrow
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  narrow or wide is a NaN or an infinity
 *  @retval HSP_E_RANGE       narrow is below the floor, or one of them above 2^51 lattice steps */
HSP_API int32_t HSP_CALL hsp_pores_find_pockets(hsp_pores *pores, double narrow, double wide, uint32_t *pockets);

/** The pockets first .. first + count - 1 of the last hsp_pores_find_pockets, exactly count records, that with the
 *  widest maximum first; out may be NULL with count 0.
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

/** The balls that line a pocket, in ascending order: nearest ones of its maxima, of the gates between them and of its
 *  mouths.
 *  @retval HSP_E_ARGUMENT  pores is NULL; balls is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, which may be NULL
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such pocket */
HSP_API int32_t HSP_CALL hsp_pores_get_pocket_balls(const hsp_pores *pores, uint32_t pocket, uint32_t *balls,
                                                    uint32_t capacity, uint32_t *needed);

/** The balls as rounded to the lattice, grown by the narrow probe of the last hsp_pores_find_pockets, and then a plug
 *  for each mouth: xyz [needed][3] and radius [needed], of which either may be NULL. Balls have their numbers; plugs
 *  come behind them, in the order of pockets and of their mouths. They are what hsp_pores_measure_pockets wants
 *  pores of. Of pores that it has taken for that, the balls as they are, and a plug for each leak that it found. Before
 *  either, the balls as they are.
 *
 *  A plug is a ball around the point of a mouth. The grown balls that are nearest there leave a part of their plane
 *  open, of which the corners are where two neighbouring ones meet, or else are the ends of the gap between them. The
 *  plug is the smallest ball that holds all corners, but for a part in 10^6 and some lattice steps. The radius of the
 *  probe is rounded up to the lattice, and a ball that it leaves no radius, as it is negative, keeps the radius 0. In a
 *  periodic box each ball may be given as another image than before.
 *
 *  Cost: O(n), and O(k^2) for a mouth where k balls tie.
 *  @retval HSP_E_ARGUMENT  pores is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is smaller than *needed; nothing but that is written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_pores_get_plugged_balls(const hsp_pores *pores, double *xyz, double *radius,
                                                     uint32_t capacity, uint32_t *needed);

/** How much of free space a probe gets to from the outside, or in a box for ever, and how much it does not. Frozen. */
typedef struct hsp_pore_access {
  double accessible_area;   /**< of the boundary beside accessible regions, length^2 */
  double accessible_volume; /**< length^3; infinite without a box */
  double blocked_area;      /**< of the boundary beside the other regions: cavities that end on all sides */
  double blocked_volume;    /**< of these */
  uint32_t accessible;      /**< how many regions are */
  uint32_t blocked;         /**< how many are not */
} hsp_pore_access;

/** Find the regions of free space beside the balls as they are, which are those that were given, grown by the probe of
 *  the model or box: where the centre of this probe gets about, with area and volume of each. The tree says which
 *  regions there are, so that its floor must not be above 0; the boundary of the union is their surface, and each of
 *  its shells belongs to where a way up from it leads. The regions stay until the next call.
 *
 *  A region is accessible if it is the outside or, in a box, has directions. A box without balls is one region in three
 *  directions.
 *  - Property 1: regions but the outside are the channels of hsp_pores_get_channels with the radius 0; without a box
 *    those of hsp_topology_get_regions, in another order.
 *  - Property 2: areas sum to the area of the union; in a box volumes to free_volume of hsp_periodic_totals.
 *
 *  Source: in a box volumes come from surfaces alone, for regions that go on for ever up to whole boxes: as a product
 *  of three phases (lib/boxes/periodic/surface_volume.hpp). Accuracy: about 1e-14 of the box.
 *  Cost: O(size of the boundary), and that of hsp_pores_locate for each shell.
 *  @param[in,out] pores   of which no other regions are needed any more
 *  @param[in] boundary    of the model that the pores were computed of; NULL in a box, which has its own
 *  @param[out] access     or NULL: the sums
 *  @param[out] regions    or NULL: how many there are
 *  @retval HSP_E_ARGUMENT  pores is NULL; boundary is NULL without a box, of another model, or given with one
 *  @retval HSP_E_STATE     nothing computed, or the model, box or boundary has changed since
 *  @retval HSP_E_RANGE     the floor is above 0; or free space is only some lattice steps wide around every vertex of a
 *                          shell and up to 25 points of each of its balls of more than 64 steps, or a way up is lost
 *                          between balls that are more than 2^35 steps apart, so that it is not certain where it leads
 *  @retval HSP_E_CHECK     a way up ends nowhere, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_pores_find_regions(hsp_pores *pores, const hsp_boundary *boundary, hsp_pore_access *access,
                                                uint32_t *regions);

/** How questions of pores are answered. Zero means default in every field but the first. */
typedef struct hsp_pores_request {
  uint32_t struct_size;         /**< sizeof(hsp_pores_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: whether to go on is asked of it; its threads share nothing yet */
} hsp_pores_request;

/** The same as hsp_pores_find_regions, as a request says; request may be NULL: all defaults.
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
  double radius;       /**< of the widest probe, beyond that of the model, that fits in it; infinite outside */
  double area;         /**< of its boundary, length^2 */
  double volume;       /**< length^3; infinite outside */
  uint32_t maximum;    /**< where the widest probe fits, or HSP_PORE_OUTSIDE */
  uint32_t maxima;     /**< how many are in it */
  uint32_t shells;     /**< of the boundary, how many bound it */
  uint32_t accessible; /**< whether it is: 1 or 0 */
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
  double volume; /**< where the centre of the narrow probe gets, length^3; NaN if the plugs do not close the pocket */
  double area;   /**< of the grown balls beside it, length^2; NaN likewise */
  double plug_area; /**< of the plugs beside it; NaN likewise */
  uint32_t regions; /**< how many parts it falls into; 0 if the plugs fill it, or do not close it */
  uint32_t closed;  /**< whether the plugs close it: 1 or 0 */
} hsp_pore_pocket_size;

/** Measure all pockets of the last hsp_pores_find_pockets: out gets a record for each, in their order. `plugged` are
 *  pores, with a floor that is not above 0, of the balls that hsp_pores_get_plugged_balls gives, without a probe and in
 *  the same box if there is one. Give them the step of `pores`, as the one that is chosen by default may be finer; or a
 *  coarser one, if a plug is too large for that. Balls behind these are plugs, too.
 *
 *  The volume of a pocket is that of the regions of `plugged` in which maxima of it are. It is closed if none of these
 *  is accessible and none holds a maximum, wider than the narrow probe, of no pocket or of another one; maxima in plugs
 *  are in no region. So the tree decides whether it is closed, and no tolerance. A dent that is hardly wider than its
 *  mouth may be filled by the plug: it is closed then, and has no volume. The plugs of all mouths are there at once, so
 *  that one may also take from a pocket or cavity beside its own, or fill it.
 *
 *  A pocket may not be closed at first, as the narrow probe slips past a plug where balls beside the mouth do not meet.
 *  Such leaks are gates of `plugged`, and become mouths of these pores instead of pockets that they may have had:
 *  hsp_pores_get_plugged_balls of `plugged` has a plug for each of them, too, and pores of those balls are for the next
 *  call, with the same first argument. Molecules need up to three. With no leak, and so no further ball, a pocket that
 *  is not closed stays so: in a box, where it, or what it opens to, goes on for ever; or where a plug turns the only
 *  way up from one of its maxima to the outside, or to where that from elsewhere leads.
 *  - Property 1: with narrow = wide, when there are no mouths, sizes are those of the blocked regions of the grown
 *    balls.
 *  - Property 2: if the first plugs close a pocket, and so do flat lids, in the plane of the three balls of each mouth,
 *    the volume behind these is no less than `volume`. It is no more than that and the free half of each plug on this
 *    side of its lid, what plugs of other pockets take, and free parts without a maximum that a plug cuts off.
 *
 *  Cost: that of hsp_pores_find_regions, and of hsp_pores_locate for each maximum that is wider than the narrow probe.
 *  @param[in,out] pores    with their pockets
 *  @param[in,out] plugged  whose regions become those that hsp_pores_find_regions finds. If it is refused, with
 *                          HSP_E_ARGUMENT, _CAPACITY or _STATE, nothing changes; on other failures it has none, and no
 *                          leaks. They may be the same pores, if nothing is grown and nothing has a plug
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

/** The same as hsp_pores_measure_pockets, as a request says; request may be NULL: all defaults.
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
