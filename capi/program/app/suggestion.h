/* The word that a user may have meant: the known word nearest to an unknown one. */
#pragma once

#include "commands/request.h"

enum { SUGGESTION_BYTES = 48 };

/* A command with a similar name, or one that other programs call so; NULL if there is none. */
const char *suggest_command(const char *unknown);

/* The same for an option of a command, "--name" or "--name=value": " did you mean
 * --name?", or "" if no option is similar. */
const char *suggest_option(enum command command, const char *unknown, char out[SUGGESTION_BYTES]);
