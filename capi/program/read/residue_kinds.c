#include "read/residue_kinds.h"

#include <stdlib.h>
#include <string.h>

#include "read/characters.h"

enum { NAME_BYTES = 8 };

struct known_residue {
  char name[5];
  unsigned char kind;
};

enum { A = RESIDUE_AMINO_ACID, N = RESIDUE_NUCLEOTIDE, W = RESIDUE_WATER };

/* The names in the order of strcmp. */
static const struct known_residue residues[] = {
    {"A", N},    {"A3", N},   {"A5", N},   {"ACE", A},  {"ADE", N},  {"ALA", A},  {"ALAD", A}, {"ALY", A}, {"ARG", A},
    {"ARN", A},  {"ASH", A},  {"ASN", A},  {"ASP", A},  {"ASPH", A}, {"ASX", A},  {"C", N},    {"C3", N},  {"C5", N},
    {"CME", A},  {"CSE", A},  {"CSO", A},  {"CYM", A},  {"CYN", A},  {"CYS", A},  {"CYSH", A}, {"CYT", N}, {"CYX", A},
    {"D2O", W},  {"DA", N},   {"DA3", N},  {"DA5", N},  {"DAN", N},  {"DC", N},   {"DC3", N},  {"DC5", N}, {"DCN", N},
    {"DG", N},   {"DG3", N},  {"DG5", N},  {"DGN", N},  {"DI", N},   {"DOD", W},  {"DT", N},   {"DT3", N}, {"DT5", N},
    {"DTN", N},  {"DU", N},   {"FOR", A},  {"G", N},    {"G3", N},   {"G5", N},   {"GLH", A},  {"GLN", A}, {"GLU", A},
    {"GLUH", A}, {"GLX", A},  {"GLY", A},  {"GUA", N},  {"H2O", W},  {"HID", A},  {"HIE", A},  {"HIP", A}, {"HIS", A},
    {"HISD", A}, {"HISE", A}, {"HISH", A}, {"HOH", W},  {"HSD", A},  {"HSE", A},  {"HSP", A},  {"HYP", A}, {"I", N},
    {"ILE", A},  {"KCX", A},  {"LEU", A},  {"LYN", A},  {"LYS", A},  {"LYSH", A}, {"M3L", A},  {"MET", A}, {"MLY", A},
    {"MSE", A},  {"NH2", A},  {"NHE", A},  {"NMA", A},  {"NME", A},  {"OPC", W},  {"PCA", A},  {"PHE", A}, {"PRO", A},
    {"PTR", A},  {"RA", N},   {"RA3", N},  {"RA5", N},  {"RC", N},   {"RC3", N},  {"RC5", N},  {"RG", N},  {"RG3", N},
    {"RG5", N},  {"RU", N},   {"RU3", N},  {"RU5", N},  {"SEC", A},  {"SEP", A},  {"SER", A},  {"SOL", W}, {"SPC", W},
    {"SPCE", W}, {"SWM4", W}, {"T", N},    {"T3P", W},  {"T4P", W},  {"T5P", W},  {"THR", A},  {"THY", N}, {"TIP", W},
    {"TIP2", W}, {"TIP3", W}, {"TIP4", W}, {"TIP5", W}, {"TP3", W},  {"TP4", W},  {"TP5", W},  {"TPO", A}, {"TRP", A},
    {"TYM", A},  {"TYR", A},  {"U", N},    {"U3", N},   {"U5", N},   {"UNK", A},  {"URA", N},  {"VAL", A}, {"WAT", W},
};

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
  to_capitals(capitals, sizeof capitals, name, strlen(name));
  const enum residue_kind kind = kind_of_capitals(capitals);
  /* Amber calls residues at the ends of chains NALA and CALA. */
  const bool end = kind == RESIDUE_OTHER && strlen(capitals) == 4 && (capitals[0] == 'N' || capitals[0] == 'C');
  return end && kind_of_capitals(capitals + 1) == RESIDUE_AMINO_ACID ? RESIDUE_AMINO_ACID : kind;
}
