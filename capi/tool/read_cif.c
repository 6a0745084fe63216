/* mmCIF, as the wwPDB keeps its entries: of each block the category _atom_site, in a loop or as single items, in any
 * order. What the authors call a chain, a residue or an atom counts, and where they are silent, the label does. A model
 * is a run of rows with the same pdbx_PDB_model_num. */
#include <string.h>

#include "alternate_locations.h"
#include "characters.h"
#include "cif_tokens.h"
#include "number.h"
#include "read_molecule.h"
#include "residue_kinds.h"

enum item {
  GROUP,
  SYMBOL,
  AUTH_ATOM,
  LABEL_ATOM,
  ALTERNATE,
  AUTH_RESIDUE,
  LABEL_RESIDUE,
  AUTH_CHAIN,
  LABEL_CHAIN,
  AUTH_NUMBER,
  LABEL_NUMBER,
  INSERTION,
  X,
  Y,
  Z,
  B_FACTOR,
  MODEL,
  ITEMS,
  OTHER_ITEM
};

static const char category[] = "_ATOM_SITE.";

static const char *const item_names[ITEMS] = {
    "GROUP_PDB",     "TYPE_SYMBOL",  "AUTH_ATOM_ID",  "LABEL_ATOM_ID",  "LABEL_ALT_ID",      "AUTH_COMP_ID",
    "LABEL_COMP_ID", "AUTH_ASYM_ID", "LABEL_ASYM_ID", "AUTH_SEQ_ID",    "LABEL_SEQ_ID",      "PDBX_PDB_INS_CODE",
    "CARTN_X",       "CARTN_Y",      "CARTN_Z",       "B_ISO_OR_EQUIV", "PDBX_PDB_MODEL_NUM"};

enum { MOST_ITEMS = 256, MODEL_BYTES = 24 };

/* The values of one atom. They are copied: the lines that they come from are gone when the row is complete. */
struct row {
  size_t begin[ITEMS];
  size_t length[ITEMS]; /* 0 where the file says nothing */
  uint64_t line;
  struct text_buffer text;
};

struct cif_reading {
  struct cif_tokens tokens;
  struct alternate_locations seen;
  struct molecule *molecule;
  struct failure *failure;
  struct row row;
  bool single;             /* the row is made of single items */
  bool has[ITEMS];         /* which items the table has */
  bool within;             /* a model of this table has begun */
  char model[MODEL_BYTES]; /* its number */
  bool fractional;         /* a table without Cartesian coordinates was seen */
};

static bool in_category(struct field tag, struct field *item) {
  const size_t length = sizeof category - 1;
  if (tag.length <= length || !field_is((struct field){tag.text, length}, category)) return false;
  *item = (struct field){tag.text + length, tag.length - length};
  return true;
}

static enum item item_of(struct field name) {
  for (int i = 0; i < ITEMS; ++i) {
    if (field_is(name, item_names[i])) return (enum item)i;
  }
  return OTHER_ITEM;
}

static void row_clear(struct row *row, uint64_t line) {
  memset(row->length, 0, sizeof row->length);
  row->text.length = 0;
  row->line = line;
}

static void row_put(struct row *row, enum item item, const struct cif_tokens *tokens) {
  if (cif_value_is_absent(tokens)) return;
  row->begin[item] = row->text.length;
  row->length[item] = tokens->text.length;
  text_buffer_append(&row->text, tokens->text.text, tokens->text.length);
}

static struct field row_get(const struct row *row, enum item item) {
  return row->length[item] == 0 ? (struct field){"", 0}
                                : (struct field){row->text.text + row->begin[item], row->length[item]};
}

static struct field row_either(const struct row *row, enum item author, enum item label) {
  return row_get(row, row->length[author] > 0 ? author : label);
}

/* A number without the uncertainty that may follow in parentheses: 12.345(6). */
static struct field without_uncertainty(struct field number) {
  size_t end = number.length;
  if (end == 0 || number.text[end - 1] != ')') return number;
  --end;
  while (end > 0 && is_digit(number.text[end - 1])) --end;
  const bool whole = end > 1 && number.text[end - 1] == '(' && end + 1 < number.length;
  return whole ? (struct field){number.text, end - 1} : number;
}

