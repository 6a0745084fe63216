/* Numbers of two groups each, for persons: a matrix, and what is to be said of the groups. */
#pragma once

#include <stdint.h>

#include "read/selection_groups.h"
#include "write/record.h"

/* More have no room in a line. */
enum { MOST_GROUPS_OF_MATRIX = 12 };

/* A matrix with the names of the groups, of value(of, row, column), which is the same both ways and is asked for with
 * row < column, or of a group itself with row = column where the diagonal counts. */
void group_matrix_record(struct record *record, const struct found_groups *groups, bool diagonal,
                         double value(const void *of, uint32_t row, uint32_t column), const void *of);

/* Of a column to the left with the names of the groups. */
int group_names_width(const struct found_groups *groups);

/* A line for each group that names atoms of groups before it. */
void group_notes_record(struct record *record, const struct found_groups *groups);
