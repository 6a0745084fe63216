/* The colour of each ball in a picture, before light and occlusion. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "draw/drawing.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/selection.h"

/* The meaning of the colours that were chosen. */
struct ball_palette {
  const char *name;               /* "soft", "jmol", "chain", "residue", "plddt" or "ramp" */
  const char *remark;             /* the name for persons; NULL for a ramp, which has: */
  const char *quantity;           /* the name of the numbers; NULL if colours stand for no numbers */
  int power;                      /* the unit of the numbers is this power of the unit of length */
  double low, high;               /* the numbers at its ends */
  bool falls;                     /* it goes from red to blue, as is usual for charges */
  const struct colour_band *band; /* [bands], if each colour stands for all numbers above a least one */
  size_t bands;
};

struct colour_band {
  double above;
  uint32_t colour;
  const char *name;
};

/* The colour of a number on a ramp. */
uint32_t ball_palette_colour(const struct ball_palette *palette, double value);

/* Make the colour of every ball, 0xRRGGBB, and find the meaning of colours: the user's choice; else the chain in large
 * molecules with several chains, and the element in all others. If colours stand for chains or residues, ligands and
 * ions have colours by element, with another carbon, so that they are found at a glance. If something is highlighted,
 * everything else is nearly grey; if colours stand for elements, highlighted carbon is teal. Free *colour on true. */
bool ball_colours_make(const struct drawing *drawing, const struct selection *highlight,
                       const struct molecule *molecule, uint32_t **colour, struct ball_palette *palette,
                       struct failure *failure);
