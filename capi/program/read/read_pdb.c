/* .pdb: records in fixed columns, after "Protein Data Bank contents guide", version 3.3. Of an atom record count, in
 * columns from 1: name 13-16, alternate location 17, residue 18-20, chain 22, number and insertion code 23-27, or a
 * number of five digits there, x 31-38, y 39-46, z 47-54, occupancy 55-60, element 77-78; where there is no chain, the
 * segment in 73-76. Column 21 is one of the residue or of the chain (pdb_names.h). Neighbouring fields may touch.
 * Serial numbers, 7-11, are texts that CONECT records name atoms by. .pdbqt: the same with a charge in 71-76 and a type
 * of AutoDock's in 78-80. */
#include <string.h>

#include "read/alternate_locations.h"
#include "read/atom_elements.h"
#include "read/characters.h"
#include "read/frame_title.h"
#include "read/location_choice.h"
#include "read/number.h"
#include "read/pdb_names.h"
#include "read/pdb_records.h"
#include "read/read_molecule.h"
#include "read/words.h"

enum { LAST_COLUMN = 80 };

/* The character in a column, blank beyond the end. */
static char column(const struct line_reader *reader, size_t number) {
  return number <= reader->length ? reader->text[number - 1] : ' ';
}

/* The element in columns 77-78: right-justified as the format wants it, or left-justified; a charge that begins in
 * column 78 is no part of it. Old files have line numbers there, or nothing. Letters in both 78 and 79 are a type of
 * AutoDock's, which .pdbqt files have there and up to column 80. */
static void label_element(const struct line_reader *reader, bool autodock, struct atom_label *label) {
  const char *const text = reader->text;
  const bool pair = is_letter(column(reader, 78));
  struct atom_evidence evidence = {ATOM_COLUMNS, {text + 12, 4}, {"", 0}};
  if (is_letter(column(reader, 77))) {
    evidence.stated = (struct field){text + 76, pair ? 2 : 1};
  } else if (autodock || (pair && is_letter(column(reader, 79)))) {
    evidence.dialect = ATOM_AUTODOCK;
    evidence.stated = field_in_columns(text, reader->length, 78, 80);
  } else if (pair && column(reader, 77) == ' ') {
    evidence.stated = (struct field){text + 77, 1};
  }
  atom_take_element(&evidence, label);
}

/* The name of the segment, which CHARMM and NAMD write instead of a chain. Files of before 1996 have the entry's name
 * there, and the number of the line behind it. */
static struct field segment_of(const struct line_reader *reader) {
  const struct field behind = field_in_columns(reader->text, reader->length, 77, LAST_COLUMN);
  size_t digits = 0;
  while (digits < behind.length && is_digit(behind.text[digits])) ++digits;
  const bool numbered = behind.length > 0 && digits == behind.length;
  return numbered ? (struct field){"", 0} : field_in_columns(reader->text, reader->length, 73, 76);
}

/* The data kept from one plain record to the next: columns 18-25, 20-27 and 69-76, zeros after other records, and the
 * residue in them, here and in the molecule. */
struct plain_records {
  uint64_t columns[3];
  struct residue_label residue;
  const struct residue_label *kept;
};

/* A file that is being read. */
struct pdb_reading {
  struct pdb_models models;
  struct pdb_names names;
  struct alternate_locations seen;
  struct location_choice choice;
  struct plain_records plain;
  uint64_t model; /* that the last atom is of */
};

/* The last column of a residue's number. The fifth digit of one past 9999 is no insertion code. */
static size_t end_of_number(const char *text) {
  for (size_t at = 22; at < 27; ++at) {
    if (!is_digit(text[at])) return 26;
  }
  return 27;
}

static bool label_residue(const struct line_reader *reader, struct pdb_reading *reading, uint64_t copy,
                          const char *atom, struct residue_label *label, struct failure *failure) {
  const char *text = reader->text;
  const size_t length = reader->length;
  pdb_names_read(&reading->names, text, label);
  if (label->chain[0] == '\0') label_copy(label->chain, sizeof label->chain, segment_of(reader));
  const size_t end = end_of_number(text);
  label_copy(label->number, sizeof label->number, field_in_columns(text, length, 23, end));
  label_copy(label->insertion, sizeof label->insertion, field_in_columns(text, length, end + 1, 27));
  if (label->chain[0] == '\0') pdb_names_number(&reading->names, reading->models.ends, atom, label);
  return chain_name_copy(label, copy, failure);
}

