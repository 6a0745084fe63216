#include "write/table.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "write/csv.h"
#include "write/report.h"

/* A text as it is, without what looking for conversions in it costs. */
static void add(struct text_buffer *out, const char *text) {
  text_buffer_append(out, text, strlen(text));
}

/* A text with the unit in place of each '@'. */
static void add_with_unit(struct text_buffer *out, const char *text, const char *unit) {
  for (; *text != '\0'; ++text) {
    if (*text == '@') text_buffer_add(out, "%s", unit);
    if (*text != '@') text_buffer_append(out, text, 1);
  }
}

void results_print(const struct result *results, size_t count, int width, const char *unit, struct text_buffer *out) {
  for (const struct result *result = results; result != results + count; ++result) {
    char value[NUMBER_BYTES];
    if (result->title == NULL) continue;
    const bool bare = result->remark[0] == '\0';
    text_buffer_add(out, "  %-16s %-*s%s", result->title, bare ? 0 : width,
                    quantity_text(value, result->number, result->decimals),
                    bare || result->remark[0] == ',' ? "" : " ");
    add_with_unit(out, result->remark, unit);
    text_buffer_add(out, "\n");
  }
}

void results_json(const struct result *results, size_t count, struct text_buffer *out) {
  for (const struct result *result = results; result != results + count; ++result) {
    if (result->key == NULL) continue;
    text_buffer_add(out, ", \"%s\": ", result->key);
    json_number(out, result->number);
  }
}

void results_csv_titles(const struct result *results, size_t count, struct text_buffer *out) {
  const char *comma = "";
  for (const struct result *result = results; result != results + count; ++result) {
    if (result->key == NULL) continue;
    text_buffer_add(out, "%s%s", comma, result->key);
    comma = ",";
  }
}

void results_csv(const struct result *results, size_t count, struct text_buffer *out) {
  const char *comma = "";
  for (const struct result *result = results; result != results + count; ++result) {
    if (result->key == NULL) continue;
    text_buffer_add(out, "%s", comma);
    csv_number(out, result->number);
    comma = ",";
  }
}

static void add_lead(const struct table *table, size_t row, enum form form, struct text_buffer *out) {
  if (table->lead != NULL) table->lead(table->of, row, form, out);
}

static void print_cell(const struct table *table, const struct column *column, union cell cell,
                       struct text_buffer *out) {
  char value[NUMBER_BYTES];
  const char *shown = cell.text;
  if (column->kind == COLUMN_COUNT) shown = count_text(value, cell.count);
  if (column->kind == COLUMN_QUANTITY) shown = column_text(value, table->format, cell.quantity, column->decimals);
  if (column->kind == COLUMN_COORDINATE) shown = coordinate_text(value, table->format, cell.quantity);
  if (column->kind == COLUMN_SHIFT) {
    snprintf(value, sizeof value, "%4" PRId32 " %4" PRId32 " %4" PRId32, cell.shift[0], cell.shift[1], cell.shift[2]);
    shown = value;
  }
  text_buffer_add(out, "  %*s", column->width, shown);
}

void table_print(const struct table *table, struct text_buffer *out) {
  union cell cells[MOST_COLUMNS];
  char text[CELL_BYTES];
  add_lead(table, TABLE_TITLES, FOR_PERSONS, out);
  for (int k = 0; k < table->count; ++k) {
    const struct column *column = &table->columns[k];
    struct text_buffer title = TEXT_BUFFER_EMPTY;
    if (column->title == NULL) continue;
    add_with_unit(&title, column->title, table->format->unit);
    if (!title.out_of_memory) text_buffer_add(out, "  %*s", column->width, title.length == 0 ? "" : title.text);
    out->out_of_memory = out->out_of_memory || title.out_of_memory;
    text_buffer_free(&title);
  }
  text_buffer_add(out, "\n");
  for (size_t row = 0; row < table->rows; ++row) {
    if (!table->row(table->of, row, cells, text)) continue;
    add_lead(table, row, FOR_PERSONS, out);
    for (int k = 0; k < table->count; ++k) {
      if (table->columns[k].title != NULL) print_cell(table, &table->columns[k], cells[k], out);
    }
    text_buffer_add(out, "\n");
  }
}

static void json_cell(const struct column *column, union cell cell, struct text_buffer *out) {
  switch (column->kind) {
    case COLUMN_COUNT:
      text_buffer_add(out, "%" PRId64, cell.count);
      break;
    case COLUMN_QUANTITY:
    case COLUMN_COORDINATE:
      json_number(out, cell.quantity);
      break;
    case COLUMN_TEXT:
      json_text(out, cell.text);
      break;
    case COLUMN_RESIDUE_NUMBER:
      json_residue_number(out, cell.text);
      break;
    case COLUMN_SHIFT:
      text_buffer_add(out, "[%" PRId32 ", %" PRId32 ", %" PRId32 "]", cell.shift[0], cell.shift[1], cell.shift[2]);
      break;
  }
}

void table_json(const struct table *table, struct text_buffer *out) {
  union cell cells[MOST_COLUMNS];
  char text[CELL_BYTES];
  const char *begin = "{";
  text_buffer_add(out, "[");
  for (size_t row = 0; row < table->rows; ++row) {
    if (!table->row(table->of, row, cells, text)) continue;
    add(out, begin);
    const size_t length = out->length;
    add_lead(table, row, AS_JSON, out);
    for (int k = 0; k < table->count; ++k) {
      const struct column *column = &table->columns[k];
      if (column->key == NULL) continue;
      add(out, out->length == length ? "\"" : ", \"");
      add(out, column->key);
      add(out, "\": ");
      json_cell(column, cells[k], out);
    }
    add(out, "}");
    begin = ", {";
  }
  text_buffer_add(out, "]");
}

static const char *csv_key(const struct column *column) {
  return column->csv != NULL ? column->csv : column->key;
}

void table_csv(const struct table *table, struct text_buffer *out) {
  union cell cells[MOST_COLUMNS];
  char text[CELL_BYTES];
  size_t length = out->length;
  add_lead(table, TABLE_TITLES, AS_CSV, out);
  for (int k = 0; k < table->count; ++k) {
    const char *key = csv_key(&table->columns[k]);
    if (key == NULL) continue;
    text_buffer_add(out, "%s%s", out->length == length ? "" : ",", key);
    if (table->columns[k].kind == COLUMN_SHIFT) text_buffer_add(out, "_x,%s_y,%s_z", key, key);
  }
  text_buffer_add(out, "\n");
  for (size_t row = 0; row < table->rows; ++row) {
    if (!table->row(table->of, row, cells, text)) continue;
    const char *comma = "";
    length = out->length;
    add_lead(table, row, AS_CSV, out);
    if (out->length > length) comma = ",";
    for (int k = 0; k < table->count; ++k) {
      const struct column *column = &table->columns[k];
      const int32_t *shift = cells[k].shift;
      if (csv_key(column) == NULL) continue;
      add(out, comma);
      comma = ",";
      if (column->kind == COLUMN_COUNT) {
        text_buffer_add(out, "%" PRId64, cells[k].count);
      } else if (column->kind == COLUMN_QUANTITY || column->kind == COLUMN_COORDINATE) {
        csv_number(out, cells[k].quantity);
      } else if (column->kind == COLUMN_SHIFT) {
        text_buffer_add(out, "%" PRId32 ",%" PRId32 ",%" PRId32, shift[0], shift[1], shift[2]);
      } else {
        csv_text(out, cells[k].text);
      }
    }
    add(out, "\n");
  }
}
