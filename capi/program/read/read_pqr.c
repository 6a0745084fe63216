/* .pqr: the atom records of a PDB file as fields between blanks, with charge and radius at the end:
 *   ATOM serial name residue [chain] number x y z charge radius [element]
 * (see the format's description by Dolinsky, Nielsen, McCammon and Baker for PDB2PQR). PDB2PQR itself writes the
 * columns of a PDB file, in which x, y and z may touch. A record that cannot be read by fields is read by columns. */
#include <string.h>

#include "read/atom_elements.h"
#include "read/characters.h"
#include "read/pdb_names.h"
#include "read/pdb_records.h"
#include "read/read_molecule.h"

enum { MOST_FIELDS = 12 };

/* The parts of a record. The element is empty if there is none. */
struct record {
  struct field name, residue, chain, number;
  struct field value[5]; /* x, y, z, charge, radius */
  struct field element;
};

/* The record name may run into the serial number: HETATM12345. */
static bool serial_is_joined(struct field record) {
  return !field_is(record, "ATOM") && !field_is(record, "HETATM");
}

static bool is_element(struct field field) {
  struct element_symbol symbol;
  return element_symbol_parse(field.text, field.length, &symbol);
}

/* Where a field is missing, a chain or a coordinate stands in the place of the number. Four letters are one of
 * "hybrid-36". */
static bool is_residue_number(struct field field, struct field chain) {
  size_t letters = 0;
  while (letters < field.length && is_letter(field.text[letters])) ++letters;
  return memchr(field.text, '.', field.length) == NULL && (chain.length > 0 || letters < field.length || letters == 4);
}

static bool record_of_fields(const struct line_reader *reader, struct record *record, struct failure *failure) {
  struct field part[MOST_FIELDS];
  size_t count = fields_split(reader->text, reader->length, part, MOST_FIELDS);
  memset(record, 0, sizeof *record);
  if (count <= MOST_FIELDS && is_element(part[count - 1])) record->element = part[--count];
  const size_t first = serial_is_joined(part[0]) ? 1 : 2; /* of the fields after the serial number */
  const size_t after_serial = count - first;              /* name residue [chain] number x y z charge radius */
  if (count < first || after_serial < 8 || after_serial > 9) {
    return failure_in_input(failure, reader->number,
                            "expected ATOM serial name residue [chain] number x y z charge radius, found %u fields",
                            (unsigned)count);
  }
  record->name = part[first];
  record->residue = part[first + 1];
  if (after_serial == 9) record->chain = part[first + 2];
  record->number = part[count - 6];
  for (size_t i = 0; i < 5; ++i) record->value[i] = part[count - 5 + i];
  if (!is_residue_number(record->number, record->chain)) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, reader->number,
                            "'%s' stands where a residue number should; wrong number of fields?",
                            excerpt(shown, record->number.text, record->number.length));
  }
  return true;
}

/* The record by the columns of a PDB file, with charge and radius as fields behind them; false if it is no such one. */
static bool record_of_columns(const struct line_reader *reader, struct record *record) {
  const char *text = reader->text;
  const size_t length = reader->length;
  memset(record, 0, sizeof *record);
  if (length < LAST_COORDINATE_COLUMN || text[0] == ' ' || memchr(text, '\t', length) != NULL) return false;
  struct field behind[3];
  const size_t count = fields_split(text + LAST_COORDINATE_COLUMN, length - LAST_COORDINATE_COLUMN, behind, 3);
  if (count < 2 || count > 3 || (count == 3 && !is_element(behind[2]))) return false;
  record->name = field_in_columns(text, length, 13, 16);
  record->residue = field_in_columns(text, length, 18, 21);
  record->chain = field_in_columns(text, length, 22, 22);
  record->number = field_in_columns(text, length, 23, 27);
  for (size_t axis = 0; axis < 3; ++axis) {
    record->value[axis] = field_in_columns(text, length, 31 + 8 * axis, 38 + 8 * axis);
    if (record->value[axis].length == 0 || memchr(record->value[axis].text, '.', record->value[axis].length) == NULL) {
      return false;
    }
  }
  record->value[3] = behind[0];
  record->value[4] = behind[1];
  if (count == 3) record->element = behind[2];
  return record->name.length > 0 && record->residue.length > 0;
}

