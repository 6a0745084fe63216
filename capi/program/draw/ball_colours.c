#include "draw/ball_colours.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "draw/ball_values.h"
#include "draw/colour_mixed.h"
#include "draw/residue_colours.h"
#include "hardsphere.h"
#include "read/residue_kinds.h"
#include "read/residues.h"

/* With more balls than this, colours of elements are specks, and colours of chains show more. */
enum { MOST_BALLS_BY_ELEMENT = 2000 };

enum { CARBON = 6 };

/* From blue over a neutral grey to red. So many steps cannot be distinguished, and pictures write a colour once for all
 * balls that have it. */
enum { RAMP_STEPS = 64 };
static const uint32_t ramp[3] = {0x3F74B5, 0xE8E8E8, 0xC2452F};

/* How sure AlphaFold is of a residue, in the colours of its database (J. Jumper et al., Nature 596 (2021) 583). */
static const struct colour_band plddt[] = {
    {90.0, 0x0053D6, "> 90"}, {70.0, 0x65CBF3, "70 - 90"}, {50.0, 0xFFDB13, "50 - 70"}, {-INFINITY, 0xFF7D45, "< 50"}};
enum { PLDDT_BANDS = sizeof plddt / sizeof plddt[0] };

/* Carbon of ligands, among tints and muted elements. */
static const uint32_t ligand_carbon = 0x7E8A93;

/* The share of white that is added on a dark page. */
static const double lighter = 0.15;

/* A ball that is not highlighted keeps this share of its own colour. Highlighted carbon must not be grey among grey,
 * also for people who see no red or no green: it is darker than the grey on a light page, lighter on a dark one. */
static const uint32_t plain = 0xDEDBD4;
static const double kept = 0.25;
static const uint32_t dark_plain = 0x5E636C;
static const uint32_t highlighted_carbon = 0x1F8F92, dark_highlighted_carbon = 0x7FE0CC;

/* The number of chains, up to two, by the numbers of their atoms: of all chains, or only of those of nucleotides. */
static int count_chains(const struct molecule *molecule, const uint32_t *number, bool of_nucleotides) {
  uint32_t first = UINT32_MAX;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_label *label = &molecule->label[i];
    if (!atom_is_of_chain(label)) continue;
    if (of_nucleotides && residue_kind_of(label->residue->name) != RESIDUE_NUCLEOTIDE) continue;
    if (first == UINT32_MAX) first = number[i];
    if (number[i] != first) return 2;
  }
  return first == UINT32_MAX ? 0 : 1;
}

/* Whether colours stand for chains where the user says nothing: in large molecules of several, and in strands, where
 * elements do not tell which is which. */
static bool is_by_chain(const struct drawing *drawing, const struct molecule *molecule, const uint32_t *number) {
  const bool many = drawing->by_chain || molecule->atoms > MOST_BALLS_BY_ELEMENT;
  const int chains = many ? count_chains(molecule, number, false) : 0;
  return chains == 2 || (chains == 1 && drawing->tints_one) || count_chains(molecule, number, true) == 2;
}

/* If the file names no element, grey is better than the bright colour of unknown elements. */
static uint32_t number_of(const struct atom_label *label) {
  return label->element.text[0] == '\0' ? CARBON : element_atomic_number(label->element);
}

/* Phosphate and sugar; of names like O5' or, in old files, O5*. */
static bool is_of_backbone(const struct atom_label *label) {
  return strpbrk(label->name, "'*P") != NULL;
}

/* All atoms of a chain look as one body: elements but carbon are darker by five steps of L* alone, and bases of
 * nucleotides as much lighter. The tints of the library come back after some chains, then as paler ones. */
static uint32_t tint_of(const struct atom_label *label, uint32_t chain) {
  enum { TINTS = 12 };
  const uint32_t tint = hsp_palette_colour(HSP_PALETTE_CHAIN, CARBON, chain);
  const uint32_t own = chain / TINTS % 2 == 0 ? tint : colour_mixed(tint, 0xFFFFFF, 0.4);
  const bool of_base = residue_kind_of(label->residue->name) == RESIDUE_NUCLEOTIDE && !is_of_backbone(label);
  if (of_base) return colour_mixed(own, 0xFFFFFF, 0.35);
  return number_of(label) == CARBON ? own : colour_mixed(own, 0x000000, 0.06);
}

static uint32_t colour_of(const struct atom_label *label, uint32_t palette, uint32_t chain) {
  if (palette != HSP_PALETTE_CHAIN) return hsp_palette_colour(palette, number_of(label), chain);
  if (atom_is_of_chain(label) || atom_is_water(label)) return tint_of(label, chain);
  return number_of(label) == CARBON ? ligand_carbon : hsp_palette_colour(HSP_PALETTE_SOFT, number_of(label), 0);
}

/* Numbers of chains become colours of elements or chains. */
static void colour_by_palette(const struct molecule *molecule, uint32_t palette, uint32_t *colour,
                              struct ball_palette *said) {
  said->name = drawing_palette_name(palette);
  said->remark = palette == HSP_PALETTE_CHAIN ? "a tint for each chain, ligands and ions by element" : "by element";
  for (uint32_t i = 0; i < molecule->atoms; ++i) colour[i] = colour_of(&molecule->label[i], palette, colour[i]);
}

