/* The rows of a CIF loop of atoms that stand on one line each, as they do in nearly all files: values are found in the
 * line by the blanks between them, and where they begin in the columns of the row before, without looking for them. */
#ifndef HARDSPHERE_TOOL_CIF_LINES_H
#define HARDSPHERE_TOOL_CIF_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/cif_row.h"
#include "read/line_reader.h"

enum { CIF_LINE_BYTES = 256, CIF_LINE_WORDS = CIF_LINE_BYTES / 64 };

/* The items of a loop, and where their values began in the last row. Zeros at first but for the items. */
struct cif_lines {
  const enum cif_item *items; /* [count] */
  size_t count;
  bool known;
  uint64_t begins[CIF_LINE_WORDS];    /* a bit for each column; of all values */
  size_t wanted;                      /* items with a meaning: first those that atoms of a residue share */
  size_t shared;                      /* how many */
  uint64_t of_shared[CIF_LINE_WORDS]; /* the columns of their values, if `compares` */
  bool compares;                      /* rows begin in the same columns, so that they are compared */
  size_t length;                      /* of the last row */
  char before[CIF_LINE_BYTES];        /* the last row */
  unsigned char item[CIF_ITEMS];
  unsigned char begin[CIF_ITEMS];
};

/* Take the reader's line for a row. False: it is none, or not one that can be read in this way, and the row is not to
 * be used. The row stays valid until the reader's next line. */
bool cif_lines_take(struct cif_lines *lines, const struct line_reader *reader, struct cif_row *row);

#endif
