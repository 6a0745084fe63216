/* Tables: each is stated once, and printed for persons, as JSON or as comma-separated values. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/file_format.h"
#include "read/text_buffer.h"

enum form { FOR_PERSONS, AS_JSON, AS_CSV, AS_CSV_TITLES, AS_KEYS };

enum column_kind {
  COLUMN_COUNT,
  COLUMN_QUANTITY,
  COLUMN_PLAIN, /* a quantity, written as in a row of its own */
  COLUMN_TEXT,
  COLUMN_RESIDUE_NUMBER,
  COLUMN_SHARE,      /* in per cent */
  COLUMN_DERIVATIVE, /* with decimals, or with negative ones in powers of ten */
  COLUMN_POINT,      /* three coordinates, for persons and in CSV in columns of their own; nothing if NULL */
  COLUMN_GRADIENT,   /* three derivatives, written like COLUMN_POINT */
  COLUMN_SHIFT,      /* three whole numbers, in CSV in columns of their own */
  COLUMN_COUNTS      /* an array, of JSON alone */
};

struct column {
  const char *key;   /* of JSON; NULL: not in JSON */
  const char *csv;   /* of CSV; NULL: as `key`, for three columns with _x, _y and _z behind it; "": not in CSV */
  const char *title; /* for persons; each '@' becomes the unit of length; three columns: with blanks between the titles;
                        NULL: it is for programs alone */
  int width;         /* for persons; negative: to the left */
  enum column_kind kind;
  int decimals; /* for persons */
};

/* The content of a column in one row, by the column's kind. */
union cell {
  int64_t count;
  double quantity; /* or derivative */
  const char *text;
  const double *vector; /* [3] */
  const int32_t *shift; /* [3] */
  struct {
    const uint32_t *list;
    uint32_t length;
  } counts;
};

#define TABLE_TITLES SIZE_MAX

enum { MOST_COLUMNS = 24, CELL_BYTES = 40 };

struct table {
  const struct column *columns; /* [count] */
  int count;
  const struct file_format *format;
  size_t rows;
  const void *of; /* what `row` is about */
  /* Make the cells of a row; `text` is room for one of them. False: the row is left out. */
  bool (*row)(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]);
  /* Write the text before the cells of a row in each form, for instance names, or the titles of that text. NULL: there
   * is none. */
  void (*lead)(const void *of, size_t row, enum form form, struct text_buffer *out);
};

void table_print(const struct table *table, struct text_buffer *out);
void table_csv(const struct table *table, struct text_buffer *out);

/* The same without the line of titles. */
void table_csv_rows(const struct table *table, struct text_buffer *out);

/* "[{...}, ...]" */
void table_json(const struct table *table, struct text_buffer *out);

/* ": [{key, key}, ...]", as in help; `lead` is called with AS_KEYS for the keys before them. */
void table_keys(const struct table *table, struct text_buffer *out);
