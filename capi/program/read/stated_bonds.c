#include "read/stated_bonds.h"

#include <stdlib.h>
#include <string.h>

struct numbered_atom {
  struct serial_label serial;
  uint32_t atom;
};

static int compare_serials(const void *a, const void *b) {
  const struct numbered_atom *one = a, *two = b;
  return strcmp(one->serial.text, two->serial.text);
}

static int compare_pairs(const void *a, const void *b) {
  const uint32_t *one = a, *two = b;
  const int first = (one[0] > two[0]) - (one[0] < two[0]);
  return first != 0 ? first : (one[1] > two[1]) - (one[1] < two[1]);
}

/* The only atom with a serial number; false if there is none, or another one. */
static bool find_atom(const struct numbered_atom *atoms, uint32_t count, const struct serial_label *serial,
                      uint32_t *atom) {
  const struct numbered_atom wanted = {*serial, 0};
  const struct numbered_atom *found = bsearch(&wanted, atoms, count, sizeof *atoms, compare_serials);
  if (found == NULL) return false;
  const size_t at = (size_t)(found - atoms);
  if (at > 0 && compare_serials(&atoms[at - 1], found) == 0) return false;
  if (at + 1 < count && compare_serials(&atoms[at + 1], found) == 0) return false;
  *atom = found->atom;
  return true;
}

static void take_pairs(const struct molecule *molecule, const struct numbered_atom *atoms, struct stated_bonds *bonds) {
  for (size_t k = 0; k < molecule->bonds; ++k) {
    const struct serial_label *serial = molecule->bond[k].serial;
    uint32_t one, two;
    if (!find_atom(atoms, molecule->atoms, &serial[0], &one)) continue;
    if (!find_atom(atoms, molecule->atoms, &serial[1], &two) || one == two) continue;
    bonds->named[one] = bonds->named[two] = true;
    uint32_t *pair = bonds->pair[bonds->count++];
    pair[0] = one < two ? one : two;
    pair[1] = one < two ? two : one;
  }
  qsort(bonds->pair, bonds->count, sizeof *bonds->pair, compare_pairs);
  size_t kept = 0;
  for (size_t k = 0; k < bonds->count; ++k) {
    if (k > 0 && compare_pairs(bonds->pair[k], bonds->pair[k - 1]) == 0) continue;
    memmove(bonds->pair[kept++], bonds->pair[k], sizeof *bonds->pair);
  }
  bonds->count = kept;
}

bool stated_bonds_find(const struct molecule *molecule, struct stated_bonds *bonds) {
  struct numbered_atom *atoms = calloc((size_t)molecule->atoms + 1, sizeof *atoms);
  bonds->count = 0;
  bonds->pair = calloc(molecule->bonds + 1, sizeof *bonds->pair);
  bonds->named = calloc((size_t)molecule->atoms + 1, sizeof *bonds->named);
  const bool enough = atoms != NULL && bonds->pair != NULL && bonds->named != NULL;
  if (enough) {
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      atoms[i].serial = molecule->extra[i].serial;
      atoms[i].atom = i;
    }
    qsort(atoms, molecule->atoms, sizeof *atoms, compare_serials);
    take_pairs(molecule, atoms, bonds);
  }
  free(atoms);
  return enough;
}

void stated_bonds_free(struct stated_bonds *bonds) {
  free(bonds->pair);
  free(bonds->named);
}
