/* The command line. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"

/* Read the arguments after the command, for one of the files that they name, counted from 0. Free the request with
 * request_free on true and on false. */
bool request_parse(struct request *request, enum command command, int file, int count, char **arguments,
                   struct failure *failure);

/* The same of options alone, without a look at whether they go together. */
bool request_read(struct request *request, enum command command, int count, char **arguments, struct failure *failure);
