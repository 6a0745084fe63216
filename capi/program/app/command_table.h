/* The commands: what each is called, says of itself, needs and does. */
#pragma once

#include "commands/commands.h"
#include "commands/request.h"

/* The part of the program that draws. */
#define DRAWING "part that draws"

struct command_row {
  const char *name;
  const char *arguments;
  const char *summary;
  const char *part;           /* that it needs: a component of the library, or DRAWING; NULL: none */
  command_function *run;      /* NULL: the part is left out, or the command is about two molecules */
  command_of_two *run_two;    /* likewise, about one */
  command_of_run *of_run;     /* of frames that are more than one after the other; NULL: they are not */
  command_check *check;       /* what goes together among its own options, or NULL */
  const char *text;           /* before the options in its help, */
  const char *closing;        /* and behind them, */
  const char *json;           /* and last its keys of JSON, as help_keys_fill writes them, */
  command_describe *describe; /* of this; NULL: the part is left out */
};

/* By their numbers. */
extern const struct command_row command_table[COMMANDS];

/* The command of that name; false if there is none. */
bool command_find(const char *name, enum command *command);

/* Whether the build has what a command, or an option of it, needs: "smooth", "space", DRAWING, or NULL, which is
 * nothing. False: the failure says what is left out. */
bool part_is_there(const char *part, enum command command, const char *option, struct failure *failure);
