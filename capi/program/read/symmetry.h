/* The symmetry of a crystal, as stated by the file, which has the atoms of one asymmetric unit. */
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

/* The image of a point by the operator. `point` and `out` must differ. */
void symmetry_apply(const struct symmetry_operator *symmetry, const double point[3], double out[3]);

/* Zeros at first. */
struct symmetry {
  char space_group[24]; /* as written; empty if the file does not say it */
  struct symmetry_operator *operators;
  size_t count;
  size_t capacity;
  size_t rows;     /* rows read of the last matrix in REMARK 290 */
  bool cartesian;  /* the operators are of points in angstrom, else of fractions of the box */
  bool unreadable; /* the operators of the file cannot be read; count is 0 */
  double scale[9]; /* of .pdb: fractions of a point are scale x + origin; row by row */
  double origin[3];
  bool scaled[3];  /* which rows the file has */
  size_t matrices; /* of .pdb: MTRIX records of copies that are not in the file, nor made */
  bool filled;     /* the cell was filled with copies */
  size_t shared;   /* images left out since they fell on others of the same atom */
};

/* Take the space group of a CRYST1 line, an operator of REMARK 290, a row of SCALE, or note an MTRIX; other lines are
 * ignored. REMARK 290 has operators as crystallographers write them, "2555  -X,Y+1/2,-Z", and behind them as matrices
 * in angstrom, SMTRY. The matrices are wrong in entries with another origin: they are used only if there is nothing
 * else. False: memory is short. */
bool symmetry_take_pdb_record(struct symmetry *symmetry, const struct line_reader *reader, struct failure *failure);

/* Put the fields 5 to 8 of a line of REMARK 290 or 350, which are numbers, into a row of an operator. False: they are
 * no numbers. */
bool symmetry_row(const struct field *field, size_t fields, size_t row, struct symmetry_operator *out);

/* Take an operator as crystallographers write it, -x,y+1/2,-z. False: memory is short. */
bool symmetry_take_triplet(struct symmetry *symmetry, struct field text, struct failure *failure);

/* Whether there is no symmetry but that by whole vectors of the box: no further operator or matrix, and no space group
 * but P 1. */
bool symmetry_is_none(const struct symmetry *symmetry);

void symmetry_free(struct symmetry *symmetry);
