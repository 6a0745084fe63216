/* Atoms of a periodic box by place, so that images that fall on one that is there are found. */
#ifndef HARDSPHERE_TOOL_IMAGE_TABLE_H
#define HARDSPHERE_TOOL_IMAGE_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"

/* Buckets of the atoms of a molecule; atoms of one bucket are a list. */
struct image_table {
  const struct molecule *molecule;
  double blur;      /* images that are nearer than this are one */
  int64_t cells[3]; /* into which the box is cut along its vectors, of about an angstrom or more */
  size_t buckets;   /* a power of two */
  uint32_t *first;  /* [buckets], an atom; UINT32_MAX: none */
  uint32_t *next;   /* [most], behind each atom */
};

/* Prepare for a molecule that has an upright box and grows to `most` atoms, and add all that it has. Free the table on
 * true and on false. */
bool image_table_begin(struct image_table *table, const struct molecule *molecule, size_t most,
                       struct failure *failure);

/* Add the last atom of the molecule. */
void image_table_add_last(struct image_table *table);

/* Whether an atom of that element is at these fractions of the box, whole ones aside. */
bool image_table_has(const struct image_table *table, const double fraction[3], struct element_symbol element);

void image_table_free(struct image_table *table);

#endif
