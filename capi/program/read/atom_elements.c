#include "read/atom_elements.h"

#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/number.h"
#include "read/residue_kinds.h"
#include "read/words.h"

enum { NAME_BYTES = 8, SYMBOL_LETTERS = 2 };

/* An atom's name from its first letter on, as written and in capitals. */
struct name {
  char written[NAME_BYTES];
  char capitals[NAME_BYTES];
  size_t letters; /* that it begins with */
};

static size_t leading_letters(const char *text, size_t length) {
  size_t letters = 0;
  while (letters < length && is_letter(text[letters])) ++letters;
  return letters;
}

static struct name name_of(struct field field) {
  struct name name;
  size_t begin = 0, end = field.length;
  while (begin < end && !is_letter(field.text[begin])) ++begin;
  while (end > begin && field.text[end - 1] == ' ') --end;
  label_copy(name.written, sizeof name.written, (struct field){field.text + begin, end - begin});
  to_capitals(name.capitals, sizeof name.capitals, name.written, strlen(name.written));
  name.letters = leading_letters(name.written, strlen(name.written));
  return name;
}

/* The letters of a text in capitals, without digits and signs. */
static void letters_of(char out[NAME_BYTES], const char *text, size_t length) {
  size_t count = 0;
  for (size_t i = 0; i < length && count + 1 < NAME_BYTES; ++i) {
    if (is_letter(text[i])) out[count++] = to_upper(text[i]);
  }
  out[count] = '\0';
}

static bool is_element(const char *text, size_t length, struct element_symbol *element) {
  return element_symbol_parse(text, length, element) && element_symbol_exists(*element);
}

static bool is_among(const char *word, const char *const *words, size_t count) {
  size_t i = 0;
  while (i < count && strcmp(word, words[i]) != 0) ++i;
  return i < count;
}
#define IS_AMONG(word, words) is_among(word, words, sizeof words / sizeof words[0])

/* ---- no atoms ---- */

static const struct element_symbol dummy = {"Du"};

static bool set_virtual(struct atom_label *label, struct element_symbol symbol) {
  label->virtual_site = true;
  label->element = symbol;
  return true;
}

/* A symbol that no element has, and that programs write for virtual sites and dummies in files of any kind. */
static bool is_site_symbol(struct element_symbol symbol) {
  static const char *const symbols[] = {"Du", "Ep", "Lp", "M", "Mw"};
  return IS_AMONG(symbol.text, symbols);
}

/* Likewise a name. The zinc of some force fields has charges DM1 to DM6. */
static bool is_site_name(const struct name *name) {
  static const char *const names[] = {"DM", "DU", "DUM", "M", "MW"};
  char letters[NAME_BYTES];
  letters_of(letters, name->capitals, name->letters);
  if (strncmp(letters, "EP", 2) == 0 || strncmp(letters, "LP", 2) == 0) return true;
  const char *const behind = name->capitals + name->letters;
  return IS_AMONG(letters, names) && behind[strspn(behind, "0123456789")] == '\0' &&
         (letters[1] != '\0' || *behind == '\0');
}

/* The symbol of a virtual site, for radii that the user gives; empty if it has none. */
static struct element_symbol site_symbol_of(struct field name) {
  char letters[NAME_BYTES];
  letters_of(letters, name.text, name.length);
  struct element_symbol symbol = {""};
  if (letters[0] == 'M' || strcmp(letters, "OM") == 0) return (struct element_symbol){"M"};
  if (strcmp(letters, "DM") == 0) return dummy;
  if (letters[1] != '\0' && element_symbol_parse(letters, 2, &symbol) && is_site_symbol(symbol)) return symbol;
  return (struct element_symbol){""};
}

/* Whether the text stands for no atom where files of single molecules have a symbol: dummies everywhere, and in those
 * with queries what a search may find there. */
