#include "draw/drawing.h"

#include <stddef.h>
#include <string.h>

#include "draw/look.h"
#include "hardsphere.h"
#include "read/characters.h"
#include "read/fields.h"
#include "read/number.h"
#include "write/output_file.h"

enum { FORMATS = 3, STYLES = 3, PALETTES = 3, UNITS = 2, PIECES = 3, KINDS = 2 };

/* In the order of their numbers in hardsphere.h; what is visible comes last. */
static const char *const style_names[STYLES] = {"flat", "headlight", "soft"};
static const char *const palette_names[PALETTES] = {"soft", "jmol", "chain"};
static const char *const colour_names[COLOUR_FILE] = {"element", "chain", "residue", "area", "bfactor", "charge"};
static const char *const unit_names[UNITS] = {"px", "mm"};
static const char *const piece_names[PIECES] = {"g", "h", "visible"};
static const char *const label_names[LABELS] = {"atom", "residue", "chain"};
static const char *const kind_names[KINDS] = {"balls", "ball-and-stick"};
static const char *const format_names[FORMATS] = {"SVG", "EPS", "PDF"};
static const char *const picture_names[FORMATS] = {"svg", "eps", "pdf"};

/* Above MOST_SOFT_BALLS shading of single balls tells less than it costs in bytes. What tells something about molecules
 * of that size is how deep their balls lie. */
enum { MOST_SOFT_BALLS = 2000 };

/* More than that is a slip of the finger. */
enum { MOST_PICTURES = 10000 };

/* As wide as the text of a page, which .eps and .pdf are for. */
static const double default_px = 1000.0;
static const double default_millimetres = 170.0;
static const double px_per_millimetre = 96.0 / 25.4;

struct number_option {
  const char *name;
  size_t place;      /* in struct drawing */
  bool positive;     /* 0 is too small */
  double most;       /* the largest that is allowed */
  const char *range; /* how a person reads that */
};

static const struct number_option number_options[] = {
    {"--width", offsetof(struct drawing, width), true, 1e6, "above 0 and at most 1000000"},
    {"--height", offsetof(struct drawing, height), true, 1e6, "above 0 and at most 1000000"},
    {"--outline", offsetof(struct drawing, outline), false, 1e6, "between 0 and 1000000"},
    {"--fog", offsetof(struct drawing, fog), false, 1.0, "between 0 and 1"},
    {"--margin", offsetof(struct drawing, margin), false, 10.0, "between 0 and 10"},
    {"--scale", offsetof(struct drawing, scale), true, 1e9, "above 0 and at most 1000000000"},
    {"--occlusion", offsetof(struct drawing, occlusion), false, 1.0, "between 0 and 1"},
    {"--ball-size", offsetof(struct drawing, ball_size), true, 1.0, "above 0 and at most 1"},
    {"--stick", offsetof(struct drawing, stick), true, 1e6, "above 0 and at most 1000000"},
};

struct choice_option {
  const char *name;
  size_t place;
  const char *const *words;
  int count;
  const char *what;
};

static const struct choice_option choice_options[] = {
    {"--style", offsetof(struct drawing, style), style_names, STYLES, "flat, headlight or soft"},
    {"--palette", offsetof(struct drawing, palette), palette_names, PALETTES, "soft, jmol or chain"},
    {"--unit", offsetof(struct drawing, unit), unit_names, UNITS, "px or mm"},
    {"--picture", offsetof(struct drawing, format), picture_names, FORMATS, "svg, eps or pdf"},
    {"--pieces", offsetof(struct drawing, pieces), piece_names, PIECES, "g, h or visible"},
    {"--as", offsetof(struct drawing, as), kind_names, KINDS, "balls or ball-and-stick"},
    {"--label", offsetof(struct drawing, label), label_names, LABELS, "atom, residue or chain"},
    {"--look", offsetof(struct drawing, look), look_names, LOOKS, "paper, goodsell, slide or print"},
};

static bool twice(const struct option_reader *reader, const char *option) {
  return failure_in_usage(reader->failure, "%s is given twice", option);
}

static bool take_number(struct option_reader *reader, const struct number_option *option, const char *value,
                        double *number) {
  if (!option_value(reader, option->name, &value, "a number")) return false;
  if (*number >= 0.0) return twice(reader, option->name);
  if (!option_number(reader, option->name, value, number)) return false;
  if (*number >= 0.0 && *number <= option->most && !(option->positive && *number == 0.0)) return true;
  return failure_in_usage(reader->failure, "%s must be %s", option->name, option->range);
}

