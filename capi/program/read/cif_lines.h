/* Rows of a CIF loop of atoms that are on one line each, as in nearly all files: values are found in the line by the
 * blanks between them. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/cif_row.h"
#include "read/line_reader.h"

enum { CIF_LINE_BYTES = 256, CIF_LINE_WORDS = CIF_LINE_BYTES / 64 };

/* Neighbouring values of a row, from the first to the last one. */
struct cif_run {
  uint16_t first, last;
};

/* The items of a loop, and what is known of the rows before. */
struct cif_lines {
  size_t count;  /* of the items; if a line has no room for so many, rows are not read as lines */
  size_t wanted; /* how many items have a meaning; those that atoms of a residue share come first */
  size_t shared; /* how many atoms of a residue share */
  unsigned char item[CIF_ITEMS];
  uint16_t place[CIF_ITEMS];                           /* their values' numbers in a row */
  struct cif_run run[CIF_ITEMS];                       /* of items that atoms of a residue share */
  size_t runs;                                         /* how many */
  uint16_t run_begin[CIF_ITEMS];                       /* where they were in the last row that was kept, */
  uint16_t run_length[CIF_ITEMS];                      /* their lengths, */
  char kept[CIF_LINE_BYTES + 16];                      /* and this row */
  uint64_t begins[CIF_LINE_WORDS + 1];                 /* a bit for each column where a value of the last row begins */
  uint16_t begin[CIF_LINE_BYTES], end[CIF_LINE_BYTES]; /* [count], its values */
};

/* For a loop of these items. */
void cif_lines_begin(struct cif_lines *lines, const enum cif_item *items, size_t count);

/* Take the reader's line for a row. False: it is none, or not one that can be read in this way, and the row is not to
 * be used. The row stays valid until the reader's next line. go_on: where model, residue and letter of the location are
 * those of the row before, which was a line, too, the row may leave them out and go on. */
bool cif_lines_take(struct cif_lines *lines, const struct line_reader *reader, bool go_on, struct cif_row *row);
