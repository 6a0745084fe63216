/* .sdf and .mol, the structure-data files of MDL: three lines of header, a line with the numbers of atoms and bonds, a
 * line for each, what else is known, and "$$$$" where another record follows: each is a model. V2000 has fixed columns,
 * V3000 blocks of lines "M  V30 index type x y z ..", which go on in the next line where they end in '-'. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "read/atom_elements.h"
#include "read/characters.h"
#include "read/number.h"
#include "read/read_molecule.h"
#include "read/text_buffer.h"
#include "read/words.h"

enum { HEADER_LINES = 3, MOST_COLUMNS = 8, BEFORE_SYMBOL = 30 };

/* At the end of the file there is no line. */
static bool is_end_of_record(const struct line_reader *reader) {
  return reader->text != NULL && reader->text[0] == '$' && strncmp(reader->text, "$$$$", 4) == 0;
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

/* index: what bonds name it by. number: NULL if xyz has them. */
static bool add_atom(const struct line_reader *reader, struct field symbol, const struct field *number, double xyz[3],
                     struct field index, struct molecule *molecule, struct failure *failure) {
  static const char *const names[3] = {"x", "y", "z"};
  struct atom_label label = ATOM_LABEL_NONE;
  const struct atom_evidence evidence = {ATOM_QUERIES, {"", 0}, symbol};
  if (symbol.length == 1 && atom_is_usual(symbol.text[0], "")) {
    label.element.text[0] = symbol.text[0];
  } else if (!atom_take_element(&evidence, &label)) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, reader->number, "unknown element '%s'",
                            excerpt(shown, symbol.text, symbol.length));
  }
  for (int axis = 0; axis < 3 && number != NULL; ++axis) {
    if (!field_number(number[axis], names[axis], &xyz[axis], reader->number, failure)) return false;
  }
  if (!molecule_add(molecule, xyz, 0.0, &label, reader->number, failure)) return false;
  struct atom_extra *const extra = molecule_last_extra(molecule);
  if (extra != NULL && !serial_of_number(index, &extra->serial)) extra->serial.text[0] = '\0';
  return true;
}

/* Kinds beyond 4 are for queries, bonds to metals and hydrogen bonds, which do not count as bonds. */
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

/* Most coordinates, eight columns at a time. */
static bool plain_numbers(const struct line_reader *reader, double xyz[3]) {
  if (reader->length < 34) return false;
  for (size_t axis = 0; axis < 3; ++axis) {
    const char *const text = reader->text + 10 * axis;
    if (text[0] != ' ' || text[1] != ' ' || !word_number(word_at(text + 2), &xyz[axis])) return false;
  }
  return true;
}

static bool read_columns(struct line_reader *reader, uint64_t atoms, uint64_t bonds, struct molecule *molecule,
                         struct failure *failure) {
  const uint64_t counts_line = reader->number;
  const bool bonded = (molecule->keeps & KEEP_EXTRAS) != 0;
  for (uint64_t i = 0; i < atoms + bonds; ++i) {
    const char *passed;
    size_t bytes;
    if (i >= atoms && !bonded) i += line_reader_pass(reader, '$', &passed, &bytes);
    if (i >= atoms + bonds) break;
    const enum line_status status = line_reader_next(reader, failure);
    if (status == LINE_FAILED) return false;
    if (status == LINE_END || is_end_of_record(reader)) {
      return failure_in_input(failure, counts_line,
                              "%" PRIu64 " atoms and %" PRIu64 " bonds announced, the record ends after %" PRIu64
                              " lines",
                              atoms, bonds, i);
    }
    if (i >= atoms && !bonded) continue;
    struct field part[3];
    double xyz[3];
    if (i < atoms && reader->length > BEFORE_SYMBOL && !is_blank(reader->text[BEFORE_SYMBOL])) {
      return failure_in_input(failure, reader->number, "column 31, between z and the symbol, is not blank");
    }
    const bool plain = i < atoms && plain_numbers(reader, xyz);
    for (size_t k = 0; k < 3 && !plain; ++k) {
      const size_t wide = i < atoms ? 10 : 3;
      part[k] = field_in_columns(reader->text, reader->length, k * wide + 1, (k + 1) * wide);
    }
    if (i >= atoms) {
      if (!add_bond(part[2], part, molecule, failure)) return false;
      continue;
    }
    char index[24];
    struct field name = {index, 0};
    if (bonded) name.length = (size_t)snprintf(index, sizeof index, "%" PRIu64, i + 1);
    const struct field symbol = plain && reader->text[31] != ' ' && memcmp(reader->text + 32, "  ", 2) == 0
                                    ? (struct field){reader->text + 31, 1}
                                    : field_in_columns(reader->text, reader->length, 32, 34);
    if (!add_atom(reader, symbol, plain ? NULL : part, xyz, name, molecule, failure)) return false;
  }
  return true;
}

