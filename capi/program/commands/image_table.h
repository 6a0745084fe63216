/* Atoms of a periodic box by place, so that images that fall on one that is there are found. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"

/* Buckets of the atoms of a molecule; atoms of one bucket are a list. */
struct image_table {
  const struct molecule *molecule;
  double *error;    /* [most][3], of each atom, as fractions */
  int64_t cells[3]; /* into which the box is cut along its vectors, of about an angstrom or more */
  size_t buckets;   /* a power of two */
  uint32_t *first;  /* [buckets], an atom; UINT32_MAX: none */
  uint32_t *next;   /* [most], behind each atom */
};

/* Prepare for a molecule that has an upright box and grows to `most` atoms, and add all that it has. Free the table on
 * true and on false. */
bool image_table_begin(struct image_table *table, const struct molecule *molecule, size_t most,
                       struct failure *failure);

/* By how much the place of an atom of the molecule may be wrong along each vector, by the digits that the file has of
 * it: fractions of the vectors. Numbers without a second digit behind the point are simple fractions, and right. */
void image_table_error(const struct image_table *table, uint32_t atom, double error[3]);

/* Add the last atom of the molecule, whose place may be wrong by so much. */
void image_table_add_last(struct image_table *table, const double error[3]);

/* Whether an atom of that element is at these fractions of the box, whole ones aside, which may be wrong by so much: it
 * is there if both errors explain that it is elsewhere and it is nearer than any two atoms are, or within 0.01 A. */
bool image_table_has(const struct image_table *table, const double fraction[3], const double error[3],
                     struct element_symbol element);

void image_table_free(struct image_table *table);
