/* hardsphere/cells.h: free space as O(n) simple cells with their neighbours (Section 2, Theorem 2.4).
 *
 * Guide: tutorial.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * Space is cut by the cubes of the grid, whose side is twice the largest radius. In a cube that balls meet every point
 * belongs to the ball to which it has the least power, its squared distance from the centre less the squared radius.
 * The points of one ball in one cube make a convex polytope, called a power cell here. The part of a power cell outside
 * its ball falls into free parts. Cubes that no ball meets are joined to runs along x, and these to rows and layers.
 *
 *   cell           a free part of a power cell, or a run: 0 .. cells - 1. Runs come first; cell 0 is the one below all
 *                  balls, which reaches to infinity
 *   neighbours     two cells that share a piece of a facet or of a cube's side, through which a point can move from one
 *                  to the other in free space
 *   region         a connected component of free space, made of cells that are neighbours: a region of regions.h, in
 *                  another order. Region 0 is the outside
 *
 * All of this is decided in integers, as the boundary is; balls that touch count as meeting, so that nothing passes
 * between them. A point with the same power to two balls belongs to the ball that comes first by (x, y, z, radius,
 * index). So where such points fill a side of a cube they may be a cell of no thickness, between its neighbours on both
 * sides. In a model with a probe the cells are the space where the probe's centre may be. */
#ifndef HARDSPHERE_CELLS_H
#define HARDSPHERE_CELLS_H

#include "model.h"
#include "topology.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Free space as cells. */
typedef struct hsp_cells hsp_cells;

/** The limits that fix the memory of cells. */
typedef struct hsp_cells_limits {
  uint32_t struct_size;  /**< sizeof(hsp_cells_limits) */
  uint32_t cubes;        /**< cubes that balls meet */
  uint32_t entries;      /**< pairs of a ball and a cube that it meets */
  uint32_t cells;        /**< free parts and runs */
  uint32_t adjacencies;  /**< pairs of neighbours */
  uint32_t landmarks;    /**< vertices of power cells with several free parts */
  uint32_t facets;       /**< of power cells on sides between two cubes that balls meet, each side once */
  uint32_t corners;      /**< of all these facets */
  uint32_t cube_balls;   /**< most balls that meet one cube; a computation may rarely ask for some more */
  uint32_t cube_corners; /**< vertices of all power cells of one cube */
} hsp_cells_limits;

