/* A report of the interface of two chains: what each loses of its surface, the area in which they touch, and which
 * atoms touch most.
 *   interface FIRST.xyzr SECOND.xyzr [PROBE]      x y z r on each line
 * Buried area is that of each chain alone less that of both together. Contacts share the interface out among pairs of
 * atoms: their area is that of the surface between the two chains, seen from both sides alike. */
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <stdlib.h>

#include "read_balls.h"

enum { MOST_SHOWN = 10 };

struct report {
  double alone[2], together[2]; /* areas of each chain */
  hsp_group_contact between;    /* of the two, zeros if they do not touch */
  hsp_contact *pair;            /* [pairs] from the first chain to the second, largest area first */
  uint32_t pairs;
};

static int32_t set_boundary(hsp_workspace *work, const struct balls *balls, double probe) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK) status = hsp_workspace_set(work, balls->count, balls->xyz, balls->radius, &options, NULL);
  return status == HSP_OK ? hsp_workspace_boundary(work) : status;
}

static int larger_first(const void *p, const void *q) {
  const hsp_contact *a = p, *b = q;
  if (a->area != b->area) return a->area > b->area ? -1 : 1;
  return a->ball[0] != b->ball[0] ? (a->ball[0] < b->ball[0] ? -1 : 1) : (a->ball[1] < b->ball[1] ? -1 : 1);
}

/* Contacts of a first chain of `first` atoms with the atoms behind them. */
static int32_t find_pairs(const hsp_contacts *contacts, uint32_t first, struct report *report) {
  uint32_t all = 0;
  int32_t status = hsp_contacts_get_pairs(contacts, NULL, 0, &all);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return status;
  report->pair = malloc(((size_t)all + 1) * sizeof *report->pair);
  if (report->pair == NULL) return HSP_E_MEMORY;
  status = hsp_contacts_get_pairs(contacts, report->pair, all, &all);
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < all; ++k) {
    if (report->pair[k].ball[0] < first && report->pair[k].ball[1] >= first) {
      report->pair[report->pairs++] = report->pair[k];
    }
  }
  qsort(report->pair, report->pairs, sizeof *report->pair, larger_first);
  return HSP_OK;
}

/* chain [2]: each alone; both: one after the other. group [atoms] and area [atoms] are for this function. */
static int32_t make_report(hsp_workspace *work, const struct balls *chain, const struct balls *both, double probe,
                           uint32_t *group, double *area, struct report *report) {
  hsp_totals totals;
  int32_t status = HSP_OK;
  for (int c = 0; c < 2 && status == HSP_OK; ++c) {
    status = set_boundary(work, &chain[c], probe);
    if (status == HSP_OK) status = hsp_boundary_measure(work->boundary, NULL, &totals, NULL, NULL, 0, NULL);
    if (status == HSP_OK) report->alone[c] = totals.area;
  }
  if (status == HSP_OK) status = set_boundary(work, both, probe);
  if (status == HSP_OK) status = hsp_boundary_measure(work->boundary, NULL, NULL, area, NULL, both->count, NULL);
  if (status == HSP_OK) status = hsp_workspace_contacts(work);
  if (status != HSP_OK) return status;
  for (uint32_t i = 0; i < both->count; ++i) {
    group[i] = i < chain[0].count ? 0 : 1;
    report->together[group[i]] += area[i];
  }
  uint32_t groups = 0;
  status = hsp_contacts_group(work->contacts, group, &report->between, 1, &groups);
  return status == HSP_OK ? find_pairs(work->contacts, chain[0].count, report) : status;
}

static void print_report(const struct report *report, const struct balls *chain) {
  const double buried[2] = {report->alone[0] - report->together[0], report->alone[1] - report->together[1]};
  printf("chain   atoms         alone      together        buried\n");
  for (int c = 0; c < 2; ++c) {
    printf("%5d %7u %13.6f %13.6f %13.6f\n", c + 1, (unsigned)chain[c].count, report->alone[c], report->together[c],
           buried[c]);
  }
  printf("buried in all %.6f\n", buried[0] + buried[1]);
  printf("contact area %.6f in %u pairs of atoms, %.6f of its border on the surface\n", report->between.area,
         (unsigned)report->between.contacts, report->between.rim);
  for (uint32_t k = 0; k < report->pairs && k < MOST_SHOWN; ++k) {
    const hsp_contact *pair = &report->pair[k];
    printf("%u of the first, %u of the second: area %.6f, distance %.6f\n", (unsigned)pair->ball[0],
           (unsigned)(pair->ball[1] - chain[0].count), pair->area, pair->distance);
  }
}

int main(int count, char **arguments) {
  if (count != 3 && count != 4) {
    fprintf(stderr, "usage: interface FIRST.xyzr SECOND.xyzr [PROBE]\n");
    return 2;
  }
  struct balls chain[2] = {{0, NULL, NULL}, {0, NULL, NULL}}, both = {0, NULL, NULL};
  struct report report = {.pair = NULL};
  hsp_workspace work = {0};
  int done = read_balls(arguments[1], &chain[0]) && read_balls(arguments[2], &chain[1]);
  done = done && read_balls(arguments[1], &both) && read_balls(arguments[2], &both);
  uint32_t *group = malloc(((size_t)both.count + 1) * sizeof *group);
  double *area = malloc(((size_t)both.count + 1) * sizeof *area);
  done = done && group != NULL && area != NULL;
  if (done) {
    const double probe = count == 4 ? strtod(arguments[3], NULL) : 1.4;
    const int32_t status = make_report(&work, chain, &both, probe, group, area, &report);
    if (status != HSP_OK) fprintf(stderr, "interface: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  if (done) print_report(&report, chain);
  hsp_workspace_free(&work);
  free(report.pair);
  free(group);
  free(area);
  free_balls(&both);
  free_balls(&chain[0]);
  free_balls(&chain[1]);
  return done ? 0 : 1;
}
