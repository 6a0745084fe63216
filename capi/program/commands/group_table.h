/* Residues, chains and groups of an index file with their areas; with `deviation` [groups], unless it is NULL, also the
 * standard deviation of each; with `relative` also as parts of the largest area that a residue of its name
 * can have. */
#pragma once

#include "read/molecule.h"
#include "read/residues.h"
#include "read/text_buffer.h"
#include "write/record.h"

/* As a table, or as an array of JSON under "residues", "chains" or "groups". */
void group_table_record(struct record *record, const struct atom_groups *groups, const double *deviation,
                        bool relative);

void group_table_csv(const struct molecule *molecule, const struct atom_groups *groups, const double *deviation,
                     bool relative, struct text_buffer *out);
