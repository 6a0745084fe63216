/* The library never allocates: malloc and its relatives are replaced by functions that count while armed, and every
 * entry point is called armed. For glibc only, and not for sanitizer builds, which bring their own malloc. */
#include <hardsphere.h>
#include <stdlib.h>

#include "ball_sets.h"
#include "check.h"
#include "malloc_trap.h"
#include "map_result.h"
#include "mesh_result.h"
#include "surface_result.h"
#include "topology_result.h"
#include "topology_sets.h"
#include "view_result.h"

/* What the functions write into besides the arrays of results. */
typedef struct buffers {
  size_t model_bytes, boundary_bytes;
  void *model, *boundary;
  uint32_t *ids, *flags;   /* [n] */
  uint32_t *first, *pairs; /* [n + 1] [pair_count] */
  uint32_t pair_count;
  uint8_t *selected;               /* [n] */
  double *face_area, *face_volume; /* [faces] */
  double *by_centre;               /* [n][3] */
  double *by_radius;               /* [n] */
  hsp_area_derivative *row;        /* [n] */
} buffers;

static buffers buffers_for(const computed *c) {
  buffers b;
  CHECK_EQUAL(hsp_model_bytes(c->n, &b.model_bytes), HSP_OK);
  CHECK_EQUAL(hsp_boundary_bytes(&c->needed, &b.boundary_bytes), HSP_OK);
  b.model = test_zeros(b.model_bytes, 1);
  b.boundary = test_zeros(b.boundary_bytes, 1);
  b.ids = test_zeros(c->n, sizeof *b.ids);
  b.flags = test_zeros(c->n, sizeof *b.flags);
  b.first = test_zeros(c->n + 1, sizeof *b.first);
  (void)hsp_query_pairs(c->model, 0, b.first, NULL, 0, &b.pair_count);
  b.pairs = test_zeros(b.pair_count, sizeof *b.pairs);
  b.selected = test_zeros(c->n, sizeof *b.selected);
  b.selected[0] = 1;
  b.face_area = test_zeros(c->counts.faces, sizeof *b.face_area);
  b.face_volume = test_zeros(c->counts.faces, sizeof *b.face_volume);
  b.by_centre = test_zeros(c->n, 3 * sizeof *b.by_centre);
  b.by_radius = test_zeros(c->n, sizeof *b.by_radius);
  b.row = test_zeros(c->n, sizeof *b.row);
  return b;
}

static void buffers_release(buffers *b) {
  free(b->model);
  free(b->boundary);
  free(b->ids);
  free(b->flags);
  free(b->first);
  free(b->pairs);
  free(b->selected);
  free(b->face_area);
  free(b->face_volume);
  free(b->by_centre);
  free(b->by_radius);
  free(b->row);
}

/* Every function but those of topologies, views, sticks, pictures and maps, into the arrays of `c` and `numbers`; how
 * many calls did not succeed. */
