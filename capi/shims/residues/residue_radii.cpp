#include "residue_radii.hpp"

#include <cstring>

namespace hsp {
namespace {

// One line of a published table: all atoms with one of these names in all residues with one of these names. Names are
// separated by blanks.
struct Rule {
  const char *residues;
  const char *atoms;
  double radius;
};

// Amino acids with the names of their protonation states in Amber and CHARMM, where the radii are the same.
#define HISTIDINE "HIS HID HIE HIP HSD HSE HSP"
#define CYSTEINE "CYS CYX CYM"
#define LYSINE "LYS LYN"
#define WITH_BETA_CARBON \
  "ALA ARG ASN ASP GLN GLU ILE LEU MET PHE PRO SER THR TRP TYR VAL " HISTIDINE " " CYSTEINE " " LYSINE
#define ALL "GLY " WITH_BETA_CARBON

// Nucleotides with their names in Amber and CHARMM.
#define ADENINE "A A3 A5 ADE DA DA3 DA5 RA RA3 RA5"
#define CYTOSINE "C C3 C5 CYT DC DC3 DC5 RC RC3 RC5"
#define GUANINE "G G3 G5 GUA DG DG3 DG5 RG RG3 RG5"
#define INOSINE "I DI"
#define THYMINE "T THY DT DT3 DT5"
#define URACIL "U U3 U5 URA DU RU RU3 RU5"
#define PURINES ADENINE " " GUANINE " " INOSINE
#define PYRIMIDINES CYTOSINE " " THYMINE " " URACIL
#define WATER "D2O DOD H2O HOH OPC SOL SPC SPCE SWM4 T3P T4P T5P TIP TIP2 TIP3 TIP4 TIP5 TP3 TP4 TP5 WAT"

#define PROTOR_ALL ALL " ASX GLX MSE PYL SEC"

// J. Tsai, R. Taylor, C. Chothia and M. Gerstein, J. Mol. Biol. 290 (1999) 253: an atom's class is its element, its
// bonds and its hydrogens. They have the 20 amino acids; nucleotides, water and some other residues are classed as
// FreeSASA 2.1 ships it, and so is one oxygen of each carboxylate and phosphate: as a hydroxyl, O2H1.
constexpr Rule protor[] = {
    {PROTOR_ALL, "N", 1.64},
    {PROTOR_ALL, "CA", 1.88},
    {PROTOR_ALL, "C", 1.61},                                // C3H0
    {PROTOR_ALL, "O OT1", 1.42},                            // O1H0
    {PROTOR_ALL, "OXT OT2", 1.46},                          // O2H1
    {WITH_BETA_CARBON " ASX GLX MSE PYL SEC", "CB", 1.88},  // C4H1, C4H2, C4H3
    {"ARG", "CG CD", 1.88},
    {"ARG", "NE NH1 NH2", 1.64},  // N3H1, N3H2
    {"ARG", "CZ", 1.61},
    {"ASN ASP", "CG", 1.61},
    {"ASN ASP", "OD1", 1.42},
    {"ASN", "ND2", 1.64},
    {"ASP", "OD2", 1.46},    // O2H1
    {CYSTEINE, "SG", 1.77},  // S2H0, S2H1
    {"GLN GLU", "CG", 1.88},
    {"GLN GLU", "CD", 1.61},
    {"GLN GLU", "OE1", 1.42},
    {"GLN", "NE2", 1.64},
    {"GLU", "OE2", 1.46},  // O2H1
    {HISTIDINE, "CG", 1.61},
    {HISTIDINE, "CD2 CE1", 1.76},  // C3H1
    {HISTIDINE, "ND1 NE2", 1.64},
    {"ILE", "CG1 CG2 CD1 CD", 1.88},
    {"LEU", "CG CD1 CD2", 1.88},
    {LYSINE, "CG CD CE", 1.88},
    {LYSINE, "NZ", 1.64},  // N4H3
    {"MET", "CG CE", 1.88},
    {"MET", "SD", 1.77},
    {"PHE", "CG", 1.61},
    {"PHE", "CD1 CD2 CE1 CE2 CZ", 1.76},
    {"PRO", "CG CD", 1.88},
    {"SER", "OG", 1.46},  // O2H1
    {"THR", "OG1", 1.46},
    {"THR", "CG2", 1.88},
    {"TRP", "CG CD2 CE2", 1.61},
    {"TRP", "CD1 CE3 CZ2 CZ3 CH2", 1.76},
    {"TRP", "NE1", 1.64},
    {"TYR", "CG CZ", 1.61},
    {"TYR", "CD1 CD2 CE1 CE2", 1.76},
    {"TYR", "OH", 1.46},
    {"VAL", "CG1 CG2", 1.88},
    {"ASX", "CG", 1.61},
    {"ASX", "XD1 XD2", 1.50},  // nitrogen or oxygen
    {"GLX", "CG", 1.88},
    {"GLX", "CD", 1.61},
    {"GLX", "XE1 XE2", 1.50},
    {"MSE", "CG CE", 1.88},
    {"MSE SEC", "SE", 1.90},  // SE2H0, SE2H1
    {"PYL", "CG CD CE CA2 CB2 CD2 CG2", 1.88},
    {"PYL", "C2", 1.61},
    {"PYL", "CE2", 1.76},
    {"PYL", "NZ N2", 1.64},
    {"PYL", "O2", 1.42},
    {"ACE", "CH3", 1.88},
    {"ACE", "C", 1.76},
    {"ACE", "O", 1.42},
    {"NH2", "N", 1.64},
    {PURINES, "P", 1.80},  // P4H0
    {PYRIMIDINES, "P", 1.80},
    {PURINES, "OP1 O1P", 1.42},
    {PYRIMIDINES, "OP1 O1P", 1.42},
    {PURINES, "OP2 O2P OP3 O3P O2' O3' O4' O5'", 1.46},  // O2H1, O2H0
    {PYRIMIDINES, "OP2 O2P OP3 O3P O2' O3' O4' O5'", 1.46},
    {PURINES, "C1' C2' C3' C4' C5'", 1.88},
    {PYRIMIDINES, "C1' C2' C3' C4' C5'", 1.88},
    {PURINES, "N1 N3 N7 N9", 1.64},  // N2H0, N3H0, N3H1
    {PURINES, "C4 C5 C6", 1.61},
    {PURINES, "C8", 1.76},
    {ADENINE " " INOSINE, "C2", 1.76},
    {GUANINE, "C2", 1.61},
    {ADENINE, "N6", 1.64},
    {GUANINE, "N2", 1.64},
    {GUANINE " " INOSINE, "O6", 1.42},
    {PYRIMIDINES, "N1 N3", 1.64},
    {PYRIMIDINES, "C2 C4", 1.61},
    {PYRIMIDINES, "C6", 1.76},
    {PYRIMIDINES, "O2", 1.42},
    {CYTOSINE, "N4", 1.64},
    {CYTOSINE " " URACIL, "C5", 1.76},
    {THYMINE, "C5", 1.61},
    {THYMINE, "C7 C5M", 1.88},
    {THYMINE " " URACIL, "O4", 1.42},
    {WATER, "O OW OH2", 1.46},  // O2H2
};

// C. Chothia, J. Mol. Biol. 105 (1976) 1, as the program NACCESS by S. Hubbard and J. Thornton uses them: 20 amino
// acids.
constexpr Rule naccess[] = {
    {ALL, "N", 1.65},   // trigonal nitrogen
    {ALL, "CA", 1.87},  // tetrahedral carbon
    {ALL, "C", 1.76},   // trigonal carbon
    {ALL, "O OXT OT1 OT2", 1.40},
    {WITH_BETA_CARBON, "CB", 1.87},
    {"ARG", "CG CD", 1.87},
    {"ARG", "NE NH1 NH2", 1.65},
    {"ARG", "CZ", 1.76},
    {"ASN ASP", "CG", 1.76},
    {"ASN ASP", "OD1", 1.40},
    {"ASN", "ND2", 1.65},
    {"ASP", "OD2", 1.40},
    {CYSTEINE, "SG", 1.85},
    {"GLN GLU", "CG", 1.87},
    {"GLN GLU", "CD", 1.76},
    {"GLN GLU", "OE1", 1.40},
    {"GLN", "NE2", 1.65},
    {"GLU", "OE2", 1.40},
    {HISTIDINE, "CG CD2 CE1", 1.76},
    {HISTIDINE, "ND1 NE2", 1.65},
    {"ILE", "CG1 CG2 CD1 CD", 1.87},
    {"LEU", "CG CD1 CD2", 1.87},
    {LYSINE, "CG CD CE", 1.87},
    {LYSINE, "NZ", 1.50},  // tetrahedral nitrogen
    {"MET", "CG CE", 1.87},
    {"MET", "SD", 1.85},
    {"PHE", "CG CD1 CD2 CE1 CE2 CZ", 1.76},
    {"PRO", "CG CD", 1.87},
    {"SER", "OG", 1.40},
    {"THR", "OG1", 1.40},
    {"THR", "CG2", 1.87},
    {"TRP", "CG CD1 CD2 CE2 CE3 CZ2 CZ3 CH2", 1.76},
    {"TRP", "NE1", 1.65},
    {"TYR", "CG CD1 CD2 CE1 CE2 CZ", 1.76},
    {"TYR", "OH", 1.40},
    {"VAL", "CG1 CG2", 1.87},
};

Span<const Rule> rules_of(ResidueSet set) {
  if (set == ResidueSet::protor) return {protor, sizeof protor / sizeof protor[0]};
  return {naccess, sizeof naccess / sizeof naccess[0]};
}

char upper(char letter) {
  return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
}

// Calls visit(word, length) for each word of a text.
template <class Visit>
constexpr void visit_words(const char *text, Visit visit) {
  while (*text != '\0') {
    if (*text == ' ') {
      ++text;
      continue;
    }
    uint32_t length = 0;
    while (text[length] != '\0' && text[length] != ' ') ++length;
    visit(text, length);
    text += length;
  }
}

constexpr uint32_t count_words(const char *text) {
  uint32_t count = 0;
  visit_words(text, [&count](const char *, uint32_t) { ++count; });
  return count;
}

template <size_t n>
constexpr uint32_t count_atoms(const Rule (&rules)[n]) {
  uint32_t count = 0;
  for (const Rule &rule : rules) count += count_words(rule.residues) * count_words(rule.atoms);
  return count;
}

constexpr uint32_t protor_atoms = count_atoms(protor);
constexpr uint32_t naccess_atoms = count_atoms(naccess);

// Whether a name, in any case of its letters and with blanks around it, is one of some words.
bool is_one_of(const char *name, const char *words) {
  while (*name == ' ') ++name;
  bool found = false;
  visit_words(words, [&](const char *word, uint32_t length) {
    uint32_t at = 0;
    while (at < length && upper(name[at]) == word[at]) ++at;
    if (at < length) return;
    while (name[at] == ' ') ++at;
    found = found || name[at] == '\0';
  });
  return found;
}

void put_name(const char *word, uint32_t length, char (&name)[8]) {
  for (char &letter : name) letter = '\0';
  for (uint32_t i = 0; i < length; ++i) name[i] = word[i];
}

}  // namespace

bool find_residue_radius(ResidueSet set, const char *residue, const char *atom, double &radius) {
  for (const Rule &rule : rules_of(set)) {
    if (!is_one_of(residue, rule.residues) || !is_one_of(atom, rule.atoms)) continue;
    radius = rule.radius;
    return true;
  }
  return false;
}

uint32_t list_residue_radii(ResidueSet set, hsp_residue_atom *out) {
  uint32_t count = 0;
  if (out == nullptr) return set == ResidueSet::protor ? protor_atoms : naccess_atoms;
  for (const Rule &rule : rules_of(set)) {
    const uint32_t first = count;
    uint32_t atoms = 0;
    visit_words(rule.residues, [&](const char *residue, uint32_t residue_length) {
      hsp_residue_atom listed;
      put_name(residue, residue_length, listed.residue);
      listed.radius = rule.radius;
      // The atoms of a rule are read once, for its first residue; further residues copy them.
      for (uint32_t k = 0; k < atoms; ++k) {
        std::memcpy(listed.atom, out[first + k].atom, sizeof listed.atom);
        out[count++] = listed;
      }
      if (atoms > 0) return;
      visit_words(rule.atoms, [&](const char *atom, uint32_t atom_length) {
        put_name(atom, atom_length, listed.atom);
        out[count++] = listed;
      });
      atoms = count - first;
    });
  }
  return count;
}

}  // namespace hsp
