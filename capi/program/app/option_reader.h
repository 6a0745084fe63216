/* The arguments of a command line, one after the other, and the values that stand behind options. */
#ifndef HARDSPHERE_TOOL_OPTION_READER_H
#define HARDSPHERE_TOOL_OPTION_READER_H

#include <stdbool.h>

#include "read/failure.h"

struct option_reader {
  char **rest; /* arguments not looked at yet */
  int left;    /* how many */
  struct failure *failure;
};

/* Whether the argument is the option, alone or as --option=value; then *value is set (NULL: not given that way). */
bool option_is(const char *argument, const char *option, const char **value);

/* Step over the next argument; NULL if there is none. */
const char *option_next(struct option_reader *reader);

/* A number that a person wrote behind an option. False: it is none, and the failure says so. */
bool option_number(struct option_reader *reader, const char *option, const char *text, double *value);

/* The same for a number that must not be negative. */
bool option_length(struct option_reader *reader, const char *option, const char *text, double *value);

/* As many numbers as `names` has letters, for instance "XYZ": with commas or blanks between them, in one argument or in
 * several. value: what stands behind '=', or NULL. */
bool option_numbers(struct option_reader *reader, const char *option, const char *value, const char *names,
                    double *numbers);

/* Three numbers of one option; `given` tells whether there are any. */
struct option_vector {
  bool given;
  double xyz[3];
};

/* Take them, once. direction: 0,0,0 is none. */
bool option_vector(struct option_reader *reader, const char *option, const char *value, bool direction,
                   struct option_vector *vector);

/* The value of an option, behind '=' or as the next argument. False: there is none, and the failure says that `what`
 * is needed, for instance "a length". */
bool option_value(struct option_reader *reader, const char *option, const char **value, const char *what);

/* The place in names [count] of the word that a person wrote; -1 and a failure if it is none of them. */
int option_choice(struct option_reader *reader, const char *option, const char *word, const char *const *names,
                  int count);

#endif
