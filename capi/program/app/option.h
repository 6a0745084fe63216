/* The options: one table, option_table.c, which the parser, the help and the completion of shells use. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "commands/request.h"
#include "read/failure.h"

/* A command line that is being read. */
struct reading {
  struct request *request;
  char **rest; /* arguments not looked at yet */
  int left;    /* how many */
  bool probe_seen;
  bool radii_seen;
  bool radius_seen;
  struct failure *failure;
};

struct option;

/* Take an option whose name was read. value: the text behind '=', or NULL. False: the failure says why not. */
typedef bool take_option(struct reading *reading, const struct option *option, const char *value);

#define EVERY_COMMAND (~0u)

struct option {
  const char *name;
  const char *argument; /* as the help writes it; NULL: a flag */
  take_option *take;    /* NULL: the row is only a further text about the option */
  unsigned commands;    /* the commands that take it: a bit for each, or EVERY_COMMAND */
  size_t target;        /* its place in struct request */
  const char *words;    /* the words that it takes, with '|' between them */
  const char *what;     /* for messages: what must stand behind it, "a length" */
  const char *part;     /* the part that it needs, as in command_table.h; NULL: none */
  const char *help; /* lines; NULL: it shares those of the next row; "": the command's own text tells all about it */
  int first;        /* the number of the first word */
  double most;      /* the largest number allowed */
  bool positive;    /* 0 is too small */
};

/* All rows, in the order of the help; NULL beyond the last. */
const struct option *option_at(size_t i);

bool option_is_of(const struct option *option, enum command command);

/* The option of a command that an argument names: --name, --name=value or -ovalue. *value becomes the value within the
 * argument, or NULL. The result is NULL if the command has no such option. */
const struct option *option_find(enum command command, const char *argument, const char **value);

/* Step over the next argument; NULL if there is none. */
const char *option_next(struct reading *reading);

/* ---- kinds of options, by what stands behind them ---- */

take_option take_flag;
take_option take_length; /* a number that is not negative */
take_option take_number; /* from 0 to `most`; negative in the request if it is not given */
take_option take_count;  /* from 1 to `most`; 0 in the request if it is not given */
take_option take_choice; /* one of the words, as a number; less than `first` in the request if it is not given */
take_option take_text;
take_option take_path;      /* the name of a file */
take_option take_vector;    /* three numbers */
take_option take_direction; /* three numbers that are not all 0 */
take_option take_angles;    /* three angles of a rotation */
take_option take_colour;    /* RRGGBB, or `none` if that is among the words */

/* ---- options with values of their own ---- */

take_option take_format, take_radii, take_radius, take_probe, take_atoms, take_model, take_location, take_chains,
    take_groups, take_frames, take_real, take_box, take_place, take_query, take_at, take_edge, take_view,
    take_colour_meaning, take_range, take_crop, take_ink_width, take_ink_colour;

/* ---- parts of these functions ---- */

/* Fail since an option is given twice. Always false. */
bool option_given_twice(const struct reading *reading, const struct option *option);

/* The value, behind '=' or as the next argument. False: there is none. */
bool option_value(struct reading *reading, const struct option *option, const char **value);

/* The same for an option that may be given once; given: whether it was before. */
bool option_value_once(struct reading *reading, const struct option *option, bool given, const char **value);

/* The place of a word among those that the option takes, from 0 on; -1: it is none of them. */
int option_word(const struct option *option, const char *word);

/* A number that a person wrote. */
bool option_number(const struct reading *reading, const struct option *option, const char *text, double *value);

/* As many numbers as `names` has letters, for instance "XYZ": with commas or blanks between them, in one argument or in
 * several. */
bool option_numbers(struct reading *reading, const struct option *option, const char *value, const char *names,
                    double *numbers);

/* The colour RRGGBB, with # or without it, or a name as in style sheets; negative: it is no colour. */
int option_rgb(const char *text);
