#include "protein_radii.h"

#include <stddef.h>

/* Amino acids with the names of their protonation states in Amber and CHARMM, where the radii are the same. */
#define HISTIDINE "HIS HID HIE HIP HSD HSE HSP"
#define CYSTEINE "CYS CYX CYM"
#define LYSINE "LYS LYN"
#define WITH_BETA_CARBON \
  "ALA ARG ASN ASP GLN GLU ILE LEU MET PHE PRO SER THR TRP TYR VAL " HISTIDINE " " CYSTEINE " " LYSINE
#define ALL "GLY " WITH_BETA_CARBON

const struct radii_rule protein_radii_protor[] = {
    {ALL, "N", 1.64},
    {ALL, "CA", 1.88},
    {ALL, "C", 1.61},               /* C3H0 */
    {ALL, "O OXT OT1 OT2", 1.42},   /* O1H0 */
    {WITH_BETA_CARBON, "CB", 1.88}, /* C4H1, C4H2, C4H3 */
    {"ARG", "CG CD", 1.88},
    {"ARG", "NE NH1 NH2", 1.64}, /* N3H1, N3H2 */
    {"ARG", "CZ", 1.61},
    {"ASN ASP", "CG", 1.61},
    {"ASN ASP", "OD1", 1.42},
    {"ASN", "ND2", 1.64},
    {"ASP", "OD2", 1.42},
    {CYSTEINE, "SG", 1.77}, /* S2H0, S2H1 */
    {"GLN GLU", "CG", 1.88},
    {"GLN GLU", "CD", 1.61},
    {"GLN GLU", "OE1", 1.42},
    {"GLN", "NE2", 1.64},
    {"GLU", "OE2", 1.42},
    {HISTIDINE, "CG", 1.61},
    {HISTIDINE, "CD2 CE1", 1.76}, /* C3H1 */
    {HISTIDINE, "ND1 NE2", 1.64},
    {"ILE", "CG1 CG2 CD1 CD", 1.88},
    {"LEU", "CG CD1 CD2", 1.88},
    {LYSINE, "CG CD CE", 1.88},
    {LYSINE, "NZ", 1.64}, /* N4H3 */
    {"MET", "CG CE", 1.88},
    {"MET", "SD", 1.77},
    {"PHE", "CG", 1.61},
    {"PHE", "CD1 CD2 CE1 CE2 CZ", 1.76},
    {"PRO", "CG CD", 1.88},
    {"SER", "OG", 1.46}, /* O2H1 */
    {"THR", "OG1", 1.46},
    {"THR", "CG2", 1.88},
    {"TRP", "CG CD2 CE2", 1.61},
    {"TRP", "CD1 CE3 CZ2 CZ3 CH2", 1.76},
    {"TRP", "NE1", 1.64},
    {"TYR", "CG CZ", 1.61},
    {"TYR", "CD1 CD2 CE1 CE2", 1.76},
    {"TYR", "OH", 1.46},
    {"VAL", "CG1 CG2", 1.88},
    {NULL, NULL, 0.0},
};

const struct radii_rule protein_radii_naccess[] = {
    {ALL, "N", 1.65},  /* trigonal nitrogen */
    {ALL, "CA", 1.87}, /* tetrahedral carbon */
    {ALL, "C", 1.76},  /* trigonal carbon */
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
    {LYSINE, "NZ", 1.50}, /* tetrahedral nitrogen */
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
    {NULL, NULL, 0.0},
};
