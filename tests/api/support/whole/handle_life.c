#include "handle_life.h"

#include <stdlib.h>
#include <string.h>

#include "boundary_hash.h"
#include "check.h"
#include "picture_sink.h"

/* ---- hashes ---- */

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
  bad |= hsp_topology_get_regions(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_region));
  for (id = 0; id < counts.regions; ++id) {
    bad |= hsp_topology_get_region_shells(topology, id, (void *)buffer, room, &needed) != HSP_OK;
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

/* Patches and what lies between them only where every joint is closed. */
static uint64_t surface_hash(const void *surface, const void *source, unsigned char *buffer, uint32_t room) {
  const surface_result *s = source;
  const uint32_t n = s->base->n;
  double *numbers = (void *)buffer;
  uint32_t *flags = (void *)(numbers + 4 * (size_t)n);
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_surface_counts counts;
  hsp_surface_part_counts map;
  hsp_surface_totals totals;
  hsp_energy energy;
  uint32_t needed = 0, h;
  int bad = 0;
  if (hsp_surface_get_counts(surface, &counts) != HSP_OK) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_surface_measure(surface, &totals, (void *)buffer, n, &needed) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &totals, sizeof totals), buffer, n * sizeof totals);
  bad |= hsp_surface_get_gradient(surface, SIZED(hsp_gradient_request, .tension = 1, .pressure = -0.5),
                                  SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = numbers,
                                        .d_radius = numbers + 3 * (size_t)n, .flags = flags, .capacity = n)) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &energy, sizeof energy), numbers, 4 * (size_t)n * sizeof *numbers);
  hash = mixed_hash(hash, flags, n * sizeof *flags);
  bad |= hsp_surface_get_gradient(surface, SIZED(hsp_gradient_request, .sigma = s->base->radius, .tension = 1),
                                  SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = numbers,
                                        .d_radius = numbers + 3 * (size_t)n, .flags = flags, .capacity = n)) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &energy, sizeof energy), numbers, 4 * (size_t)n * sizeof *numbers);
  if (hsp_surface_get_part_counts(surface, &map) != HSP_OK) return bad || counts.open_joints == 0 ? 0 : hash;
  hash = mixed_hash(hash, &map, sizeof map);
  bad |= map.patches > room || map.edges > room || map.corners > room || map.shells > room;
  if (bad) return 0;
  bad |= hsp_surface_get_patches(surface, 0, map.patches, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, map.patches * sizeof(hsp_surface_patch));
  bad |= hsp_surface_get_edges(surface, 0, map.edges, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, map.edges * sizeof(hsp_surface_edge));
  bad |= hsp_surface_get_corners(surface, 0, map.corners, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, map.corners * sizeof(hsp_surface_corner));
  bad |= hsp_surface_get_shells(surface, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_surface_shell));
  for (h = 0; h < 2 * map.edges; h += 3) {
    uint32_t steps[5];
    steps[0] = hsp_surface_next(surface, h);
    steps[1] = hsp_surface_previous(surface, h);
    steps[2] = hsp_surface_next_loop(surface, h);
    steps[3] = hsp_surface_origin(surface, h);
    steps[4] = hsp_surface_left(surface, h);
    hash = mixed_hash(hash, steps, sizeof steps);
  }
  return bad ? 0 : hash;
}