/* ---- V3000 ---- */

static const char table_head[] = "M  V30 ";

/* The rest of the reader's line behind the head, without the '-' that tells that it goes on. */
static struct field behind_head(const struct line_reader *reader, bool *goes_on) {
  struct field rest = {reader->text + sizeof table_head - 1, reader->length - (sizeof table_head - 1)};
  size_t end = rest.length;
  while (end > 0 && is_blank(rest.text[end - 1])) --end;
  *goes_on = end > 0 && rest.text[end - 1] == '-';
  if (*goes_on) rest.length = end - 1;
  return rest;
}

/* The next line of the table with all lines that it goes on in, which it is joined with if there are some. *columns
 * becomes 0 at the end of the table. */
static enum line_status next_of_table(struct line_reader *reader, struct text_buffer *joined,
                                      struct field column[MOST_COLUMNS], size_t *columns, struct failure *failure) {
  static const char behind[16] = ""; /* that may be read behind a line */
  bool goes_on = false;
  joined->length = *columns = 0;
  for (;;) {
    const enum line_status status = line_reader_next(reader, failure);
    if (status == LINE_FAILED) return status;
    if (status == LINE_END || strncmp(reader->text, table_head, sizeof table_head - 1) != 0) {
      if (!goes_on) return status;
      failure_in_input(failure, reader->number, "the line before ends in '-', but M  V30 does not go on");
      return LINE_FAILED;
    }
    const bool again = goes_on;
    const struct field rest = behind_head(reader, &goes_on);
    if (!again && !goes_on) {
      *columns = fields_split(rest.text, rest.length, column, MOST_COLUMNS);
      return LINE_READ;
    }
    text_buffer_append(joined, rest.text, rest.length);
    if (!goes_on) break;
  }
  text_buffer_append(joined, behind, sizeof behind);
  if (joined->out_of_memory) {
    failure_of_memory(failure);
    return LINE_FAILED;
  }
  *columns = fields_split(joined->text, joined->length - sizeof behind, column, MOST_COLUMNS);
  return LINE_READ;
}

static bool read_table(struct line_reader *reader, struct text_buffer *joined, struct molecule *molecule,
                       struct failure *failure) {
  enum { OUTSIDE, ATOMS, BONDS } block = OUTSIDE;
  const uint64_t counts_line = reader->number;
  uint64_t announced = 0, found = 0;
  bool closed = false;
  for (;;) {
    struct field column[MOST_COLUMNS];
    size_t columns = 0;
    const enum line_status status = next_of_table(reader, joined, column, &columns, failure);
    if (status == LINE_FAILED) return false;
    if (columns == 0) {
      closed = closed || (status == LINE_READ && (strncmp(reader->text, "M  END", 6) == 0 || is_end_of_record(reader)));
      if (!closed) return failure_in_input(failure, counts_line, "the table ends before M  V30 END CTAB");
      break;
    }
    if (field_is(column[0], "COUNTS") && columns > 1) {
      if (number_parse_count(column[1].text, column[1].length, &announced) != NUMBER_OK) announced = 0;
    } else if (field_is(column[0], "BEGIN") && columns > 1) {
      block = field_is(column[1], "ATOM") ? ATOMS : field_is(column[1], "BOND") ? BONDS : OUTSIDE;
    } else if (field_is(column[0], "END")) {
      block = OUTSIDE;
      closed = closed || (columns > 1 && field_is(column[1], "CTAB"));
    } else if (block != OUTSIDE && columns < (block == ATOMS ? 5U : 4U)) {
      return failure_in_input(failure, reader->number, "expected %s",
                              block == ATOMS ? "M  V30 index type x y z" : "M  V30 index type atom atom");
    } else if (block == ATOMS) {
      double xyz[3];
      if (is_digit(column[1].text[0])) {
        return failure_in_input(failure, reader->number, "expected M  V30 index type x y z, and the type is a number");
      }
      ++found;
      if (!add_atom(reader, column[1], column + 2, xyz, column[0], molecule, failure)) return false;
    } else if (block == BONDS && !add_bond(column[1], column + 2, molecule, failure)) {
      return false;
    }
  }
  return found == announced ||
         failure_in_input(failure, counts_line, "%" PRIu64 " atoms announced, %" PRIu64 " found", announced, found);
}

/* ---- records ---- */

