/* Tables, each stated once, that are printed for persons, as JSON or as comma-separated values. */
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
  COLUMN_PLAIN, /* a quantity as it is in a row of its own */
  COLUMN_TEXT,
  COLUMN_RESIDUE_NUMBER,
  COLUMN_SHARE,      /* in per cent */
  COLUMN_DERIVATIVE, /* with decimals, or with negative ones in powers of ten */
  COLUMN_POINT,      /* three coordinates, for persons and in CSV in columns of their own; nothing if NULL */
  COLUMN_GRADIENT,   /* three derivatives, likewise */
  COLUMN_SHIFT,      /* three whole numbers, in CSV in columns of their own */
  COLUMN_COUNTS      /* an array, of JSON alone */
};

struct column {
  const char *key; /* of JSON; NULL: it is not there */
  const char *csv; /* of CSV; NULL: the same, and of three columns with _x, _y and _z behind it; "": it is not there */
  const char *title; /* for persons, each '@' in it is the unit of length, of three columns with blanks between them;
                        NULL: it is for programs alone */
  int width;         /* for persons; negative: to the left */
  enum column_kind kind;
  int decimals; /* for persons */
};

/* The content of one row of it, by its kind. */
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
  /* The cells of a row; `text` is room for one of them. False: it is left out. */
  bool (*row)(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]);
  /* Writes the text before them in each form, as what a row is about is called, or its titles; NULL: nothing. */
  void (*lead)(const void *of, size_t row, enum form form, struct text_buffer *out);
};

void table_print(const struct table *table, struct text_buffer *out);
void table_csv(const struct table *table, struct text_buffer *out);

/* The same without the line of titles. */
void table_csv_rows(const struct table *table, struct text_buffer *out);

/* "[{...}, ...]" */
void table_json(const struct table *table, struct text_buffer *out);

/* ": [{key, key}, ...]", as help has them; that of what is before them is asked for AS_KEYS, for titles. */
void table_keys(const struct table *table, struct text_buffer *out);
