#include "read/radii_list.h"

#include <string.h>

#include "hardsphere.h"
#include "read/radii.h"
#include "read/radii_table.h"

static void print_element(struct text_buffer *out, const struct radii *radii, size_t count,
                          struct element_symbol symbol) {
  text_buffer_add(out, "  %-8s", symbol.text);
  for (size_t i = 0; i < count; ++i) {
    double radius = 0.0;
    radii_find(&radii[i], symbol, &radius);
    const bool hundredths = (double)(int)(100.0 * radius + 0.5) / 100.0 == radius;
    text_buffer_add(out, "  %7.*f%s", hundredths ? 2 : 4, radius,
                    radii_is_substitute(&radii[i], symbol) ? "*"
                    : i + 1 < count                        ? " "
                                                           : "");
  }
  text_buffer_add(out, "\n");
}

static void print_elements(struct text_buffer *out) {
  struct radii radii[8];
  size_t count = 0;
  text_buffer_add(out,
                  "\nBy element, in angstrom; * the set has none, and takes this one instead; X is unknown:\n  %-8s",
                  "element");
  for (size_t i = 0; radii_set_at(i) != NULL; ++i) {
    const struct radii_set *set = radii_set_at(i);
    if (radii_set_residues(set) != HSP_NONE) continue;
    text_buffer_add(out, "  %7s ", radii_set_name(set));
    radii_take_set(&radii[count++], set);
  }
  text_buffer_add(out, "\n");
  struct element_symbol symbol;
  for (uint32_t number = 1; element_symbol_of_number(number, &symbol); ++number) {
    print_element(out, radii, count, symbol);
  }
  print_element(out, radii, count, element_unknown);
}

static bool print_residues(const struct radii_set *set, struct text_buffer *out, struct failure *failure) {
  struct radii_table table = RADII_TABLE_NONE;
  const bool made = radii_table_make(&table, radii_set_residues(set), failure);
  radii_table_sort(&table);
  const char *residue, *atom;
  const char *before = "";
  double radius;
  if (made) text_buffer_add(out, "\n%s, in angstrom, by residue and atom:", radii_set_name(set));
  for (size_t i = 0; made && radii_table_get(&table, i, &residue, &atom, &radius); ++i) {
    if (strcmp(residue, before) != 0) text_buffer_add(out, "\n  %-4s", residue);
    text_buffer_add(out, " %s %.2f", atom, radius);
    before = residue;
  }
  text_buffer_add(out, "\n");
  radii_table_free(&table);
  return made;
}

bool radii_list_print(struct text_buffer *out, struct failure *failure) {
  text_buffer_add(out, "Sets for --radii:\n");
  for (size_t i = 0; radii_set_at(i) != NULL; ++i) {
    const struct radii_set *set = radii_set_at(i);
    text_buffer_add(out, "  %-8s %s\n", radii_set_name(set), radii_set_source(set));
  }
  print_elements(out);
  for (size_t i = 0; radii_set_at(i) != NULL; ++i) {
    const struct radii_set *set = radii_set_at(i);
    if (radii_set_residues(set) != HSP_NONE && !print_residues(set, out, failure)) return false;
  }
  return true;
}
