#include "write/pdb_number.h"

#include <stdio.h>
#include <string.h>

bool pdb_number(char out[PDB_NUMBER_BYTES], int width, int decimals, double number) {
  char wide[400]; /* a double has at most 309 digits before its point */
  for (int kept = decimals; kept >= 0; --kept) {
    const int length = snprintf(wide, sizeof wide, "%*.*f", width, kept, number + 0.0);
    if (length != width) continue;
    memcpy(out, wide, (size_t)width + 1);
    return true;
  }
  return false;
}
