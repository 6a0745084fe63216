#include "commands/group_table.h"

#include <string.h>

#include "read/relative_areas.h"

static const struct residue_label *label_of(const struct molecule *molecule, const struct atom_group *group) {
  return molecule->label[group->first].residue;
}

/* NaN where there is nothing to compare with. */
static double relative_area(const struct molecule *molecule, const struct atom_group *group) {
  return group->area / largest_residue_area(label_of(molecule, group)->name);
}

/* The subject of a row, and the columns that the table has. */
struct listed {
  const struct molecule *molecule;
  const struct atom_groups *groups;
  const double *deviation; /* [groups], or NULL */
  bool relative;
  struct column columns[MOST_COLUMNS];
  struct table table;
};

/* Insertion codes stand behind numbers, which stand under each other. */
static void put_number(const struct residue_label *label, char text[CELL_BYTES]) {
  const size_t length = strlen(label->number), blanks = length < 6 ? 6 - length : 0;
  memset(text, ' ', blanks);
  memcpy(text + blanks, label->number, length);
  memcpy(text + blanks + length, label->insertion[0] == '\0' ? " " : label->insertion, 2);
}

static bool row_of(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct listed *const listed = of;
  const struct atom_group *const group = &listed->groups->group[row];
  union cell *cell = cells;
  if (listed->groups->grouping == GROUPING_GROUP) {
    (cell++)->text = group->name;
  } else {
    const struct residue_label *const label = label_of(listed->molecule, group);
    (cell++)->text = label->chain;
    if (listed->groups->grouping == GROUPING_RESIDUE) {
      put_number(label, text);
      (cell++)->text = label->name;
      (cell++)->text = label->number;
      (cell++)->text = label->insertion;
      (cell++)->text = text;
    }
  }
  (cell++)->count = group->atoms;
  (cell++)->quantity = group->area;
  if (listed->deviation != NULL) (cell++)->quantity = listed->deviation[row];
  if (listed->relative) cell->quantity = relative_area(listed->molecule, group);
  return true;
}

static void make_table(struct listed *listed) {
  static const struct column of_group[] = {{"name", "group", "group", -20, COLUMN_TEXT, 0}};
  static const struct column of_residue[] = {
      {"chain", NULL, "chain", -5, COLUMN_TEXT, 0},        {"name", "residue", "residue", -7, COLUMN_TEXT, 0},
      {"number", NULL, NULL, 0, COLUMN_RESIDUE_NUMBER, 0}, {"insertion", NULL, NULL, 0, COLUMN_TEXT, 0},
      {NULL, NULL, "number", 7, COLUMN_TEXT, 0},
  };
  static const struct column atoms = {"atoms", NULL, "atoms", 9, COLUMN_COUNT, 0},
                             area = {"area", NULL, "free area", 16, COLUMN_QUANTITY, 4},
                             deviation = {"deviation", NULL, "deviation", 12, COLUMN_QUANTITY, 4},
                             relative = {"relative", NULL, "relative", 8, COLUMN_QUANTITY, 3};
  const enum grouping grouping = listed->groups->grouping;
  const int names = grouping == GROUPING_RESIDUE ? 5 : 1;
  int count = names;
  memcpy(listed->columns, grouping == GROUPING_GROUP ? of_group : of_residue,
         (size_t)names * sizeof listed->columns[0]);
  listed->columns[count++] = atoms;
  listed->columns[count++] = area;
  if (listed->deviation != NULL) listed->columns[count++] = deviation;
  if (listed->relative) listed->columns[count++] = relative;
  listed->table =
      (struct table){listed->columns, count, listed->molecule->format, listed->groups->count, listed, row_of, NULL};
}

void group_table_record(struct record *record, const struct atom_groups *groups, const double *deviation,
                        bool relative) {
  static const char *const names[] = {
      [GROUPING_RESIDUE] = "residues", [GROUPING_CHAIN] = "chains", [GROUPING_GROUP] = "groups"};
  struct listed listed = {.molecule = record->molecule, .groups = groups, .deviation = deviation, .relative = relative};
  make_table(&listed);
  record_line(record, "");
  record_count(record, NULL, names[groups->grouping], groups->count, "");
  record_table(record, names[groups->grouping], &listed.table);
  if (!relative) return;
  record_line(record, "");
  if (record->form == FOR_PERSONS) text_buffer_add(record->out, "  relative to the %s\n", relative_areas_source);
}

void group_table_csv(const struct molecule *molecule, const struct atom_groups *groups, const double *deviation,
                     bool relative, struct text_buffer *out) {
  struct listed listed = {.molecule = molecule, .groups = groups, .deviation = deviation, .relative = relative};
  make_table(&listed);
  table_csv(&listed.table, out);
}