static uint64_t mesh_hash(const void *mesh, const void *source, unsigned char *buffer, uint32_t room) {
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_mesh_counts counts;
  uint32_t numbers[2], patch;
  double *const reals = (void *)buffer;
  uint32_t *const ids = (void *)buffer;
  int bad = 0;
  (void)source;
  if (hsp_mesh_get_counts(mesh, &counts) != HSP_OK || counts.vertices > room || counts.triangles > room) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_mesh_get_vertices(mesh, reals, NULL, NULL, NULL, room, NULL) != HSP_OK;
  hash = mixed_hash(hash, reals, 3 * (size_t)counts.vertices * sizeof *reals);
  bad |= hsp_mesh_get_vertices(mesh, NULL, reals, NULL, NULL, room, NULL) != HSP_OK;
  hash = mixed_hash(hash, reals, 3 * (size_t)counts.vertices * sizeof *reals);
  bad |= hsp_mesh_get_vertices(mesh, NULL, NULL, reals, NULL, room, NULL) != HSP_OK;
  hash = mixed_hash(hash, reals, counts.vertices * sizeof *reals);
  bad |= hsp_mesh_get_vertices(mesh, NULL, NULL, NULL, ids, room, NULL) != HSP_OK;
  hash = mixed_hash(hash, ids, counts.vertices * sizeof *ids);
  bad |= hsp_mesh_get_triangles(mesh, ids, NULL, NULL, NULL, room, NULL) != HSP_OK;
  hash = mixed_hash(hash, ids, 3 * (size_t)counts.triangles * sizeof *ids);
  bad |= hsp_mesh_get_triangles(mesh, NULL, NULL, ids, NULL, room, NULL) != HSP_OK;
  hash = mixed_hash(hash, ids, counts.triangles * sizeof *ids);
  for (patch = 0; patch < 20; ++patch) {
    bad |= hsp_mesh_get_patch(mesh, patch, &numbers[0], &numbers[1]) != HSP_OK;
    hash = mixed_hash(hash, numbers, sizeof numbers);
  }
  return bad ? 0 : hash;
}

