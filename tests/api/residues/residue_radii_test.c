/* Radii by residue and atom: classes of the publications, all atoms of a set, names as files have them, refusals. */
#include <hardsphere.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { MOST = 2000 };

static hsp_residue_atom atoms[MOST];

static void check_radius(uint32_t set, const char *residue, const char *atom, double expected) {
  double radius;
  FILL(radius);
  check_scene("set %u, %s %s", (unsigned)set, residue, atom);
  CHECK_EQUAL(hsp_residue_radius(set, residue, atom, &radius), HSP_OK);
  CHECK_BYTES(&radius, &expected, sizeof radius);
}

static void check_missing(uint32_t set, const char *residue, const char *atom) {
  double radius;
  FILL(radius);
  check_scene("set %u, '%s' '%s'", (unsigned)set, residue, atom);
  CHECK_EQUAL(hsp_residue_radius(set, residue, atom, &radius), HSP_E_ID);
  CHECK_UNTOUCHED(radius);
}

/* An atom of each class: C3H0, C3H1, C4H2, N3H1, N4H3, O1H0, O2H1, S2H1, P4H0; trigonal and tetrahedral ones. */
static void classes(void) {
  check_radius(HSP_RADII_PROTOR, "VAL", "C", 1.61);
  check_radius(HSP_RADII_PROTOR, "PHE", "CZ", 1.76);
  check_radius(HSP_RADII_PROTOR, "LYS", "CE", 1.88);
  check_radius(HSP_RADII_PROTOR, "TRP", "NE1", 1.64);
  check_radius(HSP_RADII_PROTOR, "LYS", "NZ", 1.64);
  check_radius(HSP_RADII_PROTOR, "ASP", "OD1", 1.42);
  check_radius(HSP_RADII_PROTOR, "ASP", "OD2", 1.46);
  check_radius(HSP_RADII_PROTOR, "CYS", "SG", 1.77);
  check_radius(HSP_RADII_PROTOR, "DA", "P", 1.80);
  check_radius(HSP_RADII_PROTOR, "HOH", "O", 1.46);
  check_radius(HSP_RADII_NACCESS, "VAL", "C", 1.76);
  check_radius(HSP_RADII_NACCESS, "LYS", "CE", 1.87);
  check_radius(HSP_RADII_NACCESS, "LYS", "NZ", 1.50);
  check_radius(HSP_RADII_NACCESS, "TRP", "NE1", 1.65);
  check_radius(HSP_RADII_NACCESS, "ASP", "OD2", 1.40);
  check_radius(HSP_RADII_NACCESS, "MET", "SD", 1.85);
}

static void names_as_files_have_them(void) {
  check_radius(HSP_RADII_PROTOR, "ala", " CA ", 1.88);
  check_radius(HSP_RADII_PROTOR, "  Da", "o5' ", 1.46);
  check_radius(HSP_RADII_NACCESS, "hip ", " ne2", 1.65);
}

/* Property 1: the amino acids' numbers of heavy atoms are those of their formulas, and each atom is found, by no other
 * name. */
static void whole_set(uint32_t set) {
  static const struct {
    const char *residue;
    uint32_t heavy; /* without OXT, OT1 and OT2 */
  } amino_acids[] = {{"GLY", 4},  {"ALA", 5},  {"VAL", 7},  {"LEU", 8},  {"PRO", 7}, {"SER", 6}, {"THR", 7},
                     {"CYS", 6},  {"MET", 8},  {"ASN", 8},  {"ASP", 8},  {"GLN", 9}, {"GLU", 9}, {"LYS", 9},
                     {"ARG", 11}, {"HIS", 10}, {"PHE", 11}, {"TYR", 12}, {"TRP", 14}};
  uint32_t count, i, k;
  size_t a;
  CHECK_EQUAL(hsp_residue_get_atoms(set, NULL, 0, &count), HSP_E_CAPACITY);
  if (!CHECK(count > 200 && count <= MOST)) return;
  FILL(atoms);
  CHECK_EQUAL(hsp_residue_get_atoms(set, atoms, count - 1, NULL), HSP_E_CAPACITY);
  CHECK_UNTOUCHED(atoms);
  CHECK_EQUAL(hsp_residue_get_atoms(set, atoms, count, NULL), HSP_OK);
  for (i = 0; i < count; ++i) {
    char longer[10];
    CHECK(atoms[i].residue[7] == '\0' && atoms[i].atom[7] == '\0');
    check_radius(set, atoms[i].residue, atoms[i].atom, atoms[i].radius);
    snprintf(longer, sizeof longer, "%sQ", atoms[i].atom);
    check_missing(set, atoms[i].residue, longer);
    for (k = 0; k < i; ++k) {
      const int same = strcmp(atoms[i].residue, atoms[k].residue) == 0 && strcmp(atoms[i].atom, atoms[k].atom) == 0;
      CHECK(!same);
    }
  }
  for (a = 0; a < sizeof amino_acids / sizeof amino_acids[0]; ++a) {
    uint32_t heavy = 0;
    for (i = 0; i < count; ++i) {
      const char *const atom = atoms[i].atom;
      heavy += strcmp(atoms[i].residue, amino_acids[a].residue) == 0 && strcmp(atom, "OXT") != 0 &&
               strncmp(atom, "OT", 2) != 0;
    }
    check_scene("set %u, %s", (unsigned)set, amino_acids[a].residue);
    CHECK_EQUAL(heavy, amino_acids[a].heavy);
  }
}

static void refusals(void) {
  static const uint32_t no_set[] = {HSP_RADII_BONDI, HSP_RADII_CHEM3D, HSP_RADII_NACCESS + 1, HSP_NONE};
  double radius;
  size_t i;
  FILL(radius);
  for (i = 0; i < sizeof no_set / sizeof no_set[0]; ++i) {
    check_scene("set %u", (unsigned)no_set[i]);
    CHECK_EQUAL(hsp_residue_radius(no_set[i], "ALA", "CA", &radius), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_residue_get_atoms(no_set[i], atoms, MOST, NULL), HSP_E_ARGUMENT);
  }
  CHECK_UNTOUCHED(radius);
  check_missing(HSP_RADII_PROTOR, "ALA", "H");
  check_missing(HSP_RADII_PROTOR, "ALA", "C A");
  check_missing(HSP_RADII_PROTOR, "ALA", "");
  check_missing(HSP_RADII_PROTOR, "", "CA");
  check_missing(HSP_RADII_PROTOR, "   ", "CA");
  check_missing(HSP_RADII_PROTOR, "A LA", "CA");
  check_missing(HSP_RADII_PROTOR, "ALA ARG", "CA");
  check_missing(HSP_RADII_PROTOR, "HEM", "FE");
  check_missing(HSP_RADII_NACCESS, "DA", "P");
  check_missing(HSP_RADII_NACCESS, "GLY", "CB");
}

int main(void) {
  classes();
  names_as_files_have_them();
  whole_set(HSP_RADII_PROTOR);
  whole_set(HSP_RADII_NACCESS);
  refusals();
  return check_report();
}
