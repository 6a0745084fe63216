#include "draw/drawing.h"

#include <string.h>

#include "hardsphere.h"
#include "read/file_format.h"
#include "write/output_file.h"

enum { FORMATS = 3, STYLES = 3, PALETTES = 3 };

/* All that is visible, after the kinds of pieces that the library numbers. */
enum { PIECES_VISIBLE = 2 };

/* In the order of their numbers in hardsphere.h. */
static const char *const style_names[STYLES] = {"flat", "headlight", "soft"};
static const char *const palette_names[PALETTES] = {"soft", "jmol", "chain"};
static const char *const colour_names[COLOUR_FILE] = {"element", "chain",  "residue", "area",
                                                      "bfactor", "charge", "plddt"};
static const char *const format_names[FORMATS] = {"SVG", "EPS", "PDF"};

/* With more balls than MOST_SOFT_BALLS the shading of single balls is not worth its bytes: in molecules of that size
 * the depth of balls shows more. */
enum { MOST_SOFT_BALLS = 2000 };

/* As wide as the text of a page, which .eps and .pdf are for. */
static const double default_px = 1000.0;
static const double default_millimetres = 170.0;
static const double px_per_millimetre = 96.0 / 25.4;

/* The format that --picture asks for, or the name; SVG for what goes to standard output. */
static bool find_format(struct drawing *drawing) {
  if (drawing->format >= 0) return true;
  drawing->format = file_extension_among(drawing->out, format_names, FORMATS);
  if (drawing->format < 0 && output_is_standard(drawing->out)) drawing->format = (int)HSP_FORMAT_SVG;
  return drawing->format >= 0;
}

bool drawing_check(struct drawing *drawing, struct failure *failure) {
  if (drawing->out == NULL) return failure_in_usage(failure, "draw needs -o OUT, a file .svg, .eps or .pdf");
  if (!find_format(drawing)) {
    char shown[EXCERPT_BYTES];
    return failure_in_usage(failure, "-o: '%s' is no .svg, .eps or .pdf file",
                            excerpt(shown, drawing->out, strlen(drawing->out)));
  }
  const bool sticks = drawing_is_of_sticks(drawing), of_map = drawing_is_of_map(drawing);
  const bool bare = drawing->background == DRAWING_NO_BACKGROUND, svg = drawing->format == (int)HSP_FORMAT_SVG;
  const struct usage_rule frame[] = {
      {drawing->centre.given && drawing->scale < 0.0, "--centre needs --scale"},
      {drawing->margin >= 0.0 && drawing->scale >= 0.0, "either --margin around all that is seen, or --scale"},
      {drawing->spin > 0 && output_is_standard(drawing->out), "--spin writes several files: standard output is one"},
      {drawing->range_given && (!drawing_is_of_values(drawing) || drawing->colour == COLOUR_PLDDT),
       "--range is for colours that stand for numbers: it needs --colour area, bfactor, charge or a file"},
  };
  const struct usage_rule others[] = {
      {drawing->classes && !svg, "--classes is for .svg: other formats have none"},
      {drawing->tooltips && !svg, "--tooltips is for .svg: other formats have none"},
      {drawing->fog_colour >= 0 && !bare,
       "--fog-colour is for --background none: fog has the colour of the background"},
      {drawing->fog > 0.0 && drawing->fog_colour < 0 && bare,
       "--fog with --background none needs --fog-colour, the colour of what lies behind"},
      {drawing->all_balls && of_map, "either --all-balls, hidden ones too, or --pieces visible"},
      {sticks && drawing->pieces >= 0 && !of_map, "--as ball-and-stick has no --pieces but visible"},
      {sticks && (drawing->all_balls || drawing->occlusion > 0.0),
       "--all-balls and --occlusion are not for --as ball-and-stick"},
      {!sticks && (drawing->ball_size >= 0.0 || drawing->stick >= 0.0),
       "--ball-size and --stick are for --as ball-and-stick"},
  };
  if (!usage_rules_hold(frame, sizeof frame / sizeof frame[0], failure)) return false;
  const int palette_of = drawing->palette == (int)HSP_PALETTE_CHAIN ? COLOUR_CHAIN : COLOUR_ELEMENT;
  if (drawing->palette >= 0 && drawing->colour >= 0 && drawing->colour != palette_of) {
    return failure_in_usage(failure, "--palette %s is of colours by %s", palette_names[drawing->palette],
                            colour_names[palette_of]);
  }
  return usage_rules_hold(others, sizeof others / sizeof others[0], failure);
}

bool drawing_is_of_sticks(const struct drawing *drawing) {
  return drawing->as == 1;
}

bool drawing_is_of_map(const struct drawing *drawing) {
  return drawing->pieces == PIECES_VISIBLE;
}

bool drawing_is_annotated(const struct drawing *drawing) {
  return drawing->label >= 0 || drawing->scale_bar || drawing->legend;
}

bool drawing_has_ink(const struct drawing *drawing) {
  const double *const width = drawing->ink_width;
  return drawing->ink && !(width[0] == 0.0 && width[1] == 0.0 && width[2] == 0.0);
}

bool drawing_is_of_values(const struct drawing *drawing) {
  return drawing->colour >= COLOUR_AREA;
}

uint32_t drawing_style(const struct drawing *drawing, uint32_t balls) {
  if (drawing->style >= 0) return (uint32_t)drawing->style;
  return balls <= MOST_SOFT_BALLS ? HSP_STYLE_SOFT : HSP_STYLE_FLAT;
}

double drawing_occlusion(const struct drawing *drawing, uint32_t balls) {
  if (drawing->occlusion >= 0.0) return drawing->occlusion;
  if (drawing_is_of_sticks(drawing) || drawing_is_of_values(drawing)) return 0.0;
  const bool deep = drawing->darkens || balls > MOST_SOFT_BALLS;
  return deep || drawing_style(drawing, balls) == HSP_STYLE_SOFT ? 0.5 : 0.0;
}

double drawing_default_width(const struct drawing *drawing) {
  if (drawing->unit == (int)HSP_UNIT_MM) return default_millimetres;
  return drawing->format == (int)HSP_FORMAT_SVG ? default_px : default_millimetres * px_per_millimetre;
}

const char *drawing_format_name(uint32_t format) {
  return format_names[format];
}

const char *drawing_style_name(uint32_t style) {
  return style_names[style];
}

const char *drawing_palette_name(uint32_t palette) {
  return palette_names[palette];
}
