#include "computed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "loops.h"
HANDLE_FUNCTIONS(boundary)
LIMITS_OF_BALLS(boundary)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const computed *c = source;
  return hsp_boundary_compute(handle, c->model, limits);
}

const handle_kind boundary_handle = {(uint32_t)sizeof(hsp_boundary_limits),
                                     4,
                                     {"", "balls", "neighbours", "vertices", "circles", "workers"},
                                     init_limits,
                                     bytes_of_limits,
                                     init_handle,
                                     compute_handle,
                                     0};

static int32_t compute_boundary(computed *c) {
  void *boundary = NULL;
  const int32_t status =
      grow_until_computed(&boundary_handle, c, c->n, &c->boundary_memory, &boundary, &c->needed, &c->enlargements);
  c->boundary = boundary;
  return status;
}

static int32_t read_boundary(computed *c) {
  uint32_t needed = 0;
  int32_t status = hsp_boundary_get_counts(c->boundary, &c->counts);
  if (status != HSP_OK) return status;
  c->vertices = test_zeros(c->counts.vertices, sizeof *c->vertices);
  c->arcs = test_zeros(c->counts.arcs, sizeof *c->arcs);
  c->circles = test_zeros(c->counts.circles, sizeof *c->circles);
  c->faces = test_zeros(c->counts.faces, sizeof *c->faces);
  c->loops = test_zeros(c->counts.loops, sizeof *c->loops);
  c->loop_arcs = test_zeros(2 * (size_t)c->counts.arcs, sizeof *c->loop_arcs);
  status = hsp_boundary_get_vertices(c->boundary, c->vertices, c->counts.vertices, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_arcs(c->boundary, c->arcs, c->counts.arcs, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_circles(c->boundary, c->circles, c->counts.circles, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_faces(c->boundary, c->faces, c->counts.faces, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_loops(c->boundary, c->loops, c->counts.loops, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_loop_arcs(c->boundary, c->loop_arcs, 2 * c->counts.arcs, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_balls(c->boundary, c->balls, c->n, &needed);
  if (status == HSP_OK) status = hsp_boundary_measure(c->boundary, NULL, &c->totals, c->area, c->volume, c->n, NULL);
  return status;
}

static double moved_by_lattice(double value, double step) {
  return fabs(value - floor(value / step + 0.5) * step);
}

hsp_model_options options_with_probe(double probe) {
  hsp_model_options options;
  (void)hsp_model_options_init(&options, (uint32_t)sizeof options);
  options.probe = probe;
  return options;
}

void spread_balls(uint32_t n, const double (*ball)[4], double *xyz, double *radius) {
  uint32_t i;
  for (i = 0; i < n; ++i) {
    memcpy(xyz + 3 * i, ball[i], 3 * sizeof *xyz);
    radius[i] = ball[i][3];
  }
}

int32_t computed_make(uint32_t n, const double *xyz, const double *radius, const hsp_model_options *options,
                      computed *c) {
  size_t bytes = 0;
  uint32_t i;
  int32_t status;
  memset(c, 0, sizeof *c);
  c->n = n;
  c->xyz = test_zeros(n, 3 * sizeof(double));
  c->radius = test_zeros(n, sizeof(double));
  c->balls = test_zeros(n, sizeof *c->balls);
  c->area = test_zeros(n, sizeof(double));
  c->volume = test_zeros(n, sizeof(double));
  if (n > 0) memcpy(c->xyz, xyz, n * 3 * sizeof(double));

  status = hsp_model_bytes(n, &bytes);
  if (status != HSP_OK) return status;
  c->model_memory = test_zeros(bytes, 1);
  status = hsp_model_init(c->model_memory, bytes, n, &c->model);
  if (status == HSP_OK) status = hsp_model_set(c->model, n, xyz, radius, options, NULL);
  if (status == HSP_OK) status = hsp_model_get_info(c->model, &c->info);
  if (status != HSP_OK) return status;
  for (i = 0; i < n; ++i) {
    c->radius[i] = radius[i] + c->info.probe;
    c->rounding = fmax(c->rounding, moved_by_lattice(radius[i], c->info.step));
  }
  for (i = 0; i < 3 * n; ++i) {
    c->extent = fmax(c->extent, fabs(xyz[i]));
    c->rounding = fmax(c->rounding, moved_by_lattice(xyz[i], c->info.step));
  }

  status = compute_boundary(c);
  if (status == HSP_OK) status = read_boundary(c);
  return status;
}

static void free_records(computed *c) {
  free(c->vertices);
  free(c->arcs);
  free(c->circles);
  free(c->faces);
  free(c->loops);
  free(c->loop_arcs);
}

int32_t computed_by_workers(computed *c, uint32_t workers, uint64_t seed) {
  loop own = loop_of(LOOP_SHUFFLED);
  const hsp_executor executor = executor_of(&own, workers);
  hsp_boundary_request request = {.struct_size = sizeof request};
  hsp_boundary_limits limits = c->needed;
  size_t bytes = 0;
  int32_t status;
  own.seed = seed;
  request.executor = &executor;
  limits.workers = workers;
  status = hsp_boundary_bytes(&limits, &bytes);
  if (status != HSP_OK) return status;
  free(c->boundary_memory);
  c->boundary_memory = test_zeros(bytes, 1);
  status = hsp_boundary_init(c->boundary_memory, bytes, &limits, &c->boundary);
  if (status == HSP_OK) status = hsp_boundary_compute_with(c->boundary, c->model, &request, &c->needed);
  if (status != HSP_OK) return status;
  c->needed.workers = 0;
  free_records(c);
  return read_boundary(c);
}

void computed_release(computed *c) {
  free(c->xyz);
  free(c->radius);
  free(c->model_memory);
  free(c->boundary_memory);
  free_records(c);
  free(c->balls);
  free(c->area);
  free(c->volume);
  memset(c, 0, sizeof *c);
}
