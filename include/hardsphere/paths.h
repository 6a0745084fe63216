/* hardsphere/paths.h: paths of a point, the centre of a probe, through free space (Section 2, Theorem 2.4).
 *
 * Guide: questions.md, coming_from.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * Free space is what no ball covers. The probe is that of hsp_model_options: paths are those of its centre. Whether
 * there is a path is decided in integers, as everything combinatorial is; balls that touch count as meeting, so that
 * nothing passes between them.
 *
 *   path   a polyline between lattice points, found from cell to cell of free space and then shortened; it need not be
 *          the shortest path. It is certified if a test in integers shows for every segment that it meets no ball
 *
 * hsp_pores_widest (pores.h) tells how wide a probe can be to get from one point to another, and what stops a wider
 * one. */
#ifndef HARDSPHERE_PATHS_H
#define HARDSPHERE_PATHS_H

#include "cells.h"
#include "model.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Paths through the free space of a model. */
typedef struct hsp_paths hsp_paths;

/** The limits that fix the memory of paths: those of cells, and points. */
typedef struct hsp_paths_limits {
  uint32_t struct_size;  /**< sizeof(hsp_paths_limits) */
  uint32_t cubes;        /**< as hsp_cells_limits.cubes */
  uint32_t entries;      /**< as hsp_cells_limits.entries */
  uint32_t cells;        /**< as hsp_cells_limits.cells */
  uint32_t adjacencies;  /**< as hsp_cells_limits.adjacencies */
  uint32_t landmarks;    /**< as hsp_cells_limits.landmarks */
  uint32_t facets;       /**< as hsp_cells_limits.facets */
  uint32_t corners;      /**< as hsp_cells_limits.corners */
  uint32_t cube_balls;   /**< as hsp_cells_limits.cube_balls */
  uint32_t cube_corners; /**< as hsp_cells_limits.cube_corners */
  uint32_t points;       /**< points of a path before it is shortened */
} hsp_paths_limits;

/** Limits that suffice for most molecules of `balls` atoms, about 9 kB for each: those of hsp_cells_limits_init, and
 *  points 4 balls + 1024.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 2048) / 80 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_paths_limits_init(hsp_paths_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_paths_init needs.
 *  - Property 1: at most HSP_PATHS_BYTES of the limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_paths_bytes(const hsp_paths_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_PATHS_BYTES(cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, cube_corners,  \
                        points)                                                                                    \
  ((size_t)32768 + (size_t)128 * (size_t)(cubes) + (size_t)8 * (size_t)(entries) + (size_t)136 * (size_t)(cells) + \
   (size_t)48 * (size_t)(adjacencies) + (size_t)12 * (size_t)(landmarks) + (size_t)72 * (size_t)(facets) +         \
   (size_t)48 * (size_t)(corners) + (size_t)2304 * (size_t)(cube_balls) + (size_t)64 * (size_t)(cube_corners) +    \
   (size_t)24 * (size_t)(points))

/** Make paths without results in caller memory of any alignment; sets *paths.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_paths_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, the size does not fit a size_t, or an array in it
 *                          would have 2^32 items or more */
HSP_API int32_t HSP_CALL hsp_paths_init(void *memory, size_t bytes, const hsp_paths_limits *limits, hsp_paths **paths);

/** Cut the free space of a model into cells, so that paths can be found. The model must outlive the paths; the paths
 *  can be read while the model holds the same balls (RESULTS in hardsphere.h). On failure they hold no results. limits:
 *  see LIMITS in hardsphere.h; at most six retries. On HSP_OK limits->points becomes 0: how many points are needed
 *  depends on the path.
 *
 *  Cost: that of hsp_cells_compute.
 *  @retval HSP_E_ARGUMENT  paths or model is NULL
 *  @retval HSP_E_VERSION   bad struct_size of limits
 *  @retval HSP_E_CAPACITY  a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE     hsp_model_set has failed
 *  @retval HSP_E_CHECK     cells contradict each other, which cannot happen: please report it */
