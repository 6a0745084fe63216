/* A handle of each of several kinds over one small set of balls, and copies of what they hold, to be compared before
 * and after a call. */
#pragma once

#include <hardsphere.h>

enum { BALLS = 4, FEW = 1, VERTICES = 8, EDGES = 64, ARCS = 64, SIZE = 65536 };

/* Three balls that have two vertices in common, and a fourth ball apart. */
extern const double four_xyz[3 * BALLS];
extern const double four_radius[BALLS];
extern const double four_inside[3]; /* a point that three of them contain */

/* The handles and their memory, SIZE bytes each. */
typedef struct four_handles {
  hsp_model *model;
  hsp_boundary *boundary;
  hsp_topology *topology;
  hsp_view *view;
  hsp_map *map;
  void *model_memory, *boundary_memory, *topology_memory, *view_memory, *map_memory;
} four_handles;

/* Limits that suffice for all balls or, if `balls` is FEW, for that many. */
hsp_boundary_limits four_boundary_limits(uint32_t balls);
hsp_topology_limits four_topology_limits(uint32_t balls);
hsp_view_limits four_view_limits(uint32_t balls);
hsp_map_limits four_map_limits(uint32_t balls);

/* Empty handles: model and boundary have room for all balls, the others for `balls`. All calls use the same memory. */
four_handles four_handles_make(uint32_t balls);

/* Sets the model to the first balls. */
void four_handles_set(const four_handles *h, uint32_t balls);

/* Sets the model to all balls and computes everything, which must succeed. */
void four_handles_compute(const four_handles *h);

/* The contents of a model. */
typedef struct model_contents {
  hsp_model_info info;
  uint32_t hits[BALLS], neighbours[BALLS], hit_count;
  int32_t status, neighbours_status; /* of these two questions */
} model_contents;

model_contents contents_of_model(const hsp_model *model);

/* A surface and a mesh over the boundary of the set: the surface has room for `balls`, the mesh for all of them with
 * edges of length 2 but not for much shorter edges. Every call uses the same memory, FIFTH_SIZE bytes each. */
enum { FIFTH_SIZE = 1 << 17, POINTS = 300 };
typedef struct fifth_handles {
  hsp_surface *surface;
  hsp_mesh *mesh;
  void *surface_memory, *mesh_memory;
} fifth_handles;
hsp_surface_limits four_surface_limits(uint32_t balls);
hsp_mesh_limits four_mesh_limits(void);
fifth_handles fifth_handles_make(uint32_t balls);

/* The contents of a handle of any other kind: the status of reading it, and the counts and records that were read. */
typedef struct contents {
  union {
    hsp_boundary_counts boundary;
    hsp_topology_counts topology;
    hsp_view_info view;
    hsp_map_info map;
    hsp_surface_part_counts surface;
    hsp_mesh_counts mesh;
  } counts;
  union {
    hsp_vertex vertices[VERTICES];
    hsp_topology_edge edges[EDGES];
    hsp_view_arc arcs[ARCS];
    hsp_map_edge map_edges[EDGES];
    hsp_surface_edge surface_edges[EDGES];
    double points[POINTS][3];
  } records;
  int32_t status;
} contents;

contents contents_of_boundary(const hsp_boundary *boundary);
contents contents_of_topology(const hsp_topology *topology);
contents contents_of_view(const hsp_view *view);
contents contents_of_map(const hsp_map *map);
contents contents_of_surface(const hsp_surface *surface);
contents contents_of_mesh(const hsp_mesh *mesh);

void check_status(contents read, int32_t status);
void check_same_contents(const contents *a, contents b);
