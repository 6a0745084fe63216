/* Atoms of a periodic box, ordered by place, to find images that fall on an atom already there. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"

/* Buckets of the atoms of a molecule; atoms of one bucket are a list. */
struct image_table {
  const struct molecule *molecule;
  double *error;    /* [most][3], the error of each atom's place, in fractions */
  int64_t cells[3]; /* how many cells the box has along each vector; they are about an angstrom wide or more */
  size_t buckets;   /* a power of two */
  uint32_t *first;  /* [buckets], the first atom of each; UINT32_MAX: none */
  uint32_t *next;   /* [most], the atom behind each atom in its bucket */
};

/* Prepare for a molecule that has an upright box and grows to `most` atoms, and add the atoms that it has now. Free the
 * table on true and on false. */
bool image_table_begin(struct image_table *table, const struct molecule *molecule, size_t most,
                       struct failure *failure);

/* The largest error of an atom's place along each vector, in fractions of the vectors, by the number of digits in the
 * file. Numbers without a second digit behind the point are simple fractions, and exact. */
void image_table_error(const struct image_table *table, uint32_t atom, double error[3]);

/* Add the last atom of the molecule, whose place has at most this error. */
void image_table_add_last(struct image_table *table, const double error[3]);

/* Whether the molecule has an atom of that element at these fractions of the box, apart from whole numbers. `error` is
 * their largest error. An atom counts if it is within 0.01 A, or if the errors of both explain the distance and this is
 * less than that of any two atoms. */
bool image_table_has(const struct image_table *table, const double fraction[3], const double error[3],
                     struct element_symbol element);

void image_table_free(struct image_table *table);
