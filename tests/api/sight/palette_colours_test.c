/* Every colour of every palette. Jmol's colours stand here in decimal, from the table of another program that has them
 * as fractions (ASE, ase/data/colors.py); the palettes of this project in decimal as they were designed. */
#include <hardsphere.h>

#include "check.h"

typedef struct element {
  char symbol[3];
  double rgb[3];
} element;

/* Elements 1 to 109: Jmol knows no more. */
static const element jmol[] = {
    {"H", {255, 255, 255}},  {"He", {217, 255, 255}}, {"Li", {204, 128, 255}}, {"Be", {194, 255, 0}},
    {"B", {255, 181, 181}},  {"C", {144, 144, 144}},  {"N", {48, 80, 248}},    {"O", {255, 13, 13}},
    {"F", {144, 224, 80}},   {"Ne", {179, 227, 245}}, {"Na", {171, 92, 242}},  {"Mg", {138, 255, 0}},
    {"Al", {191, 166, 166}}, {"Si", {240, 200, 160}}, {"P", {255, 128, 0}},    {"S", {255, 255, 48}},
    {"Cl", {31, 240, 31}},   {"Ar", {128, 209, 227}}, {"K", {143, 64, 212}},   {"Ca", {61, 255, 0}},
    {"Sc", {230, 230, 230}}, {"Ti", {191, 194, 199}}, {"V", {166, 166, 171}},  {"Cr", {138, 153, 199}},
    {"Mn", {156, 122, 199}}, {"Fe", {224, 102, 51}},  {"Co", {240, 144, 160}}, {"Ni", {80, 208, 80}},
    {"Cu", {200, 128, 51}},  {"Zn", {125, 128, 176}}, {"Ga", {194, 143, 143}}, {"Ge", {102, 143, 143}},
    {"As", {189, 128, 227}}, {"Se", {255, 161, 0}},   {"Br", {166, 41, 41}},   {"Kr", {92, 184, 209}},
    {"Rb", {112, 46, 176}},  {"Sr", {0, 255, 0}},     {"Y", {148, 255, 255}},  {"Zr", {148, 224, 224}},
    {"Nb", {115, 194, 201}}, {"Mo", {84, 181, 181}},  {"Tc", {59, 158, 158}},  {"Ru", {36, 143, 143}},
    {"Rh", {10, 125, 140}},  {"Pd", {0, 105, 133}},   {"Ag", {192, 192, 192}}, {"Cd", {255, 217, 143}},
    {"In", {166, 117, 115}}, {"Sn", {102, 128, 128}}, {"Sb", {158, 99, 181}},  {"Te", {212, 122, 0}},
    {"I", {148, 0, 148}},    {"Xe", {66, 158, 176}},  {"Cs", {87, 23, 143}},   {"Ba", {0, 201, 0}},
    {"La", {112, 212, 255}}, {"Ce", {255, 255, 199}}, {"Pr", {217, 255, 199}}, {"Nd", {199, 255, 199}},
    {"Pm", {163, 255, 199}}, {"Sm", {143, 255, 199}}, {"Eu", {97, 255, 199}},  {"Gd", {69, 255, 199}},
    {"Tb", {48, 255, 199}},  {"Dy", {31, 255, 199}},  {"Ho", {0, 255, 156}},   {"Er", {0, 230, 117}},
    {"Tm", {0, 212, 82}},    {"Yb", {0, 191, 56}},    {"Lu", {0, 171, 36}},    {"Hf", {77, 194, 255}},
    {"Ta", {77, 166, 255}},  {"W", {33, 148, 214}},   {"Re", {38, 125, 171}},  {"Os", {38, 102, 150}},
    {"Ir", {23, 84, 135}},   {"Pt", {208, 208, 224}}, {"Au", {255, 209, 35}},  {"Hg", {184, 184, 208}},
    {"Tl", {166, 84, 77}},   {"Pb", {87, 89, 97}},    {"Bi", {158, 79, 181}},  {"Po", {171, 92, 0}},
    {"At", {117, 79, 69}},   {"Rn", {66, 130, 150}},  {"Fr", {66, 0, 102}},    {"Ra", {0, 125, 0}},
    {"Ac", {112, 171, 250}}, {"Th", {0, 186, 255}},   {"Pa", {0, 161, 255}},   {"U", {0, 143, 255}},
    {"Np", {0, 128, 255}},   {"Pu", {0, 107, 255}},   {"Am", {84, 92, 242}},   {"Cm", {120, 92, 227}},
    {"Bk", {138, 79, 227}},  {"Cf", {161, 54, 212}},  {"Es", {179, 31, 212}},  {"Fm", {179, 31, 186}},
    {"Md", {179, 13, 166}},  {"No", {189, 13, 135}},  {"Lr", {199, 0, 102}},   {"Rf", {204, 0, 89}},
    {"Db", {209, 0, 79}},    {"Sg", {217, 0, 69}},    {"Bh", {224, 0, 56}},    {"Hs", {230, 0, 46}},
    {"Mt", {235, 0, 38}}};
