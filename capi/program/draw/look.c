#include "draw/look.h"

#include <stdbool.h>

#include "draw/drawing.h"
#include "hardsphere.h"

/* Negative numbers leave the choice to `draw`. */
struct look {
  int style;
  int background;
  int outline_colour;
  int text_colour; /* of texts over the picture; if the user gives a colour of lines, texts have it, too */
  int ink_colour;
  double outline;
  double fog;
  double occlusion;
  bool darkens;         /* buried balls, also in the flat style */
  bool by_chain;        /* colours of molecules of two chains or more, also of small ones */
  bool tints_one;       /* colours of molecules of one chain */
  double stick_outline; /* of balls and sticks: their contours */
  double fog_of_many;   /* with more sticks than one takes in at a glance */
  double width, height; /* px */
};

/* In the order of their names in the table of options.
 *   paper     light and contours on white
 *   goodsell  after D. S. Goodsell's pictures: flat colours, darker in depth, contours, no lines between bonded atoms
 *   slide     light on dark, 16:9; lines are a little lighter than the background, around the molecule, too: those of
 *             its colour would be gaps, which nibble at outlines and leave slivers without a body
 *   print     for printers without colours or with little ink: flat, nothing darkened or faded, black lines */
static const struct look looks[] = {
    {-1, -1, -1, -1, -1, -1.0, -1.0, -1.0, true, false, false, 2.0, -1.0, -1.0, -1.0},
    {(int)HSP_STYLE_FLAT, -1, -1, -1, -1, 0.0, 0.4, -1.0, true, true, true, 2.0, -1.0, -1.0, -1.0},
    {-1, DARK_PAGE, DARK_PAGE_LINES, DARK_PAGE_TEXT, DARK_PAGE_LINES, 1.0, 0.15, 0.1, true, true, false, 1.0, 0.5,
     1600.0, 900.0},
    {(int)HSP_STYLE_FLAT, -1, 0x000000, -1, 0x000000, -1.0, 0.0, 0.0, false, true, false, 2.0, -1.0, -1.0, -1.0},
};

static void choose(int *choice, int preset) {
  if (*choice < 0) *choice = preset;
}
static void choose_number(double *number, double preset) {
  if (*number < 0.0) *number = preset;
}

void look_apply(struct drawing *drawing) {
  if (drawing->look < 0) return;
  const struct look *look = &looks[drawing->look];
  const bool of_sticks = drawing_is_of_sticks(drawing);
  choose(&drawing->style, look->style);
  /* Without a background the colour to which far balls fade is not known, unless the user gives it. */
  if (drawing->background != DRAWING_NO_BACKGROUND || drawing->fog_colour >= 0) {
    if (drawing->fog < 0.0) drawing->fog_of_many = look->fog_of_many;
    choose_number(&drawing->fog, look->fog);
  }
  choose(&drawing->background, look->background);
  if (drawing->outline_colour < 0) drawing->text_colour = look->text_colour;
  choose(&drawing->outline_colour, of_sticks && look->background >= 0 ? look->background : look->outline_colour);
  for (int level = 0; level < INK_LEVELS; ++level) choose(&drawing->ink_colour[level], look->ink_colour);
  if (of_sticks) {
    choose_number(&drawing->outline, look->stick_outline);
  } else {
    drawing->ink = true;
    choose_number(&drawing->outline, look->outline);
    choose_number(&drawing->occlusion, look->occlusion);
  }
  drawing->darkens = look->darkens;
  drawing->by_chain = look->by_chain;
  drawing->tints_one = look->tints_one;
  drawing->lightens = look->background >= 0;
  const bool sized = drawing->width >= 0.0 || drawing->height >= 0.0 || drawing->scale >= 0.0 || drawing->crop_given;
  if (!sized && drawing->unit != (int)HSP_UNIT_MM) {
    drawing->width = look->width;
    drawing->height = look->height;
  }
}