static bool take_choice(struct option_reader *reader, const struct choice_option *option, const char *value,
                        int *choice) {
  if (!option_value(reader, option->name, &value, option->what)) return false;
  if (*choice >= 0) return twice(reader, option->name);
  *choice = option_choice(reader, option->name, value, option->words, option->count);
  return *choice >= 0;
}

static int hexadecimal_digit(char c) {
  if (is_digit(c)) return c - '0';
  const char lower = to_lower(c);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/* Behind --background stands a colour or none, behind the others a colour. */
static bool take_colour(struct option_reader *reader, const char *option, bool or_none, const char *value,
                        int *colour) {
  if (!option_value(reader, option, &value, or_none ? "RRGGBB or none" : "RRGGBB")) return false;
  if (*colour >= 0) return twice(reader, option);
  if (or_none && strcmp(value, "none") == 0) {
    *colour = DRAWING_NO_BACKGROUND;
    return true;
  }
  const char *digits = value[0] == '#' ? value + 1 : value;
  int number = 0;
  bool good = strlen(digits) == 6;
  for (int i = 0; good && i < 6; ++i) {
    const int digit = hexadecimal_digit(digits[i]);
    good = digit >= 0;
    number = 16 * number + digit;
  }
  if (good) {
    *colour = number;
    return true;
  }
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reader->failure, "%s: '%s' is %s", option, excerpt(shown, value, strlen(value)),
                          or_none ? "neither RRGGBB nor none" : "not RRGGBB");
}

static bool take_what_colours_mean(struct option_reader *reader, const char *value, struct drawing *drawing) {
  static const char *const what = "element, chain, residue, area, bfactor, charge or a file";
  if (!option_value(reader, "--colour", &value, what)) return false;
  if (drawing->colour >= 0) return twice(reader, "--colour");
  for (int i = 0; i < COLOUR_FILE; ++i) {
    if (strcmp(value, colour_names[i]) == 0) drawing->colour = i;
  }
  if (drawing->colour >= 0) return true;
  if (strpbrk(value, "./") != NULL) { /* the words have neither */
    drawing->colour = COLOUR_FILE;
    drawing->colour_file = value;
    return true;
  }
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reader->failure, "--colour: '%s' is not %s with a dot or slash in its name",
                          excerpt(shown, value, strlen(value)), what);
}

static bool take_range(struct option_reader *reader, const char *value, struct drawing *drawing) {
  if (drawing->range_given) return twice(reader, "--range");
  drawing->range_given = true;
  if (!option_numbers(reader, "--range", value, "LH", drawing->range)) return false;
  return drawing->range[0] < drawing->range[1] ||
         failure_in_usage(reader->failure, "--range goes from a lower to a higher number");
}

static bool take_crop(struct option_reader *reader, const char *value, struct drawing *drawing) {
  if (drawing->crop_given) return twice(reader, "--crop");
  drawing->crop_given = true;
  if (!option_numbers(reader, "--crop", value, "XYWH", drawing->crop)) return false;
  for (int k = 0; k < 4; ++k) {
    if (drawing->crop[k] < -1e6 || drawing->crop[k] > 1e6) {
      return failure_in_usage(reader->failure, "--crop: numbers must be between -1000000 and 1000000");
    }
  }
  return (drawing->crop[2] > 0.0 && drawing->crop[3] > 0.0) ||
         failure_in_usage(reader->failure, "--crop: W and H must be above 0");
}

/* One number for all contours, or three. */
static bool take_ink_width(struct option_reader *reader, const char *value, struct drawing *drawing) {
  double *const width = drawing->ink_width;
  if (!option_value(reader, "--ink-width", &value, "a number or three")) return false;
  if (width[0] >= 0.0) return twice(reader, "--ink-width");
  const bool three = strpbrk(value, ", \t") != NULL;
  if (three ? !option_numbers(reader, "--ink-width", value, "BGD", width)
            : !option_number(reader, "--ink-width", value, width)) {
    return false;
  }
  for (int level = 0; level < INK_LEVELS; ++level) {
    if (!three) width[level] = width[0];
    if (!(width[level] >= 0.0 && width[level] <= 1e6)) {
      return failure_in_usage(reader->failure, "--ink-width must be between 0 and 1000000");
    }
  }
  drawing->ink = true;
  return true;
}

