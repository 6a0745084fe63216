#include "write/table.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/number.h"
#include "read/threads.h"
#include "write/csv.h"
#include "write/report.h"

static bool is_vector(const struct column *column) {
  return column->kind == COLUMN_POINT || column->kind == COLUMN_GRADIENT;
}

static void add_lead(const struct table *table, size_t row, enum form form, struct text_buffer *out) {
  if (table->lead != NULL) table->lead(table->of, row, form, out);
}

/* The title, of a vector three, with the unit in place of each '@'. */
static void print_title(const struct table *table, const struct column *column, struct text_buffer *out) {
  char title[CELL_BYTES] = "";
  size_t length = 0;
  for (const char *at = column->title;; ++at) {
    if (*at == '\0' || (*at == ' ' && is_vector(column))) {
      text_buffer_add(out, "  %*s", column->width, title);
      length = 0;
      if (*at == '\0') return;
    } else if (*at == '@') {
      length += (size_t)snprintf(title + length, sizeof title - length, "%s", table->format->unit);
    } else {
      title[length++] = *at;
    }
    title[length] = '\0';
  }
}

/* The text of a derivative, in columns that are easy to compare: no "-0.000000". */
static const char *derivative_text(char out[NUMBER_BYTES], double value, int decimals) {
  if (!is_finite(value)) return "-";
  if (decimals < 0) {
    snprintf(out, NUMBER_BYTES, "%.*e", -decimals, value + 0.0);
  } else {
    number_text_fixed(out, value < 5e-7 && value > -5e-7 ? 0.0 : value, decimals);
  }
  return out;
}

static const char *cell_text(const struct table *table, const struct column *column, union cell cell,
                             char out[NUMBER_BYTES]) {
  switch (column->kind) {
    case COLUMN_COUNT:
      return count_text(out, cell.count);
    case COLUMN_QUANTITY:
      return column_text(out, table->format, cell.quantity, column->decimals);
    case COLUMN_PLAIN:
      return quantity_text(out, cell.quantity, column->decimals);
    case COLUMN_DERIVATIVE:
      return derivative_text(out, cell.quantity, column->decimals);
    case COLUMN_SHARE:
      if (!is_finite(cell.quantity)) return "-";
      return strcpy(out + number_text_fixed(out, cell.quantity, column->decimals), " %"), out;
    case COLUMN_SHIFT:
      snprintf(out, NUMBER_BYTES, "%4" PRId32 " %4" PRId32 " %4" PRId32, cell.shift[0], cell.shift[1], cell.shift[2]);
      return out;
    default:
      return cell.text;
  }
}

/* Powers of ten with fewer digits where the column has no room for all of them. */
static const char *fit(const struct column *column, double value, const char *shown, char out[NUMBER_BYTES]) {
  const int digits = column->width - (int)strlen("0.e-00") - (value < 0.0 ? 1 : 0);
  if (strchr(shown, 'e') == NULL || strlen(shown) <= (size_t)column->width || digits < 1) return shown;
  snprintf(out, NUMBER_BYTES, "%.*e", digits, value);
  return out;
}

static void print_cell(const struct table *table, const struct column *column, union cell cell,
                       struct text_buffer *out) {
  char value[NUMBER_BYTES];
  if (!is_vector(column)) {
    const char *const text = cell_text(table, column, cell, value);
    const bool quantity = column->kind == COLUMN_QUANTITY;
    text_buffer_add(out, "  %*s", column->width, quantity ? fit(column, cell.quantity, text, value) : text);
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    text_buffer_add(
        out, "  %*s", column->width,
        cell.vector == NULL ? "-"
        : column->kind == COLUMN_POINT
            ? fit(column, cell.vector[axis], coordinate_text(value, table->format, cell.vector[axis]), value)
            : derivative_text(value, cell.vector[axis], column->decimals));
  }
}

/* The cells of a row, in one of the forms. */
typedef void row_function(const struct table *table, size_t row, const union cell *cells, struct text_buffer *out);

/* ---- rows by several threads ---- */

enum { ROWS_OF_PART = 2000, SLOTS_OF_WORKER = 2 };

