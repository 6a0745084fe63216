/* Pointers to what is not a handle of the right kind: every function refuses them. C's types keep such mistakes out of
 * C programs, but other languages have one type for all pointers. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "four_handles.h"
#include "untouched.h"

static four_handles h;
static hsp_surface *surface;
static hsp_mesh *mesh;
static hsp_contacts *contacts;
static hsp_cells *cells;
static hsp_paths *paths;
static hsp_gate *gate;
static hsp_body *body;
static hsp_periodic *periodic;
static hsp_sticks *sticks;
static hsp_moving *moving;

/* A surface and a mesh of its own, as four_handles has none. */
static void make_surface(void) {
  const fifth_handles fifth = fifth_handles_make(BALLS);
  surface = fifth.surface;
  mesh = fifth.mesh;
  CHECK_EQUAL(hsp_surface_compute(surface, h.boundary, NULL), HSP_OK);
}

/* Contacts, cells, paths, a gate, a body, sticks and balls that move likewise. */
static void make_further(void) {
  enum { CELLS_SIZE = 1 << 18, PATHS_SIZE = 1 << 19 };
  static unsigned char contacts_memory[SIZE], cells_memory[CELLS_SIZE], body_memory[SIZE];
  static unsigned char paths_memory[PATHS_SIZE], gate_memory[CELLS_SIZE], periodic_memory[PATHS_SIZE];
  static unsigned char sticks_memory[SIZE];
  const hsp_sticks_limits of_sticks = {(uint32_t)sizeof of_sticks, BALLS, 1, 32, 64};
  static unsigned char moving_memory[HSP_MOVING_BYTES(BALLS, BALLS)];
  const hsp_moving_limits of_moving = {(uint32_t)sizeof of_moving, BALLS, BALLS};
  hsp_periodic_limits of_periodic;
  hsp_paths_limits of_paths;
  hsp_gate_limits of_gate;
  hsp_contacts_limits of_contacts;
  hsp_cells_limits of_cells;
  CHECK_EQUAL(hsp_contacts_limits_init(&of_contacts, (uint32_t)sizeof of_contacts, h.boundary), HSP_OK);
  CHECK_EQUAL(hsp_contacts_init(contacts_memory, sizeof contacts_memory, &of_contacts, &contacts), HSP_OK);
  CHECK_EQUAL(hsp_cells_limits_init(&of_cells, (uint32_t)sizeof of_cells, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_cells_init(cells_memory, sizeof cells_memory, &of_cells, &cells), HSP_OK);
  CHECK_EQUAL(hsp_paths_limits_init(&of_paths, (uint32_t)sizeof of_paths, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_paths_init(paths_memory, sizeof paths_memory, &of_paths, &paths), HSP_OK);
  CHECK_EQUAL(hsp_gate_limits_init(&of_gate, (uint32_t)sizeof of_gate, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_gate_init(gate_memory, sizeof gate_memory, &of_gate, &gate), HSP_OK);
  CHECK_EQUAL(hsp_periodic_limits_init(&of_periodic, (uint32_t)sizeof of_periodic, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_periodic_init(periodic_memory, sizeof periodic_memory, &of_periodic, &periodic), HSP_OK);
  CHECK_EQUAL(hsp_moving_init(moving_memory, sizeof moving_memory, &of_moving, &moving), HSP_OK);
  CHECK_EQUAL(hsp_body_init(body_memory, sizeof body_memory, BALLS, &body), HSP_OK);
  CHECK_EQUAL(hsp_sticks_init(sticks_memory, sizeof sticks_memory, &of_sticks, &sticks), HSP_OK);
}

static void compute_further(void) {
  CHECK_EQUAL(hsp_contacts_compute(contacts, h.boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_cells_compute(cells, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_paths_compute(paths, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_gate_compute(gate, h.model, four_inside, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_body_set(body, h.model), HSP_OK);
  CHECK_EQUAL(hsp_sticks_compute_map(sticks, h.model, NULL, NULL, 0, 1, NULL, NULL), HSP_OK);
}

static void check_further(int32_t of_contacts, int32_t of_cells) {
  hsp_complex complex;
  hsp_cells_counts counts;
  hsp_widest_probe widest;
  hsp_map_info info;
  CHECK_EQUAL(hsp_map_get_info(h.map, &info), of_cells);
  CHECK_EQUAL(hsp_sticks_get_map_info(sticks, &info), of_cells);
  CHECK_EQUAL(hsp_contacts_get_complex(contacts, &complex), of_contacts);
  CHECK_EQUAL(hsp_cells_get_counts(cells, &counts), of_cells);
  CHECK_EQUAL(hsp_paths_get_points(paths, NULL, 0, &counts.cubes), of_cells);
  CHECK_EQUAL(hsp_gate_get(gate, &widest), of_cells);
}

static const char *scene;

static int32_t take_nothing(void *context, const char *bytes, size_t count) {
  (void)context;
  (void)bytes;
  (void)count;
  return 0;
}

/* Every function that takes a handle is given `handle` for it, with good arguments else. */
static void refused_as_model(void *handle) {
  hsp_model_info info;
  hsp_packing packing;
  uint32_t ids[BALLS], first[BALLS + 1], needed;
  int32_t meets;
  hsp_ray_hit hit;
  check_scene("%s as a model", scene);
  CHECK_EQUAL(hsp_map_compute(h.map, handle, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_compute(sticks, handle, NULL, NULL, 0, 1, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_compute(cells, handle, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_paths_compute(paths, handle, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_gate_compute(gate, handle, four_inside, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_set(body, handle), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_set(moving, handle, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_get_model(moving, handle), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_model_arrangement(handle, NULL, NULL, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_model_set(handle, BALLS, four_xyz, four_radius, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_model_get_info(handle, &info), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_model_get_packing(handle, &packing), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_query_point(handle, four_inside, ids, BALLS, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_query_ball(handle, four_inside, 1, ids, BALLS, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_query_meets(handle, four_inside, 1, &meets), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_query_neighbours(handle, 0, ids, BALLS, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_query_pairs(handle, 0, first, ids, BALLS, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_query_ray(handle, four_inside, four_inside, &hit), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, handle, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_begin(h.boundary, handle, 1, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_view_compute(h.view, handle, NULL, NULL, NULL), HSP_E_HANDLE);
  four_handles_compute(&h);
}

static void refused_as_boundary(void *handle) {
  hsp_contacts_limits of_contacts;
  hsp_boundary_counts counts;
  hsp_topology_limits limits;
  hsp_surface_limits of_surface;
  hsp_mesh_limits of_mesh;
  hsp_curvatures curvatures;
  hsp_totals totals;
  hsp_energy energy;
  const hsp_morphometry bending = {0, 0, 1, 0};
  uint32_t needed, invariant, id;
  double numbers[BALLS];
  check_scene("%s as a boundary", scene);
  CHECK_EQUAL(hsp_contacts_limits_init(&of_contacts, sizeof of_contacts, handle), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_compute(contacts, handle, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_compute(handle, h.model, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_begin(handle, h.model, 1, &id), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_work(handle, 0, 0), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_end(handle, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_counts(handle, &counts), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_vertices(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_arcs(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_circles(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_faces(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_loops(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_loop_arcs(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_balls(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_measure(handle, NULL, &totals, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_measure_range(handle, NULL, 0, 0, numbers, numbers), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_measure_end(handle, NULL, numbers, numbers), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_measure_faces(handle, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_gradient(handle, NULL, 1, 1, HSP_TANGENT_OVERLAP, &energy, NULL, NULL, NULL, 0, NULL, NULL),
              HSP_E_HANDLE);
  CHECK_EQUAL(
      hsp_boundary_gradient_range(handle, NULL, 1, 1, HSP_TANGENT_OVERLAP, 0, 0, numbers, numbers, &id, numbers, NULL),
      HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_gradient_end(handle, 1, 1, &energy, &id, numbers), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_derivatives(handle, NULL, HSP_TANGENT_OVERLAP, NULL, NULL, NULL, NULL, NULL, 0, NULL, NULL),
              HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_area_row(handle, 0, HSP_TANGENT_OVERLAP, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_curvature(handle, &curvatures, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_morphometry(handle, NULL, &bending, NULL, NULL, NULL, NULL, 0, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_check(handle, &invariant, &id), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, sizeof limits, handle), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_compute(h.topology, handle, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_limits_init(&of_surface, sizeof of_surface, handle), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_compute(surface, handle, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_compute_shells(surface, handle, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_limits_init(&of_mesh, sizeof of_mesh, handle, 1), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, handle, 1, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_view_compute(h.view, h.model, handle, NULL, NULL), HSP_E_HANDLE);
  four_handles_compute(&h);
}

static void refused_as_topology(void *handle) {
  hsp_topology_counts counts;
  hsp_topology_vertex vertex;
  hsp_topology_edge edge;
  uint32_t needed, cell, invariant, id;
  check_scene("%s as a topology", scene);
  CHECK_EQUAL(hsp_topology_compute(handle, h.boundary, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_counts(handle, &counts), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_onext(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_topology_lnext(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_topology_origin(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_topology_left(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_topology_get_quad_edges(handle, 0, 0, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_vertices(handle, 0, 1, &vertex), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_edges(handle, 0, 1, &edge), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_simple_faces(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_shells(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_components(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_cells(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_cell_shells(handle, 0, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_get_traversal(handle, 0, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_locate(handle, four_inside, &cell), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_topology_check(handle, &invariant, &id), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_check(cells, handle, &invariant, &id), HSP_E_HANDLE);
}

static void refused_as_surface(void *handle) {
  hsp_surface_counts counts;
  hsp_surface_map_counts map;
  hsp_mesh_limits of_mesh;
  hsp_surface_totals totals;
  hsp_energy energy;
  const uint32_t shell = 0;
  uint32_t needed, invariant, id;
  check_scene("%s as a surface", scene);
  CHECK_EQUAL(hsp_surface_compute(handle, h.boundary, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_compute_shells(handle, h.boundary, &shell, 1, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_get_counts(handle, &counts), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_measure(handle, &totals, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_gradient(handle, 1, 1, &energy, NULL, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_weighted_gradient(handle, NULL, 1, 1, &energy, NULL, NULL, NULL, 0, NULL, NULL),
              HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_get_map_counts(handle, &map), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_next(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_surface_previous(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_surface_next_loop(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_surface_origin(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_surface_left(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_surface_get_patches(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_get_edges(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_get_corners(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_get_shells(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_surface_check(handle, &invariant, &id), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&of_mesh, sizeof of_mesh, handle, 1), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, handle, 1, NULL), HSP_E_HANDLE);
}

static void refused_as_mesh(void *handle) {
  hsp_mesh_counts counts;
  uint32_t first, count;
  check_scene("%s as a mesh", scene);
  CHECK_EQUAL(hsp_mesh_compute(handle, h.boundary, 1, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_compute_surface(handle, surface, 1, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_get_counts(handle, &counts), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_get_vertices(handle, NULL, NULL, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_get_triangles(handle, NULL, NULL, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_mesh_get_patch(handle, 0, &first, &count), HSP_E_HANDLE);
}

static void refused_as_view(void *handle) {
  hsp_view_info info;
  uint32_t needed;
  check_scene("%s as a view", scene);
  CHECK_EQUAL(hsp_view_compute(handle, h.model, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_view_get_info(handle, &info), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_view_get_pieces(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_view_get_loops(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_view_get_arcs(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_picture_write(handle, NULL, NULL, NULL, NULL, take_nothing, NULL, NULL), HSP_E_HANDLE);
}

static void refused_as_map(void *handle) {
  hsp_map_info info;
  hsp_map_sight sight;
  hsp_map_point point;
  hsp_map_pole pole;
  uint32_t needed, invariant, id;
  check_scene("%s as a map", scene);
  CHECK_EQUAL(hsp_map_compute(handle, h.model, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_get_info(handle, &info), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_next(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_previous(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_next_loop(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_origin(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_left(handle, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_get_vertices(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_get_edges(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_get_faces(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_get_areas(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_get_outline(handle, 0, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_pick(handle, 0, 0, &sight), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_get_point(handle, 0, 0, &point), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_get_pole(handle, 1, &pole), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_check(handle, &invariant, &id), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_picture_write_map(handle, NULL, NULL, NULL, NULL, take_nothing, NULL, NULL), HSP_E_HANDLE);
}

static void refused_as_sticks(void *handle) {
  hsp_map_point point;
  hsp_map_pole pole;
  hsp_sticks_info info;
  hsp_map_info of_map;
  hsp_map_sight sight;
  uint32_t needed, invariant, id;
  check_scene("%s as sticks", scene);
  CHECK_EQUAL(hsp_sticks_compute(handle, h.model, NULL, NULL, 0, 1, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_compute_map(handle, h.model, NULL, NULL, 0, 1, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_info(handle, &info), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_map_info(handle, &of_map), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_vertices(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_edges(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_faces(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_areas(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_pick(handle, 0, 0, &sight), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_outline(handle, 0, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_point(handle, 0, 0, &point), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_get_pole(handle, 1, &pole), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_sticks_check(handle, &invariant, &id), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_picture_write_sticks(handle, NULL, NULL, NULL, NULL, take_nothing, NULL, NULL), HSP_E_HANDLE);
}

static void refused_as_contacts(void *handle) {
  const uint32_t group[BALLS] = {0, 0, 0, 0};
  hsp_complex complex;
  hsp_totals totals;
  uint32_t needed, invariant, id;
  check_scene("%s as contacts", scene);
  CHECK_EQUAL(hsp_contacts_compute(handle, h.boundary, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_get(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_get_row(handle, 0, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_measure(handle, &totals, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_group(handle, group, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_get_complex(handle, &complex), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_get_simplices(handle, 2, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_contacts_check(handle, &invariant, &id), HSP_E_HANDLE);
}

static void refused_as_cells(void *handle) {
  hsp_cells_counts counts;
  uint32_t needed, invariant, id;
  check_scene("%s as cells", scene);
  CHECK_EQUAL(hsp_cells_compute(handle, h.model, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_get_counts(handle, &counts), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_get_cells(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_get_pairs(handle, 0, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_get_neighbours(handle, 0, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_locate(handle, four_inside, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_cells_check(handle, NULL, &invariant, &id), HSP_E_HANDLE);
}

static void refused_as_paths(void *handle) {
  hsp_path path;
  uint32_t needed;
  check_scene("%s as paths", scene);
  CHECK_EQUAL(hsp_paths_compute(handle, h.model, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_paths_find(handle, four_inside, four_inside, &path, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_paths_get_points(handle, NULL, 0, &needed), HSP_E_HANDLE);
}

static void refused_as_gate(void *handle) {
  hsp_widest_probe widest;
  check_scene("%s as a gate", scene);
  CHECK_EQUAL(hsp_gate_compute(handle, h.model, four_inside, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_gate_get(handle, &widest), HSP_E_HANDLE);
}

static void refused_as_periodic(void *handle) {
  const hsp_morphometry bending = {0, 0, 1, 0};
  const uint32_t one_group[BALLS] = {0};
  static const double box[9] = {20, 0, 0, 0, 20, 0, 0, 0, 20};
  hsp_periodic_counts counts;
  uint32_t needed, id;
  check_scene("%s as periodic", scene);
  CHECK_EQUAL(hsp_periodic_compute(handle, BALLS, four_xyz, four_radius, NULL, box, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_counts(handle, &counts), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_measure(handle, NULL, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_curvature(handle, NULL, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_contacts(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_windings(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_components(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(
      hsp_periodic_gradient(handle, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL, NULL, NULL, NULL, NULL, NULL, 0, NULL, NULL),
      HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_morphometry(handle, NULL, &bending, NULL, NULL, NULL, NULL, NULL, NULL, 0, NULL, NULL),
              HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_group_contacts(handle, one_group, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_query_point(handle, four_xyz, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_query_ball(handle, four_xyz, 1, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_query_neighbours(handle, 0, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_query_pairs(handle, 0, &id, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_vertices(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_arcs(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_circles(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_faces(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_loops(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_loop_arcs(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_get_balls(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_periodic_check(handle, &needed, &id), HSP_E_HANDLE);
}

static void refused_as_moving(void *handle) {
  const uint32_t ball = 0;
  hsp_moving_info info;
  hsp_moving_ball record;
  uint32_t needed;
  check_scene("%s as balls that move", scene);
  CHECK_EQUAL(hsp_moving_set(handle, h.model, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_move(handle, 1, &ball, four_xyz, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_undo(handle), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_get_info(handle, &info), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_measure(handle, NULL, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_gradient(handle, NULL, NULL, NULL, NULL, 0, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_get_balls(handle, 1, &ball, &record), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_get_changed(handle, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_moving_get_model(handle, h.model), HSP_E_HANDLE);
}

static void refused_as_body(void *handle) {
  uint32_t needed;
  hsp_pose pose;
  hsp_rational_pose rational;
  memset(&pose, 0, sizeof pose);
  memset(&rational, 0, sizeof rational);
  check_scene("%s as a body", scene);
  CHECK_EQUAL(hsp_body_set(handle, h.model), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_hits(handle, body, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_hits(body, handle, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_hits_along(handle, body, 0, NULL, 1, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_hits_along(body, handle, 0, NULL, 1, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_gaps(handle, body, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_gaps(body, handle, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_overlaps(handle, body, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_overlaps(body, handle, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_pairs(handle, body, &pose, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_pairs(body, handle, &pose, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_hits(handle, body, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_hits(body, handle, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_hits_along(handle, body, 0, NULL, 1, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_hits_along(body, handle, 0, NULL, 1, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_gaps(handle, body, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_gaps(body, handle, 0, NULL, NULL, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_pairs(handle, body, &rational, NULL, 0, &needed), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_body_rational_pairs(body, handle, &rational, NULL, 0, &needed), HSP_E_HANDLE);
}

/* Every kind: its name, a handle of it, and what refuses others in its place. */
enum { KINDS = 15 };
static struct {
  const char *name;
  void *handle;
  void (*refuse)(void *);
} kinds[KINDS];

static void list_kinds(void) {
  uint32_t count = 0;
#define HSP_KIND(kind_name, kind_handle, kind_refuse) \
  kinds[count].name = kind_name;                      \
  kinds[count].handle = kind_handle;                  \
  kinds[count++].refuse = kind_refuse
  HSP_KIND("a model", h.model, refused_as_model);
  HSP_KIND("a boundary", h.boundary, refused_as_boundary);
  HSP_KIND("a topology", h.topology, refused_as_topology);
  HSP_KIND("a surface", surface, refused_as_surface);
  HSP_KIND("a mesh", mesh, refused_as_mesh);
  HSP_KIND("a view", h.view, refused_as_view);
  HSP_KIND("a map", h.map, refused_as_map);
  HSP_KIND("sticks", sticks, refused_as_sticks);
  HSP_KIND("contacts", contacts, refused_as_contacts);
  HSP_KIND("cells", cells, refused_as_cells);
  HSP_KIND("paths", paths, refused_as_paths);
  HSP_KIND("a gate", gate, refused_as_gate);
  HSP_KIND("a periodic union", periodic, refused_as_periodic);
  HSP_KIND("balls that move", moving, refused_as_moving);
  HSP_KIND("a body", body, refused_as_body);
#undef HSP_KIND
  CHECK_EQUAL(count, KINDS);
}

static void refused_as_anything(void *handle, const char *what) {
  uint32_t k;
  scene = what;
  for (k = 0; k < KINDS; ++k) kinds[k].refuse(handle);
}

/* Tags have the width of a pointer: two kinds that differ on one processor may not on another. */
static void handles_of_other_kinds(void) {
  uint32_t i, k;
  for (i = 0; i < KINDS; ++i) {
    scene = kinds[i].name;
    for (k = 0; k < KINDS; ++k) {
      if (k != i) kinds[k].refuse(kinds[i].handle);
    }
  }
}

/* Copies at another address, as realloc makes them. */
static void moved_handles(void) {
  static union {
    unsigned char bytes[4096];
    double alignment;
  } copy;
  uint32_t k;
  for (k = 0; k < KINDS; ++k) {
    unpoison(kinds[k].handle, 4096);
    memcpy(copy.bytes, kinds[k].handle, 4096);
    refused_as_anything(copy.bytes, "a moved handle");
  }
}

static void no_handles_at_all(void) {
  static union {
    unsigned char bytes[256];
    double alignment;
  } memory;
  refused_as_anything(memory.bytes, "zeros");
  memset(memory.bytes, 0xFF, sizeof memory.bytes);
  refused_as_anything(memory.bytes, "ones");
  refused_as_anything(memory.bytes + 1, "a misaligned pointer");
  refused_as_anything((unsigned char *)h.model + 1, "a pointer into a handle");
}

/* Nothing but the tag of a handle is gone: what was computed from it must not follow the pointer any more. */
static void forgotten_handles(void) {
  hsp_view_info info;
  hsp_surface_counts counts;
  uint64_t tag;
  four_handles_compute(&h);
  CHECK_EQUAL(hsp_surface_compute(surface, h.boundary, NULL), HSP_OK);
  compute_further();
  check_further(HSP_OK, HSP_OK);
  check_scene("a model without its tag");
  memcpy(&tag, h.model, sizeof tag);
  memset(h.model, 0, sizeof tag);
  check_status(contents_of_boundary(h.boundary), HSP_E_STATE);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_view_get_info(h.view, &info), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_get_counts(surface, &counts), HSP_E_STATE);
  check_further(HSP_E_STATE, HSP_E_STATE);
  memcpy(h.model, &tag, sizeof tag);
  check_scene("a boundary without its tag");
  memcpy(&tag, h.boundary, sizeof tag);
  memset(h.boundary, 0, sizeof tag);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_get_counts(surface, &counts), HSP_E_STATE);
  check_further(HSP_E_STATE, HSP_OK);
  memcpy(h.boundary, &tag, sizeof tag);
  CHECK_EQUAL(hsp_surface_get_counts(surface, &counts), HSP_OK);
  check_status(contents_of_topology(h.topology), HSP_OK);
  CHECK_EQUAL(hsp_view_get_info(h.view, &info), HSP_OK);
}

/* The memory of a model becomes that of a boundary: what was computed from the model is out of date, and the pointer to
 * the model is refused. */
static void dead_handles(void) {
  const hsp_boundary_limits limits = four_boundary_limits(FEW);
  hsp_boundary *instead = NULL;
  hsp_boundary_counts counts;
  hsp_view_info info;
  void *const model = h.model;
  CHECK_EQUAL(hsp_boundary_init(h.model_memory, SIZE, &limits, &instead), HSP_OK);
  check_scene("a model that is a boundary now");
  CHECK_EQUAL(hsp_boundary_get_counts(h.boundary, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_view_get_info(h.view, &info), HSP_E_STATE);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, model, NULL), HSP_E_HANDLE);
  CHECK_EQUAL(hsp_boundary_get_counts(instead, &counts), HSP_E_STATE);
  unpoison(h.model_memory, SIZE);
  memset(h.model_memory, 0, SIZE);
  CHECK_EQUAL(hsp_boundary_get_counts(instead, &counts), HSP_E_HANDLE);
}

int main(void) {
  h = four_handles_make(BALLS);
  four_handles_compute(&h);
  make_surface();
  make_further();
  list_kinds();
  handles_of_other_kinds();
  moved_handles();
  no_handles_at_all();
  forgotten_handles();
  dead_handles();
  return check_report();
}
