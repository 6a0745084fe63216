/* hardsphere/mesh.h: a boundary or a smooth surface as triangles, for programs that draw it or compute on it.
 *
 * Guide: smooth_surface.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * The triangles of a mesh form closed surfaces: every edge belongs to two triangles, which run through it in opposite
 * directions, and the triangles around a vertex form one ring. Corners of a triangle are in counter-clockwise order
 * seen from outside. Every vertex lies on the surface up to rounding, and every triangle belongs to one patch. Faces,
 * arcs and vertices hang together as in the exact boundary: where a face is so thin that chords of its arcs would
 * cross, these arcs get more points. Where no number of points separates borders, because they touch or run along each
 * other, there are triangles without area between them; vertices may lie in one place.
 *
 * Areas and volumes of a mesh are those of its triangles. Their error falls with the square of edge_length;
 * hsp_boundary_measure and hsp_surface_measure have the exact ones.
 *
 * Angles between triangles: on the smooth surface of crambin, probe 1.4, neighbouring triangles of one tangent plane
 * differ by 80, 35 and 11 degrees at most with edges of 0.6, 0.3 and 0.15, and by 18, 10 and 5 degrees in the mean; the
 * largest angles are next to cusps.
 *
 * There are meshes of a boundary, which is the van der Waals surface or with a probe the solvent-accessible one, and of
 * the smooth surface over it (surface.h). In both triangles are in the order of their patches: faces of the boundary,
 * or patches of the smooth surface. */
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
  uint32_t balls;       /**< balls of the model; of a smooth surface, balls and vertices of the boundary */
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

/** The same as hsp_mesh_limits_init, for a computed smooth surface.
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

/** Triangles for a computed boundary, with edges of about edge_length, a length: the van der Waals surface, or with a
 *  probe the solvent-accessible one. Edges have that length in the mean; one of a hundred is longer than 1.7 times
 *  edge_length, and the longest, beside borders, have some 2.5 times edge_length. Edges are shorter where the surface
 *  has shorter arcs or curves that are close to each other. Boundary and model must outlive the mesh; the mesh can be
 *  read while boundary and model hold the same (RESULTS in hardsphere.h). On failure the mesh holds no results. limits:
 *  see LIMITS in hardsphere.h; at most twenty retries.
 *  - Property 1: the triangles are closed surfaces as described above, and the number of vertices less half that of
 *    triangles is the Euler characteristic of hsp_boundary_get_counts, or the status says that there are none.
 *  - Property 2: the same model, boundary and edge_length yield the same bytes on every machine.
 *
 *  Cost: O(m + p log p) for m vertices, some 1.2 for each area of edge_length^2, with p of them on the sphere that has
 *  most. Where patches are far smaller than their spheres, also the time to look at points, edge_length apart, all over
 *  the belt of each sphere, between two circles of latitude, that its patches lie in.
 *  @retval HSP_E_ARGUMENT    mesh or boundary is NULL; edge_length is not above 0
 *  @retval HSP_E_VERSION     bad struct_size of limits
 *  @retval HSP_E_NOT_FINITE  edge_length is NaN or infinite
 *  @retval HSP_E_RANGE       there would be more than HSP_MAX_BALLS of something; or edge_length is less than 1/4288 of
 *                            the radius of a sphere that a patch lies on
 *  @retval HSP_E_CAPACITY    a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_STATE       the boundary holds no results, or its model has changed since
 *  @retval HSP_E_DEGENERATE  more than two borders on one sphere, or borders with different points, coincide along a
 *                            curve up to rounding, so that nothing tells which is on which side. Thousands of
 *                            degenerate sets with radii of one size have no such case; of sets with radii 1 to 3 on a
 *                            ball of radius 10^6 some 8 of 100 have one */
HSP_API int32_t HSP_CALL hsp_mesh_compute(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length,
                                          hsp_mesh_limits *limits);

/** Triangles for a computed smooth surface, with edges of about edge_length, a length. Everything else is as in
 *  hsp_mesh_compute. Boundary and model must outlive the mesh; the surface need not. Without a probe the smooth surface
 *  is the boundary, and the triangles are the boundary's. After hsp_surface_compute_shells they are those of the chosen
 *  part alone.
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
 *  @retval HSP_E_DEGENERATE    borders touch or coincide, as for a boundary, around a patch that has an area: in each
 *                              of 37 families of sets full of ties at most 1 of 100 sets, in most families none */