/* With questions to it. */
static uint64_t map_hash(const void *map, const void *source, unsigned char *buffer, uint32_t room) {
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_map_info info;
  uint32_t needed = 0, id;
  int bad = 0;
  (void)source;
  if (hsp_map_get_info(map, &info) != HSP_OK) return 0;
  hash = mixed_hash(hash, &info, sizeof info);
  bad |= hsp_map_get_vertices(map, 0, info.vertices, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, info.vertices * sizeof(hsp_map_vertex));
  bad |= hsp_map_get_edges(map, 0, info.edges, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, info.edges * sizeof(hsp_map_edge));
  bad |= hsp_map_get_faces(map, 0, info.faces, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, info.faces * sizeof(hsp_map_face));
  bad |= hsp_map_get_areas(map, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(double));
  if (needed > 0) {
    bad |= hsp_map_get_outline(map, 0, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  for (id = 0; id < 2 * info.edges; id += 3) {
    hsp_map_point point;
    uint32_t steps[2];
    steps[0] = hsp_map_previous(map, id);
    steps[1] = hsp_map_next_loop(map, id);
    hash = mixed_hash(hash, steps, sizeof steps);
    bad |= hsp_map_get_edges(map, id / 2, 1, (void *)buffer) != HSP_OK;
    bad |= hsp_map_get_point(map, id / 2, ((hsp_map_edge *)(void *)buffer)->to, &point) != HSP_OK;
    hash = mixed_hash(hash, &point, sizeof point);
  }
  for (id = 1; id < info.faces; id += 1 + info.faces / 8) {
    hsp_map_pole pole;
    hsp_map_sight sight;
    bad |= hsp_map_get_pole(map, id, &pole) != HSP_OK;
    hash = mixed_hash(hash, &pole, sizeof pole);
    bad |= hsp_map_pick(map, pole.centre[0], pole.centre[1], &sight) != HSP_OK;
    hash = mixed_hash(hash, &sight, sizeof sight);
  }
  return bad ? 0 : hash;
}

/* Of both a painting order and a map, with what is seen where balls are. */
static uint64_t sticks_hash(const void *sticks, const void *source, unsigned char *buffer, uint32_t room) {
  const sticks_result *s = source;
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_sticks_info info;
  hsp_map_info map;
  uint32_t needed = 0, i;
  int bad = 0;
  if (hsp_sticks_get_info(sticks, &info) != HSP_OK || hsp_sticks_get_map_info(sticks, &map) != HSP_OK) return 0;
  hash = mixed_hash(mixed_hash(hash, &info, sizeof info), &map, sizeof map);
  bad |= hsp_sticks_get_vertices(sticks, 0, map.vertices, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, map.vertices * sizeof(hsp_map_vertex));
  bad |= hsp_sticks_get_edges(sticks, 0, map.edges, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, map.edges * sizeof(hsp_map_edge));
  bad |= hsp_sticks_get_faces(sticks, 0, map.faces, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, map.faces * sizeof(hsp_map_face));
  bad |= hsp_sticks_get_areas(sticks, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(double));
  for (i = 0; i < s->base->n; i += 3) {
    hsp_map_sight sight;
    bad |= hsp_sticks_pick(sticks, s->base->xyz[3 * (size_t)i], s->base->xyz[3 * (size_t)i + 1], &sight) != HSP_OK;
    hash = mixed_hash(hash, &sight, sizeof sight);
    bad |= hsp_sticks_get_outline(sticks, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  for (i = 1; i < map.faces; i += 5) {
    hsp_map_pole pole;
    bad |= hsp_sticks_get_pole(sticks, i, &pole) != HSP_OK;
    hash = mixed_hash(hash, &pole, sizeof pole);
  }
  for (i = 0; i < map.edges; i += 5) {
    hsp_map_point point;
    bad |= hsp_sticks_get_point(sticks, i, s->edges[i].to, &point) != HSP_OK;
    hash = mixed_hash(hash, &point, sizeof point);
  }
  return bad ? 0 : hash;
}

static uint64_t contacts_hash(const void *contacts, const void *source, unsigned char *buffer, uint32_t room) {
  const contacts_result *c = source;
  const uint32_t n = c->base->n;
  double *numbers = (void *)buffer;
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_complex counts;
  hsp_totals totals;
  uint32_t needed = 0, i;
  int bad = 0;
  if (hsp_contacts_get_complex(contacts, &counts) != HSP_OK) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_contacts_get_pairs(contacts, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_contact));
  for (i = 0; i < n; ++i) {
    bad |= hsp_contacts_get_row(contacts, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(hsp_contact));
  }
  bad |= hsp_contacts_measure(contacts, &totals, numbers, numbers + n, n, NULL) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &totals, sizeof totals), numbers, 2 * (size_t)n * sizeof *numbers);
  for (i = 2; i < 4; ++i) {
    bad |= hsp_contacts_get_simplices(contacts, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(hsp_simplex));
  }
  return bad ? 0 : hash;
}

/* With the places of the balls' centres and of points beside them. */
static uint64_t cells_hash(const void *cells, const void *source, unsigned char *buffer, uint32_t room) {
  const computed *c = ((const cells_result *)source)->base;
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_cells_counts counts;
  uint32_t needed = 0, i;
  int bad = 0;
  if (hsp_cells_get_counts(cells, &counts) != HSP_OK || counts.cells > room || counts.adjacencies > room) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_cells_get_cells(cells, 0, counts.cells, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.cells * sizeof(hsp_free_cell));
  bad |= hsp_cells_get_pairs(cells, 0, counts.adjacencies, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.adjacencies * sizeof(hsp_cell_pair));
  for (i = 0; i < counts.cells; i += 3) {
    bad |= hsp_cells_get_neighbours(cells, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  for (i = 0; i < 2 * c->n; ++i) {
    double place[3];
    memcpy(place, c->xyz + 3 * (size_t)(i / 2), sizeof place);
    if (i % 2 != 0) place[2] += 1.5 * c->radius[i / 2];
    bad |= hsp_cells_locate(cells, place, &needed) != HSP_OK;
    hash = mixed_hash(hash, &needed, sizeof needed);
  }
  return bad ? 0 : hash;
}

static uint64_t paths_hash(const void *paths, const void *source, unsigned char *buffer, uint32_t room) {
  uint32_t needed = 0;
  (void)source;
  if (hsp_paths_get_points(paths, (void *)buffer, room, &needed) != HSP_OK) return 0;
  return mixed_hash(UINT64_C(0xCBF29CE484222325), buffer, 3 * needed * sizeof(double));
}

/* Maxima, gates, all their balls, the tunnel, and where its points are. */
static uint64_t pores_hash(const void *pores, const void *source, unsigned char *buffer, uint32_t room) {
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_pores_counts counts;
  hsp_pore_place place;
  uint32_t needed = 0, i;
  int bad = hsp_pores_get_counts(pores, &counts) != HSP_OK;
  (void)source;
  if (bad || counts.maxima + counts.gates > room) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_pores_get_maxima(pores, 0, counts.maxima, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.maxima * sizeof(hsp_pore_maximum));
  bad |= hsp_pores_get_gates(pores, 0, counts.gates, (void *)buffer) != HSP_OK;
  hash = mixed_hash(hash, buffer, counts.gates * sizeof(hsp_pore_gate));
  for (i = 0; i < counts.maxima && !bad; ++i) {
    bad |= hsp_pores_get_maximum_balls(pores, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  bad |= hsp_pores_get_tunnel_points(pores, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_tunnel_point));
  for (i = 0; i < needed && !bad; ++i) {
    hsp_tunnel_point point;
    memcpy(&point, buffer + i * sizeof point, sizeof point);
    bad |= hsp_pores_locate(pores, point.xyz, &place) != HSP_OK;
    hash = mixed_hash(hash, &place, sizeof place);
  }
  return bad ? 0 : hash;
}

/* Of a body that has balls; the one of itself with itself. */
static uint64_t body_hash(const void *body, const void *source, unsigned char *buffer, uint32_t room) {
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_body_gap gap[BODY_POSES];
  hsp_body_overlap overlap[BODY_POSES];
  uint32_t hit[BODY_POSES], needed = 0;
  int bad = hsp_body_gaps(body, body, BODY_POSES, body_poses, gap, NULL) != HSP_OK || gap[0].fixed == HSP_NONE;
  (void)source;
  if (bad) return 0;
  hash = mixed_hash(hash, gap, sizeof gap);
  bad |= hsp_body_overlaps(body, body, BODY_POSES, body_poses, overlap, NULL) != HSP_OK;
  hash = mixed_hash(hash, overlap, sizeof overlap);
  bad |= hsp_body_hits(body, body, BODY_POSES, body_poses, hit, NULL) != HSP_OK;
  hash = mixed_hash(hash, hit, sizeof hit);
  bad |= hsp_body_pairs(body, body, &body_poses[0], (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * 2 * sizeof(uint32_t));
  bad |= hsp_body_rational_gaps(body, body, BODY_POSES, body_rational_poses, gap, NULL) != HSP_OK;
  return bad ? 0 : mixed_hash(hash, gap, sizeof gap);
}

/* With what is at the balls' centres. */
static uint64_t periodic_hash(const void *periodic, const void *source, unsigned char *buffer, uint32_t room) {
  const computed *c = ((const periodic_result *)source)->base;
  const uint32_t n = c->n;
  double *numbers = (void *)buffer;
  uint32_t *flags = (void *)(numbers + 4 * (size_t)n);
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_periodic_counts counts;
  hsp_periodic_totals totals;
  hsp_curvatures curvatures;
  hsp_energy energy;
  hsp_morphometric_energy morphometric;
  double strain[9], box[9];
  uint32_t needed = 0, i;
  int bad = 0;
  if (hsp_periodic_get_counts(periodic, &counts) != HSP_OK) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_periodic_measure(periodic, &totals, numbers, numbers + n, n, NULL) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &totals, sizeof totals), numbers, 2 * (size_t)n * sizeof *numbers);
  bad |= hsp_periodic_curvature(periodic, &curvatures, numbers, (void *)flags, n, NULL) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &curvatures, sizeof curvatures), numbers, (size_t)n * sizeof *numbers);
  hash = mixed_hash(hash, flags, (size_t)n * sizeof *flags);
  bad |= hsp_periodic_get_contacts(periodic, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_periodic_contact));
  bad |= hsp_periodic_get_windings(periodic, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_winding));
  bad |= hsp_periodic_get_components(periodic, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  bad |= hsp_periodic_get_gradient(periodic,
                                   SIZED(hsp_gradient_request, .sigma = c->radius, .tension = 1, .pressure = -0.5),
                                   SIZED(hsp_periodic_gradient_outputs, .energy = &energy, .d_centre = numbers,
                                         .d_radius = numbers + 3 * (size_t)n, .flags = flags, .d_strain = strain,
                                         .d_box = box, .capacity = n)) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &energy, sizeof energy), numbers, 4 * (size_t)n * sizeof *numbers);
  hash = mixed_hash(mixed_hash(hash, flags, n * sizeof *flags), strain, sizeof strain);
  hash = mixed_hash(hash, box, sizeof box);
  bad |= hsp_periodic_get_morphometry(periodic,
                                      SIZED(hsp_morphometry_request, .sigma = c->radius, .pressure = -0.5, .tension = 1,
                                            .bending = 2, .gaussian = 3),
                                      SIZED(hsp_periodic_morphometry_outputs, .energy = &morphometric,
                                            .d_centre = numbers, .d_radius = numbers + 3 * (size_t)n, .flags = flags,
                                            .d_strain = strain, .d_box = box, .capacity = n)) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &morphometric, sizeof morphometric), numbers, 4 * (size_t)n * sizeof *numbers);
  hash = mixed_hash(mixed_hash(hash, flags, n * sizeof *flags), strain, sizeof strain);
  hash = mixed_hash(hash, box, sizeof box);
  for (i = 0; i < n; ++i) {
    bad |= hsp_periodic_query_neighbours(periodic, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(hsp_image));
    bad |= hsp_periodic_query_point(periodic, c->xyz + 3 * (size_t)i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(hsp_image));
  }
  return bad ? 0 : hash;
}