struct rows {
  const struct table *table;
  row_function *add;
  struct text_buffer *out;
  struct text_buffer *part; /* [slots] */
  size_t *first;            /* [slots], of the rows in it */
  size_t next;
};

static void add_rows(const struct table *table, row_function *add, size_t first, size_t end, struct text_buffer *out) {
  union cell cells[MOST_COLUMNS];
  char text[CELL_BYTES];
  for (size_t row = first; row < end; ++row) {
    if (table->row(table->of, row, cells, text)) add(table, row, cells, out);
  }
}

static bool take_part(void *of, uint32_t slot, uint64_t *weight) {
  struct rows *const rows = of;
  (void)weight;
  rows->first[slot] = rows->next;
  rows->next += ROWS_OF_PART;
  return rows->first[slot] < rows->table->rows;
}

static void work_on_part(void *of, uint32_t worker, uint32_t slot) {
  struct rows *const rows = of;
  const size_t first = rows->first[slot], left = rows->table->rows - first;
  (void)worker;
  rows->part[slot].length = 0;
  add_rows(rows->table, rows->add, first, first + (left < ROWS_OF_PART ? left : ROWS_OF_PART), &rows->part[slot]);
}

static bool give_part(void *of, uint32_t slot) {
  struct rows *const rows = of;
  text_buffer_append(rows->out, rows->part[slot].text, rows->part[slot].length);
  rows->out->out_of_memory = rows->out->out_of_memory || rows->part[slot].out_of_memory;
  return !rows->out->out_of_memory;
}

static void add_all_rows(const struct table *table, row_function *add, struct text_buffer *out) {
  const size_t parts = table->rows / ROWS_OF_PART;
  const uint32_t workers = out->threads < parts ? out->threads : (uint32_t)parts, slots = SLOTS_OF_WORKER * workers;
  if (workers < 2) {
    add_rows(table, add, 0, table->rows, out);
    return;
  }
  struct rows rows = {table, add, out, calloc(slots, sizeof *rows.part), calloc(slots, sizeof *rows.first), 0};
  const struct in_order loop = {&rows, workers, slots, 0, take_part, work_on_part, give_part};
  if (rows.part == NULL || rows.first == NULL || !in_order_run(&loop)) out->out_of_memory = true;
  for (uint32_t k = 0; rows.part != NULL && k < slots; ++k) text_buffer_free(&rows.part[k]);
  free(rows.part);
  free(rows.first);
}

/* ---- for persons ---- */

static void print_row(const struct table *table, size_t row, const union cell *cells, struct text_buffer *out) {
  add_lead(table, row, FOR_PERSONS, out);
  for (int k = 0; k < table->count; ++k) {
    if (table->columns[k].title != NULL) print_cell(table, &table->columns[k], cells[k], out);
  }
  text_buffer_append(out, "\n", 1);
}

void table_print(const struct table *table, struct text_buffer *out) {
  add_lead(table, TABLE_TITLES, FOR_PERSONS, out);
  for (int k = 0; k < table->count; ++k) {
    if (table->columns[k].title != NULL) print_title(table, &table->columns[k], out);
  }
  text_buffer_add_text(out, "\n");
  add_all_rows(table, print_row, out);
}

/* ---- as JSON ---- */

static void json_cell(const struct column *column, union cell cell, struct text_buffer *out) {
  switch (column->kind) {
    case COLUMN_COUNT:
      text_buffer_add(out, "%" PRId64, cell.count);
      break;
    case COLUMN_QUANTITY:
    case COLUMN_PLAIN:
    case COLUMN_SHARE:
    case COLUMN_DERIVATIVE:
      json_number(out, cell.quantity);
      break;
    case COLUMN_TEXT:
      json_text(out, cell.text);
      break;
    case COLUMN_RESIDUE_NUMBER:
      json_residue_number(out, cell.text);
      break;
    case COLUMN_POINT:
    case COLUMN_GRADIENT:
      json_numbers(out, cell.vector, 3);
      break;
    case COLUMN_SHIFT:
      text_buffer_add(out, "[%" PRId32 ", %" PRId32 ", %" PRId32 "]", cell.shift[0], cell.shift[1], cell.shift[2]);
      break;
    case COLUMN_COUNTS:
      json_counts(out, cell.counts.list, cell.counts.length);
      break;
  }
}

