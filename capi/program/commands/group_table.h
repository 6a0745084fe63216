/* Residues and chains with their areas; with `relative` also as parts of the largest area that a residue of its name
 * can have. */
#ifndef HARDSPHERE_TOOL_GROUP_TABLE_H
#define HARDSPHERE_TOOL_GROUP_TABLE_H

#include "read/molecule.h"
#include "read/residues.h"
#include "read/text_buffer.h"
#include "write/record.h"

/* As a table, or as an array of JSON under "residues" or "chains". */
void group_table_record(struct record *record, const struct atom_groups *groups, bool relative);

void group_table_csv(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                     struct text_buffer *out);

#endif
