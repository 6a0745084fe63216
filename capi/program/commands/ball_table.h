/* Balls with their areas and derivatives. */
#pragma once

#include "commands/measurement.h"
#include "read/molecule.h"
#include "write/ball_label.h"
#include "write/table.h"

/* The table, and the data from which it is made. */
struct ball_table {
  struct ball_rows rows;
  const double *area, *weight;
  const uint8_t *part; /* 0: a ball that only blocks; NULL: there are none */
  bool lists_blocking; /* list these, too, without area and weight */
  double probe;
  struct column columns[MOST_COLUMNS];
  const double *values[MOST_COLUMNS]; /* per column: a number or a vector for each ball; NULL: free parts of areas */
  struct table table;
};

void ball_table_make(const struct molecule *molecule, const struct measurement *measurement, double probe,
                     struct ball_table *made);