/* With what is known of each ball, and of all of them as a model again. */
static uint64_t moving_hash(const void *moving, const void *source, unsigned char *buffer, uint32_t room) {
  double *numbers = (void *)buffer;
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_moving_info info;
  hsp_totals totals;
  hsp_energy energy;
  uint32_t *flags, needed = 0, i;
  int bad = 0;
  (void)source;
  if (hsp_moving_get_info(moving, &info) != HSP_OK || info.balls > room) return 0;
  flags = (void *)(numbers + 4 * (size_t)info.balls);
  /* The number of changes in the last call is no part of the contents. */
  info.changed = 0;
  hash = mixed_hash(hash, &info, sizeof info);
  bad |= hsp_moving_measure(moving, &totals, numbers, numbers + info.balls, info.balls, NULL) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &totals, sizeof totals), numbers, 2 * (size_t)info.balls * sizeof *numbers);
  bad |= hsp_moving_gradient(moving, &energy, numbers, numbers + 3 * (size_t)info.balls, flags, info.balls, NULL) !=
         HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &energy, sizeof energy), numbers, 4 * (size_t)info.balls * sizeof *numbers);
  hash = mixed_hash(hash, flags, info.balls * sizeof *flags);
  for (i = 0; i < info.balls; ++i) {
    hsp_moving_ball ball;
    bad |= hsp_moving_get_balls(moving, 1, &i, &ball) != HSP_OK;
    hash = mixed_hash(hash, &ball, sizeof ball);
  }
  bad |= hsp_moving_get_changed(moving, flags, info.balls, &needed) != HSP_OK;
  return bad ? 0 : hash;
}