static bool is_no_atom(struct field text, bool queries, struct element_symbol *symbol) {
  static const char *const dummies[] = {"DU", "DUM", "EP", "LP", "M", "MW", "X"};
  static const char *const any[] = {"A",  "AH",  "ANY", "HAL", "HET", "HEV", "L",
                                    "MH", "MOD", "POL", "Q",   "QH",  "R",   "XH"};
  const size_t letters = leading_letters(text.text, text.length);
  char word[NAME_BYTES];
  to_capitals(word, sizeof word, text.text, letters);
  *symbol = element_unknown;
  if (queries && text.length > 0 && (text.text[0] == '*' || text.text[0] == '[')) return true;
  if (!IS_AMONG(word, dummies) && !(queries && IS_AMONG(word, any))) return false;
  if (letters <= SYMBOL_LETTERS) element_symbol_parse(word, letters, symbol);
  return true;
}

/* ---- names in residues ---- */

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
  return is_element(letters, strlen(letters), element);
}

struct cofactor {
  char name[5];
  char metals[7];
};

static int order_of_cofactors(const void *name, const void *cofactor) {
  return strcmp(name, ((const struct cofactor *)cofactor)->name);
}

/* Metals of cofactors and clusters, by the names of the Protein Data Bank and of CHARMM. All their other elements have
 * one letter, so that NB of a haem is nitrogen in any columns. */
static bool element_in_cofactor(const struct name *name, const char *residue, struct element_symbol *element) {
  static const struct cofactor known[] = {
      {"B12", "CO"},   {"BCB", "MG"}, {"BCL", "MG"}, {"C1O", "CU"},   {"C2O", "CU"},   {"CBY", "CO"},   {"CHL", "MG"},
      {"CL7", "MG"},   {"CLA", "MG"}, {"CNC", "CO"}, {"COB", "CO"},   {"COH", "CO"},   {"COY", "CO"},   {"CUA", "CU"},
      {"CUB", "CU"},   {"CUZ", "CU"}, {"DHE", "FE"}, {"EMC", "HG"},   {"F43", "NI"},   {"HAS", "FE"},   {"HDD", "FE"},
      {"HEA", "FE"},   {"HEB", "FE"}, {"HEC", "FE"}, {"HEM", "FE"},   {"HEME", "FE"},  {"HEO", "FE"},   {"HNI", "NI"},
      {"MBO", "HG"},   {"MMC", "HG"}, {"NCO", "CO"}, {"NFU", "NIFE"}, {"NFV", "NIFE"}, {"OEC", "MNCA"}, {"OEX", "MNCA"},
      {"OEY", "MNCA"}, {"OHX", "OS"}, {"SRM", "FE"}, {"XCC", "NIFE"},
  };
  char capitals[NAME_BYTES];
  to_capitals(capitals, sizeof capitals, residue, strlen(residue));
  const struct cofactor *const found =
      bsearch(capitals, known, sizeof known / sizeof known[0], sizeof known[0], order_of_cofactors);
  if (found == NULL) return false;
  for (const char *metal = found->metals; name->letters == 2 && *metal != '\0'; metal += 2) {
    if (strncmp(name->capitals, metal, 2) == 0) return element_symbol_parse(metal, 2, element);
  }
  return name->capitals[0] != '\0' && strchr("HDCNOSPF", name->capitals[0]) != NULL &&
         element_symbol_parse(name->capitals, 1, element);
}

/* Whether an amino acid or nucleotide has sulfur. */
static bool has_sulfur(const char *residue) {
  static const char *const names[] = {"CME",  "CSE", "CSO", "CYM", "CYN", "CYS",
                                      "CYSH", "CYX", "MET", "MSE", "SEC", "UNK"};
  char capitals[NAME_BYTES];
  to_capitals(capitals, sizeof capitals, residue, strlen(residue));
  /* At the end of a chain: NCYS. */
  const bool end = strlen(capitals) == 4 && (capitals[0] == 'N' || capitals[0] == 'C') && strcmp(capitals, "CYSH") != 0;
  return IS_AMONG(capitals + (end ? 1 : 0), names);
}

