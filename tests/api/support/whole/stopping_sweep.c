/* Computations that are stopped at their questions whether to go on (hsp_executor.proceed), by one worker and by three.
 *
 * With set number k the sweep stops each computation at the questions k, k + 40, k + 80 and so on: over 40 sets at
 * every question once. A stopped computation returns HSP_E_STOPPED, writes nothing but what tasks may write, and leaves
 * its handle without results and its limits as they were; a function that only reads results leaves these. Asked again,
 * it gives the same as before. */
#include "stopping_sweep.h"

#include <hardsphere.h>
#include <hardsphere_workspace.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "loops.h"

enum { BALLS = 300, FEW_BALLS = 50, WORKERS = 3 };

typedef struct scene {
  hsp_workspace work;
  uint32_t n;
  double area[BALL_SET_MOST], d_centre[3 * BALL_SET_MOST];
  uint32_t first[BALL_SET_MOST + 1];
  double box[9];
  const ball_set *set;
  hsp_workspace bare; /* of small balls with sticks between them */
  hsp_sticks *sticks;
  hsp_sticks_limits sticks_limits;
  hsp_stick stick[BALL_SET_MOST];
  uint32_t bonds;
  double inside[2][3]; /* points of free space */
  hsp_model *model;    /* of many balls, which only these are taken into */
  hsp_body *body;      /* of these */
} scene;

/* ---- the computations; `read` reads the handle's results ------------------------------------------------------- */

typedef struct question {
  const char *name;
  int32_t (*ask)(scene *s, const hsp_executor *executor);
  int32_t (*read)(scene *s, void *counts, size_t *bytes); /* NULL: results stay */
  int few;                                                /* whether it is asked of few balls, as it takes long */
  uint32_t least;                                         /* questions that it has to ask; 0: three */
} question;

static int32_t ask_boundary(scene *s, const hsp_executor *executor) {
  const hsp_boundary_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_boundary_limits limits = s->work.boundary_limits;
  const int32_t status = hsp_boundary_compute_with(s->work.boundary, s->work.model, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.boundary_limits, sizeof limits);
  return status;
}
static int32_t read_boundary(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_boundary_counts);
  return hsp_boundary_get_counts(s->work.boundary, counts);
}

static int32_t ask_measures(scene *s, const hsp_executor *executor) {
  const hsp_measure_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_measure_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .area = s->area};
  return hsp_boundary_get_measures(s->work.boundary, &request, &outputs);
}
static int32_t ask_gradient(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_boundary_get_gradient(s->work.boundary, &request, &outputs);
}
static int32_t ask_derivatives(scene *s, const hsp_executor *executor) {
  const hsp_derivatives_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .area_centre = s->d_centre};
  return hsp_boundary_get_derivatives(s->work.boundary, &request, &outputs);
}
static int32_t ask_rows(scene *s, const hsp_executor *executor) {
  static uint32_t ball[64 * BALL_SET_MOST];
  static double d_centre[3 * 64 * BALL_SET_MOST];
  const hsp_derivatives_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_boundary_get_area_rows(s->work.boundary, &request, s->first, ball, d_centre, NULL, 64 * BALL_SET_MOST,
                                    NULL);
}
static int32_t ask_morphometry(scene *s, const hsp_executor *executor) {
  const hsp_morphometry_request request = {.struct_size = sizeof request, .bending = 1, .executor = executor};
  hsp_morphometry_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_boundary_get_morphometry(s->work.boundary, &request, &outputs);
}
static int32_t ask_surface_gradient(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_surface_get_gradient(s->work.surface, &request, &outputs);
}

static int32_t ask_contacts(scene *s, const hsp_executor *executor) {
  const hsp_contacts_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_contacts_limits limits = s->work.contacts_limits;
  const int32_t status = hsp_contacts_compute_with(s->work.contacts, s->work.boundary, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.contacts_limits, sizeof limits);
  return status;
}
static int32_t read_contacts(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_complex);
  return hsp_contacts_get_complex(s->work.contacts, counts);
}

static int32_t ask_topology(scene *s, const hsp_executor *executor) {
  const hsp_topology_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_topology_limits limits = s->work.topology_limits;
  const int32_t status = hsp_topology_compute_with(s->work.topology, s->work.boundary, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.topology_limits, sizeof limits);
  return status;
}
static int32_t read_topology(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_topology_counts);
  return hsp_topology_get_counts(s->work.topology, counts);
}

