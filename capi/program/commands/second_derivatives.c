#include "commands/second_derivatives.h"

#include <stdlib.h>
#include <string.h>

static bool allocate(struct second_derivatives *rows, uint32_t atoms, uint32_t entries, struct failure *failure) {
  rows->first = calloc((size_t)atoms + 1, sizeof *rows->first);
  rows->ball = malloc(((size_t)entries + 1) * sizeof *rows->ball);
  rows->block = malloc((9 * (size_t)entries + 1) * sizeof *rows->block);
  rows->flags = calloc((size_t)atoms + 1, sizeof *rows->flags);
  if (rows->first != NULL && rows->ball != NULL && rows->block != NULL && rows->flags != NULL) return true;
  return failure_of_memory(failure);
}

static bool find(struct second_derivatives *rows, const struct geometry *geometry, uint32_t atoms,
                 const hsp_gradient_request *asked, struct failure *failure) {
  const hsp_boundary *const boundary = geometry->work.boundary;
  hsp_gradient_request request = *asked;
  uint32_t entries = 0;
  if (!allocate(rows, atoms, 0, failure)) return false;
  request.executor = geometry_executor(geometry);
  int32_t status = hsp_boundary_get_hessian_rows(boundary, &request, rows->first, NULL, NULL, NULL, 0, &entries);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  second_derivatives_free(rows);
  if (!allocate(rows, atoms, entries, failure)) return false;
  status = hsp_boundary_get_hessian_rows(boundary, &request, rows->first, rows->ball, rows->block, rows->flags, entries,
                                         &entries);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The sum of two rows of every ball, with the blocks that either has. */
static void merge(const struct second_derivatives *one, const struct second_derivatives *other, uint32_t atoms,
                  struct second_derivatives *sum) {
  const struct second_derivatives *const parts[2] = {one, other};
  uint32_t entries = 0;
  for (uint32_t i = 0; i < atoms; ++i) {
    uint32_t at[2] = {one->first[i], other->first[i]};
    for (;;) {
      uint32_t ball = HSP_NONE;
      for (int k = 0; k < 2; ++k) {
        if (at[k] < parts[k]->first[i + 1] && parts[k]->ball[at[k]] < ball) ball = parts[k]->ball[at[k]];
      }
      if (ball == HSP_NONE) break;
      double *const block = sum->block + 9 * (size_t)entries;
      memset(block, 0, 9 * sizeof *block);
      for (int k = 0; k < 2; ++k) {
        if (at[k] == parts[k]->first[i + 1] || parts[k]->ball[at[k]] != ball) continue;
        for (int e = 0; e < 9; ++e) block[e] += parts[k]->block[9 * (size_t)at[k] + (size_t)e];
        ++at[k];
      }
      sum->ball[entries++] = ball;
    }
    sum->first[i + 1] = entries;
  }
  for (uint32_t i = 0; i <= atoms; ++i) sum->flags[i] = one->flags[i] | other->flags[i];
}

bool second_derivatives_add(struct second_derivatives *sum, const struct geometry *geometry, uint32_t atoms,
                            const hsp_gradient_request *request, struct failure *failure) {
  if (sum->first == NULL) return find(sum, geometry, atoms, request, failure);
  struct second_derivatives before = *sum, more = {NULL, NULL, NULL, NULL};
  memset(sum, 0, sizeof *sum);
  bool done = find(&more, geometry, atoms, request, failure);
  done = done && allocate(sum, atoms, before.first[atoms] + more.first[atoms], failure);
  if (done) merge(&before, &more, atoms, sum);
  second_derivatives_free(&before);
  second_derivatives_free(&more);
  return done;
}

void second_derivatives_free(struct second_derivatives *sum) {
  free(sum->first);
  free(sum->ball);
  free(sum->block);
  free(sum->flags);
  memset(sum, 0, sizeof *sum);
}