/* Likewise. */
static bool take_ink_colour(struct option_reader *reader, const char *value, struct drawing *drawing) {
  enum { DIGITS = 7 }; /* with # */
  int *const colour = drawing->ink_colour;
  if (!option_value(reader, "--ink-colour", &value, "RRGGBB or three of them")) return false;
  if (colour[0] >= 0) return twice(reader, "--ink-colour");
  int given = 0;
  for (const char *at = value; given < INK_LEVELS; ++at) {
    char digits[DIGITS + 2]; /* one more makes it none */
    size_t length = strcspn(at, ",");
    if (given == INK_LEVELS - 1 || length > DIGITS + 1) length = strlen(at) < DIGITS + 1 ? strlen(at) : DIGITS + 1;
    memcpy(digits, at, length);
    digits[length] = '\0';
    if (!take_colour(reader, "--ink-colour", false, digits, &colour[given])) return false;
    ++given;
    at += length;
    if (*at == '\0') break;
  }
  if (given == 2) return failure_in_usage(reader->failure, "--ink-colour: either one RRGGBB or three, not two");
  for (int level = given; level < INK_LEVELS; ++level) colour[level] = colour[0];
  drawing->ink = true;
  return true;
}

static bool take_spin(struct option_reader *reader, const char *value, int *spin) {
  uint64_t pictures = 0;
  if (!option_value(reader, "--spin", &value, "how many pictures")) return false;
  if (*spin >= 0) return twice(reader, "--spin");
  if (number_parse_count(value, strlen(value), &pictures) != NUMBER_OK || pictures < 1 || pictures > MOST_PICTURES) {
    return failure_in_usage(reader->failure, "--spin must be how many pictures, from 1 to %d", (int)MOST_PICTURES);
  }
  *spin = (int)pictures;
  return true;
}

static bool take_text(struct option_reader *reader, const char *option, const char *value, const char *what,
                      const char **text) {
  if (!option_value(reader, option, &value, what)) return false;
  if (*text != NULL) return twice(reader, option);
  *text = value;
  return true;
}

bool drawing_take_option(struct drawing *drawing, struct option_reader *reader, const char *argument, bool *known) {
  char *const base = (char *)drawing;
  const char *value = NULL;
  *known = true;
  for (size_t i = 0; i < sizeof number_options / sizeof number_options[0]; ++i) {
    const struct number_option *option = &number_options[i];
    if (option_is(argument, option->name, &value)) {
      return take_number(reader, option, value, (double *)(void *)(base + option->place));
    }
  }
  for (size_t i = 0; i < sizeof choice_options / sizeof choice_options[0]; ++i) {
    const struct choice_option *option = &choice_options[i];
    if (option_is(argument, option->name, &value)) {
      return take_choice(reader, option, value, (int *)(void *)(base + option->place));
    }
  }
  if (!viewing_take_option(&drawing->viewing, reader, argument, known)) return false;
  if (*known) return true;
  *known = true;
  if (option_is(argument, "--centre", &value)) {
    return option_vector(reader, "--centre", value, false, &drawing->centre);
  }
  if (option_is(argument, "--background", &value)) {
    return take_colour(reader, "--background", true, value, &drawing->background);
  }
  if (option_is(argument, "--outline-colour", &value)) {
    return take_colour(reader, "--outline-colour", false, value, &drawing->outline_colour);
  }
  if (option_is(argument, "--fog-colour", &value)) {
    return take_colour(reader, "--fog-colour", false, value, &drawing->fog_colour);
  }
  if (option_is(argument, "--ink-width", &value)) return take_ink_width(reader, value, drawing);
  if (option_is(argument, "--ink-colour", &value)) return take_ink_colour(reader, value, drawing);
  if (option_is(argument, "--colour", &value)) return take_what_colours_mean(reader, value, drawing);
  if (option_is(argument, "--range", &value)) return take_range(reader, value, drawing);
  if (option_is(argument, "--crop", &value)) return take_crop(reader, value, drawing);
  if (option_is(argument, "--spin", &value)) return take_spin(reader, value, &drawing->spin);
  if (option_is(argument, "--title", &value)) {
    return take_text(reader, "--title", value, "a text", &drawing->title);
  }
  if (option_is(argument, "--output", &value)) return take_text(reader, "--output", value, "a file", &drawing->out);
  if (strncmp(argument, "-o", 2) == 0 && argument[2] != '=') { /* -o OUT and -oOUT */
    return take_text(reader, "-o", argument[2] == '\0' ? NULL : argument + 2, "a file", &drawing->out);
  }
  bool *const flag = strcmp(argument, "--all-balls") == 0   ? &drawing->all_balls
                     : strcmp(argument, "--water") == 0     ? &drawing->water
                     : strcmp(argument, "--scale-bar") == 0 ? &drawing->scale_bar
                     : strcmp(argument, "--legend") == 0    ? &drawing->legend
                     : strcmp(argument, "--ink") == 0       ? &drawing->ink
                     : strcmp(argument, "--classes") == 0   ? &drawing->classes
                     : strcmp(argument, "--tooltips") == 0  ? &drawing->tooltips
                                                            : NULL;
  if (flag != NULL) {
    *flag = true;
    return true;
  }
  *known = false;
  return true;
}

