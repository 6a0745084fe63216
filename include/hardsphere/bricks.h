/* hardsphere/bricks.h: areas, volume, components, voids of sets too large for one memory, computed in parts.
 *
 * Guide: bricks.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * Every ball of the whole set has an id, and one owner, a brick. The model of a brick holds its own balls and all balls
 * of other bricks that meet one of them: balls of other bricks within 2 (largest radius + probe) of its region suffice,
 * and more do no harm. If such balls are missing totals are wrong, which merging notices in most cases, not in all: the
 * caller has to take care of it. All bricks have the same step, probe and largest_radius (hsp_model_options), and give
 * their balls in ascending order of ids. The caller is free to choose which balls a brick owns. Boxes are not periodic.
 *
 * A brick leaves a summary, some bytes for each ball at its border. Where balls of two bricks join, at a curve or a
 * contact, the summaries of both bricks have a record of it, a seam. Summaries merge in any order and any tree to
 * totals and shells of the same bits, as if the whole had been one brick. A summary is a block of bytes, the same on
 * every machine, at any address: it is stored, sent and read as it is, and needs no handle and no limits. The bytes of
 * a merged summary depend on the order of merges.
 *
 * Counts are those of hsp_boundary_counts of the whole. Areas are sums over faces. Each term is rounded once to a
 * multiple of a quantum of some 1e-24 of the square of the largest radius: such integers add up to the same bits in any
 * order, and the sum is rounded once more at the end. Volumes likewise. So their last bits differ from those of
 * hsp_totals, which are sums of doubles in a tree over the balls. */
#ifndef HARDSPHERE_BRICKS_H
#define HARDSPHERE_BRICKS_H

#include "boundary.h"
#include "executor.h"
#include "regions.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Complete shells stay in summaries as records, for hsp_brick_get_shells: some 200 bytes for each. */
#define HSP_BRICK_KEEP_SHELLS UINT32_C(1)