/* Whether the name is one that beads have in such a residue, BB, BB1, SC1, whatever element programs guess from it. */
static bool is_bead_name(const char *capitals, enum residue_kind kind) {
  const bool backbone = strncmp(capitals, "BB", 2) == 0 && !is_letter(capitals[2]);
  const bool side = strncmp(capitals, "SC", 2) == 0 && is_digit(capitals[2]);
  return (kind == RESIDUE_AMINO_ACID || kind == RESIDUE_NUCLEOTIDE) && (backbone || side);
}

/* Whether the name is one that sulfur has in place of an oxygen of phosphate or sugar, S1P, S2P, S5'; no bead is called
 * so. */
static bool is_thio_name(const char *capitals, enum residue_kind kind) {
  return kind == RESIDUE_NUCLEOTIDE && capitals[0] == 'S' && is_digit(capitals[1]) &&
         strchr("P'*", capitals[2]) != NULL && capitals[2] != '\0' && capitals[3] == '\0';
}

enum atom_kind { ATOM_KNOWN, ATOM_UNKNOWN, ATOM_BEAD, ATOM_VIRTUAL };

/* An atom in a known residue. `name` is in capitals, from its first letter on. ATOM_UNKNOWN: such residues have no such
 * name. */
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
  if (is_bead_name(name, kind)) return ATOM_BEAD;
  if (name[0] == 'S' && name[1] == 'E') {
    static const char *const names[] = {"CSE", "MSE", "SEC"};
    char capitals[NAME_BYTES];
    to_capitals(capitals, sizeof capitals, residue, strlen(residue));
    if (IS_AMONG(capitals, names)) return element_symbol_parse("Se", 2, element) ? ATOM_KNOWN : ATOM_UNKNOWN;
  }
  const bool sulfur = name[0] == 'S' && (has_sulfur(residue) || is_thio_name(name, kind));
  if (kind != RESIDUE_WATER && (name[0] == 'B' || (name[0] == 'S' && !sulfur))) return ATOM_BEAD;
  if (name[0] == '\0' || strchr("HDCNOSP", name[0]) == NULL) return ATOM_UNKNOWN;
  return element_symbol_parse(name, 1, element) ? ATOM_KNOWN : ATOM_UNKNOWN;
}

/* ---- columns and letters ---- */

/* By the first two of the four columns of a name. */
static bool element_in_columns(struct field columns, struct element_symbol *element) {
  char name[4] = {' ', ' ', ' ', ' '};
  for (size_t i = 0; i < columns.length && i < 4; ++i) name[i] = columns.text[i];
  const bool full = name[2] != ' ' && name[3] != ' ';
  const char first = to_upper(name[0]);
  const bool hydrogen = full && (first == 'H' || first == 'D');
  return !hydrogen && !(full && is_letter(name[2])) && is_element(name, 2, element);
}

/* Two letters that mean an element wherever they begin a name in capitals: none of a usual name of the first one. */
static bool is_pair(const char *capitals, struct element_symbol *element) {
  static const char pairs[][3] = {"BE", "BI", "BR", "CL", "CU", "FE", "IN", "IR",
                                  "KR", "MG", "PT", "SE", "SI", "YB", "ZN"};
  for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; ++i) {
    if (strncmp(capitals, pairs[i], 2) == 0) return element_symbol_parse(capitals, 2, element);
  }
  return false;
}

static bool element_of_letters(const struct name *name, struct element_symbol *element) {
  const char *const capitals = name->capitals;
  const bool mixed = name->letters == 2 && is_upper(name->written[0]) && is_lower(name->written[1]);
  const bool carbon = name->letters == 3 && strncmp(capitals, "CL", 2) == 0;
  if (mixed && is_element(capitals, 2, element)) return true;
  if (!carbon && is_pair(capitals, element)) return true;
  /* T1 is a bead or a tetrahedral site rather than tritium. */
  if (capitals[0] != 'T' && is_element(capitals, 1, element)) return true;
  return name->letters >= 2 && is_element(capitals, 2, element);
}

