/* Options with values of their own. */
#include <string.h>

#include "app/option.h"
#include "read/number.h"
#include "read/threads.h"

/* ---- files and radii ---- */

bool take_format(struct reading *reading, const struct option *option, const char *value) {
  struct request *request = reading->request;
  char list[FORMAT_LIST_BYTES];
  file_format_list(list, "", "or", FILE_ATOMS, true);
  if (value == NULL) value = option_next(reading);
  if (value == NULL) return failure_in_usage(reading->failure, "--format needs %s", list);
  if (request->format != NULL) return option_given_twice(reading, option);
  request->format = file_format_named(value, FILE_ATOMS);
  request->format_given = true;
  char shown[EXCERPT_BYTES];
  return request->format != NULL ||
         failure_in_usage(reading->failure, "--format: '%s' is not %s", excerpt(shown, value, strlen(value)), list);
}

bool take_radii(struct reading *reading, const struct option *option, const char *value) {
  struct request *request = reading->request;
  if (!option_value_once(reading, option, reading->radii_seen, &value)) return false;
  reading->radii_seen = true;
  const struct radii_set *set = radii_set_find(value);
  if (set != NULL) {
    request->set = set;
  } else if (strcmp(value, "list") == 0) {
    request->list_radii = true;
  } else if (strpbrk(value, "./") != NULL) { /* the name of a set has neither */
    request->radii_file = value;
  } else {
    char shown[EXCERPT_BYTES];
    return failure_in_usage(
        reading->failure,
        "--radii: no set '%s'; there are bondi, chem3d, uff, protor, naccess, and files with a dot or "
        "slash in their names",
        excerpt(shown, value, strlen(value)));
  }
  return true;
}

/* Gather the text; it is applied when the set is known. */
bool take_radius(struct reading *reading, const struct option *option, const char *value) {
  if (!option_value(reading, option, &value)) return false;
  struct text_buffer *overrides = &reading->request->overrides;
  text_buffer_add(overrides, "%s%s", reading->radius_seen ? "," : "", value);
  if (overrides->out_of_memory) return failure_of_memory(reading->failure);
  reading->radius_seen = true;
  return true;
}

bool take_probe(struct reading *reading, const struct option *option, const char *value) {
  if (!option_value_once(reading, option, reading->probe_seen, &value)) return false;
  reading->probe_seen = true;
  return take_length(reading, option, value);
}

/* ---- which atoms are read ---- */

/* A selection, or a flag that stands for one of atoms to be left out. */
bool take_atoms(struct reading *reading, const struct option *option, const char *value) {
  struct selection *selection = (void *)((char *)reading->request + option->target);
  const bool flag = option->argument == NULL;
  if (!flag && !option_value(reading, option, &value)) return false;
  const bool hide = flag || strcmp(option->name, "--hide") == 0;
  return selection_add(selection, option->name, flag ? option->words : value, hide, reading->failure);
}

bool take_model(struct reading *reading, const struct option *option, const char *value) {
  uint64_t *model = &reading->request->choice.model;
  if (!option_value_once(reading, option, reading->request->model_given, &value)) return false;
  reading->request->model_given = true;
  if (number_parse_count(value, strlen(value), model) == NUMBER_OK && *model > 0 && *model < EVERY_MODEL) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "--model: '%s' is not the number of a model, from 1 on",
                          excerpt(shown, value, strlen(value)));
}

/* One of the words, or a letter. */
bool take_location(struct reading *reading, const struct option *option, const char *value) {
  struct request *request = reading->request;
  if (!option_value_once(reading, option, request->location_given, &value)) return false;
  request->location_given = true;
  const int word = option_word(option, value);
  request->choice.location = word >= 0 ? (char)(LOCATION_FIRST + word) : value[0];
  if (word >= 0 || (value[0] > ' ' && value[1] == '\0')) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "--altloc: '%s' is not %s", excerpt(shown, value, strlen(value)),
                          option->what);
}

