/* The commands: what each is called, says of itself, needs and does. */
#pragma once

#include "commands/commands.h"
#include "commands/request.h"

struct command_row {
  const char *name;
  const char *arguments;
  const char *summary;
  const char *component;   /* of the library, that it needs; NULL: none */
  command_function *run;   /* NULL: the component is left out, or the command is about two molecules */
  command_of_two *run_two; /* likewise, about one */
  command_check *check;    /* what goes together among its own options, or NULL */
  const char *text;        /* before the options in its help, */
  const char *closing;     /* and behind them */
};

/* By their numbers. */
extern const struct command_row command_table[COMMANDS];

/* The command of that name; false if there is none. */
bool command_find(const char *name, enum command *command);

/* Whether the library has this one of its components, "smooth", "space" or "sight". */
bool component_is_built(const char *component);
