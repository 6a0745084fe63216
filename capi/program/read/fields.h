/* Pieces of a line: fields between blanks, and fields in fixed columns. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"

struct field {
  const char *text; /* inside the line, not NUL-terminated */
  size_t length;
};

/* Split a line of a line_reader, or the rest of one, at blanks and tabs. Stores the first `capacity` fields; returns
 * the number of all fields. */
size_t fields_split(const char *line, size_t length, struct field *fields, size_t capacity);

/* Columns first .. last, counted from 1, without the blanks around; empty if the line ends before them. */
struct field field_in_columns(const char *line, size_t length, size_t first, size_t last);

/* Whether the field is the word, in any case of its letters (word in capitals). */
bool field_is(struct field field, const char *word);

/* The number in a field; `name` is what the reason calls it, for instance "x" or "charge". */
bool field_number(struct field field, const char *name, double *value, uint64_t line, struct failure *failure);

/* The same for a field in a line of a line_reader; most numbers are read faster by it. */
bool field_number_in_line(struct field field, const char *name, double *value, uint64_t line, struct failure *failure);

/* The same for a radius: negative numbers are refused as well. */
bool field_radius(struct field field, double *value, uint64_t line, struct failure *failure);
