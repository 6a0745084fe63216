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

/* The subject of a row. */
struct listed {
  const struct molecule *molecule;
  const struct atom_groups *groups;
};

/* Insertion codes stand behind numbers, which stand under each other. */
static bool residue_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct listed *listed = of;
  const struct atom_group *group = &listed->groups->group[row];
  const struct residue_label *label = label_of(listed->molecule, group);
  const size_t length = strlen(label->number), blanks = length < 6 ? 6 - length : 0;
  memset(text, ' ', blanks);
  memcpy(text + blanks, label->number, length);
  memcpy(text + blanks + length, label->insertion[0] == '\0' ? " " : label->insertion, 2);
  cells[0].text = label->chain;
  cells[1].text = label->name;
  cells[2].text = label->number;
  cells[3].text = label->insertion;
  cells[4].text = text;
  cells[5].count = group->atoms;
  cells[6].quantity = group->area;
  cells[7].quantity = relative_area(listed->molecule, group);
  return true;
}

static bool chain_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct listed *listed = of;
  const struct atom_group *group = &listed->groups->group[row];
  (void)text;
  cells[0].text = label_of(listed->molecule, group)->chain;
  cells[1].count = group->atoms;
  cells[2].quantity = group->area;
  return true;
}

static struct table table_of(const struct listed *listed, bool relative) {
  static const struct column residue_columns[] = {
      {"chain", NULL, "chain", -5, COLUMN_TEXT, 0},
      {"name", "residue", "residue", -7, COLUMN_TEXT, 0},
      {"number", NULL, NULL, 0, COLUMN_RESIDUE_NUMBER, 0},
      {"insertion", NULL, NULL, 0, COLUMN_TEXT, 0},
      {NULL, NULL, "number", 7, COLUMN_TEXT, 0},
      {"atoms", NULL, "atoms", 9, COLUMN_COUNT, 0},
      {"area", NULL, "free area", 16, COLUMN_QUANTITY, 4},
      {"relative", NULL, "relative", 8, COLUMN_QUANTITY, 3}, /* the last one, if it is asked for */
  };
  static const struct column chain_columns[] = {
      {"chain", NULL, "chain", -5, COLUMN_TEXT, 0},
      {"atoms", NULL, "atoms", 9, COLUMN_COUNT, 0},
      {"area", NULL, "free area", 16, COLUMN_QUANTITY, 4},
  };
  const bool residues = listed->groups->grouping == GROUPING_RESIDUE;
  return (struct table){residues ? residue_columns : chain_columns,
                        !residues  ? 3
                        : relative ? 8
                                   : 7,
                        listed->molecule->format,
                        listed->groups->count,
                        listed,
                        residues ? residue_row : chain_row,
                        NULL};
}

void group_table_record(struct record *record, const struct atom_groups *groups, bool relative) {
  const bool residues = groups->grouping == GROUPING_RESIDUE;
  const struct listed listed = {record->molecule, groups};
  const struct table table = table_of(&listed, relative);
  record_line(record, "");
  record_count(record, NULL, residues ? "residues" : "chains", groups->count, "");
  record_table(record, residues ? "residues" : "chains", &table);
  if (!relative) return;
  record_line(record, "");
  if (record->form == FOR_PERSONS) text_buffer_add(record->out, "  relative to the %s\n", relative_areas_source);
}

void group_table_csv(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                     struct text_buffer *out) {
  const struct listed listed = {molecule, groups};
  const struct table table = table_of(&listed, relative);
  table_csv(&table, out);
}
