#include "app/option.h"

#include <stdio.h>
#include <string.h>

#include "read/characters.h"
#include "read/number.h"

bool option_is_of(const struct option *option, enum command command) {
  return (option->commands >> command & 1u) != 0;
}

/* Whether the argument is the option, alone, as --option=value, or of one letter as -ovalue. */
static bool names(const char *argument, const struct option *option, const char **value) {
  const size_t length = strlen(option->name);
  if (strncmp(argument, option->name, length) != 0) return false;
  const char *behind = argument + length;
  *value = NULL;
  if (behind[0] == '\0') return true;
  if (option->argument == NULL || (length == 2) == (behind[0] == '=')) return false;
  *value = behind + (length == 2 ? 0 : 1);
  return length == 2 || behind[0] == '=';
}

const struct option *option_find(enum command command, const char *argument, const char **value) {
  const struct option *option;
  for (size_t i = 0; (option = option_at(i)) != NULL; ++i) {
    if (option_is_of(option, command) && option->take != NULL && names(argument, option, value)) return option;
  }
  return NULL;
}

const char *option_next(struct reading *reading) {
  if (reading->left == 0) return NULL;
  --reading->left;
  return *reading->rest++;
}

bool option_given_twice(const struct reading *reading, const struct option *option) {
  return failure_in_usage(reading->failure, "%s is given twice", option->name);
}

/* "a, b or c" of "a|b|c", or with another word before the last one. Returns how many there are. */
enum { LIST_BYTES = 120 };
static int list_words(const char *words, const char * or, char list[LIST_BYTES]) {
  int count = 0;
  size_t listed = 0;
  for (const char *at = words;; ++at, ++count) {
    const size_t length = strcspn(at, "|");
    const bool last = at[length] == '\0';
    snprintf(list + listed, LIST_BYTES - listed, "%s%.*s", count == 0 ? "" : last ? or : ", ", (int)length, at);
    listed = strlen(list);
    at += length;
    if (last) return count + 1;
  }
}

int option_word(const struct option *option, const char *word) {
  const char *at = option->words;
  for (int place = 0;; ++place) {
    const size_t length = strcspn(at, "|");
    if (strlen(word) == length && memcmp(word, at, length) == 0) return place;
    if (at[length] == '\0') return -1;
    at += length + 1;
  }
}

bool option_value(struct reading *reading, const struct option *option, const char **value) {
  if (*value == NULL) *value = option_next(reading);
  if (*value != NULL) return true;
  char list[LIST_BYTES];
  const char *what = option->what;
  if (what == NULL && option->words != NULL) {
    list_words(option->words, " or ", list);
    what = list;
  }
  return failure_in_usage(reading->failure, "%s needs %s", option->name, what == NULL ? "a number" : what);
}

bool option_value_once(struct reading *reading, const struct option *option, bool given, const char **value) {
  return option_value(reading, option, value) && (!given || option_given_twice(reading, option));
}

bool option_number(const struct reading *reading, const struct option *option, const char *text, double *value) {
  const enum number_status status = number_parse(text, strlen(text), value);
  if (status == NUMBER_OK) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "%s: '%s' %s", option->name, excerpt(shown, text, strlen(text)),
                          number_complaint(status));
}

static bool numbers_wanted(const struct reading *reading, const struct option *option, const char *names) {
  char blanks[16] = "";
  char commas[16] = "";
  const size_t count = strlen(names);
  for (size_t i = 0; i < count; ++i) {
    blanks[2 * i] = commas[2 * i] = names[i];
    if (i + 1 < count) blanks[2 * i + 1] = ' ', commas[2 * i + 1] = ',';
  }
  return failure_in_usage(reading->failure, "%s needs %lu numbers: %s or %s", option->name, (unsigned long)count,
                          blanks, commas);
}

bool option_numbers(struct reading *reading, const struct option *option, const char *value, const char *names,
                    double *numbers) {
  static const char separators[] = ", \t";
  const char *text = value != NULL ? value : "";
  for (size_t i = 0; names[i] != '\0'; ++i) {
    if (text[0] == '\0') text = option_next(reading);
    if (text == NULL || text[0] == '\0') return numbers_wanted(reading, option, names);
    const size_t length = strcspn(text, separators);
    const enum number_status status = number_parse(text, length, &numbers[i]);
    if (status != NUMBER_OK) {
      char shown[EXCERPT_BYTES];
      return failure_in_usage(reading->failure, "%s: '%s' %s", option->name, excerpt(shown, text, length),
                              number_complaint(status));
    }
    text += length;
    /* One comma, with blanks about it, or blanks alone. */
    text += strspn(text, " \t");
    if (text[0] == ',') text += 1 + strspn(text + 1, " \t");
    const bool last = names[i + 1] == '\0';
    if (last && (text[0] != '\0' || text[-1] == ',')) return numbers_wanted(reading, option, names);
  }
  return true;
}

/* The names that style sheets have had from the first. */
struct colour_name {
  const char *name;
  int rgb;
};
static const struct colour_name colour_names[] = {
    {"white", 0xFFFFFF}, {"silver", 0xC0C0C0},  {"gray", 0x808080},   {"grey", 0x808080},   {"black", 0x000000},
    {"red", 0xFF0000},   {"maroon", 0x800000},  {"orange", 0xFFA500}, {"yellow", 0xFFFF00}, {"olive", 0x808000},
    {"lime", 0x00FF00},  {"green", 0x008000},   {"aqua", 0x00FFFF},   {"teal", 0x008080},   {"blue", 0x0000FF},
    {"navy", 0x000080},  {"fuchsia", 0xFF00FF}, {"purple", 0x800080}};

