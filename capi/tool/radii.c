#include "radii.h"

#include <string.h>

#include "characters.h"

struct element_radius {
  char symbol[3];
  double radius;
};

struct radii_set {
  const char *name;
  const char *source;
  const struct element_radius *elements;
  size_t count;
};

/* Van der Waals radii.
 *   Main group: Mantina, Chamberlin, Valero, Cramer, Truhlar, "Consistent van der Waals radii for the whole main
 *   group", J. Phys. Chem. A 113 (2009) 5806, Table 12, which keeps the radii of
 *   Bondi, "Van der Waals volumes and radii", J. Phys. Chem. 68 (1964) 441, where he gives one (but for hydrogen, after
 *   Rowland and Taylor, J. Phys. Chem. 100 (1996) 7384) and adds the others.
 *   Ni Cu Zn Pd Ag Cd Au Hg U: Bondi 1964. Other transition metals have no radius there and none here. */
static const struct element_radius bondi_elements[] = {
    {"H", 1.10},  {"He", 1.40}, {"Li", 1.81}, {"Be", 1.53}, {"B", 1.92},  {"C", 1.70},  {"N", 1.55},  {"O", 1.52},
    {"F", 1.47},  {"Ne", 1.54}, {"Na", 2.27}, {"Mg", 1.73}, {"Al", 1.84}, {"Si", 2.10}, {"P", 1.80},  {"S", 1.80},
    {"Cl", 1.75}, {"Ar", 1.88}, {"K", 2.75},  {"Ca", 2.31}, {"Ga", 1.87}, {"Ge", 2.11}, {"As", 1.85}, {"Se", 1.90},
    {"Br", 1.83}, {"Kr", 2.02}, {"Rb", 3.03}, {"Sr", 2.49}, {"In", 1.93}, {"Sn", 2.17}, {"Sb", 2.06}, {"Te", 2.06},
    {"I", 1.98},  {"Xe", 2.16}, {"Cs", 3.43}, {"Ba", 2.68}, {"Tl", 1.96}, {"Pb", 2.02}, {"Bi", 2.07}, {"Po", 1.97},
    {"At", 2.02}, {"Rn", 2.20}, {"Fr", 3.48}, {"Ra", 2.83}, {"Ni", 1.63}, {"Cu", 1.40}, {"Zn", 1.39}, {"Pd", 1.63},
    {"Ag", 1.72}, {"Cd", 1.58}, {"Au", 1.66}, {"Hg", 1.55}, {"U", 1.86},
};

/* The radii of Halperin and Overmars, "Spheres, Molecules, and Hidden Surface Removal", UU-CS-1994-36, Section 2, who
 * took them from the modelling package Chem3D Plus. */
static const struct element_radius chem3d_elements[] = {
    {"C", 1.52}, {"Ca", 3.48}, {"H", 0.70}, {"N", 1.36}, {"O", 1.28}, {"P", 2.18}, {"S", 2.10},
};

const struct radii_set radii_bondi = {"bondi",
                                      "van der Waals radii of Bondi 1964, Rowland & Taylor 1996, Mantina et al. 2009",
                                      bondi_elements, sizeof bondi_elements / sizeof bondi_elements[0]};
const struct radii_set radii_chem3d = {"chem3d", "Chem3D Plus radii of Halperin & Overmars 1994", chem3d_elements,
                                       sizeof chem3d_elements / sizeof chem3d_elements[0]};

/* The symbols of the periodic table by atomic number, in two columns each. */
static const char symbols[] =
    "H HeLiBeB C N O F NeNaMgAlSiP S ClArK CaScTiV CrMnFeCoNiCuZnGaGeAsSeBrKrRbSrY ZrNbMoTcRuRhPdAgCdInSnSbTeI XeCs"
    "BaLaCePrNdPmSmEuGdTbDyHoErTmYbLuHfTaW ReOsIrPtAuHgTlPbBiPoAtRnFrRaAcThPaU NpPuAmCmBkCfEsFmMdNoLrRfDbSgBhHsMtDs"
    "RgCnNhFlMcLvTsOg";

bool element_symbol_parse(const char *text, size_t length, struct element_symbol *symbol) {
  if (length < 1 || length > 2 || !is_letter(text[0]) || (length == 2 && !is_letter(text[1]))) return false;
  symbol->text[0] = to_upper(text[0]);
  symbol->text[1] = length == 2 ? to_lower(text[1]) : '\0';
  symbol->text[2] = '\0';
  if (strcmp(symbol->text, "D") == 0) symbol->text[0] = 'H';
  return true;
}

uint32_t element_atomic_number(struct element_symbol symbol) {
  const char second = symbol.text[1] == '\0' ? ' ' : symbol.text[1];
  for (size_t at = 0; symbols[at] != '\0'; at += 2) {
    if (symbol.text[0] == symbols[at] && second == symbols[at + 1]) return (uint32_t)(at / 2 + 1);
  }
  return 0;
}

bool element_symbol_exists(struct element_symbol symbol) {
  return element_atomic_number(symbol) != 0;
}

static size_t place(struct element_symbol symbol) {
  const size_t second = symbol.text[1] == '\0' ? 0 : (size_t)(symbol.text[1] - 'a' + 1);
  return 27 * (size_t)(symbol.text[0] - 'A') + second;
}

const struct radii_set *radii_set_find(const char *name) {
  if (strcmp(name, radii_bondi.name) == 0) return &radii_bondi;
  if (strcmp(name, radii_chem3d.name) == 0) return &radii_chem3d;
  return NULL;
}

const char *radii_set_name(const struct radii_set *set) {
  return set->name;
}

const char *radii_set_source(const struct radii_set *set) {
  return set->source;
}

void radii_take_set(struct radii *radii, const struct radii_set *set) {
  for (size_t i = 0; i < sizeof radii->of / sizeof radii->of[0]; ++i) radii->of[i] = -1.0;
  for (size_t i = 0; i < set->count; ++i) {
    struct element_symbol symbol;
    if (element_symbol_parse(set->elements[i].symbol, strlen(set->elements[i].symbol), &symbol)) {
      radii_put(radii, symbol, set->elements[i].radius);
    }
  }
}

void radii_put(struct radii *radii, struct element_symbol symbol, double radius) {
  radii->of[place(symbol)] = radius;
}

bool radii_find(const struct radii *radii, struct element_symbol symbol, double *radius) {
  const double found = radii->of[place(symbol)];
  if (found < 0.0) return false;
  *radius = found;
  return true;
}
