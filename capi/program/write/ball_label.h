/* The names of balls: their index, and the names that their file's format has. */
#pragma once

#include <stdint.h>

#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/record.h"
#include "write/report.h"
#include "write/table.h"

/* The balls that a table is about, at the beginning of its `of`. */
struct ball_rows {
  const struct molecule *molecule;
  struct ball_columns columns;
  const uint32_t *balls; /* NULL: all of them */
};

struct ball_rows ball_rows_of(const struct molecule *molecule, const uint32_t *balls);

/* The leads of such tables: the ball in full, with index alone in JSON, and not at all in JSON. */
void ball_rows_lead(const void *of, size_t row, enum form form, struct text_buffer *out);
void ball_rows_lead_index(const void *of, size_t row, enum form form, struct text_buffer *out);
void ball_rows_lead_silent(const void *of, size_t row, enum form form, struct text_buffer *out);

/* For persons: a table of balls alone behind an empty line. */
void ball_rows_print(const struct molecule *molecule, const uint32_t *balls, uint32_t count, struct text_buffer *out);

/* The keys of JSON from "ball" to "radius", without braces. */
void ball_label_json(const struct molecule *molecule, uint32_t ball, struct text_buffer *out);

/* All balls, for JSON alone. */
void ball_labels_record(struct record *record, const char *key);

/* The first columns of a row that is about a ball, and their titles with a suffix behind each. */
void ball_label_csv_titles(const struct file_format *format, const char *suffix, struct text_buffer *out);
void ball_label_csv(const struct molecule *molecule, uint32_t ball, struct text_buffer *out);