/* Tabs behind the coordinates count as blanks; before their end it is not known which columns they replace. */
static bool check_columns(const struct line_reader *reader, struct failure *failure) {
  const uint64_t line = reader->number;
  const size_t looked_at = reader->length < LAST_COORDINATE_COLUMN ? reader->length : LAST_COORDINATE_COLUMN;
  if (memchr(reader->text, '\t', looked_at) != NULL) {
    return failure_in_input(failure, line, "a tab in a record of fixed columns");
  }
  for (size_t i = looked_at; i < reader->length; ++i) {
    if (reader->text[i] == '\t') reader->text[i] = ' ';
  }
  if (reader->text[0] == ' ') return failure_in_input(failure, line, "the record does not begin in column 1");
  if (reader->length < LAST_COORDINATE_COLUMN) {
    return failure_in_input(failure, line, "short record: it ends in column %u, x y z need columns 31-54",
                            (unsigned)reader->length);
  }
  /* A digit in column 55 that is no part of an occupancy is one of a z that is too long. */
  if (is_digit(reader->text[LAST_COORDINATE_COLUMN - 1]) && is_digit(column(reader, LAST_COORDINATE_COLUMN + 1)) &&
      column(reader, LAST_COORDINATE_COLUMN + 2) == ' ') {
    return failure_in_input(failure, line, "z (columns 47-54) goes on in column 55");
  }
  return true;
}

/* The serial number and the temperature factor, if they are kept. */
static void take_extra(const struct line_reader *reader, struct atom_extra *extra) {
  if (extra == NULL) return;
  label_copy(extra->serial.text, sizeof extra->serial.text, field_in_columns(reader->text, reader->length, 7, 11));
  const struct field factor = field_in_columns(reader->text, reader->length, 61, 66);
  extra->has_value = number_parse(factor.text, factor.length, &extra->value) == NUMBER_OK;
}

static bool is_autodock(const struct molecule *molecule) {
  return (molecule->format->features & FILE_CHARGES) != 0;
}

/* In columns 71-76 .pdb files have a segment, .pdbqt files a charge. */
static void move_charge(const struct line_reader *reader, char charge[7]) {
  for (size_t i = 0; i < 6; ++i) {
    charge[i] = column(reader, 71 + i);
    if (71 + i <= reader->length) reader->text[70 + i] = ' ';
  }
}

/* The letter of an atom's location; empty: it has none. */
static struct field letter_of(const struct line_reader *reader) {
  return field_in_columns(reader->text, reader->length, 17, 17);
}

/* Whether the record belongs to the molecule, or may belong to it once the locations that count are known. */
static bool keeps(struct pdb_reading *reading, const struct molecule *molecule, const struct atom_label *label,
                  struct field segment, struct field letter, bool *keep) {
  const bool later = molecule->choice.location != LOCATION_FIRST && letter.length > 0;
  *keep = true;
  return later || alternate_locations_keep(&reading->seen, molecule, label, segment, letter, keep);
}

/* Note the location of the last atom, if the user has a choice. */
static bool note_location(const struct line_reader *reader, struct location_choice *choice,
                          const struct molecule *molecule, struct failure *failure) {
  const struct field letter = letter_of(reader);
  const struct atom_label *const label = &molecule->label[molecule->atoms - 1];
  if (letter.length == 0 && !residue_is_numbered(label->residue)) return true;
  const struct residue_place place =
      residue_place_of(label->residue, field_in_columns(reader->text, reader->length, 73, 76));
  return location_choice_add(choice, molecule, &place, label->name, label->residue->name, letter,
                             field_in_columns(reader->text, reader->length, 55, 60), failure);
}

/* Note the data of the last atom added about which the end of the file decides. */
static inline bool note_atom(const struct line_reader *reader, struct pdb_reading *reading, struct molecule *molecule,
                             struct failure *failure) {
  if (reader->text[20] != ' ' && !pdb_names_note(&reading->names, reader->text, molecule, failure)) return false;
  take_extra(reader, molecule_last_extra(molecule));
  return molecule->choice.location == LOCATION_FIRST || note_location(reader, &reading->choice, molecule, failure);
}

