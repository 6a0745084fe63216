/* CIF: of each block the atoms, in a loop or as single items, in any order; cell, space group and operators.
 *   mmCIF, as the wwPDB keeps its entries: _atom_site with Cartesian coordinates. The authors' name of a chain, a
 *     residue or an atom counts, and where they are silent, the label does; of a chain, if it is chosen so, the other
 *     way round. A model is all rows with the same pdbx_PDB_model_num, wherever they stand.
 *   Small molecules and frameworks: _atom_site with fractions of the cell. Atoms without coordinates, and all groups of
 *     disordered atoms but the first, are left out. A block is a model.
 *   Components and monomers: _chem_comp_atom, if the file has no _atom_site; each is a model. Its bonds are in the same
 *     block, before or after the atoms. */
#include <string.h>

#include "read/alternate_locations.h"
#include "read/atom_elements.h"
#include "read/characters.h"
#include "read/cif_component.h"
#include "read/cif_crystal.h"
#include "read/cif_lines.h"
#include "read/cif_row.h"
#include "read/cif_tokens.h"
#include "read/location_choice.h"
#include "read/number.h"
#include "read/read_molecule.h"
#include "read/words.h"

enum { MOST_ITEMS = 256 };

struct cif_reading {
  struct cif_tokens tokens;
  struct alternate_locations seen;
  struct location_choice choice;
  struct molecule *molecule;
  struct failure *failure;
  struct cif_row row;
  struct residue_place place;          /* of the last atom */
  const struct residue_label *residue; /* of the row before, if its atom had no letter; else NULL */
  bool hetatm;                         /* that atom is HETATM */
  struct cif_crystal crystal;          /* of this block */
  unsigned char decimals[3];           /* of the fractions of the row's atom */
  struct cif_component component;
  enum cif_table table;     /* the table that is read */
  enum cif_table source;    /* the table from which atoms come; one that is no component's has precedence */
  bool single;              /* the row is made of single items */
  bool has[CIF_ITEMS];      /* which items the table has */
  bool fractional;          /* its coordinates are */
  bool within;              /* a model of this table has begun */
  struct name_table models; /* of this table: their numbers in the file, or names of components */
  uint64_t models_before;   /* of tables before */
  bool taken;               /* atoms come from this block */
  bool taken_fractional;    /* and have fractional coordinates so far */
  bool done;                /* they came from a block before */
};

/* By a symbol that a charge may follow, FE or O2-; where there is none, by the name, which in crystals is a label. */
static bool take_element(const struct cif_reading *reading, struct field symbol, struct field name,
                         struct atom_label *label) {
  if (symbol.length == 1 && atom_is_usual(symbol.text[0], label->residue->name)) {
    label->element.text[0] = symbol.text[0];
    return true;
  }
  const bool *const has = reading->has;
  const bool names = has[CIF_AUTH_ATOM] || has[CIF_LABEL_ATOM] || has[CIF_COMPONENT_ATOM];
  const bool labels = !names && (has[CIF_SITE_LABEL] || reading->fractional);
  const struct atom_evidence evidence = {labels ? ATOM_LABELS : ATOM_NAMES, name, symbol};
  if (atom_take_element(&evidence, label)) return true;
  char shown[EXCERPT_BYTES];
  return symbol.length > 0
             ? failure_in_input(reading->failure, reading->row.line, "type_symbol: '%s' is not an element symbol",
                                excerpt(shown, symbol.text, symbol.length))
             : failure_in_input(reading->failure, reading->row.line,
                                "no type_symbol, and the label '%s' does not tell the element",
                                excerpt(shown, name.text, name.length));
}

/* The file's name of the atom, with the label where the authors are silent. */
static struct field name_of(const struct cif_row *row) {
  const struct field name = cif_row_either(row, CIF_AUTH_ATOM, CIF_LABEL_ATOM);
  return name.length > 0 ? name : cif_row_get(row, CIF_SITE_LABEL);
}

/* label_copy, by a word where the value stands in a line. */
static void take_name(const struct cif_row *row, struct field name, struct atom_label *label) {
  if (row->values == NULL || name.length == 0 || name.length >= sizeof label->name) {
    label_copy(label->name, sizeof label->name, name);
  } else {
    word_put(label->name, word_first(word_at(name.text), (unsigned)name.length));
  }
}

