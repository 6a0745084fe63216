#include "commands/interface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands/group_matrix.h"
#include "read/stopping.h"

static const char option[] = "--interface";

/* The atoms of some groups, in the order of the file. */
struct parts {
  double *xyz;    /* [atoms][3] */
  double *radius; /* [atoms] */
  uint8_t *side;  /* [atoms], 1 of the second group */
  double *area;   /* [atoms] */
  uint32_t atoms;
};

static void take_groups(const struct molecule *molecule, const struct found_groups *groups, uint32_t first,
                        uint32_t second, struct parts *parts) {
  parts->atoms = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (groups->of[i] != first && groups->of[i] != second) continue;
    memcpy(parts->xyz + 3 * (size_t)parts->atoms, molecule->xyz + 3 * (size_t)i, 3 * sizeof *parts->xyz);
    parts->side[parts->atoms] = groups->of[i] == first ? 0 : 1;
    parts->radius[parts->atoms++] = molecule->radius[i];
  }
}

/* The area of the atoms, and of each group in the presence of the other. All sets are put on the lattice of the whole
 * molecule, so that the same balls are the same everywhere. */
static int32_t measure(struct geometry *geometry, const hsp_model_options *options, const struct parts *parts,
                       double *area, double together[2]) {
  hsp_workspace *work = &geometry->work;
  hsp_totals totals;
  const uint32_t atoms = parts->atoms;
  work->executor = stopping_executor();
  int32_t status = hsp_workspace_set(work, atoms, parts->xyz, parts->radius, options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(work);
  if (status == HSP_OK) status = hsp_boundary_measure(work->boundary, NULL, &totals, parts->area, NULL, atoms, NULL);
  if (status == HSP_OK) {
    *area = totals.area;
    together[0] = together[1] = 0.0;
    for (uint32_t i = 0; i < atoms; ++i) together[parts->side[i]] += parts->area[i];
  }
  return status;
}

/* Boxes around the groups, grown by radii and probe: [groups][2][3]. */
static double *bounds_of(const struct molecule *molecule, double probe, const struct found_groups *groups) {
  double *const bounds = malloc(6 * (size_t)groups->count * sizeof *bounds);
  for (size_t k = 0; bounds != NULL && k < 6 * (size_t)groups->count; ++k) bounds[k] = k % 6 < 3 ? HUGE_VAL : -HUGE_VAL;
  for (uint32_t i = 0; bounds != NULL && i < molecule->atoms; ++i) {
    if (groups->of[i] == HSP_NONE) continue;
    double *const own = bounds + 6 * (size_t)groups->of[i];
    const double *const xyz = molecule->xyz + 3 * (size_t)i;
    const double reach = molecule->radius[i] + probe;
    for (int axis = 0; axis < 3; ++axis) {
      own[axis] = fmin(own[axis], xyz[axis] - reach);
      own[3 + axis] = fmax(own[3 + axis], xyz[axis] + reach);
    }
  }
  return bounds;
}

/* Whether some ball of one group may meet one of the other; coordinates are rounded by less than the margin. */
static bool may_meet(const double *bounds, const uint32_t group[2], double margin) {
  const double *const a = bounds + 6 * (size_t)group[0], *const b = bounds + 6 * (size_t)group[1];
  for (int axis = 0; axis < 3; ++axis) {
    if (a[axis] > b[3 + axis] + margin || b[axis] > a[3 + axis] + margin) return false;
  }
  return true;
}

static bool allocate(const struct molecule *molecule, struct interface *interface, struct parts *parts,
                     struct failure *failure) {
  const size_t groups = interface->groups.count;
  parts->xyz = malloc(((size_t)molecule->atoms + 1) * 3 * sizeof *parts->xyz);
  parts->radius = malloc(((size_t)molecule->atoms + 1) * sizeof *parts->radius);
  parts->side = malloc((size_t)molecule->atoms + 1);
  parts->area = malloc(((size_t)molecule->atoms + 1) * sizeof *parts->area);
  interface->alone = malloc(groups * sizeof *interface->alone);
  interface->pair = malloc(groups * (groups - 1) / 2 * sizeof *interface->pair);
  return (parts->xyz != NULL && parts->radius != NULL && parts->side != NULL && parts->area != NULL &&
          interface->alone != NULL && interface->pair != NULL) ||
         failure_of_memory(failure);
}

/* Each group alone, and two and two. Of more than two groups those that are too far from each other to meet bury
 * nothing, and are not measured. */
static int32_t measure_all(const struct molecule *molecule, double probe, struct geometry *geometry,
                           const double *bounds, struct parts *parts, struct interface *interface) {
  const struct found_groups *const groups = &interface->groups;
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, (uint32_t)sizeof options);
  double none[2];
  options.probe = probe;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (molecule->radius[i] > options.largest_radius) options.largest_radius = molecule->radius[i];
  }
  const double margin = 1e-6 * (options.largest_radius + probe);
  for (uint32_t g = 0; g < groups->count && status == HSP_OK; ++g) {
    take_groups(molecule, groups, g, g, parts);
    status = measure(geometry, &options, parts, &interface->alone[g], none);
  }
  for (uint32_t first = 0; first < groups->count; ++first) {
    for (uint32_t second = first + 1; second < groups->count && status == HSP_OK; ++second) {
      struct interface_pair *const pair = &interface->pair[interface->pairs++];
      *pair = (struct interface_pair){{first, second}, {interface->alone[first], interface->alone[second]}, 0.0, 0.0};
      const double apart = pair->together[0] + pair->together[1];
      pair->both = apart;
      if (groups->count == 2 || may_meet(bounds, pair->group, margin)) {
        take_groups(molecule, groups, first, second, parts);
        status = measure(geometry, &options, parts, &pair->both, pair->together);
      }
      pair->buried = apart - pair->both;
    }
  }
  return status;
}

