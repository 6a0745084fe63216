/* Names of atoms, residues or chains, and where in a picture each has most room. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "hardsphere.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/selection.h"

struct page_label {
  char text[48];
  double at[2];  /* in view coordinates: the middle of the largest circle in any face of a ball that belongs to it */
  double radius; /* of that circle */
  uint32_t atom; /* whose ball has it */
};

/* One label for each atom, residue or chain of which something is selected and seen, in the order of the file; *labels
 * [count] is to be freed on true. kind: LABEL_* of drawing.h. map: computed, of the molecule's balls. */
bool page_labels_find(const hsp_map *map, const struct molecule *molecule, const struct selection *selected, int kind,
                      struct page_label **labels, uint32_t *count, struct failure *failure);