static int32_t ask_mesh(scene *s, const hsp_executor *executor) {
  const hsp_mesh_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_mesh_compute_with(s->work.mesh, s->work.boundary, 0.4, &request, NULL);
}
static int32_t ask_smooth_mesh(scene *s, const hsp_executor *executor) {
  const hsp_mesh_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_mesh_compute_surface_with(s->work.mesh, s->work.surface, 0.4, &request, NULL);
}
static int32_t read_mesh(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_mesh_counts);
  return hsp_mesh_get_counts(s->work.mesh, counts);
}

static int32_t ask_periodic(scene *s, const hsp_executor *executor) {
  const hsp_periodic_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_periodic_compute_with(s->work.periodic, s->n, s->set->xyz, s->set->radius, s->box, &request, NULL, NULL);
}
static int32_t read_periodic(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_periodic_counts);
  return hsp_periodic_get_counts(s->work.periodic, counts);
}
static int32_t ask_periodic_gradient(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_periodic_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_periodic_get_gradient(s->work.periodic, &request, &outputs);
}
static int32_t ask_periodic_morphometry(scene *s, const hsp_executor *executor) {
  const hsp_morphometry_request request = {.struct_size = sizeof request, .bending = 1, .executor = executor};
  hsp_periodic_morphometry_outputs outputs = {.struct_size = sizeof outputs, .capacity = s->n, .d_centre = s->d_centre};
  return hsp_periodic_get_morphometry(s->work.periodic, &request, &outputs);
}

static int32_t ask_view(scene *s, const hsp_executor *executor) {
  hsp_view_options options;
  hsp_view_limits limits = s->work.view_limits;
  int32_t status = hsp_view_options_init(&options, sizeof options);
  options.executor = executor;
  if (status == HSP_OK) status = hsp_view_compute(s->work.view, s->work.model, NULL, &options, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.view_limits, sizeof limits);
  return status;
}
static int32_t ask_whole_view(scene *s, const hsp_executor *executor) {
  hsp_view_options options;
  const int32_t status = hsp_view_options_init(&options, sizeof options);
  options.executor = executor;
  options.pieces = HSP_PIECES_OUTSIDE_ALL;
  options.flags = HSP_VIEW_ALL_BALLS;
  if (status != HSP_OK) return status;
  return hsp_view_compute(s->work.view, s->work.model, s->work.boundary, &options, NULL);
}
static int32_t read_view(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_view_info);
  return hsp_view_get_info(s->work.view, counts);
}
static int32_t ask_map(scene *s, const hsp_executor *executor) {
  hsp_view_options options;
  hsp_map_limits limits = s->work.map_limits;
  int32_t status = hsp_view_options_init(&options, sizeof options);
  options.executor = executor;
  if (status == HSP_OK) status = hsp_map_compute(s->work.map, s->work.model, &options, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.map_limits, sizeof limits);
  return status;
}
static int32_t read_map(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_map_info);
  return hsp_map_get_info(s->work.map, counts);
}

static int32_t ask_some_sticks(scene *s, const hsp_executor *executor, int as_map) {
  const hsp_sticks_conflict before = {77, 78, 79, 0};
  hsp_sticks_conflict conflict = before;
  hsp_view_options options;
  hsp_sticks_limits limits = s->sticks_limits;
  int32_t status = hsp_view_options_init(&options, sizeof options);
  options.executor = executor;
  if (status == HSP_OK) {
    status = (as_map ? hsp_sticks_compute_map : hsp_sticks_compute)(s->sticks, s->bare.model, &options, s->stick,
                                                                    s->bonds, 0.1, &conflict, &limits);
  }
  if (status == HSP_E_STOPPED) CHECK_BYTES(&conflict, &before, sizeof before);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->sticks_limits, sizeof limits);
  return status;
}
static int32_t ask_sticks(scene *s, const hsp_executor *executor) {
  return ask_some_sticks(s, executor, 0);
}
static int32_t ask_sticks_map(scene *s, const hsp_executor *executor) {
  return ask_some_sticks(s, executor, 1);
}
static int32_t read_sticks(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_sticks_info);
  return hsp_sticks_get_info(s->sticks, counts);
}