static bool take_residue(const struct cif_row *row, struct molecule *molecule, struct residue_label *residue,
                         struct failure *failure) {
  const bool by_label = molecule->choice.label_chains;
  const struct field chain = by_label ? cif_row_either(row, CIF_LABEL_CHAIN, CIF_AUTH_CHAIN)
                                      : cif_row_either(row, CIF_AUTH_CHAIN, CIF_LABEL_CHAIN);
  const struct field asym = cif_row_get(row, CIF_LABEL_CHAIN);
  const struct field name = cif_row_either(row, CIF_AUTH_RESIDUE, CIF_LABEL_RESIDUE);
  const struct field number = cif_row_either(row, CIF_AUTH_NUMBER, CIF_LABEL_NUMBER);
  const struct field insertion = cif_row_get(row, CIF_INSERTION);
  if (!label_take(residue->chain, sizeof residue->chain, chain, "the chain's name", row->line, failure) ||
      !label_take(residue->name, sizeof residue->name, name, "the residue's name", row->line, failure) ||
      !label_take(residue->number, sizeof residue->number, number, "the residue's number", row->line, failure) ||
      !label_take(residue->insertion, sizeof residue->insertion, insertion, "the insertion code", row->line, failure)) {
    return false;
  }
  if (asym.length > 0) residue->asym = name_table_number(&molecule->asyms, asym);
  if (asym.length > 0 && residue->asym == 0) return failure_of_memory(failure);
  return chain_name_copy(residue, molecule->copy, failure);
}

/* The temperature factor, if it is kept. */
static void take_extra(const struct cif_row *row, struct atom_extra *extra) {
  if (extra == NULL) return;
  const struct field factor = cif_without_uncertainty(cif_row_get(row, CIF_B_FACTOR));
  extra->has_value = number_parse(factor.text, factor.length, &extra->value) == NUMBER_OK;
}

/* Whether the row belongs to the model that is read. False with a failure: memory is short. */
static bool in_model(struct cif_reading *reading) {
  struct molecule *molecule = reading->molecule;
  const enum cif_item item = reading->table == CIF_COMPONENT ? CIF_COMPONENT_NAME : CIF_MODEL;
  if (!reading->within) {
    name_table_free(&reading->models);
    reading->models_before = molecule->models;
    reading->within = true;
  }
  const uint32_t number = name_table_number(&reading->models, cif_row_get(&reading->row, item));
  if (number == 0) return failure_of_memory(reading->failure);
  molecule->models = reading->models_before + reading->models.count;
  if (molecule->model == EVERY_MODEL && molecule->models > 1 && (reading->done || item == CIF_COMPONENT_NAME)) {
    return failure_in_input(reading->failure, reading->row.line,
                            "--models merged is of one structure: here begins another block or component");
  }
  if (molecule_wants_model(molecule, reading->models_before + number)) {
    reading->taken = true;
    return true;
  }
  ++molecule->left_out.other_models;
  return false;
}

/* Coordinates in angstrom. */
static bool take_cartesian(struct cif_reading *reading, double xyz[3]) {
  static const char *const names[3] = {"Cartn_x", "Cartn_y", "Cartn_z"};
  for (int axis = 0; axis < 3; ++axis) {
    const struct field value = cif_row_get(&reading->row, (enum cif_item)(CIF_X + axis));
    if (reading->row.values != NULL && word_decimal(value.text, value.length, 0, &xyz[axis])) continue;
    const struct field number = cif_without_uncertainty(value);
    if (!field_number(number, names[axis], &xyz[axis], reading->row.line, reading->failure)) return false;
  }
  return true;
}

