#include "app/suggestion.h"

#include <stdio.h>
#include <string.h>

#include "app/command_table.h"
#include "app/option.h"

enum { MOST_LETTERS = 24, FAR_APART = MOST_LETTERS };

/* A name that other programs have, and the name in this program. */
struct alias {
  const char *there;
  const char *here;
};

static const char *alias_of(const struct alias *aliases, size_t count, const char *word, size_t length) {
  for (size_t i = 0; i < count; ++i) {
    if (strlen(aliases[i].there) == length && memcmp(aliases[i].there, word, length) == 0) return aliases[i].here;
  }
  return NULL;
}

static size_t least_of(size_t a, size_t b) {
  return a < b ? a : b;
}

/* How many letters are to be put in, taken out or changed to make the one word of the other (Levenshtein 1966). */
static size_t distance(const char *a, size_t a_length, const char *b, size_t b_length) {
  size_t row[MOST_LETTERS + 1];
  if (a_length > MOST_LETTERS || b_length > MOST_LETTERS) return FAR_APART;
  for (size_t k = 0; k <= b_length; ++k) row[k] = k;
  for (size_t i = 1; i <= a_length; ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t k = 1; k <= b_length; ++k) {
      const size_t above = row[k];
      row[k] = least_of(least_of(above, row[k - 1]) + 1, diagonal + (a[i - 1] == b[k - 1] ? 0 : 1));
      diagonal = above;
    }
  }
  return row[b_length];
}

/* Two letters may be wrong, of short words one. */
static size_t most_wrong(size_t length) {
  return length < 5 ? 1 : 2;
}

const char *suggest_command(const char *unknown) {
  static const struct alias aliases[] = {{"sasa", "measure FILE --probe 1.4"},
                                         {"area", "measure"},
                                         {"volume", "measure"},
                                         {"cavities", "voids"},
                                         {"pockets", "pores"},
                                         {"tunnels", "pores"},
                                         {"render", "draw"},
                                         {"interface", "measure"}};
  const size_t length = strlen(unknown);
  const char *best = alias_of(aliases, sizeof aliases / sizeof aliases[0], unknown, length);
  if (best != NULL) return best;
  size_t least = most_wrong(length) + 1;
  for (int command = 0; command < COMMANDS; ++command) {
    const char *name = command_table[command].name;
    const size_t wrong = distance(unknown, length, name, strlen(name));
    if (wrong >= least) continue;
    least = wrong;
    best = name;
  }
  return best;
}

/* The option of the command whose name is nearest, or --help. */
static void nearest_option(enum command command, const char *unknown, size_t length, char out[SUGGESTION_BYTES]) {
  size_t least = most_wrong(length - 2) + 1;
  const struct option *option = option_at(0);
  for (size_t i = 1;; option = option_at(i++)) {
    const char *name = option == NULL ? "--help" : option->name;
    const bool known = option == NULL || (option_is_of(option, command) && name[1] == '-');
    const size_t wrong = known ? distance(unknown, length, name, strlen(name)) : FAR_APART;
    if (wrong > 0 && wrong < least) { /* 0: a flag with a value */
      least = wrong;
      snprintf(out, SUGGESTION_BYTES, " did you mean %s?", name);
    }
    if (option == NULL) return;
  }
}

const char *suggest_option(enum command command, const char *unknown, char out[SUGGESTION_BYTES]) {
  static const struct alias aliases[] = {{"--chain", "--only chain:A"},
                                         {"--chains", "--only chain:A"},
                                         {"-c", "--only chain:A"},
                                         {"-p", "--probe"},
                                         {"--probe-radius", "--probe"},
                                         {"-r", "--radii"},
                                         {"-o", "> OUT"},
                                         {"--output", "> OUT"}};
  const size_t length = strcspn(unknown, "=");
  const char *value;
  const bool writes = option_find(command, "-o", &value) != NULL;
  const char *alias =
      writes && unknown[1] == 'o' ? NULL : alias_of(aliases, sizeof aliases / sizeof aliases[0], unknown, length);
  out[0] = '\0';
  if (alias != NULL) {
    snprintf(out, SUGGESTION_BYTES, " did you mean %s?", alias);
  } else if (length > 2 && length < MOST_LETTERS) {
    nearest_option(command, unknown, length, out);
  }
  return out;
}
