#include "commands/interface.h"

#include "read/stopping.h"

#include <stdlib.h>
#include <string.h>

/* Which group of the text a chain belongs to: 0 or 1, or -1 for none. */
static int side_of(const char *text, const char *chain) {
  int side = 0;
  for (;;) {
    const size_t length = strcspn(text, "+,");
    if (chain_is_named(chain, (struct field){text, length})) return side;
    if (text[length] == '\0') return -1;
    if (text[length] == ',') ++side;
    text += length + 1;
  }
}

bool interface_parse(const char *text, struct failure *failure) {
  const size_t length = strlen(text);
  size_t commas = 0;
  bool good = length > 0;
  for (size_t i = 0; i < length; ++i) {
    const bool separates = text[i] == ',' || text[i] == '+';
    if (text[i] == ',') ++commas;
    if (separates && (i == 0 || i + 1 == length || text[i + 1] == ',' || text[i + 1] == '+')) good = false;
  }
  char shown[EXCERPT_BYTES];
  if (!good || commas != 1) {
    return failure_in_usage(failure, "--interface: '%s' is not of the form A,B or A+B,C", excerpt(shown, text, length));
  }
  /* Each chain is in one group. */
  for (const char *at = text; at != NULL; at = strpbrk(at, "+,"), at = at == NULL ? NULL : at + 1) {
    const size_t own = strcspn(at, "+,");
    for (const char *other = text; other != at; other += strcspn(other, "+,") + 1) {
      if (strcspn(other, "+,") == own && strncmp(at, other, own) == 0) {
        return failure_in_usage(failure, "--interface: chain '%s' is named twice", excerpt(shown, at, own));
      }
    }
  }
  return true;
}

/* The atoms of the groups: those of side 0 first. */
struct parts {
  double *xyz;    /* [atoms][3] */
  double *radius; /* [atoms] */
  uint32_t atoms[2];
};

static bool take_parts(const char *text, const struct molecule *molecule, struct parts *parts) {
  parts->xyz = malloc(((size_t)molecule->atoms + 1) * 3 * sizeof *parts->xyz);
  parts->radius = malloc(((size_t)molecule->atoms + 1) * sizeof *parts->radius);
  if (parts->xyz == NULL || parts->radius == NULL) return false;
  uint32_t taken = 0;
  for (int side = 0; side < 2; ++side) {
    const uint32_t first = taken;
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      if (side_of(text, molecule->label[i].residue->chain) != side) continue;
      memcpy(parts->xyz + 3 * (size_t)taken, molecule->xyz + 3 * (size_t)i, 3 * sizeof *parts->xyz);
      parts->radius[taken++] = molecule->radius[i];
    }
    parts->atoms[side] = taken - first;
  }
  return true;
}

/* The area of some atoms, and of the first `split` of them in the presence of the others. All sets are put on the
 * lattice of the whole molecule, so that the same balls are the same everywhere. */
static int32_t measure(struct geometry *geometry, const hsp_model_options *options, uint32_t atoms, const double *xyz,
                       const double *radius, uint32_t split, double *area, double part[2]) {
  hsp_workspace *work = &geometry->work;
  hsp_totals totals;
  double *areas = malloc(((size_t)atoms + 1) * sizeof *areas);
  work->executor = stopping_executor();
  int32_t status = areas == NULL ? HSP_E_MEMORY : hsp_workspace_set(work, atoms, xyz, radius, options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(work);
  if (status == HSP_OK) status = hsp_boundary_measure(work->boundary, NULL, &totals, areas, NULL, atoms, NULL);
  if (status == HSP_OK) {
    *area = totals.area;
    part[0] = part[1] = 0.0;
    for (uint32_t i = 0; i < atoms; ++i) part[i < split ? 0 : 1] += areas[i];
  }
  free(areas);
  return status;
}

bool interface_measure(const char *text, const struct molecule *molecule, double probe, struct geometry *geometry,
                       struct interface *interface, struct failure *failure) {
  struct parts parts = {NULL, NULL, {0, 0}};
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, (uint32_t)sizeof options);
  options.probe = probe;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (molecule->radius[i] > options.largest_radius) options.largest_radius = molecule->radius[i];
  }
  bool done = take_parts(text, molecule, &parts) || failure_of_memory(failure);
  for (int side = 0; done && side < 2; ++side) {
    if (parts.atoms[side] == 0) {
      done = failure_in_input(failure, 0, "--interface: there are no atoms in the %s group of chains",
                              side == 0 ? "first" : "second");
    }
  }
  if (done) {
    progress_show(&geometry->progress, "measuring the interface");
    double part[2] = {0.0, 0.0};
    for (int side = 0; side < 2 && status == HSP_OK; ++side) {
      const size_t first = side == 0 ? 0 : parts.atoms[0];
      status = measure(geometry, &options, parts.atoms[side], parts.xyz + 3 * first, parts.radius + first, 0,
                       &interface->side[side].alone, part);
      interface->side[side].atoms = parts.atoms[side];
    }
    if (status == HSP_OK) {
      status = measure(geometry, &options, parts.atoms[0] + parts.atoms[1], parts.xyz, parts.radius, parts.atoms[0],
                       &interface->together, part);
    }
    if (status != HSP_OK) done = failure_in_library(failure, status);
    interface->side[0].together = part[0];
    interface->side[1].together = part[1];
    interface->buried = interface->side[0].alone + interface->side[1].alone - interface->together;
  }
  free(parts.xyz);
  free(parts.radius);
  return done;
}
