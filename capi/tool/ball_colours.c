#include "ball_colours.h"

#include <stddef.h>

#include "hardsphere.h"
#include "residue_kinds.h"
#include "residues.h"

/* With more balls than that, elements are specks; what is to be seen are chains. */
enum { MOST_BALLS_BY_ELEMENT = 2000 };

enum { CARBON = 6 };

/* Of chains of residues: what the file calls HETATM belongs to them if it is a modified residue. */
static bool is_of_chain(const struct atom_label *label) {
  if (!label->hetatm) return true;
  const enum residue_kind kind = residue_kind_of(label->residue.name);
  return kind == RESIDUE_AMINO_ACID || kind == RESIDUE_NUCLEOTIDE;
}

/* Whether atoms of chains have more than one of these numbers. */
static bool has_chains(const struct molecule *molecule, const uint32_t *number) {
  uint32_t first = UINT32_MAX;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (!is_of_chain(&molecule->label[i])) continue;
    if (first == UINT32_MAX) first = number[i];
    if (number[i] != first) return true;
  }
  return false;
}

static uint32_t colour_of(const struct atom_label *label, uint32_t palette, uint32_t chain) {
  /* Where the file names no element, grey is better than the loud colour of elements that nobody knows. */
  const uint32_t number = label->element.text[0] == '\0' ? CARBON : element_atomic_number(label->element);
  const bool alone = palette == HSP_PALETTE_CHAIN && !is_of_chain(label) && !atom_is_water(label);
  return hsp_palette_colour(alone ? HSP_PALETTE_JMOL : palette, number, chain);
}

bool ball_colours_make(const struct drawing *drawing, const struct molecule *molecule, uint32_t **colour,
                       uint32_t *palette, struct failure *failure) {
  if (!chain_numbers_make(molecule, colour, failure)) return false;
  *palette = HSP_PALETTE_SOFT;
  if (drawing->palette >= 0) {
    *palette = (uint32_t)drawing->palette;
  } else if (molecule->atoms > MOST_BALLS_BY_ELEMENT && has_chains(molecule, *colour)) {
    *palette = HSP_PALETTE_CHAIN;
  }
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    (*colour)[i] = colour_of(&molecule->label[i], *palette, (*colour)[i]);
  }
  return true;
}
