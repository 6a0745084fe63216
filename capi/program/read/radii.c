#include "read/radii.h"

#include <string.h>

#include "hardsphere.h"
#include "read/characters.h"

/* The numbers are in the library. */
struct radii_set {
  const char *name;
  const char *source;
  uint32_t elements; /* HSP_RADII_* */
  uint32_t residues; /* HSP_RADII_*, or HSP_NONE */
};

const struct radii_set radii_bondi = {"bondi",
                                      "van der Waals radii of Bondi 1964, Rowland & Taylor 1996, Mantina et al. 2009",
                                      HSP_RADII_BONDI, HSP_NONE};
static const struct radii_set radii_chem3d = {"chem3d", "Chem3D Plus radii of Halperin & Overmars 1994",
                                              HSP_RADII_CHEM3D, HSP_NONE};
static const struct radii_set radii_uff = {
    "uff", "sigma / 2 of the universal force field, Rappe et al. 1992, as for porous crystals", HSP_RADII_UFF,
    HSP_NONE};
static const struct radii_set radii_protor = {
    "protor", "radii of Tsai et al. 1999 for heavy atoms, classed as by FreeSASA", HSP_RADII_BONDI, HSP_RADII_PROTOR};
static const struct radii_set radii_naccess = {
    "naccess", "radii of Chothia 1976 for heavy atoms of proteins, as in NACCESS", HSP_RADII_BONDI, HSP_RADII_NACCESS};

static const struct radii_set *const sets[] = {&radii_bondi, &radii_chem3d, &radii_uff, &radii_protor, &radii_naccess};

/* Of an atom whose element is unknown: what the library gives elements that no set has a radius for. */
static const double unknown_radius = 2.0;

bool element_symbol_parse(const char *text, size_t length, struct element_symbol *symbol) {
  if (length < 1 || length > 2 || !is_letter(text[0]) || (length == 2 && !is_letter(text[1]))) return false;
  symbol->text[0] = to_upper(text[0]);
  symbol->text[1] = length == 2 ? to_lower(text[1]) : '\0';
  symbol->text[2] = '\0';
  if (strcmp(symbol->text, "D") == 0 || strcmp(symbol->text, "T") == 0) symbol->text[0] = 'H';
  return true;
}

uint32_t element_atomic_number(struct element_symbol symbol) {
  uint32_t number = 0;
  return hsp_element_number(symbol.text, &number) == HSP_OK ? number : 0;
}

bool element_symbol_of_number(uint64_t number, struct element_symbol *symbol) {
  const char *const text = number > UINT32_MAX ? "" : hsp_element_symbol((uint32_t)number);
  return element_symbol_parse(text, strlen(text), symbol);
}

bool element_symbol_exists(struct element_symbol symbol) {
  return element_atomic_number(symbol) != 0;
}

const struct element_symbol element_unknown = {"X"};

bool element_is_unknown(struct element_symbol symbol) {
  return strcmp(symbol.text, element_unknown.text) == 0;
}

static size_t place(struct element_symbol symbol) {
  const size_t second = symbol.text[1] == '\0' ? 0 : (size_t)(symbol.text[1] - 'a' + 1);
  return 27 * (size_t)(symbol.text[0] - 'A') + second;
}

const struct radii_set *radii_set_at(size_t i) {
  return i < sizeof sets / sizeof sets[0] ? sets[i] : NULL;
}

const struct radii_set *radii_set_find(const char *name) {
  size_t i = 0;
  while (radii_set_at(i) != NULL && strcmp(radii_set_at(i)->name, name) != 0) ++i;
  return radii_set_at(i);
}

uint32_t radii_set_residues(const struct radii_set *set) {
  return set->residues;
}

const char *radii_set_name(const struct radii_set *set) {
  return set->name;
}

const char *radii_set_source(const struct radii_set *set) {
  return set->source;
}

void radii_take_set(struct radii *radii, const struct radii_set *set) {
  for (size_t i = 0; i < sizeof radii->of / sizeof radii->of[0]; ++i) {
    radii->of[i] = -1.0;
    radii->substitute[i] = false;
    radii->given[i] = false;
  }
  struct element_symbol symbol;
  for (uint32_t number = 1; element_symbol_of_number(number, &symbol); ++number) {
    double radius;
    uint32_t flags;
    if (hsp_element_radius(set->elements, number, &radius, &flags) != HSP_OK) continue;
    radii_put(radii, symbol, radius);
    radii->substitute[place(symbol)] = (flags & HSP_RADIUS_FALLBACK) != 0;
    radii->given[place(symbol)] = false;
  }
  radii->of[place(element_unknown)] = unknown_radius;
  radii->substitute[place(element_unknown)] = true;
}

void radii_put(struct radii *radii, struct element_symbol symbol, double radius) {
  radii->of[place(symbol)] = radius;
  radii->substitute[place(symbol)] = false;
  radii->given[place(symbol)] = true;
}

bool radii_find(const struct radii *radii, struct element_symbol symbol, double *radius) {
  if (symbol.text[0] == '\0') return false;
  const double found = radii->of[place(symbol)];
  if (found < 0.0) return false;
  *radius = found;
  return true;
}

bool radii_is_substitute(const struct radii *radii, struct element_symbol symbol) {
  return symbol.text[0] != '\0' && radii->substitute[place(symbol)];
}

bool radii_is_given(const struct radii *radii, struct element_symbol symbol) {
  return symbol.text[0] != '\0' && radii->given[place(symbol)];
}
