/* Elements by symbol: all of the periodic table, in any case and with blanks around; what is no symbol is refused. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

/* By periods, as the table is printed. */
static const char table[] =
    "H He "
    "Li Be B C N O F Ne Na Mg Al Si P S Cl Ar "
    "K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn Ga Ge As Se Br Kr "
    "Rb Sr Y Zr Nb Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I Xe "
    "Cs Ba La Ce Pr Nd Pm Sm Eu Gd Tb Dy Ho Er Tm Yb Lu Hf Ta W Re Os Ir Pt Au Hg Tl Pb Bi Po At Rn "
    "Fr Ra Ac Th Pa U Np Pu Am Cm Bk Cf Es Fm Md No Lr Rf Db Sg Bh Hs Mt Ds Rg Cn Nh Fl Mc Lv Ts Og ";

static void check_number(const char *symbol, uint32_t expected) {
  uint32_t number;
  FILL(number);
  check_scene("symbol '%s'", symbol);
  CHECK_EQUAL(hsp_element_number(symbol, &number), expected == 0 ? HSP_E_ID : HSP_OK);
  if (expected == 0) {
    CHECK_UNTOUCHED(number);
  } else {
    CHECK_EQUAL(number, expected);
  }
}

static char other_case(char letter) {
  return (char)(letter ^ ('a' ^ 'A'));
}

/* The symbol as it is, in all cases of its letters, and with blanks. */
static void every_element(void) {
  const char *at = table;
  uint32_t number = 0;
  while (*at != '\0') {
    const size_t length = strcspn(at, " ");
    char symbol[8] = {0};
    ++number;
    memcpy(symbol, at, length);
    CHECK(strcmp(hsp_element_symbol(number), symbol) == 0);
    check_number(symbol, number);
    symbol[0] = other_case(symbol[0]);
    check_number(symbol, number);
    if (length == 2) symbol[1] = other_case(symbol[1]);
    check_number(symbol, number);
    symbol[0] = other_case(symbol[0]);
    check_number(symbol, number);
    memset(symbol, 0, sizeof symbol);
    memcpy(symbol, "   ", 3);
    memcpy(symbol + 3 - length, at, length); /* as in columns 77 and 78 of a PDB file */
    memcpy(symbol + 3, "  ", 2);
    check_number(symbol, number);
    at += length + 1;
  }
  CHECK_EQUAL(number, 118);
  check_number("D", 1);
  check_number(" d ", 1);
}

/* All texts of up to two bytes, 0 in them left out. */
static void every_short_text(void) {
  uint32_t found = 0;
  unsigned first, second;
  for (first = 1; first < 256; ++first) {
    for (second = 0; second < 256; ++second) {
      char text[3] = {0};
      uint32_t number = 0;
      text[0] = (char)first;
      text[1] = (char)second;
      if (hsp_element_number(text, &number) != HSP_OK) continue;
      ++found;
      CHECK(number >= 1 && number <= 118);
    }
  }
  check_scene("all texts of one or two bytes");
  /* Of 14 symbols of one letter and D each case alone, before and behind a blank; of the others each case of both. */
  CHECK_EQUAL(found, (14 + 1) * 2 * 3 + (118 - 14) * 4);
}

static void no_symbols(void) {
  static const char *const no_symbol[] = {"",    " ",   "X",   "Xx",     "J",        "C1", "1",   "Fe2", "Fe+",
                                          "C C", "F e", "HHe", "Carbon", "\xC3\xA9", "\t", "C\n", "*",   "DT"};
  static const uint32_t no_number[] = {0, 119, 256 + 6, HSP_NONE};
  size_t i;
  for (i = 0; i < sizeof no_symbol / sizeof no_symbol[0]; ++i) check_number(no_symbol[i], 0);
  check_scene("numbers of no element");
  for (i = 0; i < sizeof no_number / sizeof no_number[0]; ++i) CHECK(hsp_element_symbol(no_number[i])[0] == '\0');
}

int main(void) {
  every_element();
  every_short_text();
  no_symbols();
  return check_report();
}
