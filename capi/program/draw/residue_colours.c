#include "draw/residue_colours.h"

#include <stddef.h>
#include <string.h>

#include "read/characters.h"
#include "read/residue_kinds.h"

struct residue_group {
  uint32_t colour;
  const char *kind;
  const char *names; /* three letters each, and a blank */
};

static const struct residue_group amino_acids[] = {
    {0x5A84DC, "positive", "ARG LYS HIS HID HIE HIP HSD HSE HSP LYN MLY M3L ALY "},
    {0xE8705E, "negative", "ASP GLU ASH GLH KCX PTR SEP TPO "},
    {0xAFE0A4, "polar", "SER THR ASN GLN HYP ASX GLX PCA "},
    {0xDDB3EC, "aromatic", "PHE TYR TRP TYM "},
    {0xF2DF38, "with sulfur", "CYS CYX CYM CYN CSO CME MET MSE SEC CSE "},
    {0xA8A09A, "aliphatic", "ALA VAL LEU ILE PRO "},
    {0xF5F3EE, "glycine", "GLY "},
};

static const struct residue_group bases[] = {
    {0xF0AC96, "A", "A"}, {0x9FC3E6, "C", "C"}, {0xB7D3A0, "G", "G"}, {0xEED28A, "T", "T"}, {0xEED28A, "U", "U"}};

/* By the first three letters, LYSH is LYS; else by those after the first: Amber's NALA, CALA begin and end chains. */
static bool find_amino_acid(const char *name, struct residue_colour *colour) {
  const size_t length = strlen(name);
  for (size_t first = 0; first < 2 && first + 3 <= length; ++first) {
    char letters[4] = "";
    for (size_t i = 0; i < 3; ++i) letters[i] = to_upper(name[first + i]);
    for (size_t i = 0; i < sizeof amino_acids / sizeof amino_acids[0]; ++i) {
      if (strstr(amino_acids[i].names, letters) == NULL) continue;
      *colour = (struct residue_colour){amino_acids[i].colour, amino_acids[i].kind, (int)i};
      return true;
    }
  }
  return false;
}

static bool find_base(const char *name, struct residue_colour *colour) {
  /* DA, RA and A5 are A, and so is ADE; D and R stand for the sugar. */
  const char first = to_upper(name[0]);
  const bool sugar = (first == 'D' || first == 'R') && name[1] != '\0';
  const char base = sugar ? to_upper(name[1]) : first;
  for (size_t i = 0; i < sizeof bases / sizeof bases[0]; ++i) {
    if (bases[i].names[0] != base) continue;
    *colour = (struct residue_colour){bases[i].colour, bases[i].kind, (int)i};
    return true;
  }
  return false;
}

bool residue_colour_find(const char *name, struct residue_colour *colour) {
  const enum residue_kind kind = residue_kind_of(name);
  if (kind == RESIDUE_NUCLEOTIDE) return find_base(name, colour);
  return kind == RESIDUE_AMINO_ACID && find_amino_acid(name, colour);
}
