/* hardsphere/mesh.h: a surface as triangles, for programs that draw it or compute on it.
 *
 * Guide: smooth_surface.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * The triangles of a mesh form closed surfaces: every edge belongs to two triangles, which run through it in opposite
 * directions, and the triangles around a vertex form one ring. They run counter-clockwise seen from outside. Every
 * vertex lies on the surface up to rounding, and every triangle belongs to one patch. How the faces, arcs and vertices
 * hang together is the exact boundary's own: where a border is so thin that chords of its arcs would cross, these get
 * more points. Where no number of points tells borders apart, because they touch or run along each other, there are
 * triangles without area between them; vertices may lie in one place.
 *
 * Areas and volumes of a mesh are those of its triangles. They approach those of the surface with the square of
 * edge_length; hsp_boundary_measure and hsp_surface_measure have the exact ones.
 *
 * How flat triangles lie: on the smooth surface of crambin, probe 1.4, neighbours of one tangent plane differ by 80, 35
 * and 11 degrees at most with edges of 0.6, 0.3 and 0.15, by 18, 10 and 5 in the mean; the worst are next to cusps.
 *
 * There are meshes of a boundary, which is the van der Waals surface or with a probe the solvent-accessible one, and of
 * the smooth surface over it (surface.h). Either way triangles are in the order of their patches. */
#ifndef HARDSPHERE_MESH_H
#define HARDSPHERE_MESH_H

#include "executor.h"
#include "surface.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The triangles of a surface. */
typedef struct hsp_mesh hsp_mesh;

/** The limits that fix a mesh's memory. */
typedef struct hsp_mesh_limits {
  uint32_t struct_size; /**< sizeof(hsp_mesh_limits) */
  uint32_t balls;       /**< of the model; of a smooth surface, balls and vertices of the boundary */
  uint32_t curves;      /**< arcs and circles of the boundary; of a smooth surface, its edges */
  uint32_t vertices;    /**< of the mesh, with those that finer ones have replaced */
  uint32_t triangles;   /**< of the mesh, with those that finer ones have replaced */
  uint32_t points;      /**< most points of any one sphere while it is triangulated */
} hsp_mesh_limits;

/** Limits for a computed boundary and edges of about the given length that nearly always suffice.
 *  @retval HSP_E_ARGUMENT    limits or boundary is NULL; edge_length is not above 0
 *  @retval HSP_E_VERSION     struct_size is bad
 *  @retval HSP_E_NOT_FINITE  edge_length is NaN or infinite
 *  @retval HSP_E_RANGE       there would be more than HSP_MAX_BALLS of something
 *  @retval HSP_E_STATE       the boundary holds no results, or its model has changed since */
HSP_API int32_t HSP_CALL hsp_mesh_limits_init(hsp_mesh_limits *limits, uint32_t struct_size,
                                              const hsp_boundary *boundary, double edge_length);

/** The same for a computed smooth surface.
 *  @retval HSP_E_ARGUMENT      limits or surface is NULL; edge_length is not above 0
 *  @retval HSP_E_VERSION       struct_size is bad
 *  @retval HSP_E_NOT_FINITE    edge_length is NaN or infinite
 *  @retval HSP_E_RANGE         there would be more than HSP_MAX_BALLS of something
 *  @retval HSP_E_STATE         the surface holds no results, or its model or boundary has changed since */
HSP_API int32_t HSP_CALL hsp_mesh_limits_init_surface(hsp_mesh_limits *limits, uint32_t struct_size,
                                                      const hsp_surface *surface, double edge_length);

