/* The command line. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"

/* Read the arguments after the command into a request for one of the files that they name: number `file`, counted from
 * 0. Free the request with request_free on true and on false. */
bool request_parse(struct request *request, enum command command, int file, int count, char **arguments,
                   struct failure *failure);

/* The same for options alone, without checking whether they may be combined. */
bool request_read(struct request *request, enum command command, int count, char **arguments, struct failure *failure);