/* Coordinates as fractions of the cell; *keep is false if the atom has none, or stands elsewhere too. */
static bool take_fractions(struct cif_reading *reading, double xyz[3], bool *keep) {
  static const char *const names[3] = {"fract_x", "fract_y", "fract_z"};
  const struct cif_row *row = &reading->row;
  struct left_out *left_out = &reading->molecule->left_out;
  bool placed = !field_is(cif_row_get(row, CIF_CALCULATED), "DUM");
  for (int axis = 0; axis < 3; ++axis) placed = placed && row->length[CIF_FRACTION_X + axis] > 0;
  *keep = placed;
  if (!placed) {
    ++left_out->unplaced;
    return true;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const struct field number = cif_row_get(row, (enum cif_item)(CIF_FRACTION_X + axis));
    unsigned char *const decimals = &reading->decimals[axis];
    if (!cif_crystal_fraction(number, names[axis], &xyz[axis], decimals, row->line, reading->failure)) {
      return false;
    }
  }
  const bool first = reading->molecule->choice.location == LOCATION_FIRST;
  if (first && !cif_crystal_keeps(&reading->crystal, row, keep, reading->failure)) return false;
  if (!*keep) ++left_out->alternate_locations;
  reading->taken_fractional = true;
  return true;
}

/* Note where the last atom stands, if it may stand elsewhere too and the user has a choice: at a location of its
 * residue, or in a group of disordered atoms. */
static bool note_location(struct cif_reading *reading, bool goes_on) {
  const struct cif_row *row = &reading->row;
  const struct molecule *molecule = reading->molecule;
  const struct atom_label *const label = &molecule->label[molecule->atoms - 1];
  const struct field occupancy = cif_without_uncertainty(cif_row_get(row, CIF_OCCUPANCY));
  static const struct atom_label nameless = ATOM_LABEL_NONE;
  if (!reading->fractional) {
    /* A row that goes on shares the place of the row before. */
    if (!goes_on) reading->place = residue_place_of(label->residue, cif_row_get(row, CIF_LABEL_CHAIN));
    const struct field letter = goes_on ? (struct field){"", 0} : cif_row_get(row, CIF_ALTERNATE);
    return (letter.length == 0 && !residue_is_numbered(label->residue)) ||
           location_choice_add(&reading->choice, molecule, &reading->place, label->name, label->residue->name, letter,
                               occupancy, reading->failure);
  }
  struct residue_label assembly = RESIDUE_LABEL_NONE;
  const struct field group = cif_row_get(row, CIF_DISORDER_GROUP);
  label_copy(assembly.chain, sizeof assembly.chain, cif_row_get(row, CIF_DISORDER_ASSEMBLY));
  const struct residue_place place = residue_place_of(&assembly, (struct field){"", 0});
  return group.length == 0 || location_choice_add(&reading->choice, molecule, &place, nameless.name,
                                                  residue_nameless.name, group, occupancy, reading->failure);
}

static bool is_in_part(struct field occupancy) {
  double value;
  return number_parse(occupancy.text, occupancy.length, &value) == NUMBER_OK && value < 1.0;
}

/* before: the residue of the row before, if this row goes on with it. */
static bool take_atom(struct cif_reading *reading, const struct residue_label *before) {
  const struct cif_row *row = &reading->row;
  struct molecule *molecule = reading->molecule;
  struct failure *failure = reading->failure;
  double xyz[3] = {0.0, 0.0, 0.0};
  bool keep = true;
  if (!(reading->fractional ? take_fractions(reading, xyz, &keep) : take_cartesian(reading, xyz))) return false;
  if (!keep) return true;
  struct residue_label residue = RESIDUE_LABEL_NONE;
  struct atom_label label = ATOM_LABEL_NONE;
  const struct field name = name_of(row);
  take_name(row, name, &label);
  memcpy(label.decimals, reading->decimals, sizeof label.decimals);
  label.partly = reading->fractional && is_in_part(cif_without_uncertainty(cif_row_get(row, CIF_OCCUPANCY)));
  struct field letter = {"", 0};
  if (before != NULL) {
    label.residue = before;
    label.hetatm = reading->hetatm;
    alternate_locations_go_on(&reading->seen);
  } else {
    label.residue = &residue;
    label.hetatm = reading->hetatm = field_is(cif_row_get(row, CIF_GROUP), "HETATM");
    const struct field alternate = cif_row_get(row, CIF_ALTERNATE);
    if (alternate.length > 0 && alternate.text[0] != ' ') letter = alternate;
    if (!take_residue(row, molecule, &residue, failure)) return false;
    /* Atoms whose names were cut to one would be locations of one atom. */
    if (letter.length > 0 && !label_fits(name, sizeof label.name, "the atom's name", row->line, failure)) return false;
    const bool later = letter.length > 0 && molecule->choice.location != LOCATION_FIRST;
    if (!later &&
        !alternate_locations_keep(&reading->seen, molecule, &label, cif_row_get(row, CIF_LABEL_CHAIN), letter, &keep)) {
      return failure_of_memory(failure);
    }
  }
  if (!keep) {
    ++molecule->left_out.alternate_locations;
    return true;
  }
  if (!take_element(reading, cif_row_get(row, CIF_SYMBOL), name, &label) ||
      !molecule_add(molecule, xyz, 0.0, &label, row->line, failure)) {
    return false;
  }
  if (letter.length == 0) reading->residue = molecule->label[molecule->atoms - 1].residue;
  take_extra(row, molecule_last_extra(molecule));
  return molecule->choice.location == LOCATION_FIRST || note_location(reading, before != NULL);
}

