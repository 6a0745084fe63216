#include "write/ball_label.h"

#include <inttypes.h>

#include "write/csv.h"
#include "write/report.h"

/* The names of a ball, in the order of the keys and columns. */
enum { MOST_NAMES = 6 };

struct ball_name {
  const char *key;
  const char *json; /* between two values */
  size_t json_length;
  const char *text;
};
#define JSON_BEFORE(key) ", \"" key "\": "
#define NAMED(key, text) \
  { key, JSON_BEFORE(key), sizeof JSON_BEFORE(key) - 1, text }

/* List the names. The format decides which there are, not which ones a file leaves empty. Returns their number. */
static int list_names(const struct file_format *format, const struct atom_label *label,
                      struct ball_name list[MOST_NAMES]) {
  const struct residue_label *residue = label->residue;
  const bool residues = file_format_has(format, FILE_RESIDUES);
  int count = 0;
  if (residues) list[count++] = (struct ball_name)NAMED("atom", label->name);
  if (!file_format_has(format, FILE_RADII)) list[count++] = (struct ball_name)NAMED("element", label->element.text);
  if (!residues) return count;
  list[count++] = (struct ball_name)NAMED("chain", residue->chain);
  list[count++] = (struct ball_name)NAMED("residue", residue->name);
  list[count++] = (struct ball_name)NAMED("number", residue->number);
  list[count++] = (struct ball_name)NAMED("insertion", residue->insertion);
  return count;
}

void ball_label_json(const struct molecule *molecule, uint32_t ball, struct text_buffer *out) {
  const struct atom_label *label = &molecule->label[ball];
  struct ball_name names[MOST_NAMES];
  const int count = list_names(molecule->format, label, names);
  text_buffer_add_text(out, "\"ball\": ");
  text_buffer_add_count(out, ball);
  for (int i = 0; i < count; ++i) {
    text_buffer_append(out, names[i].json, names[i].json_length);
    (names[i].text == label->residue->number ? json_residue_number : json_text)(out, names[i].text);
  }
  text_buffer_add_text(out, ", \"xyz\": ");
  json_numbers(out, molecule->xyz + 3 * (size_t)ball, 3);
  text_buffer_add_text(out, ", \"radius\": ");
  json_number(out, molecule->radius[ball]);
}

static void add_keys(const struct file_format *format, struct text_buffer *out) {
  static const struct atom_label nobody = ATOM_LABEL_NONE;
  struct ball_name names[MOST_NAMES];
  const int count = list_names(format, &nobody, names);
  text_buffer_add_text(out, "ball");
  for (int i = 0; i < count; ++i) text_buffer_add(out, ", %s", names[i].key);
  text_buffer_add_text(out, ", xyz, radius");
}

void ball_label_csv_titles(const struct file_format *format, const char *suffix, struct text_buffer *out) {
  static const struct atom_label nobody = ATOM_LABEL_NONE;
  struct ball_name names[MOST_NAMES];
  const int count = list_names(format, &nobody, names);
  text_buffer_add(out, "ball%s", suffix);
  for (int i = 0; i < count; ++i) text_buffer_add(out, ",%s%s", names[i].key, suffix);
}

void ball_label_csv(const struct molecule *molecule, uint32_t ball, struct text_buffer *out) {
  struct ball_name names[MOST_NAMES];
  const int count = list_names(molecule->format, &molecule->label[ball], names);
  text_buffer_add_count(out, ball);
  for (int i = 0; i < count; ++i) {
    text_buffer_add_character(out, ',');
    csv_text(out, names[i].text);
  }
}

struct ball_rows ball_rows_of(const struct molecule *molecule, const uint32_t *balls) {
  return (struct ball_rows){molecule, ball_columns_of(molecule), balls};
}

static uint32_t ball_of(const struct ball_rows *rows, size_t row) {
  return rows->balls == NULL ? (uint32_t)row : rows->balls[row];
}

void ball_rows_lead_silent(const void *of, size_t row, enum form form, struct text_buffer *out) {
  const struct ball_rows *const rows = of;
  if (form == FOR_PERSONS && row == TABLE_TITLES) report_ball_titles(out, rows->columns);
  if (form == FOR_PERSONS && row != TABLE_TITLES) report_ball(out, rows->columns, rows->molecule, ball_of(rows, row));
}

void ball_rows_lead_index(const void *of, size_t row, enum form form, struct text_buffer *out) {
  ball_rows_lead_silent(of, row, form, out);
  if (form == AS_JSON) text_buffer_add(out, "\"ball\": %" PRIu32, ball_of(of, row));
  if (form == AS_KEYS) text_buffer_add_text(out, "ball");
}

void ball_rows_lead(const void *of, size_t row, enum form form, struct text_buffer *out) {
  const struct ball_rows *const rows = of;
  ball_rows_lead_silent(of, row, form, out);
  if (form == AS_JSON) ball_label_json(rows->molecule, ball_of(rows, row), out);
  if (form == AS_KEYS) add_keys(rows->molecule->format, out);
  if (form == AS_CSV_TITLES) ball_label_csv_titles(rows->molecule->format, "", out);
  if (form == AS_CSV) ball_label_csv(rows->molecule, ball_of(rows, row), out);
}

static bool no_cells(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  (void)of, (void)row, (void)cells, (void)text;
  return true;
}

void ball_rows_print(const struct molecule *molecule, const uint32_t *balls, uint32_t count, struct text_buffer *out) {
  const struct ball_rows rows = ball_rows_of(molecule, balls);
  const struct table table = {NULL, 0, molecule->format, count, &rows, no_cells, ball_rows_lead};
  text_buffer_add_text(out, "\n");
  table_print(&table, out);
}

void ball_labels_record(struct record *record, const char *key) {
  const struct molecule *const molecule = record->molecule;
  const struct ball_rows rows = ball_rows_of(molecule, NULL);
  const struct table table = {NULL, 0, molecule->format, molecule->atoms, &rows, no_cells, ball_rows_lead};
  if (record->form == AS_JSON) record_table(record, key, &table);
}