int option_rgb(const char *text) {
  for (size_t k = 0; k < sizeof colour_names / sizeof colour_names[0]; ++k) {
    if (strcmp(text, colour_names[k].name) == 0) return colour_names[k].rgb;
  }
  const char *digits = text[0] == '#' ? text + 1 : text;
  int number = 0;
  if (strlen(digits) != 6) return -1;
  for (int i = 0; i < 6; ++i) {
    const char lower = to_lower(digits[i]);
    const int digit = is_digit(lower) ? lower - '0' : lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
    if (digit < 0) return -1;
    number = 16 * number + digit;
  }
  return number;
}

static void *target_of(const struct reading *reading, const struct option *option) {
  return (char *)reading->request + option->target;
}

bool take_flag(struct reading *reading, const struct option *option, const char *value) {
  (void)value;
  *(bool *)target_of(reading, option) = true;
  return true;
}

bool take_length(struct reading *reading, const struct option *option, const char *value) {
  double *const length = target_of(reading, option);
  if (!option_value(reading, option, &value) || !option_number(reading, option, value, length)) return false;
  return *length >= 0.0 || failure_in_usage(reading->failure, "%s must not be negative", option->name);
}

bool take_number(struct reading *reading, const struct option *option, const char *value) {
  double *const number = target_of(reading, option);
  if (!option_value_once(reading, option, *number >= 0.0, &value)) return false;
  if (!option_number(reading, option, value, number)) return false;
  if (*number >= 0.0 && *number <= option->most && !(option->positive && *number == 0.0)) return true;
  return failure_in_usage(reading->failure, "%s must be %s %.0f", option->name,
                          option->positive ? "above 0 and at most" : "between 0 and", option->most);
}

bool take_count(struct reading *reading, const struct option *option, const char *value) {
  uint32_t *const target = target_of(reading, option);
  uint64_t count = 0;
  if (!option_value_once(reading, option, *target > 0, &value)) return false;
  const bool read = number_parse_count(value, strlen(value), &count) == NUMBER_OK;
  *target = (uint32_t)count;
  if (read && count >= 1 && (double)count <= option->most) return true;
  return failure_in_usage(reading->failure, "%s must be %s, from 1 to %.0f", option->name, option->what, option->most);
}

bool take_choice(struct reading *reading, const struct option *option, const char *value) {
  int *const choice = target_of(reading, option);
  if (!option_value_once(reading, option, *choice >= option->first, &value)) return false;
  const int place = option_word(option, value);
  if (place >= 0) {
    *choice = option->first + place;
    return true;
  }
  char list[LIST_BYTES], shown[EXCERPT_BYTES];
  const bool two = list_words(option->words, " or ", list) == 2;
  if (two) list_words(option->words, " nor ", list);
  return failure_in_usage(reading->failure, "%s: '%s' is %s %s", option->name, excerpt(shown, value, strlen(value)),
                          two ? "neither" : "not", list);
}

bool take_text(struct reading *reading, const struct option *option, const char *value) {
  const char **const text = target_of(reading, option);
  if (!option_value_once(reading, option, *text != NULL, &value)) return false;
  *text = value;
  return true;
}

bool take_path(struct reading *reading, const struct option *option, const char *value) {
  const char **const path = target_of(reading, option);
  if (value == NULL) value = option_next(reading);
  if (value == NULL || value[0] == '\0') return failure_in_usage(reading->failure, "%s needs a file", option->name);
  if (*path != NULL) return option_given_twice(reading, option);
  *path = value;
  return true;
}

bool take_vector(struct reading *reading, const struct option *option, const char *value) {
  struct given_vector *const vector = target_of(reading, option);
  if (vector->given) return option_given_twice(reading, option);
  vector->given = option_numbers(reading, option, value, "XYZ", vector->xyz);
  return vector->given;
}

bool take_angles(struct reading *reading, const struct option *option, const char *value) {
  const struct given_vector *const vector = target_of(reading, option);
  if (!take_vector(reading, option, value)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (vector->xyz[axis] > 1e6 || vector->xyz[axis] < -1e6) {
      return failure_in_usage(reading->failure, "%s: angles must be between -1000000 and 1000000 degrees",
                              option->name);
    }
  }
  return true;
}

bool take_direction(struct reading *reading, const struct option *option, const char *value) {
  const struct given_vector *const vector = target_of(reading, option);
  if (!take_vector(reading, option, value)) return false;
  if (vector->xyz[0] != 0.0 || vector->xyz[1] != 0.0 || vector->xyz[2] != 0.0) return true;
  return failure_in_usage(reading->failure, "%s: 0,0,0 is no direction", option->name);
}

bool take_colour(struct reading *reading, const struct option *option, const char *value) {
  int *const colour = target_of(reading, option);
  const bool or_none = option->words != NULL;
  if (!option_value_once(reading, option, *colour >= 0, &value)) return false;
  *colour = or_none && strcmp(value, option->words) == 0 ? DRAWING_NO_BACKGROUND : option_rgb(value);
  char shown[EXCERPT_BYTES];
  return *colour >= 0 ||
         failure_in_usage(reading->failure, "%s: '%s' is %s", option->name, excerpt(shown, value, strlen(value)),
                          or_none ? "neither RRGGBB nor none" : "not RRGGBB");
}