static int call_boundary(computed *c, const buffers *b) {
  hsp_model *model = NULL;
  hsp_boundary *boundary = NULL;
  hsp_model_options options;
  hsp_model_info info;
  hsp_packing figures;
  hsp_boundary_limits limits;
  hsp_boundary_counts counts;
  hsp_totals totals;
  hsp_energy energy;
  uint32_t needed, invariant, id, flags, stages = 0, stage;
  int32_t meets;
  hsp_ray_hit hit;
  size_t bytes;
  double radius;
  int bad = 0;
  bad += hsp_version() != HSP_VERSION_NUMBER;
  bad += hsp_abi() != HSP_ABI_NUMBER;
  bad += hsp_numerics() != HSP_NUMERICS_NUMBER;
  bad += hsp_status_text(HSP_OK) == NULL;
  bad += hsp_model_bytes(c->n, &bytes) != HSP_OK;
  bad += hsp_model_init(b->model, b->model_bytes, c->n, &model) != HSP_OK;
  bad += hsp_element_radius(HSP_RADII_BONDI, 6, &radius, &flags) != HSP_OK;
  bad += hsp_model_options_init(&options, (uint32_t)sizeof options) != HSP_OK;
  bad += hsp_model_set(model, c->n, c->xyz, c->radius, &options, NULL) != HSP_OK;
  bad += hsp_model_get_info(model, &info) != HSP_OK;
  bad += hsp_model_get_packing(model, &figures) != HSP_OK;
  bad += hsp_query_point(model, c->xyz, b->ids, c->n, &needed) != HSP_OK;
  bad += hsp_query_ball(model, c->xyz, 3, b->ids, c->n, &needed) != HSP_OK;
  bad += hsp_query_meets(model, c->xyz, 3, &meets) != HSP_OK;
  bad += hsp_query_neighbours(model, 0, b->ids, c->n, &needed) != HSP_OK;
  bad += hsp_query_pairs(model, 0, b->first, NULL, 0, &needed) != (needed > 0 ? HSP_E_CAPACITY : HSP_OK);
  bad += hsp_query_pairs(model, 0, b->first, b->pairs, b->pair_count, &needed) != HSP_OK;
  bad += hsp_query_pairs(model, HSP_PAIRS_ONCE, b->first, b->pairs, b->pair_count, &needed) != HSP_OK;
  bad += hsp_query_ray(model, c->xyz, c->xyz + 3, &hit) == HSP_E_ARGUMENT;
  bad += hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, c->n) != HSP_OK;
  bad += hsp_boundary_bytes(&c->needed, &bytes) != HSP_OK;
  bad += hsp_boundary_init(b->boundary, b->boundary_bytes, &c->needed, &boundary) != HSP_OK;
  bad += hsp_boundary_compute(boundary, model, NULL) != HSP_OK;
  bad += hsp_boundary_begin(boundary, model, 1, &stages) != HSP_OK;
  for (stage = 0; stage < stages; ++stage) bad += hsp_boundary_work(boundary, stage, 0) != HSP_OK;
  bad += hsp_boundary_end(boundary, NULL) != HSP_OK;
  bad += hsp_boundary_get_counts(boundary, &counts) != HSP_OK;
  bad += hsp_boundary_get_vertices(boundary, c->vertices, counts.vertices, &needed) != HSP_OK;
  bad += hsp_boundary_get_arcs(boundary, c->arcs, counts.arcs, &needed) != HSP_OK;
  bad += hsp_boundary_get_circles(boundary, c->circles, counts.circles, &needed) != HSP_OK;
  bad += hsp_boundary_get_faces(boundary, c->faces, counts.faces, &needed) != HSP_OK;
  bad += hsp_boundary_get_loops(boundary, c->loops, counts.loops, &needed) != HSP_OK;
  bad += hsp_boundary_get_loop_arcs(boundary, c->loop_arcs, 2 * counts.arcs, &needed) != HSP_OK;
  bad += hsp_boundary_get_balls(boundary, c->balls, c->n, &needed) != HSP_OK;
  bad += hsp_boundary_measure(boundary, NULL, &totals, c->area, c->volume, c->n, NULL) != HSP_OK;
  bad += hsp_boundary_measure(boundary, b->selected, &totals, c->area, c->volume, c->n, NULL) != HSP_OK;
  bad += hsp_boundary_measure_range(boundary, NULL, 0, c->n, c->area, c->volume) != HSP_OK;
  bad += hsp_boundary_measure_end(boundary, &totals, c->area, c->volume) != HSP_OK;
  bad += hsp_boundary_measure_faces(boundary, b->face_area, b->face_volume, counts.faces, NULL) != HSP_OK;
  bad += hsp_boundary_gradient(boundary, NULL, 1, 1, HSP_TANGENT_OVERLAP, &energy, b->by_centre, b->by_radius, b->flags,
                               c->n, NULL, NULL) != HSP_OK;
  bad += hsp_boundary_gradient_range(boundary, NULL, 1, 1, HSP_TANGENT_OVERLAP, 0, c->n, b->by_centre, b->by_radius,
                                     b->flags, b->by_centre, NULL) != HSP_OK;
  bad += hsp_boundary_gradient_end(boundary, 1, 1, &energy, b->flags, b->by_centre) != HSP_OK;
  bad += hsp_boundary_derivatives(boundary, NULL, HSP_TANGENT_OVERLAP, NULL, c->area, NULL, c->volume, NULL, c->n,
                                  &needed, NULL) != HSP_OK;
  bad += hsp_boundary_get_area_row(boundary, 0, HSP_TANGENT_DISJOINT, b->row, c->n, &needed) != HSP_OK;
  bad += hsp_boundary_check(boundary, &invariant, &id) != HSP_OK;
  return bad;
}

/* Every function of topologies, into the arrays of `t`; the number of calls that did not succeed. */
static int call_surface(surface_result *s, void *memory, size_t bytes) {
  const computed *c = s->base;
  hsp_surface *surface = NULL;
  hsp_surface_limits limits;
  hsp_surface_counts counts;
  hsp_energy energy;
  hsp_surface_map_counts map;
  hsp_surface_patch patch;
  hsp_surface_edge edge;
  hsp_surface_corner corner;
  uint32_t needed = 0, invariant, id;
  int32_t status;
  size_t size = 0;
  int bad = 0;
  bad += hsp_surface_limits_init(&limits, (uint32_t)sizeof limits, c->boundary) != HSP_OK;
  bad += hsp_surface_bytes(&s->needed, &size) != HSP_OK;
  bad += hsp_surface_init(memory, bytes, &s->needed, &surface) != HSP_OK;
  bad += hsp_surface_compute_shells(surface, c->boundary, &needed, 1, NULL) != HSP_OK;
  bad += hsp_surface_compute(surface, c->boundary, NULL) != HSP_OK;
  bad += hsp_surface_get_counts(surface, &counts) != HSP_OK;
  bad += hsp_surface_measure(surface, &s->totals, s->balls, c->n, &needed) != HSP_OK;
  bad += hsp_surface_gradient(surface, 1, 1, &energy, NULL, c->area, NULL, c->n, &needed) != HSP_OK;
  bad += hsp_surface_weighted_gradient(surface, c->radius, 1, 1, &energy, NULL, c->area, NULL, c->n, &needed, NULL) !=
         HSP_OK;
  bad += hsp_surface_check(surface, &invariant, &id) != (counts.open_joints == 0 ? HSP_OK : HSP_E_OPEN_SURFACE);
  status = hsp_surface_get_map_counts(surface, &map);
  bad += status != (counts.open_joints == 0 ? HSP_OK : HSP_E_OPEN_SURFACE);
  if (status != HSP_OK) return bad;
  for (id = 0; id < map.patches; ++id) bad += hsp_surface_get_patches(surface, id, 1, &patch) != HSP_OK;
  for (id = 0; id < map.edges; ++id) bad += hsp_surface_get_edges(surface, id, 1, &edge) != HSP_OK;
  for (id = 0; id < map.corners; ++id) bad += hsp_surface_get_corners(surface, id, 1, &corner) != HSP_OK;
  for (id = 0; id < 2 * map.edges; ++id) {
    bad += hsp_surface_next(surface, hsp_surface_previous(surface, id)) != id;
    bad += hsp_surface_left(surface, hsp_surface_next_loop(surface, id)) != hsp_surface_left(surface, id);
    bad += hsp_surface_origin(surface, id) == map.corners;
  }
  bad += hsp_surface_get_shells(surface, NULL, 0, &needed) != (map.shells == 0 ? HSP_OK : HSP_E_CAPACITY);
  return bad;
}