/* Find the element by a name alone. *by_letters: only its letters tell the element. */
static enum atom_kind kind_of_name(struct field field, bool in_columns, const char *residue,
                                   struct element_symbol *element, bool *by_letters) {
  const struct name name = name_of(field);
  const enum residue_kind kind = residue_kind_of(residue);
  struct element_symbol pair;
  *by_letters = false;
  if (ion_of(field, residue, element)) return ATOM_KNOWN;
  if (is_site_name(&name)) return ATOM_VIRTUAL;
  if (kind == RESIDUE_OTHER && element_in_cofactor(&name, residue, element)) return ATOM_KNOWN;
  /* UNK is an unknown amino acid, and in files of some programs a ligand. */
  const bool ligand = is_pair(name.capitals, &pair) && strcmp(residue, "UNK") == 0;
  if (kind != RESIDUE_OTHER && !ligand) {
    const enum atom_kind found = kind_in_residue(name.capitals, kind, residue, element);
    if (found != ATOM_UNKNOWN) return found;
  }
  if (in_columns && element_in_columns(field, element)) return ATOM_KNOWN;
  *by_letters = true;
  if (element_of_letters(&name, element)) return ATOM_KNOWN;
  /* Beads in columns are called so that a radius can be given to them. */
  if (in_columns && name.capitals[0] != 'T' && element_symbol_parse(name.capitals, 1, element)) return ATOM_KNOWN;
  element->text[0] = '\0';
  return ATOM_UNKNOWN;
}

static bool take_name(const struct atom_evidence *evidence, struct atom_label *label) {
  const bool in_columns = evidence->dialect == ATOM_COLUMNS || evidence->dialect == ATOM_AUTODOCK;
  bool by_letters;
  const enum atom_kind kind =
      kind_of_name(evidence->name, in_columns, label->residue->name, &label->element, &by_letters);
  label->virtual_site = kind == ATOM_VIRTUAL;
  label->bead = kind == ATOM_BEAD;
  label->by_letters = by_letters;
  if (kind == ATOM_VIRTUAL) label->element = site_symbol_of(evidence->name);
  return kind != ATOM_UNKNOWN;
}

/* ---- labels of crystals ---- */

static bool take_label(struct field field, struct atom_label *label) {
  const struct name name = name_of(field);
  struct element_symbol one;
  if (strncmp(name.capitals, "DU", 2) == 0) return set_virtual(label, dummy);
  if (strncmp(name.capitals, "WAT", 3) == 0) return element_symbol_parse("O", 1, &label->element);
  if (field.length == 0 || !is_letter(field.text[0])) return false;
  const bool single = name.capitals[0] != 'T' && is_element(name.capitals, 1, &one);
  const bool pair = name.letters >= 2 && is_element(name.capitals, 2, &label->element);
  const bool lower = is_lower(name.written[1]);
  if (pair && (lower || !single || (name.letters == 2 && is_pair(name.capitals, &one)))) return true;
  /* Two capitals may be the symbol of one element or begin with that of another, which is carbon or cobalt. Of small
   * letters only those behind elements of water and of what it surrounds tell which site it is. */
  if (pair || !single || (lower && strchr("CDHNO", name.capitals[0]) == NULL)) return false;
  label->element = one;
  return true;
}

/* ---- stated symbols and types ---- */

/* A name that begins with the one letter of another element than the stated one, C1 of calcium: a program has taken a
 * type, ca, for a symbol. */
static bool contradicts(struct field name, struct element_symbol element) {
  if (element.text[1] == '\0') return false;
  const struct name of = name_of(name);
  return of.letters == 1 && of.capitals[0] == element.text[0] && is_element(of.capitals, 1, &element);
}

/* The letters of a symbol that a charge may follow, FE or O2-. */
static bool symbol_with_charge(struct field text, struct element_symbol *element) {
  const size_t letters = leading_letters(text.text, text.length);
  size_t end;
  for (end = letters; end < text.length && strchr("0123456789+-", text.text[end]) != NULL; ++end) continue;
  return end == text.length && element_symbol_parse(text.text, letters, element);
}