/* By which names chains are called. Users who want only some chains write those here, too, by mistake. */
bool take_chains(struct reading *reading, const struct option *option, const char *value) {
  char shown[EXCERPT_BYTES];
  if (!option_value(reading, option, &value)) return false;
  if (option_word(option, value) >= 0) return take_choice(reading, option, value);
  excerpt(shown, value, strlen(value));
  return failure_in_usage(reading->failure, "--chains: '%s' is neither auth nor label; did you mean --only chain:%s?",
                          shown, shown);
}

bool take_groups(struct reading *reading, const struct option *option, const char *value) {
  struct selection_groups *const groups = (void *)((char *)reading->request + option->target);
  if (!option_value_once(reading, option, groups->text != NULL, &value)) return false;
  return selection_groups_parse(groups, option->name, value, reading->failure);
}

bool take_frames(struct reading *reading, const struct option *option, const char *value) {
  struct request *request = reading->request;
  if (!option_value_once(reading, option, request->frames_given, &value)) return false;
  request->frames_given = true;
  return frame_range_parse(&request->frames, value, reading->failure);
}

/* A time, or a positive one between frames; the request has no finite time, or no interval, where none is given. */
bool take_real(struct reading *reading, const struct option *option, const char *value) {
  double *const number = (void *)((char *)reading->request + option->target);
  if (!option_value_once(reading, option, option->positive ? *number > 0.0 : is_finite(*number), &value)) return false;
  if (!option_number(reading, option, value, number)) return false;
  return !option->positive || *number > 0.0 || failure_in_usage(reading->failure, "%s must be above 0", option->name);
}

/* ---- the periodic box ---- */

enum { MOST_NUMBERS = 9 };

/* Read numbers with a comma or blanks between them, in one argument. Returns how many; -1: the argument has something
 * else, and the failure says so. */
static int read_numbers(const struct reading *reading, const char *text, double numbers[MOST_NUMBERS]) {
  int count = 0;
  text += strspn(text, " \t");
  while (text[0] != '\0') {
    const size_t length = strcspn(text, ", \t");
    const bool fits = count < MOST_NUMBERS;
    double value = 0.0;
    const enum number_status status = number_parse(text, length, &value);
    if (status != NUMBER_OK) {
      char shown[EXCERPT_BYTES];
      failure_in_usage(reading->failure, "--box: '%s' %s", excerpt(shown, text, length), number_complaint(status));
      return -1;
    }
    if (fits) numbers[count] = value;
    ++count;
    text += length;
    text += strspn(text, " \t");
    if (text[0] == ',') {
      text += 1 + strspn(text + 1, " \t");
      if (text[0] == '\0') return 0;
    }
  }
  return count;
}

/* Three lengths, nine numbers, or one of the words file and p1. */
bool take_box(struct reading *reading, const struct option *option, const char *value) {
  struct box_choice *choice = &reading->request->box;
  if (!option_value_once(reading, option, choice->source != BOX_NONE, &value)) return false;
  choice->without_copies = strcmp(value, "p1") == 0;
  if (choice->without_copies || strcmp(value, "file") == 0) {
    choice->source = BOX_OF_FILE;
    return true;
  }
  double numbers[MOST_NUMBERS] = {0};
  const int count = read_numbers(reading, value, numbers);
  if (count < 0) return false;
  if (count != 3 && count != MOST_NUMBERS) return failure_in_usage(reading->failure, "--box needs %s", option->what);
  choice->source = BOX_GIVEN;
  memset(choice->vector, 0, sizeof choice->vector);
  if (count == 3) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(numbers[axis] > 0.0))
        return failure_in_usage(reading->failure, "--box: AX, BY and CZ must be larger than 0");
      choice->vector[4 * axis] = numbers[axis];
    }
  } else {
    memcpy(choice->vector, numbers, sizeof numbers);
  }
  return true;
}

/* ---- points ---- */

