/* Which options go together, and with the files that are named. */
#pragma once

#include "commands/request.h"

/* Whether the command takes as many files. */
bool request_check_several(const struct request *request, struct failure *failure);

/* The same of all else, once the format of the file is known. Takes back or adds what follows from other options. */
bool request_check(struct request *request, struct failure *failure);
