/* .mol2, of Tripos: sections that begin with "@<TRIPOS>" and a name. Read are
 *   MOLECULE   a name, the numbers of atoms, bonds and more, a type, and NO_CHARGES or where charges come from: each
 *              begins a model
 *   ATOM       id name x y z type [number residue [charge ..]], where a name may have blanks, and that of the residue
 *              may end in its number
 *   BOND       id atom atom type
 * Lines that begin with '#' are comments. Lines of numbers, of atoms and of bonds that end in '\' go on in the next
 * one. */
#include <inttypes.h>
#include <string.h>

#include "read/atom_elements.h"
#include "read/characters.h"
#include "read/number.h"
#include "read/read_molecule.h"
#include "read/residue_kinds.h"
#include "read/text_buffer.h"

enum { USUAL_COLUMNS = 9, MOST_BLANKS = 3, MOST_COLUMNS = USUAL_COLUMNS + MOST_BLANKS };

static const char head[] = "@<TRIPOS>";

/* The section that is read, and the counts of the model that is wanted. */
struct reading {
  enum { OTHER, NAME, COUNTS, TYPE, CHARGES, ATOMS, BONDS } section;
  bool wanted, no_charges;
  uint64_t announced, found, counts_line;
  struct text_buffer joined; /* a line that goes on, with what it goes on with */
};

/* How many digits a text ends in. */
static size_t digits_at_end(struct field text) {
  size_t digits = 0;
  while (digits < text.length && is_digit(text.text[text.length - 1 - digits])) ++digits;
  return digits;
}

static bool is_known(struct field residue) {
  struct residue_label label;
  label_copy(label.name, sizeof label.name, residue);
  return residue_kind_of(label.name) != RESIDUE_OTHER;
}

/* Whether a name ends in the residue's number, as SO4301 does in 301. ALA21 does not in 1, a running number that it has
 * by chance: without it ALA2 would be left, and ALA is known. Nor does TP3 in 3: it is water, and TP is unknown. Digits
 * alone are a name from three on. */
static bool ends_in_number(struct field name, struct field number) {
  if (number.length == 0 || number.length >= name.length || digits_at_end(number) < number.length) return false;
  const struct field rest = {name.text, name.length - number.length};
  if (memcmp(rest.text + rest.length, number.text, number.length) != 0) return false;
  const struct field letters = {name.text, name.length - digits_at_end(name)};
  if (letters.length == rest.length) {
    return rest.text[rest.length - 1] != '-' && (is_known(rest) || !is_known(name));
  }
  if (letters.length == 0) return rest.length >= 3;
  return letters.text[letters.length - 1] != '-' && (is_known(rest) || !is_known(letters));
}

/* Take a number and an insertion code off the end of a name: ALA23, ALA-5, GLY52A. False: there is none, or nothing
 * before it, or more digits than a label has room for. Three characters that end in a letter are a name, G6P. */
static bool strip_number(struct field *name, struct field *number, struct field *code) {
  const bool coded = name->length > 3 && is_letter(name->text[name->length - 1]);
  struct field rest = {name->text, name->length - (coded ? 1 : 0)};
  size_t digits = digits_at_end(rest);
  rest.length -= digits;
  if (digits == 0 || digits + 1 >= sizeof residue_nameless.number || rest.length == 0) return false;
  if (rest.text[rest.length - 1] == '-') {
    --rest.length;
    ++digits;
  }
  if (rest.length == 0) return false;
  for (size_t i = 0; coded && i < rest.length; ++i) {
    if (!is_letter(rest.text[i])) return false;
  }
  *number = (struct field){rest.text + rest.length, digits};
  *code = (struct field){number->text + digits, coded ? 1 : 0};
  *name = rest;
  return true;
}

/* The name of a residue mostly ends in its number, but digits belong to many names as well. The number before the name
 * may be that number, or count the residues of the file: two in a row may have one name, LIG1 of two chains. "<0>":
 * there is none. */
static void take_residue(struct residue_label *residue, struct field number, struct field name) {
  struct field code = {"", 0};
  uint64_t count;
  if (name.text[0] == '<') return;
  if (number_parse_count(number.text, number.length, &count) == NUMBER_OK) residue->asym = (uint32_t)count;
  if (ends_in_number(name, number)) {
    name.length -= number.length;
  } else if (!is_known(name)) {
    strip_number(&name, &number, &code); /* else the whole name, and the number before it */
  }
  label_copy(residue->name, sizeof residue->name, name);
  label_copy(residue->number, sizeof residue->number, number);
  label_copy(residue->insertion, sizeof residue->insertion, code);
}

static bool is_decimal(struct field field) {
  double value;
  return memchr(field.text, '.', field.length) != NULL && number_parse(field.text, field.length, &value) == NUMBER_OK;
}

