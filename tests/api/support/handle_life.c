#include "handle_life.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "picture_sink.h"

/* ---- hashes ---- */

uint64_t mixed_hash(uint64_t hash, const void *bytes, size_t size) {
  const unsigned char *from = bytes;
  size_t i;
  for (i = 0; i < size; ++i) hash = (hash ^ from[i]) * UINT64_C(0x100000001B3);
  return hash;
}

/* What is computed on request: areas of faces, a gradient, and rows of derivatives of areas. */
static uint64_t derived_hash(const hsp_boundary *boundary, const hsp_boundary_counts *counts, unsigned char *buffer,
                             uint64_t hash) {
  const uint32_t n = counts->balls;
  double *numbers = (void *)buffer;
  uint32_t *flags = (void *)(numbers + 4 * (size_t)n);
  hsp_totals totals;
  hsp_energy energy;
  uint32_t needed = 0, i;
  int bad = hsp_boundary_measure(boundary, NULL, &totals, numbers, numbers + n, n, NULL) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &totals, sizeof totals), numbers, 2 * (size_t)n * sizeof *numbers);
  bad |= hsp_boundary_measure_faces(boundary, numbers, numbers + counts->faces, counts->faces, NULL) != HSP_OK;
  hash = mixed_hash(hash, numbers, 2 * (size_t)counts->faces * sizeof *numbers);
  bad |= hsp_boundary_gradient(boundary, NULL, 1, -0.5, HSP_TANGENT_OVERLAP, &energy, numbers, numbers + 3 * (size_t)n,
                               flags, n, NULL, NULL) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &energy, sizeof energy), numbers, 4 * (size_t)n * sizeof *numbers);
  hash = mixed_hash(hash, flags, n * sizeof *flags);
  for (i = 0; i < n; ++i) {
    bad |= hsp_boundary_get_area_row(boundary, i, HSP_TANGENT_DISJOINT, (void *)buffer, n, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(hsp_area_derivative));
  }
  return bad ? 0 : hash;
}

/* With queries of the model that the boundary is of. */
static uint64_t boundary_hash(const void *boundary, const void *source, unsigned char *buffer, uint32_t room) {
  const computed *c = source;
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_boundary_counts counts;
  uint32_t needed = 0, i;
  int bad = 0;
  if (hsp_boundary_get_counts(boundary, &counts) != HSP_OK) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_boundary_get_vertices(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_vertex));
  bad |= hsp_boundary_get_arcs(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_arc));
  bad |= hsp_boundary_get_circles(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_circle));
  bad |= hsp_boundary_get_faces(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_face));
  bad |= hsp_boundary_get_loops(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_loop));
  bad |= hsp_boundary_get_loop_arcs(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_loop_arc));
  bad |= hsp_boundary_get_balls(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_ball));
  for (i = 0; i < c->n; ++i) {
    bad |= hsp_query_neighbours(c->model, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
    bad |= hsp_query_ball(c->model, c->xyz + 3 * i, 2.5, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  return bad ? 0 : derived_hash(boundary, &counts, buffer, hash);
}

static uint64_t topology_hash(const void *handle, const void *source, unsigned char *buffer, uint32_t room) {
  hsp_topology *topology = (hsp_topology *)handle; /* no handle is const by itself, and some calls scan its shells */
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_topology_counts counts;
  uint32_t needed = 0, q, id;
  int bad = 0;
  (void)source;
  if (hsp_topology_get_counts(topology, &counts) != HSP_OK) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_topology_get_vertices(topology, 0, counts.vertices, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.vertices * sizeof(hsp_topology_vertex));
  bad |= hsp_topology_get_edges(topology, 0, counts.edges, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.edges * sizeof(hsp_topology_edge));
  bad |= hsp_topology_get_simple_faces(topology, 0, counts.simple_faces, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.simple_faces * sizeof(hsp_simple_face));
  bad |= hsp_topology_get_quad_edges(topology, 0, counts.edges, (void *)buffer, NULL) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.edges * 4 * sizeof(uint32_t));
  bad |= hsp_topology_get_shells(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_shell));
  bad |= hsp_topology_get_components(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_component));
  bad |= hsp_topology_get_cells(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_cell));
  for (id = 0; id < counts.cells; ++id) {
    bad |= hsp_topology_get_cell_shells(topology, id, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  for (id = 0; id < counts.shells; ++id) {
    bad |= hsp_topology_get_traversal(topology, id, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  for (q = 0; q < 4 * counts.edges; q += 3) {
    uint32_t steps[4];
    steps[0] = hsp_topology_onext(topology, q);
    steps[1] = hsp_topology_lnext(topology, q);
    steps[2] = hsp_topology_origin(topology, q);
    steps[3] = hsp_topology_left(topology, q);
    hash = mixed_hash(hash, steps, sizeof steps);
  }
  return bad ? 0 : hash;
}

static uint64_t view_hash(const void *view, const void *source, unsigned char *buffer, uint32_t room) {
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_view_info info;
  uint32_t needed = 0;
  int bad = 0;
  (void)source;
  if (hsp_view_get_info(view, &info) != HSP_OK) return 0;
  hash = mixed_hash(hash, &info, sizeof info);
  bad |= hsp_view_get_pieces(view, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_view_piece));
  bad |= hsp_view_get_loops(view, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_view_loop));
  bad |= hsp_view_get_arcs(view, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_view_arc));
  return bad ? 0 : hash;
}

