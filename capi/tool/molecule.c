#include "molecule.h"

#include <stdlib.h>
#include <string.h>

#include "hardsphere.h"

void molecule_init(struct molecule *molecule, enum molecule_format format) {
  molecule->format = format;
  molecule->atoms = 0;
  molecule->capacity = 0;
  molecule->xyz = NULL;
  molecule->radius = NULL;
  molecule->line = NULL;
  molecule->label = NULL;
}

static bool grow(struct molecule *molecule) {
  const size_t capacity = molecule->capacity == 0 ? 256 : 2 * (size_t)molecule->capacity;
  if (capacity > SIZE_MAX / (4 * sizeof(struct atom_label))) return false;
  double *xyz = realloc(molecule->xyz, capacity * sizeof *xyz * 3);
  if (xyz != NULL) molecule->xyz = xyz;
  double *radius = realloc(molecule->radius, capacity * sizeof *radius);
  if (radius != NULL) molecule->radius = radius;
  uint64_t *line = realloc(molecule->line, capacity * sizeof *line);
  if (line != NULL) molecule->line = line;
  struct atom_label *label = realloc(molecule->label, capacity * sizeof *label);
  if (label != NULL) molecule->label = label;
  if (xyz == NULL || radius == NULL || line == NULL || label == NULL) return false;
  molecule->capacity = (uint32_t)capacity; /* at most twice HSP_MAX_BALLS */
  return true;
}

bool molecule_add(struct molecule *molecule, const double xyz[3], double radius, const struct atom_label *label,
                  uint64_t line, struct failure *failure) {
  if (molecule->atoms == HSP_MAX_BALLS) {
    return failure_in_input(failure, line, "more than %lu atoms", (unsigned long)HSP_MAX_BALLS);
  }
  if (molecule->atoms == molecule->capacity && !grow(molecule)) return failure_of_memory(failure);
  const size_t atom = molecule->atoms++;
  memcpy(molecule->xyz + 3 * atom, xyz, 3 * sizeof *xyz);
  molecule->radius[atom] = radius;
  molecule->line[atom] = line;
  molecule->label[atom] = *label;
  return true;
}

bool molecule_add_element(struct molecule *molecule, const double xyz[3], const struct radii *radii,
                          const struct atom_label *label, uint64_t line, struct failure *failure) {
  double radius;
  if (radii_find(radii, label->element, &radius)) {
    return molecule_add(molecule, xyz, radius, label, line, failure);
  }
  if (!element_symbol_exists(label->element)) {
    return failure_in_input(failure, line, "unknown element '%s'; give it a radius with --radius %s=R",
                            label->element.text, label->element.text);
  }
  return failure_in_input(failure, line, "element '%s' has no radius in this set; give it one with --radius %s=R",
                          label->element.text, label->element.text);
}

void molecule_free(struct molecule *molecule) {
  free(molecule->xyz);
  free(molecule->radius);
  free(molecule->line);
  free(molecule->label);
  molecule_init(molecule, molecule->format);
}

void label_copy(char *out, size_t room, struct field text) {
  const size_t length = text.length < room ? text.length : room - 1;
  memcpy(out, text.text, length);
  out[length] = '\0';
}

bool format_has_radii(enum molecule_format format) {
  return format == FORMAT_XYZR || format == FORMAT_PQR;
}

bool format_has_residues(enum molecule_format format) {
  return format == FORMAT_PDB || format == FORMAT_PQR;
}

const char *format_unit(enum molecule_format format) {
  return format == FORMAT_XYZR ? "unit" : "angstrom";
}