/* ---- what uses scratch memory; 0 if a call fails ---- */

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

static int use_surface(void *surface) {
  uint32_t invariant, id;
  return hsp_surface_check(surface, &invariant, &id) == HSP_OK;
}

/* No function of a mesh uses scratch memory. */
static int use_mesh(void *mesh) {
  hsp_mesh_counts counts;
  return hsp_mesh_get_counts(mesh, &counts) == HSP_OK;
}

static int use_map(void *map) {
  uint32_t invariant, id;
  return hsp_map_check(map, &invariant, &id) == HSP_OK;
}

static int use_sticks(void *sticks) {
  uint32_t invariant, id;
  picture_sink sink;
  int32_t status;
  picture_sink_start(&sink, SIZE_MAX);
  status = hsp_picture_write_sticks(sticks, NULL, NULL, NULL, NULL, picture_sink_take, &sink, NULL);
  picture_sink_release(&sink);
  return status == HSP_OK && hsp_sticks_check(sticks, &invariant, &id) == HSP_OK;
}

static int use_contacts(void *contacts) {
  hsp_group_contact sum;
  uint32_t invariant, id, n = 0, needed = 0, *group, i;
  int32_t status = hsp_contacts_measure(contacts, NULL, NULL, NULL, 0, &n);
  group = test_zeros(n, sizeof *group);
  for (i = 0; i < n; ++i) group[i] = i % 2;
  if (status == HSP_OK) status = hsp_contacts_group(contacts, group, &sum, 1, &needed);
  free(group);
  return status == HSP_OK && hsp_contacts_check(contacts, &invariant, &id) == HSP_OK;
}