/* Its coordinates follow when all atoms are known. */
static bool take_component_atom(struct cif_reading *reading) {
  static const double nowhere[3] = {0.0, 0.0, 0.0};
  const struct cif_row *row = &reading->row;
  const struct field name = cif_row_get(row, CIF_COMPONENT_ATOM);
  struct residue_label residue = RESIDUE_LABEL_NONE;
  struct atom_label label = ATOM_LABEL_NONE;
  label.residue = &residue;
  label_copy(label.name, sizeof label.name, name);
  const struct field component = cif_row_get(row, CIF_COMPONENT_NAME);
  if (!label_take(residue.name, sizeof residue.name, component, "the component's name", row->line, reading->failure)) {
    return false;
  }
  if (!cif_component_take(&reading->component, row, reading->failure) ||
      !take_element(reading, cif_row_get(row, CIF_COMPONENT_SYMBOL), name, &label) ||
      !molecule_add(reading->molecule, nowhere, 0.0, &label, row->line, reading->failure)) {
    return false;
  }
  struct atom_extra *const extra = molecule_last_extra(reading->molecule);
  if (extra != NULL && name.length < sizeof extra->serial.text) {
    label_copy(extra->serial.text, sizeof extra->serial.text, name);
  }
  return true;
}

static bool take_row(struct cif_reading *reading) {
  const struct residue_label *const before = reading->row.goes_on ? reading->residue : NULL;
  reading->residue = NULL;
  reading->row.goes_on = false;
  if (reading->row.text.out_of_memory) return failure_of_memory(reading->failure);
  if (before == NULL && !in_model(reading)) return reading->failure->exit_status == 0;
  return reading->table == CIF_COMPONENT ? take_component_atom(reading) : take_atom(reading, before);
}

/* Drop the atoms of components, if there are any: the file has a structure, and the components are only its
 * dictionary. */
static void drop_component(struct cif_reading *reading) {
  struct molecule *molecule = reading->molecule;
  if (reading->source != CIF_COMPONENT) return;
  molecule_empty(molecule);
  molecule->models = molecule->copy = 0;
  memset(&molecule->left_out, 0, sizeof molecule->left_out);
  cif_component_free(&reading->component);
  reading->taken = reading->done = false;
}

/* Whether the table has atoms to be read, and all that one needs; *atoms tells the first. */
static bool check_items(struct cif_reading *reading, uint64_t line, bool mmcif, bool *atoms) {
  const bool *has = reading->has;
  *atoms = false;
  if (reading->table == CIF_COMPONENT) {
    /* Files of structures have them without coordinates. */
    *atoms = reading->source != CIF_ATOMS && (has[CIF_IDEAL_X] || has[CIF_MODEL_X] || has[CIF_PLAIN_X]);
    if (*atoms) reading->source = CIF_COMPONENT;
    return true;
  }
  reading->fractional = !has[CIF_X] && has[CIF_FRACTION_X];
  if (!mmcif && !has[CIF_X] && !has[CIF_FRACTION_X]) return true;
  for (int axis = 0; axis < 3; ++axis) {
    if (has[(reading->fractional ? CIF_FRACTION_X : CIF_X) + axis]) continue;
    return failure_in_input(reading->failure, line, "_atom_site has no %s_%c", reading->fractional ? "fract" : "Cartn",
                            "xyz"[axis]);
  }
  drop_component(reading);
  reading->source = CIF_ATOMS;
  *atoms = true;
  return true;
}

