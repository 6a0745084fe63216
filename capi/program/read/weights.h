/* A weight for every ball, from a text file. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"

/* Read one number per ball in the order of the molecule: one on each line; blank lines are skipped, text behind a '#'
 * is a comment. Fewer or more numbers are refused. what: the name of such a number in messages, for instance "weight".
 * Free *weights [count] on true. */
bool weights_read(const char *path, const char *what, uint32_t count, double **weights, struct failure *failure);