static int use_cells(void *cells) {
  uint32_t invariant, id;
  return hsp_cells_check(cells, NULL, &invariant, &id) == HSP_OK;
}

/* Only finding paths uses scratch memory, and this is a part of computing them. */
static int use_paths(void *paths) {
  uint32_t needed = 0;
  return hsp_paths_get_points(paths, NULL, 0, &needed) == HSP_E_CAPACITY && needed >= 2;
}

static int use_pores(void *pores) {
  hsp_tunnel tunnel;
  uint32_t found = 0;
  const int bad = hsp_pores_find_pockets(pores, 0, 1e3, &found) != HSP_OK;
  return !bad && hsp_pores_get_pockets(pores, 0, 0, NULL) == HSP_OK &&
         find_widest_tunnel(pores, &tunnel, NULL) == HSP_OK;
}

/* No function of a body uses scratch memory. */
static int use_body(void *body) {
  uint32_t hit = 0;
  return hsp_body_hits(body, body, 1, body_poses, &hit, NULL) == HSP_OK && hit == 1;
}

static int use_periodic(void *periodic) {
  hsp_group_contact sum;
  uint32_t invariant, id, n = 0, needed = 0, *group, i;
  int32_t status = hsp_periodic_measure(periodic, NULL, NULL, NULL, 0, &n);
  group = test_zeros(n, sizeof *group);
  for (i = 0; i < n; ++i) group[i] = i % 2;
  if (status == HSP_OK) status = hsp_periodic_group_contacts(periodic, group, &sum, 1, &needed);
  free(group);
  return status == HSP_OK && hsp_periodic_check(periodic, &invariant, &id) == HSP_OK;
}

/* A move of every ball, taken back. */
static int use_moving(void *moving) {
  hsp_moving_info info;
  uint32_t i;
  int bad = hsp_moving_get_info(moving, &info) != HSP_OK;
  for (i = 0; i < info.balls && !bad; i += 1 + info.balls / 8) {
    hsp_moving_ball ball;
    bad |= hsp_moving_get_balls(moving, 1, &i, &ball) != HSP_OK;
    ball.centre[0] += 0.25 * ball.radius;
    /* There may be no room for more neighbours. */
    if (hsp_moving_move(moving, 1, &i, ball.centre, NULL, NULL, NULL) == HSP_OK) {
      bad |= hsp_moving_undo(moving) != HSP_OK;
    }
  }
  return !bad;
}