static int32_t ask_surface(scene *s, const hsp_executor *executor) {
  const hsp_surface_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_surface_limits limits = s->work.surface_limits;
  const int32_t status = hsp_surface_compute_with(s->work.surface, s->work.boundary, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.surface_limits, sizeof limits);
  return status;
}
static int32_t ask_surface_of_shell(scene *s, const hsp_executor *executor) {
  const uint32_t shell = 0;
  const hsp_surface_request request = {
      .struct_size = sizeof request, .count = 1, .executor = executor, .shells = &shell};
  return hsp_surface_compute_with(s->work.surface, s->work.boundary, &request, NULL);
}
static int32_t read_surface(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_surface_counts);
  return hsp_surface_get_counts(s->work.surface, counts);
}

static int32_t ask_cells(scene *s, const hsp_executor *executor) {
  const hsp_cells_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_cells_limits limits = s->work.cells_limits;
  const int32_t status = hsp_cells_compute_with(s->work.cells, s->work.model, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.cells_limits, sizeof limits);
  return status;
}
static int32_t read_cells(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_cells_counts);
  return hsp_cells_get_counts(s->work.cells, counts);
}

static int32_t find_path(scene *s, const hsp_executor *executor, hsp_path *path) {
  const hsp_paths_request request = {.struct_size = sizeof request, .executor = executor};
  const double from[3] = {-60, -60, -60};
  return hsp_paths_find_with(s->work.paths, from, s->inside[0], &request, path, NULL);
}
static int32_t ask_paths(scene *s, const hsp_executor *executor) {
  const hsp_paths_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_paths_limits limits = s->work.paths_limits;
  const int32_t status = hsp_paths_compute_with(s->work.paths, s->work.model, &request, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.paths_limits, sizeof limits);
  return status;
}
static int32_t read_paths(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_path);
  return find_path(s, NULL, counts);
}
static int32_t ask_path(scene *s, const hsp_executor *executor) {
  hsp_path path;
  unsigned char before[sizeof path];
  uint32_t points = 1;
  int32_t status;
  memset(&path, 0x5A, sizeof path);
  memset(before, 0x5A, sizeof before);
  status = find_path(s, executor, &path);
  if (status == HSP_E_STOPPED) {
    CHECK_BYTES(&path, before, sizeof path);
    CHECK_EQUAL(hsp_paths_get_points(s->work.paths, NULL, 0, &points), HSP_OK);
    CHECK_EQUAL(points, 0);
  }
  return status;
}

static int32_t ask_pores(scene *s, const hsp_executor *executor) {
  const hsp_pores_options options = {.struct_size = sizeof options, .executor = executor};
  hsp_pores_limits limits = s->work.pores_limits;
  const int32_t status = hsp_pores_compute(s->work.pores, s->work.model, &options, &limits);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.pores_limits, sizeof limits);
  return status;
}
static int32_t ask_pores_in_box(scene *s, const hsp_executor *executor) {
  const hsp_pores_options options = {.struct_size = sizeof options, .executor = executor};
  return hsp_pores_compute_periodic(s->work.pores, s->work.periodic, &options, NULL);
}
static int32_t read_pores(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_pores_counts);
  return hsp_pores_get_counts(s->work.pores, counts);
}
static int32_t ask_regions(scene *s, const hsp_executor *executor) {
  const hsp_pores_request request = {.struct_size = sizeof request, .executor = executor};
  const hsp_pore_access before = {1, 2, 3, 4, 5, 6};
  hsp_pore_access access = before;
  uint32_t regions = 77;
  const int32_t status = hsp_pores_find_regions_with(s->work.pores, s->work.boundary, &request, &access, &regions);
  if (status == HSP_E_STOPPED) {
    CHECK_BYTES(&access, &before, sizeof access);
    CHECK_EQUAL(regions, 77);
    CHECK_EQUAL(hsp_pores_get_regions(s->work.pores, 0, 1, (hsp_pore_region[1]){{0}}), HSP_E_ID);
  }
  return status;
}
static int32_t ask_pocket_sizes(scene *s, const hsp_executor *executor) {
  const hsp_pores_request request = {.struct_size = sizeof request, .executor = executor};
  static hsp_pore_pocket_size size[BALL_SET_MOST];
  uint32_t pockets = 0;
  int32_t status = hsp_pores_find_pockets(s->work.pores, 0, 0, &pockets);
  if (status == HSP_OK) {
    status = hsp_pores_measure_pockets_with(s->work.pores, s->work.pores, s->work.boundary, &request, size,
                                            BALL_SET_MOST, NULL);
  }
  return status;
}
static int32_t ask_tunnel(scene *s, const hsp_executor *executor) {
  const hsp_tunnel_request request = {.struct_size = sizeof request, .cheapest = 1, .executor = executor};
  hsp_tunnel tunnel;
  unsigned char before[sizeof tunnel];
  uint32_t points = 1;
  int32_t status;
  memset(&tunnel, 0x5A, sizeof tunnel);
  memset(before, 0x5A, sizeof before);
  status = hsp_pores_find_tunnel_with(s->work.pores, s->inside[0], s->inside[1], NULL, 0, &request, &tunnel, NULL);
  if (status == HSP_E_STOPPED) {
    CHECK_BYTES(&tunnel, before, sizeof tunnel);
    CHECK_EQUAL(hsp_pores_get_tunnel_points(s->work.pores, NULL, 0, &points), HSP_OK);
    CHECK_EQUAL(points, 0);
  }
  return status;
}

