#include "element_symbols.hpp"

#include "element_radii.hpp"

namespace hsp {
namespace {

constexpr char symbols[][3] = {
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",  "S",  "Cl",
    "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se",
    "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb",
    "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er",
    "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At",
    "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No",
    "Lr", "Rf", "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og",
};
static_assert(sizeof symbols / sizeof symbols[0] == element_count);

char with_case(char letter, char first, char made_first) {
  const char last = static_cast<char>(first + ('Z' - 'A'));
  return letter >= first && letter <= last ? static_cast<char>(letter - first + made_first) : letter;
}

}  // namespace

const char *element_symbol(uint32_t atomic_number) {
  return atomic_number < 1 || atomic_number > element_count ? "" : symbols[atomic_number - 1];
}

uint32_t element_number(const char *symbol) {
  while (*symbol == ' ') ++symbol;
  if (*symbol == '\0') return 0;
  const char first = with_case(*symbol++, 'a', 'A');
  const char second = *symbol == '\0' || *symbol == ' ' ? '\0' : with_case(*symbol++, 'A', 'a');
  while (*symbol == ' ') ++symbol;
  if (*symbol != '\0') return 0;
  if (first == 'D' && second == '\0') return 1;
  for (uint32_t number = 1; number <= element_count; ++number) {
    if (symbols[number - 1][0] == first && symbols[number - 1][1] == second) return number;
  }
  return 0;
}

}  // namespace hsp
