#include "computed.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *take(size_t count, size_t size) {
  void *memory = calloc(count == 0 ? 1 : count, size);
  if (memory == NULL) {
    fprintf(stderr, "out of memory in a test\n");
    exit(2);
  }
  return memory;
}

/* From no room for anything but the balls: the header promises that the second enlargement suffices. */
static int32_t compute_boundary(computed *c) {
  hsp_boundary_limits limits;
  memset(&limits, 0, sizeof limits);
  limits.struct_size = (uint32_t)sizeof limits;
  limits.balls = c->n;
  for (c->enlargements = 0;; ++c->enlargements) {
    size_t bytes = 0;
    int32_t status = hsp_boundary_bytes(&limits, &bytes);
    if (status != HSP_OK) return status;
    free(c->boundary_memory);
    c->boundary_memory = take(bytes, 1);
    status = hsp_boundary_init(c->boundary_memory, bytes, &limits, &c->boundary);
    if (status != HSP_OK) return status;
    status = hsp_boundary_compute(c->boundary, c->model);
    if (status == HSP_OK) return hsp_boundary_get_needed(c->boundary, &c->needed);
    if (status != HSP_E_CAPACITY || c->enlargements == 2) return status;
    status = hsp_boundary_get_needed(c->boundary, &c->needed);
    if (status != HSP_OK) return status;
    if (c->needed.balls > limits.balls) limits.balls = c->needed.balls;
    if (c->needed.neighbours > limits.neighbours) limits.neighbours = c->needed.neighbours;
    if (c->needed.vertices > limits.vertices) limits.vertices = c->needed.vertices;
    if (c->needed.circles > limits.circles) limits.circles = c->needed.circles;
  }
}

static int32_t read_boundary(computed *c) {
  uint32_t needed = 0;
  int32_t status = hsp_boundary_get_counts(c->boundary, &c->counts);
  if (status != HSP_OK) return status;
  c->vertices = take(c->counts.vertices, sizeof *c->vertices);
  c->arcs = take(c->counts.arcs, sizeof *c->arcs);
  c->circles = take(c->counts.circles, sizeof *c->circles);
  c->faces = take(c->counts.faces, sizeof *c->faces);
  status = hsp_boundary_get_vertices(c->boundary, c->vertices, c->counts.vertices, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_arcs(c->boundary, c->arcs, c->counts.arcs, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_circles(c->boundary, c->circles, c->counts.circles, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_faces(c->boundary, c->faces, c->counts.faces, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_balls(c->boundary, c->balls, c->n, &needed);
  if (status == HSP_OK) status = hsp_boundary_measure(c->boundary, &c->totals, c->area, c->volume, c->n);
  return status;
}

static double moved_by_lattice(double value, double step) {
  return fabs(value - floor(value / step + 0.5) * step);
}

int32_t computed_make(uint32_t n, const double *xyz, const double *radius, const hsp_model_options *options,
                      computed *c) {
  size_t bytes = 0;
  uint32_t i;
  int32_t status;
  memset(c, 0, sizeof *c);
  c->n = n;
  c->xyz = take(n, 3 * sizeof(double));
  c->radius = take(n, sizeof(double));
  c->balls = take(n, sizeof *c->balls);
  c->area = take(n, sizeof(double));
  c->volume = take(n, sizeof(double));
  if (n > 0) memcpy(c->xyz, xyz, n * 3 * sizeof(double));

  status = hsp_model_bytes(n, &bytes);
  if (status != HSP_OK) return status;
  c->model_memory = take(bytes, 1);
  status = hsp_model_init(c->model_memory, bytes, n, &c->model);
  if (status == HSP_OK) status = hsp_model_set(c->model, n, xyz, radius, options, NULL);
  if (status == HSP_OK) status = hsp_model_get_info(c->model, &c->info);
  if (status != HSP_OK) return status;
  for (i = 0; i < n; ++i) {
    c->radius[i] = radius[i] + c->info.probe;
    c->rounding = fmax(c->rounding, moved_by_lattice(radius[i], c->info.step));
  }
  for (i = 0; i < 3 * n; ++i) c->rounding = fmax(c->rounding, moved_by_lattice(xyz[i], c->info.step));

  status = compute_boundary(c);
  if (status == HSP_OK) status = read_boundary(c);
  return status;
}

void computed_release(computed *c) {
  free(c->xyz);
  free(c->radius);
  free(c->model_memory);
  free(c->boundary_memory);
  free(c->vertices);
  free(c->arcs);
  free(c->circles);
  free(c->faces);
  free(c->balls);
  free(c->area);
  free(c->volume);
  memset(c, 0, sizeof *c);
}
