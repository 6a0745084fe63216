#include "commands/group_matrix.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The subject of the table. */
struct matrix {
  const struct found_groups *groups;
  bool diagonal;
  double (*value)(const void *of, uint32_t row, uint32_t column);
  const void *of;
};

static bool matrix_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct matrix *const matrix = of;
  const uint32_t own = (uint32_t)row;
  (void)text;
  cells[0].text = matrix->groups->group[row].name;
  for (uint32_t k = 0; k < matrix->groups->count; ++k) {
    const bool shown = k != own || matrix->diagonal;
    cells[1 + k].quantity = !shown ? (double)NAN : matrix->value(matrix->of, k < own ? k : own, k < own ? own : k);
  }
  return true;
}

int group_names_width(const struct found_groups *groups) {
  int width = 14;
  for (uint32_t g = 0; g < groups->count; ++g) {
    const int length = (int)strlen(groups->group[g].name);
    width = length > width ? length : width;
  }
  return -width;
}

void group_matrix_record(struct record *record, const struct found_groups *groups, bool diagonal,
                         double value(const void *of, uint32_t row, uint32_t column), const void *of) {
  struct column columns[1 + MOST_GROUPS_OF_MATRIX];
  char titles[MOST_GROUPS_OF_MATRIX][CELL_BYTES];
  const struct matrix matrix = {groups, diagonal, value, of};
  if (record->form != FOR_PERSONS || groups->count > MOST_GROUPS_OF_MATRIX) return;
  columns[0] = (struct column){NULL, NULL, "", group_names_width(groups), COLUMN_TEXT, 0};
  for (uint32_t k = 0; k < groups->count; ++k) {
    snprintf(titles[k], sizeof titles[k], "%.30s", groups->group[k].name);
    for (char *at = strchr(titles[k], '@'); at != NULL; at = strchr(at, '@')) *at = '?'; /* it is no unit here */
    const int length = (int)strlen(titles[k]);
    columns[1 + k] = (struct column){NULL, NULL, titles[k], length < 14 ? 14 : length, COLUMN_QUANTITY, 4};
  }
  const struct table table = {
      columns, 1 + (int)groups->count, record->molecule->format, groups->count, &matrix, matrix_row, NULL};
  record_table(record, NULL, &table);
}

void group_notes_record(struct record *record, const struct found_groups *groups) {
  if (record->form != FOR_PERSONS) return;
  for (uint32_t g = 0; g < groups->count; ++g) {
    const struct found_group *const group = &groups->group[g];
    if (group->others == 0) continue;
    text_buffer_add(record->out, "  of %s %" PRIu32 " more %s of a group before it\n", group->name, group->others,
                    group->others == 1 ? "atom is" : "atoms are");
  }
}