/* By the letters of a symbol that a charge may follow, FE or O2-; where there is none, by the name. */
static bool take_element(const struct row *row, struct atom_label *label, struct failure *failure) {
  const struct field symbol = row_get(row, SYMBOL);
  const struct field name = row_either(row, AUTH_ATOM, LABEL_ATOM);
  char shown[EXCERPT_BYTES];
  if (symbol.length == 0) {
    if (label_take_element(label, name)) return true;
    return failure_in_input(failure, row->line, "no type_symbol, and no element in the atom name '%s'",
                            excerpt(shown, name.text, name.length));
  }
  size_t letters = 0;
  while (letters < symbol.length && is_letter(symbol.text[letters])) ++letters;
  size_t end = letters;
  while (end < symbol.length && (is_digit(symbol.text[end]) || symbol.text[end] == '+' || symbol.text[end] == '-')) {
    ++end;
  }
  if (end < symbol.length || !element_symbol_parse(symbol.text, letters, &label->element)) {
    return failure_in_input(failure, row->line, "type_symbol: '%s' is not an element symbol",
                            excerpt(shown, symbol.text, symbol.length));
  }
  label->virtual_site = is_virtual_symbol(label->element);
  return true;
}

static void take_label(const struct row *row, struct atom_label *label) {
  struct residue_label *residue = &label->residue;
  label_copy(label->name, sizeof label->name, row_either(row, AUTH_ATOM, LABEL_ATOM));
  label_copy(residue->name, sizeof residue->name, row_either(row, AUTH_RESIDUE, LABEL_RESIDUE));
  label_copy(residue->chain, sizeof residue->chain, row_either(row, AUTH_CHAIN, LABEL_CHAIN));
  label_copy(residue->number, sizeof residue->number, row_either(row, AUTH_NUMBER, LABEL_NUMBER));
  label_copy(residue->insertion, sizeof residue->insertion, row_get(row, INSERTION));
  label->hetatm = field_is(row_get(row, GROUP), "HETATM");
  const struct field factor = without_uncertainty(row_get(row, B_FACTOR));
  label->has_temperature_factor = number_parse(factor.text, factor.length, &label->temperature_factor) == NUMBER_OK;
}

/* Whether the row belongs to the model that is read. */
static bool in_model(struct cif_reading *reading) {
  struct molecule *molecule = reading->molecule;
  char model[MODEL_BYTES];
  label_copy(model, sizeof model, row_get(&reading->row, MODEL));
  if (!reading->within || strcmp(model, reading->model) != 0) ++molecule->models;
  reading->within = true;
  memcpy(reading->model, model, sizeof model);
  if (molecule->models == molecule->model) return true;
  ++molecule->left_out.other_models;
  return false;
}

static bool take_row(struct cif_reading *reading) {
  const struct row *row = &reading->row;
  struct molecule *molecule = reading->molecule;
  struct failure *failure = reading->failure;
  if (row->text.out_of_memory) return failure_of_memory(failure);
  if (!in_model(reading)) return true;
  static const char *const names[3] = {"Cartn_x", "Cartn_y", "Cartn_z"};
  double xyz[3];
  for (int axis = 0; axis < 3; ++axis) {
    const struct field number = without_uncertainty(row_get(row, (enum item)(X + axis)));
    if (!field_number(number, names[axis], &xyz[axis], row->line, failure)) return false;
  }
  struct atom_label label = ATOM_LABEL_NONE;
  take_label(row, &label);
  const struct field alternate = row_get(row, ALTERNATE);
  bool keep;
  if (!alternate_locations_keep(&reading->seen, &label, row_get(row, LABEL_CHAIN),
                                alternate.length == 0 ? ' ' : alternate.text[0], &keep)) {
    return failure_of_memory(failure);
  }
  if (!keep) {
    ++molecule->left_out.alternate_locations;
    return true;
  }
  return take_element(row, &label, failure) && molecule_add(molecule, xyz, 0.0, &label, row->line, failure);
}

/* Whether the table has what an atom needs. */
static bool check_items(struct cif_reading *reading, uint64_t line) {
  for (int i = X; i <= Z; ++i) {
    if (reading->has[i]) continue;
    return failure_in_input(reading->failure, line, "_atom_site has no Cartn_%c%s", "xyz"[i - X],
                            reading -> fractional ? ": fractional coordinates are not read" : "");
  }
  return true;
}

/* Note that the table has an item; false if it has it already. */
static bool note_item(struct cif_reading *reading, struct field name, enum item *item) {
  *item = item_of(name);
  if (*item == OTHER_ITEM) {
    reading->fractional = reading->fractional || field_is(name, "FRACT_X");
    return true;
  }
  if (reading->has[*item]) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(reading->failure, reading->tokens.line, "_atom_site.%s is given twice",
                            excerpt(shown, name.text, name.length));
  }
  reading->has[*item] = true;
  return true;
}

static void begin_table(struct cif_reading *reading) {
  memset(reading->has, 0, sizeof reading->has);
  reading->within = false;
  reading->single = false;
}

/* The end of single items: they are one atom. */
static bool end_single(struct cif_reading *reading) {
  if (!reading->single) return true;
  reading->single = false;
  return check_items(reading, reading->row.line) && take_row(reading);
}

