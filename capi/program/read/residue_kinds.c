#include "read/residue_kinds.h"

#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/words.h"

enum { NAME_BYTES = 8 };

struct known_residue {
  char name[5];
  unsigned char kind;
};

enum { A = RESIDUE_AMINO_ACID, N = RESIDUE_NUCLEOTIDE, W = RESIDUE_WATER };

/* In the order of strcmp. */
static const struct known_residue residues[] = {
    {"A", N},    {"A3", N},   {"A5", N},   {"ACE", A},  {"ADE", N},  {"ALA", A},  {"ALY", A}, {"ARG", A}, {"ARN", A},
    {"ASH", A},  {"ASN", A},  {"ASP", A},  {"ASPH", A}, {"ASX", A},  {"C", N},    {"C3", N},  {"C5", N},  {"CME", A},
    {"CSE", A},  {"CSO", A},  {"CYM", A},  {"CYN", A},  {"CYS", A},  {"CYSH", A}, {"CYT", N}, {"CYX", A}, {"D2O", W},
    {"DA", N},   {"DA3", N},  {"DA5", N},  {"DAN", N},  {"DC", N},   {"DC3", N},  {"DC5", N}, {"DCN", N}, {"DG", N},
    {"DG3", N},  {"DG5", N},  {"DGN", N},  {"DI", N},   {"DOD", W},  {"DT", N},   {"DT3", N}, {"DT5", N}, {"DTN", N},
    {"DU", N},   {"FOR", A},  {"G", N},    {"G3", N},   {"G5", N},   {"GLH", A},  {"GLN", A}, {"GLU", A}, {"GLUH", A},
    {"GLX", A},  {"GLY", A},  {"GUA", N},  {"H2O", W},  {"HID", A},  {"HIE", A},  {"HIP", A}, {"HIS", A}, {"HISD", A},
    {"HISE", A}, {"HISH", A}, {"HOH", W},  {"HSD", A},  {"HSE", A},  {"HSP", A},  {"HYP", A}, {"I", N},   {"ILE", A},
    {"KCX", A},  {"LEU", A},  {"LYN", A},  {"LYS", A},  {"LYSH", A}, {"M3L", A},  {"MET", A}, {"MLY", A}, {"MSE", A},
    {"NH2", A},  {"NHE", A},  {"NMA", A},  {"NME", A},  {"OPC", W},  {"PCA", A},  {"PHE", A}, {"PRO", A}, {"PTR", A},
    {"RA", N},   {"RA3", N},  {"RA5", N},  {"RC", N},   {"RC3", N},  {"RC5", N},  {"RG", N},  {"RG3", N}, {"RG5", N},
    {"RU", N},   {"RU3", N},  {"RU5", N},  {"SEC", A},  {"SEP", A},  {"SER", A},  {"SOL", W}, {"SPC", W}, {"SPCE", W},
    {"SWM4", W}, {"T", N},    {"T3P", W},  {"T4P", W},  {"T5P", W},  {"THR", A},  {"THY", N}, {"TIP", W}, {"TIP2", W},
    {"TIP3", W}, {"TIP4", W}, {"TIP5", W}, {"TP3", W},  {"TP4", W},  {"TP5", W},  {"TPO", A}, {"TRP", A}, {"TYM", A},
    {"TYR", A},  {"U", N},    {"U3", N},   {"U5", N},   {"UNK", A},  {"URA", N},  {"VAL", A}, {"WAT", W},
};

static void to_capitals(char out[NAME_BYTES], const char *name, size_t length) {
  size_t at = 0;
  for (; at < length && at + 1 < NAME_BYTES; ++at) out[at] = to_upper(name[at]);
  out[at] = '\0';
}

static int order_of_names(const void *name, const void *residue) {
  return strcmp(name, ((const struct known_residue *)residue)->name);
}

static enum residue_kind kind_of_capitals(const char *name) {
  const struct known_residue *found =
      bsearch(name, residues, sizeof residues / sizeof residues[0], sizeof residues[0], order_of_names);
  return found == NULL ? RESIDUE_OTHER : (enum residue_kind)found->kind;
}

enum residue_kind residue_kind_of(const char *name) {
  char capitals[NAME_BYTES];
  to_capitals(capitals, name, strlen(name));
  const enum residue_kind kind = kind_of_capitals(capitals);
  /* Amber calls residues at the ends of chains NALA and CALA. */
  const bool end = kind == RESIDUE_OTHER && strlen(capitals) == 4 && (capitals[0] == 'N' || capitals[0] == 'C');
  return end && kind_of_capitals(capitals + 1) == RESIDUE_AMINO_ACID ? RESIDUE_AMINO_ACID : kind;
}