static int32_t ask_moving(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_moving_limits limits = s->work.moving_limits;
  const int32_t status = hsp_moving_set_with(s->work.moving, s->work.model, &request, &limits, NULL);
  if (status == HSP_E_STOPPED) CHECK_BYTES(&limits, &s->work.moving_limits, sizeof limits);
  return status;
}
static int32_t read_moving(scene *s, void *counts, size_t *bytes) {
  *bytes = sizeof(hsp_moving_info);
  return hsp_moving_get_info(s->work.moving, counts);
}
/* All balls move and are moved back, so that each call finds the same. */
static int32_t ask_move(scene *s, const hsp_executor *executor) {
  const hsp_moving_request request = {.struct_size = sizeof request, .executor = executor};
  static uint32_t ball[BALL_SET_MOST];
  static double xyz[3 * BALL_SET_MOST];
  hsp_totals before, after;
  uint32_t k;
  int32_t status;
  for (k = 0; k < s->n; ++k) ball[k] = k;
  for (k = 0; k < 3 * s->n; ++k) xyz[k] = s->set->xyz[k] + (k % 7 < 3 ? 0.25 : -0.125);
  CHECK_EQUAL(hsp_moving_measure(s->work.moving, &before, NULL, NULL, 0, NULL), HSP_OK);
  status = hsp_moving_move_with(s->work.moving, s->n, ball, xyz, NULL, &request, NULL, NULL);
  if (status == HSP_OK) CHECK_EQUAL(hsp_moving_undo(s->work.moving), HSP_OK);
  CHECK_EQUAL(hsp_moving_measure(s->work.moving, &after, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&after, &before, sizeof after);
  return status;
}

static int32_t ask_hessian_rows(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  static uint32_t first[BALLS + 1], ball[32 * BALLS], flags[BALLS + 1];
  static double block[9 * 32 * BALLS];
  return hsp_boundary_get_hessian_rows(s->work.boundary, &request, first, ball, block, flags, 32 * BALLS, NULL);
}
static int32_t ask_hessian_product(scene *s, const hsp_executor *executor) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  static double product[3 * BALLS];
  return hsp_boundary_get_hessian_product(s->work.boundary, &request, s->set->xyz, product, NULL, s->n, NULL);
}
/* The first of two bricks, which owns every second ball. */
static int32_t ask_brick(scene *s, const hsp_executor *executor) {
  static uint8_t summary[1000000];
  static uint64_t id[BALL_SET_MOST];
  static uint32_t owner[BALL_SET_MOST];
  const hsp_brick_request request = {sizeof request, 0, 2, 0, id, owner, executor};
  size_t bytes = sizeof summary;
  uint32_t i;
  for (i = 0; i < s->n; ++i) {
    id[i] = i;
    owner[i] = i % 2;
  }
  return hsp_brick_summarise(s->work.boundary, &request, summary, &bytes, NULL);
}

