/* The request of a user of `draw`: the values of its options, for the part of the program that draws. */
#pragma once

#include <stdbool.h>

#include "commands/viewing.h"
#include "read/selection.h"

/* The meaning of colours. */
enum {
  COLOUR_ELEMENT,
  COLOUR_CHAIN,
  COLOUR_RESIDUE,
  COLOUR_AREA,
  COLOUR_BFACTOR,
  COLOUR_CHARGE,
  COLOUR_PLDDT,
  COLOUR_FILE
};

/* The things that have labels. */
enum { LABEL_ATOM, LABEL_RESIDUE, LABEL_CHAIN };

/* The levels HSP_INK_BORDER and so on. */
enum { INK_LEVELS = 3 };

/* Numbers and choices are negative if the user has not given them. Choices are numbered as in hardsphere.h; see
 * drawing_is_of_map. */
struct drawing {
  const char *out; /* a file, or NULL */
  const char *title;
  struct viewing viewing;
  struct selection highlight;
  struct given_vector centre; /* of a fixed frame */
  int format;                 /* if the user has not given it, drawing_check takes it from the extension of `out` */
  int style;
  int palette;
  int colour;              /* COLOUR_* */
  const char *colour_file; /* for COLOUR_FILE */
  bool range_given;
  double range[2]; /* the numbers at the ends of the colour ramp */
  int unit;
  int pieces;
  int as;         /* see drawing_is_of_sticks */
  int background; /* 0xRRGGBB, or DRAWING_NO_BACKGROUND */
  int outline_colour;
  int text_colour; /* of texts over the picture; < 0: that of lines */
  int fog_colour;  /* of fog, if the picture has no background */
  uint32_t spin;   /* number of pictures of one turn; 0: not given */
  double width;
  double height;
  double outline;
  double fog;
  double fog_of_many; /* for many sticks, if the look has another value for them */
  double margin;
  double scale; /* of a fixed frame */
  bool crop_given;
  double crop[4]; /* left, top, width and height of the wanted part of the picture, in its unit */
  double occlusion;
  double ball_size; /* with sticks: the balls' radii as parts of those of the atoms */
  double stick;     /* radius of sticks */
  int label;        /* LABEL_* */
  bool scale_bar;
  bool legend;
  bool all_balls;
  bool water; /* it is drawn, not left out */
  bool ink;
  double ink_width[INK_LEVELS];
  int ink_colour[INK_LEVELS];
  int look;       /* see look.h */
  bool lightens;  /* set by looks: colours become lighter, as dark pages make them look darker */
  bool darkens;   /* set by looks: buried balls become darker if the user does not state the occlusion */
  bool by_chain;  /* set by looks: molecules with two chains or more have colours by chain, also small ones */
  bool tints_one; /* set by looks: with one chain, too */
  bool classes;   /* names of elements, residues and chains for style sheets */
  bool tooltips;  /* names of atoms beside the pointer */
};

#define DRAWING_NO_BACKGROUND 0x1000000

#define DRAWING_DEFAULT                                                                                         \
  {                                                                                                             \
    .format = -1, .style = -1, .palette = -1, .colour = -1, .unit = -1, .pieces = -1, .as = -1, .label = -1,    \
    .background = -1, .outline_colour = -1, .text_colour = -1, .fog_colour = -1, .width = -1.0, .height = -1.0, \
    .outline = -1.0, .fog = -1.0, .fog_of_many = -1.0, .margin = -1.0, .scale = -1.0, .occlusion = -1.0,        \
    .ball_size = -1.0, .stick = -1.0, .ink_width = {-1.0, -1.0, -1.0}, .ink_colour = {-1, -1, -1}, .look = -1   \
  }
