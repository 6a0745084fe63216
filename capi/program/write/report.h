/* Results as persons read them, and values of JSON. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/molecule.h"
#include "read/number_text.h"
#include "read/text_buffer.h"

/* The name of a file, with '?' for characters that would disturb a terminal. */
void report_file_name(struct text_buffer *out, const char *name);

/* "  name   value   remark", in columns; remark may be "". */
void report_row(struct text_buffer *out, const char *name, const char *value, const char *remark);
void report_row_count(struct text_buffer *out, const char *name, int64_t value, const char *remark);

/* A count, somewhere in `out`. Numbers have no commas between thousands, so that other programs can read tables too. */
const char *count_text(char out[NUMBER_BYTES], int64_t value);

/* A quantity with `decimals` decimals, or in powers of ten if that would be long or show only zeros. "-" if it is not
 * finite. */
const char *quantity_text(char out[NUMBER_BYTES], double value, int decimals);

/* A quantity in a column: always with `decimals` decimals, or "<0.0001" if these would show only zeros. For files
 * without a unit of length, as quantity_text. */
const char *column_text(char out[NUMBER_BYTES], const struct file_format *format, double value, int decimals);

/* The same for a coordinate, for which 0.0000 is a value like any other. */
const char *coordinate_text(char out[NUMBER_BYTES], const struct file_format *format, double value);

/* One line per ball with its names; report_name writes only index, atom and residue. Only columns for which the file
 * has values are shown. */
struct ball_columns {
  bool names;
  bool elements;
};

struct ball_columns ball_columns_of(const struct molecule *molecule);
void report_name_titles(struct text_buffer *out, struct ball_columns columns, const char *ball);
void report_name(struct text_buffer *out, struct ball_columns columns, const struct molecule *molecule, uint32_t ball);
void report_ball_titles(struct text_buffer *out, struct ball_columns columns);
void report_ball(struct text_buffer *out, struct ball_columns columns, const struct molecule *molecule, uint32_t ball);

/* A number of JSON, as number_text_exact writes it; null if it is not finite. */
void json_number(struct text_buffer *out, double value);

/* Arrays of JSON; json_numbers: null if `numbers` is NULL. */
void json_numbers(struct text_buffer *out, const double *numbers, uint32_t count);
void json_counts(struct text_buffer *out, const uint32_t *counts, uint32_t count);

/* [[x, y, z], ...] */
void json_points(struct text_buffer *out, const double *xyz, uint32_t count);

/* A string of JSON, quotes included. Characters of UTF-8 stand as they are; columns of bytes may cut one in two, so
 * each byte that is of none becomes U+FFFD, the replacement character. */
void json_text(struct text_buffer *out, const char *text);

/* The number of a residue. Most are whole numbers; but files with too many residues for the columns write letters, and
 * some files write nothing: these remain texts. */
void json_residue_number(struct text_buffer *out, const char *text);
