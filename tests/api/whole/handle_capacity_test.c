/* Every limit of models, boundaries, topologies, views, contacts, cells, paths, pores, bodies, periodic
 * unions and balls that move, for sets of every kind, at 0, 1, needed-1, needed and needed+1: HSP_E_CAPACITY with
 * nothing written beyond what the header names, or the same results as with ample memory. Memory is of exactly the
 * size that the bytes function tells, with guard bytes around it. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "body_result.h"
#include "cells_result.h"
#include "check.h"
#include "core_sweeps.h"
#include "guarded_memory.h"
#include "limit_sweep.h"
#include "moving_result.h"
#include "output_sweep.h"
#include "paths_result.h"
#include "periodic_result.h"
#include "pores_result.h"
#include "topology_sets.h"
#include "view_result.h"

/* ---- models ---- */

static void sweep_model(const ball_set *set) {
  uint32_t limits[AROUND], i;
  values_around(set->n, limits);
  for (i = 0; i < AROUND; ++i) {
    size_t bytes = 0;
    guarded_memory memory;
    hsp_model *model = NULL;
    hsp_model_info info;
    uint32_t bad = 12345;
    CHECK_EQUAL(hsp_model_bytes(limits[i], &bytes), HSP_OK);
    memory = guarded_take(bytes, i, GUARDED_RANDOM);
    if (CHECK_EQUAL(hsp_model_init(memory.block, bytes, limits[i], &model), HSP_OK)) {
      CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, NULL, &bad),
                  limits[i] < set->n ? HSP_E_CAPACITY : HSP_OK);
      CHECK_EQUAL(bad, HSP_NONE);
      CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
      CHECK_EQUAL(info.balls, limits[i] < set->n ? 0 : set->n);
    }
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
}

/* ---- boundaries ---- */

