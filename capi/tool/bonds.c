#include "bonds.h"

#include <stdlib.h>

enum { CARBON = 6, ELEMENTS = 96 };

/* In hundredths of an angstrom, by atomic number: B. Cordero et al., Dalton Trans. (2008) 2832, Table 2; carbon as sp3,
 * manganese, iron and cobalt with low spin. 0: bonds are none, or ionic. */
static const unsigned char covalent_radius[ELEMENTS + 1] = {
    0,   31,  0,   0,   96,  84,  76,  71,  66,  57,  0,   0,   0,   121, 111, 107, 105, 102, 0,   0,
    0,   170, 160, 153, 139, 139, 132, 126, 124, 132, 122, 122, 120, 119, 120, 120, 0,   0,   0,   190,
    175, 164, 154, 147, 146, 142, 139, 145, 144, 142, 139, 139, 138, 139, 0,   0,   0,   207, 204, 203,
    201, 199, 198, 198, 196, 194, 192, 192, 189, 190, 187, 187, 175, 170, 162, 151, 144, 141, 136, 136,
    132, 145, 146, 148, 140, 150, 0,   0,   0,   215, 206, 200, 196, 190, 187, 180, 169};

static double radius_of(const struct atom_label *label) {
  const uint32_t number = element_atomic_number(label->element);
  const uint32_t known = number == 0 || number > ELEMENTS ? CARBON : number;
  return covalent_radius[known] / 100.0;
}

/* Balls with half the tolerance added meet where atoms are bonded. */
static bool list_pairs(const struct molecule *molecule, struct geometry *geometry, uint32_t *first, uint32_t **ids,
                       struct failure *failure) {
  double *radius = calloc((size_t)molecule->atoms + 1, sizeof *radius);
  if (radius == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const double covalent = radius_of(&molecule->label[i]);
    radius[i] = covalent > 0.0 ? covalent + BOND_TOLERANCE / 2 : 0.0;
  }
  uint32_t needed = 0;
  int32_t status = hsp_workspace_set(&geometry->work, molecule->atoms, molecule->xyz, radius, NULL, NULL);
  free(radius);
  if (status == HSP_OK) {
    status = hsp_query_pairs(geometry->work.model, HSP_PAIRS_ONCE, first, NULL, 0, &needed);
    if (status == HSP_E_CAPACITY) status = HSP_OK;
  }
  if (status != HSP_OK) return failure_in_library(failure, status);
  *ids = calloc((size_t)needed + 1, sizeof **ids);
  if (*ids == NULL) return failure_of_memory(failure);
  status = hsp_query_pairs(geometry->work.model, HSP_PAIRS_ONCE, first, *ids, needed, &needed);
  if (status == HSP_OK) return true;
  free(*ids);
  return failure_in_library(failure, status);
}

bool bonds_find(const struct molecule *molecule, struct geometry *geometry, uint32_t (**bonds)[2], uint32_t *count,
                struct failure *failure) {
  uint32_t *ids = NULL;
  uint32_t *first = calloc((size_t)molecule->atoms + 1, sizeof *first);
  if (first == NULL) return failure_of_memory(failure);
  if (!list_pairs(molecule, geometry, first, &ids, failure)) {
    free(first);
    return false;
  }
  *count = 0;
  *bonds = calloc((size_t)first[molecule->atoms] + 1, sizeof **bonds);
  if (*bonds != NULL) {
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      for (uint32_t k = first[i]; k < first[i + 1]; ++k) {
        if (radius_of(&molecule->label[i]) <= 0.0 || radius_of(&molecule->label[ids[k]]) <= 0.0) continue;
        (*bonds)[*count][0] = i;
        (*bonds)[(*count)++][1] = ids[k];
      }
    }
  }
  free(first);
  free(ids);
  return *bonds != NULL || failure_of_memory(failure);
}
