/* One command for each molecule of a file of many, by several threads: a row for each molecule. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"

/* Print a row of a table, of JSON or of comma-separated values for each molecule of the request's file: in their order,
 * each as soon as all rows before it are printed. Each thread has a few molecules in memory at a time. The row of a
 * molecule that fails says why; the result is false then. */
bool many_molecules_run(const struct request *request, struct failure *failure);