enum { ELEMENTS = sizeof jmol / sizeof jmol[0], BEYOND = 130 };

static const double jmol_unknown[3] = {255, 20, 147};
static const double soft_unknown[3] = {215, 166, 200};

typedef struct own_colour {
  uint32_t atomic_number;
  double rgb[3];
} own_colour;

/* Hydrogen, carbon, nitrogen, oxygen, phosphorus, sulphur, iron. */
static const own_colour soft[] = {{1, {251, 250, 247}}, {6, {210, 205, 195}}, {7, {134, 169, 242}}, {8, {242, 112, 92}},
                                  {15, {240, 160, 75}}, {16, {248, 214, 96}}, {26, {217, 130, 43}}};

enum { TINTS = 12 };
static const double tints[TINTS][3] = {{232, 160, 116}, {107, 160, 225}, {253, 220, 136}, {176, 211, 187},
                                       {196, 173, 206}, {111, 159, 151}, {206, 120, 93},  {193, 243, 189},
                                       {234, 211, 243}, {103, 191, 168}, {217, 194, 128}, {160, 153, 194}};

/* A colour with a share of another one mixed in. */
static uint32_t mixed(const double rgb[3], const double other[3], double share) {
  uint32_t colour = 0;
  int k;
  for (k = 0; k < 3; ++k) colour = 256 * colour + (uint32_t)(rgb[k] * (1 - share) + other[k] * share + 0.5);
  return colour;
}

static uint32_t plain(const double rgb[3]) {
  return mixed(rgb, rgb, 0);
}

static void by_element(void) {
  static const double light_grey[3] = {220, 216, 208};
  uint32_t number, k;
  CHECK_EQUAL(ELEMENTS, 109);
  for (number = 0; number <= BEYOND; ++number) {
    const int known = number > 0 && number <= ELEMENTS;
    uint32_t expected_jmol = plain(jmol_unknown), expected_soft = plain(soft_unknown);
    check_scene("element %u %s", (unsigned)number, known ? jmol[number - 1].symbol : "unknown");
    if (known) {
      expected_jmol = plain(jmol[number - 1].rgb);
      expected_soft = mixed(jmol[number - 1].rgb, light_grey, 0.5);
    }
    for (k = 0; k < sizeof soft / sizeof soft[0]; ++k) {
      if (soft[k].atomic_number == number) expected_soft = plain(soft[k].rgb);
    }
    for (k = 0; k < 2; ++k) { /* whatever the chain */
      CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_JMOL, number, 7 * k), expected_jmol);
      CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_SOFT, number, 7 * k), expected_soft);
      CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_CHAIN + 1, number, 7 * k), expected_soft);
      CHECK_EQUAL(hsp_palette_colour(HSP_NONE, number, 7 * k), expected_soft);
    }
  }
  check_scene("numbers of no element");
  CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_JMOL, HSP_NONE, 0), plain(jmol_unknown));
  CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_SOFT, HSP_NONE, 0), plain(soft_unknown));
}

static void by_chain(void) {
  static const double black[3] = {0, 0, 0};
  uint32_t chain, number;
  for (chain = 0; chain < 3 * TINTS; ++chain) {
    const double *tint = tints[chain % TINTS];
    check_scene("chain %u", (unsigned)chain);
    for (number = 0; number <= BEYOND; ++number) {
      CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_CHAIN, number, chain),
                  number == 6 ? plain(tint) : mixed(tint, black, 0.12));
    }
  }
  CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_CHAIN, 6, HSP_NONE), plain(tints[HSP_NONE % TINTS]));
}

int main(void) {
  by_element();
  by_chain();
  return check_report();
}