/* The lines before the counts of a record. */
struct header {
  bool blank;
  bool drawn;       /* it says that it is of two dimensions */
  bool braced;      /* it begins with a brace */
  const char *kind; /* what else than a molecule the record is; or NULL */
};

static const char *kind_of_title(const char *title) {
  static const char *const kinds[][2] = {{"$RXN", "a reaction ($RXN)"},
                                         {"$RDFILE", "a file of reactions ($RDFILE)"},
                                         {"$MDL", "a molecule with R groups ($MDL)"}};
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; ++k) {
    if (strncmp(title, kinds[k][0], strlen(kinds[k][0])) == 0) return kinds[k][1];
  }
  return NULL;
}

static bool read_atoms(struct line_reader *reader, const struct header *header, struct molecule *molecule,
                       struct failure *failure) {
  const struct field version = field_in_columns(reader->text, reader->length, 34, 39);
  bool known[2];
  const uint64_t atoms = count_in(reader, 1, 3, &known[0]), bonds = count_in(reader, 4, 6, &known[1]);
  if (field_is(version, "V3000")) {
    struct text_buffer joined = TEXT_BUFFER_EMPTY;
    const bool done = read_table(reader, &joined, molecule, failure);
    text_buffer_free(&joined);
    return done;
  }
  if (known[0] && known[1]) return read_columns(reader, atoms, bonds, molecule, failure);
  return failure_in_input(failure, reader->number, "expected the numbers of atoms and bonds in columns 1 to 6%s",
                          header->braced ? ": this looks like JSON" : "");
}

/* The record whose line of counts is the current one. */
static bool read_record(struct line_reader *reader, const struct header *header, struct molecule *molecule,
                        struct failure *failure) {
  const uint64_t line = reader->number;
  const uint32_t first = molecule->atoms;
  if (!molecule_wants_model(molecule, ++molecule->models)) {
    bool known;
    molecule->left_out.other_models += count_in(reader, 1, 3, &known);
    return true;
  }
  if (header->kind != NULL) return failure_in_input(failure, line - 3, "%s, and no molecule", header->kind);
  const bool done = read_atoms(reader, header, molecule, failure);
  if (!header->drawn) return done;
  /* Some programs write the mark over coordinates in space, where others have none to give. */
  if (molecule_is_flat(molecule, first)) {
    return failure_in_input(failure, line - 2, "a drawing in two dimensions, 2D: it says nothing of space");
  }
  molecule->remark = "marked 2D, but not all z are 0: taken as a molecule in space";
  return done;
}

static bool read_sdf(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  for (;;) {
    struct header header = {.blank = true};
    enum line_status status = LINE_READ;
    for (int line = 0; line <= HEADER_LINES && status == LINE_READ; ++line) {
      status = line_reader_next(reader, failure);
      if (status != LINE_READ) break;
      struct field first = {"", 0};
      header.blank = fields_split(reader->text, reader->length, &first, 1) == 0 && header.blank;
      if (line == 0) header.kind = kind_of_title(reader->text);
      if (line == 0) header.braced = first.length > 0 && (first.text[0] == '{' || first.text[0] == '[');
      if (line == 1) header.drawn = field_is(field_in_columns(reader->text, reader->length, 21, 22), "2D");
    }
    if (status == LINE_FAILED) return false;
    if (status == LINE_END) {
      return header.blank || molecule->models > 0 ||
             failure_in_input(failure, reader->number, "the file ends before the numbers of atoms and bonds%s",
                              header.braced ? ": this looks like JSON" : "");
    }
    if (!read_record(reader, &header, molecule, failure)) return false;
    if (reader->borrowed) return true; /* the text is one record, and nothing else of it is wanted */
    status = skip_record(reader, failure);
    if (status != LINE_READ) return status == LINE_END;
  }
}

/* A record ends with "$$$$" anywhere from its line of counts on. */
static bool begins_sdf(struct molecule_lines *lines, const struct line_reader *reader) {
  const bool begins = !lines->open;
  if (begins) {
    ++lines->count;
    lines->line = 0;
  }
  lines->open = !(++lines->line > HEADER_LINES && is_end_of_record(reader));
  lines->mark = lines->open ? '$' : '\0';
  return begins;
}

static struct field title_of_sdf(const char *text, size_t length) {
  return molecule_text_next_line(&text, &length);
}

const struct file_format sdf_format = {.name = "sdf",
                                       .extensions = "SDF SD MOL",
                                       ANGSTROM,
                                       .features = FILE_ATOMS | FILE_ELEMENTS | FILE_ORDERS | FILE_MOLECULES,
                                       .nameless = "no element",
                                       .read = read_sdf,
                                       .begins = begins_sdf,
                                       .title = title_of_sdf};