static int call_mesh(mesh_result *m, void *memory, size_t bytes) {
  const computed *c = m->base;
  hsp_mesh *mesh = NULL;
  hsp_mesh_limits limits;
  hsp_mesh_counts counts = {0, 0, 0, 0};
  uint32_t needed = 0;
  size_t size = 0;
  int bad = 0;
  bad += hsp_mesh_limits_init(&limits, (uint32_t)sizeof limits, c->boundary, m->edge) != HSP_OK;
  bad += hsp_mesh_bytes(&m->needed, &size) != HSP_OK;
  bad += hsp_mesh_init(memory, bytes, &m->needed, &mesh) != HSP_OK;
  bad += hsp_mesh_compute(mesh, c->boundary, m->edge, NULL) != HSP_OK;
  bad += hsp_mesh_get_counts(mesh, &counts) != HSP_OK;
  bad += hsp_mesh_get_vertices(mesh, m->xyz[0], m->normals[0], m->areas, m->vertex_balls, counts.vertices, &needed) !=
         HSP_OK;
  bad +=
      hsp_mesh_get_triangles(mesh, m->corners[0], m->kinds, m->patches, m->balls, counts.triangles, &needed) != HSP_OK;
  return bad;
}

static int call_surface_mesh(const mesh_result *m, void *memory, size_t bytes) {
  hsp_mesh *mesh = NULL;
  hsp_mesh_limits limits;
  uint32_t first = 0, count = 0;
  int bad = 0;
  bad += hsp_mesh_limits_init_surface(&limits, (uint32_t)sizeof limits, m->surface, m->edge) != HSP_OK;
  bad += hsp_mesh_init(memory, bytes, &m->needed, &mesh) != HSP_OK;
  bad += hsp_mesh_compute_surface(mesh, m->surface, m->edge, NULL) != HSP_OK;
  bad += hsp_mesh_get_patch(mesh, 0, &first, &count) != HSP_OK || count == 0;
  return bad;
}

static int32_t count_bytes(void *context, const char *bytes, size_t count) {
  (void)bytes;
  *(uint64_t *)context += count;
  return 0;
}

/* Every format in every style, of a view or else of a map; the number of calls that did not succeed. */
static int write_everything(hsp_view *view, hsp_map *map, const uint32_t *colour) {
  hsp_picture_options options;
  uint32_t format, style;
  int bad = hsp_picture_options_init(&options, (uint32_t)sizeof options) != HSP_OK;
  for (format = HSP_FORMAT_SVG; format <= HSP_FORMAT_PDF; ++format) {
    for (style = HSP_STYLE_FLAT; style <= HSP_STYLE_SOFT; ++style) {
      uint64_t taken = 0, said = 0;
      options.format = format;
      options.style = style;
      if (map == NULL) {
        bad += hsp_picture_write(view, colour, &options, "title", "text", count_bytes, &taken, &said) != HSP_OK;
      } else {
        bad += hsp_picture_write_map(map, colour, &options, "title", "text", count_bytes, &taken, &said) != HSP_OK;
      }
      bad += taken == 0 || taken != said;
    }
  }
  return bad;
}

