#include "four_handles.h"

#include <string.h>

#include "check.h"

const double four_xyz[3 * BALLS] = {0, 0, 0, 2, 0, 0, 1, 1.5, 0, 9, 0, 0};
const double four_radius[BALLS] = {1.5, 1.5, 1.25, 1};
const double four_inside[3] = {1, 0.5, 0};

static unsigned char memory[5][SIZE];
static unsigned char fifth_memory[2][FIFTH_SIZE];

hsp_boundary_limits four_boundary_limits(uint32_t balls) {
  hsp_boundary_limits limits;
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, balls), HSP_OK);
  limits.vertices = balls == BALLS ? VERTICES : 0;
  return limits;
}

hsp_topology_limits four_topology_limits(uint32_t balls) {
  hsp_topology_limits limits = {(uint32_t)sizeof limits, balls, balls, EDGES, 16, 0};
  if (balls != BALLS) limits.edges = 2;
  return limits;
}

hsp_view_limits four_view_limits(uint32_t balls) {
  hsp_view_limits limits;
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, balls), HSP_OK);
  limits.arcs = balls == BALLS ? ARCS : 2;
  return limits;
}

hsp_surface_limits four_surface_limits(uint32_t balls) {
  const hsp_surface_limits limits = {(uint32_t)sizeof limits, balls == BALLS ? VERTICES : 0, 16, BALLS, 8, 32, 4};
  return limits;
}

hsp_mesh_limits four_mesh_limits(void) {
  const hsp_mesh_limits limits = {(uint32_t)sizeof limits, 16, EDGES, POINTS, 2 * POINTS, 128};
  return limits;
}

fifth_handles fifth_handles_make(uint32_t balls) {
  const hsp_surface_limits of_surface = four_surface_limits(balls);
  const hsp_mesh_limits of_mesh = four_mesh_limits();
  fifth_handles h;
  h.surface_memory = fifth_memory[0];
  h.mesh_memory = fifth_memory[1];
  CHECK_EQUAL(hsp_surface_init(h.surface_memory, FIFTH_SIZE, &of_surface, &h.surface), HSP_OK);
  CHECK_EQUAL(hsp_mesh_init(h.mesh_memory, FIFTH_SIZE, &of_mesh, &h.mesh), HSP_OK);
  return h;
}

hsp_map_limits four_map_limits(uint32_t balls) {
  const hsp_map_limits limits = {(uint32_t)sizeof limits, balls, balls, balls == BALLS ? EDGES : 1};
  return limits;
}

four_handles four_handles_make(uint32_t balls) {
  const hsp_boundary_limits of_boundary = four_boundary_limits(BALLS);
  const hsp_topology_limits of_topology = four_topology_limits(balls);
  const hsp_view_limits of_view = four_view_limits(balls);
  const hsp_map_limits of_map = four_map_limits(balls);
  four_handles h;
  h.model_memory = memory[0];
  h.boundary_memory = memory[1];
  h.topology_memory = memory[2];
  h.view_memory = memory[3];
  h.map_memory = memory[4];
  CHECK_EQUAL(hsp_model_init(h.model_memory, SIZE, BALLS, &h.model), HSP_OK);
  CHECK_EQUAL(hsp_boundary_init(h.boundary_memory, SIZE, &of_boundary, &h.boundary), HSP_OK);
  CHECK_EQUAL(hsp_topology_init(h.topology_memory, SIZE, &of_topology, &h.topology), HSP_OK);
  CHECK_EQUAL(hsp_view_init(h.view_memory, SIZE, &of_view, &h.view), HSP_OK);
  CHECK_EQUAL(hsp_map_init(h.map_memory, SIZE, &of_map, &h.map), HSP_OK);
  return h;
}

void four_handles_set(const four_handles *h, uint32_t balls) {
  CHECK_EQUAL(hsp_model_set(h->model, balls, four_xyz, four_radius, NULL, NULL), HSP_OK);
}

void four_handles_compute(const four_handles *h) {
  four_handles_set(h, BALLS);
  CHECK_EQUAL(hsp_boundary_compute(h->boundary, h->model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(h->topology, h->boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_compute(h->view, h->model, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_map_compute(h->map, h->model, NULL, NULL), HSP_OK);
  check_status(contents_of_boundary(h->boundary), HSP_OK);
  check_status(contents_of_topology(h->topology), HSP_OK);
  check_status(contents_of_view(h->view), HSP_OK);
  check_status(contents_of_map(h->map), HSP_OK);
}

model_contents contents_of_model(const hsp_model *model) {
  model_contents read;
  uint32_t count = 0;
  memset(&read, 0, sizeof read);
  CHECK_EQUAL(hsp_model_get_info(model, &read.info), HSP_OK);
  read.status = hsp_query_point(model, four_inside, read.hits, BALLS, &read.hit_count);
  read.neighbours_status = hsp_query_neighbours(model, 0, read.neighbours, BALLS, &count);
  return read;
}

contents contents_of_boundary(const hsp_boundary *boundary) {
  contents read;
  uint32_t count;
  memset(&read, 0, sizeof read);
  read.status = hsp_boundary_get_counts(boundary, &read.counts.boundary);
  CHECK_EQUAL(hsp_boundary_get_vertices(boundary, read.records.vertices, VERTICES, &count), read.status);
  return read;
}

contents contents_of_topology(const hsp_topology *topology) {
  contents read;
  memset(&read, 0, sizeof read);
  read.status = hsp_topology_get_counts(topology, &read.counts.topology);
  CHECK_EQUAL(hsp_topology_get_edges(topology, 0, read.counts.topology.edges, read.records.edges), read.status);
  return read;
}

contents contents_of_view(const hsp_view *view) {
  contents read;
  uint32_t count;
  memset(&read, 0, sizeof read);
  read.status = hsp_view_get_info(view, &read.counts.view);
  CHECK_EQUAL(hsp_view_get_arcs(view, read.records.arcs, ARCS, &count), read.status);
  return read;
}

contents contents_of_surface(const hsp_surface *surface) {
  contents read;
  memset(&read, 0, sizeof read);
  read.status = hsp_surface_get_part_counts(surface, &read.counts.surface);
  CHECK_EQUAL(hsp_surface_get_edges(surface, 0, read.counts.surface.edges, read.records.surface_edges), read.status);
  return read;
}

contents contents_of_mesh(const hsp_mesh *mesh) {
  contents read;
  memset(&read, 0, sizeof read);
  read.status = hsp_mesh_get_counts(mesh, &read.counts.mesh);
  CHECK_EQUAL(hsp_mesh_get_vertices(mesh, read.records.points[0], NULL, NULL, NULL, POINTS, NULL), read.status);
  return read;
}

contents contents_of_map(const hsp_map *map) {
  contents read;
  memset(&read, 0, sizeof read);
  read.status = hsp_map_get_info(map, &read.counts.map);
  CHECK_EQUAL(hsp_map_get_edges(map, 0, read.counts.map.edges, read.records.map_edges), read.status);
  return read;
}

void check_status(contents read, int32_t status) {
  CHECK_EQUAL(read.status, status);
}

void check_same_contents(const contents *a, contents b) {
  CHECK_BYTES(a, &b, sizeof b);
}
