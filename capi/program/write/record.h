/* The results of a command, each stated once: rows for persons, keys of JSON, or columns of comma-separated values. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/table.h"

/* Where results go. In the functions below, key NULL: for persons alone; title NULL: not for persons. A remark, in
 * which each '@' is the unit of length, stands behind a blank unless it begins with a comma. */
struct record {
  enum form form;
  const struct molecule *molecule; /* that they are of */
  const char *atoms;               /* the key of the number of its atoms in this form */
  int width;                       /* what values with a remark take at least, so that remarks stand under each other */
  bool any;                        /* a key was written */
  bool aligned;                    /* lines of CSV and their titles in columns for persons instead */
  struct text_buffer *out;
  bool keys; /* of JSON the keys alone, with the columns of tables, each on a line: for help */
};

enum { VALUE_WIDTH = 14 };

/* Whether it is one row, of comma-separated values or of a table for persons, or the titles of such rows. */
bool record_is_row(const struct record *record);

/* The number of atoms, which is for programs alone. */
void record_atoms(struct record *record);

/* With so many decimals for persons. Unless it is finite, "-" for them, null in JSON, and nothing in CSV. */
void record_number(struct record *record, const char *key, const char *title, double number, int decimals,
                   const char *remark);
void record_count(struct record *record, const char *key, const char *title, int64_t count, const char *remark);
void record_text(struct record *record, const char *key, const char *title, const char *text, const char *remark);

/* "yes" or "no", true or false. */
void record_whether(struct record *record, const char *key, const char *title, bool whether, const char *remark);

/* For JSON alone: arrays, of numbers null if there are none; and a key whose value the caller adds, if it is true. */
void record_numbers(struct record *record, const char *key, const double *numbers, uint32_t count);
void record_counts(struct record *record, const char *key, const uint32_t *counts, uint32_t count);
bool record_key(struct record *record, const char *key);

/* An array of JSON; for persons, if there is a key or not, a table behind an empty line. */
void record_table(struct record *record, const char *key, const struct table *table);

/* For persons alone: what is not a row. */
void record_line(struct record *record, const char *text);
