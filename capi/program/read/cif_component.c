#include "read/cif_component.h"

#include <stdlib.h>
#include <string.h>

static const struct {
  const char *name[3];
  enum cif_item first; /* y and z follow */
} sets[CIF_SETS] = {{{"pdbx_model_Cartn_x_ideal", "pdbx_model_Cartn_y_ideal", "pdbx_model_Cartn_z_ideal"}, CIF_IDEAL_X},
                    {{"model_Cartn_x", "model_Cartn_y", "model_Cartn_z"}, CIF_MODEL_X},
                    {{"x", "y", "z"}, CIF_PLAIN_X}};

/* SING, DOUB, as the Protein Data Bank has them; single, double, aromatic, deloc in libraries of monomers. */
static enum bond_order order_of(struct field word) {
  static const struct {
    const char *begin;
    enum bond_order order;
  } orders[] = {{"SING", BOND_SINGLE},
                {"DOUB", BOND_DOUBLE},
                {"TRIP", BOND_TRIPLE},
                {"AROM", BOND_AROMATIC},
                {"DELO", BOND_AROMATIC}};
  for (size_t k = 0; word.length >= 4 && k < sizeof orders / sizeof orders[0]; ++k) {
    if (field_is((struct field){word.text, 4}, orders[k].begin)) return orders[k].order;
  }
  return BOND_SINGLE;
}

bool cif_component_take_bond(const struct cif_row *row, struct molecule *molecule, struct failure *failure) {
  if ((molecule->keeps & KEEP_EXTRAS) == 0) return true;
  if (row->text.out_of_memory) return failure_of_memory(failure);
  struct stated_bond bond = {.order = order_of(cif_row_get(row, CIF_BOND_ORDER)), .model = 0};
  label_copy(bond.component, sizeof bond.component, cif_row_get(row, CIF_BOND_COMPONENT));
  for (int end = 0; end < 2; ++end) {
    const struct field name = cif_row_get(row, (enum cif_item)(CIF_BOND_FIRST + end));
    if (name.length == 0 || name.length >= sizeof bond.serial[end].text) return true; /* found by distance */
    label_copy(bond.serial[end].text, sizeof bond.serial[end].text, name);
  }
  return molecule_add_bond(molecule, &bond, failure);
}

void cif_component_choose_bonds(struct molecule *molecule) {
  size_t chosen = 0;
  for (size_t k = 0; molecule->atoms > 0 && k < molecule->bonds; ++k) {
    const struct stated_bond *const bond = &molecule->bond[k];
    if (bond->component[0] != '\0' && strcmp(bond->component, molecule->label[0].residue->name) != 0) continue;
    molecule->bond[chosen++] = *bond;
  }
  molecule->bonds = chosen;
}

static bool grow(struct cif_component *component, struct failure *failure) {
  const size_t capacity = component->capacity == 0 ? 64 : 2 * component->capacity;
  for (int set = 0; set < CIF_SETS; ++set) {
    double *grown =
        capacity > SIZE_MAX / (3 * sizeof *grown) ? NULL : realloc(component->xyz[set], capacity * 3 * sizeof *grown);
    if (grown == NULL) return failure_of_memory(failure);
    component->xyz[set] = grown;
  }
  component->capacity = capacity;
  return true;
}

bool cif_component_take(struct cif_component *component, const struct cif_row *row, struct failure *failure) {
  if (component->atoms == component->capacity && !grow(component, failure)) return false;
  const size_t atom = component->atoms++;
  for (int set = 0; set < CIF_SETS; ++set) {
    for (int axis = 0; axis < 3; ++axis) {
      double *value = &component->xyz[set][3 * atom + (size_t)axis];
      const struct field number = cif_row_get(row, (enum cif_item)((int)sets[set].first + axis));
      *value = 0.0;
      component->broken[set] = component->broken[set] || number.length == 0;
      if (number.length > 0 &&
          !field_number(cif_without_uncertainty(number), sets[set].name[axis], value, row->line, failure))
        return false;
    }
  }
  return true;
}

bool cif_component_finish(const struct cif_component *component, struct molecule *molecule, struct failure *failure) {
  for (int set = 0; set < CIF_SETS; ++set) {
    if (component->broken[set]) continue;
    molecule->coordinates = sets[set].name[0];
    if (molecule->atoms > 0) {
      memcpy(molecule->xyz, component->xyz[set], molecule->atoms * 3 * sizeof *molecule->xyz);
    }
    return true;
  }
  return failure_in_input(failure, 0, "a chemical component without a whole set of coordinates");
}

void cif_component_free(struct cif_component *component) {
  for (int set = 0; set < CIF_SETS; ++set) free(component->xyz[set]);
  memset(component, 0, sizeof *component);
}
