/* .sdf and .mol, the structure-data files of MDL: three lines of header, a line with the numbers of atoms and bonds, a
 * line for each, what else is known, and "$$$$" where another record follows: each is a model. V2000 has fixed columns,
 * V3000 blocks of lines "M  V30 index type x y z ..". */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "read/characters.h"
#include "read/number.h"
#include "read/read_molecule.h"

enum { HEADER_LINES = 3, MOST_COLUMNS = 8 };

static bool is_end_of_record(const struct line_reader *reader) {
  return strncmp(reader->text, "$$$$", 4) == 0;
}

/* Past the end of the record, or of the file. */
static enum line_status skip_record(struct line_reader *reader, struct failure *failure) {
  enum line_status status = LINE_READ;
  while (status == LINE_READ && !is_end_of_record(reader)) status = line_reader_next(reader, failure);
  return status;
}

/* 0 where there is no number: the count of a record that is not wanted. */
static uint64_t count_in(const struct line_reader *reader, size_t first, size_t last, bool *found) {
  const struct field text = field_in_columns(reader->text, reader->length, first, last);
  uint64_t count = 0;
  *found = number_parse_count(text.text, text.length, &count) == NUMBER_OK;
  return *found ? count : 0;
}

static bool add_atom(const struct line_reader *reader, struct field symbol, const struct field number[3],
                     struct field index, struct molecule *molecule, struct failure *failure) {
  static const char *const names[3] = {"x", "y", "z"};
  struct atom_label label = ATOM_LABEL_NONE;
  double xyz[3];
  if (!label_take_symbol(&label, symbol)) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, reader->number, "unknown element '%s'",
                            excerpt(shown, symbol.text, symbol.length));
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!field_number(number[axis], names[axis], &xyz[axis], reader->number, failure)) return false;
  }
  if (!molecule_add(molecule, xyz, 0.0, &label, reader->number, failure)) return false;
  struct atom_extra *const extra = molecule_last_extra(molecule);
  if (extra != NULL && !serial_of_number(index, &extra->serial)) extra->serial.text[0] = '\0';
  return true;
}

/* Kinds beyond 4 are those of queries, of bonds to metals and of hydrogen bonds, which are none. */
static bool add_bond(struct field kind, const struct field atom[2], struct molecule *molecule,
                     struct failure *failure) {
  enum { HYDROGEN_BOND = 10 };
  static const enum bond_order orders[] = {BOND_SINGLE, BOND_SINGLE, BOND_DOUBLE, BOND_TRIPLE, BOND_AROMATIC};
  struct stated_bond bond = {.order = BOND_SINGLE};
  uint64_t number;
  if ((molecule->keeps & KEEP_EXTRAS) == 0) return true;
  if (number_parse_count(kind.text, kind.length, &number) != NUMBER_OK || number == HYDROGEN_BOND) return true;
  if (number < sizeof orders / sizeof orders[0]) bond.order = orders[number];
  for (int end = 0; end < 2; ++end) {
    if (!serial_of_number(atom[end], &bond.serial[end])) return true;
  }
  return molecule_add_bond(molecule, &bond, failure);
}

/* ---- V2000 ---- */

static bool read_columns(struct line_reader *reader, uint64_t atoms, uint64_t bonds, struct molecule *molecule,
                         struct failure *failure) {
  const uint64_t counts_line = reader->number;
  for (uint64_t i = 0; i < atoms + bonds; ++i) {
    const enum line_status status = line_reader_next(reader, failure);
    if (status == LINE_FAILED) return false;
    if (status == LINE_END || is_end_of_record(reader)) {
      return failure_in_input(failure, counts_line,
                              "%" PRIu64 " atoms and %" PRIu64 " bonds announced, the record ends after %" PRIu64
                              " lines",
                              atoms, bonds, i);
    }
    struct field part[3];
    for (size_t k = 0; k < 3; ++k) {
      const size_t wide = i < atoms ? 10 : 3;
      part[k] = field_in_columns(reader->text, reader->length, k * wide + 1, (k + 1) * wide);
    }
    if (i >= atoms) {
      if (!add_bond(part[2], part, molecule, failure)) return false;
      continue;
    }
    char index[24];
    snprintf(index, sizeof index, "%" PRIu64, i + 1);
    const struct field symbol = field_in_columns(reader->text, reader->length, 32, 34);
    if (!add_atom(reader, symbol, part, (struct field){index, strlen(index)}, molecule, failure)) return false;
  }
  return true;
}

/* ---- V3000 ---- */

/* The next line of the table that is none's continuation, which '-' at the end of a line announces. *columns becomes 0
 * at the end of the table. */