/** Bytes that hsp_mesh_init needs.
 *  - Property 1: at most HSP_MESH_BYTES of the five limits.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_mesh_bytes(const hsp_mesh_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_MESH_BYTES(balls, curves, vertices, triangles, points)                                                 \
  ((size_t)4096 + (size_t)16 * (size_t)(balls) + (size_t)32 * (size_t)(curves) + (size_t)64 * (size_t)(vertices) + \
   (size_t)32 * (size_t)(triangles) + (size_t)384 * (size_t)(points))

/** Make an empty mesh in caller memory of any alignment; sets *mesh.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_mesh_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_mesh_init(void *memory, size_t bytes, const hsp_mesh_limits *limits, hsp_mesh **mesh);

/** Triangles for a computed boundary, with edges of about the given length: the van der Waals surface, or with a probe
 *  the solvent-accessible one. Edges have that length in the mean; one of a hundred is longer than 1.7 times, the
 *  longest, beside borders, up to some 2.5 times. They are shorter where the surface has shorter arcs or curves that
 *  are close to each other. Boundary and model must outlive the mesh, which can be read while these hold the same
 *  (RESULTS in hardsphere.h). On failure it holds no results. limits: see LIMITS in hardsphere.h; at most twenty
 *  retries.
 *  - Property 1: the triangles are closed surfaces as described above, and the number of vertices less half that of
 *    triangles is the Euler characteristic of hsp_boundary_get_counts, or the status says that there are none.
 *  - Property 2: the same model, boundary and edge_length yield the same bytes on every machine.
 *
 *  Cost: O(m + p log p) for m vertices, some 1.2 for each area of edge_length^2, and p on the sphere that has most of
 *  them. Where patches are far smaller than their spheres, also what it takes to look at points of edge_length all over
 *  the belt of each sphere, between two circles of latitude, that its patches lie in.
 *  @retval HSP_E_ARGUMENT    mesh or boundary is NULL; edge_length is not above 0
 *  @retval HSP_E_VERSION     bad struct_size of limits
 *  @retval HSP_E_NOT_FINITE  edge_length is NaN or infinite
 *  @retval HSP_E_RANGE       there would be more than HSP_MAX_BALLS of something; or edge_length is less than 1/4288 of
 *                            the radius of a sphere that a patch lies on
 *  @retval HSP_E_CAPACITY    a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE       the boundary holds no results, or its model has changed since
 *  @retval HSP_E_DEGENERATE  borders on one sphere lie on each other along a curve, up to rounding, so that nothing
 *                            tells which is on which side: more than two of them, or with different points. Among
 *                            thousands of degenerate sets of radii of one size there is none; of sets with radii of
 *                            1 to 3 on one of 10^6 some 8 of 100 are so */
HSP_API int32_t HSP_CALL hsp_mesh_compute(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length,
                                          hsp_mesh_limits *limits);

/** Triangles for a computed smooth surface, with edges of about the given length. Everything else is as for a
 *  boundary, which must outlive the mesh with its model; the surface need not. Without a probe the smooth surface is
 *  the boundary, and so are its triangles. After hsp_surface_compute_shells they are those of the chosen part alone.
 *  - Property 1: the triangles are closed surfaces, and the number of vertices less half that of triangles is the sum
 *    of hsp_surface_shell.euler over the chosen shells, or the status says that there are none.
 *  - Property 2: the same model, boundary and edge_length yield the same bytes on every machine.
 *
 *  @retval HSP_E_ARGUMENT      mesh or surface is NULL; edge_length is not above 0
 *  @retval HSP_E_VERSION       bad struct_size of limits
 *  @retval HSP_E_NOT_FINITE    edge_length is NaN or infinite
 *  @retval HSP_E_RANGE         there would be more than HSP_MAX_BALLS of something; or edge_length is less than 1/4288
 *                              of the radius of a sphere that a patch lies on
 *  @retval HSP_E_CAPACITY      a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE         the surface holds no results, or its model or boundary has changed since
 *  @retval HSP_E_DEGENERATE    borders touch or lie on each other, as for a boundary, around a patch that has an area:
 *                              of 37 families of sets full of ties at most 1 of 100, of most of them none */
HSP_API int32_t HSP_CALL hsp_mesh_compute_surface(hsp_mesh *mesh, const hsp_surface *surface, double edge_length,
                                                  hsp_mesh_limits *limits);

/** How triangles are computed. Zero means default in every field but the first. */
typedef struct hsp_mesh_request {
  uint32_t struct_size;         /**< sizeof(hsp_mesh_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: whether to go on is asked of it; its threads share nothing yet */
} hsp_mesh_request;