bool interface_measure(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                       struct interface *interface, struct failure *failure) {
  struct parts parts = {.atoms = 0};
  memset(interface, 0, sizeof *interface);
  if (!selection_groups_find(&request->measure.interface, option, molecule, &interface->groups, failure)) return false;
  double *const bounds = bounds_of(molecule, request->probe, &interface->groups);
  bool done = allocate(molecule, interface, &parts, failure) && (bounds != NULL || failure_of_memory(failure));
  if (done) {
    progress_show(&geometry->progress, "measuring the interface");
    const int32_t status = measure_all(molecule, request->probe, geometry, bounds, &parts, interface);
    done = status == HSP_OK || failure_in_library(failure, status);
  }
  free(bounds);
  free(parts.xyz);
  free(parts.radius);
  free(parts.side);
  free(parts.area);
  return done;
}

void interface_free(struct interface *interface) {
  found_groups_free(&interface->groups);
  free(interface->alone);
  free(interface->pair);
  memset(interface, 0, sizeof *interface);
}

/* ---- two groups: one by one, and for persons both ---- */

static bool side_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  static const char *const names[] = {"first", "second", "both"};
  const struct interface *const interface = of;
  const struct found_group *const group = interface->groups.group;
  const bool both = row == 2;
  (void)text;
  cells[0].text = names[row];
  cells[1].count = both ? group[0].atoms + group[1].atoms : group[row].atoms;
  cells[2].quantity = both ? interface->alone[0] + interface->alone[1] : interface->alone[row];
  cells[3].quantity = both ? interface->pair->both : interface->pair->together[row];
  cells[4].quantity = cells[2].quantity - cells[3].quantity;
  return true;
}