static bool read_numbers(const struct record *record, uint64_t line, double value[4], double *radius,
                         struct failure *failure) {
  static const char *const names[4] = {"x", "y", "z", "charge"};
  for (size_t i = 0; i < 4; ++i) {
    if (!field_number_in_line(record->value[i], names[i], &value[i], line, failure)) return false;
  }
  return field_radius(record->value[4], radius, line, failure);
}

/* A residue number may end in its insertion code, 52A, and four digits may stand right behind their chain, A1001. */
static void label_number(struct field number, struct residue_label *label) {
  if (number.length >= 2 && is_digit(number.text[number.length - 2]) && is_letter(number.text[number.length - 1])) {
    label_copy(label->insertion, sizeof label->insertion, (struct field){number.text + number.length - 1, 1});
    --number.length;
  }
  size_t digits = 0;
  while (digits < number.length && is_digit(number.text[number.length - 1 - digits])) ++digits;
  if (label->chain[0] == '\0' && digits >= 4 && number.length == digits + 1 && is_letter(number.text[0])) {
    label_copy(label->chain, sizeof label->chain, (struct field){number.text, 1});
    ++number.text;
    --number.length;
  }
  label_copy(label->number, sizeof label->number, number);
}

static bool read_atom(const struct line_reader *reader, struct elements_seen *seen, struct pdb_names *names,
                      uint64_t ends, struct molecule *molecule, struct failure *failure) {
  const uint64_t line = reader->number;
  struct record record;
  double value[4];
  double radius;
  if (!record_of_fields(reader, &record, failure) || !read_numbers(&record, line, value, &radius, failure)) {
    const struct failure as_fields = *failure;
    if (!record_of_columns(reader, &record) || !read_numbers(&record, line, value, &radius, failure)) {
      *failure = as_fields;
      return false;
    }
    failure->exit_status = 0;
    failure->line = 0;
  }

  struct residue_label residue = RESIDUE_LABEL_NONE;
  struct atom_label label = ATOM_LABEL_NONE;
  label.residue = &residue;
  if (!label_take(residue.chain, sizeof residue.chain, record.chain, "the chain's name", line, failure) ||
      !label_take(residue.name, sizeof residue.name, record.residue, "the residue's name", line, failure) ||
      !label_fits(record.number, sizeof residue.number, "the residue's number", line, failure)) {
    return false;
  }
  label_copy(label.name, sizeof label.name, record.name);
  label_number(record.number, &residue);
  if (residue.chain[0] == '\0') pdb_names_number(names, ends, label.name, &residue);
  if (!chain_name_copy(&residue, molecule->copy, failure)) return false;
  label.hetatm = pdb_record_is_hetatm(reader->text);
  /* Virtual sites have radii here as well, and names that tell nothing are no reason to refuse an atom. */
  const struct atom_evidence evidence = {ATOM_NAMES, record.name, record.element};
  if (record.element.length > 0) {
    atom_take_element(&evidence, &label);
  } else {
    atom_take_element_again(seen, record.name, &label);
    if (label.virtual_site || label.bead) label.element.text[0] = '\0';
  }
  label.virtual_site = label.bead = false;
  if (!molecule_add(molecule, value, radius, &label, line, failure)) return false;
  struct atom_extra *const extra = molecule_last_extra(molecule);
  if (extra != NULL) {
    extra->has_value = true;
    extra->value = value[3];
  }
  return true;
}

static bool read_pqr(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  struct pdb_models models = PDB_MODELS_NONE;
  struct pdb_names names = {0};
  struct elements_seen seen;
  bool record_seen = false;
  memset(&seen, 0, sizeof seen);
  for (;;) {
    const enum line_status status = pdb_next_atom(reader, molecule, &models, &record_seen, failure);
    if (status != LINE_READ) return status == LINE_END;
    if (!read_atom(reader, &seen, &names, models.ends, molecule, failure)) return false;
  }
}

const struct file_format pqr_format = {
    .name = "pqr",
    .extensions = "PQR",
    ANGSTROM,
    .features = FILE_ATOMS | FILE_RADII | FILE_ELEMENTS | FILE_RESIDUES | FILE_HETATM | FILE_CHARGES | FILE_MOLECULES,
    .nameless = "no element",
    .read = read_pqr,
    .begins = pdb_begins_molecule,
    .title = pdb_title_of};