/** The same as hsp_mesh_compute, as a request says; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT    mesh or boundary is NULL; edge_length is not above 0; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY    as hsp_mesh_compute
 *  @retval HSP_E_STATE       as hsp_mesh_compute
 *  @retval HSP_E_NOT_FINITE  edge_length is NaN or infinite
 *  @retval HSP_E_RANGE       as hsp_mesh_compute
 *  @retval HSP_E_DEGENERATE  as hsp_mesh_compute
 *  @retval HSP_E_STOPPED     the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_mesh_compute_with(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length,
                                               const hsp_mesh_request *request, hsp_mesh_limits *limits);

/** The same as hsp_mesh_compute_surface, as a request says; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT      mesh or surface is NULL; edge_length is not above 0; an executor with several workers
 *                              and without run
 *  @retval HSP_E_VERSION       bad struct_size of request, executor or limits, or reserved is not 0
 *  @retval HSP_E_CAPACITY      as hsp_mesh_compute_surface
 *  @retval HSP_E_STATE         as hsp_mesh_compute_surface
 *  @retval HSP_E_NOT_FINITE    edge_length is NaN or infinite
 *  @retval HSP_E_RANGE         as hsp_mesh_compute_surface
 *  @retval HSP_E_DEGENERATE    as hsp_mesh_compute_surface
 *  @retval HSP_E_STOPPED       the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_mesh_compute_surface_with(hsp_mesh *mesh, const hsp_surface *surface, double edge_length,
                                                       const hsp_mesh_request *request, hsp_mesh_limits *limits);

/** How many of everything. Frozen. */
typedef struct hsp_mesh_counts {
  uint32_t vertices;  /**< of the triangles */
  uint32_t triangles; /**< of the mesh */
  uint32_t curves;    /**< arcs and circles of the boundary; edges of the smooth surface */
  uint32_t refined;   /**< of these, those that got more points than their length demands */
} hsp_mesh_counts;

/** How many vertices and triangles there are.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_counts(const hsp_mesh *mesh, hsp_mesh_counts *counts);

/** The vertices, which also serve as points all over the surface (but see hsp_mesh_get_weights for what they are not
 *  fit for): positions, normals, areas and balls. Each of xyz [vertices][3], normals [vertices][3], areas [vertices]
 *  and balls [vertices] may be NULL, else capacity >= vertices; needed may be NULL and else becomes their number.
 *  normals have length 1 and point outward; on a border, where the patches that meet have one each, it is the direction
 *  of their sum. areas: a third of all triangles around a vertex. balls: in the caller's order, the ball that the
 *  vertex lies on, on a border of a boundary the first of them; of a smooth surface, as those of triangles.
 *  - Property 1: the areas sum to the area of the mesh, up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  mesh is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is too small; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_vertices(const hsp_mesh *mesh, double *xyz, double *normals, double *areas,
                                               uint32_t *balls, uint32_t capacity, uint32_t *needed);

/** Weights of the vertices for sums over the surface, such as the mean of something at its points: areas as above, but
 *  those of a patch's triangles are scaled so that they sum to its exact area. area [patches] has these: of
 *  hsp_boundary_measure_faces, or hsp_surface_patch.area. A patch without triangles has no part in them.
 *  weights [vertices].
 *  - Property 1: the weights sum to the areas of all patches with triangles, up to rounding.
 *
 *  Points and weights are those of one geometry, for energies and pictures of it. They have no derivatives. When atoms
 *  move, points appear and vanish, and a sum over them jumps by a part of a weight: in continuum electrostatics by some
 *  1e-5 of the energy. For forces, optimisation and molecular dynamics they are not fit; areas and volumes themselves
 *  have exact gradients (gradient.h, surface.h).
 *  @retval HSP_E_ARGUMENT    mesh or area is NULL; weights is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than *needed, the number of vertices
 *  @retval HSP_E_STATE       nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID          a patch with triangles is none of those of area
 *  @retval HSP_E_NOT_FINITE  an area is NaN or infinite */
HSP_API int32_t HSP_CALL hsp_mesh_get_weights(const hsp_mesh *mesh, const double *area, uint32_t patches,
                                              double *weights, uint32_t capacity, uint32_t *needed);

/** The triangles: the numbers of their vertices, and what each belongs to. Each of
 *  corners [triangles][3], kinds [triangles], patches [triangles] and balls [triangles] may be NULL, else capacity >=
 *  triangles; needed may be NULL and else becomes their number. kinds: HSP_PATCH_CONVEX for all of a boundary. patches:
 *  the number of the face, of a smooth surface that of its patch; ascending. balls: in the caller's order, the ball of
 *  a convex patch; on a saddle patch the one on whose side of the narrowest place the triangle lies; on a concave patch
 *  the one that the probe touches nearest to it.
 *  @retval HSP_E_ARGUMENT  mesh is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is too small; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_triangles(const hsp_mesh *mesh, uint32_t *corners, uint32_t *kinds,
                                                uint32_t *patches, uint32_t *balls, uint32_t capacity,
                                                uint32_t *needed);

/** The triangles of one patch: *first .. *first + *count - 1; *count becomes 0 if it has none.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_patch(const hsp_mesh *mesh, uint32_t patch, uint32_t *first, uint32_t *count);

#ifdef __cplusplus
}
#endif

#endif