/* The format that --picture asks for, or the name; SVG for what goes to standard output. */
static bool find_format(struct drawing *drawing) {
  if (drawing->format >= 0) return true;
  const char *slash = strrchr(drawing->out, '/');
  const char *dot = strrchr(slash == NULL ? drawing->out : slash + 1, '.');
  const char *end = dot == NULL ? "" : dot + 1;
  const struct field extension = {end, strlen(end)};
  for (int i = 0; i < FORMATS; ++i) {
    if (field_is(extension, format_names[i])) {
      drawing->format = i;
      return true;
    }
  }
  if (!output_is_standard(drawing->out)) return false;
  drawing->format = (int)HSP_FORMAT_SVG;
  return true;
}

bool drawing_check(struct drawing *drawing, struct failure *failure) {
  if (drawing->out == NULL) return failure_in_usage(failure, "draw needs -o OUT, a file .svg, .eps or .pdf");
  if (!find_format(drawing)) {
    char shown[EXCERPT_BYTES];
    return failure_in_usage(failure, "-o: '%s' is no .svg, .eps or .pdf file",
                            excerpt(shown, drawing->out, strlen(drawing->out)));
  }
  if (!viewing_check(&drawing->viewing, failure)) return false;
  if (drawing->centre.given && drawing->scale < 0.0) return failure_in_usage(failure, "--centre needs --scale");
  if (drawing->margin >= 0.0 && drawing->scale >= 0.0) {
    return failure_in_usage(failure, "either --margin around all that is seen, or --scale");
  }
  if (drawing->spin > 0 && output_is_standard(drawing->out)) {
    return failure_in_usage(failure, "--spin writes several files: standard output is one");
  }
  if (drawing->range_given && !drawing_is_of_values(drawing)) {
    return failure_in_usage(failure,
                            "--range is for colours that stand for numbers: it needs --colour area, bfactor, "
                            "charge or a file");
  }
  const int palette_of = drawing->palette == (int)HSP_PALETTE_CHAIN ? COLOUR_CHAIN : COLOUR_ELEMENT;
  if (drawing->palette >= 0 && drawing->colour >= 0 && drawing->colour != palette_of) {
    return failure_in_usage(failure, "--palette %s is of colours by %s", palette_names[drawing->palette],
                            colour_names[palette_of]);
  }
  if ((drawing->classes || drawing->tooltips) && drawing->format != (int)HSP_FORMAT_SVG) {
    return failure_in_usage(failure, "%s is for .svg: other formats have none",
                            drawing->classes ? "--classes" : "--tooltips");
  }
  if (drawing->fog_colour >= 0 && drawing->background != DRAWING_NO_BACKGROUND) {
    return failure_in_usage(failure, "--fog-colour is for --background none: fog has the colour of the background");
  }
  if (drawing->fog > 0.0 && drawing->fog_colour < 0 && drawing->background == DRAWING_NO_BACKGROUND) {
    return failure_in_usage(failure, "--fog with --background none needs --fog-colour, the colour of what lies behind");
  }
  if (drawing->all_balls && drawing_is_of_map(drawing)) {
    return failure_in_usage(failure, "either --all-balls, hidden ones too, or --pieces visible");
  }
  if (drawing_is_of_sticks(drawing) && drawing->pieces >= 0 && !drawing_is_of_map(drawing)) {
    return failure_in_usage(failure, "--as ball-and-stick has no --pieces but visible");
  }
  if (drawing_is_of_sticks(drawing) && (drawing->all_balls || drawing->occlusion > 0.0)) {
    return failure_in_usage(failure, "--all-balls and --occlusion are not for --as ball-and-stick");
  }
  if (drawing->legend && drawing->colour == COLOUR_RESIDUE) {
    return failure_in_usage(failure, "--legend is for colours by element, by chain and of numbers");
  }
  if (drawing_is_of_sticks(drawing) && drawing->ink) {
    return failure_in_usage(failure, "--ink is not for --as ball-and-stick");
  }
  if (!drawing_is_of_sticks(drawing) && (drawing->ball_size >= 0.0 || drawing->stick >= 0.0)) {
    return failure_in_usage(failure, "--ball-size and --stick are for --as ball-and-stick");
  }
  look_apply(drawing);
  return true;
}

bool drawing_is_of_sticks(const struct drawing *drawing) {
  return drawing->as == 1;
}

bool drawing_is_of_map(const struct drawing *drawing) {
  return drawing->pieces == PIECES - 1;
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
