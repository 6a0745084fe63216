/* The options: one table, option_table.c, from which the parser, the help and the completion of shells come. */
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

/* Take an option whose name was read. value: what stands behind '=', or NULL. False: the failure says why not. */
typedef bool take_option(struct reading *reading, const struct option *option, const char *value);

#define EVERY_COMMAND (~0u)

struct option {
  const char *name;
  const char *argument; /* as the help writes it; NULL: a flag */
  take_option *take;    /* NULL: the row is but one more text about the option */
  unsigned commands;    /* that take it: a bit for each, or EVERY_COMMAND */
  size_t target;        /* its place in struct request */
  const char *words;    /* that may stand behind it, with '|' between them */
  const char *what;     /* is needed behind it, "a length" */
  const char *part;     /* that it needs, as in command_table.h; NULL: none */
  const char *help; /* lines; NULL: those of the next row are of both; "": the command's own text tells all about it */
  int first;        /* the number of the first word */
  double most;      /* the largest number that is allowed */
  bool positive;    /* 0 is too small */
};

/* All rows, in the order of the help; NULL beyond the last. */
const struct option *option_at(size_t i);

bool option_is_of(const struct option *option, enum command command);

/* The option of a command that an argument names, alone, as --name=value or as -ovalue; then *value is set (NULL: not
 * given that way). NULL: there is none. */
const struct option *option_find(enum command command, const char *argument, const char **value);

/* Step over the next argument; NULL if there is none. */
const char *option_next(struct reading *reading);

/* ---- kinds of options, by what stands behind them ---- */

take_option take_flag;
take_option take_length; /* a number that is not negative */
take_option take_number; /* from 0 to `most`; negative in the request where it is not given */
take_option take_count;  /* from 1 to `most`; 0 in the request where it is not given */
take_option take_choice; /* one of the words, as a number; less than `first` in the request where it is not given */
take_option take_text;
take_option take_path;      /* the name of a file */
take_option take_vector;    /* three numbers */
take_option take_direction; /* three numbers that are not all 0 */
take_option take_angles;    /* three numbers that one may turn by */
take_option take_colour;    /* RRGGBB, or `none` if that is among the words */

/* ---- and those with values of their own ---- */

take_option take_format, take_radii, take_radius, take_probe, take_atoms, take_model, take_location, take_chains,
    take_groups, take_frames, take_real, take_box, take_place, take_query, take_at, take_edge, take_view,
    take_colour_meaning, take_range, take_crop, take_ink_width, take_ink_colour;

/* ---- what they are made of ---- */

/* Always false. */
bool option_given_twice(const struct reading *reading, const struct option *option);

/* The value, behind '=' or as the next argument. False: there is none. */
bool option_value(struct reading *reading, const struct option *option, const char **value);

/* The place of a word among those that may stand behind it, from 0 on; -1: it is none of them. */
int option_word(const struct option *option, const char *word);

/* A number that a person wrote. */
bool option_number(const struct reading *reading, const struct option *option, const char *text, double *value);

/* As many numbers as `names` has letters, for instance "XYZ": with commas or blanks between them, in one argument or in
 * several. */
bool option_numbers(struct reading *reading, const struct option *option, const char *value, const char *names,
                    double *numbers);

/* RRGGBB, with # or without it, or a name as in style sheets; negative: it is none. */
int option_rgb(const char *text);
