#include "commands/space_geometry.h"

#include "read/stopping.h"

#include <math.h>
#include <stdlib.h>

bool geometry_compute_cells(struct geometry *geometry, struct failure *failure) {
  progress_show(&geometry->progress, "cutting free space");
  const int32_t status = hsp_workspace_cells(&geometry->work);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_find_path(struct geometry *geometry, const double from[3], const double to[3], hsp_path *path,
                        struct failure *failure) {
  progress_show(&geometry->progress, "looking for a path");
  const int32_t status = hsp_workspace_path(&geometry->work, from, to, path);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--from or --to: %s", geometry_reason(status));
  return status == HSP_OK || failure_in_library(failure, status);
}

typedef int32_t attempt(hsp_workspace *work, const void *of);

/* Try on the lattice of the model, then on coarser ones as long as the results are too wide for it. */
static bool try_coarser(struct geometry *geometry, const struct molecule *molecule, double probe, attempt *find,
                        const void *of, int32_t *status, struct failure *failure) {
  enum { COARSER = 6 };
  hsp_model_info info;
  *status = find(&geometry->work, of);
  for (int time = 0; time < COARSER && *status == HSP_E_RANGE; ++time) {
    *status = hsp_model_get_info(geometry->work.model, &info);
    if (*status != HSP_OK) return failure_in_library(failure, *status);
    if (!geometry_set_model(geometry, molecule, probe, 10.0 * info.step, failure)) return false;
    *status = find(&geometry->work, of);
  }
  return true;
}

static hsp_pores_request request_of_pores(void) {
  return (hsp_pores_request){.struct_size = (uint32_t)sizeof(hsp_pores_request), .executor = stopping_executor()};
}

static hsp_pores_options pores_of(double narrowest) {
  return (hsp_pores_options){
      .struct_size = (uint32_t)sizeof(hsp_pores_options), .floor = narrowest, .executor = stopping_executor()};
}

static int32_t find_pores(hsp_workspace *work, const void *of) {
  return hsp_workspace_pores(work, of);
}

struct ends {
  const double *from, *to;
  hsp_pore_passage *passage;
};

static int32_t find_passage(hsp_workspace *work, const void *of) {
  const struct ends *const ends = of;
  const int32_t status = hsp_workspace_pores(work, NULL);
  return status != HSP_OK ? status : hsp_pores_widest(work->pores, ends->from, ends->to, ends->passage);
}

static int order_of_balls(const void *left, const void *right) {
  const uint32_t *a = left, *b = right;
  return (*a > *b) - (*a < *b);
}

/* The balls that stop a wider probe. */
static int32_t take_gate(const hsp_pores *pores, const hsp_pore_passage *passage, struct widest_probe *widest) {
  hsp_pore_gate gate;
  if (passage->ball != HSP_NONE) widest->gate[widest->balls++] = passage->ball;
  if (passage->gate == HSP_NONE) return HSP_OK;
  const int32_t status = hsp_pores_get_gates(pores, passage->gate, 1, &gate);
  if (status != HSP_OK) return status;
  widest->balls = 3;
  for (int k = 0; k < 3; ++k) widest->gate[k] = gate.ball[k];
  qsort(widest->gate, 3, sizeof *widest->gate, order_of_balls);
  return HSP_OK;
}

bool geometry_find_widest(struct geometry *geometry, const struct molecule *molecule, const double from[3],
                          const double *to, struct widest_probe *widest, struct failure *failure) {
  hsp_pore_passage passage;
  const struct ends ends = {from, to, &passage};
  int32_t status = HSP_OK;
  *widest = (struct widest_probe){.passes = false};
  progress_show(&geometry->progress, "looking for the widest probe");
  if (!try_coarser(geometry, molecule, 0.0, find_passage, &ends, &status, failure)) return false;
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--from or --to: %s", geometry_reason(status));
  if (status == HSP_OK) status = take_gate(geometry->work.pores, &passage, widest);
  if (status != HSP_OK) return failure_in_library(failure, status);
  widest->passes = passage.passes != 0;
  widest->radius = passage.radius;
  return true;
}

static bool find_pores_with(struct geometry *geometry, const struct molecule *molecule, double probe,
                            const hsp_pores_options *options, struct failure *failure) {
  int32_t status = HSP_OK;
  progress_show(&geometry->progress, "looking for pores");
  return try_coarser(geometry, molecule, probe, find_pores, options, &status, failure) &&
         (status == HSP_OK ||
          (status == HSP_E_RANGE ? failure_in_input(failure, 0, "balls are too far apart for their radii")
                                 : failure_in_library(failure, status)));
}

bool geometry_find_pores(struct geometry *geometry, const struct molecule *molecule, double probe, double narrowest,
                         struct failure *failure) {
  const hsp_pores_options options = pores_of(narrowest);
  return find_pores_with(geometry, molecule, probe, &options, failure);
}

/* Compute the pores of the model, or of the box. */
static int32_t compute_pores(const struct geometry *geometry, bool in_box, double narrowest, hsp_pores_limits *limits) {
  const hsp_pores_options options = pores_of(narrowest);
  hsp_pores *const pores = geometry->work.pores;
  return in_box ? hsp_pores_compute_periodic(pores, geometry->periodic, &options, limits)
                : hsp_pores_compute(pores, geometry->work.model, &options, limits);
}

static bool find_pores_of_box(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                              const double *box, double narrowest, struct failure *failure) {
  if (!geometry_compute_periodic(geometry, molecule, probe, step, box, failure)) return false;
  hsp_workspace *const work = &geometry->work;
  progress_show(&geometry->progress, "looking for pores");
  int32_t status = hsp_workspace_ready_pores(work);
  hsp_pores_limits limits = work->pores_limits;
  while (status == HSP_OK) {
    status = compute_pores(geometry, true, narrowest, &limits);
    if (status != HSP_E_CAPACITY) break;
    status = hsp_workspace_grow_pores(work, &limits);
  }
  if (status == HSP_E_RANGE) {
    return failure_in_input(failure, 0, "the box is too long for its width, or a probe in it is too wide");
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_find_pores_in_box(struct geometry *geometry, const struct molecule *molecule, const double *box,
                                double narrowest, struct failure *failure) {
  return find_pores_of_box(geometry, molecule, 0.0, 0.0, box, narrowest, failure);
}

/* Find the pores of the balls grown by a probe, and the surface of these balls. step: the lattice's, 0: the library
 * chooses it. before: as in hsp_pores_options. */
static bool find_pores_and_surface(struct geometry *geometry, const struct molecule *molecule, const double *box,
                                   double probe, double step, const hsp_pores *before, struct failure *failure) {
  hsp_pores_options options = pores_of(0.0);
  options.before = before;
  return box != NULL ? find_pores_of_box(geometry, molecule, probe, step, box, 0.0, failure)
                     : geometry_set_model(geometry, molecule, probe, step, failure) &&
                           find_pores_with(geometry, molecule, probe, &options, failure) &&
                           geometry_compute_boundary(geometry, failure);
}

bool geometry_find_regions(struct geometry *geometry, const struct molecule *molecule, const double *box, double probe,
                           hsp_pore_access *access, uint32_t *regions, struct failure *failure) {
  if (!find_pores_and_surface(geometry, molecule, box, probe, 0.0, NULL, failure)) return false;
  progress_show(&geometry->progress, "measuring regions");
  const hsp_pores_request request = request_of_pores();
  const int32_t status = hsp_pores_find_regions_with(geometry->work.pores, box != NULL ? NULL : geometry->work.boundary,
                                                     &request, access, regions);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--regions: free space is too narrow somewhere");
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Balls and plugs, the latter of mouths or of leaks; freed by free_balls, on false too. */
static bool take_plugged_balls(const hsp_pores *pores, struct molecule *balls, struct failure *failure) {
  int32_t status = hsp_pores_get_plugged_balls(pores, NULL, NULL, 0, &balls->atoms);
  balls->xyz = calloc((size_t)balls->atoms + 1, 3 * sizeof *balls->xyz);
  balls->radius = calloc((size_t)balls->atoms + 1, sizeof *balls->radius);
  balls->line = calloc((size_t)balls->atoms + 1, sizeof *balls->line);
  if (balls->xyz == NULL || balls->radius == NULL || balls->line == NULL) return failure_of_memory(failure);
  if (status == HSP_OK) status = hsp_pores_get_plugged_balls(pores, balls->xyz, balls->radius, balls->atoms, NULL);
  return status == HSP_OK || failure_in_library(failure, status);
}

static void free_balls(struct molecule *balls) {
  free(balls->xyz);
  free(balls->radius);
  free(balls->line);
}

static void set_unknown(hsp_pore_pocket_size *sizes, uint32_t pockets) {
  for (uint32_t k = 0; k < pockets; ++k) {
    sizes[k] = (hsp_pore_pocket_size){.volume = (double)NAN, .area = (double)NAN, .plug_area = (double)NAN};
  }
}

static bool are_closed(const hsp_pore_pocket_size *sizes, uint32_t pockets) {
  for (uint32_t k = 0; k < pockets; ++k) {
    if (sizes[k].closed == 0) return false;
  }
  return true;
}

/* The first step of the lattice for balls with plugs: that of the pores with the pockets, as the library's own choice
 * may be finer, since radii of 0 are grown. In a box it is 0: the library's choice. */
static bool first_step(const struct geometry *geometry, const double *box, double *step, struct failure *failure) {
  hsp_model_info info = {.step = 0.0};
  const int32_t status = box != NULL ? HSP_OK : hsp_model_get_info(geometry->work.model, &info);
  *step = info.step;
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The next one where radii have room. */
static double step_for(const struct molecule *balls, double step) {
  double largest = 0.0;
  for (uint32_t k = 0; k < balls->atoms; ++k) largest = largest > balls->radius[k] ? largest : balls->radius[k];
  while (step > 0.0 && largest >= ldexp(step, 30)) step *= 10.0;
  return step;
}

/* Measure pockets with plugs, and again with further plugs for those that leak, until none does. plugged: [2], used by
 * turns, as pores are computed from those before. HSP_E_RANGE, HSP_E_ARGUMENT: it is impossible with this step. */
static bool measure_plugged(const struct geometry *geometry, struct geometry *plugged, const double *box, double step,
                            uint32_t pockets, hsp_pore_pocket_size *sizes, int32_t *status, struct failure *failure) {
  enum { MOST_TIMES = 12 };
  uint32_t before = 0;
  for (int time = 0; time < MOST_TIMES; ++time) {
    struct molecule balls = {.atoms = 0};
    const hsp_pores *const from = time == 0 ? geometry->work.pores : plugged[1 - time % 2].work.pores;
    struct geometry *const now = &plugged[time % 2];
    bool done = take_plugged_balls(from, &balls, failure);
    const bool more = balls.atoms > before;
    before = balls.atoms;
    if (done) step = step_for(&balls, step);
    if (done && more && !find_pores_and_surface(now, &balls, box, 0.0, step, from, failure)) {
      done = failure->exit_status == EXIT_BAD_INPUT && !failure->of_memory;
      *status = HSP_E_RANGE;
    }
    free_balls(&balls);
    if (!done || !more || *status != HSP_OK) return done;
    const hsp_pores_request request = request_of_pores();
    *status = hsp_pores_measure_pockets_with(geometry->work.pores, now->work.pores,
                                             box != NULL ? NULL : now->work.boundary, &request, sizes, pockets, NULL);
    if (*status == HSP_E_RANGE || *status == HSP_E_ARGUMENT) return true;
    if (*status != HSP_OK) return failure_in_library(failure, *status);
    if (are_closed(sizes, pockets)) return true;
  }
  return true;
}

/* Pores of the balls with plugs are computed in a geometry of their own, as those with the pockets must stay. In a box
 * they are tried again with the step 1e-8, which balls without radii have. */
bool geometry_measure_pockets(const struct geometry *geometry, const double *box, uint32_t pockets,
                              hsp_pore_pocket_size *sizes, struct failure *failure) {
  if (pockets == 0) return true;
  const struct failure none = *failure;
  struct geometry plugged[2];
  for (int k = 0; k < 2; ++k) {
    plugged[k] = (struct geometry){.progress = geometry->progress, .executor = geometry->executor};
    plugged[k].executor.context = &plugged[k].executor;
  }
  int32_t status = HSP_OK;
  double step = 0.0;
  bool done = first_step(geometry, box, &step, failure) &&
              measure_plugged(geometry, plugged, box, step, pockets, sizes, &status, failure);
  if (done && status != HSP_OK && box != NULL) {
    status = HSP_OK;
    *failure = none;
    done = measure_plugged(geometry, plugged, box, 1e-8, pockets, sizes, &status, failure);
  }
  if (done && status != HSP_OK) {
    *failure = none;
    set_unknown(sizes, pockets);
  }
  for (int k = 0; k < 2; ++k) geometry_free(&plugged[k]);
  return done;
}

static int order_of_pockets(const void *left, const void *right) {
  const struct sized_pocket *const a = left, *const b = right;
  if (a->volume != b->volume) return a->volume > b->volume ? -1 : 1;
  return (a->pocket > b->pocket) - (a->pocket < b->pocket);
}

void sized_pockets_sort(struct sized_pocket *pockets, uint32_t count) {
  if (count > 1) qsort(pockets, count, sizeof *pockets, order_of_pockets);
}

bool geometry_find_tunnel(struct geometry *geometry, const struct tunnel_question *question, hsp_tunnel *tunnel,
                          struct failure *failure) {
  hsp_workspace *const work = &geometry->work;
  hsp_pores_limits limits = work->pores_limits;
  int32_t status = HSP_OK;
  const hsp_tunnel_request request = {
      .struct_size = (uint32_t)sizeof request, .cheapest = question->cheapest ? 1 : 0, .executor = stopping_executor()};
  progress_show(&geometry->progress, "looking for tunnels");
  while (status == HSP_OK) {
    status = hsp_pores_find_tunnel_with(work->pores, question->from, question->to, question->avoided, question->count,
                                        &request, tunnel, &limits);
    if (status != HSP_E_CAPACITY) break;
    status = hsp_workspace_grow_pores(work, &limits);
    if (status == HSP_OK) status = compute_pores(geometry, question->in_box, question->narrowest, NULL);
  }
  if (status == HSP_E_RANGE && question->in_box) {
    return failure_in_input(failure, 0, "the tunnel leads more than 2^17 boxes away");
  }
  return status == HSP_OK || failure_in_library(failure, status);
}