/* X Y Z, or of `gate` void:K, of `pores` atom:N. */
bool take_place(struct reading *reading, const struct option *option, const char *value) {
  const enum command command = reading->request->command;
  struct place *place = (void *)((char *)reading->request + option->target);
  const struct {
    enum command command;
    const char *word, *what;
    uint64_t *number;
    uint64_t first;
  } names[] = {{COMMAND_GATE, "void:", "a void, from 1 on", &place->of_void, 1},
               {COMMAND_PORES, "atom:", "an atom, from 0 on", &place->of_atom, 0},
               {COMMAND_PORES, "maximum:", "a maximum, from 0 on", &place->of_maximum, 0}};
  enum { NAMES = sizeof names / sizeof names[0] };
  const char *text = value != NULL ? value : reading->left > 0 ? reading->rest[0] : "";
  size_t k = 0;
  while (k < NAMES && (names[k].command != command || strncmp(text, names[k].word, strlen(names[k].word)) != 0)) ++k;
  if (k < NAMES && value == NULL) option_next(reading);
  if (place->point.given) return option_given_twice(reading, option);
  if (k == NAMES) {
    place->point.given = option_numbers(reading, option, value, "XYZ", place->point.xyz);
    return place->point.given;
  }
  uint64_t number = 0;
  const char *digits = text + strlen(names[k].word);
  place->point.given = true;
  if (number_parse_count(digits, strlen(digits), &number) == NUMBER_OK && number >= names[k].first &&
      number < UINT32_MAX) {
    *names[k].number = number + 1 - names[k].first;
    return true;
  }
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "%s: '%s' is not the number of %s", option->name,
                          excerpt(shown, digits, strlen(digits)), names[k].what);
}

bool take_query(struct reading *reading, const struct option *option, const char *value) {
  struct request *request = reading->request;
  const bool point = strcmp(option->name, "--point") == 0;
  if (request->query.kind != QUERY_NONE) {
    return failure_in_usage(reading->failure, "one query at a time: either --point X Y Z or --ball X Y Z R");
  }
  request->query.kind = point ? QUERY_POINT : QUERY_BALL;
  double numbers[4] = {0};
  if (!option_numbers(reading, option, value, point ? "XYZ" : "XYZR", numbers)) return false;
  memcpy(request->query.position, numbers, sizeof request->query.position);
  request->query.radius = numbers[3];
  return numbers[3] >= 0.0 || failure_in_usage(reading->failure, "--ball: R must not be negative");
}

bool take_at(struct reading *reading, const struct option *option, const char *value) {
  struct given_vector *at = &reading->request->pick.at;
  if (at->given) return option_given_twice(reading, option);
  at->given = true;
  return option_numbers(reading, option, value, "XY", at->xyz);
}

/* ---- surfaces and pictures ---- */

bool take_edge(struct reading *reading, const struct option *option, const char *value) {
  double *edge = &reading->request->meshing.edge;
  if (!option_value_once(reading, option, *edge >= 0.0, &value)) return false;
  return take_length(reading, option, value) &&
         (*edge > 0.0 || failure_in_usage(reading->failure, "--edge must be above 0"));
}

/* A direction, or a word for one. */
bool take_view(struct reading *reading, const struct option *option, const char *value) {
  struct viewing *viewing = (void *)((char *)reading->request + option->target);
  const char *word = value != NULL ? value : reading->left > 0 ? reading->rest[0] : "";
  const bool automatic = strcmp(word, "auto") == 0;
  const bool of_highlight = strcmp(word, "highlight") == 0 && viewing == &reading->request->drawing.viewing;
  if ((automatic || of_highlight) && value == NULL) option_next(reading);
  if (viewing->automatic || viewing->of_highlight || viewing->view.given) return option_given_twice(reading, option);
  viewing->automatic = automatic;
  viewing->of_highlight = of_highlight;
  struct option view = *option;
  view.target += offsetof(struct viewing, view);
  return automatic || of_highlight || take_direction(reading, &view, value);
}