/* Note that the table has an item; false if it has it already. */
static bool note_item(struct cif_reading *reading, struct field tag, enum cif_item item) {
  if (item == CIF_OTHER_ITEM) return true;
  if (reading->has[item]) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(reading->failure, reading->tokens.line, "%s is given twice",
                            excerpt(shown, tag.text, tag.length));
  }
  reading->has[item] = true;
  return true;
}

static void begin_table(struct cif_reading *reading, enum cif_table table) {
  memset(reading->has, 0, sizeof reading->has);
  reading->table = table;
  reading->within = false;
  reading->single = false;
}

/* A bond, of the component that is read or of another one. */
static bool take_bond(struct cif_reading *reading) {
  return reading->source == CIF_ATOMS || reading->done ||
         cif_component_take_bond(&reading->row, reading->molecule, reading->failure);
}

/* A row of another table than the atoms', which has a meaning. */
static bool take_other_row(struct cif_reading *reading, enum cif_table table) {
  const struct cif_row *row = &reading->row;
  struct assemblies *const assemblies = &reading->molecule->assemblies;
  struct field number[12];
  if (table == CIF_BONDS) return take_bond(reading);
  if (table == CIF_OTHER_TABLE || reading->done) return true;
  if (row->text.out_of_memory) return failure_of_memory(reading->failure);
  if (table == CIF_ASSEMBLIES) {
    return assemblies_add_part(assemblies, cif_row_get(row, CIF_ASSEMBLY_NAME),
                               cif_row_get(row, CIF_ASSEMBLY_EXPRESSION), cif_row_get(row, CIF_ASSEMBLY_CHAINS),
                               reading->failure);
  }
  for (int k = 0; k < 12; ++k) number[k] = cif_row_get(row, (enum cif_item)(CIF_OPERATOR_NUMBERS + k));
  return assemblies_add_operator(assemblies, cif_row_get(row, CIF_OPERATOR_NAME), number, reading->failure);
}

static bool is_other_table(enum cif_table table) {
  return table == CIF_BONDS || table == CIF_ASSEMBLIES || table == CIF_OPERATORS;
}

/* The end of single items: they are one row. */
static bool end_single(struct cif_reading *reading) {
  bool atoms = false;
  if (!reading->single) return true;
  reading->single = false;
  if (is_other_table(reading->table)) return take_other_row(reading, reading->table);
  if (!check_items(reading, reading->row.line, true, &atoms)) return false;
  return !atoms || take_row(reading);
}

/* The end of a block, or of the file. Later ones have nothing to say to the atoms of this one. */
static bool end_block(struct cif_reading *reading) {
  struct molecule *molecule = reading->molecule;
  if (reading->done) return true;
  reading->done = reading->taken;
  if (reading->source == CIF_COMPONENT) {
    cif_component_choose_bonds(molecule);
  } else {
    molecule->bonds = 0;
  }
  if (!reading->taken) symmetry_free(&molecule->symmetry);
  if (!reading->taken) assemblies_free(&molecule->assemblies);
  if (!reading->taken || reading->source == CIF_COMPONENT) return true;
  if (reading->taken_fractional) molecule->coordinates = "fract_x";
  return cif_crystal_finish(&reading->crystal, reading->taken_fractional, molecule, reading->failure);
}

/* Take a value about the cell, unless it is in another block than the atoms. */
static bool take_crystal(struct cif_reading *reading, enum cif_item item) {
  return reading->done ||
         cif_crystal_take(&reading->crystal, item, &reading->tokens, &reading->molecule->symmetry, reading->failure);
}

/* Rows that are lines, from the value that begins the reader's line to the first that is none, before which a value is
 * not looked at. False: an atom cannot be read, or the file. */