/** To which brick a boundary belongs. */
typedef struct hsp_brick_request {
  uint32_t struct_size;         /**< sizeof(hsp_brick_request) */
  uint32_t brick;               /**< which it is, below bricks */
  uint32_t bricks;              /**< how many make the whole, the same for all */
  uint32_t flags;               /**< HSP_BRICK_*, the same for all */
  const uint64_t *id;           /**< [n]: each ball's id in the whole set, ascending */
  const uint32_t *owner;        /**< [n]: the brick that owns it, below bricks */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_brick_request;

/** Write the summary of a brick, from the boundary of all balls of its model (not of selected ones). summary has *bytes
 *  bytes of any alignment, in which the work is done; *bytes becomes how many of them the summary takes, from the first
 *  on. If they do not suffice *bytes becomes a larger number: call again with so many bytes, twice at most. summary may
 *  be NULL with *bytes 0. first_bad may be NULL, else it becomes the first ball whose id or owner is refused, or
 *  HSP_NONE.
 *  - Property 1: totals of all bricks do not depend on which ball belongs to which, bit for bit.
 *
 *  Cost: O(n + vertices + circles), expected, and that of hsp_query_neighbours for each ball of other bricks.
 *  @retval HSP_E_ARGUMENT  boundary, request or bytes is NULL, or summary with *bytes above 0; id or owner with n > 0;
 *                          brick is not below bricks, or an unknown flag; an executor with several workers and
 *                          without run
 *  @retval HSP_E_VERSION   bad struct_size of request or executor
 *  @retval HSP_E_CAPACITY  *bytes do not suffice; nothing but *bytes and the memory is written
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since; of selected balls
 *  @retval HSP_E_ID        an id is not above the one before, or an owner is not below bricks
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_brick_summarise(const hsp_boundary *boundary, const hsp_brick_request *request,
                                             void *summary, size_t *bytes, uint32_t *first_bad);

/** Merge two summaries, a [a_bytes] and b [b_bytes], into a third one. summary has *bytes bytes, as for
 *  hsp_brick_summarise, and overlaps neither; a second call always suffices. Seams that a and b share vanish. Shells
 *  and components that are complete are added up, and their records dropped unless shells are kept: so a summary grows
 *  only with its open seams. brick may be NULL, else it becomes the brick at fault, or HSP_NONE where there is none to
 *  name. executor may be NULL; its proceed is asked whether to go on, its threads share no work.
 *  - Property 1: once all bricks are in, totals are the same for every order and tree of merges, bit for bit.
 *
 *  Cost: O(a_bytes + b_bytes), and a logarithm of the number of bricks in them for each seam.
 *  @retval HSP_E_ARGUMENT  a, b or bytes is NULL, or summary with *bytes above 0; bricks of other lattices, of another
 *                          number of bricks or with other flags: *brick is the first in b; an executor with several
 *                          workers and without run
 *  @retval HSP_E_VERSION   a summary of a newer version, or bad struct_size of executor
 *  @retval HSP_E_CAPACITY  *bytes do not suffice; nothing but *bytes is written
 *  @retval HSP_E_ID        the brick *brick is in both
 *  @retval HSP_E_RANGE     more than 2^32 records together
 *  @retval HSP_E_CONFLICT  *brick lacks a seam that its neighbour has: one of them lacked balls that meet its own, or
 *                          they are not parts of one set
 *  @retval HSP_E_DAMAGED   bytes that are no summary, or not as they were written
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_brick_merge(const uint8_t *a, size_t a_bytes, const uint8_t *b, size_t b_bytes,
                                         const hsp_executor *executor, void *summary, size_t *bytes, uint32_t *brick);

/** Totals of the whole. Frozen. */
typedef struct hsp_brick_totals {
  uint64_t balls;           /**< each counted by its owner */
  uint64_t exposed_balls;   /**< as in hsp_boundary_counts, like all others */
  uint64_t contained_balls; /**< balls inside one other ball */
  uint64_t vertices;        /**< points where three spheres meet */
  uint64_t arcs;            /**< between two vertices */
  uint64_t circles;         /**< whole circles that are free */
  uint64_t faces;           /**< maximal free pieces of spheres */
  uint64_t loops;           /**< boundary loops of all faces */
  uint64_t shells;          /**< connected components of the boundary */
  uint64_t components;      /**< connected components of the union */
  uint64_t voids;           /**< bounded components of the complement of the union */
  uint64_t tied_vertices;   /**< vertices with HSP_VERTEX_TIED */
  int64_t euler;            /**< Euler characteristic of the boundary, summed over its shells */
  double area;              /**< of the boundary, walls of voids included, length^2 */
  double volume;            /**< of the union, voids not included, length^3 */
  double void_volume;       /**< that shells of voids enclose, with whatever lies in them, length^3 */
  uint64_t reserved[2];     /**< 0 */
} hsp_brick_totals;

/** Totals of the whole, from a summary [bytes] with all bricks in it. brick may be NULL, else it becomes the first
 *  brick that is missing, or HSP_NONE.
 *  @param[in]  summary  [bytes]
 *  @param[in]  bytes    its size
 *  @param[out] totals   one
 *  @param[out] brick    one, or NULL
 *  - Property 1: euler = vertices - arcs + 2 faces - loops, voids = shells - components, 2 arcs = 3 vertices.
 *
 *  Cost: O(bytes).
 *  @retval HSP_E_ARGUMENT  summary or totals is NULL
 *  @retval HSP_E_VERSION   a summary of a newer version
 *  @retval HSP_E_STATE     a brick is missing: *brick is the first
 *  @retval HSP_E_CONFLICT  no set of balls has such totals: bricks lacked balls that meet their own, or are not parts
 *                          of one set
 *  @retval HSP_E_DAMAGED   bytes that are no summary, or not as they were written */
HSP_API int32_t HSP_CALL hsp_brick_get_totals(const uint8_t *summary, size_t bytes, hsp_brick_totals *totals,
                                              uint32_t *brick);

/** A shell of the whole. Frozen. */
typedef struct hsp_brick_shell {
  uint64_t component;   /**< of the union: the lowest id of its balls */
  uint64_t faces;       /**< maximal faces */
  int64_t euler;        /**< Euler characteristic; 1 - euler/2 handles */
  double area;          /**< length^2 */
  double volume;        /**< of the space that it encloses, with whatever lies in it, length^3 */
  uint32_t kind;        /**< HSP_SHELL_* */
  uint32_t reserved[3]; /**< 0 */
} hsp_brick_shell;

/** The shells of the whole, from a summary [bytes] with all bricks in it, all made with HSP_BRICK_KEEP_SHELLS. They are
 *  in the order of their components, and the outer one of each before its voids. brick may be NULL, else it becomes the
 *  first that is missing, or HSP_NONE.
 *  - Property 1: records and their order are the same for every order and tree of merges, bit for bit.
 *
 *  Cost: O(bytes), and that of sorting the shells.
 *  @retval HSP_E_ARGUMENT  summary is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_VERSION   a summary of a newer version
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     a brick is missing: *brick is the first; or shells were not kept
 *  @retval HSP_E_CONFLICT  as hsp_brick_get_totals
 *  @retval HSP_E_DAMAGED   bytes that are no summary, or not as they were written */
HSP_API int32_t HSP_CALL hsp_brick_get_shells(const uint8_t *summary, size_t bytes, hsp_brick_shell *out,
                                              uint32_t capacity, uint32_t *needed, uint32_t *brick);

#ifdef __cplusplus
}
#endif

#endif