static void record_two(struct record *record, const struct selection_groups *groups,
                       const struct interface *interface) {
  static const struct column columns[] = {
      {NULL, NULL, "group", -8, COLUMN_TEXT, 0},        {"atoms", NULL, "atoms", 9, COLUMN_COUNT, 0},
      {"alone", NULL, "alone", 16, COLUMN_QUANTITY, 4}, {"together", NULL, "together", 16, COLUMN_QUANTITY, 4},
      {NULL, NULL, "buried", 16, COLUMN_QUANTITY, 4},
  };
  static double nothing[2];
  static struct interface_pair no_pair;
  const bool json = record->form == AS_JSON;
  struct interface none = {.alone = nothing, .pair = &no_pair};
  if (interface->pairs > 0) none = *interface; /* else help asks for the keys */
  const struct table sides = {columns, 5, record->molecule->format, json ? 2 : 3, &none, side_row, NULL};
  if (json && !record_key(record, "interface")) return;
  if (record->form == FOR_PERSONS) text_buffer_add(record->out, "\ninterface of %s", groups->text);
  record_line(record, ": areas in @^2, of each group alone and of both without anything else");
  struct record own = {.form = AS_JSON, .out = record->out}, *const to = json ? &own : record;
  if (json) text_buffer_add_text(record->out, "{");
  record_table(to, "groups", &sides);
  if (!json) record_number(record, "first_alone", NULL, none.alone[0], 0, "");
  if (!json) record_number(record, "second_alone", NULL, none.alone[1], 0, "");
  record_number(to, "together", NULL, none.pair->both, 0, "");
  record_number(to, "buried", NULL, none.pair->buried, 0, "");
  if (json) text_buffer_add_text(record->out, "}");
  group_notes_record(record, &interface->groups);
}

/* ---- more of them ---- */

static bool group_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct interface *const interface = of;
  (void)text;
  cells[0].text = interface->groups.group[row].name;
  cells[1].count = interface->groups.group[row].atoms;
  cells[2].quantity = interface->alone[row];
  return true;
}

static bool pair_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct interface *const interface = of;
  const struct interface_pair *const pair = &interface->pair[row];
  (void)text;
  cells[0].text = interface->groups.group[pair->group[0]].name;
  cells[1].text = interface->groups.group[pair->group[1]].name;
  cells[2].quantity = pair->together[0];
  cells[3].quantity = pair->together[1];
  cells[4].quantity = pair->both;
  cells[5].quantity = pair->buried;
  return true;
}

static double buried_of(const void *of, uint32_t first, uint32_t second) {
  const struct interface *const interface = of;
  const size_t groups = interface->groups.count, before = first;
  return interface->pair[before * (2 * groups - before - 1) / 2 + (second - first - 1)].buried;
}

static void record_many(struct record *record, const struct selection_groups *groups,
                        const struct interface *interface) {
  const int width = group_names_width(&interface->groups);
  const struct column of_groups[] = {{"group", NULL, "group", width, COLUMN_TEXT, 0},
                                     {"atoms", NULL, "atoms", 9, COLUMN_COUNT, 0},
                                     {"alone", NULL, "alone", 16, COLUMN_QUANTITY, 4}};
  const struct column of_pairs[] = {
      {"first", NULL, "first", width, COLUMN_TEXT, 0},
      {"second", NULL, "second", width, COLUMN_TEXT, 0},
      {"first_together", NULL, "first together", 16, COLUMN_QUANTITY, 4},
      {"second_together", NULL, "second together", 16, COLUMN_QUANTITY, 4},
      {"together", NULL, "both", 16, COLUMN_QUANTITY, 4},
      {"buried", NULL, "buried", 16, COLUMN_QUANTITY, 4},
  };
  const struct file_format *const format = record->molecule->format;
  const struct table sides = {of_groups, 3, format, interface->groups.count, interface, group_row, NULL};
  const struct table pairs = {of_pairs, 6, format, interface->pairs, interface, pair_row, NULL};
  const bool json = record->form == AS_JSON;
  if (json && !record_key(record, "interfaces")) return;
  if (record->form == FOR_PERSONS) text_buffer_add(record->out, "\ninterfaces of %s", groups->text);
  record_line(record, ": areas in @^2, of each group alone, and what each two bury without anything else");
  struct record own = {.form = AS_JSON, .out = record->out}, *const to = json ? &own : record;
  if (json) text_buffer_add_text(record->out, "{");
  record_table(to, "groups", &sides);
  if (json || interface->groups.count > MOST_GROUPS_OF_MATRIX) {
    record_table(to, "pairs", &pairs);
  } else {
    group_matrix_record(record, &interface->groups, false, buried_of, interface);
  }
  if (json) text_buffer_add_text(record->out, "}");
  group_notes_record(record, &interface->groups);
}

void interface_record(struct record *record, const struct selection_groups *groups, const struct interface *interface) {
  (groups->chains || groups->count > 2 ? record_many : record_two)(record, groups, interface);
}
