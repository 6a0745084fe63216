#include "read/cif_crystal.h"

#include <math.h>
#include <string.h>

#include "read/number.h"

/* Take the name of the space group, unless there is one of an earlier kind, in the order of enum cif_item. A number of
 * the International Tables is made a name. */
static bool take_name(struct cif_crystal *crystal, enum cif_item item, struct field name, struct symmetry *symmetry) {
  static const char before[] = "No. ";
  if (name.length == 0 || (crystal->named && item > crystal->name)) return true;
  const bool number = item == CIF_SPACE_GROUP_NUMBER, first = number && field_is(name, "1");
  const size_t lead = number && !first ? sizeof before - 1 : 0;
  crystal->named = true;
  crystal->name = item;
  memcpy(symmetry->space_group, before, lead);
  label_copy(symmetry->space_group + lead, sizeof symmetry->space_group - lead,
             first ? (struct field){"P 1", 3} : name);
  return true;
}

bool cif_crystal_take(struct cif_crystal *crystal, enum cif_item item, const struct cif_tokens *tokens,
                      struct symmetry *symmetry, struct failure *failure) {
  static const char *const names[6] = {"a", "b", "c", "alpha", "beta", "gamma"};
  if (item == CIF_OTHER_ITEM) return true;
  if (cif_value_is_absent(tokens)) {
    const bool of_cell = item >= CIF_CELL_A && item <= CIF_CELL_GAMMA;
    if (of_cell && tokens->text.text[0] == '?') crystal->unknown[(int)item - (int)CIF_CELL_A] = true;
    return true;
  }
  if (item == CIF_OPERATOR) return symmetry_take_triplet(symmetry, tokens->text, failure);
  if (item >= CIF_SPACE_GROUP && item <= CIF_SPACE_GROUP_NUMBER) {
    return take_name(crystal, item, tokens->text, symmetry);
  }
  const int k = (int)item - (int)CIF_CELL_A;
  crystal->has[k] = true;
  return field_number(cif_without_uncertainty(tokens->text), names[k], &crystal->cell[k], tokens->line, failure);
}

static size_t decimals_of(struct field number) {
  const char *point = number.length == 0 ? NULL : memchr(number.text, '.', number.length);
  return point == NULL ? 0 : (size_t)(number.text + number.length - point) - 1;
}

bool cif_crystal_fraction(struct field text, const char *name, double *value, unsigned char *digits, uint64_t line,
                          struct failure *failure) {
  enum { LEAST = 4, MOST = 15, FAR = 1000000 };
  const struct field number = cif_without_uncertainty(text);
  if (!field_number(number, name, value, line, failure)) return false;
  const size_t decimals = decimals_of(number);
  *digits = (unsigned char)(decimals < MOST ? decimals : MOST);
  const double sixth = round(*value * 6.0) / 6.0;
  const double power = pow(10.0, (double)decimals);
  if (decimals < LEAST || decimals > MOST || !(fabs(*value) < FAR) || round(sixth * power) != round(*value * power))
    return true;
  *value = sixth;
  return true;
}

bool cif_crystal_keeps(struct cif_crystal *crystal, const struct cif_row *row, bool *keep, struct failure *failure) {
  char assembly[8], group[8];
  label_copy(assembly, sizeof assembly, cif_row_get(row, CIF_DISORDER_ASSEMBLY));
  label_copy(group, sizeof group, cif_row_get(row, CIF_DISORDER_GROUP));
  *keep = true;
  if (group[0] == '\0') return true;
  size_t at = 0;
  while (at < crystal->assemblies && strcmp(crystal->assembly[at], assembly) != 0) ++at;
  if (at == CIF_MOST_ASSEMBLIES) {
    return failure_in_input(failure, row->line, "more than %d disorder assemblies", (int)CIF_MOST_ASSEMBLIES);
  }
  if (at == crystal->assemblies) {
    memcpy(crystal->assembly[at], assembly, sizeof assembly);
    memcpy(crystal->group[at], group, sizeof group);
    ++crystal->assemblies;
  }
  *keep = strcmp(crystal->group[at], group) == 0;
  return true;
}

bool cif_crystal_finish(const struct cif_crystal *crystal, bool fractional, struct molecule *molecule,
                        struct failure *failure) {
  struct box_record *box = &molecule->frame.box;
  bool whole = true;
  double angle[3];
  for (int k = 0; k < 6; ++k) whole = whole && (crystal->has[k] || (k >= 3 && !crystal->unknown[k]));
  for (int k = 0; k < 3; ++k) angle[k] = crystal->has[3 + k] ? crystal->cell[3 + k] : 90.0;
  if (whole) box_from_angles(crystal->cell, angle, box);
  if (!fractional) return true;
  if (!whole) return failure_in_input(failure, 0, "fractional coordinates, but no cell: _cell_length_a and the like");
  if (!box->given) return failure_in_input(failure, 0, "fractional coordinates, but the cell is none");
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    double *xyz = molecule->xyz + 3 * (size_t)i;
    const double fraction[3] = {xyz[0], xyz[1], xyz[2]};
    box_point(box, fraction, xyz);
    for (int k = 0; k < 3; ++k) {
      if (!is_finite(xyz[k])) return failure_in_input(failure, molecule->line[i], "a coordinate is too large");
    }
  }
  return true;
}
