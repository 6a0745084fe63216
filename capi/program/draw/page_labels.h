/* Names of atoms, residues or chains, and the place in a picture where each has most room. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "hardsphere.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/residues.h"
#include "read/selection.h"

struct page_label {
  char text[RESIDUE_TEXT_BYTES];
  double at[2];  /* in view coordinates: the centre of the largest circle within a face of one of its balls */
  double radius; /* of that circle */
  uint32_t atom; /* whose ball has that face */
};

/* Make one label for each atom, residue or chain with a selected atom that is seen, in the order of the file. Free
 * *labels [count] on true. kind: LABEL_* of drawing_request.h. map: computed, of the molecule's balls. */
bool page_labels_find(const hsp_map *map, const struct molecule *molecule, const struct selection *selected, int kind,
                      struct page_label **labels, uint32_t *count, struct failure *failure);
