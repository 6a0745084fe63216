/* Balls with their areas and derivatives. */
#pragma once

#include "commands/measurement.h"
#include "read/molecule.h"
#include "write/ball_label.h"
#include "write/table.h"

/* The table, and what it is made of. */
struct ball_table {
  struct ball_rows rows;
  const double *area, *weight;
  const uint8_t *part; /* 0 of balls that only block; NULL: none do */
  bool lists_blocking; /* with neither area nor weight */
  double probe;
  struct column columns[MOST_COLUMNS];
  const double *values[MOST_COLUMNS]; /* of the columns, a number or a vector a ball; NULL: the free part of its area */
  struct table table;
};

void ball_table_make(const struct molecule *molecule, const struct measurement *measurement, double probe,
                     struct ball_table *made);