/* ---- a computation of any kind ---- */

const kind_of_life kinds_of_life[KINDS] = {{&boundary_handle, "a boundary", boundary_hash, use_boundary},
                                           {&topology_handle, "a topology", topology_hash, use_topology},
                                           {&view_handle, "a view", view_hash, use_view},
                                           {&surface_handle, "a surface", surface_hash, use_surface},
                                           {&mesh_handle, "a mesh", mesh_hash, use_mesh},
                                           {&map_handle, "a map", map_hash, use_map},
                                           {&sticks_handle, "sticks", sticks_hash, use_sticks},
                                           {&contacts_handle, "contacts", contacts_hash, use_contacts},
                                           {&cells_handle, "cells", cells_hash, use_cells},
                                           {&paths_handle, "a path", paths_hash, use_paths},
                                           {&pores_handle, "pores", pores_hash, use_pores},
                                           {&body_handle, "a body", body_hash, use_body},
                                           {&periodic_handle, "a periodic union", periodic_hash, use_periodic},
                                           {&moving_handle, "balls that move", moving_hash, use_moving}};

/* A probe half as large as the largest ball, and triangles as large as that ball. Where joints are open or borders
 * touch in a point there are no triangles. */
static int make_surface(const ball_set *set, computations *all) {
  const computed *c = &all->rolled;
  hsp_model_options options;
  double largest = 1e-3;
  uint32_t i;
  int32_t status;
  for (i = 0; i < set->n; ++i) {
    if (set->radius[i] > largest) largest = set->radius[i];
  }
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 0.5 * largest;
  if (!CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &all->rolled), HSP_OK)) return 0;
  if (!CHECK_EQUAL(surface_result_make(c, &all->surface), HSP_OK)) return 0;
  status = mesh_result_make_surface(&all->surface, largest, &all->mesh);
  all->room += 8 * (c->counts.arcs + c->counts.circles + c->counts.vertices) + c->counts.faces +
               all->mesh.counts.vertices + all->mesh.counts.triangles;
  return CHECK_EQUAL(status, HSP_OK);
}

static int add_cells(computations *all) {
  if (!CHECK_EQUAL(cells_result_make(&all->boundary, &all->cells), HSP_OK)) return 0;
  all->room += all->cells.counts.cells + all->cells.counts.adjacencies;
  return 1;
}

static int add_path(computations *all) {
  if (!CHECK_EQUAL(paths_result_make(&all->boundary, &all->paths), HSP_OK)) return 0;
  all->room += 3 * all->paths.path.points;
  return 1;
}

static int add_pores(computations *all) {
  if (!CHECK_EQUAL(pores_result_make(&all->boundary, &all->pores), HSP_OK)) return 0;
  all->room += all->pores.counts.maxima + all->pores.counts.gates + all->pores.tunnel.points;
  return 1;
}

static int add_sticks(computations *all, const hsp_view_options *options) {
  if (!CHECK_EQUAL(sticks_result_make(&all->boundary, options, &all->sticks), HSP_OK)) return 0;
  all->room += 2 * all->sticks.count + all->sticks.map.edges + all->sticks.map.faces;
  return 1;
}

int computations_add_slow(computations *all, const hsp_view_options *options) {
  return add_cells(all) && add_path(all) && add_pores(all) && add_sticks(all, options);
}

static int make_contacts_and_cells(computations *all) {
  const computed *c = &all->boundary;
  if (!CHECK_EQUAL(contacts_result_make(c, &all->contacts), HSP_OK)) return 0;
  all->room += all->contacts.count + all->contacts.needed.triangles + all->contacts.needed.tetrahedra;
  if (c->n <= CELLS_OF_BALLS && !(add_cells(all) && add_path(all) && add_pores(all))) return 0;
  if (!CHECK_EQUAL(body_result_make(c, &all->body), HSP_OK)) return 0;
  all->room += all->body.overlap[0].pairs;
  if (!CHECK_EQUAL(periodic_result_make(c, &all->periodic), HSP_OK)) return 0;
  all->room += all->periodic.needed.images + all->periodic.counts.contacts;
  return CHECK_EQUAL(moving_result_make(c, &all->moving), HSP_OK);
}

