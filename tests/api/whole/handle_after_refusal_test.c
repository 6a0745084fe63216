/* A refused call of any function but set and compute leaves what a handle holds as it is. */
#include <hardsphere.h>
#include <math.h>

#include "check.h"
#include "four_handles.h"

static int32_t refuse_bytes(void *context, const char *bytes, size_t count) {
  (void)context;
  (void)bytes;
  return count > 0;
}

static void refused_of_model(void) {
  const four_handles h = four_handles_make(BALLS);
  static const double nowhere[3] = {0, NAN, 0}, far_away[3] = {0, 0, 1e300};
  hsp_model *made = NULL;
  model_contents before, after;
  uint32_t ids[BALLS], first[BALLS + 1], count;
  uint32_t meets;
  hsp_ray_hit hit;
  four_handles_set(&h, BALLS);
  before = contents_of_model(h.model);
  CHECK_EQUAL(before.status, HSP_OK);
  CHECK_EQUAL(before.hit_count, 3);
  CHECK_EQUAL(hsp_model_init(h.model_memory, 10, BALLS, &made), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_model_init(h.model_memory, SIZE, BALLS, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_model_init(h.model_memory, SIZE, HSP_NONE, &made), HSP_E_RANGE);
  CHECK_EQUAL(hsp_model_set(NULL, BALLS, four_xyz, four_radius, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_model_get_info(h.model, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_model_get_packing(h.model, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_query_point(h.model, NULL, ids, BALLS, &count), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_query_point(h.model, nowhere, ids, BALLS, &count), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_query_ball(h.model, far_away, 1, ids, BALLS, &count), HSP_E_RANGE);
  CHECK_EQUAL(hsp_query_ball(h.model, four_inside, 1, ids, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_query_meets(h.model, four_inside, -1, &meets), HSP_E_NEGATIVE);
  CHECK_EQUAL(hsp_query_neighbours(h.model, BALLS, ids, BALLS, &count), HSP_E_ID);
  CHECK_EQUAL(hsp_query_pairs(h.model, 2, first, ids, BALLS, &count), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_query_pairs(h.model, 0, first, ids, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_query_ray(h.model, far_away, four_inside, &hit), HSP_E_RANGE);
  CHECK_EQUAL(hsp_boundary_compute(NULL, h.model, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_compute(NULL, h.model, NULL, NULL, NULL), HSP_E_ARGUMENT);
  after = contents_of_model(h.model);
  CHECK_BYTES(&after, &before, sizeof after);
}

static void refused_of_boundary(void) {
  const four_handles h = four_handles_make(BALLS);
  hsp_boundary_limits limits = four_boundary_limits(BALLS);
  hsp_topology_limits of_topology;
  hsp_boundary *made = NULL;
  contents before;
  double number[3 * BALLS];
  hsp_vertex vertex;
  uint32_t invariant, id, count;
  four_handles_compute(&h);
  before = contents_of_boundary(h.boundary);
  CHECK_EQUAL(hsp_boundary_init(h.boundary_memory, 10, &limits, &made), HSP_E_MEMORY);
  limits.struct_size = 4;
  CHECK_EQUAL(hsp_boundary_init(h.boundary_memory, SIZE, &limits, &made), HSP_E_VERSION);
  limits = four_boundary_limits(BALLS);
  limits.circles = HSP_NONE;
  CHECK_EQUAL(hsp_boundary_init(h.boundary_memory, SIZE, &limits, &made), HSP_E_RANGE);
  limits = four_boundary_limits(BALLS);
  limits.workers = HSP_MAX_WORKERS + 1;
  CHECK_EQUAL(hsp_boundary_init(h.boundary_memory, SIZE, &limits, &made), HSP_E_RANGE);
  CHECK_EQUAL(hsp_boundary_get_counts(h.boundary, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_vertices(h.boundary, &vertex, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_get_arcs(h.boundary, NULL, 0, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_get_circles(h.boundary, NULL, 1, &count), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_faces(h.boundary, NULL, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_loops(h.boundary, NULL, 0, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_get_loop_arcs(h.boundary, NULL, 1, &count), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_balls(h.boundary, NULL, 0, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_measure(h.boundary, NULL, NULL, number, NULL, BALLS - 1, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_measure(h.boundary, NULL, NULL, NULL, number, 0, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_measure_faces(h.boundary, number, NULL, 1, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_get_gradient(h.boundary, SIZED(hsp_gradient_request, .tension = NAN),
                                        SIZED(hsp_gradient_outputs, .capacity = 0)),
              HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_boundary_get_gradient(h.boundary, SIZED(hsp_gradient_request, .tension = 1, .tangency = 2),
                                        SIZED(hsp_gradient_outputs, .capacity = 0)),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_area_row(h.boundary, BALLS, HSP_TANGENT_DISJOINT, NULL, 0, &count), HSP_E_ID);
  CHECK_EQUAL(hsp_boundary_check(h.boundary, NULL, &id), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_check(h.boundary, &invariant, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_init(&of_topology, 0, h.boundary), HSP_E_VERSION);
  CHECK_EQUAL(hsp_topology_compute(NULL, h.boundary, NULL), HSP_E_ARGUMENT);
  check_same_contents(&before, contents_of_boundary(h.boundary));
}

static void refused_of_topology(void) {
  const four_handles h = four_handles_make(BALLS);
  static const double nowhere[3] = {0, NAN, 0};
  hsp_topology_limits limits = four_topology_limits(BALLS);
  hsp_topology *made = NULL;
  contents before;
  hsp_topology_edge edge;
  hsp_simple_face face;
  hsp_topology_vertex vertex;
  uint32_t ids[2], cell, invariant, id, count;
  four_handles_compute(&h);
  before = contents_of_topology(h.topology);
  CHECK_EQUAL(hsp_topology_init(h.topology_memory, 10, &limits, &made), HSP_E_MEMORY);
  limits.struct_size = 0;
  CHECK_EQUAL(hsp_topology_init(h.topology_memory, SIZE, &limits, &made), HSP_E_VERSION);
  limits = four_topology_limits(BALLS);
  limits.edges = HSP_NONE;
  CHECK_EQUAL(hsp_topology_init(h.topology_memory, SIZE, &limits, &made), HSP_E_RANGE);
  CHECK_EQUAL(hsp_topology_get_counts(h.topology, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_quad_edges(h.topology, HSP_NONE, 1, ids, NULL), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_vertices(h.topology, HSP_NONE, 1, &vertex), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_edges(h.topology, 0, HSP_NONE, &edge), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_simple_faces(h.topology, 1, HSP_NONE, &face), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_shells(h.topology, NULL, 0, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_topology_get_components(h.topology, NULL, 1, &count), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_regions(h.topology, NULL, 0, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_topology_get_region_shells(h.topology, HSP_NONE, ids, 2, &count), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_traversal(h.topology, 0, ids, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_topology_locate(h.topology, nowhere, &cell), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_topology_check(h.topology, NULL, &id), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_check(h.topology, &invariant, NULL), HSP_E_ARGUMENT);
  check_same_contents(&before, contents_of_topology(h.topology));
}

static void refused_of_view(void) {
  const four_handles h = four_handles_make(BALLS);
  static const uint32_t no_colours[BALLS] = {0, 0, 0, 0x1000000};
  hsp_view_limits limits = four_view_limits(BALLS);
  hsp_view *made = NULL;
  contents before;
  hsp_view_piece piece;
  hsp_view_loop loop;
  hsp_view_arc arc;
  hsp_picture_options options;
  uint32_t count;
  four_handles_compute(&h);
  before = contents_of_view(h.view);
  CHECK_EQUAL(hsp_view_init(h.view_memory, 10, &limits, &made), HSP_E_MEMORY);
  limits.arcs = HSP_NONE;
  CHECK_EQUAL(hsp_view_init(h.view_memory, SIZE, &limits, &made), HSP_E_RANGE);
  CHECK_EQUAL(hsp_view_init(h.view_memory, SIZE, NULL, &made), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_get_info(h.view, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_get_pieces(h.view, &piece, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_view_get_loops(h.view, &loop, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_view_get_arcs(h.view, &arc, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.margin = NAN;
  CHECK_EQUAL(hsp_picture_write(h.view, NULL, &options, NULL, NULL, refuse_bytes, NULL, NULL), HSP_E_NOT_FINITE);
  options.margin = -1;
  CHECK_EQUAL(hsp_picture_write(h.view, NULL, &options, NULL, NULL, refuse_bytes, NULL, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_picture_write(h.view, no_colours, NULL, NULL, NULL, refuse_bytes, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_picture_write(h.view, NULL, NULL, NULL, NULL, NULL, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_picture_write(h.view, NULL, NULL, NULL, NULL, refuse_bytes, NULL, NULL), HSP_E_SINK);
  check_same_contents(&before, contents_of_view(h.view));
}

static void refused_of_surface(void) {
  const four_handles h = four_handles_make(BALLS);
  const fifth_handles f = fifth_handles_make(BALLS);
  static const double weights[BALLS] = {1, 2, NAN, 3};
  hsp_surface_limits limits = four_surface_limits(BALLS);
  hsp_surface *made = NULL;
  contents before;
  hsp_surface_totals totals[BALLS];
  hsp_surface_patch patch;
  hsp_surface_edge edge;
  hsp_surface_corner corner;
  hsp_mesh_limits of_mesh;
  double number[3 * BALLS];
  uint32_t invariant, id, count;
  four_handles_compute(&h);
  CHECK_EQUAL(hsp_surface_compute(f.surface, h.boundary, NULL), HSP_OK);
  before = contents_of_surface(f.surface);
  check_status(before, HSP_OK);
  CHECK_EQUAL(hsp_surface_init(f.surface_memory, 10, &limits, &made), HSP_E_MEMORY);
  limits.struct_size = 4;
  CHECK_EQUAL(hsp_surface_init(f.surface_memory, FIFTH_SIZE, &limits, &made), HSP_E_VERSION);
  limits = four_surface_limits(BALLS);
  limits.pieces = HSP_NONE;
  CHECK_EQUAL(hsp_surface_init(f.surface_memory, FIFTH_SIZE, &limits, &made), HSP_E_RANGE);
  CHECK_EQUAL(hsp_surface_get_counts(f.surface, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_surface_measure(f.surface, NULL, totals, BALLS - 1, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_surface_get_gradient(f.surface, SIZED(hsp_gradient_request, .tension = 1, .pressure = NAN),
                                       SIZED(hsp_gradient_outputs, .d_centre = number, .capacity = BALLS)),
              HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_surface_get_gradient(f.surface, SIZED(hsp_gradient_request, .tension = 1, .pressure = 1),
                                       SIZED(hsp_gradient_outputs, .d_centre = number)),
              HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_surface_get_gradient(f.surface, SIZED(hsp_gradient_request, .sigma = weights, .tension = 1),
                                       SIZED(hsp_gradient_outputs, .d_centre = number, .capacity = BALLS)),
              HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_surface_get_part_counts(f.surface, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_surface_get_patches(f.surface, HSP_NONE, 1, &patch), HSP_E_ID);
  CHECK_EQUAL(hsp_surface_get_edges(f.surface, 0, HSP_NONE, &edge), HSP_E_ID);
  CHECK_EQUAL(hsp_surface_get_corners(f.surface, HSP_NONE, 2, &corner), HSP_E_ID);
  CHECK_EQUAL(hsp_surface_get_shells(f.surface, NULL, 0, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_surface_check(f.surface, NULL, &id), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_surface_check(f.surface, &invariant, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&of_mesh, 0, f.surface, 2), HSP_E_VERSION);
  CHECK_EQUAL(hsp_mesh_compute_surface(NULL, f.surface, 2, NULL), HSP_E_ARGUMENT);
  check_same_contents(&before, contents_of_surface(f.surface));
}

static void refused_of_mesh(void) {
  const four_handles h = four_handles_make(BALLS);
  const fifth_handles f = fifth_handles_make(BALLS);
  hsp_mesh_limits limits = four_mesh_limits();
  hsp_mesh *made = NULL;
  contents before;
  double points[3];
  uint32_t ids[3], first, count;
  four_handles_compute(&h);
  CHECK_EQUAL(hsp_mesh_compute(f.mesh, h.boundary, 2, NULL), HSP_OK);
  before = contents_of_mesh(f.mesh);
  check_status(before, HSP_OK);
  CHECK_EQUAL(hsp_mesh_init(f.mesh_memory, 10, &limits, &made), HSP_E_MEMORY);
  limits.struct_size = 0;
  CHECK_EQUAL(hsp_mesh_init(f.mesh_memory, FIFTH_SIZE, &limits, &made), HSP_E_VERSION);
  limits = four_mesh_limits();
  limits.points = HSP_NONE;
  CHECK_EQUAL(hsp_mesh_init(f.mesh_memory, FIFTH_SIZE, &limits, &made), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_get_counts(f.mesh, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_get_vertices(f.mesh, points, NULL, NULL, NULL, 1, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_mesh_get_triangles(f.mesh, ids, NULL, NULL, NULL, 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_mesh_get_patch(f.mesh, 0, NULL, &count), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_get_patch(f.mesh, 0, &first, NULL), HSP_E_ARGUMENT);
  check_same_contents(&before, contents_of_mesh(f.mesh));
}

static void refused_of_map(void) {
  const four_handles h = four_handles_make(BALLS);
  hsp_map_limits limits = four_map_limits(BALLS);
  hsp_map *made = NULL;
  contents before;
  hsp_map_vertex vertex;
  hsp_map_edge edge;
  hsp_map_face face;
  hsp_map_sight sight;
  hsp_map_point point;
  hsp_map_pole pole;
  double area[BALLS];
  uint32_t invariant, id, loop, count;
  four_handles_compute(&h);
  before = contents_of_map(h.map);
  CHECK_EQUAL(hsp_map_init(h.map_memory, 10, &limits, &made), HSP_E_MEMORY);
  limits.edges = HSP_NONE;
  CHECK_EQUAL(hsp_map_init(h.map_memory, SIZE, &limits, &made), HSP_E_RANGE);
  CHECK_EQUAL(hsp_map_init(h.map_memory, SIZE, NULL, &made), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_info(h.map, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_vertices(h.map, HSP_NONE, 1, &vertex), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_edges(h.map, 0, HSP_NONE, &edge), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_faces(h.map, 1, HSP_NONE, &face), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_areas(h.map, area, BALLS - 1, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_map_get_outline(h.map, BALLS, &loop, 1, &count), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_outline(h.map, 0, NULL, 0, &count), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_map_pick(h.map, NAN, 0, &sight), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_map_get_point(h.map, HSP_NONE, 0, &point), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_point(h.map, 0, 1000, &point), HSP_E_RANGE);
  CHECK_EQUAL(hsp_map_get_pole(h.map, 0, &pole), HSP_E_ID);
  CHECK_EQUAL(hsp_map_check(h.map, NULL, &id), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_check(h.map, &invariant, NULL), HSP_E_ARGUMENT);
  check_same_contents(&before, contents_of_map(h.map));
}

int main(void) {
  refused_of_model();
  refused_of_boundary();
  refused_of_topology();
  refused_of_view();
  refused_of_map();
  refused_of_surface();
  refused_of_mesh();
  return check_report();
}
