/* The request of a user of `draw`: what the options say, which the part of the program that draws reads. */
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

/* The things that labels name. */
enum { LABEL_ATOM, LABEL_RESIDUE, LABEL_CHAIN };

/* HSP_INK_BORDER and so on. */
enum { INK_LEVELS = 3 };

/* Numbers and choices are negative where the user has said nothing. Choices are numbered as in hardsphere.h;
 * see drawing_is_of_map. */
struct drawing {
  const char *out; /* a file, or NULL */
  const char *title;
  struct viewing viewing;
  struct selection highlight;
  struct given_vector centre; /* of a fixed frame */
  int format;                 /* where the user has not said, drawing_check sets it by the extension of out */
  int style;
  int palette;
  int colour;              /* COLOUR_* */
  const char *colour_file; /* of COLOUR_FILE */
  bool range_given;
  double range[2]; /* of numbers: the ends of the ramp */
  int unit;
  int pieces;
  int as;         /* see drawing_is_of_sticks */
  int background; /* 0xRRGGBB, or DRAWING_NO_BACKGROUND */
  int outline_colour;
  int text_colour; /* of what is written over the picture; < 0: that of lines */
  int fog_colour;  /* of what lies behind a picture without a background */
  uint32_t spin;   /* pictures of one turn; 0: not said */
  double width;
  double height;
  double outline;
  double fog;
  double fog_of_many; /* of many sticks, if a look has one of its own for them */
  double margin;
  double scale; /* of a fixed frame */
  bool crop_given;
  double crop[4]; /* left, top, width and height of the part of the picture that is wanted, in its unit */
  double occlusion;
  double ball_size; /* of sticks: parts of the radii */
  double stick;     /* radius */
  int label;        /* LABEL_* */
  bool scale_bar;
  bool legend;
  bool all_balls;
  bool water; /* is drawn, and not left out */
  bool ink;
  double ink_width[INK_LEVELS];
  int ink_colour[INK_LEVELS];
  int look;       /* see look.h */
  bool lightens;  /* colours, which dark pages make look darker: looks do */
  bool darkens;   /* buried balls, where the user says nothing of occlusion: looks do */
  bool by_chain;  /* colours of molecules with two chains or more: likewise, of palettes */
  bool tints_one; /* of one chain, too: likewise */
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