bool is_virtual_symbol(struct element_symbol symbol) {
  static const char *const symbols[] = {"Ep", "Lp", "M", "Mw"};
  for (size_t i = 0; i < sizeof symbols / sizeof symbols[0]; ++i) {
    if (strcmp(symbol.text, symbols[i]) == 0) return true;
  }
  return false;
}

/* The letters of a name in capitals, without digits and signs. */
static void letters_of(char out[NAME_BYTES], const char *name, size_t length) {
  size_t count = 0;
  for (size_t i = 0; i < length && count + 1 < NAME_BYTES; ++i) {
    if (is_letter(name[i])) out[count++] = to_upper(name[i]);
  }
  out[count] = '\0';
}

struct element_symbol virtual_symbol_of(struct field name) {
  char letters[NAME_BYTES];
  letters_of(letters, name.text, name.length);
  struct element_symbol symbol = {""};
  if (letters[0] == 'M' || strcmp(letters, "OM") == 0) return (struct element_symbol){"M"};
  if (strlen(letters) >= 2 && element_symbol_parse(letters, 2, &symbol) && is_virtual_symbol(symbol)) return symbol;
  return (struct element_symbol){""};
}

static bool ion_of(struct field name, const char *residue, struct element_symbol *element) {
  static const char *const aliases[][2] = {{"SOD", "Na"}, {"CLA", "Cl"}, {"POT", "K"},  {"CAL", "Ca"}, {"CES", "Cs"},
                                           {"LIT", "Li"}, {"RUB", "Rb"}, {"BAR", "Ba"}, {"CAD", "Cd"}};
  char letters[NAME_BYTES];
  char of_residue[NAME_BYTES];
  letters_of(letters, name.text, name.length);
  letters_of(of_residue, residue, strlen(residue));
  if (letters[0] == '\0' || (strcmp(letters, of_residue) != 0 && strcmp(of_residue, "ION") != 0)) return false;
  for (size_t i = 0; i < sizeof aliases / sizeof aliases[0]; ++i) {
    if (strcmp(letters, aliases[i][0]) == 0) return element_symbol_parse(aliases[i][1], strlen(aliases[i][1]), element);
  }
  return element_symbol_parse(letters, strlen(letters), element) && element_symbol_exists(*element);
}

/* Whether an amino acid or nucleotide has sulfur. */
static bool has_sulfur(const char *residue) {
  static const char *const names[] = {"CME",  "CSE", "CSO", "CYM", "CYN", "CYS",
                                      "CYSH", "CYX", "MET", "MSE", "SEC", "UNK"};
  char capitals[NAME_BYTES];
  to_capitals(capitals, residue, strlen(residue));
  /* At the end of a chain: NCYS. */
  const char *name = capitals;
  if (strlen(name) == 4 && kind_of_capitals(name) == RESIDUE_OTHER) ++name;
  for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
    if (strcmp(name, names[i]) == 0) return true;
  }
  return false;
}

bool is_bead_name(const char *name, const char *residue) {
  const enum residue_kind kind = residue_kind_of(residue);
  char capitals[NAME_BYTES];
  to_capitals(capitals, name, strlen(name));
  const bool backbone = strncmp(capitals, "BB", 2) == 0 && !is_letter(capitals[2]);
  const bool side = strncmp(capitals, "SC", 2) == 0 && is_digit(capitals[2]);
  return (kind == RESIDUE_AMINO_ACID || kind == RESIDUE_NUCLEOTIDE) && (backbone || side);
}

/* In a known residue; name in capitals, from its first letter on. ATOM_UNKNOWN: the name is none of such a residue. */
static enum atom_kind kind_in_residue(const char *name, enum residue_kind kind, const char *residue,
                                      struct element_symbol *element) {
  const bool heavy_follows = name[1] != '\0' && strchr("CNOS", name[1]) != NULL;
  if (name[0] == 'D' && heavy_follows && kind != RESIDUE_NUCLEOTIDE) return ATOM_VIRTUAL; /* a Drude particle */
  if (kind == RESIDUE_WATER) {
    if (name[0] == '\0' || strchr("OHD", name[0]) == NULL || strcmp(name, "OM") == 0) return ATOM_VIRTUAL;
  }
  if (kind == RESIDUE_AMINO_ACID && (name[0] == 'Q' || name[0] == 'M')) return ATOM_VIRTUAL;
  if (kind == RESIDUE_AMINO_ACID && (name[0] == 'A' || name[0] == 'X')) {
    *element = element_unknown;
    return ATOM_KNOWN;
  }
  if (is_bead_name(name, residue)) return ATOM_BEAD;
  if (name[0] == 'S' && name[1] == 'E') {
    char capitals[NAME_BYTES];
    to_capitals(capitals, residue, strlen(residue));
    const bool selenium = strcmp(capitals, "MSE") == 0 || strcmp(capitals, "SEC") == 0 || strcmp(capitals, "CSE") == 0;
    if (selenium) return element_symbol_parse("Se", 2, element) ? ATOM_KNOWN : ATOM_UNKNOWN;
  }
  if (kind != RESIDUE_WATER && (name[0] == 'B' || (name[0] == 'S' && !has_sulfur(residue)))) return ATOM_BEAD;
  if (name[0] == '\0' || strchr("HDCNOSP", name[0]) == NULL) return ATOM_UNKNOWN;
  return element_symbol_parse(name, 1, element) ? ATOM_KNOWN : ATOM_UNKNOWN;
}