/* Blanks in an atom's name make fields of its parts. z stands then where the type should, which is never a decimal
 * number. Join the parts. */
static void join_name(struct field *column, size_t *columns) {
  size_t blanks = 0;
  while (blanks < MOST_BLANKS && 6 + blanks < *columns && is_decimal(column[5 + blanks])) ++blanks;
  if (blanks == 0 || is_digit(column[5 + blanks].text[0])) return;
  column[1].length = (size_t)(column[1 + blanks].text - column[1].text) + column[1 + blanks].length;
  *columns -= blanks;
  for (size_t i = 2; i < *columns && i < USUAL_COLUMNS; ++i) column[i] = column[i + blanks];
}

static bool read_atom(const struct line_reader *reader, struct field *column, size_t columns, bool no_charges,
                      struct molecule *molecule, struct failure *failure) {
  static const char *const names[3] = {"x", "y", "z"};
  join_name(column, &columns);
  if (columns < 6) {
    return failure_in_input(failure, reader->number, "expected id name x y z type, found %u of 6 columns",
                            (unsigned)columns);
  }
  struct residue_label residue = RESIDUE_LABEL_NONE;
  struct atom_label label = ATOM_LABEL_NONE;
  if (columns >= 8) take_residue(&residue, column[6], column[7]);
  if (!chain_name_copy(&residue, molecule->copy, failure)) return false;
  if (residue.name[0] != '\0') label.residue = &residue;
  label_copy(label.name, sizeof label.name, column[1]);
  const struct atom_evidence evidence = {ATOM_TYPES, column[1], column[5]};
  if (!atom_take_element(&evidence, &label)) {
    char type[EXCERPT_BYTES], name[EXCERPT_BYTES];
    excerpt(type, column[5].text, column[5].length);
    excerpt(name, column[1].text, column[1].length);
    return strchr(type, '.') != NULL
               ? failure_in_input(failure, reader->number, "unknown element in the type '%s'", type)
               : failure_in_input(failure, reader->number, "neither the type '%s' nor the name '%s' tells the element",
                                  type, name);
  }
  double xyz[3];
  for (int axis = 0; axis < 3; ++axis) {
    if (!field_number_in_line(column[2 + axis], names[axis], &xyz[axis], reader->number, failure)) return false;
  }
  if (!molecule_add(molecule, xyz, 0.0, &label, reader->number, failure)) return false;
  struct atom_extra *const extra = molecule_last_extra(molecule);
  if (extra == NULL) return true;
  if (!serial_of_number(column[0], &extra->serial)) extra->serial.text[0] = '\0';
  extra->has_value =
      columns >= 9 && !no_charges && number_parse(column[8].text, column[8].length, &extra->value) == NUMBER_OK;
  return true;
}

static bool read_bond(const struct field *column, size_t columns, struct molecule *molecule, struct failure *failure) {
  static const struct {
    const char *type;
    enum bond_order order;
  } orders[] = {{"2", BOND_DOUBLE}, {"3", BOND_TRIPLE}, {"AR", BOND_AROMATIC}};
  struct stated_bond bond = {.order = BOND_SINGLE};
  if ((molecule->keeps & KEEP_EXTRAS) == 0 || columns < 4 || field_is(column[3], "NC")) return true; /* not connected */
  for (size_t k = 0; k < sizeof orders / sizeof orders[0]; ++k) {
    if (field_is(column[3], orders[k].type)) bond.order = orders[k].order;
  }
  for (int end = 0; end < 2; ++end) {
    if (!serial_of_number(column[1 + end], &bond.serial[end])) return true;
  }
  return molecule_add_bond(molecule, &bond, failure);
}

/* Whether the model that ends here has as many atoms as it announces. */
static bool end_model(struct reading *reading, struct failure *failure) {
  const uint64_t announced = reading->announced, found = reading->found;
  reading->announced = reading->found = 0;
  return found == announced || failure_in_input(failure, reading->counts_line,
                                                "%" PRIu64 " atoms announced, %" PRIu64 " found", announced, found);
}

static bool begin_section(struct reading *reading, const char *name, struct molecule *molecule,
                          struct failure *failure) {
  const struct field section = {name, strcspn(name, " \t")};
  reading->section = field_is(section, "MOLECULE") ? NAME
                     : field_is(section, "ATOM")   ? ATOMS
                     : field_is(section, "BOND")   ? BONDS
                                                   : OTHER;
  if (reading->section != NAME) return true;
  if (!end_model(reading, failure)) return false;
  reading->wanted = molecule_wants_model(molecule, ++molecule->models);
  reading->no_charges = false;
  return true;
}

