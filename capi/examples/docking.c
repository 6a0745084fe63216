/* Rigid docking on a grid: a ligand is shifted along x, y and z, and placed where it touches most without a clash.
 *   docking RECEPTOR.xyzr LIGAND.xyzr [STEP]      x y z r on each line
 * A place clashes if a ball of the ligand meets a ball of the receptor. Contacts are the balls of the receptor within
 * `reach` of the ligand's surface. The receptor is hashed once; each question is one query. */
#include <float.h>
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <stdlib.h>

#include "read_balls.h"

enum { MOST_STEPS = 100000 };
static const double reach = 1.0;

struct search {
  const hsp_model *receptor;
  const struct balls *ligand;
  uint32_t *ids; /* room for all balls of the receptor */
  uint32_t capacity;
  unsigned long places, clashes, queries;
};

static int32_t try_place(struct search *search, const double shift[3], uint32_t *clashes, uint32_t *contacts) {
  const struct balls *ligand = search->ligand;
  int32_t status = HSP_OK;
  *clashes = 0;
  *contacts = 0;
  for (int pass = 0; pass < 2; ++pass) {
    for (uint32_t i = 0; i < ligand->count && status == HSP_OK && !*clashes; ++i) {
      const double *c = ligand->xyz + 3 * (size_t)i;
      const double at[3] = {c[0] + shift[0], c[1] + shift[1], c[2] + shift[2]};
      uint32_t hits = 0;
      if (pass == 0) {
        status = hsp_query_meets(search->receptor, at, ligand->radius[i], clashes);
      } else {
        status = hsp_query_ball(search->receptor, at, ligand->radius[i] + reach, search->ids, search->capacity, &hits);
      }
      *contacts += hits;
      ++search->queries;
    }
  }
  return status;
}

static void bounds(const struct balls *balls, int axis, double *low, double *high) {
  for (uint32_t i = 0; i < balls->count; ++i) {
    const double x = balls->xyz[3 * (size_t)i + (size_t)axis], r = balls->radius[i];
    if (i == 0 || x - r < *low) *low = x - r;
    if (i == 0 || x + r > *high) *high = x + r;
  }
}

static int32_t search_grid(struct search *search, const struct balls *receptor, double step) {
  double first[3], best[3] = {0, 0, 0};
  uint32_t steps[3], most = 0;
  int32_t status = HSP_OK;
  for (int axis = 0; axis < 3; ++axis) {
    double low = 0, high = 0, own_low = 0, own_high = 0;
    bounds(receptor, axis, &low, &high);
    bounds(search->ligand, axis, &own_low, &own_high);
    first[axis] = low - own_high - reach;
    const double last = (high - own_low + reach - first[axis]) / step;
    if (!(last < MOST_STEPS)) return HSP_E_RANGE;
    steps[axis] = (uint32_t)last + 1;
  }
  for (uint32_t i = 0; i < steps[0]; ++i) {
    for (uint32_t j = 0; j < steps[1]; ++j) {
      for (uint32_t k = 0; k < steps[2] && status == HSP_OK; ++k) {
        const double shift[3] = {first[0] + i * step, first[1] + j * step, first[2] + k * step};
        uint32_t clashes;
        uint32_t contacts;
        status = try_place(search, shift, &clashes, &contacts);
        ++search->places;
        if (clashes) ++search->clashes;
        if (!clashes && contacts > most) {
          most = contacts;
          for (int axis = 0; axis < 3; ++axis) best[axis] = shift[axis];
        }
      }
    }
  }
  if (status != HSP_OK) return status;
  printf("%lu places, %lu of them clash, %lu queries\n", search->places, search->clashes, search->queries);
  if (most == 0) {
    printf("no contact without a clash in any of these places\n");
  } else {
    printf("best shift %g %g %g: %u contacts\n", best[0], best[1], best[2], (unsigned)most);
  }
  return status;
}

int main(int count, char **arguments) {
  struct balls receptor = {0, NULL, NULL}, ligand = {0, NULL, NULL};
  hsp_workspace work = {0};
  const double step = count == 4 ? strtod(arguments[3], NULL) : 1.0;
  if (count < 3 || count > 4 || !(step > 0 && step <= DBL_MAX)) {
    fprintf(stderr, "usage: docking RECEPTOR.xyzr LIGAND.xyzr [STEP]\n");
    return 2;
  }
  int done = read_balls(arguments[1], &receptor) && read_balls(arguments[2], &ligand);
  uint32_t *ids = malloc((receptor.count + 1) * sizeof *ids);
  done = done && ids != NULL;
  if (done) {
    int32_t status = hsp_workspace_set(&work, receptor.count, receptor.xyz, receptor.radius, NULL, NULL);
    struct search search = {work.model, &ligand, ids, receptor.count, 0, 0, 0};
    if (status == HSP_OK) status = search_grid(&search, &receptor, step);
    if (status != HSP_OK) fprintf(stderr, "docking: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  free(ids);
  hsp_workspace_free(&work);
  free_balls(&receptor);
  free_balls(&ligand);
  return done ? 0 : 1;
}
