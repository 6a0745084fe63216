/* Which colour each ball of a picture gets, before light and occlusion. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "draw/drawing.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/selection.h"

/* The meaning of colours, in the end. */
struct ball_palette {
  const char *name;               /* "soft", "jmol", "chain", "residue", "plddt" or "ramp" */
  const char *remark;             /* how a person reads that; NULL for a ramp: */
  const char *quantity;           /* what numbers are; NULL where colours stand for none */
  int power;                      /* of the molecule's unit of length, that is the quantity's */
  double low, high;               /* between these it goes */
  bool falls;                     /* from red to blue, as is usual for charges */
  const struct colour_band *band; /* [bands], where a colour stands for all numbers above a least one */
  size_t bands;
};

struct colour_band {
  double above;
  uint32_t colour;
  const char *name;
};

/* The colour that a ramp has for a number. */
uint32_t ball_palette_colour(const struct ball_palette *palette, double value);

/* The colour of every ball, 0xRRGGBB, to be freed on true, and what it stands for: what the user says; else the
 * chain in large molecules with several, and the element in all others. Where colours stand for chains or residues,
 * ligands and ions have colours by element, with carbon of its own, so that they are found at a glance. The rest,
 * if anything is highlighted, is nearly grey; among elements highlighted carbon is teal. */
bool ball_colours_make(const struct drawing *drawing, const struct selection *highlight,
                       const struct molecule *molecule, uint32_t **colour, struct ball_palette *palette,
                       struct failure *failure);
