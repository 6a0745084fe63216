/* Numbers in the columns of .pdb files. */
#pragma once

#include <stdbool.h>

enum { PDB_NUMBER_BYTES = 16 };

/* The number in `width` columns, fewer than PDB_NUMBER_BYTES, with as many decimals, or as many of them as fit; false
 * if not even its whole part does. */
bool pdb_number(char out[PDB_NUMBER_BYTES], int width, int decimals, double number);