/* A symbol beside a name or a label. */
static bool take_symbol_beside_name(const struct atom_evidence *evidence, struct atom_label *label) {
  struct element_symbol stated;
  if (!symbol_with_charge(evidence->stated, &stated)) return false;
  if (element_symbol_exists(stated)) {
    char capitals[NAME_BYTES];
    to_capitals(capitals, sizeof capitals, label->name, strlen(label->name));
    const bool guessed = strcmp(stated.text, "B") == 0 || strcmp(stated.text, "S") == 0;
    label->bead = guessed && is_bead_name(capitals, residue_kind_of(label->residue->name));
    label->element = label->bead ? (struct element_symbol){""} : stated;
    return true;
  }
  if (evidence->dialect != ATOM_LABELS) take_name(evidence, label);
  const bool unknown = element_is_unknown(label->element) && !label->virtual_site;
  label->virtual_site = label->virtual_site || is_site_symbol(stated);
  label->bead = label->by_letters = false;
  if (!unknown) label->element = stated;
  return true;
}

/* A symbol, a label that begins with one and goes on with something else, C1 or Fe3+, or an atomic number. */
static bool take_symbol(struct field text, bool queries, struct atom_label *label) {
  uint64_t number;
  struct element_symbol none;
  if (number_parse_count(text.text, text.length, &number) == NUMBER_OK) {
    label->by_number = true;
    return element_symbol_of_number(number, &label->element);
  }
  if (is_no_atom(text, queries, &none)) return set_virtual(label, none);
  const size_t letters = leading_letters(text.text, text.length);
  return element_symbol_parse(text.text, letters, &label->element);
}

/* Read a type of SYBYL, C.3, N.ar, Zn; for a type of a force field the name is read. */
static bool take_type(const struct atom_evidence *evidence, struct atom_label *label) {
  const struct field type = evidence->stated;
  const char *const dot = memchr(type.text, '.', type.length);
  const struct field before = {type.text, dot == NULL ? type.length : (size_t)(dot - type.text)};
  struct element_symbol symbol;
  if (is_no_atom(before, true, &symbol) && !(before.length > 1 && is_digit(before.text[1]))) {
    return set_virtual(label, symbol);
  }
  const size_t letters = leading_letters(before.text, before.length);
  const bool numbered = before.length > 0 && is_digit(before.text[before.length - 1]);
  const bool known = !numbered && symbol_with_charge(before, &symbol) && element_symbol_exists(symbol);
  if (dot != NULL && !known) return false;
  const char first = to_upper(type.text[0]);
  /* Types in one case only of elements that force fields have many types of are theirs, but chlorine's. */
  const bool proper = letters == 1 || (is_upper(type.text[0]) && is_lower(type.text[1]));
  const bool rare = strchr("CHNOSP", first) == NULL || (first == 'C' && to_upper(type.text[letters - 1]) == 'L');
  if (!known || (dot == NULL && !proper && !rare)) return take_name(evidence, label);
  label->element = symbol;
  return true;
}

/* Read a type of AutoDock: one of its parameters, of ring closures, or of hydrated or zinc docking; else a symbol. */
static bool take_autodock_type(struct field type, struct atom_label *label) {
  static const struct {
    char type[4];
    char element[3]; /* empty: none */
  } types[] = {{"HD", "H"}, {"HS", "H"},  {"A", "C"},   {"G", "C"},   {"GA", "C"},  {"J", "C"},  {"Q", "C"},
               {"CG", "C"}, {"CG0", "C"}, {"CG1", "C"}, {"CG2", "C"}, {"CG3", "C"}, {"NA", "N"}, {"NS", "N"},
               {"NX", "N"}, {"OA", "O"},  {"OS", "O"},  {"OX", "O"},  {"SA", "S"},  {"AC", ""},  {"G0", ""},
               {"G1", ""},  {"G2", ""},   {"G3", ""},   {"OC", ""},   {"TZ", ""},   {"W", ""},   {"Z", ""}};
  for (size_t i = 0; i < sizeof types / sizeof types[0]; ++i) {
    if (strlen(types[i].type) != type.length || memcmp(types[i].type, type.text, type.length) != 0) continue;
    const size_t letters = strlen(types[i].element);
    return letters > 0 ? element_symbol_parse(types[i].element, letters, &label->element) : set_virtual(label, dummy);
  }
  return is_element(type.text, type.length, &label->element);
}

