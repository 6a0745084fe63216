/* The workspace over malloc: handles that grow, for set after set, with the results that handles of ample size have.
 * The address sanitizer sees what is not given back. */
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* The workspace has so many allocations left. */
static unsigned allocations_left = UINT_MAX;
/* The most bytes that it gets at a time. */
static size_t most_bytes = SIZE_MAX;
static void *limited_malloc(size_t bytes) {
  if (allocations_left == 0 || bytes > most_bytes) return NULL;
  --allocations_left;
  return malloc(bytes);
}
#define malloc limited_malloc
#include <hardsphere_workspace.h>
#undef malloc

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "mesh_result.h"
#include "topology_sets.h"
#include "view_result.h"

/* Outside all balls, so that there is a path. */
static const double far_below[3] = {1e4, -2e4, -9e4}, far_above[3] = {0, 0, 9e4};
static hsp_path path;
static hsp_tunnel tunnel, cheapest;

static int32_t compute_all(hsp_workspace *work, const ball_set *set) {
  int32_t status = hsp_workspace_set(work, set->n, set->xyz, set->radius, NULL, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(work);
  if (status == HSP_OK) status = hsp_workspace_topology(work);
  if (status == HSP_OK) status = hsp_workspace_view(work, 1, NULL);
  if (status == HSP_OK) status = hsp_workspace_surface(work);
  if (status == HSP_OK) status = hsp_workspace_map(work, NULL);
  if (status == HSP_OK) status = hsp_workspace_contacts(work);
  if (status == HSP_OK) status = hsp_workspace_cells(work);
  if (status == HSP_OK) status = hsp_workspace_path(work, far_below, far_above, &path);
  if (status == HSP_OK && set->n <= 30) status = hsp_workspace_pores(work, NULL);
  if (status == HSP_OK && set->n <= 30) {
    status = hsp_workspace_cheapest_tunnel(work, NULL, far_below, far_above, NULL, 0, &cheapest);
    if (status == HSP_OK) status = hsp_workspace_tunnel(work, NULL, far_below, far_above, NULL, 0, &tunnel);
  }
  if (status == HSP_OK) status = hsp_workspace_moving(work, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL);
  return status;
}

/* Triangles of the boundary, and of the surface, which without a probe is the boundary. */
static void check_mesh(hsp_workspace *work, const computed *c) {
  mesh_result own;
  hsp_mesh_counts counts;
  double edge = 0.1;
  int32_t status;
  uint32_t i;
  int smooth;
  for (i = 0; i < c->n; ++i) edge = fmax(edge, 0.8 * c->radius[i]);
  status = mesh_result_make(c, edge, &own);
  CHECK_EQUAL(hsp_workspace_mesh(work, 0, edge), status);
  for (smooth = 0; smooth < 2 && status == HSP_OK; ++smooth) {
    double(*const xyz)[3] = test_zeros(own.counts.vertices, sizeof *xyz);
    CHECK_EQUAL(hsp_workspace_mesh(work, smooth, edge), HSP_OK);
    CHECK_EQUAL(hsp_mesh_get_counts(work->mesh, &counts), HSP_OK);
    CHECK_BYTES(&counts, &own.counts, sizeof counts);
    CHECK_EQUAL(hsp_mesh_get_vertices(work->mesh, xyz[0], NULL, NULL, NULL, own.counts.vertices, NULL), HSP_OK);
    CHECK_BYTES(xyz[0], own.xyz[0], own.counts.vertices * sizeof *xyz);
    free(xyz);
  }
  mesh_result_release(&own);
}

/* The workspace's contents are those that the same balls give by themselves. */
static void check_results(hsp_workspace *work, const ball_set *set) {
  computed c;
  hsp_boundary_counts counts;
  hsp_topology_counts topology;
  hsp_view_info view;
  hsp_totals totals, expected, cells;
  hsp_surface_totals surface; /* without a probe it is the boundary */
  hsp_map_info map;
  hsp_cells_counts free_space;
  hsp_pore_passage widest;
  uint32_t invariant, id;
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(work->boundary, &counts), HSP_OK);
  CHECK_BYTES(&counts, &c.counts, sizeof counts);
  CHECK_EQUAL(hsp_boundary_measure(c.boundary, NULL, &expected, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(work->boundary, NULL, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&totals, &expected, sizeof totals);
  CHECK_EQUAL(hsp_moving_measure(work->moving, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&totals, &expected, sizeof totals);
  CHECK_EQUAL(hsp_topology_get_counts(work->topology, &topology), HSP_OK);
  CHECK_EQUAL(topology.components, counts.components);
  CHECK_EQUAL(topology.shells, counts.shells);
  CHECK_EQUAL(hsp_surface_measure(work->surface, &surface, NULL, 0, NULL), HSP_OK);
  CHECK_NEAR(surface.area, expected.area, 1e-12 * (1.0 + expected.area));
  CHECK_EQUAL(hsp_map_get_info(work->map, &map), HSP_OK);
  CHECK_EQUAL(map.vertices + map.faces, 1 + map.components + map.edges);
  CHECK_EQUAL(hsp_map_check(work->map, &invariant, &id), HSP_OK);
  CHECK_EQUAL(hsp_contacts_check(work->contacts, &invariant, &id), HSP_OK);
  CHECK_EQUAL(hsp_contacts_measure(work->contacts, &cells, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_NEAR(cells.volume, expected.volume, 1e-12 * (1.0 + expected.volume));
  CHECK_EQUAL(hsp_view_get_info(work->view, &view), HSP_OK);
  CHECK_EQUAL(view.kind, HSP_PIECES_OUTSIDE_FARTHER);
  CHECK_EQUAL(hsp_cells_get_counts(work->cells, &free_space), HSP_OK);
  CHECK_EQUAL(free_space.regions, topology.regions);
  CHECK(path.ends == HSP_PATH_CONNECTED && path.certified == 1);
  if (set->n <= 30) {
    CHECK_EQUAL(hsp_pores_widest(work->pores, far_below, far_above, &widest), HSP_OK);
    CHECK(widest.passes == 1 && widest.radius == tunnel.radius && widest.radius > 0);
    CHECK(tunnel.there == 1 && tunnel.points >= 2 && tunnel.points <= work->pores_limits.points);
    CHECK(cheapest.there == 1 && cheapest.radius <= tunnel.radius);
    CHECK_EQUAL(hsp_cells_check(work->cells, work->topology, &invariant, &id), HSP_OK);
    check_mesh(work, &c);
  }
  computed_release(&c);
}

/* Every set of topology_sets.h in one workspace, in two orders, so that it grows at each of them or not at all. */
static void set_after_set(void) {
  static ball_set set;
  hsp_workspace work = {0};
  const uint32_t count = topology_set_count();
  uint32_t i;
  for (i = 0; i < 2 * count; ++i) {
    topology_set_make(i < count ? i : 2 * count - 1 - i, &set);
    check_scene("%s", set.name);
    CHECK_EQUAL(compute_all(&work, &set), HSP_OK);
    check_results(&work, &set);
  }
  hsp_workspace_free(&work);
  CHECK(work.model == NULL && work.boundary == NULL && work.topology == NULL && work.view == NULL &&
        work.surface == NULL && work.mesh == NULL && work.map == NULL && work.contacts == NULL && work.cells == NULL &&
        work.paths == NULL && work.pores == NULL && work.moving == NULL);
  check_scene("after it was freed");
  CHECK_EQUAL(compute_all(&work, &set), HSP_OK);
  check_results(&work, &set);
  hsp_workspace_free(&work);
}

/* A view of the boundary is none of the model alone. */
static void view_without_boundary(void) {
  hsp_workspace work = {0};
  hsp_view_info view;
  check_scene("a view without a boundary");
  CHECK_EQUAL(hsp_workspace_set(&work, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_view(&work, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_view(&work, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_view(&work, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_get_info(work.view, &view), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(hsp_workspace_view(&work, 1, NULL), HSP_OK);
  hsp_workspace_free(&work);
}

/* Nothing, one ball, more balls than before: what was computed from the balls before is out of date at once. */
static void out_of_date(void) {
  static ball_set few, many;
  hsp_workspace work = {0};
  hsp_boundary_counts counts;
  hsp_topology_counts topology;
  hsp_view_info view;
  hsp_mesh_counts mesh;
  hsp_map_info map;
  hsp_complex complex;
  hsp_cells_counts cells;
  uint32_t i;
  ball_set_start(&few, "a ball", 1e-8);
  ball_set_add(&few, 0, 0, 0, 1);
  ball_set_start(&many, "a chain", 1e-8);
  ball_set_add_chain(&many, 200, 5);
  check_scene("nothing set");
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_topology(&work), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_view(&work, 0, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 0, 1), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 1, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_map(&work, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_contacts(&work), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_cells(&work), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_path(&work, far_below, far_above, &path), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_tunnel(&work, NULL, far_below, NULL, NULL, 0, &tunnel), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_cheapest_tunnel(&work, NULL, far_below, NULL, NULL, 0, &tunnel), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_moving(&work, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_set(&work, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  for (i = 0; i < 4; ++i) {
    const ball_set *set = i % 2 == 0 ? &few : &many;
    check_scene("%s, time %u", set->name, (unsigned)i);
    CHECK_EQUAL(compute_all(&work, set), HSP_OK);
    check_results(&work, set);
    CHECK_EQUAL(hsp_workspace_mesh(&work, i / 2 % 2, 2), HSP_OK);
    CHECK_EQUAL(hsp_workspace_set(&work, many.n - i, many.xyz, many.radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_get_counts(work.boundary, &counts), HSP_E_STATE);
    CHECK_EQUAL(hsp_topology_get_counts(work.topology, &topology), HSP_E_STATE);
    CHECK_EQUAL(hsp_view_get_info(work.view, &view), HSP_E_STATE);
    CHECK_EQUAL(hsp_mesh_get_counts(work.mesh, &mesh), HSP_E_STATE);
    CHECK_EQUAL(hsp_workspace_mesh(&work, 0, 2), HSP_E_STATE);
    CHECK_EQUAL(hsp_map_get_info(work.map, &map), HSP_E_STATE);
    CHECK_EQUAL(hsp_contacts_get_complex(work.contacts, &complex), HSP_E_STATE);
    CHECK_EQUAL(hsp_workspace_contacts(&work), HSP_E_STATE);
    CHECK_EQUAL(hsp_cells_get_counts(work.cells, &cells), HSP_E_STATE);
    CHECK_EQUAL(hsp_workspace_topology(&work), HSP_E_STATE);
  }
  check_scene("a refused set");
  few.radius[0] = -1;
  CHECK_EQUAL(hsp_workspace_set(&work, 1, few.xyz, few.radius, NULL, &i), HSP_E_NEGATIVE);
  CHECK_EQUAL(i, 0);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_E_STATE);
  few.radius[0] = 1; /* more than there may be, where the balls of before are good ones */
  CHECK_EQUAL(hsp_workspace_set(&work, 1, few.xyz, few.radius, NULL, &i), HSP_OK);
  CHECK_EQUAL(hsp_workspace_set(&work, HSP_NONE, few.xyz, few.radius, NULL, &i), HSP_E_RANGE);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_E_STATE);
  CHECK_EQUAL(i, HSP_NONE);
  CHECK_EQUAL(hsp_workspace_set(&work, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(work.boundary, &counts), HSP_OK);
  CHECK_EQUAL(counts.balls, 0);
  CHECK_EQUAL(hsp_workspace_set(&work, HSP_NONE, few.xyz, few.radius, NULL, NULL), HSP_E_RANGE);
  hsp_workspace_free(&work);
}

/* The answers of reading each handle. */
static void check_readings(hsp_workspace *work, int32_t expected) {
  hsp_boundary_counts counts;
  hsp_topology_counts topology;
  hsp_view_info view;
  hsp_surface_counts surface;
  hsp_mesh_counts mesh;
  hsp_map_info map;
  hsp_complex complex;
  hsp_cells_counts cells;
  CHECK_EQUAL(hsp_boundary_get_counts(work->boundary, &counts), expected);
  CHECK_EQUAL(hsp_topology_get_counts(work->topology, &topology), expected);
  CHECK_EQUAL(hsp_view_get_info(work->view, &view), expected);
  CHECK_EQUAL(hsp_surface_get_counts(work->surface, &surface), expected);
  CHECK_EQUAL(hsp_mesh_get_counts(work->mesh, &mesh), expected);
  CHECK_EQUAL(hsp_map_get_info(work->map, &map), expected);
  CHECK_EQUAL(hsp_contacts_get_complex(work->contacts, &complex), expected);
  CHECK_EQUAL(hsp_cells_get_counts(work->cells, &cells), expected);
}

/* As many balls as before that meet more: the boundary takes larger memory, which may lie elsewhere, and what was
 * computed from it does not look where it was. */
static void boundary_grows(void) {
  static ball_set apart, crowd;
  hsp_workspace work = {0};
  uint32_t neighbours;
  hsp_topology_counts topology;
  hsp_surface_counts surface;
  hsp_mesh_counts mesh;
  hsp_complex complex;
  uint32_t i;
  ball_set_start(&apart, "balls apart", 1e-8);
  ball_set_start(&crowd, "a crowd", 1e-8);
  for (i = 0; i < 400; ++i) {
    ball_set_add(&apart, 4.0 * i, 0, 0, 1);
    ball_set_add(&crowd, i % 20, i / 20, 0.1 * (i % 7), 8);
  }
  check_scene("a boundary that grows");
  CHECK_EQUAL(compute_all(&work, &apart), HSP_OK);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 0, 2), HSP_OK);
  neighbours = work.boundary_limits.neighbours;
  CHECK_EQUAL(hsp_workspace_set(&work, crowd.n, crowd.xyz, crowd.radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK(work.boundary_limits.neighbours > neighbours);
  CHECK_EQUAL(hsp_topology_get_counts(work.topology, &topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_get_counts(work.surface, &surface), HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_get_counts(work.mesh, &mesh), HSP_E_STATE);
  CHECK_EQUAL(hsp_contacts_get_complex(work.contacts, &complex), HSP_E_STATE);
  hsp_workspace_free(&work);
}

/* Without memory for more balls nothing has results, and nothing looks into memory that was given back; wherever memory
 * ends, all can be computed once there is some again. */
static void without_memory(void) {
  static ball_set few, many;
  uint32_t left;
  int32_t status = HSP_E_MEMORY;
  ball_set_start(&few, "a ball", 1e-8);
  ball_set_add(&few, 0, 0, 0, 1);
  ball_set_start(&many, "a chain", 1e-8);
  ball_set_add_chain(&many, 200, 5);
  for (left = 0; status == HSP_E_MEMORY; ++left) {
    hsp_workspace work = {0};
    check_scene("%u allocations", (unsigned)left);
    CHECK_EQUAL(compute_all(&work, &few), HSP_OK);
    CHECK_EQUAL(hsp_workspace_mesh(&work, 0, 2), HSP_OK);
    check_readings(&work, HSP_OK);
    allocations_left = left;
    status = compute_all(&work, &many);
    if (left == 0) check_readings(&work, HSP_E_STATE);
    allocations_left = UINT_MAX;
    CHECK_EQUAL(compute_all(&work, &many), HSP_OK);
    check_results(&work, &many);
    hsp_workspace_free(&work);
  }
  CHECK_EQUAL(status, HSP_OK);
  CHECK(left > 10);
}

/* Where there is no memory for many balls, or for a fine mesh, there is some for few afterwards. */
static void few_after_too_many(void) {
  static ball_set few;
  static double xyz[3 * 1500], radius[1500];
  uint32_t i;
  hsp_workspace work = {0};
  const double box[9] = {2000, 0, 0, 0, 50, 0, 0, 0, 50};
  ball_set_start(&few, "two balls", 1e-8);
  ball_set_add(&few, 0, 0, 0, 1);
  ball_set_add(&few, 1, 0, 0, 1);
  for (i = 0; i < 1500; ++i) {
    xyz[3 * i] = 1.0 + i;
    radius[i] = 1;
  }
  check_scene("few after too many");
  most_bytes = 1000000;
  CHECK_EQUAL(hsp_workspace_set(&work, 1500, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_workspace_cells(&work), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_workspace_moving(&work, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_workspace_periodic(&work, 1500, xyz, radius, box, NULL, NULL), HSP_E_MEMORY);
  CHECK_EQUAL(compute_all(&work, &few), HSP_OK);
  CHECK_EQUAL(hsp_workspace_periodic(&work, few.n, few.xyz, few.radius, box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 0, 0.01), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 0, 1), HSP_OK);
  most_bytes = SIZE_MAX;
  hsp_workspace_free(&work);
}

/* Boxes of m x m x m copies of two balls that meet across a face: they have m^3 times everything, whatever there was
 * before, and the model is not touched. */
static void boxes(void) {
  static const uint32_t sides[] = {1, 4, 2, 5, 1};
  static ball_set set;
  hsp_workspace work = {0};
  hsp_model_info info;
  hsp_periodic_counts counts;
  hsp_periodic_totals totals, one = {0, 0, 0, 0, 0};
  uint32_t first_bad = 77, k, i;
  double box[9] = {0};
  ball_set_start(&set, "a ball", 1e-8);
  ball_set_add(&set, 0, 0, 0, 1);
  CHECK_EQUAL(hsp_workspace_set(&work, 1, set.xyz, set.radius, NULL, NULL), HSP_OK);
  for (k = 0; k < sizeof sides / sizeof sides[0]; ++k) {
    const uint32_t m = sides[k], copies = m * m * m;
    check_scene("%u copies in a box", (unsigned)copies);
    ball_set_start(&set, "copies", 1e-8);
    for (i = 0; i < copies; ++i) {
      const double x = 4.0 * (i % m), y = 4.0 * (i / m % m), z = 4.0 * (i / m / m);
      ball_set_add(&set, x + 0.5, y, z, 1);
      ball_set_add(&set, x + 3.25, y, z, 1);
    }
    box[0] = box[4] = box[8] = 4.0 * m;
    CHECK_EQUAL(hsp_workspace_periodic(&work, set.n, set.xyz, set.radius, box, NULL, &first_bad), HSP_OK);
    CHECK_EQUAL(first_bad, HSP_NONE);
    CHECK_EQUAL(hsp_periodic_get_counts(work.periodic, &counts), HSP_OK);
    CHECK(counts.balls == 2 * copies && counts.components == copies && counts.circles == copies);
    CHECK_EQUAL(hsp_periodic_measure(work.periodic, &totals, NULL, NULL, 0, NULL), HSP_OK);
    if (k == 0) one = totals;
    CHECK_NEAR(totals.area, copies * one.area, 1e-12 * totals.area);
    CHECK_NEAR(totals.volume, copies * one.volume, 1e-12 * totals.volume);
  }
  /* Two balls at distance 1.25: each loses a cap of height 3/8. */
  CHECK_NEAR(one.area, 4 * acos(-1.0) * (2 - 0.375), 1e-13);
  check_scene("refused boxes");
  set.radius[1] = -1;
  CHECK_EQUAL(hsp_workspace_periodic(&work, 2, set.xyz, set.radius, box, NULL, &first_bad), HSP_E_NEGATIVE);
  CHECK_EQUAL(first_bad, 1);
  CHECK_EQUAL(hsp_periodic_get_counts(work.periodic, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_periodic(&work, HSP_NONE, set.xyz, set.radius, box, NULL, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_model_get_info(work.model, &info), HSP_OK);
  CHECK_EQUAL(info.balls, 1);
  hsp_workspace_free(&work);
  CHECK(work.periodic == NULL);
  CHECK_EQUAL(hsp_workspace_periodic(&work, HSP_NONE, set.xyz, set.radius, box, NULL, NULL), HSP_E_RANGE);
  hsp_workspace_free(&work);
}

/* Shorter and shorter edges in one workspace, of the boundary and of the surface in turn; with a probe these differ. */
static void shorter_edges(void) {
  static ball_set set;
  hsp_workspace work = {0};
  hsp_model_options options;
  hsp_mesh_counts counts;
  uint32_t last[2] = {0, 0}, k;
  CHECK_EQUAL(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.probe = 1.4;
  ball_set_start(&set, "a chain with a probe", 1e-8);
  ball_set_add_chain(&set, 12, 5);
  check_scene("%s", set.name);
  CHECK_EQUAL(hsp_workspace_set(&work, set.n, set.xyz, set.radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 1, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_surface(&work), HSP_OK);
  for (k = 0; k < 6; ++k) {
    CHECK_EQUAL(hsp_workspace_mesh(&work, k % 2, k < 2 ? 2 : k < 4 ? 0.7 : 0.3), HSP_OK);
    CHECK_EQUAL(hsp_mesh_get_counts(work.mesh, &counts), HSP_OK);
    CHECK(counts.vertices > last[k % 2]);
    last[k % 2] = counts.vertices;
  }
  CHECK(last[0] > last[1]);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 0, NAN), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_mesh_get_counts(work.mesh, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 1, 0), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_mesh(&work, 1, 2), HSP_OK);
  hsp_workspace_free(&work);
}

/* A box with more balls than hsp_periodic_limits_init knows limits for: their values are looked at, as those of any
 * box. Nothing but the first one is written, so that most systems have no memory for the rest. */
static void very_many(void) {
  const uint32_t n = (HSP_MAX_BALLS - 2048) / 36 + 1;
  const double box[9] = {9, 0, 0, 0, 9, 0, 0, 0, 9};
  double *const xyz = calloc((size_t)3 * n, sizeof *xyz), *const radius = calloc(n, sizeof *radius);
  hsp_workspace work = {0};
  hsp_periodic_limits limits;
  uint32_t first_bad = 77;
  CHECK_EQUAL(hsp_periodic_limits_init(&limits, sizeof limits, n), HSP_E_RANGE);
  if (xyz != NULL && radius != NULL) {
    xyz[0] = NAN;
    radius[0] = 1;
    CHECK_EQUAL(hsp_workspace_periodic(&work, n, xyz, radius, box, NULL, &first_bad), HSP_E_NOT_FINITE);
    CHECK_EQUAL(first_bad, 0);
  }
  hsp_workspace_free(&work);
  free(xyz);
  free(radius);
  first_bad = 77;
  CHECK_EQUAL(hsp_workspace_set(&work, UINT32_MAX, NULL, NULL, NULL, &first_bad), HSP_E_RANGE);
  CHECK_EQUAL(first_bad, HSP_NONE);
}

int main(void) {
  set_after_set();
  shorter_edges();
  view_without_boundary();
  out_of_date();
  boundary_grows();
  boxes();
  very_many();
  without_memory();
  few_after_too_many();
  return check_report();
}