static bool read_atom(const struct line_reader *reader, struct pdb_reading *reading, struct molecule *molecule,
                      struct failure *failure) {
  const uint64_t line = reader->number;
  const bool autodock = is_autodock(molecule);
  char charge[7] = "";
  if (!check_columns(reader, failure)) return false;
  if (autodock) move_charge(reader, charge);
  double xyz[3];
  static const char *const names[3] = {"x (columns 31-38)", "y (columns 39-46)", "z (columns 47-54)"};
  for (size_t axis = 0; axis < 3; ++axis) {
    const struct field number = field_in_columns(reader->text, reader->length, 31 + 8 * axis, 38 + 8 * axis);
    if (!field_number_in_line(number, names[axis], &xyz[axis], line, failure)) return false;
  }
  struct residue_label residue = RESIDUE_LABEL_NONE;
  struct atom_label label = ATOM_LABEL_NONE;
  label.residue = &residue;
  const struct field name = field_in_columns(reader->text, reader->length, 13, 16);
  label_copy(label.name, sizeof label.name, name);
  if (!label_residue(reader, reading, molecule->copy, label.name, &residue, failure)) return false;
  label.hetatm = pdb_record_is_hetatm(reader->text);
  const struct field segment = field_in_columns(reader->text, reader->length, 73, 76);
  bool keep;
  if (!keeps(reading, molecule, &label, segment, letter_of(reader), &keep)) return failure_of_memory(failure);
  if (!keep) {
    ++molecule->left_out.alternate_locations;
    return true;
  }
  label_element(reader, autodock, &label);
  if (!molecule_add(molecule, xyz, 0.0, &label, line, failure) || !note_atom(reader, reading, molecule, failure))
    return false;
  struct atom_extra *const extra = molecule_last_extra(molecule);
  if (autodock && extra != NULL) {
    const struct field value = field_in_columns(charge, 6, 1, 6);
    extra->has_value = number_parse(value.text, value.length, &extra->value) == NUMBER_OK;
  }
  return true;
}

/* Whether there is a tab among 72 characters. */
static bool has_tab(const char *text) {
  uint32_t found = 0;
  for (size_t at = 0; at < 64; at += 16) found |= equal_in_16(text + at, '\t');
  return (found | equal_in_16(text + 56, '\t')) != 0;
}

static bool goes_on(const struct plain_records *plain, const uint64_t columns[3]) {
  const uint64_t segment = (columns[2] ^ plain->columns[2]) >> 32;
  return columns[0] == plain->columns[0] && columns[1] == plain->columns[1] && segment == 0;
}

static void plain_residue(const char *text, const uint64_t columns[3], const struct pdb_names *names,
                          struct plain_records *plain) {
  memset(&plain->residue, 0, sizeof plain->residue);
  if (text[20] == ' ') {
    word_put(plain->residue.name, word_label(columns[0], 3));
    plain->residue.chain[0] = text[21];
  } else {
    pdb_names_read(names, text, &plain->residue);
  }
  const size_t end = end_of_number(text);
  word_put(plain->residue.number, word_label(columns[1] >> 24, (unsigned)(end - 22)));
  if (end == 26 && text[26] != ' ') plain->residue.insertion[0] = text[26];
}

/* Most records, eight columns at a time: one with all columns, a chain, a usual element, decimals that end in the last
 * of their columns, without tabs and without a letter of its location. LINE_END: it is no such record, whatever else,
 * and nothing was done. */
static enum line_status read_plain_atom(const struct line_reader *reader, struct pdb_reading *reading,
                                        struct molecule *molecule, struct failure *failure) {
  const char *const text = reader->text;
  struct plain_records *const plain = &reading->plain;
  struct alternate_locations *const seen = &reading->seen;
  struct atom_label label = ATOM_LABEL_NONE;
  double xyz[3];
  if (reader->length < 78 || text[16] != ' ' || text[54] != ' ' || !pdb_record_is_plain_atom(text, reader->length))
    return LINE_END;
  if (has_tab(text + 6)) return LINE_END;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (!word_number(word_at(text + 30 + 8 * axis), &xyz[axis])) return LINE_END;
  }
  const uint64_t columns[3] = {word_at(text + 17), word_at(text + 19), word_at(text + 68)};
  const bool on = goes_on(plain, columns);
  if (!on && text[21] == ' ') return LINE_END; /* it may be the segment's name that tells the chain */
  if (!on) {
    plain_residue(text, columns, &reading->names, plain);
    if (molecule->copy > 1 && !chain_name_copy(&plain->residue, molecule->copy, failure)) return LINE_FAILED;
  }
  label.residue = on ? plain->kept : &plain->residue;
  if (text[76] != ' ' || is_letter(text[78]) || !atom_is_usual(text[77], label.residue->name)) return LINE_END;
  label.element.text[0] = text[77];
  label.hetatm = text[0] == 'H';
  word_put(label.name, word_label(word_at(text + 12), 4));
  bool keep;
  if (on) {
    alternate_locations_go_on(seen);
  } else if (!alternate_locations_keep(seen, molecule, &label, field_in_columns(text, reader->length, 73, 76),
                                       (struct field){"", 0}, &keep)) {
    failure_of_memory(failure);
    return LINE_FAILED;
  }
  if (!molecule_add(molecule, xyz, 0.0, &label, reader->number, failure)) return LINE_FAILED;
  memcpy(plain->columns, columns, sizeof columns);
  plain->kept = molecule->label[molecule->atoms - 1].residue;
  return note_atom(reader, reading, molecule, failure) ? LINE_READ : LINE_FAILED;
}

