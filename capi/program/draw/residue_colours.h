/* Colours by the kind of residue to which an atom belongs. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* A colour and its meaning for a legend. */
struct residue_colour {
  uint32_t colour;
  const char *kind;
  int rank; /* the place of the kind in a legend */
};

/* Amino acids have colours by their side chains: positively charged blue, negatively charged red, polar green, aromatic
 * violet, with sulfur yellow, others greyish brown, glycine nearly white; people who do not distinguish red from green
 * can tell them apart, too. Nucleotides have colours by their base. False: the residue is none of these. */
bool residue_colour_find(const char *name, struct residue_colour *colour);
