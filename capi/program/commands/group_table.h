/* Residues and chains with their areas, as a table, JSON or CSV; with `relative` also as parts of the largest area
 * that a residue of its name can have. */
#ifndef HARDSPHERE_TOOL_GROUP_TABLE_H
#define HARDSPHERE_TOOL_GROUP_TABLE_H

#include "read/molecule.h"
#include "read/residues.h"
#include "read/text_buffer.h"

void group_table_print(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                       struct text_buffer *out);
void group_table_csv(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                     struct text_buffer *out);

/* The list, in brackets, that stands under "residues" or "chains". */
void group_table_json(const struct molecule *molecule, const struct atom_groups *groups, bool relative,
                      struct text_buffer *out);

#endif