/* One of the words, or a file. */
bool take_colour_meaning(struct reading *reading, const struct option *option, const char *value) {
  struct drawing *drawing = &reading->request->drawing;
  if (!option_value_once(reading, option, drawing->colour >= 0, &value)) return false;
  drawing->colour = option_word(option, value);
  if (drawing->colour >= 0) return true;
  if (strpbrk(value, "./") != NULL) { /* the words have neither */
    drawing->colour = COLOUR_FILE;
    drawing->colour_file = value;
    return true;
  }
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "--colour: '%s' is not %s with a dot or slash in its name",
                          excerpt(shown, value, strlen(value)), option->what);
}

bool take_range(struct reading *reading, const struct option *option, const char *value) {
  struct drawing *drawing = &reading->request->drawing;
  if (drawing->range_given) return option_given_twice(reading, option);
  drawing->range_given = true;
  if (!option_numbers(reading, option, value, "LH", drawing->range)) return false;
  return drawing->range[0] < drawing->range[1] ||
         failure_in_usage(reading->failure, "--range goes from a lower to a higher number");
}

bool take_crop(struct reading *reading, const struct option *option, const char *value) {
  struct drawing *drawing = &reading->request->drawing;
  if (drawing->crop_given) return option_given_twice(reading, option);
  drawing->crop_given = true;
  if (!option_numbers(reading, option, value, "XYWH", drawing->crop)) return false;
  for (int k = 0; k < 4; ++k) {
    if (drawing->crop[k] < -1e6 || drawing->crop[k] > 1e6) {
      return failure_in_usage(reading->failure, "--crop: numbers must be between -1000000 and 1000000");
    }
  }
  return (drawing->crop[2] > 0.0 && drawing->crop[3] > 0.0) ||
         failure_in_usage(reading->failure, "--crop: W and H must be above 0");
}

/* One number for all contours, or three. */
bool take_ink_width(struct reading *reading, const struct option *option, const char *value) {
  double *const width = reading->request->drawing.ink_width;
  if (!option_value_once(reading, option, width[0] >= 0.0, &value)) return false;
  const bool three = strpbrk(value, ", \t") != NULL;
  if (three ? !option_numbers(reading, option, value, "BGD", width) : !option_number(reading, option, value, width)) {
    return false;
  }
  for (int level = 0; level < INK_LEVELS; ++level) {
    if (!three) width[level] = width[0];
    if (!(width[level] >= 0.0 && width[level] <= 1e6)) {
      return failure_in_usage(reading->failure, "--ink-width must be between 0 and 1000000");
    }
  }
  reading->request->drawing.ink = true;
  return true;
}

/* Likewise. */
bool take_ink_colour(struct reading *reading, const struct option *option, const char *value) {
  enum { DIGITS = 7 }; /* with # */
  int *const colour = reading->request->drawing.ink_colour;
  if (!option_value_once(reading, option, colour[0] >= 0, &value)) return false;
  int given = 0;
  for (const char *at = value; given < INK_LEVELS; ++at) {
    char digits[DIGITS + 2]; /* one more makes it none */
    size_t length = strcspn(at, ",");
    if (given == INK_LEVELS - 1 || length > DIGITS + 1) length = strlen(at) < DIGITS + 1 ? strlen(at) : DIGITS + 1;
    memcpy(digits, at, length);
    digits[length] = '\0';
    colour[given] = option_rgb(digits);
    if (colour[given++] < 0) {
      char shown[EXCERPT_BYTES];
      return failure_in_usage(reading->failure, "--ink-colour: '%s' is not RRGGBB", excerpt(shown, digits, length));
    }
    at += length;
    if (*at == '\0') break;
  }
  if (given == 2) return failure_in_usage(reading->failure, "--ink-colour: either one RRGGBB or three, not two");
  for (int level = given; level < INK_LEVELS; ++level) colour[level] = colour[0];
  reading->request->drawing.ink = true;
  return true;
}