static bool read_lines(struct cif_reading *reading, struct cif_lines *lines) {
  struct cif_tokens *tokens = &reading->tokens;
  bool any = false;
  cif_row_clear(&reading->row, tokens->line);
  for (; cif_lines_take(lines, tokens->reader, reading->residue != NULL, &reading->row); any = true) {
    if (!take_row(reading)) return false;
    if (!cif_tokens_next_line(tokens)) return tokens->kind == CIF_END;
  }
  return !any || cif_tokens_next(tokens) != CIF_FAILED;
}

/* The values of a loop, row by row. */
static bool read_rows(struct cif_reading *reading, const enum cif_item *items, size_t count) {
  struct cif_tokens *tokens = &reading->tokens;
  struct cif_lines lines;
  size_t at = 0;
  cif_lines_begin(&lines, items, count);
  for (; tokens->kind == CIF_VALUE; cif_tokens_next(tokens)) {
    if (at == 0 && !tokens->quoted && tokens->text.text == tokens->reader->text) {
      if (!read_lines(reading, &lines)) return false;
      if (tokens->kind != CIF_VALUE) break;
    }
    if (at == 0) cif_row_clear(&reading->row, tokens->line);
    if (items[at] != CIF_OTHER_ITEM) cif_row_put(&reading->row, items[at], tokens);
    if (++at < count) continue;
    at = 0;
    if (!take_row(reading)) return false;
  }
  if (tokens->kind == CIF_FAILED) return false;
  if (at == 0) return true;
  return failure_in_input(reading->failure, reading->row.line, "a row of %s has %u of %u values",
                          reading->table == CIF_COMPONENT ? "_chem_comp_atom" : "_atom_site", (unsigned)at,
                          (unsigned)count);
}

/* Read the values of any other loop; only operators and rows of some tables are used. */
static bool skip_rows(struct cif_reading *reading, enum cif_table table, const enum cif_item *items, size_t count) {
  struct cif_tokens *tokens = &reading->tokens;
  for (size_t at = 0; tokens->kind == CIF_VALUE; at = (at + 1) % count, cif_tokens_next(tokens)) {
    const enum cif_item item = at < MOST_ITEMS ? items[at] : CIF_OTHER_ITEM;
    if (at == 0) cif_row_clear(&reading->row, tokens->line);
    if (item >= CIF_BOND_COMPONENT && item <= CIF_OPERATOR_LAST) cif_row_put(&reading->row, item, tokens);
    if (at + 1 == count && !take_other_row(reading, table)) return false;
    if (item >= CIF_CELL_A && item <= CIF_OPERATOR && !take_crystal(reading, item)) return false;
  }
  return tokens->kind != CIF_FAILED;
}

static bool read_loop(struct cif_reading *reading) {
  struct cif_tokens *tokens = &reading->tokens;
  const uint64_t line = tokens->line;
  enum cif_item items[MOST_ITEMS];
  size_t count = 0;
  bool mmcif = false, atoms = false;
  enum cif_table other = CIF_OTHER_TABLE;
  begin_table(reading, CIF_OTHER_TABLE);
  for (cif_tokens_next(tokens); tokens->kind == CIF_TAG; cif_tokens_next(tokens)) {
    enum cif_table table;
    const enum cif_item item = cif_item_of(tokens->text, &table);
    const bool of_atoms = table == CIF_ATOMS || table == CIF_COMPONENT;
    if (of_atoms) reading->table = table;
    if (is_other_table(table)) other = table;
    mmcif = mmcif || (of_atoms && memchr(tokens->text.text, '.', tokens->text.length) != NULL);
    if (reading->table != CIF_OTHER_TABLE && count >= MOST_ITEMS) {
      return failure_in_input(reading->failure, tokens->line, "_atom_site has more than %d items", (int)MOST_ITEMS);
    }
    if (of_atoms && !note_item(reading, tokens->text, item)) return false;
    const bool unused = item == CIF_OCCUPANCY && mmcif && reading->molecule->choice.location == LOCATION_FIRST;
    if (count < MOST_ITEMS) items[count] = unused ? CIF_OTHER_ITEM : item;
    ++count;
  }
  if (count == 0 && tokens->kind != CIF_FAILED) {
    return failure_in_input(reading->failure, line, "loop_ without a tag behind it");
  }
  if (reading->table != CIF_OTHER_TABLE && !check_items(reading, line, mmcif, &atoms)) return false;
  return atoms ? read_rows(reading, items, count) : skip_rows(reading, other, items, count);
}

