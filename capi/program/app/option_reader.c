#include "app/option_reader.h"

#include <stdio.h>
#include <string.h>

#include "read/number.h"

bool option_is(const char *argument, const char *option, const char **value) {
  const size_t length = strlen(option);
  if (strncmp(argument, option, length) != 0 || (argument[length] != '\0' && argument[length] != '=')) return false;
  *value = argument[length] == '=' ? argument + length + 1 : NULL;
  return true;
}

const char *option_next(struct option_reader *reader) {
  if (reader->left == 0) return NULL;
  --reader->left;
  return *reader->rest++;
}

bool option_number(struct option_reader *reader, const char *option, const char *text, double *value) {
  const enum number_status status = number_parse(text, strlen(text), value);
  if (status == NUMBER_OK) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reader->failure, "%s: '%s' %s", option, excerpt(shown, text, strlen(text)),
                          number_complaint(status));
}

bool option_length(struct option_reader *reader, const char *option, const char *text, double *value) {
  if (!option_number(reader, option, text, value)) return false;
  if (*value < 0.0) return failure_in_usage(reader->failure, "%s must not be negative", option);
  return true;
}

static bool numbers_wanted(struct option_reader *reader, const char *option, const char *names) {
  char blanks[16] = "";
  char commas[16] = "";
  const size_t count = strlen(names);
  for (size_t i = 0; i < count; ++i) {
    blanks[2 * i] = commas[2 * i] = names[i];
    if (i + 1 < count) blanks[2 * i + 1] = ' ', commas[2 * i + 1] = ',';
  }
  return failure_in_usage(reader->failure, "%s needs %lu numbers: %s or %s", option, (unsigned long)count, blanks,
                          commas);
}

bool option_numbers(struct option_reader *reader, const char *option, const char *value, const char *names,
                    double *numbers) {
  static const char separators[] = ", \t";
  const char *text = value != NULL ? value : "";
  for (size_t i = 0; names[i] != '\0'; ++i) {
    if (text[0] == '\0') text = option_next(reader);
    if (text == NULL || text[0] == '\0') return numbers_wanted(reader, option, names);
    const size_t length = strcspn(text, separators);
    const enum number_status status = number_parse(text, length, &numbers[i]);
    if (status != NUMBER_OK) {
      char shown[EXCERPT_BYTES];
      return failure_in_usage(reader->failure, "%s: '%s' %s", option, excerpt(shown, text, length),
                              number_complaint(status));
    }
    text += length;
    /* One comma, with blanks about it, or blanks alone. */
    text += strspn(text, " \t");
    if (text[0] == ',') text += 1 + strspn(text + 1, " \t");
    const bool last = names[i + 1] == '\0';
    if (last && (text[0] != '\0' || text[-1] == ',')) return numbers_wanted(reader, option, names);
  }
  return true;
}

bool option_vector(struct option_reader *reader, const char *option, const char *value, bool direction,
                   struct option_vector *vector) {
  if (vector->given) return failure_in_usage(reader->failure, "%s is given twice", option);
  if (!option_numbers(reader, option, value, "XYZ", vector->xyz)) return false;
  vector->given = true;
  if (direction && vector->xyz[0] == 0.0 && vector->xyz[1] == 0.0 && vector->xyz[2] == 0.0) {
    return failure_in_usage(reader->failure, "%s: 0,0,0 is no direction", option);
  }
  return true;
}

bool option_value(struct option_reader *reader, const char *option, const char **value, const char *what) {
  if (*value == NULL) *value = option_next(reader);
  if (*value == NULL) return failure_in_usage(reader->failure, "%s needs %s", option, what);
  return true;
}

int option_choice(struct option_reader *reader, const char *option, const char *word, const char *const *names,
                  int count) {
  char listed[120] = "";
  for (int i = 0; i < count; ++i) {
    if (strcmp(word, names[i]) == 0) return i;
    const size_t length = strlen(listed);
    snprintf(listed + length, sizeof listed - length, "%s%s", i == 0 ? "" : i + 1 < count ? ", " : " or ", names[i]);
  }
  char shown[EXCERPT_BYTES];
  failure_in_usage(reader->failure, "%s: '%s' is not %s", option, excerpt(shown, word, strlen(word)), listed);
  return -1;
}