/* ---- what uses scratch memory; 0 if a call fails ---- */

static int use_boundary(void *boundary) {
  uint32_t invariant, id;
  return hsp_boundary_check(boundary, &invariant, &id) == HSP_OK;
}

static int use_topology(void *topology) {
  static const double place[3] = {0.5, 0.25, 0.125};
  uint32_t invariant, id, cell;
  return hsp_topology_check(topology, &invariant, &id) == HSP_OK &&
         hsp_topology_locate(topology, place, &cell) == HSP_OK;
}

static int use_view(void *view) {
  picture_sink sink;
  int32_t status;
  picture_sink_start(&sink, SIZE_MAX);
  status = hsp_picture_write(view, NULL, NULL, NULL, NULL, picture_sink_take, &sink, NULL);
  picture_sink_release(&sink);
  return status == HSP_OK;
}

/* ---- a computation of any kind ---- */

const kind_of_life kinds_of_life[KINDS] = {{&boundary_handle, "a boundary", boundary_hash, use_boundary},
                                           {&topology_handle, "a topology", topology_hash, use_topology},
                                           {&view_handle, "a view", view_hash, use_view}};

int computations_make(const ball_set *set, const hsp_view_options *options, computations *all) {
  const computed *c = &all->boundary;
  memset(all, 0, sizeof *all);
  if (!CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &all->boundary), HSP_OK)) return 0;
  all->room =
      c->n + c->counts.vertices + 2 * c->counts.arcs + c->counts.circles + c->counts.faces + c->counts.loops + 1;
  if (options == NULL) return 1;
  if (!CHECK_EQUAL(topology_result_make(c, &all->topology), HSP_OK)) return 0;
  all->room += all->topology.counts.edges + all->topology.counts.shells + all->topology.counts.cells;
  if (!CHECK_EQUAL(view_result_make(c, options, 1, &all->view), HSP_OK)) return 0;
  all->room += all->view.info.arcs;
  return 1;
}

void computations_release(computations *all) {
  view_result_release(&all->view);
  topology_result_release(&all->topology);
  computed_release(&all->boundary);
}

const void *source_of(const computations *all, int kind) {
  return kind == BOUNDARY   ? (const void *)&all->boundary
         : kind == TOPOLOGY ? (const void *)&all->topology
                            : (const void *)&all->view;
}

void *handle_of(const computations *all, int kind) {
  return kind == BOUNDARY   ? (void *)all->boundary.boundary
         : kind == TOPOLOGY ? (void *)all->topology.topology
                            : (void *)all->view.view;
}

limit_numbers limits_of(const computations *all, int kind) {
  limit_numbers limits;
  memset(&limits, 0, sizeof limits);
  memcpy(&limits,
         kind == BOUNDARY   ? (const void *)&all->boundary.needed
         : kind == TOPOLOGY ? (const void *)&all->topology.needed
                            : (const void *)&all->view.needed,
         kinds_of_life[kind].kind->struct_size);
  return limits;
}

unsigned char *buffer_for(const computations *all) {
  return test_zeros(all->room,
                    sizeof(hsp_vertex) + sizeof(hsp_topology_edge) + sizeof(hsp_shell) + sizeof(hsp_view_arc));
}
