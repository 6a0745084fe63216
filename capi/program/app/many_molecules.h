/* One command on each molecule of a file of many, by several threads: a row for each. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"

/* Print a row of a table, of JSON or of comma-separated values for each molecule of the request's file, in their order
 * and as soon as those before it are there, in the memory of a few molecules for each thread. One that fails has a row
 * that says why; false at the end then. */
bool many_molecules_run(const struct request *request, struct failure *failure);