HSP_API int32_t HSP_CALL hsp_mesh_compute_surface(hsp_mesh *mesh, const hsp_surface *surface, double edge_length,
                                                  hsp_mesh_limits *limits);

/** How triangles are computed. Zero means default in every field but the first. */
typedef struct hsp_mesh_request {
  uint32_t struct_size;         /**< sizeof(hsp_mesh_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_mesh_request;

/** The same as hsp_mesh_compute, with an executor that may stop it; request may be NULL: all defaults.
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

/** The same as hsp_mesh_compute_surface, with an executor that may stop it; request may be NULL: all defaults.
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
  uint32_t refined;   /**< curves that got more points than their length demands */
} hsp_mesh_counts;

/** How many vertices and triangles there are.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_counts(const hsp_mesh *mesh, hsp_mesh_counts *counts);

/** The vertices: positions, normals, areas and balls. They also serve as points all over the surface
 *  (hsp_mesh_get_weights says for which purposes not). Each of xyz [vertices][3], normals [vertices][3], areas
 *  [vertices] and balls [vertices] may be NULL, else capacity >= vertices; needed may be NULL and else becomes the
 *  number of vertices. normals have length 1 and point outward; on a border it is the direction of the sum of the
 *  normals of the patches that meet. areas: a third of the area of all triangles around a vertex. balls: in the
 *  caller's order, the ball that the vertex lies on, on a border of a boundary the first such ball; of a smooth
 *  surface, as in hsp_mesh_get_triangles.
 *  - Property 1: the areas sum to the area of the mesh, up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  mesh is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is too small; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_vertices(const hsp_mesh *mesh, double *xyz, double *normals, double *areas,
                                               uint32_t *balls, uint32_t capacity, uint32_t *needed);

/** Weights of the vertices for sums over the surface, such as the mean of a quantity at its points: areas as above, but
 *  the areas of a patch's triangles are scaled so that they sum to the patch's exact area. area [patches] holds these
 *  exact areas, those of hsp_boundary_measure_faces, or hsp_surface_patch.area. If all triangles of a patch have area 0
 *  they get equal parts; a patch without triangles adds nothing. weights [vertices].
 *  - Property 1: the weights sum to the areas of all patches with triangles, up to rounding.
 *
 *  Points and weights are for energies and pictures of one fixed geometry. They have no derivatives. When atoms move,
 *  points appear and vanish, and a sum over them jumps by a part of a weight: in continuum electrostatics by some 1e-5
 *  of the energy. So they do not suit forces, optimisation and molecular dynamics. Areas and volumes themselves have
 *  exact gradients (gradient.h, surface.h).
 *  @retval HSP_E_ARGUMENT    mesh or area is NULL; weights is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than *needed, the number of vertices
 *  @retval HSP_E_STATE       nothing computed, or model or boundary changed since
 *  @retval HSP_E_ID          a patch with triangles has a number of `patches` or more
 *  @retval HSP_E_NOT_FINITE  an area is NaN or infinite */
HSP_API int32_t HSP_CALL hsp_mesh_get_weights(const hsp_mesh *mesh, const double *area, uint32_t patches,
                                              double *weights, uint32_t capacity, uint32_t *needed);

/** The triangles: the numbers of their vertices, and the patch and ball of each. Each of corners [triangles][3], kinds
 *  [triangles], patches [triangles] and balls [triangles] may be NULL, else capacity >= triangles; needed may be NULL
 *  and else becomes the number of triangles. kinds: HSP_PATCH_*; of a boundary always HSP_PATCH_CONVEX. patches: the
 *  number of the face, or of the patch of a smooth surface; ascending. balls: in the caller's order, the ball of a
 *  convex patch; on a saddle patch the ball on whose side of the narrowest place the triangle lies; on a concave patch
 *  the ball that the probe touches nearest to the triangle.
 *  @retval HSP_E_ARGUMENT  mesh is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity is too small; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_triangles(const hsp_mesh *mesh, uint32_t *corners, uint32_t *kinds,
                                                uint32_t *patches, uint32_t *balls, uint32_t capacity,
                                                uint32_t *needed);

/** The numbers of the triangles of one patch: *first .. *first + *count - 1; *count becomes 0 if it has none.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed, or model or boundary changed since */
HSP_API int32_t HSP_CALL hsp_mesh_get_patch(const hsp_mesh *mesh, uint32_t patch, uint32_t *first, uint32_t *count);

#ifdef __cplusplus
}
#endif

#endif
