/* A weight for every ball, from a text file. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"

/* Read one number per ball in the order of the molecule: one on each line, blank lines skipped, what follows a '#' is
 * a comment. Any other number of numbers is refused. what: such a number is called, for instance "weight".
 * *weights [count] is to be freed on true. */
bool weights_read(const char *path, const char *what, uint32_t count, double **weights, struct failure *failure);
