/* Whether options may be combined with each other and with the files that are named. */
#pragma once

#include "commands/request.h"

/* Whether the command takes that many files. */
bool request_check_several(const struct request *request, struct failure *failure);

/* Whether standard input is read for one thing, and once, and so is each pipe. */
bool request_check_inputs(const struct request *request, struct failure *failure);

/* Check everything else, once the format of the file is known. Adds choices that follow from other options, or removes
 * them. */
bool request_check(struct request *request, struct failure *failure);
