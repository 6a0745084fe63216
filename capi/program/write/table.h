/* Results, each stated once: single numbers and tables, that are printed for persons, as JSON or as comma-separated
 * values. */
#ifndef HARDSPHERE_TOOL_TABLE_H
#define HARDSPHERE_TOOL_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/file_format.h"
#include "read/text_buffer.h"

/* A number. */
struct result {
  const char *key;   /* of JSON and CSV; NULL: it is for persons alone */
  const char *title; /* for persons; NULL: it is for programs alone */
  double number;     /* a count, too: they are below 2^53 */
  int decimals;      /* for persons */
  /* For persons, each '@' in it being the unit of length. A blank stands before it unless it begins with a comma. */
  const char *remark;
};

/* What values take as a rule, so that remarks stand under each other. */
enum { RESULT_WIDTH = 14 };

/* For persons a line for each: title, value in so many columns at least, remark. */
void results_print(const struct result *results, size_t count, int width, const char *unit, struct text_buffer *out);

/* , "key": number */
void results_json(const struct result *results, size_t count, struct text_buffer *out);

/* With commas between them. */
void results_csv_titles(const struct result *results, size_t count, struct text_buffer *out);
void results_csv(const struct result *results, size_t count, struct text_buffer *out);

/* A column of a table. */
enum column_kind {
  COLUMN_COUNT,
  COLUMN_QUANTITY,
  COLUMN_COORDINATE,
  COLUMN_TEXT,
  COLUMN_RESIDUE_NUMBER,
  COLUMN_SHIFT /* three whole numbers; in CSV columns of their own, _x, _y and _z */
};

struct column {
  const char *key;   /* of JSON; NULL: it is not there */
  const char *csv;   /* of CSV, if it is another one */
  const char *title; /* for persons, each '@' in it is the unit of length; NULL: it is for programs alone */
  int width;         /* for persons; negative: to the left */
  enum column_kind kind;
  int decimals; /* for persons */
};

/* What stands in one row of it, by its kind. */
union cell {
  int64_t count;
  double quantity; /* or coordinate */
  const char *text;
  const int32_t *shift; /* [3] */
};

enum form { FOR_PERSONS, AS_JSON, AS_CSV };

#define TABLE_TITLES SIZE_MAX

enum { MOST_COLUMNS = 12, CELL_BYTES = 40 };

struct table {
  const struct column *columns; /* [count] */
  int count;
  const struct file_format *format;
  size_t rows;
  const void *of; /* what `row` is about */
  /* The cells of a row; `text` is room for one of them. False: it is left out. */
  bool (*row)(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]);
  /* What stands before them in each form, as what a row is about is called, or its titles; NULL: nothing. */
  void (*lead)(const void *of, size_t row, enum form form, struct text_buffer *out);
};

void table_print(const struct table *table, struct text_buffer *out);
void table_csv(const struct table *table, struct text_buffer *out);

/* "[{...}, ...]" */
void table_json(const struct table *table, struct text_buffer *out);

#endif