/* One boundary goes from failure to success and back; nothing of the failure stays. */
static void fail_and_succeed(const computed *all) {
  static const double one_xyz[3] = {0, 0, 0};
  static const double one_radius[1] = {1};
  hsp_boundary_limits limits = all->needed, needed = all->needed;
  hsp_boundary_counts counts;
  size_t bytes = 0, model_bytes = 0;
  guarded_memory memory, model_memory;
  hsp_boundary *boundary = NULL;
  hsp_model *model = NULL;
  if (limits.vertices == 0) return;
  limits.vertices -= 1;
  CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
  CHECK_EQUAL(hsp_model_bytes(1, &model_bytes), HSP_OK);
  memory = guarded_take(bytes, 0, GUARDED_RANDOM);
  model_memory = guarded_take(model_bytes, 0, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_boundary_init(memory.block, bytes, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_model_init(model_memory.block, model_bytes, 1, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 1, one_xyz, one_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, all->model, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_EQUAL(counts.balls, 1);
  CHECK_EQUAL(counts.faces, 1);
  needed.vertices = 0;
  CHECK_EQUAL(hsp_boundary_compute(boundary, all->model, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
  CHECK_EQUAL(needed.vertices, all->needed.vertices);
  CHECK(guarded_clean(&memory) && guarded_clean(&model_memory));
  guarded_give_back(&memory);
  guarded_give_back(&model_memory);
}

/* ---- views ---- */

static void view_results(const void *view, const void *source) {
  const view_result *all = source;
  hsp_view_info info;
  uint32_t count = 0;
  guarded_memory pieces = guarded_take(sizeof(hsp_view_piece) * all->info.pieces, 0, GUARDED_PATTERN);
  guarded_memory loops = guarded_take(sizeof(hsp_view_loop) * all->info.loops, 0, GUARDED_PATTERN);
  guarded_memory arcs = guarded_take(sizeof(hsp_view_arc) * all->info.arcs, 0, GUARDED_PATTERN);
  memset(&info, 0, sizeof info);
  CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_OK);
  CHECK_BYTES(&info, &all->info, sizeof info);
  CHECK_EQUAL(hsp_view_get_pieces(view, (void *)pieces.block, all->info.pieces, &count), HSP_OK);
  CHECK_BYTES(pieces.block, all->pieces, pieces.bytes);
  CHECK_EQUAL(hsp_view_get_loops(view, (void *)loops.block, all->info.loops, &count), HSP_OK);
  CHECK_BYTES(loops.block, all->loops, loops.bytes);
  CHECK_EQUAL(hsp_view_get_arcs(view, (void *)arcs.block, all->info.arcs, &count), HSP_OK);
  CHECK_BYTES(arcs.block, all->arcs, arcs.bytes);
  CHECK(guarded_clean(&pieces) && guarded_clean(&loops) && guarded_clean(&arcs));
  guarded_give_back(&pieces);
  guarded_give_back(&loops);
  guarded_give_back(&arcs);
}

static void no_view_results(const void *view) {
  hsp_view_info info;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_E_STATE);
  CHECK_EQUAL(hsp_view_get_arcs(view, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(count, 12345);
}

static void sweep_view(const computed *c, const hsp_view_options *options, int with_boundary, const char *name) {
  view_result all;
  if (CHECK_EQUAL(view_result_make(c, options, with_boundary, &all), HSP_OK)) {
    const known_handle known = {&view_handle, &all, &all.needed, view_results, no_view_results, NULL};
    CHECK(all.enlargements <= 3);
    sweep_limits(&known, name);
  }
  view_result_release(&all);
}

/* Every kind of pieces, without and with boundary, of balls that may be seen and of all. */
static void sweep_views(const computed *c, uint32_t which, const char *name) {
  hsp_view_options options;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.towards[0] = 3;
  options.towards[1] = which % 3;
  options.towards[2] = 1;
  sweep_view(c, &options, 0, name);
  options.flags = HSP_VIEW_ALL_BALLS;
  sweep_view(c, &options, which % 2 == 0, name);
  options.pieces = HSP_PIECES_OUTSIDE_ALL;
  options.flags = which % 2 == 0 ? 0 : HSP_VIEW_ALL_BALLS;
  sweep_view(c, &options, 1, name);
}

/* ---- cells, bodies, periodic unions and balls that move ---- */

static void cells_results(const void *cells, const void *source) {
  const cells_result *all = source;
  hsp_cells_counts counts;
  guarded_memory list = guarded_take(sizeof(hsp_free_cell) * all->counts.cells, 0, GUARDED_PATTERN);
  guarded_memory pairs = guarded_take(sizeof(hsp_cell_pair) * all->counts.adjacencies, 0, GUARDED_PATTERN);
  CHECK_EQUAL(hsp_cells_get_counts(cells, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_cells_get_cells(cells, 0, counts.cells, (void *)list.block), HSP_OK);
  CHECK_BYTES(list.block, all->list, list.bytes);
  CHECK_EQUAL(hsp_cells_get_pairs(cells, 0, counts.adjacencies, (void *)pairs.block), HSP_OK);
  CHECK_BYTES(pairs.block, all->pairs, pairs.bytes);
  CHECK(guarded_clean(&list) && guarded_clean(&pairs));
  guarded_give_back(&list);
  guarded_give_back(&pairs);
}

static void no_cells_results(const void *cells) {
  hsp_cells_counts counts;
  hsp_free_cell cell;
  CHECK_EQUAL(hsp_cells_get_counts(cells, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_cells_get_cells(cells, 0, 1, &cell), HSP_E_STATE);
}

static void sweep_cells(const computed *c, const char *name) {
  cells_result all;
  if (CHECK_EQUAL(cells_result_make(c, &all), HSP_OK)) {
    const known_handle known = {&cells_handle, &all, &all.needed, cells_results, no_cells_results, NULL};
    sweep_limits(&known, name);
  }
  cells_result_release(&all);
}

/* Of a path the points, of which there are none after a failure. */
static void paths_results(const void *paths, const void *source) {
  const paths_result *all = source;
  const uint32_t count = all->path.points;
  uint32_t needed = 0;
  guarded_memory points = guarded_take(3 * sizeof(double) * count, 0, GUARDED_PATTERN);
  double *known = test_zeros(count, 3 * sizeof(double));
  CHECK_EQUAL(hsp_paths_get_points(all->paths, known, count, &needed), HSP_OK);
  CHECK_EQUAL(hsp_paths_get_points(paths, (void *)points.block, count, &needed), HSP_OK);
  CHECK_EQUAL(needed, count);
  CHECK_BYTES(points.block, known, points.bytes);
  CHECK(guarded_clean(&points));
  guarded_give_back(&points);
  free(known);
}

static void no_paths_results(const void *paths) {
  uint32_t needed = 12345;
  const int32_t status = hsp_paths_get_points(paths, NULL, 0, &needed);
  CHECK(status == HSP_E_STATE ? needed == 12345 : status == HSP_OK && needed == 0);
}

static void sweep_paths(const computed *c, const char *name) {
  paths_result all;
  if (CHECK_EQUAL(paths_result_make(c, &all), HSP_OK)) {
    const known_handle known = {&paths_handle, &all, &all.needed, paths_results, no_paths_results, NULL};
    CHECK(all.path.points >= 2 && all.path.certified == 1);
    sweep_limits(&known, name);
  }
  paths_result_release(&all);
}

/* Of pores all records and the points of the tunnel, of which there are none after a failure. */
static void pores_results(const void *pores, const void *source) {
  const pores_result *all = source;
  const size_t bytes[3] = {all->counts.maxima * sizeof(hsp_pore_maximum), all->counts.gates * sizeof(hsp_pore_gate),
                           all->tunnel.points * sizeof(hsp_tunnel_point)};
  int part;
  for (part = 0; part < 3; ++part) {
    guarded_memory records = guarded_take(bytes[part], 0, GUARDED_PATTERN);
    void *known = test_zeros(1, bytes[part]);
    int copy;
    for (copy = 0; copy < 2; ++copy) {
      const hsp_pores *const handle = copy == 0 ? all->pores : pores;
      void *const out = copy == 0 ? known : (void *)records.block;
      uint32_t needed = all->tunnel.points;
      CHECK_EQUAL(part == 0   ? hsp_pores_get_maxima(handle, 0, all->counts.maxima, out)
                  : part == 1 ? hsp_pores_get_gates(handle, 0, all->counts.gates, out)
                              : hsp_pores_get_tunnel_points(handle, out, all->tunnel.points, &needed),
                  HSP_OK);
      CHECK_EQUAL(needed, all->tunnel.points);
    }
    CHECK_BYTES(records.block, known, bytes[part]);
    CHECK(guarded_clean(&records));
    guarded_give_back(&records);
    free(known);
  }
}

static void no_pores_results(const void *pores) {
  uint32_t needed = 12345;
  const int32_t status = hsp_pores_get_tunnel_points(pores, NULL, 0, &needed);
  CHECK(status == HSP_E_STATE ? needed == 12345 : status == HSP_OK && needed == 0);
}

static void sweep_pores(const computed *c, const char *name) {
  pores_result all;
  if (CHECK_EQUAL(pores_result_make(c, &all), HSP_OK)) {
    const known_handle known = {&pores_handle, &all, &all.needed, pores_results, no_pores_results, NULL};
    CHECK(all.tunnel.there == 1 && all.tunnel.points >= 1);
    sweep_limits(&known, name);
  }
  pores_result_release(&all);
}

static void sweep_pores_in_box(const computed *c, const char *name) {
  periodic_result periodic;
  pores_result all;
  memset(&all, 0, sizeof all);
  if (CHECK_EQUAL(periodic_result_make(c, &periodic), HSP_OK) &&
      CHECK_EQUAL(pores_result_make_in_box(c, periodic.periodic, &all), HSP_OK)) {
    const known_handle known = {&pores_handle, &all, &all.needed, pores_results, no_pores_results, NULL};
    sweep_limits(&known, name);
  }
  pores_result_release(&all);
  periodic_result_release(&periodic);
}

static void body_results(const void *body, const void *source) {
  const body_result *all = source;
  hsp_body_gap gap[BODY_POSES];
  hsp_body_overlap overlap[BODY_POSES];
  CHECK_EQUAL(hsp_body_gaps(body, body, BODY_POSES, body_poses, gap, NULL), HSP_OK);
  CHECK_BYTES(gap, all->gap, sizeof gap);
  CHECK_EQUAL(hsp_body_overlaps(body, body, BODY_POSES, body_poses, overlap, NULL), HSP_OK);
  CHECK_BYTES(overlap, all->overlap, sizeof overlap);
}

static void no_body_results(const void *body) {
  hsp_body_gap gap;
  CHECK_EQUAL(hsp_body_gaps(body, body, 1, body_poses, &gap, NULL), HSP_E_STATE);
}

static void sweep_body(const computed *c, const char *name) {
  body_result all;
  if (CHECK_EQUAL(body_result_make(c, &all), HSP_OK)) {
    const known_handle known = {&body_handle, &all, &all.needed, body_results, no_body_results, NULL};
    sweep_limits(&known, name);
  }
  body_result_release(&all);
}

static void periodic_results(const void *periodic, const void *source) {
  const periodic_result *all = source;
  const uint32_t n = all->base->n;
  hsp_periodic_counts counts;
  hsp_periodic_totals totals;
  uint32_t count = 0;
  guarded_memory list = guarded_take(sizeof(hsp_periodic_contact) * all->counts.contacts, 0, GUARDED_PATTERN);
  guarded_memory windings = guarded_take(sizeof(hsp_winding) * all->counts.components, 0, GUARDED_PATTERN);
  guarded_memory vertices = guarded_take(sizeof(hsp_periodic_vertex) * all->counts.vertices, 0, GUARDED_PATTERN);
  guarded_memory arcs = guarded_take(sizeof(hsp_periodic_arc) * all->counts.arcs, 0, GUARDED_PATTERN);
  guarded_memory circles = guarded_take(sizeof(hsp_periodic_circle) * all->counts.circles, 0, GUARDED_PATTERN);
  guarded_memory area = guarded_take(sizeof(double) * n, 0, GUARDED_PATTERN);
  guarded_memory volume = guarded_take(sizeof(double) * n, 0, GUARDED_PATTERN);
  CHECK_EQUAL(hsp_periodic_get_counts(periodic, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, (void *)list.block, all->counts.contacts, &count), HSP_OK);
  CHECK_BYTES(list.block, all->contacts, list.bytes);
  CHECK_EQUAL(hsp_periodic_get_windings(periodic, (void *)windings.block, all->counts.components, &count), HSP_OK);
  CHECK_BYTES(windings.block, all->windings, windings.bytes);
  CHECK_EQUAL(hsp_periodic_get_vertices(periodic, (void *)vertices.block, all->counts.vertices, &count), HSP_OK);
  CHECK_BYTES(vertices.block, all->vertices, vertices.bytes);
  CHECK_EQUAL(hsp_periodic_get_arcs(periodic, (void *)arcs.block, all->counts.arcs, &count), HSP_OK);
  CHECK_BYTES(arcs.block, all->arcs, arcs.bytes);
  CHECK_EQUAL(hsp_periodic_get_circles(periodic, (void *)circles.block, all->counts.circles, &count), HSP_OK);
  CHECK_BYTES(circles.block, all->circles, circles.bytes);
  CHECK_EQUAL(hsp_periodic_measure(periodic, &totals, (void *)area.block, (void *)volume.block, n, NULL), HSP_OK);
  CHECK_BYTES(&totals, &all->totals, sizeof totals);
  CHECK_BYTES(area.block, all->area, area.bytes);
  CHECK_BYTES(volume.block, all->share_volume, volume.bytes);
  CHECK(guarded_clean(&list) && guarded_clean(&windings) && guarded_clean(&area) && guarded_clean(&volume));
  CHECK(guarded_clean(&vertices) && guarded_clean(&arcs) && guarded_clean(&circles));
  guarded_give_back(&list);
  guarded_give_back(&windings);
  guarded_give_back(&vertices);
  guarded_give_back(&arcs);
  guarded_give_back(&circles);
  guarded_give_back(&area);
  guarded_give_back(&volume);
}

static void no_periodic_results(const void *periodic) {
  hsp_periodic_counts counts;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_periodic_get_counts(periodic, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(count, 12345);
}

static void sweep_periodic(const computed *c, const char *name) {
  periodic_result all;
  if (CHECK_EQUAL(periodic_result_make(c, &all), HSP_OK)) {
    const known_handle known = {&periodic_handle, &all, &all.needed, periodic_results, no_periodic_results, NULL};
    sweep_limits(&known, name);
  }
  periodic_result_release(&all);
}

static void moving_results(const void *moving, const void *source) {
  const moving_result *all = source;
  hsp_moving_info info;
  hsp_totals totals;
  hsp_energy energy;
  CHECK_EQUAL(hsp_moving_get_info(moving, &info), HSP_OK);
  CHECK_BYTES(&info, &all->info, sizeof info);
  CHECK_EQUAL(hsp_moving_measure(moving, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&totals, &all->totals, sizeof totals);
  CHECK_EQUAL(hsp_moving_gradient(moving, &energy, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&energy, &all->energy, sizeof energy);
}

static void no_moving_results(const void *moving) {
  hsp_moving_info info;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_moving_get_info(moving, &info), HSP_E_STATE);
  CHECK_EQUAL(hsp_moving_get_changed(moving, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(count, 12345);
}

static void sweep_moving(const computed *c, const char *name) {
  moving_result all;
  if (CHECK_EQUAL(moving_result_make(c, &all), HSP_OK)) {
    const known_handle known = {&moving_handle, &all, &all.needed, moving_results, no_moving_results, NULL};
    CHECK(all.enlargements <= 2);
    CHECK_EQUAL(all.needed.neighbours, c->needed.neighbours);
    sweep_limits(&known, name);
  }
  moving_result_release(&all);
}

int main(void) {
  static ball_set set;
  computed all;
  uint32_t which;
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    sweep_model(&set);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &all), HSP_OK)) {
      sweep_boundary(&all, set.name, sweep_limits);
      check_scene("%s", set.name);
      fail_and_succeed(&all);
    }
    computed_release(&all);
  }
  for (which = 0; which < topology_set_count(); ++which) {
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &all), HSP_OK)) {
      sweep_topology(&all, set.name, sweep_limits);
      sweep_views(&all, which, set.name);
      sweep_body(&all, set.name);
      sweep_moving(&all, set.name);
      if (which % 3 == 0) sweep_contacts(&all, set.name, sweep_limits);
      if (which % 3 == 2 && set.n <= 60) sweep_periodic(&all, set.name);
      /* They have nine limits, so that a few balls must do. */
      if (which % 3 == 1 && set.n <= 12) sweep_cells(&all, set.name);
      if (which % 3 == 2 && set.n <= 5) sweep_paths(&all, set.name);
      if (which % 3 == 0 && set.n <= 12) sweep_pores(&all, set.name);
      if (which % 3 == 1 && set.n <= 12) sweep_pores_in_box(&all, set.name);
    }
    computed_release(&all);
  }
  return check_report();
}