static int call_contacts(const computed *c, void *memory, size_t bytes) {
  static hsp_contact contact[64];
  static hsp_group_contact sum[64];
  static hsp_simplex simplex[64];
  static const uint32_t group[4] = {0, 1, 1, 2};
  hsp_contacts *contacts = NULL;
  hsp_contacts_limits limits;
  hsp_complex counts;
  hsp_totals totals;
  hsp_curvatures curvatures;
  hsp_morphometric_energy energy;
  const hsp_morphometry factors = {1, 1, 1, 1};
  uint32_t needed, invariant, id;
  size_t size = 0;
  int bad = 0;
  bad += hsp_contacts_limits_init(&limits, (uint32_t)sizeof limits, c->boundary) != HSP_OK;
  limits.triangles = limits.tetrahedra = 64;
  bad += hsp_contacts_bytes(&limits, &size) != HSP_OK || size > bytes;
  bad += hsp_contacts_init(memory, size, &limits, &contacts) != HSP_OK;
  bad += hsp_contacts_compute(contacts, c->boundary, &limits) != HSP_OK;
  bad += hsp_contacts_get(contacts, contact, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_contacts_get_row(contacts, 0, contact, 64, &needed) != HSP_OK;
  bad += hsp_contacts_measure(contacts, &totals, c->area, c->volume, c->n, &needed) != HSP_OK;
  bad += hsp_contacts_group(contacts, group, sum, 64, &needed) != HSP_OK;
  bad += hsp_contacts_get_complex(contacts, &counts) != HSP_OK;
  bad += hsp_contacts_get_simplices(contacts, 2, simplex, 64, &needed) != HSP_OK;
  bad += hsp_contacts_check(contacts, &invariant, &id) != HSP_OK;
  bad += hsp_boundary_curvature(c->boundary, &curvatures, c->area, NULL, c->n, &needed) != HSP_OK;
  bad += hsp_boundary_morphometry(c->boundary, NULL, &factors, &energy, NULL, c->area, NULL, c->n, &needed, NULL) !=
         HSP_OK;
  return bad;
}

/* Balls and sticks, which have an order to paint them if `edges` is 0. */
static int call_sticks(const hsp_model *model, void *memory, size_t bytes, uint32_t edges) {
  static const hsp_stick stick[2] = {{{0, 1}, 0, 0}, {{2, 1}, HSP_STICK_WHOLE, 0}};
  hsp_sticks *sticks = NULL;
  hsp_sticks_limits limits;
  hsp_sticks_conflict conflict;
  hsp_sticks_info info;
  hsp_map_info map_info;
  hsp_map_vertex vertex;
  hsp_map_edge edge;
  hsp_map_face face;
  hsp_map_sight sight;
  hsp_map_point point;
  hsp_map_pole pole;
  hsp_picture_options options;
  double area[7];
  uint32_t needed = 0, invariant = 0, id = 0, outline[7];
  size_t size = 0;
  int bad = hsp_picture_options_init(&options, (uint32_t)sizeof options) != HSP_OK;
  bad += hsp_sticks_limits_init(&limits, (uint32_t)sizeof limits, 3) != HSP_OK;
  limits.edges = edges;
  bad += hsp_sticks_bytes(&limits, &size) != HSP_OK || size > bytes;
  bad += hsp_sticks_init(memory, size, &limits, &sticks) != HSP_OK;
  bad += hsp_sticks_compute(sticks, model, NULL, stick, 2, 0.5, &conflict, NULL) != HSP_OK;
  bad += hsp_sticks_get_info(sticks, &info) != HSP_OK;
  bad += info.balls != 3;
  bad += (conflict.kind == HSP_STICKS_BALLS_MEET) != (edges > 0);
  if (edges > 0) {
    bad += hsp_sticks_compute_map(sticks, model, NULL, stick, 2, 0.5, NULL, NULL) != HSP_OK;
    bad += hsp_sticks_get_map_info(sticks, &map_info) != HSP_OK;
    bad += hsp_sticks_get_vertices(sticks, 0, 1, &vertex) != HSP_OK;
    bad += hsp_sticks_get_edges(sticks, 0, 1, &edge) != HSP_OK;
    bad += hsp_sticks_get_faces(sticks, 1, 1, &face) != HSP_OK;
    bad += hsp_sticks_get_areas(sticks, area, 7, &needed) != HSP_OK;
    bad += hsp_sticks_pick(sticks, 0, 0, &sight) != HSP_OK;
    bad += hsp_sticks_get_outline(sticks, 0, outline, 7, &needed) != HSP_OK;
    bad += hsp_sticks_get_point(sticks, 0, edge.from, &point) != HSP_OK;
    bad += hsp_sticks_get_pole(sticks, 1, &pole) != HSP_OK;
    bad += hsp_sticks_check(sticks, &invariant, &id) != HSP_OK;
  }
  for (options.format = HSP_FORMAT_SVG; options.format <= HSP_FORMAT_PDF; ++options.format) {
    uint64_t taken = 0, said = 0;
    bad += hsp_picture_write_sticks(sticks, NULL, &options, "title", "text", count_bytes, &taken, &said) != HSP_OK;
    bad += taken == 0 || taken != said;
  }
  return bad;
}

/* Cells of free space, all functions. */
static int call_cells(const hsp_model *model, void *memory, size_t bytes) {
  static const double origin[3] = {0, 0, 0};
  hsp_cells *cells = NULL;
  hsp_cells_limits limits;
  hsp_cells_counts counts;
  hsp_free_cell cell;
  hsp_cell_pair pair;
  hsp_arrangement arrangement;
  uint32_t neighbours[64], needed = 0, found = 0;
  size_t size = 0;
  int bad = hsp_cells_limits_init(&limits, (uint32_t)sizeof limits, 3) != HSP_OK;
  bad += hsp_cells_bytes(&limits, &size) != HSP_OK || size > bytes;
  bad += hsp_cells_init(memory, size, &limits, &cells) != HSP_OK;
  bad += hsp_cells_compute(cells, model, NULL) != HSP_OK;
  bad += hsp_cells_get_counts(cells, &counts) != HSP_OK || counts.regions != 1;
  bad += hsp_cells_get_cells(cells, 0, 1, &cell) != HSP_OK;
  bad += hsp_cells_get_pairs(cells, 0, 1, &pair) != HSP_OK;
  bad += hsp_cells_get_neighbours(cells, 0, neighbours, 64, &needed) != HSP_OK || needed != cell.neighbours;
  bad += hsp_cells_locate(cells, origin, &found) != HSP_OK || found != HSP_NONE;
  bad += hsp_cells_check(cells, NULL, &found, &needed) != HSP_OK;
  bad += hsp_model_arrangement(model, &arrangement, NULL, neighbours, 64, &needed) != HSP_OK || arrangement.faces < 3;
  return bad;
}

/* Paths through free space and the widest probe, all functions. */
static int call_paths(const hsp_model *model, void *memory, size_t bytes) {
  static const double from[3] = {-5, 0, 1}, to[3] = {9, 1, 0};
  double points[30][3];
  hsp_paths *paths = NULL;
  hsp_paths_limits limits;
  hsp_path path;
  hsp_gate *gate = NULL;
  hsp_gate_limits of_gate;
  hsp_widest_probe widest;
  uint32_t needed = 0;
  size_t size = 0;
  int bad = hsp_paths_limits_init(&limits, (uint32_t)sizeof limits, 3) != HSP_OK;
  bad += hsp_paths_bytes(&limits, &size) != HSP_OK || size > bytes;
  bad += hsp_paths_init(memory, size, &limits, &paths) != HSP_OK;
  bad += hsp_paths_compute(paths, model, NULL) != HSP_OK;
  bad += hsp_paths_find(paths, from, to, &path, NULL) != HSP_OK || path.ends != HSP_PATH_CONNECTED;
  bad += hsp_paths_get_points(paths, points[0], 30, &needed) != HSP_OK || needed != path.points;
  bad += hsp_gate_limits_init(&of_gate, (uint32_t)sizeof of_gate, 3) != HSP_OK;
  bad += hsp_gate_bytes(&of_gate, &size) != HSP_OK || size > bytes;
  bad += hsp_gate_init(memory, size, &of_gate, &gate) != HSP_OK;
  bad += hsp_gate_compute(gate, model, from, to, NULL) != HSP_OK;
  bad += hsp_gate_get(gate, &widest) != HSP_OK || widest.passes != 1;
  return bad;
}

/* A periodic box, all functions. */
static int call_periodic(void *memory, size_t bytes) {
  static const double xyz[9] = {0, 0, 0, 3, 0, 1, 1, 1, -2}, radius[3] = {2, 2, 1.75};
  static const double box[9] = {5, 0, 0, 1, 4, 0, -1, 1, 4.5};
  static hsp_periodic_contact contact[64];
  static hsp_image image[64];
  static hsp_periodic_vertex vertex[128];
  static hsp_periodic_arc arc[192];
  static hsp_periodic_circle circle[64];
  static hsp_periodic_face face[64];
  static hsp_periodic_loop loop[64];
  static hsp_periodic_loop_arc loop_arc[384];
  hsp_ball ball[3];
  hsp_periodic *periodic = NULL;
  hsp_periodic_limits limits;
  hsp_periodic_counts counts;
  hsp_periodic_totals totals;
  hsp_curvatures curvatures;
  hsp_winding winding[3];
  hsp_energy energy;
  const uint32_t group[3] = {0, 1, 2};
  const hsp_morphometry factors = {1, 1, 1, 1};
  hsp_group_contact between[3];
  hsp_morphometric_energy morphometric;
  double area[3], cell[3], centre[9], strain[9], by_box[9];
  int32_t thirds[3];
  uint32_t component[3], flags[3], first[4], needed = 0, invariant, id;
  size_t size = 0;
  int bad = hsp_periodic_limits_init(&limits, (uint32_t)sizeof limits, 3) != HSP_OK;
  bad += hsp_periodic_bytes(&limits, &size) != HSP_OK || size > bytes;
  bad += hsp_periodic_init(memory, size, &limits, &periodic) != HSP_OK;
  bad += hsp_periodic_compute(periodic, 3, xyz, radius, NULL, box, &limits, NULL) != HSP_OK;
  bad += hsp_periodic_get_counts(periodic, &counts) != HSP_OK || counts.contacts == 0;
  bad += hsp_periodic_measure(periodic, &totals, area, cell, 3, &needed) != HSP_OK;
  bad += hsp_periodic_curvature(periodic, &curvatures, area, thirds, 3, &needed) != HSP_OK;
  bad += hsp_periodic_get_contacts(periodic, contact, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_group_contacts(periodic, group, between, 3, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_windings(periodic, winding, 3, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_components(periodic, component, 3, &needed) != HSP_OK;
  bad += hsp_periodic_gradient(periodic, NULL, 1, 1, HSP_TANGENT_OVERLAP, &energy, centre, area, flags, strain, by_box,
                               3, &needed, NULL) != HSP_OK;
  bad += hsp_periodic_morphometry(periodic, NULL, &factors, &morphometric, centre, area, flags, strain, by_box, 3,
                                  &needed, NULL) != HSP_OK;
  bad += hsp_periodic_query_point(periodic, xyz, image, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_query_ball(periodic, xyz, 2.5, image, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_query_neighbours(periodic, 0, image, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_query_pairs(periodic, HSP_PAIRS_ONCE, first, image, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_vertices(periodic, vertex, 128, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_arcs(periodic, arc, 192, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_circles(periodic, circle, 64, &needed) != HSP_OK;
  bad += hsp_periodic_get_faces(periodic, face, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_loops(periodic, loop, 64, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_loop_arcs(periodic, loop_arc, 384, &needed) != HSP_OK || needed == 0;
  bad += hsp_periodic_get_balls(periodic, ball, 3, &needed) != HSP_OK;
  bad += hsp_periodic_check(periodic, &invariant, &id) != HSP_OK;
  return bad;
}

/* Balls that move, all functions. */
static int call_moving(hsp_model *model, void *memory, size_t bytes) {
  static const uint32_t ball[3] = {2, 0, 1};
  static const double to[9] = {1, 1, -2, 0, 0, 0, 3, 0, 1};
  hsp_moving *moving = NULL;
  hsp_moving_limits limits;
  hsp_moving_info info;
  hsp_moving_ball record[3];
  hsp_totals totals;
  hsp_energy energy;
  double area[3], volume[3], centre[9];
  uint32_t flags[3], changed[3], needed = 0;
  size_t size = 0;
  int bad = hsp_moving_limits_init(&limits, (uint32_t)sizeof limits, 3) != HSP_OK;
  bad += hsp_moving_bytes(&limits, &size) != HSP_OK || size > bytes;
  bad += hsp_moving_init(memory, size, &limits, &moving) != HSP_OK;
  bad += hsp_moving_set(moving, model, NULL, 1, 1, HSP_TANGENT_OVERLAP, &limits, NULL) != HSP_OK;
  bad += hsp_moving_move(moving, 3, ball, to, NULL, &limits, NULL) != HSP_OK;
  bad += hsp_moving_get_changed(moving, changed, 3, &needed) != HSP_OK || needed == 0;
  bad += hsp_moving_undo(moving) != HSP_OK;
  bad += hsp_moving_get_info(moving, &info) != HSP_OK || info.balls != 3;
  bad += hsp_moving_measure(moving, &totals, area, volume, 3, &needed) != HSP_OK;
  bad += hsp_moving_gradient(moving, &energy, centre, area, flags, 3, &needed) != HSP_OK;
  bad += hsp_moving_get_balls(moving, 3, ball, record) != HSP_OK;
  bad += hsp_moving_get_model(moving, model) != HSP_OK;
  return bad;
}

static int call_map(map_result *m, void *memory, size_t bytes, const uint32_t *colour) {
  hsp_map *map = NULL;
  hsp_map_limits limits;
  hsp_map_info info;
  hsp_map_sight sight;
  hsp_map_point point;
  hsp_map_pole pole;
  uint32_t needed = 0, invariant, id;
  size_t size = 0;
  int bad = 0;
  bad += hsp_map_limits_init(&limits, (uint32_t)sizeof limits, m->base->n) != HSP_OK;
  bad += hsp_map_bytes(&m->needed, &size) != HSP_OK;
  bad += hsp_map_init(memory, bytes, &m->needed, &map) != HSP_OK;
  bad += hsp_map_compute(map, m->base->model, &m->options, NULL) != HSP_OK;
  bad += hsp_map_get_info(map, &info) != HSP_OK;
  bad += hsp_map_get_vertices(map, 0, m->info.vertices, m->vertices) != HSP_OK;
  bad += hsp_map_get_edges(map, 0, m->info.edges, m->edges) != HSP_OK;
  bad += hsp_map_get_faces(map, 0, m->info.faces, m->faces) != HSP_OK;
  bad += hsp_map_get_areas(map, m->area, m->base->n, &needed) != HSP_OK;
  bad += hsp_map_check(map, &invariant, &id) != HSP_OK;
  bad += write_everything(NULL, map, colour);
  bad += hsp_map_pick(map, 0.1, 0.2, &sight) != HSP_OK;
  for (id = 1; id < m->info.faces; ++id) bad += hsp_map_get_pole(map, id, &pole) != HSP_OK;
  for (id = 0; id < 2 * m->info.edges; ++id) {
    bad += hsp_map_get_point(map, id / 2, m->edges[id / 2].from, &point) != HSP_OK;
    bad += hsp_map_previous(map, hsp_map_next(map, id)) != id;
    bad += hsp_map_left(map, hsp_map_next_loop(map, id)) != hsp_map_left(map, id);
    bad += hsp_map_origin(map, id) == HSP_NONE;
  }
  if (m->base->n > 0) {
    const int32_t status = hsp_map_get_outline(map, 0, NULL, 0, &needed);
    bad += status != (needed == 0 ? HSP_OK : HSP_E_CAPACITY);
  }
  return bad;
}

static int call_topology(topology_result *t, void *memory, size_t bytes, uint32_t *ids, uint32_t room) {
  const computed *c = t->base;
  hsp_topology *topology = NULL;
  hsp_topology_limits limits;
  hsp_topology_counts counts;
  uint32_t needed, invariant, id, cell;
  size_t size;
  int bad = 0;
  bad += hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, c->boundary) != HSP_OK;
  bad += hsp_topology_bytes(&t->needed, &size) != HSP_OK;
  bad += hsp_topology_init(memory, bytes, &t->needed, &topology) != HSP_OK;
  bad += hsp_topology_compute(topology, c->boundary, NULL) != HSP_OK;
  bad += hsp_topology_get_counts(topology, &counts) != HSP_OK;
  bad += hsp_topology_get_quad_edges(topology, 0, counts.edges, t->onext, t->origin) != HSP_OK;
  bad += HSP_TOPOLOGY_OPREV(topology, hsp_topology_onext(topology, 0)) != 0;
  bad += HSP_TOPOLOGY_LPREV(topology, hsp_topology_lnext(topology, 0)) != 0;
  bad += hsp_topology_origin(topology, 0) == HSP_NONE || hsp_topology_left(topology, 0) == HSP_NONE;
  bad += hsp_topology_get_vertices(topology, 0, counts.vertices, t->vertices) != HSP_OK;
  bad += hsp_topology_get_edges(topology, 0, counts.edges, t->edges) != HSP_OK;
  bad += hsp_topology_get_simple_faces(topology, 0, counts.simple_faces, t->faces) != HSP_OK;
  bad += hsp_topology_get_shells(topology, t->shells, counts.shells, &needed) != HSP_OK;
  bad += hsp_topology_get_components(topology, t->components, counts.components, &needed) != HSP_OK;
  bad += hsp_topology_get_cells(topology, t->cells, counts.cells, &needed) != HSP_OK;
  bad += hsp_topology_get_cell_shells(topology, 0, ids, room, &needed) != HSP_OK;
  bad += hsp_topology_get_traversal(topology, 0, ids, room, &needed) != HSP_OK;
  bad += hsp_topology_locate(topology, c->xyz, &cell) != HSP_OK;
  bad += hsp_topology_check(topology, &invariant, &id) != HSP_OK;
  return bad;
}

/* Every function of views and pictures, into the arrays of `v`; the number of calls that did not succeed. */
static int call_view(view_result *v, void *memory, size_t bytes, uint32_t *colour) {
  const computed *c = v->base;
  hsp_view *view = NULL;
  hsp_view_limits limits;
  hsp_view_options options;
  hsp_view_info info;
  uint32_t needed, i;
  size_t size;
  int bad = 0;
  bad += hsp_view_limits_init(&limits, (uint32_t)sizeof limits, c->n) != HSP_OK;
  bad += hsp_view_bytes(&v->needed, &size) != HSP_OK;
  bad += hsp_view_init(memory, bytes, &v->needed, &view) != HSP_OK;
  bad += hsp_view_options_init(&options, (uint32_t)sizeof options) != HSP_OK;
  bad += hsp_view_options_turn(&options, 10, 20, 30) != HSP_OK;
  bad += hsp_view_compute(view, c->model, v->with_boundary ? c->boundary : NULL, &v->options, NULL) != HSP_OK;
  bad += hsp_view_get_info(view, &info) != HSP_OK;
  bad += hsp_view_get_pieces(view, v->pieces, v->info.pieces, &needed) != HSP_OK;
  bad += hsp_view_get_loops(view, v->loops, v->info.loops, &needed) != HSP_OK;
  bad += hsp_view_get_arcs(view, v->arcs, v->info.arcs, &needed) != HSP_OK;
  for (i = 0; i < c->n; ++i) colour[i] = hsp_palette_colour(i % 4, i % 120, i);
  return bad + write_everything(view, NULL, colour);
}

/* The trap notices. */
static void check_trap(void) {
  void *volatile bait;
  armed = 1;
  bait = malloc(10);
  free(bait);
  armed = 0;
  CHECK_EQUAL(caught, 2);
}

static void arm(void) {
  caught = 0;
  armed = 1;
}

static void disarm(int bad) {
  int allocations;
  armed = 0;
  allocations = caught;
  CHECK_EQUAL(bad, 0);
  CHECK_EQUAL(allocations, 0);
}

static void trap_boundary(computed *c) {
  buffers b = buffers_for(c);
  int bad;
  arm();
  bad = call_boundary(c, &b);
  disarm(bad);
  buffers_release(&b);
}

static void trap_topology(const computed *c) {
  topology_result t;
  if (CHECK_EQUAL(topology_result_make(c, &t), HSP_OK)) {
    const uint32_t room = t.counts.edges + t.counts.shells + c->n;
    uint32_t *ids = test_zeros(room, sizeof *ids);
    size_t bytes = 0;
    void *memory;
    int bad;
    CHECK_EQUAL(hsp_topology_bytes(&t.needed, &bytes), HSP_OK);
    memory = test_zeros(bytes, 1);
    arm();
    bad = call_topology(&t, memory, bytes, ids, room);
    disarm(bad);
    free(memory);
    free(ids);
  }
  topology_result_release(&t);
}

static void trap_surface(const ball_set *set) {
  hsp_model_options options;
  computed c;
  surface_result s;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 1.5;
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK);
  if (CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK)) {
    size_t bytes = 0;
    void *memory;
    int bad;
    CHECK_EQUAL(hsp_surface_bytes(&s.needed, &bytes), HSP_OK);
    memory = test_zeros(bytes, 1);
    arm();
    bad = call_surface(&s, memory, bytes);
    disarm(bad);
    free(memory);
  }
  surface_result_release(&s);
  computed_release(&c);
}

/* Four balls that overlap, with the borders well apart. */
static void trap_mesh(void) {
  static const double xyz[4][3] = {{0, 0, 0}, {1.5, 0, 0}, {2.0, 1.4, 0}, {1.0, 0.7, 1.1}};
  static const double radius[4] = {1.0, 1.2, 0.9, 1.1};
  computed c;
  mesh_result m;
  CHECK_EQUAL(computed_make(4, xyz[0], radius, NULL, &c), HSP_OK);
  if (CHECK_EQUAL(mesh_result_make(&c, 0.3, &m), HSP_OK)) {
    size_t bytes = 0;
    void *memory;
    int bad;
    CHECK_EQUAL(hsp_mesh_bytes(&m.needed, &bytes), HSP_OK);
    memory = test_zeros(bytes, 1);
    arm();
    bad = call_mesh(&m, memory, bytes);
    disarm(bad);
    free(memory);
  }
  mesh_result_release(&m);
  computed_release(&c);
}

static void trap_surface_mesh(void) {
  static const double xyz[4][3] = {{0, 0, 0}, {1.5, 0, 0}, {2.0, 1.4, 0}, {1.0, 0.7, 1.1}};
  static const double radius[4] = {1.0, 1.2, 0.9, 1.1};
  hsp_model_options options;
  computed c;
  surface_result s;
  mesh_result m;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 1.4;
  CHECK_EQUAL(computed_make(4, xyz[0], radius, &options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK);
  if (CHECK_EQUAL(mesh_result_make_surface(&s, 0.3, &m), HSP_OK)) {
    size_t bytes = 0;
    void *memory;
    int bad;
    CHECK_EQUAL(hsp_mesh_bytes(&m.needed, &bytes), HSP_OK);
    memory = test_zeros(bytes, 1);
    arm();
    bad = call_surface_mesh(&m, memory, bytes);
    disarm(bad);
    free(memory);
  }
  mesh_result_release(&m);
  surface_result_release(&s);
  computed_release(&c);
}

static void trap_view(const computed *c, uint32_t pieces) {
  hsp_view_options options;
  view_result v;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(hsp_view_options_turn(&options, 25, 35, 0), HSP_OK);
  options.pieces = pieces;
  if (CHECK_EQUAL(view_result_make(c, &options, pieces == HSP_PIECES_OUTSIDE_ALL, &v), HSP_OK)) {
    uint32_t *colour = test_zeros(c->n, sizeof *colour);
    size_t bytes = 0;
    void *memory;
    int bad;
    CHECK_EQUAL(hsp_view_bytes(&v.needed, &bytes), HSP_OK);
    memory = test_zeros(bytes, 1);
    arm();
    bad = call_view(&v, memory, bytes, colour);
    disarm(bad);
    free(memory);
    free(colour);
  }
  view_result_release(&v);
}

static void trap_bodies(void) {
  static const double xyz[3][3] = {{0, 0, 0}, {1.5, 0, 0}, {2.0, 1.4, 0}};
  static const double radius[3] = {1.0, 1.2, 0.9}, matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, shift[3] = {1, 2, 0};
  static unsigned char memory[HSP_BODY_BYTES(3)];
  computed c;
  if (CHECK_EQUAL(computed_make(3, xyz[0], radius, NULL, &c), HSP_OK)) {
    hsp_body *body = NULL;
    hsp_pose pose;
    const hsp_rational_pose rational = {{1, 0, 0, 0}, {0, 0, 0}};
    hsp_body_gap gap;
    hsp_body_overlap overlap;
    uint32_t hit, pair[18], needed;
    int bad = 0;
    size_t bytes = 0;
    arm();
    bad += hsp_body_bytes(3, &bytes) != HSP_OK || bytes > sizeof memory;
    bad += hsp_body_init(memory, bytes, 3, &body) != HSP_OK;
    bad += hsp_body_set(body, c.model) != HSP_OK;
    bad += hsp_pose_from_matrix(matrix, shift, &pose) != HSP_OK;
    bad += hsp_body_hits(body, body, 1, &pose, &hit, NULL) != HSP_OK || hit != 1;
    bad += hsp_body_hits_along(body, body, 1, &pose, 1, &hit, NULL) != HSP_OK || hit != 1;
    bad += hsp_body_gaps(body, body, 1, &pose, &gap, NULL) != HSP_OK;
    bad += hsp_body_overlaps(body, body, 1, &pose, &overlap, NULL) != HSP_OK;
    bad += hsp_body_pairs(body, body, &pose, pair, 9, &needed) != HSP_OK;
    bad += hsp_body_rational_hits(body, body, 1, &rational, &hit, NULL) != HSP_OK || hit != 1;
    bad += hsp_body_rational_hits_along(body, body, 1, &rational, 1, &hit, NULL) != HSP_OK || hit != 1;
    bad += hsp_body_rational_gaps(body, body, 1, &rational, &gap, NULL) != HSP_OK;
    bad += hsp_body_rational_pairs(body, body, &rational, pair, 9, &needed) != HSP_OK;
    disarm(bad);
  }
  computed_release(&c);
}

static void trap_contacts(void) {
  static const double xyz[4][3] = {{0, 0, 0}, {1.5, 0, 0}, {2.0, 1.4, 0}, {1.0, 0.7, 1.1}};
  static const double radius[4] = {1.0, 1.2, 0.9, 1.1};
  static unsigned char memory[HSP_CONTACTS_BYTES(4, 8, 128, 64, 64)];
  computed c;
  if (CHECK_EQUAL(computed_make(4, xyz[0], radius, NULL, &c), HSP_OK)) {
    int bad;
    arm();
    bad = call_contacts(&c, memory, sizeof memory);
    disarm(bad);
  }
  computed_release(&c);
}

static void trap_sticks(void) {
  static const double xyz[9] = {0, 0, 0, 10, 0, 3, 10, 10, -2}, radius[3] = {2, 2, 3};
  static const double meeting[3] = {5, 6, 5};
  static unsigned char memory[HSP_STICKS_BYTES(3, 6, 256, 100)], model_memory[HSP_MODEL_BYTES(3)];
  hsp_model *model = NULL;
  int bad;
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, 3, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 3, xyz, radius, NULL, NULL), HSP_OK);
  arm();
  bad = call_sticks(model, memory, sizeof memory, 0);
  bad += hsp_model_set(model, 3, xyz, meeting, NULL, NULL) != HSP_OK;
  bad += call_sticks(model, memory, sizeof memory, 100);
  disarm(bad);
}

static void trap_cells(void) {
  static const double xyz[9] = {0, 0, 0, 3, 0, 1, 10, 10, -2}, radius[3] = {2, 2, 3};
  static unsigned char memory[1 << 19], model_memory[HSP_MODEL_BYTES(3)];
  hsp_model *model = NULL;
  int bad;
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, 3, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 3, xyz, radius, NULL, NULL), HSP_OK);
  arm();
  bad = call_cells(model, memory, sizeof memory);
  bad += call_paths(model, memory, sizeof memory);
  bad += call_moving(model, memory, sizeof memory);
  disarm(bad);
}

static void trap_periodic(void) {
  static unsigned char memory[1 << 19];
  int bad;
  arm();
  bad = call_periodic(memory, sizeof memory);
  disarm(bad);
}

static void trap_map(const computed *c) {
  hsp_view_options options;
  map_result m;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(hsp_view_options_turn(&options, 25, 35, 0), HSP_OK);
  if (CHECK_EQUAL(map_result_make(c, &options, &m), HSP_OK)) {
    uint32_t *colour;
    size_t bytes = 0;
    void *memory;
    int bad;
    CHECK_EQUAL(hsp_map_bytes(&m.needed, &bytes), HSP_OK);
    memory = test_zeros(bytes, 1);
    colour = test_zeros(c->n, sizeof *colour);
    arm();
    bad = call_map(&m, memory, bytes, colour);
    disarm(bad);
    free(memory);
    free(colour);
  }
  map_result_release(&m);
}

int main(void) {
  static ball_set set;
  computed c;
  uint32_t which;
  check_trap();
  trap_mesh();
  trap_surface_mesh();
  trap_contacts();
  trap_bodies();
  trap_sticks();
  trap_cells();
  trap_periodic();
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &set);
    if (set.n == 0) continue;
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) trap_boundary(&c);
    computed_release(&c);
    trap_surface(&set);
  }
  for (which = 0; which < topology_set_count(); ++which) {
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      if (set.n > 0) trap_topology(&c);
      trap_view(&c, HSP_PIECES_OUTSIDE_FARTHER);
      trap_view(&c, HSP_PIECES_OUTSIDE_ALL);
      trap_map(&c);
    }
    computed_release(&c);
  }
  return check_report();
}