/* So many balls that hsp_model_set asks; a model that was stopped has no balls. */
enum { MANY_BALLS = 5000, MOST_PAIRS = 400 * MANY_BALLS };
static int32_t ask_model(scene *s, const hsp_executor *executor) {
  static double xyz[3 * MANY_BALLS], radius[MANY_BALLS];
  const hsp_model_request request = {.struct_size = sizeof request, .executor = executor};
  uint32_t k, bad = 77;
  int32_t status;
  for (k = 0; k < MANY_BALLS; ++k) {
    xyz[3 * k] = s->set->xyz[3 * (k % s->n)] + 3.0 * (k / s->n);
    xyz[3 * k + 1] = s->set->xyz[3 * (k % s->n) + 1];
    xyz[3 * k + 2] = s->set->xyz[3 * (k % s->n) + 2];
    radius[k] = s->set->radius[k % s->n];
  }
  status = hsp_model_set_with(s->model, MANY_BALLS, xyz, radius, &request, &bad);
  CHECK_EQUAL(bad, HSP_NONE);
  return status;
}
static int32_t read_model(scene *s, void *counts, size_t *bytes) {
  uint32_t needed;
  int32_t status;
  *bytes = sizeof(hsp_model_info);
  status = hsp_model_get_info(s->model, counts);
  if (status == HSP_OK) status = hsp_model_get_balls(s->model, NULL, NULL, 0, &needed);
  if (status == HSP_E_STATE) CHECK_EQUAL(((hsp_model_info *)counts)->balls, 0);
  return status;
}
static int32_t ask_pairs(scene *s, const hsp_executor *executor) {
  static uint32_t first[MANY_BALLS + 1], ids[MOST_PAIRS];
  const hsp_pairs_request request = {.struct_size = sizeof request, .executor = executor};
  uint32_t needed = 77;
  const int32_t status = hsp_query_pairs_with(s->model, &request, first, ids, MOST_PAIRS, &needed);
  CHECK(status == HSP_OK ? needed == first[MANY_BALLS] : status == HSP_E_STOPPED);
  return status;
}
static int32_t ask_pairs_once(scene *s, const hsp_executor *executor) {
  static uint32_t first[MANY_BALLS + 1], ids[MOST_PAIRS];
  const hsp_pairs_request request = {.struct_size = sizeof request, .flags = HSP_PAIRS_ONCE, .executor = executor};
  return hsp_query_pairs_with(s->model, &request, first, ids, MOST_PAIRS, NULL);
}
static int32_t ask_body(scene *s, const hsp_executor *executor) {
  const hsp_body_request request = {.struct_size = sizeof request, .executor = executor};
  return hsp_body_set_with(s->body, s->model, &request);
}
static int32_t read_body(scene *s, void *counts, size_t *bytes) {
  const hsp_pose pose = {{1, 0, 0, 0}, {0.5, 0, 0}};
  *bytes = sizeof(hsp_body_overlap);
  return hsp_body_overlaps(s->body, s->body, 1, &pose, counts, NULL);
}
static int32_t ask_curvature(scene *s, const hsp_executor *executor) {
  const hsp_curvature_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_curvatures totals = {77, 78};
  const int32_t status = hsp_boundary_curvature_with(s->work.boundary, &request, &totals, s->area, NULL, s->n, NULL);
  if (status == HSP_E_STOPPED) CHECK(totals.mean == 77 && totals.gauss == 78);
  return status;
}
static int32_t ask_surface_measures(scene *s, const hsp_executor *executor) {
  static hsp_surface_totals balls[BALL_SET_MOST];
  const hsp_surface_measure_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_surface_totals totals = {77, 78, 0, 0, 0};
  const int32_t status = hsp_surface_measure_with(s->work.surface, &request, &totals, balls, s->n, NULL);
  if (status == HSP_E_STOPPED) CHECK(totals.area == 77 && totals.volume == 78);
  return status;
}

