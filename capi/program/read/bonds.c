#include "read/bonds.h"

#include <math.h>
#include <stdlib.h>

enum { CARBON = 6, ELEMENTS = 96 };

/* The cosine of 80 degrees. */
static const double cosine_between = 0.17364817766693036;

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
    status = hsp_query_pairs(geometry->work.model, 0, first, NULL, 0, &needed);
    if (status == HSP_E_CAPACITY) status = HSP_OK;
  }
  if (status != HSP_OK) return failure_in_library(failure, status);
  *ids = calloc((size_t)needed + 1, sizeof **ids);
  if (*ids == NULL) return failure_of_memory(failure);
  status = hsp_query_pairs(geometry->work.model, 0, first, *ids, needed, &needed);
  if (status == HSP_OK) return true;
  free(*ids);
  return failure_in_library(failure, status);
}

double atoms_squared_distance(const struct molecule *molecule, uint32_t i, uint32_t j) {
  double sum = 0.0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double d = molecule->xyz[3 * (size_t)i + axis] - molecule->xyz[3 * (size_t)j + axis];
    sum += d * d;
  }
  return sum;
}

/* Whether a third atom that is close enough to both lies between two of them: the angle there is more than 80 degrees.
 * In rings of three it is about 60. Then the two are neighbours of the third one whom poor coordinates bring too close.
 */
static bool has_atom_between(const struct molecule *molecule, const uint32_t *first, const uint32_t *ids, uint32_t i,
                             uint32_t j) {
  const double length = atoms_squared_distance(molecule, i, j);
  uint32_t b = first[j];
  for (uint32_t a = first[i]; a < first[i + 1]; ++a) {
    while (b < first[j + 1] && ids[b] < ids[a]) ++b;
    if (b == first[j + 1] || ids[b] != ids[a] || radius_of(&molecule->label[ids[a]]) <= 0.0) continue;
    const double one = atoms_squared_distance(molecule, i, ids[a]), two = atoms_squared_distance(molecule, j, ids[a]);
    if (one + two - 2.0 * cosine_between * sqrt(one * two) < length) return true;
  }
  return false;
}

/* Find, in order, the bonds that records state, and pairs that are close enough unless both atoms have stated bonds. */
static bool join_pairs(const struct molecule *molecule, const uint32_t *first, const uint32_t *ids, struct bond **bonds,
                       uint32_t *count) {
  struct stated_bonds stated;
  bool enough = stated_bonds_find(molecule, &stated);
  const size_t most = (size_t)first[molecule->atoms] + stated.count;
  *count = 0;
  *bonds = enough && most < UINT32_MAX ? calloc(most + 1, sizeof **bonds) : NULL;
  enough = *bonds != NULL;
  size_t next = 0;
  for (uint32_t i = 0; enough && i < molecule->atoms; ++i) {
    for (; next < stated.count && stated.bond[next].atom[0] == i; ++next) {
      (*bonds)[(*count)++] = stated.bond[next];
    }
    for (uint32_t k = first[i]; k < first[i + 1]; ++k) {
      const uint32_t j = ids[k];
      if (j < i || (stated.named[i] && stated.named[j])) continue;
      if (radius_of(&molecule->label[i]) <= 0.0 || radius_of(&molecule->label[j]) <= 0.0) continue;
      if (has_atom_between(molecule, first, ids, i, j)) continue;
      (*bonds)[(*count)++] = (struct bond){{i, j}, BOND_UNKNOWN};
    }
  }
  stated_bonds_free(&stated);
  return enough;
}

bool bonds_find(const struct molecule *molecule, struct geometry *geometry, struct bond **bonds, uint32_t *count,
                struct failure *failure) {
  uint32_t *ids = NULL;
  uint32_t *first = calloc((size_t)molecule->atoms + 1, sizeof *first);
  if (first == NULL) return failure_of_memory(failure);
  if (!list_pairs(molecule, geometry, first, &ids, failure)) {
    free(first);
    return false;
  }
  const bool done = join_pairs(molecule, first, ids, bonds, count);
  free(first);
  free(ids);
  return done || failure_of_memory(failure);
}
