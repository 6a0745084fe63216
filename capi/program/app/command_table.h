/* The commands: for each its name, its help, the part of the program that it needs, and the function that runs it. */
#pragma once

#include "commands/commands.h"
#include "commands/request.h"

/* The part of the program that draws. */
#define DRAWING "part that draws"

struct command_row {
  const char *name;
  const char *arguments;
  const char *summary;
  const char *part;           /* the part that it needs: a component of the library, or DRAWING; NULL: none */
  command_function *run;      /* NULL: the part is left out, or the command takes two molecules */
  command_of_two *run_two;    /* NULL: the part is left out, or the command takes one molecule */
  command_of_run *of_run;     /* for all frames together; NULL: the command treats frames one by one */
  command_check *check;       /* whether its own options may be combined, or NULL */
  const char *text;           /* the part of its help before the options, */
  const char *closing;        /* the part behind them, */
  const char *json;           /* and the last part: its keys of JSON, for help_keys_fill */
  command_describe *describe; /* tells these keys; NULL: the part is left out */
};

/* The commands by their numbers. */
extern const struct command_row command_table[COMMANDS];

/* The command of that name; false if there is none. */
bool command_find(const char *name, enum command *command);

/* Whether the build has the part that a command, or an option of it, needs: "smooth", "space", DRAWING, or NULL for
 * none. False: the failure says what is left out. */
bool part_is_there(const char *part, enum command command, const char *option, struct failure *failure);
