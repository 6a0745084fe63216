/* Numbers in the columns of .pdb files. */
#pragma once

#include <stdbool.h>

enum { PDB_NUMBER_BYTES = 16 };

/* The number in `width` columns, fewer than PDB_NUMBER_BYTES, with that many decimals, or as many of them as fit. False
 * if not even its whole part fits. */
bool pdb_number(char out[PDB_NUMBER_BYTES], int width, int decimals, double number);
