/* The symmetry of a crystal, as the file with one asymmetric unit states it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/fields.h"
#include "read/line_reader.h"

/* x becomes rotation x + translation. */
struct symmetry_operator {
  double rotation[9]; /* row by row */
  double translation[3];
};

/* Where the operator takes a point, which is not `out`. */
void symmetry_apply(const struct symmetry_operator *symmetry, const double point[3], double out[3]);

/* Zeros at first. */
struct symmetry {
  char space_group[24]; /* as written; empty where the file does not say */
  struct symmetry_operator *operators;
  size_t count;
  size_t capacity;
  size_t rows;     /* of the last operator that REMARK 290 has given as a matrix so far */
  bool cartesian;  /* the operators are of points in angstrom, else of fractions of the box */
  bool unreadable; /* there are operators, but not as they should be; count is 0 */
  double scale[9]; /* of .pdb: fractions of a point are scale x + origin; row by row */
  double origin[3];
  bool scaled[3];  /* which rows the file has */
  size_t matrices; /* of .pdb: MTRIX records of copies that are not in the file, nor made */
  bool filled;     /* the cell was filled with copies */
  size_t shared;   /* images that fell on others of the same atom, and were left out */
};

/* Take the space group of CRYST1, an operator of REMARK 290, a row of SCALE, or note an MTRIX if the line is one. Of
 * REMARK 290 the lines as crystallographers write them count, "2555  -X,Y+1/2,-Z": matrices in angstrom, SMTRY, which
 * follow them, are wrong in entries whose origin is elsewhere; they count where they are alone. False: memory is
 * short. */
bool symmetry_take_pdb_record(struct symmetry *symmetry, const struct line_reader *reader, struct failure *failure);

/* Put four numbers, the fields 5 to 8 of a line as REMARK 290 and 350 have them, into a row of an operator. False: it
 * has other fields. */
bool symmetry_row(const struct field *field, size_t fields, size_t row, struct symmetry_operator *out);

/* Take an operator as crystallographers write it, -x,y+1/2,-z. False: memory is short. */
bool symmetry_take_triplet(struct symmetry *symmetry, struct field text, struct failure *failure);

/* Whether there is none but that by whole vectors of the box: no other operator or matrix, and no space group but
 * P 1. */
bool symmetry_is_none(const struct symmetry *symmetry);

void symmetry_free(struct symmetry *symmetry);