HSP_API int32_t HSP_CALL hsp_paths_compute(hsp_paths *paths, const hsp_model *model, hsp_paths_limits *limits);

/** How paths are computed and found. Zero means default in every field but the first. */
typedef struct hsp_paths_request {
  uint32_t struct_size;         /**< sizeof(hsp_paths_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_paths_request;

/** The same as hsp_paths_compute, with an executor that may stop it; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  paths or model is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY  as hsp_paths_compute
 *  @retval HSP_E_STATE     as hsp_paths_compute
 *  @retval HSP_E_CHECK     as hsp_paths_compute
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_paths_compute_with(hsp_paths *paths, const hsp_model *model,
                                                const hsp_paths_request *request, hsp_paths_limits *limits);

#define HSP_PATH_CONNECTED UINT32_C(0) /**< there is a path */
#define HSP_PATH_APART UINT32_C(1)     /**< the ends lie in two regions of free space */
#define HSP_PATH_COVERED UINT32_C(2)   /**< at least one of the ends lies in a ball */

/** A path. Frozen. */
typedef struct hsp_path {
  double length;      /**< of the polyline, length; 0 if there is none */
  double clearance;   /**< least distance of the polyline from a ball; 0 if there is none, infinite without balls */
  uint32_t ends;      /**< HSP_PATH_*, exactly */
  uint32_t certified; /**< whether no segment meets a ball, exactly: 1 or 0 */
  uint32_t points;    /**< how many, both ends included: 2 or more; 0 if there is none */
  uint32_t reserved;  /**< 0 */
} hsp_path;

/** Find a path between two points, from [3] and to [3], after hsp_paths_compute; they are rounded to the lattice. Its
 *  points stay until the next call; on failure there are none. limits, if not NULL, become what was needed for cells
 *  and path, or limits to retry with in a new handle: their struct_size has to be set.
 *  - Property 1: there is a path if and only if hsp_cells_locate puts both points into one region.
 *  - Property 2: a path that is not certified meets a ball because its points are rounded to the lattice. It does so a
 *    few lattice steps deep, in a passage that is a few steps wide.
 *
 *  Cost: O(c log c) for the c cells that A* looks at, and O(n) for each of the points that remain.
 *  @retval HSP_E_ARGUMENT    paths, from, to or path is NULL
 *  @retval HSP_E_VERSION     bad struct_size of limits
 *  @retval HSP_E_CAPACITY    limits.points is too small; the paths keep their cells
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_CHECK       cells contradict each other, which cannot happen: please report it
 *  @retval HSP_E_NOT_FINITE  a point holds a NaN or an infinity
 *  @retval HSP_E_RANGE       a point lies beyond 2^50 lattice steps */
HSP_API int32_t HSP_CALL hsp_paths_find(hsp_paths *paths, const double *from, const double *to, hsp_path *path,
                                        hsp_paths_limits *limits);

/** The same as hsp_paths_find, with an executor that may stop it; request may be NULL: all defaults. Where it is
 *  stopped there is no path, and the paths keep their cells.
 *  @retval HSP_E_ARGUMENT    paths, from, to or path is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY    as hsp_paths_find
 *  @retval HSP_E_STATE       as hsp_paths_find
 *  @retval HSP_E_CHECK       as hsp_paths_find
 *  @retval HSP_E_NOT_FINITE  as hsp_paths_find
 *  @retval HSP_E_RANGE       as hsp_paths_find
 *  @retval HSP_E_STOPPED     the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_paths_find_with(hsp_paths *paths, const double *from, const double *to,
                                             const hsp_paths_request *request, hsp_path *path,
                                             hsp_paths_limits *limits);

/** The points [needed][3] of the last path, from its start to its end, length; none if there was no path.
 *  @retval HSP_E_ARGUMENT  paths is NULL; points is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed, the number of points
 *  @retval HSP_E_STATE     nothing computed, or the model has changed since */
HSP_API int32_t HSP_CALL hsp_paths_get_points(const hsp_paths *paths, double *points, uint32_t capacity,
                                              uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
