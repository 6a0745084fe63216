/* The names of balls: their index, and the names that the format of their file has. */
#pragma once

#include <stdint.h>

#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/record.h"
#include "write/report.h"
#include "write/table.h"

/* The balls in the rows of a table; it stands at the beginning of the table's `of`. */
struct ball_rows {
  const struct molecule *molecule;
  struct ball_columns columns;
  const uint32_t *balls; /* NULL: all of them */
};

struct ball_rows ball_rows_of(const struct molecule *molecule, const uint32_t *balls);

/* The leads of such tables. For persons all of them write the ball's names; for programs the first one writes all
 * names, the second one only the index, in JSON, and the third one nothing. */
void ball_rows_lead(const void *of, size_t row, enum form form, struct text_buffer *out);
void ball_rows_lead_index(const void *of, size_t row, enum form form, struct text_buffer *out);
void ball_rows_lead_silent(const void *of, size_t row, enum form form, struct text_buffer *out);

/* For persons: an empty line, then a table of balls without further columns. */
void ball_rows_print(const struct molecule *molecule, const uint32_t *balls, uint32_t count, struct text_buffer *out);

/* The keys of JSON from "ball" to "radius", without braces. */
void ball_label_json(const struct molecule *molecule, uint32_t ball, struct text_buffer *out);

/* All balls, only in JSON. */
void ball_labels_record(struct record *record, const char *key);

/* The titles of the first columns of a row about a ball, each with the suffix behind it; and these columns. */
void ball_label_csv_titles(const struct file_format *format, const char *suffix, struct text_buffer *out);
void ball_label_csv(const struct molecule *molecule, uint32_t ball, struct text_buffer *out);
