#include "write/record.h"

#include <string.h>

#include "write/csv.h"
#include "write/report.h"

static void add_with_unit(struct record *record, const char *text) {
  for (; *text != '\0'; ++text) {
    if (*text == '@') text_buffer_add_text(record->out, record->molecule->format->unit);
    if (*text != '@') text_buffer_append(record->out, text, 1);
  }
}

/* The width of a column for persons. */
static int column_width(const char *key) {
  const int length = (int)strlen(key);
  return length > VALUE_WIDTH ? length : VALUE_WIDTH;
}

/* Writes a text in a column for persons. False: there are none. */
static bool add_aligned(const struct record *record, const char *key, const char *text) {
  if (record->aligned) text_buffer_add(record->out, "  %*s", column_width(key), text);
  return record->aligned;
}

/* Writes the text before a value. False: the value is not to follow. */
static bool begin(struct record *record, const char *key) {
  if (key == NULL || record->form == FOR_PERSONS) return false;
  const bool json = record->form == AS_JSON;
  if (record->aligned) {
    if (record->form == AS_CSV_TITLES) text_buffer_add(record->out, "  %*s", column_width(key), key);
    return record->form != AS_CSV_TITLES;
  }
  if (record->any) text_buffer_add_text(record->out, record->keys ? "\n" : json ? ", " : ",");
  record->any = true;
  if (record->keys) {
    text_buffer_add_text(record->out, key);
    return false;
  }
  if (json) text_buffer_add(record->out, "\"%s\": ", key);
  if (record->form == AS_CSV_TITLES) text_buffer_add_text(record->out, key);
  return record->form != AS_CSV_TITLES;
}

static bool has_row(const struct record *record, const char *title) {
  return title != NULL && record->form == FOR_PERSONS;
}

static void print_row(struct record *record, const char *title, const char *value, const char *remark) {
  if (!has_row(record, title)) return;
  const bool bare = remark[0] == '\0';
  text_buffer_add(record->out, "  %-16s %-*s%s", title, bare ? 0 : record->width, value,
                  bare || remark[0] == ',' ? "" : " ");
  add_with_unit(record, remark);
  text_buffer_add_text(record->out, "\n");
}

bool record_is_row(const struct record *record) {
  return record->form == AS_CSV || record->form == AS_CSV_TITLES;
}

void record_atoms(struct record *record) {
  record_count(record, record->atoms, NULL, record->molecule->atoms, "");
}

void record_number(struct record *record, const char *key, const char *title, double number, int decimals,
                   const char *remark) {
  enum { DECIMALS_OF_COLUMN = 4 };
  char value[NUMBER_BYTES];
  if (begin(record, key) && !add_aligned(record, key, quantity_text(value, number, DECIMALS_OF_COLUMN))) {
    (record->form == AS_JSON ? json_number : csv_number)(record->out, number);
  }
  if (has_row(record, title)) print_row(record, title, quantity_text(value, number, decimals), remark);
}

void record_count(struct record *record, const char *key, const char *title, int64_t count, const char *remark) {
  char value[NUMBER_BYTES];
  const char *const text = count_text(value, count);
  if (begin(record, key) && !add_aligned(record, key, text)) text_buffer_add_text(record->out, text);
  print_row(record, title, text, remark);
}

void record_text(struct record *record, const char *key, const char *title, const char *text, const char *remark) {
  if (begin(record, key) && !add_aligned(record, key, text)) {
    (record->form == AS_JSON ? json_text : csv_text)(record->out, text);
  }
  print_row(record, title, text, remark);
}

void record_whether(struct record *record, const char *key, const char *title, bool whether, const char *remark) {
  if (begin(record, key) && !add_aligned(record, key, whether ? "yes" : "no")) {
    text_buffer_add_text(record->out, whether ? "true" : "false");
  }
  print_row(record, title, whether ? "yes" : "no", remark);
}

bool record_key(struct record *record, const char *key) {
  return record->form == AS_JSON && begin(record, key);
}

void record_numbers(struct record *record, const char *key, const double *numbers, uint32_t count) {
  if (record_key(record, key)) json_numbers(record->out, numbers, count);
}

void record_counts(struct record *record, const char *key, const uint32_t *counts, uint32_t count) {
  if (record_key(record, key)) json_counts(record->out, counts, count);
}

void record_table(struct record *record, const char *key, const struct table *table) {
  if (key != NULL && record_key(record, key)) table_json(table, record->out);
  if (key != NULL && record->keys) table_keys(table, record->out);
  if (record->form != FOR_PERSONS) return;
  text_buffer_add_text(record->out, "\n");
  table_print(table, record->out);
}

void record_line(struct record *record, const char *text) {
  if (record->form != FOR_PERSONS) return;
  add_with_unit(record, text);
  text_buffer_add_text(record->out, "\n");
}