/* Whether the reader's line ends in '\', blanks apart; *length becomes that before it, or the whole one. */
static bool goes_on(const struct line_reader *reader, size_t *length) {
  size_t end = reader->length;
  while (end > 0 && is_blank(reader->text[end - 1])) --end;
  const bool found = end > 0 && reader->text[end - 1] == '\\';
  *length = found ? end - 1 : reader->length;
  return found;
}

/* The reader's line, joined with those in which it goes on; the reader steps to the last of them. */
static bool take_line(struct line_reader *reader, struct reading *reading, struct field *line,
                      struct failure *failure) {
  static const char behind[LINE_READER_ROOM] = "";
  struct text_buffer *const joined = &reading->joined;
  const bool data = reading->section == COUNTS || reading->section == ATOMS || reading->section == BONDS;
  size_t length;
  *line = (struct field){reader->text, reader->length};
  if (!data || reader->text[0] == '#' || !goes_on(reader, &length)) return true;
  joined->length = 0;
  for (bool more = true; more;) {
    text_buffer_append(joined, reader->text, length);
    const enum line_status status = line_reader_next(reader, failure);
    if (status == LINE_FAILED) return false;
    if (status == LINE_END || reader->text[0] == head[0]) {
      return failure_in_input(failure, reader->number, "the line before ends in '\\', but does not go on");
    }
    more = goes_on(reader, &length);
  }
  text_buffer_append(joined, reader->text, length);
  text_buffer_append(joined, behind, sizeof behind);
  *line = (struct field){joined->text, joined->length - sizeof behind};
  return !joined->out_of_memory || failure_of_memory(failure);
}

static bool read_line(struct line_reader *reader, struct reading *reading, struct molecule *molecule,
                      struct failure *failure) {
  struct field column[MOST_COLUMNS], line;
  if (!take_line(reader, reading, &line, failure)) return false;
  const size_t columns = fields_split(line.text, line.length, column, MOST_COLUMNS);
  if (reading->section == NAME) {
    reading->section = COUNTS; /* the name may be blank */
    return true;
  }
  if (columns > 0 && column[0].text[0] == '#') return true;
  if (reading->section == TYPE || reading->section == CHARGES) {
    reading->no_charges = reading->section == CHARGES && columns > 0 && field_is(column[0], "NO_CHARGES");
    reading->section = reading->section == TYPE ? CHARGES : OTHER;
    return true;
  }
  if (columns == 0) return true;
  if (reading->section == COUNTS) {
    uint64_t count = 0;
    reading->section = TYPE;
    if (number_parse_count(column[0].text, column[0].length, &count) != NUMBER_OK) {
      return !reading->wanted || failure_in_input(failure, reader->number, "expected the number of atoms");
    }
    if (reading->wanted) {
      reading->announced = count;
      reading->counts_line = reader->number;
    } else {
      molecule->left_out.other_models += count;
    }
    return true;
  }
  if (!reading->wanted) return true;
  if (reading->section == BONDS) return read_bond(column, columns, molecule, failure);
  if (reading->section != ATOMS) return true;
  ++reading->found;
  return read_atom(reader, column, columns, reading->no_charges, molecule, failure);
}

static bool read_mol2(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  struct reading reading = {.section = OTHER};
  enum line_status status;
  bool done = true;
  while (done && (status = line_reader_next(reader, failure)) == LINE_READ) {
    if (strncmp(reader->text, head, sizeof head - 1) == 0) {
      done = begin_section(&reading, reader->text + sizeof head - 1, molecule, failure);
    } else {
      done = read_line(reader, &reading, molecule, failure);
    }
  }
  text_buffer_free(&reading.joined);
  return done && status == LINE_END && end_model(&reading, failure);
}

static bool is_head_of_molecule(const char *line) {
  const char *const section = line + sizeof head - 1;
  return strncmp(line, head, sizeof head - 1) == 0 &&
         field_is((struct field){section, strcspn(section, " \t\n")}, "MOLECULE");
}

/* Lines before the first one are its, too. */
static bool begins_mol2(struct molecule_lines *lines, const struct line_reader *reader) {
  const bool begins = is_head_of_molecule(reader->text);
  lines->count += begins ? 1 : 0;
  lines->mark = '@';
  return begins;
}

static struct field title_of_mol2(const char *text, size_t length) {
  while (length > 0) {
    if (is_head_of_molecule(molecule_text_next_line(&text, &length).text)) break;
  }
  return molecule_text_next_line(&text, &length);
}

const struct file_format mol2_format = {
    .name = "mol2",
    .extensions = "MOL2",
    ANGSTROM,
    .features = FILE_ATOMS | FILE_ELEMENTS | FILE_RESIDUES | FILE_ORDERS | FILE_CHARGES | FILE_MOLECULES,
    .nameless = "no element",
    .read = read_mol2,
    .begins = begins_mol2,
    .title = title_of_mol2};
