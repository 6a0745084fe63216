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

/* One statement of a bond. */
struct statement {
  struct bond bond;
  uint32_t model;
  bool back; /* of the larger number first */
};

static int compare_bonds(const struct bond *one, const struct bond *two) {
  const int first = (one->atom[0] > two->atom[0]) - (one->atom[0] < two->atom[0]);
  return first != 0 ? first : (one->atom[1] > two->atom[1]) - (one->atom[1] < two->atom[1]);
}

/* So that no two orders make a difference: statements that are equal here are equal. */
static int compare_statements(const void *a, const void *b) {
  const struct statement *one = a, *two = b;
  int order = compare_bonds(&one->bond, &two->bond);
  if (order == 0) order = (one->model > two->model) - (one->model < two->model);
  if (order == 0) order = (int)one->back - (int)two->back;
  return order != 0 ? order : (int)one->bond.order - (int)two->bond.order;
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

static size_t find_statements(const struct molecule *molecule, const struct numbered_atom *atoms, bool *named,
                              struct statement *statement) {
  size_t count = 0;
  for (size_t k = 0; k < molecule->bonds; ++k) {
    const struct stated_bond *stated = &molecule->bond[k];
    uint32_t one, two;
    if (!find_atom(atoms, molecule->atoms, &stated->serial[0], &one)) continue;
    if (!find_atom(atoms, molecule->atoms, &stated->serial[1], &two) || one == two) continue;
    named[one] = named[two] = true;
    const bool back = one > two;
    statement[count++] = (struct statement){{{back ? two : one, back ? one : two}, stated->order}, stated->model, back};
  }
  qsort(statement, count, sizeof *statement, compare_statements);
  return count;
}

/* The order of a bond: the largest order stated, or the number of times that one end states it; more than three times
 * tell nothing. */
static void merge_statements(const struct statement *statement, size_t count, struct stated_bonds *bonds) {
  for (size_t k = 0, begin = 0; k < count; ++k) {
    const bool first = k == 0 || compare_bonds(&statement[k].bond, &statement[k - 1].bond) != 0;
    if (first) bonds->bond[bonds->count++] = (struct bond){{statement[k].bond.atom[0], statement[k].bond.atom[1]}, 0};
    if (first || statement[k].model != statement[begin].model || statement[k].back != statement[begin].back) begin = k;
    struct bond *const bond = &bonds->bond[bonds->count - 1];
    const size_t times = k - begin + 1;
    const enum bond_order order = statement[k].bond.order != BOND_UNKNOWN ? statement[k].bond.order
                                  : times <= BOND_TRIPLE                  ? (enum bond_order)times
                                                                          : BOND_UNKNOWN;
    if (order > bond->order) bond->order = order;
    if (times > BOND_TRIPLE && statement[k].bond.order == BOND_UNKNOWN) bond->order = BOND_SINGLE;
  }
}

bool stated_bonds_find(const struct molecule *molecule, struct stated_bonds *bonds) {
  struct numbered_atom *atoms = calloc((size_t)molecule->atoms + 1, sizeof *atoms);
  struct statement *statement = calloc(molecule->bonds + 1, sizeof *statement);
  bonds->count = 0;
  bonds->bond = calloc(molecule->bonds + 1, sizeof *bonds->bond);
  bonds->named = calloc((size_t)molecule->atoms + 1, sizeof *bonds->named);
  const bool enough = atoms != NULL && statement != NULL && bonds->bond != NULL && bonds->named != NULL;
  if (enough) {
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      atoms[i].serial = molecule->extra[i].serial;
      atoms[i].atom = i;
    }
    qsort(atoms, molecule->atoms, sizeof *atoms, compare_serials);
    merge_statements(statement, find_statements(molecule, atoms, bonds->named, statement), bonds);
  }
  free(atoms);
  free(statement);
  return enough;
}

void stated_bonds_free(struct stated_bonds *bonds) {
  free(bonds->bond);
  free(bonds->named);
}
