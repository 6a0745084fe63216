/* A neighbour list for a force field: all pairs of atoms at most a cutoff apart, each once.
 *   neighbour_list FILE.xyzr CUTOFF [PRINT]     x y z r on each line; the radii do not matter
 * One row an atom: how many later atoms are within the cutoff, and which, if PRINT is given. */
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <stdlib.h>

#include "read_balls.h"

/* Points that have half the cutoff about them meet if they are at most a cutoff apart. */
static int32_t set_points(hsp_workspace *work, const struct balls *points, double cutoff) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = cutoff / 2;
  double *no_radius = calloc((size_t)points->count + 1, sizeof *no_radius);
  if (no_radius == NULL) return HSP_E_MEMORY;
  if (status == HSP_OK) status = hsp_workspace_set(work, points->count, points->xyz, no_radius, &options, NULL);
  free(no_radius);
  return status;
}

static int32_t list_pairs(const hsp_model *model, uint32_t atoms, int print) {
  uint32_t pairs = 0;
  uint32_t *first = malloc(((size_t)atoms + 1) * sizeof *first);
  if (first == NULL) return HSP_E_MEMORY;
  /* Counting tells how much room the list takes. */
  int32_t status = hsp_query_pairs(model, HSP_PAIRS_ONCE, first, NULL, 0, &pairs);
  uint32_t *ids = malloc(((size_t)pairs + 1) * sizeof *ids);
  if (ids == NULL) status = HSP_E_MEMORY;
  if (status == HSP_E_CAPACITY) status = hsp_query_pairs(model, HSP_PAIRS_ONCE, first, ids, pairs, &pairs);
  if (status == HSP_OK) {
    printf("%u pairs\n", (unsigned)pairs);
    for (uint32_t i = 0; print && i < atoms; ++i) {
      printf("%u:", (unsigned)i);
      for (uint32_t k = first[i]; k < first[i + 1]; ++k) printf(" %u", (unsigned)ids[k]);
      printf("\n");
    }
  }
  free(first);
  free(ids);
  return status;
}

int main(int count, char **arguments) {
  struct balls points = {0, NULL, NULL};
  hsp_workspace work = {0};
  if (count < 3 || count > 4) {
    fprintf(stderr, "usage: neighbour_list FILE.xyzr CUTOFF [PRINT]\n");
    return 2;
  }
  int done = read_balls(arguments[1], &points);
  if (done) {
    int32_t status = set_points(&work, &points, strtod(arguments[2], NULL));
    if (status == HSP_OK) status = list_pairs(work.model, points.count, count == 4);
    if (status != HSP_OK) fprintf(stderr, "neighbour_list: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  hsp_workspace_free(&work);
  free_balls(&points);
  return done ? 0 : 1;
}