/* The values of a loop, row by row. */
static bool read_rows(struct cif_reading *reading, const enum item *items, size_t count) {
  struct cif_tokens *tokens = &reading->tokens;
  size_t at = 0;
  for (; tokens->kind == CIF_VALUE; cif_tokens_next(tokens)) {
    if (at == 0) row_clear(&reading->row, tokens->line);
    if (items[at] != OTHER_ITEM) row_put(&reading->row, items[at], tokens);
    if (++at < count) continue;
    at = 0;
    if (!take_row(reading)) return false;
  }
  if (tokens->kind == CIF_FAILED) return false;
  if (at == 0) return true;
  return failure_in_input(reading->failure, reading->row.line, "a row of _atom_site has %u of %u values", (unsigned)at,
                          (unsigned)count);
}

static bool read_loop(struct cif_reading *reading) {
  struct cif_tokens *tokens = &reading->tokens;
  const uint64_t line = tokens->line;
  enum item items[MOST_ITEMS];
  size_t count = 0;
  bool atoms = false;
  begin_table(reading);
  for (cif_tokens_next(tokens); tokens->kind == CIF_TAG; cif_tokens_next(tokens)) {
    struct field name;
    const bool atom_item = in_category(tokens->text, &name);
    atoms = atoms || atom_item;
    if (atoms && count >= MOST_ITEMS) {
      return failure_in_input(reading->failure, tokens->line, "_atom_site has more than %d items", (int)MOST_ITEMS);
    }
    if (!atoms) {
      /* Files of small molecules write _atom_site_fract_x. */
      reading->fractional = reading->fractional || field_is(tokens->text, "_ATOM_SITE_FRACT_X");
    }
    enum item item = OTHER_ITEM;
    if (atom_item && !note_item(reading, name, &item)) return false;
    if (count < MOST_ITEMS) items[count] = item;
    ++count;
  }
  if (count == 0 && tokens->kind != CIF_FAILED) {
    return failure_in_input(reading->failure, line, "loop_ without a tag behind it");
  }
  if (atoms) return check_items(reading, line) && read_rows(reading, items, count);
  while (tokens->kind == CIF_VALUE) cif_tokens_next(tokens);
  return tokens->kind != CIF_FAILED;
}

/* A tag and its value, outside of loops. */
static bool read_item(struct cif_reading *reading) {
  struct cif_tokens *tokens = &reading->tokens;
  const uint64_t line = tokens->line;
  struct field name;
  enum item item = OTHER_ITEM;
  if (in_category(tokens->text, &name)) {
    if (!reading->single) {
      begin_table(reading);
      row_clear(&reading->row, line);
    }
    reading->single = true;
    if (!note_item(reading, name, &item)) return false;
  } else if (!end_single(reading)) {
    return false;
  }
  char tag[EXCERPT_BYTES];
  excerpt(tag, tokens->text.text, tokens->text.length);
  if (cif_tokens_next(tokens) == CIF_FAILED) return false;
  if (tokens->kind != CIF_VALUE) return failure_in_input(reading->failure, line, "%s has no value", tag);
  if (item != OTHER_ITEM) row_put(&reading->row, item, tokens);
  return cif_tokens_next(tokens) != CIF_FAILED;
}

static bool read_all(struct cif_reading *reading) {
  struct cif_tokens *tokens = &reading->tokens;
  bool block_seen = false;
  cif_tokens_next(tokens);
  while (tokens->kind != CIF_FAILED) {
    if (tokens->kind == CIF_TAG && block_seen) {
      if (!read_item(reading)) return false;
      continue;
    }
    if (!end_single(reading)) return false;
    if (tokens->kind == CIF_END) {
      if (reading->fractional && reading->molecule->models == 0) {
        return failure_in_input(reading->failure, 0, "fractional coordinates are not read");
      }
      return true;
    }
    if (tokens->kind == CIF_BLOCK) {
      block_seen = true;
      cif_tokens_next(tokens);
    } else if (!block_seen) {
      return failure_in_input(reading->failure, tokens->line, "no CIF file: it does not begin with data_");
    } else if (tokens->kind == CIF_LOOP) {
      if (!read_loop(reading)) return false;
    } else {
      char shown[EXCERPT_BYTES];
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
  cif_tokens_begin(&reading.tokens, reader, failure);
  const bool done = read_all(&reading);
  cif_tokens_free(&reading.tokens);
  alternate_locations_free(&reading.seen);
  text_buffer_free(&reading.row.text);
  return done;
}

const struct molecule_reader cif_reader = {.name = "cif",
                                           .extensions = "CIF MMCIF",
                                           .has_elements = true,
                                           .has_residues = true,
                                           .has_hetatm = true,
                                           .unit = "angstrom",
                                           .read = read_cif};
