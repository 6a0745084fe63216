/* The results of a command, each stated once: rows for persons, keys of JSON, or columns of comma-separated values. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/table.h"

/* The output of results. In the functions below, key NULL means: for persons alone; title NULL: not for persons. In a
 * remark each '@' is replaced by the unit of length; a blank comes before it unless it begins with a comma. */
struct record {
  enum form form;
  const struct molecule *molecule; /* whose results they are */
  const char *atoms;               /* the key of the number of its atoms in this form */
  int width;                       /* least width of values with a remark, so that remarks are aligned */
  bool any;                        /* a key was written */
  bool aligned;                    /* lines of CSV and their titles in columns for persons */
  struct text_buffer *out;
  bool keys; /* write only the keys of JSON, with the columns of tables, each on a line: for help */
};

enum { VALUE_WIDTH = 14 };

/* Whether the record is one row of comma-separated values or of a table for persons, or the titles of such rows. */
bool record_is_row(const struct record *record);

/* The number of atoms, for programs alone. */
void record_atoms(struct record *record);

/* A number, with that many decimals for persons. If it is not finite: "-" for persons, null in JSON, nothing in CSV. */
void record_number(struct record *record, const char *key, const char *title, double number, int decimals,
                   const char *remark);
void record_count(struct record *record, const char *key, const char *title, int64_t count, const char *remark);
void record_text(struct record *record, const char *key, const char *title, const char *text, const char *remark);

/* "yes" or "no" for persons, true or false for programs. */
void record_whether(struct record *record, const char *key, const char *title, bool whether, const char *remark);

/* For JSON alone: arrays (record_numbers: null if `numbers` is NULL); and a key whose value the caller adds, if it is
 * true. */
void record_numbers(struct record *record, const char *key, const double *numbers, uint32_t count);
void record_counts(struct record *record, const char *key, const uint32_t *counts, uint32_t count);
bool record_key(struct record *record, const char *key);

/* An array of JSON; for persons, also without a key, an empty line and a table. */
void record_table(struct record *record, const char *key, const struct table *table);

/* For persons alone: a line that is no row. */
void record_line(struct record *record, const char *text);