static bool read_any_atom(struct line_reader *reader, struct pdb_reading *reading, struct molecule *molecule,
                          struct failure *failure) {
  const enum line_status status =
      is_autodock(molecule) ? LINE_END : read_plain_atom(reader, reading, molecule, failure);
  if (status == LINE_END) reading->plain.columns[0] = 0;
  return status == LINE_END ? read_atom(reader, reading, molecule, failure) : status == LINE_READ;
}

static void free_reading(struct pdb_reading *reading) {
  alternate_locations_free(&reading->seen);
  location_choice_free(&reading->choice);
  pdb_names_free(&reading->names);
}

static bool read_pdb(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  struct pdb_reading reading = {.model = 0};
  bool record_seen = false;
  enum line_status status;
  for (;;) {
    status = pdb_next_atom(reader, molecule, &reading.models, &record_seen, failure);
    if (reading.models.count != reading.model) { /* of another one that is read with those before */
      reading.model = reading.models.count;
      reading.plain.columns[0] = reading.names.number = 0;
    }
    if (status == LINE_READ && !read_any_atom(reader, &reading, molecule, failure)) status = LINE_FAILED;
    if (status != LINE_READ) break;
  }
  pdb_names_finish(&reading.names);
  if (status == LINE_END && !location_choice_finish(&reading.choice, molecule, failure)) status = LINE_FAILED;
  free_reading(&reading);
  return status == LINE_END;
}

/* Read the records of one model, from the one after its MODEL, if that has begun, to its end. */
static enum line_status read_records(struct line_reader *reader, bool *begun, bool wanted, struct pdb_reading *reading,
                                     struct molecule *molecule, struct failure *failure) {
  for (;;) {
    const enum line_status status = line_reader_next(reader, failure);
    const bool within = *begun;
    if (status == LINE_END) *begun = false;
    if (status != LINE_READ) return status == LINE_END && within ? LINE_READ : status;
    const enum pdb_record record = pdb_record_of(reader->text, reader->length);
    if (record == PDB_MODEL || record == PDB_ATOM) *begun = true;
    if (record == PDB_END) *begun = false;
    if (within && (record == PDB_MODEL || record == PDB_END)) return LINE_READ;
    if (record == PDB_OTHER && !within) frame_title_read(reader->text, &molecule->frame);
    if (record == PDB_OTHER) box_from_cryst1(reader, &molecule->frame.box);
    if (record == PDB_ATOM && wanted && !read_any_atom(reader, reading, molecule, failure)) return LINE_FAILED;
  }
}

static enum line_status next_pdb(struct line_reader *reader, bool *begun, bool wanted, struct molecule *molecule,
                                 struct failure *failure) {
  struct pdb_reading reading = {.model = 0};
  enum line_status status = read_records(reader, begun, wanted, &reading, molecule, failure);
  if (status == LINE_READ && !location_choice_finish(&reading.choice, molecule, failure)) status = LINE_FAILED;
  free_reading(&reading);
  return status;
}

const struct file_format pdb_format = {.name = "pdb",
                                       .extensions = "PDB# ENT",
                                       ANGSTROM,
                                       .features = FILE_ATOMS | FILE_ELEMENTS | FILE_RESIDUES | FILE_HETATM |
                                                   FILE_TEMPERATURE_FACTORS | FILE_BONDS | FILE_AREA_COLUMNS |
                                                   FILE_ONE_BOX | FILE_FRAMES | FILE_LOCATIONS | FILE_MOLECULES,
                                       .nameless = "no element in columns 77-78, and none",
                                       .read = read_pdb,
                                       .next = next_pdb,
                                       .begins = pdb_begins_molecule,
                                       .title = pdb_title_of};

/* The files of AutoDock, Vina and similar programs: the same records, and those of a ligand's branches, which are
 * ignored. */
const struct file_format pdbqt_format = {
    .name = "pdbqt",
    .extensions = "PDBQT",
    ANGSTROM,
    .features = FILE_ATOMS | FILE_ELEMENTS | FILE_RESIDUES | FILE_HETATM | FILE_CHARGES | FILE_MOLECULES,
    .nameless = "no known type in columns 78-79, and no element",
    .read = read_pdb,
    .begins = pdb_begins_molecule,
    .title = pdb_title_of};
