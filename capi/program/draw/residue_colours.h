/* Colours that tell what kind of residue an atom belongs to. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* A colour and what it stands for, as a legend says it. */
struct residue_colour {
  uint32_t colour;
  const char *kind;
  int rank; /* of the kind, in a legend */
};

/* The colour of amino acids by their side chains: with a positive charge blue, with a negative one red, polar green,
 * aromatic violet, with sulfur yellow, other ones greyish brown, glycine nearly white, all apart without red or green,
 * too; and of nucleotides by their base. False: the residue is none of these. */
bool residue_colour_find(const char *name, struct residue_colour *colour);
