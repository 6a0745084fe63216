#include "read/cif_row.h"

#include <string.h>

#include "read/characters.h"

/* With underscores for points; several names may be one item. */
static const struct {
  const char *name;
  enum cif_item item;
  enum cif_table table;
} known[] = {
    {"_ATOM_SITE_GROUP_PDB", CIF_GROUP, CIF_ATOMS},
    {"_ATOM_SITE_TYPE_SYMBOL", CIF_SYMBOL, CIF_ATOMS},
    {"_ATOM_SITE_AUTH_ATOM_ID", CIF_AUTH_ATOM, CIF_ATOMS},
    {"_ATOM_SITE_LABEL_ATOM_ID", CIF_LABEL_ATOM, CIF_ATOMS},
    {"_ATOM_SITE_LABEL", CIF_SITE_LABEL, CIF_ATOMS},
    {"_ATOM_SITE_LABEL_ALT_ID", CIF_ALTERNATE, CIF_ATOMS},
    {"_ATOM_SITE_AUTH_COMP_ID", CIF_AUTH_RESIDUE, CIF_ATOMS},
    {"_ATOM_SITE_LABEL_COMP_ID", CIF_LABEL_RESIDUE, CIF_ATOMS},
    {"_ATOM_SITE_AUTH_ASYM_ID", CIF_AUTH_CHAIN, CIF_ATOMS},
    {"_ATOM_SITE_LABEL_ASYM_ID", CIF_LABEL_CHAIN, CIF_ATOMS},
    {"_ATOM_SITE_AUTH_SEQ_ID", CIF_AUTH_NUMBER, CIF_ATOMS},
    {"_ATOM_SITE_LABEL_SEQ_ID", CIF_LABEL_NUMBER, CIF_ATOMS},
    {"_ATOM_SITE_PDBX_PDB_INS_CODE", CIF_INSERTION, CIF_ATOMS},
    {"_ATOM_SITE_CARTN_X", CIF_X, CIF_ATOMS},
    {"_ATOM_SITE_CARTN_Y", CIF_Y, CIF_ATOMS},
    {"_ATOM_SITE_CARTN_Z", CIF_Z, CIF_ATOMS},
    {"_ATOM_SITE_FRACT_X", CIF_FRACTION_X, CIF_ATOMS},
    {"_ATOM_SITE_FRACT_Y", CIF_FRACTION_Y, CIF_ATOMS},
    {"_ATOM_SITE_FRACT_Z", CIF_FRACTION_Z, CIF_ATOMS},
    {"_ATOM_SITE_OCCUPANCY", CIF_OCCUPANCY, CIF_ATOMS},
    {"_ATOM_SITE_B_ISO_OR_EQUIV", CIF_B_FACTOR, CIF_ATOMS},
    {"_ATOM_SITE_PDBX_PDB_MODEL_NUM", CIF_MODEL, CIF_ATOMS},
    {"_ATOM_SITE_DISORDER_ASSEMBLY", CIF_DISORDER_ASSEMBLY, CIF_ATOMS},
    {"_ATOM_SITE_DISORDER_GROUP", CIF_DISORDER_GROUP, CIF_ATOMS},
    {"_ATOM_SITE_CALC_FLAG", CIF_CALCULATED, CIF_ATOMS},
    {"_CHEM_COMP_ATOM_COMP_ID", CIF_COMPONENT_NAME, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_ATOM_ID", CIF_COMPONENT_ATOM, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_TYPE_SYMBOL", CIF_COMPONENT_SYMBOL, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_PDBX_MODEL_CARTN_X_IDEAL", CIF_IDEAL_X, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_PDBX_MODEL_CARTN_Y_IDEAL", CIF_IDEAL_Y, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_PDBX_MODEL_CARTN_Z_IDEAL", CIF_IDEAL_Z, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_MODEL_CARTN_X", CIF_MODEL_X, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_MODEL_CARTN_Y", CIF_MODEL_Y, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_MODEL_CARTN_Z", CIF_MODEL_Z, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_X", CIF_PLAIN_X, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_Y", CIF_PLAIN_Y, CIF_COMPONENT},
    {"_CHEM_COMP_ATOM_Z", CIF_PLAIN_Z, CIF_COMPONENT},
    {"_CHEM_COMP_BOND_COMP_ID", CIF_BOND_COMPONENT, CIF_BONDS},
    {"_CHEM_COMP_BOND_ATOM_ID_1", CIF_BOND_FIRST, CIF_BONDS},
    {"_CHEM_COMP_BOND_ATOM_ID_2", CIF_BOND_SECOND, CIF_BONDS},
    {"_CHEM_COMP_BOND_VALUE_ORDER", CIF_BOND_ORDER, CIF_BONDS},
    {"_CHEM_COMP_BOND_TYPE", CIF_BOND_ORDER, CIF_BONDS},
    {"_PDBX_STRUCT_ASSEMBLY_GEN_ASSEMBLY_ID", CIF_ASSEMBLY_NAME, CIF_ASSEMBLIES},
    {"_PDBX_STRUCT_ASSEMBLY_GEN_OPER_EXPRESSION", CIF_ASSEMBLY_EXPRESSION, CIF_ASSEMBLIES},
    {"_PDBX_STRUCT_ASSEMBLY_GEN_ASYM_ID_LIST", CIF_ASSEMBLY_CHAINS, CIF_ASSEMBLIES},
    {"_PDBX_STRUCT_OPER_LIST_ID", CIF_OPERATOR_NAME, CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[1][1]", CIF_OPERATOR_NUMBERS, CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[1][2]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 1), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[1][3]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 2), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[2][1]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 3), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[2][2]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 4), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[2][3]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 5), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[3][1]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 6), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[3][2]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 7), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_MATRIX[3][3]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 8), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_VECTOR[1]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 9), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_VECTOR[2]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 10), CIF_OPERATORS},
    {"_PDBX_STRUCT_OPER_LIST_VECTOR[3]", (enum cif_item)(CIF_OPERATOR_NUMBERS + 11), CIF_OPERATORS},
    {"_CELL_LENGTH_A", CIF_CELL_A, CIF_CRYSTAL},
    {"_CELL_LENGTH_B", CIF_CELL_B, CIF_CRYSTAL},
    {"_CELL_LENGTH_C", CIF_CELL_C, CIF_CRYSTAL},
    {"_CELL_ANGLE_ALPHA", CIF_CELL_ALPHA, CIF_CRYSTAL},
    {"_CELL_ANGLE_BETA", CIF_CELL_BETA, CIF_CRYSTAL},
    {"_CELL_ANGLE_GAMMA", CIF_CELL_GAMMA, CIF_CRYSTAL},
    {"_SYMMETRY_SPACE_GROUP_NAME_H-M", CIF_SPACE_GROUP, CIF_CRYSTAL},
    {"_SPACE_GROUP_NAME_H-M_ALT", CIF_SPACE_GROUP, CIF_CRYSTAL},
    {"_SPACE_GROUP_NAME_H-M_FULL", CIF_SPACE_GROUP_FULL, CIF_CRYSTAL},
    {"_SYMMETRY_SPACE_GROUP_NAME_HALL", CIF_SPACE_GROUP_HALL, CIF_CRYSTAL},
    {"_SPACE_GROUP_NAME_HALL", CIF_SPACE_GROUP_HALL, CIF_CRYSTAL},
    {"_SYMMETRY_INT_TABLES_NUMBER", CIF_SPACE_GROUP_NUMBER, CIF_CRYSTAL},
    {"_SPACE_GROUP_IT_NUMBER", CIF_SPACE_GROUP_NUMBER, CIF_CRYSTAL},
    {"_SYMMETRY_EQUIV_POS_AS_XYZ", CIF_OPERATOR, CIF_CRYSTAL},
    {"_SPACE_GROUP_SYMOP_OPERATION_XYZ", CIF_OPERATOR, CIF_CRYSTAL},
};

/* Whether the tag begins with the name. */
static bool begins_with(struct field tag, const char *name, bool points_alone) {
  for (size_t i = 0; name[i] != '\0'; ++i) {
    if (i >= tag.length) return false;
    const char c = to_upper(tag.text[i]);
    if (c != name[i] && (points_alone || c != '.' || name[i] != '_')) return false;
  }
  return true;
}

enum cif_item cif_item_of(struct field tag, enum cif_table *table) {
  for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
    if (strlen(known[i].name) != tag.length || !begins_with(tag, known[i].name, false)) continue;
    *table = known[i].table;
    return known[i].item;
  }
  *table = begins_with(tag, "_ATOM_SITE.", true)                  ? CIF_ATOMS
           : begins_with(tag, "_CHEM_COMP_ATOM.", true)           ? CIF_COMPONENT
           : begins_with(tag, "_CHEM_COMP_BOND.", true)           ? CIF_BONDS
           : begins_with(tag, "_PDBX_STRUCT_ASSEMBLY_GEN.", true) ? CIF_ASSEMBLIES
           : begins_with(tag, "_PDBX_STRUCT_OPER_LIST.", true)    ? CIF_OPERATORS
                                                                  : CIF_OTHER_TABLE;
  return CIF_OTHER_ITEM;
}

void cif_row_clear(struct cif_row *row, uint64_t line) {
  memset(row->length, 0, sizeof row->length);
  row->text.length = 0;
  row->values = NULL;
  row->goes_on = false;
  row->line = line;
}

void cif_row_put(struct cif_row *row, enum cif_item item, const struct cif_tokens *tokens) {
  if (cif_value_is_absent(tokens)) return;
  row->begin[item] = row->text.length;
  row->length[item] = tokens->text.length;
  text_buffer_append(&row->text, tokens->text.text, tokens->text.length);
}

struct field cif_without_uncertainty(struct field number) {
  size_t end = number.length;
  if (end == 0 || number.text[end - 1] != ')') return number;
  --end;
  while (end > 0 && is_digit(number.text[end - 1])) --end;
  const bool whole = end > 1 && number.text[end - 1] == '(' && end + 1 < number.length;
  return whole ? (struct field){number.text, end - 1} : number;
}
