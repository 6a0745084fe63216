/* The triangles of a computed boundary or smooth surface, in memory of their own, and whether they are closed. */
#pragma once

#include "surface_result.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mesh_result {
  const computed *base;       /* what it was computed from; must outlive it */
  const hsp_surface *surface; /* over that; NULL if the triangles are the boundary's */
  double edge;
  void *memory;
  hsp_mesh *mesh;
  hsp_mesh_limits needed; /* exactly */
  uint32_t enlargements;  /* how often limits had to be raised, starting from as many vertices as balls */
  hsp_mesh_counts counts;
  double (*xyz)[3], (*normals)[3], *areas;          /* [vertices] */
  uint32_t *vertex_balls;                           /* [vertices] */
  uint32_t (*corners)[3], *kinds, *patches, *balls; /* [triangles] */
} mesh_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * mesh_result_release in either case. */
int32_t mesh_result_make(const computed *base, double edge, mesh_result *result);
int32_t mesh_result_make_surface(const surface_result *base, double edge, mesh_result *result);

void mesh_result_release(mesh_result *result);

/* How such handles are made; they are computed from a `mesh_result` of which base, surface and edge are used. */
extern const handle_kind mesh_handle;

/* The first fault of the triangles as a closed and oriented surface: an edge that is not in two triangles in opposite
 * directions, a vertex whose triangles are not one ring, a number out of range. NULL if there is none. */
const char *mesh_fault(const mesh_result *mesh);

/* The volume that the triangles enclose: the sum of the tetrahedra with `about` as apex. */
double mesh_volume(const mesh_result *mesh, const double about[3]);
double mesh_area(const mesh_result *mesh);

#ifdef __cplusplus
}
#endif