static void colour_by_residue(const struct molecule *molecule, uint32_t *colour, struct ball_palette *said) {
  said->name = "residue";
  said->remark = "by kind of residue, ligands and ions by element";
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_label *label = &molecule->label[i];
    struct residue_colour own;
    if (residue_colour_find(label->residue->name, &own)) {
      colour[i] = own.colour;
      continue;
    }
    const bool alone = !atom_is_of_chain(label) && !atom_is_water(label);
    colour[i] = alone ? colour_of(label, HSP_PALETTE_CHAIN, 0) : hsp_palette_colour(HSP_PALETTE_SOFT, CARBON, 0);
  }
}

static uint32_t band_colour(const struct ball_palette *palette, double value) {
  size_t k = 0;
  while (k + 1 < palette->bands && !(value > palette->band[k].above)) ++k;
  return palette->band[k].colour;
}

/* Halves first, so that no difference overflows. */
uint32_t ball_palette_colour(const struct ball_palette *palette, double value) {
  if (palette->bands > 0) return band_colour(palette, value);
  const double low = palette->low;
  const double high = palette->high;
  const double part = high > low ? (value / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0) : 0.5;
  const double within = part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
  const int rising = (int)(within * RAMP_STEPS + 0.5);
  const int step = palette->falls ? RAMP_STEPS - rising : rising;
  const int half = RAMP_STEPS / 2;
  return step <= half ? colour_mixed(ramp[0], ramp[1], (double)step / half)
                      : colour_mixed(ramp[1], ramp[2], (double)step / half - 1.0);
}

static bool colour_by_value(const struct drawing *drawing, const struct molecule *molecule, uint32_t *colour,
                            struct ball_palette *said, struct failure *failure) {
  double *value = NULL;
  if (!ball_values_make(drawing, molecule, &value, failure)) return false;
  static const char *const quantities[] = {[COLOUR_AREA] = "area",
                                           [COLOUR_BFACTOR] = "B factor",
                                           [COLOUR_CHARGE] = "charge, e",
                                           [COLOUR_PLDDT] = "pLDDT",
                                           [COLOUR_FILE] = "value"};
  said->name = "ramp";
  said->remark = NULL;
  said->quantity = quantities[drawing->colour];
  said->power = drawing->colour == COLOUR_AREA || drawing->colour == COLOUR_BFACTOR ? 2 : 0;
  if (drawing->colour == COLOUR_PLDDT) {
    said->name = "plddt";
    said->remark = "AlphaFold's four bands of how sure it is";
    said->band = plddt;
    said->bands = PLDDT_BANDS;
  }
  said->low = drawing->range[0];
  said->high = drawing->range[1];
  for (uint32_t i = 0; i < molecule->atoms && !drawing->range_given; ++i) {
    if (i == 0 || value[i] < said->low) said->low = value[i];
    if (i == 0 || value[i] > said->high) said->high = value[i];
  }
  said->falls = drawing->colour == COLOUR_CHARGE;
  if (said->falls && !drawing->range_given) {
    /* No charge is white. */
    said->high = -said->low > said->high ? -said->low : said->high;
    said->low = -said->high;
  }
  for (uint32_t i = 0; i < molecule->atoms; ++i) colour[i] = ball_palette_colour(said, value[i]);
  free(value);
  return true;
}

/* Mute all other balls: on a dark page to a dark grey, so that they recede. */
static bool mute_others(const struct selection *highlight, const struct molecule *molecule, bool by_element, bool dark,
                        uint32_t *colour, struct failure *failure) {
  bool any = false;
  if (highlight->count == 0) return true;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (selection_takes(highlight, molecule, i)) {
      any = true;
      if (by_element && number_of(&molecule->label[i]) == CARBON)
        colour[i] = dark ? dark_highlighted_carbon : highlighted_carbon;
    } else {
      colour[i] = colour_mixed(dark ? dark_plain : plain, colour[i], kept);
    }
  }
  return any || failure_in_input(failure, 0, "--highlight names no atom that is drawn");
}

bool ball_colours_make(const struct drawing *drawing, const struct selection *highlight,
                       const struct molecule *molecule, uint32_t **colour, struct ball_palette *palette,
                       struct failure *failure) {
  *palette = (struct ball_palette){.name = NULL};
  if (!chain_numbers_make(molecule, colour, failure)) return false;
  bool done = true;
  bool by_element = false;
  if (drawing_is_of_values(drawing)) {
    done = colour_by_value(drawing, molecule, *colour, palette, failure);
  } else if (drawing->colour == COLOUR_RESIDUE) {
    colour_by_residue(molecule, *colour, palette);
  } else {
    const bool by_chain =
        drawing->colour == COLOUR_CHAIN || (drawing->colour < 0 && is_by_chain(drawing, molecule, *colour));
    const uint32_t usual = by_chain ? HSP_PALETTE_CHAIN : HSP_PALETTE_SOFT;
    const uint32_t chosen = drawing->palette >= 0 ? (uint32_t)drawing->palette : usual;
    by_element = chosen != HSP_PALETTE_CHAIN;
    colour_by_palette(molecule, chosen, *colour, palette);
  }
  for (uint32_t i = 0; done && drawing->lightens && !drawing_is_of_values(drawing) && i < molecule->atoms; ++i) {
    (*colour)[i] = colour_mixed((*colour)[i], 0xFFFFFF, lighter);
  }
  if (done && mute_others(highlight, molecule, by_element, drawing->lightens, *colour, failure)) return true;
  free(*colour);
  return false;
}