/* A tag and its value, outside of loops. */
static bool read_item(struct cif_reading *reading) {
  struct cif_tokens *tokens = &reading->tokens;
  const uint64_t line = tokens->line;
  enum cif_table table;
  const enum cif_item item = cif_item_of(tokens->text, &table);
  const bool of_row = table == CIF_ATOMS || table == CIF_COMPONENT || is_other_table(table);
  if ((!of_row || table != reading->table) && !end_single(reading)) return false;
  if (of_row) {
    if (!reading->single) {
      begin_table(reading, table);
      cif_row_clear(&reading->row, line);
    }
    reading->single = true;
    if (!is_other_table(table) && !note_item(reading, tokens->text, item)) return false;
  }
  char tag[EXCERPT_BYTES];
  excerpt(tag, tokens->text.text, tokens->text.length);
  if (cif_tokens_next(tokens) == CIF_FAILED) return false;
  if (tokens->kind != CIF_VALUE) return failure_in_input(reading->failure, line, "%s has no value", tag);
  if (of_row && item != CIF_OTHER_ITEM) cif_row_put(&reading->row, item, tokens);
  if (table == CIF_CRYSTAL && !take_crystal(reading, item)) return false;
  return cif_tokens_next(tokens) != CIF_FAILED;
}

static bool read_all(struct cif_reading *reading) {
  struct cif_tokens *tokens = &reading->tokens;
  bool block_seen = false;
  char shown[EXCERPT_BYTES];
  cif_tokens_next(tokens);
  while (tokens->kind != CIF_FAILED) {
    if (tokens->kind == CIF_TAG && block_seen) {
      if (!read_item(reading)) return false;
      continue;
    }
    if (!end_single(reading)) return false;
    if (tokens->kind == CIF_END) return end_block(reading);
    if (tokens->kind == CIF_BLOCK) {
      if (!end_block(reading)) return false;
      memset(&reading->crystal, 0, sizeof reading->crystal);
      block_seen = true;
      cif_tokens_next(tokens);
    } else if (!block_seen) {
      return failure_in_input(reading->failure, tokens->line, "no CIF file: '%s' stands before data_",
                              excerpt(shown, tokens->text.text, tokens->text.length));
    } else if (tokens->kind == CIF_LOOP) {
      if (!read_loop(reading)) return false;
    } else {
      return failure_in_input(reading->failure, tokens->line, "'%s' stands where a tag should",
                              excerpt(shown, tokens->text.text, tokens->text.length));
    }
  }
  return false;
}

static bool read_cif(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  struct cif_reading reading;
  memset(&reading, 0, sizeof reading);
  reading.molecule = molecule;
  reading.failure = failure;
  reading.source = CIF_OTHER_TABLE;
  cif_tokens_begin(&reading.tokens, reader, failure);
  bool done = read_all(&reading);
  if (done && reading.source == CIF_COMPONENT && molecule->atoms > 0) {
    done = cif_component_finish(&reading.component, molecule, failure);
  }
  done = done && location_choice_finish(&reading.choice, molecule, failure);
  cif_tokens_free(&reading.tokens);
  alternate_locations_free(&reading.seen);
  location_choice_free(&reading.choice);
  name_table_free(&reading.models);
  cif_component_free(&reading.component);
  text_buffer_free(&reading.row.text);
  return done;
}

const struct file_format cif_format = {.name = "cif",
                                       .extensions = "CIF MMCIF",
                                       ANGSTROM,
                                       .features = FILE_ATOMS | FILE_ELEMENTS | FILE_RESIDUES | FILE_HETATM |
                                                   FILE_TEMPERATURE_FACTORS | FILE_COORDINATE_ITEMS | FILE_LOCATIONS |
                                                   FILE_LABEL_CHAINS,
                                       .nameless = "no type_symbol, and no element",
                                       .read = read_cif};
