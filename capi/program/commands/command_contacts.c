/* hardsphere contacts: the balls that touch and their areas of contact, those of residues or chains, and each ball's
 * share of the union. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/group_matrix.h"
#include "commands/input_report.h"
#include "commands/periodic_result.h"
#include "commands/pictures.h"
#include "write/ball_label.h"
#include "write/csv.h"
#include "write/output_file.h"

/* All that is printed. Arrays that were not asked for are NULL. */
struct findings {
  hsp_totals totals;
  struct periodic_result box; /* if there is one; then contacts are of balls and images, moved by shifts */
  hsp_contact *contacts;      /* [contact_count] */
  int32_t *shift;             /* [contact_count][3], of the second ball */
  uint32_t contact_count;
  struct atom_groups groups;
  uint32_t *group_of;         /* [atoms] */
  hsp_group_contact *between; /* [between_count], of residues or chains */
  uint32_t between_count;
  struct found_groups named;   /* if groups are named */
  hsp_group_contact *of_named; /* [named.count (named.count + 1) / 2], within each and between each two, ascending */
  double *cell, *free_area, *area; /* [atoms] */
};

static void findings_free(struct findings *found) {
  atom_groups_free(&found->groups);
  periodic_result_free(&found->box);
  free(found->contacts);
  free(found->shift);
  free(found->group_of);
  free(found->between);
  found_groups_free(&found->named);
  free(found->of_named);
  free(found->cell);
  free(found->free_area);
  free(found->area);
}