/* By the four columns of a name. */
static bool element_in_columns(struct field columns, struct element_symbol *element) {
  char name[4] = {' ', ' ', ' ', ' '};
  for (size_t i = 0; i < columns.length && i < 4; ++i) name[i] = columns.text[i];
  if (is_letter(name[0]) && is_letter(name[1])) {
    const bool full = name[2] != ' ' && name[3] != ' ';
    const char first = to_upper(name[0]);
    const bool hydrogen = full && (first == 'H' || first == 'D');
    if (!hydrogen && !(full && is_letter(name[2])) && element_symbol_parse(name, 2, element) &&
        element_symbol_exists(*element)) {
      return true;
    }
    return element_symbol_parse(name, 1, element);
  }
  size_t at = 0;
  while (at < 4 && (name[at] == ' ' || is_digit(name[at]))) ++at;
  const bool mixed = at < 3 && is_upper(name[at]) && is_lower(name[at + 1]) && !(at < 2 && is_letter(name[at + 2]));
  if (mixed && element_symbol_parse(name + at, 2, element) && element_symbol_exists(*element)) return true;
  return at < 4 && element_symbol_parse(name + at, 1, element);
}

/* By a name without columns, from its first letter on. */
static bool element_of_letters(const char *name, struct element_symbol *element) {
  static const char *const pairs[] = {"CL", "BR", "FE", "ZN", "MG", "SE"};
  for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; ++i) {
    if (strncmp(name, pairs[i], 2) == 0) return element_symbol_parse(name, 2, element);
  }
  if (element_symbol_parse(name, 1, element) && element_symbol_exists(*element)) return true;
  return strlen(name) >= 2 && element_symbol_parse(name, 2, element) && element_symbol_exists(*element);
}

enum atom_kind atom_kind_of(struct field name, bool in_columns, const char *residue, struct element_symbol *element) {
  size_t blanks = 0;
  while (blanks < name.length && !is_letter(name.text[blanks])) ++blanks;
  size_t end = name.length;
  while (end > blanks && name.text[end - 1] == ' ') --end;
  char capitals[NAME_BYTES];
  to_capitals(capitals, name.text + blanks, end - blanks);

  if (ion_of(name, residue, element)) return ATOM_KNOWN;
  const enum residue_kind kind = residue_kind_of(residue);
  if (kind != RESIDUE_OTHER) {
    const enum atom_kind found = kind_in_residue(capitals, kind, residue, element);
    if (found != ATOM_UNKNOWN) return found;
  }
  if (strncmp(capitals, "EP", 2) == 0 || strncmp(capitals, "LP", 2) == 0 || strcmp(capitals, "M") == 0 ||
      strcmp(capitals, "MW") == 0) {
    return ATOM_VIRTUAL;
  }
  const bool known = in_columns ? element_in_columns(name, element) : element_of_letters(capitals, element);
  if (known) return ATOM_KNOWN;
  element->text[0] = '\0';
  return ATOM_UNKNOWN;
}

enum atom_kind atom_kind_again(struct kinds_seen *seen, struct field name, const char residue[8],
                               struct element_symbol *element) {
  if (name.length == 0 || name.length > 8) return atom_kind_of(name, false, residue, element);
  const uint64_t of_name = word_first(word_at(name.text), (unsigned)name.length), of_residue = word_at(residue);
  const uint64_t mixed = (of_name * 31 + of_residue) * UINT64_C(0x9E3779B97F4A7C15);
  struct kind_seen *const found = &seen->of[mixed >> 56];
  if (found->length != name.length || found->name != of_name || found->residue != of_residue) {
    *found = (struct kind_seen){of_name, of_residue, (unsigned char)name.length, 0, {""}};
    found->kind = (unsigned char)atom_kind_of(name, false, residue, &found->element);
  }
  *element = found->element;
  return (enum atom_kind)found->kind;
}
