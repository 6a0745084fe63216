/* A copy of the PDB file with the free area of each atom in place of its temperature factor. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/molecule.h"

/* Read the molecule's file `from` again and write it to `to` (output_file.h):
 *   1. In an atom record of the molecule columns 61-66 become its area; all else stays the same byte for byte, line
 *      ends included. Lines that end earlier are filled up with blanks. The area has two decimals, or fewer if it would
 *      be wider than its columns: from 999.995 on one, from 9999.95 on none. From 999999.5 on it is refused.
 *   2. Atoms that do not belong to the molecule are left out, with their ANISOU, SIGATM and SIGUIJ records: other
 *      alternate locations, what the selection leaves out, and all models but the molecule's, with all their lines.
 *   3. Other lines are copied as they are; behind the molecule's model only CONECT and MASTER records and the first
 *      END.
 * False, with `to` named, if that file cannot be written in full. Standard input can be read again after
 * line_reader_keep_standard_input. */
bool pdb_output_write(const char *from, const struct molecule *molecule, const double *area, const char *to,
                      struct failure *failure);