static bool find_contacts(const struct geometry *geometry, struct findings *found, struct failure *failure) {
  int32_t status = hsp_contacts_get_pairs(geometry->work.contacts, NULL, 0, &found->contact_count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  found->contacts = calloc((size_t)found->contact_count + 1, sizeof *found->contacts);
  if (found->contacts == NULL) return failure_of_memory(failure);
  status =
      hsp_contacts_get_pairs(geometry->work.contacts, found->contacts, found->contact_count, &found->contact_count);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* A ball that touches its own image has that contact on two sides. */
static bool find_cells_in_box(const struct molecule *molecule, struct findings *found, struct failure *failure) {
  const int32_t status =
      hsp_periodic_measure(found->box.periodic, NULL, found->free_area, found->cell, molecule->atoms, NULL);
  for (uint32_t k = 0; k < found->contact_count; ++k) {
    for (int side = 0; side < 2; ++side) found->area[found->contacts[k].ball[side]] += found->contacts[k].area;
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

static bool find_cells(const struct molecule *molecule, const struct geometry *geometry, struct findings *found,
                       struct failure *failure) {
  const uint32_t n = molecule->atoms;
  found->cell = calloc((size_t)n + 1, sizeof *found->cell);
  found->free_area = calloc((size_t)n + 1, sizeof *found->free_area);
  found->area = calloc((size_t)n + 1, sizeof *found->area);
  if (found->cell == NULL || found->free_area == NULL || found->area == NULL) return failure_of_memory(failure);
  if (found->box.periodic != NULL) return find_cells_in_box(molecule, found, failure);
  int32_t status = hsp_contacts_measure(geometry->work.contacts, NULL, found->cell, found->area, n, NULL);
  if (status == HSP_OK) {
    status = hsp_boundary_measure(geometry->work.boundary, NULL, NULL, found->free_area, NULL, n, NULL);
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Find contacts in a box: in the form of those of a molecule, and their shifts. */
static bool find_contacts_in_box(struct findings *found, struct failure *failure) {
  const uint32_t count = found->contact_count = found->box.counts.contacts;
  uint32_t needed = 0;
  hsp_periodic_contact *list = calloc((size_t)count + 1, sizeof *list);
  found->contacts = calloc((size_t)count + 1, sizeof *found->contacts);
  found->shift = calloc((size_t)count + 1, 3 * sizeof *found->shift);
  const bool room = list != NULL && found->contacts != NULL && found->shift != NULL;
  const int32_t status = room ? hsp_periodic_get_contacts(found->box.periodic, list, count, &needed) : HSP_E_MEMORY;
  for (uint32_t k = 0; status == HSP_OK && k < count; ++k) {
    hsp_contact *contact = &found->contacts[k];
    contact->area = list[k].area;
    contact->rim = list[k].rim;
    contact->distance = list[k].distance;
    memcpy(contact->ball, list[k].ball, sizeof contact->ball);
    memcpy(found->shift + 3 * (size_t)k, list[k].shift, sizeof list[k].shift);
  }
  free(list);
  found->totals.area = found->box.totals.contact_area;
  found->totals.volume = found->box.totals.volume;
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The number of each atom's residue or chain. */
static bool number_groups(const struct molecule *molecule, struct findings *found, struct failure *failure) {
  found->group_of = calloc((size_t)molecule->atoms + 1, sizeof *found->group_of);
  if (found->group_of == NULL) return failure_of_memory(failure);
  for (uint32_t g = 0; g < found->groups.count; ++g) {
    const struct atom_group *const group = &found->groups.group[g];
    for (uint32_t k = 0; k < group->atoms; ++k) found->group_of[found->groups.member[group->member + k]] = g;
  }
  return true;
}

/* The place of two groups among all pairs, each with itself too. */
static size_t named_place(const struct found_groups *named, uint32_t first, uint32_t second) {
  const size_t before = first;
  return before * (2 * (size_t)named->count - before + 1) / 2 + (second - first);
}

/* The contacts within and between the groups that are named, each once. */
static bool find_named(const struct request *request, const struct molecule *molecule, struct findings *found,
                       struct failure *failure) {
  struct found_groups *const named = &found->named;
  if (!selection_groups_find(&request->contacts.between, "--between", molecule, named, failure)) return false;
  const uint32_t groups = named->count;
  found->of_named = calloc(named_place(named, groups, groups) + 1, sizeof *found->of_named);
  if (found->of_named == NULL) return failure_of_memory(failure);
  for (uint32_t first = 0; first < groups; ++first) {
    for (uint32_t second = first; second < groups; ++second) {
      hsp_group_contact *const sum = &found->of_named[named_place(named, first, second)];
      sum->group[0] = first;
      sum->group[1] = second;
    }
  }
  for (uint32_t k = 0; k < found->contact_count; ++k) {
    const hsp_contact *const contact = &found->contacts[k];
    const uint32_t a = named->of[contact->ball[0]], b = named->of[contact->ball[1]];
    if (a == HSP_NONE || b == HSP_NONE) continue;
    hsp_group_contact *const sum = &found->of_named[a < b ? named_place(named, a, b) : named_place(named, b, a)];
    sum->area += contact->area;
    sum->rim += contact->rim;
    ++sum->contacts;
  }
  return true;
}

/* Into found->between, and how many there are into found->between_count. */
static int32_t between_groups(const struct geometry *geometry, struct findings *found, uint32_t capacity) {
  uint32_t *const count = &found->between_count;
  if (found->box.periodic != NULL) {
    return hsp_periodic_group_contacts(geometry->periodic, found->group_of, found->between, capacity, count);
  }
  return hsp_contacts_group(geometry->work.contacts, found->group_of, found->between, capacity, count);
}

/* Number residues or chains anew within each named group, group by group. */
static bool number_within_named(const struct molecule *molecule, struct findings *found, struct failure *failure) {
  const struct found_groups *const named = &found->named;
  if (found->of_named == NULL) return true;
  if ((uint64_t)named->count * found->groups.count >= HSP_NONE) {
    return failure_in_input(failure, 0, "--between: too many groups for --by");
  }
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    found->group_of[i] = named->of[i] == HSP_NONE ? HSP_NONE : named->of[i] * found->groups.count + found->group_of[i];
  }
  return true;
}

/* Keep only the sums between different named groups, with the numbers of whole residues or chains. */
static void keep_between_named(struct findings *found) {
  const uint32_t all = found->groups.count;
  uint32_t kept = 0;
  for (uint32_t k = 0; k < found->between_count; ++k) {
    hsp_group_contact sum = found->between[k];
    if (sum.group[0] / all == sum.group[1] / all) continue;
    for (int side = 0; side < 2; ++side) sum.group[side] %= all;
    found->between[kept++] = sum;
  }
  found->between_count = kept;
}

static bool find_groups(const struct request *request, const struct molecule *molecule, const struct geometry *geometry,
                        struct findings *found, struct failure *failure) {
  if (!atom_groups_make(molecule, request->by, &request->index, NULL, &found->groups, failure) ||
      !number_groups(molecule, found, failure) || !number_within_named(molecule, found, failure)) {
    return false;
  }
  int32_t status = between_groups(geometry, found, 0);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  found->between = calloc((size_t)found->between_count + 1, sizeof *found->between);
  if (found->between == NULL) return failure_of_memory(failure);
  status = between_groups(geometry, found, found->between_count);
  if (status == HSP_OK && found->of_named != NULL) keep_between_named(found);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* "A:THR:1" or "A", as far as the file says. */
enum { GROUP_NAME_BYTES = 2 * RESIDUE_TEXT_BYTES };
static const char *group_name(char out[GROUP_NAME_BYTES], const struct molecule *molecule,
                              const struct atom_groups *groups, uint32_t group) {
  const struct residue_label *label = molecule->label[groups->group[group].first].residue;
  if (groups->grouping == GROUPING_CHAIN) {
    snprintf(out, GROUP_NAME_BYTES, "%s", label->chain);
  } else {
    snprintf(out, GROUP_NAME_BYTES, "%s:%s:%s%s", label->chain, label->name, label->number, label->insertion);
  }
  return out;
}

/* The subject of tables. */
struct listed {
  struct ball_rows rows;
  const struct request *request;
  const struct findings *found;
};

/* The two balls of a contact. */
static void lead_pair(const void *of, size_t row, enum form form, struct text_buffer *out) {
  const struct listed *listed = of;
  const struct molecule *molecule = listed->rows.molecule;
  const bool titles = row == TABLE_TITLES;
  const uint32_t *const ball = titles ? NULL : listed->found->contacts[row].ball;
  if (form == AS_KEYS) text_buffer_add_text(out, "balls: [i, j]");
  if (form == AS_KEYS) return;
  if (form == AS_JSON) text_buffer_add_text(out, "\"balls\": ");
  if (form == AS_JSON) json_counts(out, ball, 2);
  for (int side = 0; side < 2 && form != AS_JSON; ++side) {
    if (form != FOR_PERSONS && side == 1) text_buffer_append(out, ",", 1);
    if (form == AS_CSV_TITLES) ball_label_csv_titles(molecule->format, side == 0 ? "_1" : "_2", out);
    if (form == AS_CSV) ball_label_csv(molecule, ball[side], out);
    if (form == FOR_PERSONS && titles) report_name_titles(out, listed->rows.columns, side == 0 ? "first" : "second");
    if (form == FOR_PERSONS && !titles) report_name(out, listed->rows.columns, molecule, ball[side]);
  }
}

static bool pair_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct listed *listed = of;
  const hsp_contact *contact = &listed->found->contacts[row];
  (void)text;
  cells[0].quantity = contact->area;
  const int32_t *const shift = listed->found->shift;
  int k = 3;
  cells[1].quantity = contact->rim;
  cells[2].quantity = contact->distance;
  if (shift != NULL) cells[k++].shift = shift + 3 * row;
  cells[k].quantity = contact->rim;
  return contact->area >= listed->request->contacts.least;
}

/* The two residues or chains of a sum; in CSV as --by has them in measure. */
static void lead_between(const void *of, size_t row, enum form form, struct text_buffer *out) {
  const struct listed *listed = of;
  const struct findings *found = listed->found;
  const bool residues = listed->request->by == GROUPING_RESIDUE;
  static const char *const keys[] = {"chain", "residue", "number", "insertion"};
  char name[GROUP_NAME_BYTES];
  if (form == AS_KEYS) {
    text_buffer_add_text(out, residues ? "residues: [\"A:THR:1\", \"A:THR:2\"]" : "chains: [\"A\", \"B\"]");
    return;
  }
  if (form == AS_JSON) text_buffer_add(out, "\"%s\": [", residues ? "residues" : "chains");
  for (int side = 0; side < 2; ++side) {
    if (row == TABLE_TITLES) {
      if (form == FOR_PERSONS) text_buffer_add(out, "  %14s", side == 0 ? "first" : "second");
      for (int i = 0; form == AS_CSV_TITLES && i < (residues ? 4 : 1); ++i) {
        text_buffer_add(out, "%s%s_%d", side + i == 0 ? "" : ",", keys[i], side + 1);
      }
      continue;
    }
    const uint32_t group = found->between[row].group[side];
    const struct residue_label *label = listed->rows.molecule->label[found->groups.group[group].first].residue;
    const char *const texts[] = {label->chain, label->name, label->number, label->insertion};
    group_name(name, listed->rows.molecule, &found->groups, group);
    if (form == FOR_PERSONS) text_buffer_add(out, "  %14s", name);
    if (form == AS_JSON && side == 1) text_buffer_add(out, ", ");
    if (form == AS_JSON) json_text(out, name);
    for (int i = 0; form == AS_CSV && i < (residues ? 4 : 1); ++i) {
      text_buffer_add(out, side + i == 0 ? "" : ",");
      csv_text(out, texts[i]);
    }
  }
  if (form == AS_JSON) text_buffer_add(out, "]");
}

/* Two groups that are named. */
static void lead_named(const void *of, size_t row, enum form form, struct text_buffer *out) {
  const struct found_groups *const named = &((const struct listed *)of)->found->named;
  const int width = -group_names_width(named);
  if (form == AS_KEYS) text_buffer_add_text(out, "groups: [\"A\", \"B\"]");
  if (form == AS_JSON) text_buffer_add_text(out, "\"groups\": [");
  for (int side = 0; side < 2 && form != AS_KEYS; ++side) {
    const char *name = side == 0 ? "first" : "second";
    if (row != TABLE_TITLES) name = named->group[((const struct listed *)of)->found->of_named[row].group[side]].name;
    if (form == FOR_PERSONS) text_buffer_add(out, "  %-*s", width, name);
    if (form == AS_CSV_TITLES) text_buffer_add(out, "%sgroup_%d", side == 0 ? "" : ",", side + 1);
    if (side == 1 && form != FOR_PERSONS && form != AS_CSV_TITLES) text_buffer_add(out, form == AS_JSON ? ", " : ",");
    if (form == AS_JSON) json_text(out, name);
    if (form == AS_CSV) csv_text(out, name);
  }
  if (form == AS_JSON) text_buffer_add_text(out, "]");
}

static bool sum_row(const struct listed *listed, const hsp_group_contact *sum, union cell cells[MOST_COLUMNS]) {
  cells[0].quantity = sum->area;
  cells[1].quantity = sum->rim;
  cells[2].count = sum->contacts;
  cells[3].quantity = sum->rim;
  return sum->area >= listed->request->contacts.least;
}

static bool between_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct listed *listed = of;
  (void)text;
  return sum_row(listed, &listed->found->between[row], cells);
}

static bool named_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct listed *listed = of;
  (void)text;
  return sum_row(listed, &listed->found->of_named[row], cells);
}

static double named_area(const void *of, uint32_t first, uint32_t second) {
  const struct findings *const found = of;
  return found->of_named[named_place(&found->named, first, second)].area;
}

static bool cell_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct findings *found = ((const struct listed *)of)->found;
  (void)text;
  cells[0].quantity = found->cell[row];
  cells[1].quantity = found->free_area[row];
  cells[2].quantity = found->area[row];
  return true;
}

static const struct column between_columns[] = {
    {"area", NULL, "area, @^2", 16, COLUMN_QUANTITY, 4},
    {"rim", NULL, "rim, @", 16, COLUMN_QUANTITY, 4},
    {"atom_pairs", NULL, "atom pairs", 14, COLUMN_COUNT, 0},
    {"edge", NULL, NULL, 0, COLUMN_QUANTITY, 0},
};

static struct table table_of_named(const struct listed *listed) {
  const struct found_groups *const named = &listed->found->named;
  const size_t rows = named_place(named, named->count, named->count);
  return (struct table){between_columns, 4, listed->rows.molecule->format, rows, listed, named_row, lead_named};
}

/* The table that is listed: pairs of balls, of residues, of chains or of groups that are named. Rims were called edges
 * once, and programs find them by either name. */
static struct table table_of_pairs(const struct listed *listed) {
  static const struct column columns[] = {
      {"area", NULL, "area, @^2", 16, COLUMN_QUANTITY, 4},
      {"rim", NULL, "rim, @", 16, COLUMN_QUANTITY, 4},
      {"distance", NULL, "distance, @", 18, COLUMN_QUANTITY, 4},
      {"edge", NULL, NULL, 0, COLUMN_QUANTITY, 0},
  };
  static const struct column columns_in_box[] = {
      {"area", NULL, "area, @^2", 16, COLUMN_QUANTITY, 4},
      {"rim", NULL, "rim, @", 16, COLUMN_QUANTITY, 4},
      {"distance", NULL, "distance, @", 18, COLUMN_QUANTITY, 4},
      {"shift", NULL, "shift of second", 14, COLUMN_SHIFT, 0},
      {"edge", NULL, NULL, 0, COLUMN_QUANTITY, 0},
  };
  const struct findings *found = listed->found;
  const struct file_format *format = listed->rows.molecule->format;
  if (listed->request->by != GROUPING_NONE) {
    return (struct table){between_columns, 4, format, found->between_count, listed, between_row, lead_between};
  }
  if (listed->request->contacts.between.text != NULL) return table_of_named(listed);
  const bool boxed = found->shift != NULL;
  return (struct table){
      boxed ? columns_in_box : columns, boxed ? 5 : 4, format, found->contact_count, listed, pair_row, lead_pair};
}

static struct table table_of_cells(const struct listed *listed) {
  static const struct column columns[] = {
      {"volume", NULL, "share, @^3", 16, COLUMN_QUANTITY, 4},
      {"area", NULL, "free area, @^2", 21, COLUMN_QUANTITY, 4},
      {"contact", NULL, "contact area, @^2", 24, COLUMN_QUANTITY, 4},
  };
  return (struct table){columns, 3,        listed->rows.molecule->format, listed->rows.molecule->atoms,
                        listed,  cell_row, ball_rows_lead_silent};
}

/* Write the groups, and for persons the contacts between them: as a matrix of areas if there are more than two groups
 * and a line has room for it. */
static void print_named(struct record *record, const struct listed *listed) {
  const struct findings *const found = listed->found;
  const struct table table = table_of_named(listed);
  const uint32_t groups = found->named.count;
  const bool residues = listed->request->by != GROUPING_NONE;
  if (record->form == FOR_PERSONS && groups > 2 && groups <= MOST_GROUPS_OF_MATRIX) {
    record_line(record, "\n  contact area within and between groups, in @^2");
    group_matrix_record(record, &found->named, true, named_area, found);
  } else if (record->form == FOR_PERSONS) {
    record_table(record, NULL, &table);
  } else if (residues) {
    record_table(record, "between", &table);
  }
  group_notes_record(record, &found->named);
}

static void print(struct record *record, const void *of) {
  const struct listed *const listed = of;
  const struct findings *const found = listed->found;
  const struct request *const request = listed->request;
  const struct periodic_result *const box = found->box.periodic == NULL ? NULL : &found->box;
  const struct table pairs = table_of_pairs(listed), cells = table_of_cells(listed);
  const bool json = record->form == AS_JSON;
  record_atoms(record);
  record_count(record, "contacts", "contacts", found->contact_count, "pairs of balls whose shares of the union meet");
  record->width = 0;
  record_number(record, "area", "area", found->totals.area, 10, "@^2, of all contacts, each once");
  record_number(record, json ? NULL : "volume", "volume", found->totals.volume, 10, "@^3, of all shares");
  if (box != NULL && !json) periodic_result_record(record, box);
  if (request->contacts.between.text != NULL) print_named(record, listed);
  const bool matrix_alone = request->contacts.between.text != NULL && request->by == GROUPING_NONE;
  if (json || (found->contact_count > 0 && !matrix_alone)) record_table(record, "pairs", &pairs);
  if (request->contacts.cells) record_table(record, "cells", &cells);
  if ((request->by == GROUPING_NONE && !matrix_alone) || request->contacts.cells) ball_labels_record(record, "balls");
  if (box != NULL && json) periodic_result_record(record, box);
}

/* Writes the listed contacts as a picture. */
static bool write_map(const struct request *request, const struct molecule *molecule, const struct findings *found,
                      struct failure *failure) {
  const bool grouped = request->by != GROUPING_NONE;
  const uint32_t pairs = grouped ? found->between_count : found->contact_count;
  struct contact_square *squares = calloc((size_t)pairs + 1, sizeof *squares);
  if (squares == NULL) return failure_of_memory(failure);
  struct contact_map map = {molecule, &found->groups,        grouped ? found->groups.count : molecule->atoms, squares,
                            0,        request->contacts.dark};
  for (uint32_t k = 0; k < pairs; ++k) {
    const uint32_t *const pair = grouped ? found->between[k].group : found->contacts[k].ball;
    const double area = grouped ? found->between[k].area : found->contacts[k].area;
    if (area > 0.0 && area >= request->contacts.least)
      squares[map.count++] = (struct contact_square){pair[0], pair[1], area};
  }
  const bool done = pictures.contacts(&map, request->contacts.map, failure);
  free(squares);
  return done;
}

static bool find_all(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct findings *found, struct failure *failure) {
  if (request->box.source != BOX_NONE) {
    return periodic_result_make(request, molecule, NULL, geometry, &found->box, failure) &&
           find_contacts_in_box(found, failure);
  }
  if (!geometry_compute_contacts(geometry, failure) || !find_contacts(geometry, found, failure)) return false;
  const int32_t status = hsp_contacts_measure(geometry->work.contacts, &found->totals, NULL, NULL, 0, NULL);
  return status == HSP_OK || failure_in_library(failure, status);
}

void describe_contacts(const struct request *request, struct record *record) {
  static const struct findings none;
  const struct listed listed = {ball_rows_of(record->molecule, NULL), request, &none};
  print(record, &listed);
}

bool command_contacts(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure) {
  struct findings found;
  memset(&found, 0, sizeof found);
  bool done = find_all(request, molecule, geometry, &found, failure);
  if (done && request->contacts.between.text != NULL) done = find_named(request, molecule, &found, failure);
  if (done && request->by != GROUPING_NONE) done = find_groups(request, molecule, geometry, &found, failure);
  if (done && request->contacts.cells) done = find_cells(molecule, geometry, &found, failure);
  if (done && request->contacts.map != NULL) done = write_map(request, molecule, &found, failure);
  if (request_prints_file(request)) {
    findings_free(&found);
    return done;
  }
  const struct listed listed = {ball_rows_of(molecule, NULL), request, &found};
  const struct table pairs = table_of_pairs(&listed);
  if (done && request->csv && molecule->frame.number == 0) {
    table_csv(&pairs, out);
  } else if (done) {
    report(request, molecule, print, &listed, out);
  }
  findings_free(&found);
  return done;
}