/** Limits that suffice for most molecules of `balls` atoms, about 6.5 kB for each: cubes 2 balls + 64, entries
 *  8 balls + 64, cells 10 balls + 256, adjacencies 40 balls + 1024, landmarks and facets 16 balls + 512, corners
 *  80 balls + 2048, cube_balls min(balls, 192), cube_corners 40 cube_balls + 64.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 2048) / 80 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_cells_limits_init(hsp_cells_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_cells_init needs.
 *  - Property 1: at most HSP_CELLS_BYTES of the limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_cells_bytes(const hsp_cells_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_CELLS_BYTES(cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, cube_corners) \
  ((size_t)24576 + (size_t)128 * (size_t)(cubes) + (size_t)8 * (size_t)(entries) + (size_t)28 * (size_t)(cells) + \
   (size_t)16 * (size_t)(adjacencies) + (size_t)12 * (size_t)(landmarks) + (size_t)72 * (size_t)(facets) +        \
   (size_t)48 * (size_t)(corners) + (size_t)1600 * (size_t)(cube_balls) + (size_t)64 * (size_t)(cube_corners))

/** Make cells without results in caller memory of any alignment; sets *cells.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_cells_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_cells_init(void *memory, size_t bytes, const hsp_cells_limits *limits, hsp_cells **cells);

/** Cut the free space of a model into cells. The model must outlive the cells; the cells can be read while the model
 *  holds the same balls (RESULTS in hardsphere.h). On failure the cells hold no results. limits: see LIMITS in
 *  hardsphere.h; at most six retries.
 *  - Property 1: the order of the balls has no effect but on their numbers, unless balls are equal.
 *
 *  Cost: O(n) for sets as in Theorem 2.1.
 *  @retval HSP_E_ARGUMENT  cells or model is NULL
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     hsp_model_set has failed
 *  @retval HSP_E_CHECK     cells contradict each other, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_cells_compute(hsp_cells *cells, const hsp_model *model, hsp_cells_limits *limits);

/** How cells are computed. Zero means default in every field but the first. */
typedef struct hsp_cells_request {
  uint32_t struct_size;         /**< sizeof(hsp_cells_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_cells_request;

/** The same as hsp_cells_compute, with an executor that may stop it; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  cells or model is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY  as hsp_cells_compute
 *  @retval HSP_E_STATE     as hsp_cells_compute
 *  @retval HSP_E_CHECK     as hsp_cells_compute
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_cells_compute_with(hsp_cells *cells, const hsp_model *model,
                                                const hsp_cells_request *request, hsp_cells_limits *limits);

/** How many of everything. Frozen. */
typedef struct hsp_cells_counts {
  uint32_t cubes;       /**< cubes that balls meet */
  uint32_t power_cells; /**< power cells in all of these cubes, free or not */
  uint32_t cells;       /**< free parts and runs */
  uint32_t runs;        /**< of the cells, those that are runs */
  uint32_t adjacencies; /**< pairs of neighbours */
  uint32_t regions;     /**< connected components of free space: 1 + voids */
} hsp_cells_counts;

/** How many cells, neighbours and regions there are.
 *  - Property 1: regions is the number that hsp_topology_get_counts reports.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_cells_get_counts(const hsp_cells *cells, hsp_cells_counts *counts);

#define HSP_CELL_RUN UINT32_C(0)     /**< cubes that no ball meets */
#define HSP_CELL_AT_BALL UINT32_C(1) /**< a free part of the power cell of a ball that meets that power cell */
#define HSP_CELL_APART UINT32_C(2)   /**< a whole power cell, which its ball does not meet */

/** A cell of free space. Frozen. */
typedef struct hsp_free_cell {
  double low[3];       /**< lower corner of its box: of the run, or of its cube; length, infinite without an end */
  double high[3];      /**< upper corner, likewise */
  uint32_t ball;       /**< ball of whose power cell it is a part; HSP_NONE for a run */
  uint32_t cube;       /**< 0 .. cubes - 1, lowest z first, of these lowest y; HSP_NONE for a run */
  uint32_t kind;       /**< HSP_CELL_* */
  uint32_t region;     /**< its region, 0 .. regions - 1 */
  uint32_t neighbours; /**< how many it has */
  uint32_t reserved;   /**< 0 */
} hsp_free_cell;

/** The cells first .. first + count - 1, exactly count records, of hsp_cells_counts.cells in all; out may be NULL with
 *  count 0. Cost: O(count), and if runs are among them O(runs).
 *  @retval HSP_E_ARGUMENT  cells is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these cells are there */
HSP_API int32_t HSP_CALL hsp_cells_get_cells(const hsp_cells *cells, uint32_t first, uint32_t count,
                                             hsp_free_cell *out);

/** The neighbours of a cell, ascending.
 *  - Property 1: a cell is a neighbour of each of its neighbours, and in the same region.
 *
 *  @retval HSP_E_ARGUMENT  cells is NULL; neighbours is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        there is no such cell */
HSP_API int32_t HSP_CALL hsp_cells_get_neighbours(const hsp_cells *cells, uint32_t cell, uint32_t *neighbours,
                                                  uint32_t capacity, uint32_t *needed);

/** Two cells that are neighbours, the lower number first. Frozen. */
typedef struct hsp_cell_pair {
  uint32_t cell[2]; /**< numbers of cells */
} hsp_cell_pair;

/** The pairs first .. first + count - 1 of neighbours, each pair once, exactly count records, of
 *  hsp_cells_counts.adjacencies in all; out may be NULL with count 0.
 *  @retval HSP_E_ARGUMENT  cells is NULL; out is NULL with a count above 0
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since
 *  @retval HSP_E_ID        not all of these pairs are there */
HSP_API int32_t HSP_CALL hsp_cells_get_pairs(const hsp_cells *cells, uint32_t first, uint32_t count,
                                             hsp_cell_pair *out);

/** Where the point xyz [3] lies: *cell becomes its cell, or HSP_NONE if it lies in a ball. Exact; the point is rounded
 *  to the lattice.
 *  Cost: O(1) for sets as in Theorem 2.1 in cubes that balls meet, O(log n) in others.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_NOT_FINITE  xyz holds a NaN or an infinity
 *  @retval HSP_E_RANGE       xyz lies beyond 2^50 lattice steps */
HSP_API int32_t HSP_CALL hsp_cells_locate(const hsp_cells *cells, const double *xyz, uint32_t *cell);

/** Check the invariants of computed cells. If all hold, *invariant becomes 0 and *id HSP_NONE. Else *invariant becomes
 *  the number of the first that is violated, and *id that of the cell or, for 4, of the cube concerned:
 *  1. runs come first, then the free parts of each ball in each cube
 *  2. neighbours ascend, no cell is its own, and of two cells both are neighbours of each other or none
 *  3. regions are the connected components of neighbours, numbered by their first cells
 *  4. every power cell, cut once more, is a polytope of which three planes meet in each vertex, with vertices - edges +
 *     facets = 2, and has as many free parts as there are cells of it
 *  5. across every piece of a facet of a cell that lies outside its ball there is a neighbour; and a cell has no other
 *     neighbours
 *  6. regions are as many as those of the complement in `topology`; not checked if that is NULL
 *
 *  Uses the cells' scratch memory, hence not const; results stay valid. Cost: about that of hsp_cells_compute.
 *  @retval HSP_OK          all hold
 *  @retval HSP_E_ARGUMENT  cells, invariant or id is NULL; a topology of another model
 *  @retval HSP_E_STATE     nothing computed, in the topology either, or the model has changed since
 *  @retval HSP_E_CHECK     one is violated: please report it */
HSP_API int32_t HSP_CALL hsp_cells_check(hsp_cells *cells, const hsp_topology *topology, uint32_t *invariant,
                                         uint32_t *id);

/** The numbers of vertices, edges and faces into which spheres cut each other; parts that balls cover count as well. A
 *  circle of two spheres that crosses no other is one edge, and a sphere that meets no other is one face. Frozen. */
typedef struct hsp_arrangement {
  uint64_t vertices; /**< where three spheres meet */
  uint64_t edges;    /**< on circles of two spheres */
  uint64_t faces;    /**< on spheres */
} hsp_arrangement;

/** How large the arrangement of all spheres is (Theorem 2.2), by exact counts and without storing it: *totals for all,
 *  of_ball [n] for each sphere; either may be NULL. scratch is memory of `words` numbers; *words_needed becomes how
 *  many suffice: twice the most balls that meet one ball.
 *  - Property 1: of all spheres together, vertices are 3 and edges 2 times those of *totals, and faces the same.
 *  - Property 2: the order of the balls has no effect but on the order of of_ball, unless balls are equal.
 *
 *  Cost: O(n) for sets as in Theorem 2.1; O(m^2) for a sphere that meets m others.
 *  @retval HSP_E_ARGUMENT  model is NULL; scratch is NULL with words above 0
 *  @retval HSP_E_CAPACITY  words is less than *words_needed; nothing else is written
 *  @retval HSP_E_STATE     hsp_model_set has failed
 *  @retval HSP_E_RANGE     a ball meets 2^31 others or more */
HSP_API int32_t HSP_CALL hsp_model_arrangement(const hsp_model *model, hsp_arrangement *totals,
                                               hsp_arrangement *of_ball, uint32_t *scratch, uint32_t words,
                                               uint32_t *words_needed);

#ifdef __cplusplus
}
#endif

#endif
