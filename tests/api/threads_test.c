/* Handles that are passed as const may be read by any number of threads at a time, and distinct handles used by
 * distinct threads: four threads read one model and one boundary while computing boundaries of their own from that
 * model. */
#include <hardsphere.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"

enum { THREADS = 4, ROUNDS = 20 };

typedef struct work {
  const computed *shared;
  uint64_t answers; /* a hash of everything read */
  int failed;
} work;

static uint64_t mixed(uint64_t hash, const void *bytes, size_t size) {
  const unsigned char *from = bytes;
  size_t i;
  for (i = 0; i < size; ++i) hash = (hash ^ from[i]) * UINT64_C(0x100000001B3);
  return hash;
}

static void *read_and_compute(void *argument) {
  work *mine = argument;
  const computed *shared = mine->shared;
  const hsp_model *model = shared->model;
  const hsp_boundary *boundary = shared->boundary;
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  uint32_t ids[BALL_SET_MOST], needed, i;
  size_t bytes = 0;
  int round;
  hsp_boundary *own = NULL;
  void *memory;
  double *area = malloc(shared->n * sizeof *area);
  hsp_vertex *vertices = malloc((shared->counts.vertices + 1) * sizeof *vertices);
  double *faces = malloc((2 * (size_t)shared->counts.faces + 1) * sizeof *faces);
  double *gradient = malloc((4 * (size_t)shared->n + 1) * sizeof *gradient);
  uint32_t *flags = malloc((shared->n + 1) * sizeof *flags);
  hsp_area_derivative *row = malloc((shared->n + 1) * sizeof *row);
  mine->failed = hsp_boundary_bytes(&shared->needed, &bytes) != HSP_OK;
  memory = malloc(bytes);
  if (memory == NULL || area == NULL || vertices == NULL || faces == NULL || gradient == NULL || flags == NULL ||
      row == NULL) {
    exit(2);
  }
  mine->failed |= hsp_boundary_init(memory, bytes, &shared->needed, &own) != HSP_OK;
  for (round = 0; round < ROUNDS && !mine->failed; ++round) {
    hsp_boundary_counts counts;
    hsp_totals totals;
    for (i = 0; i < shared->n; ++i) {
      mine->failed |= hsp_query_neighbours(model, i, ids, BALL_SET_MOST, &needed) != HSP_OK;
      hash = mixed(hash, ids, needed * sizeof ids[0]);
      mine->failed |= hsp_query_ball(model, shared->xyz + 3 * i, 2.5, ids, BALL_SET_MOST, &needed) != HSP_OK;
      hash = mixed(hash, ids, needed * sizeof ids[0]);
    }
    mine->failed |= hsp_boundary_get_vertices(boundary, vertices, shared->counts.vertices, &needed) != HSP_OK;
    hash = mixed(hash, vertices, needed * sizeof *vertices);
    mine->failed |= hsp_boundary_measure(boundary, &totals, area, NULL, shared->n) != HSP_OK;
    hash = mixed(hash, area, shared->n * sizeof *area);
    {
      const size_t face_count = shared->counts.faces;
      hsp_energy energy;
      mine->failed |= hsp_boundary_measure_faces(boundary, faces, faces + face_count, shared->counts.faces) != HSP_OK;
      hash = mixed(hash, faces, 2 * face_count * sizeof *faces);
      mine->failed |= hsp_boundary_gradient(boundary, area, 1, -0.5, HSP_TANGENT_MEETING, &energy, gradient,
                                            gradient + 3 * (size_t)shared->n, flags, shared->n) != HSP_OK;
      hash = mixed(hash, &energy, sizeof energy);
      hash = mixed(hash, gradient, 4 * (size_t)shared->n * sizeof *gradient);
      hash = mixed(hash, flags, shared->n * sizeof *flags);
      for (i = 0; i < shared->n; ++i) {
        mine->failed |= hsp_boundary_get_area_row(boundary, i, HSP_TANGENT_APART, row, shared->n, &needed) != HSP_OK;
        hash = mixed(hash, row, needed * sizeof *row);
      }
    }
    mine->failed |= hsp_boundary_compute(own, model) != HSP_OK;
    mine->failed |= hsp_boundary_get_counts(own, &counts) != HSP_OK;
    mine->failed |= memcmp(&counts, &shared->counts, sizeof counts) != 0;
    mine->failed |= hsp_boundary_measure(own, &totals, area, NULL, shared->n) != HSP_OK;
    hash = mixed(hash, area, shared->n * sizeof *area);
  }
  free(memory);
  free(area);
  free(vertices);
  free(faces);
  free(gradient);
  free(flags);
  free(row);
  mine->answers = hash;
  return NULL;
}

int main(void) {
  static ball_set set;
  computed shared;
  work works[THREADS];
  pthread_t threads[THREADS];
  int t;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 120, 77);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &shared), HSP_OK);
  for (t = 0; t < THREADS; ++t) {
    memset(&works[t], 0, sizeof works[t]);
    works[t].shared = &shared;
    if (!CHECK_EQUAL(pthread_create(&threads[t], NULL, read_and_compute, &works[t]), 0)) return check_report();
  }
  for (t = 0; t < THREADS; ++t) {
    CHECK_EQUAL(pthread_join(threads[t], NULL), 0);
    CHECK(!works[t].failed);
    CHECK(works[t].answers == works[0].answers);
  }
  computed_release(&shared);
  return check_report();
}
