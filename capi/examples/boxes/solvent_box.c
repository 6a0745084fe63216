/* A solvent box: a molecule in a periodic box is surrounded by waters, and what they make of the box is measured.
 *   solvent_box FILE.xyzr AX BY CZ      x y z r on each line
 * Waters are balls of radius 1.4 on a grid of the box, wherever none of them meets the molecule or an image of it. The
 * molecule may lie anywhere, and across faces of the box. */
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../read_balls.h"

static const double water = 1.4, spacing = 2.9;
static const double first_shell = 0.5; /* balls at most twice that apart are neighbours */

struct box {
  double vector[9];
  hsp_workspace work;
};

/* Computes the balls, each larger by the probe. */
static int32_t compute(struct box *box, const struct balls *balls, double probe) {
  hsp_model_options options;
  const int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status != HSP_OK) return status;
  return hsp_workspace_periodic(&box->work, balls->count, balls->xyz, balls->radius, box->vector, &options, NULL);
}

/* Adds waters at the points of a grid that are in no ball of the box: the molecule's, larger by a water's radius. */
static int32_t add_waters(const struct box *box, struct balls *balls) {
  int many[3];
  for (int axis = 0; axis < 3; ++axis) many[axis] = (int)(box->vector[4 * axis] / spacing);
  for (int k = 0; k < many[0] * many[1] * many[2]; ++k) {
    const int at[3] = {k % many[0], k / many[0] % many[1], k / many[0] / many[1]};
    double ball[4] = {0.0, 0.0, 0.0, water};
    for (int axis = 0; axis < 3; ++axis) ball[axis] = (at[axis] + 0.5) * box->vector[4 * axis] / many[axis];
    uint32_t hits = 0;
    const int32_t status = hsp_periodic_query_point(box->work.periodic, ball, NULL, 0, &hits);
    if (status != HSP_OK && status != HSP_E_CAPACITY) return status;
    if (hits == 0 && !add_ball(balls, ball)) return HSP_E_MEMORY;
  }
  return HSP_OK;
}

static int32_t print_volumes(const struct box *box, const char *what) {
  hsp_periodic_totals totals;
  const int32_t status = hsp_periodic_measure(box->work.periodic, &totals, NULL, NULL, 0, NULL);
  if (status == HSP_OK) {
    printf("%s: volume %.6f, area %.6f, free %.6f of %.6f\n", what, totals.volume, totals.area, totals.free_volume,
           totals.box_volume);
  }
  return status;
}

/* Waters beside the first `solute` balls, across faces of the box too. mark [balls] is all zeros. */
static int32_t count_first_shell(const struct box *box, uint32_t solute, unsigned char *mark, unsigned *waters) {
  hsp_image *image = NULL;
  uint32_t room = 0;
  int32_t status = HSP_OK;
  for (uint32_t i = 0; i < solute && status == HSP_OK;) {
    uint32_t needed = 0;
    status = hsp_periodic_query_neighbours(box->work.periodic, i, image, room, &needed);
    if (status == HSP_E_CAPACITY) {
      hsp_image *more = realloc(image, needed * sizeof *image);
      status = more != NULL ? HSP_OK : HSP_E_MEMORY;
      if (more == NULL) break;
      image = more;
      room = needed;
      continue;
    }
    for (uint32_t k = 0; k < needed && status == HSP_OK; ++k) {
      if (image[k].ball < solute || mark[image[k].ball]) continue;
      mark[image[k].ball] = 1;
      ++*waters;
    }
    ++i;
  }
  free(image);
  return status;
}

/* Into how many directions something goes on for ever, at most. */
static int32_t print_windings(const struct box *box) {
  hsp_periodic_counts counts;
  uint32_t needed = 0, most = 0, largest = 0;
  int32_t status = hsp_periodic_get_counts(box->work.periodic, &counts);
  if (status != HSP_OK) return status;
  hsp_winding *winding = malloc(((size_t)counts.components + 1) * sizeof *winding);
  if (winding == NULL) return HSP_E_MEMORY;
  status = hsp_periodic_get_windings(box->work.periodic, winding, counts.components, &needed);
  for (uint32_t c = 0; c < counts.components && status == HSP_OK; ++c) {
    if (winding[c].directions > most) most = winding[c].directions;
    if (winding[c].balls > largest) largest = winding[c].balls;
  }
  free(winding);
  if (status == HSP_OK) {
    printf("%u components, the largest of %u balls, endless in %u directions at most\n", (unsigned)counts.components,
           (unsigned)largest, (unsigned)most);
  }
  return status;
}

static int32_t run(struct box *box, struct balls *balls) {
  const uint32_t solute = balls->count;
  int32_t status = compute(box, balls, 0.0);
  if (status == HSP_OK) status = print_volumes(box, "molecule");
  if (status == HSP_OK) status = compute(box, balls, water);
  if (status == HSP_OK) status = add_waters(box, balls);
  if (status == HSP_OK) status = compute(box, balls, 0.0);
  if (status != HSP_OK) return status;
  printf("%u waters\n", (unsigned)(balls->count - solute));
  status = print_volumes(box, "with waters");
  if (status == HSP_OK) status = compute(box, balls, first_shell);
  if (status != HSP_OK) return status;
  unsigned waters = 0;
  unsigned char *mark = calloc((size_t)balls->count + 1, 1);
  status = mark != NULL ? count_first_shell(box, solute, mark, &waters) : HSP_E_MEMORY;
  free(mark);
  if (status != HSP_OK) return status;
  printf("%u waters no more than %g from the molecule\n", waters, 2 * first_shell);
  return print_windings(box);
}

int main(int count, char **arguments) {
  struct balls balls = {0, NULL, NULL};
  struct box box;
  memset(&box, 0, sizeof box);
  int good = count == 5;
  for (int axis = 0; axis < 3 && good; ++axis) {
    box.vector[4 * axis] = strtod(arguments[2 + axis], NULL);
    good = box.vector[4 * axis] >= spacing && box.vector[4 * axis] <= 1000 * spacing;
  }
  if (!good) {
    fprintf(stderr, "usage: solvent_box FILE.xyzr AX BY CZ      lengths from %g to %g\n", spacing, 1000 * spacing);
    return 2;
  }
  int done = read_balls(arguments[1], &balls);
  if (done) {
    const int32_t status = run(&box, &balls);
    if (status != HSP_OK) fprintf(stderr, "solvent_box: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  hsp_workspace_free(&box.work);
  free_balls(&balls);
  return done ? 0 : 1;
}
