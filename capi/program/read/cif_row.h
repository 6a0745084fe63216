/* The items of a CIF file that matter here, by its tags, and the values of one atom. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/cif_tokens.h"
#include "read/fields.h"
#include "read/text_buffer.h"

enum cif_table {
  CIF_ATOMS,      /* _atom_site */
  CIF_COMPONENT,  /* _chem_comp_atom, the atoms of a chemical component or monomer */
  CIF_BONDS,      /* _chem_comp_bond, the bonds of a component */
  CIF_CRYSTAL,    /* the cell, its space group and operators */
  CIF_ASSEMBLIES, /* _pdbx_struct_assembly_gen */
  CIF_OPERATORS,  /* _pdbx_struct_oper_list, of assemblies */
  CIF_OTHER_TABLE /* without a meaning here */
};

enum cif_item {
  CIF_GROUP,
  CIF_SYMBOL,
  CIF_AUTH_ATOM,
  CIF_LABEL_ATOM,
  CIF_SITE_LABEL, /* of small molecules: Zn1 */
  CIF_ALTERNATE,
  CIF_AUTH_RESIDUE,
  CIF_LABEL_RESIDUE,
  CIF_AUTH_CHAIN,
  CIF_LABEL_CHAIN,
  CIF_AUTH_NUMBER,
  CIF_LABEL_NUMBER,
  CIF_INSERTION,
  CIF_X,
  CIF_Y,
  CIF_Z,
  CIF_FRACTION_X,
  CIF_FRACTION_Y,
  CIF_FRACTION_Z,
  CIF_OCCUPANCY,
  CIF_B_FACTOR,
  CIF_MODEL,
  CIF_DISORDER_ASSEMBLY,
  CIF_DISORDER_GROUP,
  CIF_CALCULATED,
  CIF_COMPONENT_NAME,
  CIF_COMPONENT_ATOM,
  CIF_COMPONENT_SYMBOL,
  CIF_IDEAL_X,
  CIF_IDEAL_Y,
  CIF_IDEAL_Z,
  CIF_MODEL_X,
  CIF_MODEL_Y,
  CIF_MODEL_Z,
  CIF_PLAIN_X,
  CIF_PLAIN_Y,
  CIF_PLAIN_Z,
  CIF_BOND_COMPONENT,
  CIF_BOND_FIRST,
  CIF_BOND_SECOND,
  CIF_BOND_ORDER,
  CIF_ASSEMBLY_NAME,
  CIF_ASSEMBLY_EXPRESSION,
  CIF_ASSEMBLY_CHAINS,
  CIF_OPERATOR_NAME,
  CIF_OPERATOR_NUMBERS, /* of a matrix, row by row, and a vector: */
  CIF_OPERATOR_LAST = CIF_OPERATOR_NUMBERS + 11,
  CIF_CELL_A,
  CIF_CELL_B,
  CIF_CELL_C,
  CIF_CELL_ALPHA,
  CIF_CELL_BETA,
  CIF_CELL_GAMMA,
  CIF_SPACE_GROUP, /* by the symbol of Hermann and Mauguin; by its full form, by Hall's symbol, by its number: */
  CIF_SPACE_GROUP_FULL,
  CIF_SPACE_GROUP_HALL,
  CIF_SPACE_GROUP_NUMBER,
  CIF_OPERATOR,
  CIF_ITEMS,
  CIF_OTHER_ITEM
};

/* The item of a tag, in any case of its letters, and its table. Files of small molecules have an underscore in place of
 * mmCIF's point: _cell_length_a, _cell.length_a. The table is also found for tags without an item, in mmCIF's tables of
 * atoms and bonds. */
enum cif_item cif_item_of(struct field tag, enum cif_table *table);

/* The values of one atom or bond. Values of several lines are copied, as lines are gone when the row is complete. Zeros
 * at first. */
struct cif_row {
  size_t begin[CIF_ITEMS];
  size_t length[CIF_ITEMS]; /* 0: the file says nothing */
  uint64_t line;
  const char *values; /* the text with the values; NULL: `text` below */
  bool goes_on;       /* model, residue and letter of the location are those of the row before, and not in this one */
  struct text_buffer text;
};

void cif_row_clear(struct cif_row *row, uint64_t line);
void cif_row_put(struct cif_row *row, enum cif_item item, const struct cif_tokens *tokens);

static inline struct field cif_row_get(const struct cif_row *row, enum cif_item item) {
  if (row->length[item] == 0) return (struct field){"", 0};
  return (struct field){(row->values != NULL ? row->values : row->text.text) + row->begin[item], row->length[item]};
}

/* The value of the authors' item, or if it is missing that of the label's. */
static inline struct field cif_row_either(const struct cif_row *row, enum cif_item author, enum cif_item label) {
  return cif_row_get(row, row->length[author] > 0 ? author : label);
}

/* A number without the uncertainty that may follow in parentheses: 12.345(6). */
struct field cif_without_uncertainty(struct field number);