static void json_row(const struct table *table, size_t row, const union cell *cells, struct text_buffer *out) {
  text_buffer_append(out, "{", 1);
  const size_t length = out->length;
  add_lead(table, row, AS_JSON, out);
  for (int k = 0; k < table->count; ++k) {
    const struct column *column = &table->columns[k];
    if (column->key == NULL) continue;
    if (out->length != length) text_buffer_append(out, ", ", 2);
    text_buffer_append(out, "\"", 1);
    text_buffer_add_text(out, column->key);
    text_buffer_append(out, "\": ", 3);
    json_cell(column, cells[k], out);
  }
  text_buffer_append(out, "}, ", 3);
}

void table_json(const struct table *table, struct text_buffer *out) {
  text_buffer_add_text(out, "[");
  const size_t begin = out->length;
  add_all_rows(table, json_row, out);
  if (out->length > begin) out->length -= 2; /* behind the last row nothing stands between rows */
  text_buffer_add_text(out, "]");
}

void table_keys(const struct table *table, struct text_buffer *out) {
  text_buffer_add_text(out, ": [{");
  const size_t length = out->length;
  add_lead(table, TABLE_TITLES, AS_KEYS, out);
  for (int k = 0; k < table->count; ++k) {
    if (table->columns[k].key == NULL) continue;
    text_buffer_add(out, "%s%s", out->length == length ? "" : ", ", table->columns[k].key);
  }
  text_buffer_add_text(out, "}, ...]");
}

/* ---- as comma-separated values ---- */

/* NULL: it is not in CSV. */
static const char *csv_key(const struct column *column) {
  if (column->csv == NULL) return column->key;
  return column->csv[0] == '\0' ? NULL : column->csv;
}

static void csv_cell(const struct column *column, union cell cell, struct text_buffer *out) {
  switch (column->kind) {
    case COLUMN_COUNT:
      text_buffer_add(out, "%" PRId64, cell.count);
      break;
    case COLUMN_QUANTITY:
    case COLUMN_PLAIN:
    case COLUMN_SHARE:
    case COLUMN_DERIVATIVE:
      csv_number(out, cell.quantity);
      break;
    case COLUMN_POINT:
    case COLUMN_GRADIENT:
      for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text_buffer_add_character(out, ',');
        if (cell.vector != NULL) csv_number(out, cell.vector[axis]);
      }
      break;
    case COLUMN_SHIFT:
      text_buffer_add(out, "%" PRId32 ",%" PRId32 ",%" PRId32, cell.shift[0], cell.shift[1], cell.shift[2]);
      break;
    default:
      csv_text(out, cell.text);
      break;
  }
}

static void csv_row(const struct table *table, size_t row, const union cell *cells, struct text_buffer *out) {
  const size_t length = out->length;
  add_lead(table, row, AS_CSV, out);
  bool any = out->length > length;
  for (int k = 0; k < table->count; ++k) {
    if (csv_key(&table->columns[k]) == NULL) continue;
    if (any) text_buffer_add_character(out, ',');
    any = true;
    csv_cell(&table->columns[k], cells[k], out);
  }
  text_buffer_add_character(out, '\n');
}

void table_csv(const struct table *table, struct text_buffer *out) {
  const size_t length = out->length;
  add_lead(table, TABLE_TITLES, AS_CSV_TITLES, out);
  for (int k = 0; k < table->count; ++k) {
    const struct column *column = &table->columns[k];
    const char *key = csv_key(column);
    if (key == NULL) continue;
    text_buffer_add(out, "%s%s", out->length == length ? "" : ",", key);
    const bool three = (is_vector(column) && column->csv == NULL) || column->kind == COLUMN_SHIFT;
    if (three) text_buffer_add(out, "_x,%s_y,%s_z", key, key);
  }
  text_buffer_add_text(out, "\n");
  table_csv_rows(table, out);
}

void table_csv_rows(const struct table *table, struct text_buffer *out) {
  add_all_rows(table, csv_row, out);
}