static bool take_evidence(const struct atom_evidence *evidence, struct atom_label *label) {
  const struct field stated = evidence->stated;
  switch (evidence->dialect) {
    case ATOM_SYMBOLS:
    case ATOM_QUERIES:
      return take_symbol(stated, evidence->dialect == ATOM_QUERIES, label);
    case ATOM_TYPES:
      return take_type(evidence, label);
    case ATOM_LABELS:
      return stated.length > 0 ? take_symbol_beside_name(evidence, label) : take_label(evidence->name, label);
    case ATOM_AUTODOCK:
      if (stated.length > 0 && take_autodock_type(stated, label)) return true;
      break;
    case ATOM_NAMES:
    case ATOM_COLUMNS:
      if (stated.length > 0) return take_symbol_beside_name(evidence, label);
      break;
  }
  take_name(evidence, label);
  return true;
}

bool atom_take_element(const struct atom_evidence *evidence, struct atom_label *label) {
  char capitals[NAME_BYTES];
  to_capitals(capitals, sizeof capitals, label->residue->name, strlen(label->residue->name));
  if (strcmp(capitals, "DUM") == 0) return set_virtual(label, dummy);
  if (!take_evidence(evidence, label)) return false;
  label->contradicted =
      evidence->stated.length > 0 && !label->virtual_site && contradicts(evidence->name, label->element);
  return true;
}

void atom_take_element_again(struct elements_seen *seen, struct field name, struct atom_label *label) {
  const struct atom_evidence evidence = {ATOM_NAMES, name, {"", 0}};
  if (name.length == 0 || name.length > 8 || strlen(label->residue->name) > 8) {
    atom_take_element(&evidence, label);
    return;
  }
  const uint64_t of_name = word_first(word_at(name.text), (unsigned)name.length);
  const uint64_t of_residue = word_at(label->residue->name);
  const uint64_t mixed = (of_name * 31 + of_residue) * UINT64_C(0x9E3779B97F4A7C15);
  struct element_seen *const found = &seen->of[mixed >> 56];
  if (found->length != name.length || found->name != of_name || found->residue != of_residue) {
    atom_take_element(&evidence, label);
    *found = (struct element_seen){
        of_name,           of_residue,    (unsigned char)name.length, label->virtual_site, label->bead,
        label->by_letters, label->element};
    return;
  }
  label->element = found->element;
  label->virtual_site = found->virtual_site;
  label->bead = found->bead;
  label->by_letters = found->by_letters;
}

void molecule_agree_elements(struct molecule *molecule) {
  for (uint32_t begin = 0, end; begin < molecule->atoms; begin = end) {
    const struct residue_label *const residue = molecule->label[begin].residue;
    bool carbons = false, doubtful = false;
    for (end = begin; end < molecule->atoms && molecule->label[end].residue == residue; ++end) {
      const struct atom_label *const label = &molecule->label[end];
      if (label->name[1] != 'L') continue;
      carbons = carbons || label->name[0] == 'H' || (label->name[0] == 'C' && is_letter(label->name[2]));
      doubtful = doubtful || strcmp(label->name, "CL") == 0;
    }
    for (uint32_t i = begin; carbons && doubtful && i < end; ++i) {
      struct atom_label *const label = &molecule->label[i];
      if (label->by_letters && strcmp(label->name, "CL") == 0) element_symbol_parse("C", 1, &label->element);
    }
  }
}
