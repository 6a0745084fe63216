/* Numbers for pairs of groups, for persons: a matrix, and notes on the groups. */
#pragma once

#include <stdint.h>

#include "read/selection_groups.h"
#include "write/record.h"

/* More groups have no room in a line. */
enum { MOST_GROUPS_OF_MATRIX = 12 };

/* Write a matrix of value(of, row, column), with the names of the groups. The values are symmetric, and `value` is
 * called with row < column; with `diagonal` also with row = column, for the group itself. */
void group_matrix_record(struct record *record, const struct found_groups *groups, bool diagonal,
                         double value(const void *of, uint32_t row, uint32_t column), const void *of);

/* The width of a column at the left with the names of the groups. */
int group_names_width(const struct found_groups *groups);

/* A line for each group that names atoms of groups before it. */
void group_notes_record(struct record *record, const struct found_groups *groups);