int computations_make(const ball_set *set, const hsp_view_options *options, computations *all) {
  const computed *c = &all->boundary;
  memset(all, 0, sizeof *all);
  if (!CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &all->boundary), HSP_OK)) return 0;
  all->room =
      c->n + c->counts.vertices + 2 * c->counts.arcs + c->counts.circles + c->counts.faces + c->counts.loops + 1;
  if (options == NULL) return 1;
  if (!CHECK_EQUAL(topology_result_make(c, &all->topology), HSP_OK)) return 0;
  all->room += all->topology.counts.edges + all->topology.counts.shells + all->topology.counts.regions;
  if (!CHECK_EQUAL(view_result_make(c, options, 1, &all->view), HSP_OK)) return 0;
  all->room += all->view.info.arcs;
  if (!CHECK_EQUAL(map_result_make(c, options, &all->map), HSP_OK)) return 0;
  all->room += all->map.info.edges + all->map.info.faces;
  if (c->n <= STICKS_OF_BALLS && !add_sticks(all, options)) return 0;
  return make_contacts_and_cells(all) && make_surface(set, all);
}

void computations_release(computations *all) {
  moving_result_release(&all->moving);
  periodic_result_release(&all->periodic);
  body_result_release(&all->body);
  pores_result_release(&all->pores);
  paths_result_release(&all->paths);
  cells_result_release(&all->cells);
  contacts_result_release(&all->contacts);
  sticks_result_release(&all->sticks);
  map_result_release(&all->map);
  mesh_result_release(&all->mesh);
  surface_result_release(&all->surface);
  computed_release(&all->rolled);
  view_result_release(&all->view);
  topology_result_release(&all->topology);
  computed_release(&all->boundary);
}

const void *source_of(const computations *all, int kind) {
  const void *const sources[KINDS] = {&all->boundary, &all->topology, &all->view,     &all->surface, &all->mesh,
                                      &all->map,      &all->sticks,   &all->contacts, &all->cells,   &all->paths,
                                      &all->pores,    &all->body,     &all->periodic, &all->moving};
  return sources[kind];
}

void *handle_of(const computations *all, int kind) {
  void *const handles[KINDS] = {
      all->boundary.boundary, all->topology.topology, all->view.view,     all->surface.surface,
      all->mesh.mesh,         all->map.map,           all->sticks.sticks, all->contacts.contacts,
      all->cells.cells,       all->paths.paths,       all->pores.pores,   all->boundary.n > 0 ? all->body.body : NULL,
      all->periodic.periodic, all->moving.moving};
  return handles[kind];
}

limit_numbers limits_of(const computations *all, int kind) {
  const void *const needed[KINDS] = {
      &all->boundary.needed, &all->topology.needed, &all->view.needed,     &all->surface.needed, &all->mesh.needed,
      &all->map.needed,      &all->sticks.needed,   &all->contacts.needed, &all->cells.needed,   &all->paths.needed,
      &all->pores.needed,    &all->body.needed,     &all->periodic.needed, &all->moving.needed};
  limit_numbers limits;
  memset(&limits, 0, sizeof limits);
  memcpy(&limits, needed[kind], kinds_of_life[kind].kind->struct_size);
  return limits;
}

unsigned char *buffer_for(const computations *all) {
  return test_zeros(all->room, sizeof(hsp_vertex) + sizeof(hsp_topology_edge) + sizeof(hsp_shell) +
                                   sizeof(hsp_view_arc) + sizeof(hsp_surface_edge));
}