static enum line_status next_of_table(struct line_reader *reader, bool *goes_on, struct field column[MOST_COLUMNS],
                                      size_t *columns, struct failure *failure) {
  static const char head[] = "M  V30 ";
  bool again;
  do {
    const enum line_status status = line_reader_next(reader, failure);
    if (status != LINE_READ) return status;
    again = *goes_on;
    *columns = 0;
    if (strncmp(reader->text, head, sizeof head - 1) != 0) return LINE_READ;
    *goes_on = reader->text[reader->length - 1] == '-';
  } while (again);
  const size_t skipped = sizeof head - 1;
  *columns = fields_split(reader->text + skipped, reader->length - skipped, column, MOST_COLUMNS);
  return LINE_READ;
}

static bool read_table(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  enum { OUTSIDE, ATOMS, BONDS } block = OUTSIDE;
  const uint64_t counts_line = reader->number;
  uint64_t announced = 0, found = 0;
  bool goes_on = false;
  for (;;) {
    struct field column[MOST_COLUMNS];
    size_t columns = 0;
    const enum line_status status = next_of_table(reader, &goes_on, column, &columns, failure);
    if (status == LINE_FAILED) return false;
    if (status == LINE_END || columns == 0) break;
    if (field_is(column[0], "COUNTS") && columns > 1) {
      if (number_parse_count(column[1].text, column[1].length, &announced) != NUMBER_OK) announced = 0;
    } else if (field_is(column[0], "BEGIN") && columns > 1) {
      block = field_is(column[1], "ATOM") ? ATOMS : field_is(column[1], "BOND") ? BONDS : OUTSIDE;
    } else if (field_is(column[0], "END")) {
      block = OUTSIDE;
    } else if (block != OUTSIDE && columns < (block == ATOMS ? 5U : 4U)) {
      return failure_in_input(failure, reader->number, "expected %s",
                              block == ATOMS ? "M  V30 index type x y z" : "M  V30 index type atom atom");
    } else if (block == ATOMS) {
      ++found;
      if (!add_atom(reader, column[1], column + 2, column[0], molecule, failure)) return false;
    } else if (block == BONDS && !add_bond(column[1], column + 2, molecule, failure)) {
      return false;
    }
  }
  return found == announced ||
         failure_in_input(failure, counts_line, "%" PRIu64 " atoms announced, %" PRIu64 " found", announced, found);
}

/* ---- records ---- */

/* The record whose line of counts is the current one. drawn: in two dimensions. */
static bool read_record(struct line_reader *reader, bool drawn, struct molecule *molecule, struct failure *failure) {
  const bool wanted = molecule_wants_model(molecule, ++molecule->models);
  const struct field version = field_in_columns(reader->text, reader->length, 34, 39);
  bool known[2];
  const uint64_t atoms = count_in(reader, 1, 3, &known[0]), bonds = count_in(reader, 4, 6, &known[1]);
  if (!wanted) {
    molecule->left_out.other_models += atoms;
    return true;
  }
  if (drawn) {
    return failure_in_input(failure, reader->number - 2, "a drawing in two dimensions, 2D: it says nothing of space");
  }
  if (field_is(version, "V3000")) return read_table(reader, molecule, failure);
  if (known[0] && known[1]) return read_columns(reader, atoms, bonds, molecule, failure);
  return failure_in_input(failure, reader->number, "expected the numbers of atoms and bonds in columns 1 to 6");
}

static bool read_sdf(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  for (;;) {
    bool blank = true, drawn = false;
    enum line_status status = LINE_READ;
    for (int line = 0; line <= HEADER_LINES && status == LINE_READ; ++line) {
      status = line_reader_next(reader, failure);
      if (status != LINE_READ) break;
      struct field first;
      blank = blank && fields_split(reader->text, reader->length, &first, 1) == 0;
      if (line == 1) drawn = field_is(field_in_columns(reader->text, reader->length, 21, 22), "2D");
    }
    if (status == LINE_FAILED) return false;
    if (status == LINE_END) {
      return blank || molecule->models > 0 ||
             failure_in_input(failure, reader->number, "the file ends before the numbers of atoms and bonds");
    }
    if (!read_record(reader, drawn, molecule, failure)) return false;
    status = skip_record(reader, failure);
    if (status != LINE_READ) return status == LINE_END;
  }
}

const struct file_format sdf_format = {.name = "sdf",
                                       .extensions = "SDF SD MOL",
                                       ANGSTROM,
                                       .features = FILE_ATOMS | FILE_ELEMENTS | FILE_ORDERS,
                                       .nameless = "no element",
                                       .read = read_sdf};
