#include "commands/polarity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/bonds.h"
#include "read/geometry.h"

static bool is_one_of(struct element_symbol element, const char *const symbols[3]) {
  for (int i = 0; i < 3; ++i) {
    if (strcmp(element.text, symbols[i]) == 0) return true;
  }
  return false;
}

/* Hydrogens that are bound to each other say nothing. */
static void follow_bonds(struct molecule *molecule, const struct bond *bonds, uint32_t count, double *nearest) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) nearest[i] = HUGE_VAL;
  for (uint32_t k = 0; k < count; ++k) {
    const double length = atoms_squared_distance(molecule, bonds[k].atom[0], bonds[k].atom[1]);
    for (int end = 0; end < 2; ++end) {
      const uint32_t atom = bonds[k].atom[end];
      struct atom_label *const label = &molecule->label[atom];
      const struct atom_label *const other = &molecule->label[bonds[k].atom[1 - end]];
      if (!atom_is_hydrogen(label) || atom_is_hydrogen(other) || !(length < nearest[atom])) continue;
      nearest[atom] = length;
      label->polar = other->polar;
      label->apolar = other->apolar;
    }
  }
}

bool polarity_find(struct molecule *molecule, struct failure *failure) {
  static const char *const polar[3] = {"N", "O", "O"}, *const apolar[3] = {"C", "S", "Se"};
  struct geometry geometry = {.work = {0}};
  struct bond *bonds = NULL;
  uint32_t count = 0;
  bool hydrogens = false;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    struct atom_label *const label = &molecule->label[i];
    label->polar = is_one_of(label->element, polar);
    label->apolar = is_one_of(label->element, apolar);
    hydrogens = hydrogens || atom_is_hydrogen(label);
  }
  if (!hydrogens) return true;
  double *const nearest = malloc(molecule->atoms * sizeof *nearest);
  bool done = nearest != NULL || failure_of_memory(failure);
  done = done && bonds_find(molecule, &geometry, &bonds, &count, failure);
  if (done) follow_bonds(molecule, bonds, count, nearest);
  free(bonds);
  free(nearest);
  geometry_free(&geometry);
  return done;
}