/* Two bricks that share many pairs of balls, which are made once. */
enum { BRICK_PAIRS = 600, SUMMARY_BYTES = 1000000 };
static size_t make_summary(uint32_t brick, uint8_t *summary) {
  static double xyz[6 * BRICK_PAIRS], radius[2 * BRICK_PAIRS];
  static uint64_t id[2 * BRICK_PAIRS];
  static uint32_t owner[2 * BRICK_PAIRS];
  const hsp_brick_request request = {sizeof request, brick, 2, 0, id, owner, NULL};
  size_t bytes = SUMMARY_BYTES;
  hsp_workspace work = {0};
  uint32_t i;
  for (i = 0; i < 2 * BRICK_PAIRS; ++i) {
    xyz[3 * i] = 2 * i - i % 2;
    radius[i] = 0.75;
    id[i] = i;
    owner[i] = i % 2;
  }
  CHECK_EQUAL(hsp_workspace_set(&work, 2 * BRICK_PAIRS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(hsp_brick_summarise(work.boundary, &request, summary, &bytes, NULL), HSP_OK);
  hsp_workspace_free(&work);
  return bytes;
}
static int32_t ask_merge(scene *s, const hsp_executor *executor) {
  static uint8_t summary[2][SUMMARY_BYTES], merged[2 * SUMMARY_BYTES];
  static size_t bytes[2] = {0, 0};
  size_t of_merged = sizeof merged;
  uint32_t brick;
  (void)s;
  for (brick = 0; brick < 2 && bytes[brick] == 0; ++brick) bytes[brick] = make_summary(brick, summary[brick]);
  return hsp_brick_merge(summary[0], bytes[0], summary[1], bytes[1], executor, merged, &of_merged, NULL);
}

static const question questions[] = {
    {"balls of a model", ask_model, read_model, 0, 2},
    {"pairs that meet", ask_pairs, NULL, 0, 0},
    {"pairs that meet, once", ask_pairs_once, NULL, 0, 0},
    {"balls of a body", ask_body, read_body, 0, 0},
    {"curvatures", ask_curvature, NULL, 0, 0},
    {"measures of a smooth surface", ask_surface_measures, NULL, 0, 0},
    {"boundary", ask_boundary, read_boundary, 0, 0},
    {"measures", ask_measures, NULL, 0, 0},
    {"gradient", ask_gradient, NULL, 0, 0},
    {"derivatives", ask_derivatives, NULL, 0, 0},
    {"area rows", ask_rows, NULL, 0, 0},
    {"morphometry", ask_morphometry, NULL, 0, 0},
    {"gradient of a smooth surface", ask_surface_gradient, NULL, 0, 0},
    {"contacts", ask_contacts, read_contacts, 0, 0},
    {"topology", ask_topology, read_topology, 0, 0},
    {"mesh", ask_mesh, read_mesh, 0, 0},
    {"mesh of a smooth surface", ask_smooth_mesh, read_mesh, 0, 0},
    {"periodic", ask_periodic, read_periodic, 0, 0},
    {"gradient in a box", ask_periodic_gradient, NULL, 0, 0},
    {"morphometry in a box", ask_periodic_morphometry, NULL, 0, 0},
    {"second derivatives", ask_hessian_rows, NULL, 0, 0},
    {"second derivatives times a direction", ask_hessian_product, NULL, 0, 0},
    {"summary of a brick", ask_brick, NULL, 0, 0},
    {"merge of two bricks", ask_merge, NULL, 0, 0},
    {"view", ask_view, read_view, 0, 0},
    {"view of a boundary", ask_whole_view, read_view, 0, 0},
    {"map", ask_map, read_map, 0, 0},
    {"sticks", ask_sticks, read_sticks, 0, 0},
    {"map of sticks", ask_sticks_map, read_sticks, 0, 0},
    {"surface", ask_surface, read_surface, 0, 0},
    {"surface of a shell", ask_surface_of_shell, read_surface, 0, 0},
    {"cells", ask_cells, read_cells, 1, 0},
    {"paths", ask_paths, read_paths, 1, 0},
    {"path", ask_path, NULL, 0, 1},
    {"pores in a box", ask_pores_in_box, read_pores, 1, 0},
    {"pores", ask_pores, read_pores, 1, 0},
    {"regions of pores", ask_regions, NULL, 0, 0},
    {"sizes of pockets", ask_pocket_sizes, NULL, 0, 0},
    {"tunnel", ask_tunnel, NULL, 0, 1},
    {"balls that move", ask_moving, read_moving, 0, 0},
    {"a move of all balls", ask_move, NULL, 0, 0},
};
enum { QUESTIONS = sizeof questions / sizeof questions[0] };

/* ---- the sweep ---- */

/* Makes the computation, says no from question `stop_at` on, and counts the questions. */
static int32_t ask_until(const question *q, scene *s, uint32_t workers, uint32_t stop_at, uint32_t *asked) {
  stopper own;
  hsp_executor executor;
  int32_t status;
  own.own = loop_of(LOOP_IN_ORDER);
  own.asked = 0;
  own.stop_at = stop_at;
  executor = executor_of(&own.own, workers);
  executor.context = &own;
  executor.proceed = stopper_proceed;
  status = q->ask(s, &executor);
  *asked = own.asked;
  return status;
}

static void check_results(const question *q, scene *s, const unsigned char *expected, int32_t status) {
  unsigned char found[256] = {0};
  size_t bytes = 0;
  if (q->read == NULL) return;
  CHECK_EQUAL(q->read(s, found, &bytes), status);
  if (status == HSP_OK) CHECK_BYTES(found, expected, bytes);
}

static void sweep(const question *q, scene *s, uint32_t set, uint32_t workers) {
  unsigned char counts[256] = {0};
  size_t bytes;
  uint32_t questions_asked, asked, k;
  check_scene("%s by %u workers", q->name, (unsigned)workers);
  CHECK_EQUAL(ask_until(q, s, workers, UINT32_MAX, &questions_asked), HSP_OK);
  CHECK(questions_asked >= (q->least != 0 ? q->least : 3));
  if (questions_asked == 0) return;
  if (q->read != NULL) CHECK_EQUAL(q->read(s, counts, &bytes), HSP_OK);
  /* A computation with fewer than 40 questions is stopped at each of them by several sets. */
  for (k = set % (questions_asked < STOPPING_SETS ? questions_asked : STOPPING_SETS); k < questions_asked;
       k += STOPPING_SETS) {
    check_scene("%s by %u workers, stopped at question %u", q->name, (unsigned)workers, (unsigned)k);
    CHECK_EQUAL(ask_until(q, s, workers, k, &asked), HSP_E_STOPPED);
    CHECK(asked > k && asked <= k + WORKERS);
    check_results(q, s, counts, HSP_E_STATE);
  }
  check_scene("%s by %u workers, again", q->name, (unsigned)workers);
  CHECK_EQUAL(ask_until(q, s, workers, UINT32_MAX, &asked), HSP_OK);
  check_results(q, s, counts, HSP_OK);
}

/* Sticks along the chain, of balls that do not meet. */
static int make_sticks(scene *s) {
  static double radius[BALL_SET_MOST];
  size_t bytes = 0;
  uint32_t k;
  int32_t status = HSP_E_CAPACITY;
  for (k = 0; k < s->n; ++k) radius[k] = 0.25;
  for (k = 0; k + 1 < s->n; ++k) {
    const double *const a = s->set->xyz + 3 * k;
    const double d[3] = {a[3] - a[0], a[4] - a[1], a[5] - a[2]};
    if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < 1.6 * 1.6) s->stick[s->bonds++] = (hsp_stick){.ball = {k, k + 1}};
  }
  if (!CHECK_EQUAL(hsp_workspace_set(&s->bare, s->n, s->set->xyz, radius, NULL, NULL), HSP_OK)) return 0;
  if (!CHECK_EQUAL(hsp_sticks_limits_init(&s->sticks_limits, sizeof s->sticks_limits, s->n), HSP_OK)) return 0;
  while (status == HSP_E_CAPACITY) {
    free(s->bare.memory[1]);
    s->bare.memory[1] = NULL;
    if (!CHECK_EQUAL(hsp_sticks_bytes(&s->sticks_limits, &bytes), HSP_OK)) return 0;
    s->bare.memory[1] = malloc(bytes);
    if (!CHECK_EQUAL(hsp_sticks_init(s->bare.memory[1], bytes, &s->sticks_limits, &s->sticks), HSP_OK)) return 0;
    status = hsp_sticks_compute_map(s->sticks, s->bare.model, NULL, s->stick, s->bonds, 0.1, NULL, &s->sticks_limits);
  }
  return CHECK_EQUAL(status, HSP_OK);
}

/* Finds among some maxima the one with the most gates on its way to the outside, and the best one before it. */
static int find_long_tunnel(scene *s) {
  hsp_pores_counts counts;
  hsp_pore_maximum maximum;
  hsp_tunnel tunnel;
  uint32_t k, most = 0;
  if (!CHECK_EQUAL(hsp_pores_get_counts(s->work.pores, &counts), HSP_OK)) return 0;
  for (k = 0; k < counts.maxima; k += 1 + counts.maxima / 8) {
    if (!CHECK_EQUAL(hsp_pores_get_maxima(s->work.pores, k, 1, &maximum), HSP_OK)) return 0;
    if (!CHECK_EQUAL(hsp_workspace_cheapest_tunnel(&s->work, NULL, maximum.xyz, NULL, NULL, 0, &tunnel), HSP_OK))
      return 0;
    if (tunnel.gates < most) continue;
    most = tunnel.gates;
    memcpy(s->inside[1], s->inside[0], sizeof s->inside[0]);
    memcpy(s->inside[0], maximum.xyz, sizeof s->inside[0]);
  }
  return 1;
}

/* Makes a model and a body with room for many balls. */
static int make_many(scene *s) {
  size_t bytes = 0;
  if (!CHECK_EQUAL(hsp_model_bytes(MANY_BALLS, &bytes), HSP_OK)) return 0;
  if (!CHECK_EQUAL(hsp_model_init(s->bare.memory[2] = malloc(bytes), bytes, MANY_BALLS, &s->model), HSP_OK)) return 0;
  if (!CHECK_EQUAL(hsp_body_bytes(MANY_BALLS, &bytes), HSP_OK)) return 0;
  return CHECK_EQUAL(hsp_body_init(s->bare.memory[3] = malloc(bytes), bytes, MANY_BALLS, &s->body), HSP_OK);
}

/* Handles with room for three workers, and with results. */
static int make(scene *s, const ball_set *set, int few) {
  stopper own;
  hsp_executor executor;
  hsp_boundary_request request = {.struct_size = sizeof request};
  const hsp_model_options options = {.struct_size = sizeof options, .probe = 0.4};
  hsp_periodic_request in_box = {.struct_size = sizeof in_box};
  double low = 1e9, high = -1e9;
  uint32_t k;
  hsp_workspace *const work = &s->work;
  memset(s, 0, sizeof *s);
  s->set = set;
  s->n = set->n;
  for (k = 0; k < 3 * set->n; ++k) {
    if (set->xyz[k] < low) low = set->xyz[k];
    if (set->xyz[k] > high) high = set->xyz[k];
  }
  s->box[0] = s->box[4] = s->box[8] = high - low + 1.5;
  own.own = loop_of(LOOP_IN_ORDER);
  executor = executor_of(&own.own, WORKERS);
  request.executor = &executor;
  in_box.executor = &executor;
  if (!(CHECK_EQUAL(hsp_workspace_set(work, set->n, set->xyz, set->radius, &options, NULL), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_boundary_with(work, &request), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_contacts(work), HSP_OK) && CHECK_EQUAL(hsp_workspace_topology(work), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_surface(work), HSP_OK) && CHECK_EQUAL(hsp_workspace_mesh(work, 0, 0.4), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_mesh(work, 1, 0.4), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_periodic_with(work, set->n, set->xyz, set->radius, s->box, &in_box, NULL), HSP_OK)))
    return 0;
  if (few && !CHECK_EQUAL(hsp_workspace_pores_periodic(work, NULL), HSP_OK)) return 0;
  if (!(CHECK_EQUAL(hsp_workspace_view(work, 1, NULL), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_view(work, 0, NULL), HSP_OK) && CHECK_EQUAL(hsp_workspace_map(work, NULL), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_cells(work), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_path(work, (const double[3]){-60, -60, -60}, (const double[3]){60, 60, 60},
                                       (hsp_path[1]){{0}}),
                    HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_pores(work, NULL), HSP_OK) &&
        CHECK_EQUAL(hsp_workspace_moving(work, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL), HSP_OK)))
    return 0;
  return find_long_tunnel(s) && make_sticks(s) && make_many(s);
}

void stopping_sweep(uint32_t first, uint32_t last) {
  static ball_set set[2];
  static scene scenes[2];
  uint32_t k, q, few, workers;
  for (k = first; k < last; ++k) {
    for (few = 0; few < 2; ++few) {
      ball_set_start(&set[few], "chain", 1e-3);
      ball_set_add_chain(&set[few], few ? FEW_BALLS : BALLS, 500 + k);
      if (!make(&scenes[few], &set[few], (int)few)) return;
    }
    for (q = 0; q < QUESTIONS; ++q) {
      for (workers = 1; workers <= WORKERS; workers += WORKERS - 1) {
        sweep(&questions[q], &scenes[questions[q].few], k, workers);
      }
    }
    for (few = 0; few < 2; ++few) {
      hsp_workspace_free(&scenes[few].work);
      hsp_workspace_free(&scenes[few].bare);
    }
  }
}
