#include "read/pdb_records.h"

#include <string.h>

#include "read/characters.h"
#include "read/molecule_texts.h"
#include "read/words.h"

/* Records of "Protein Data Bank contents guide", versions 2.3 and 3.3, and of programs in wide use, by the letters that
 * their names begin with. */
static const char *const other_records[] = {
    "ANISOU", "AUTHOR", "CAVEAT", "CISPEP", "COMPND", "CONECT", "CRYST",  "DBREF",  "EXPDTA", "FORMUL",
    "FTNOTE", "HEADER", "HELIX",  "HET",    "HETNAM", "HETSYN", "HYDBND", "JRNL",   "KEYWDS", "LINK",
    "LINKR",  "MASTER", "MDLTYP", "MODRES", "MTRIX",  "NUMMDL", "OBSLTE", "ORIGX",  "REMARK", "REVDAT",
    "SCALE",  "SEQADV", "SEQRES", "SHEET",  "SIGATM", "SIGUIJ", "SITE",   "SLTBRG", "SOURCE", "SPLIT",
    "SPRSDE", "SSBOND", "TER",    "TITLE",  "TURN",   "TVECT",  "USER",
};

/* Whether a line begins with the word, in any case, and the word ends there: no letter and no '_' follows. Digits may:
 * those of ORIGX1, and serial numbers. */
static bool begins_with_word(const char *line, size_t length, const char *word) {
  size_t i = 0;
  while (i < length && word[i] != '\0' && to_upper(line[i]) == word[i]) ++i;
  return word[i] == '\0' && (i == length || (!is_letter(line[i]) && line[i] != '_'));
}

static bool begins_with(const char *line, size_t length, const char *word) {
  size_t i = 0;
  while (i < length && word[i] != '\0' && to_upper(line[i]) == word[i]) ++i;
  return word[i] == '\0';
}

enum pdb_record pdb_record_of(const char *line, size_t length) {
  /* Most lines are "ATOM  " or "HETATM". */
  if (pdb_record_is_plain_atom(line, length)) return PDB_ATOM;
  size_t blanks = 0;
  while (blanks < length && is_blank(line[blanks])) ++blanks;
  if (blanks == length || line[0] == '#') return PDB_BLANK;
  /* A serial number may follow HETATM at once, and may begin with a letter ("hybrid-36"). */
  if (begins_with_word(line + blanks, length - blanks, "ATOM") ||
      begins_with(line + blanks, length - blanks, "HETATM")) {
    return PDB_ATOM;
  }
  if (begins_with_word(line, length, "MODEL")) return PDB_MODEL;
  if (begins_with_word(line, length, "END") || begins_with_word(line, length, "ENDMDL")) return PDB_END;
  for (size_t i = 0; i < sizeof other_records / sizeof other_records[0]; ++i) {
    if (begins_with_word(line, length, other_records[i])) return PDB_OTHER;
  }
  return PDB_ALIEN;
}

/* Bonds in a CONECT record: of the atom in columns 7-11 with those in 12-16, 17-21, 22-26 and 27-31; a double bond is
 * there twice. Columns after them, in old versions of the format, hold no bonds. */
static bool take_bonds(const struct line_reader *reader, uint64_t model, struct molecule *molecule,
                       struct failure *failure) {
  struct stated_bond bond = {.order = BOND_UNKNOWN, .model = (uint32_t)model};
  const size_t length = reader->length;
  label_copy(bond.serial[0].text, sizeof bond.serial[0].text, field_in_columns(reader->text, length, 7, 11));
  if (bond.serial[0].text[0] == '\0') return true;
  for (size_t column = 12; column <= 27; column += 5) {
    const struct field other = field_in_columns(reader->text, length, column, column + 4);
    label_copy(bond.serial[1].text, sizeof bond.serial[1].text, other);
    if (other.length > 0 && !molecule_add_bond(molecule, &bond, failure)) return false;
  }
  return true;
}

bool pdb_record_is_plain_atom(const char *line, size_t length) {
  const uint64_t six = length < 6 ? 0 : word_first(word_at(line), 6); /* of ATOM or HETATM */
  return six == UINT64_C(0x20204D4F5441) || six == UINT64_C(0x4D5441544548);
}

bool pdb_record_is_hetatm(const char *line) {
  while (is_blank(*line)) ++line;
  return to_upper(*line) == 'H';
}

void pdb_models_step(struct pdb_models *models, enum pdb_record record) {
  if (record == PDB_END) {
    models->open = false;
  } else if (record == PDB_MODEL || (record == PDB_ATOM && !models->open)) {
    ++models->count;
    models->open = true;
  }
}

enum line_status pdb_next_atom(struct line_reader *reader, struct molecule *molecule, struct pdb_models *models,
                               bool *record_seen, struct failure *failure) {
  bool alien_seen = false;
  for (;;) {
    const enum line_status status = line_reader_next(reader, failure);
    if (status == LINE_FAILED) return LINE_FAILED;
    if (status == LINE_END) {
      molecule->models = models->count;
      if (*record_seen || !alien_seen) return LINE_END;
      failure_in_input(failure, 0, "no PDB record in the file");
      return LINE_FAILED;
    }
    const enum pdb_record record = pdb_record_of(reader->text, reader->length);
    pdb_models_step(models, record);
    if (record == PDB_OTHER) box_from_cryst1(reader, &molecule->frame.box);
    if (record == PDB_OTHER && (!symmetry_take_pdb_record(&molecule->symmetry, reader, failure) ||
                                !assemblies_take_pdb_record(&molecule->assemblies, reader, failure))) {
      return LINE_FAILED;
    }
    if (record == PDB_OTHER && begins_with_word(reader->text, reader->length, "TER")) ++models->ends;
    alien_seen = alien_seen || record == PDB_ALIEN;
    *record_seen = *record_seen || record == PDB_ATOM || record == PDB_MODEL || record == PDB_OTHER;
    if (record == PDB_OTHER && file_format_has(molecule->format, FILE_BONDS) &&
        begins_with_word(reader->text, reader->length, "CONECT") &&
        !take_bonds(reader, models->count, molecule, failure)) {
      return LINE_FAILED;
    }
    if (record != PDB_ATOM) continue;
    if (molecule_wants_model(molecule, models->count)) return LINE_READ;
    ++molecule->left_out.other_models;
  }
}

bool pdb_begins_molecule(struct molecule_lines *lines, const struct line_reader *reader) {
  const enum pdb_record record = pdb_record_of(reader->text, reader->length);
  struct pdb_models models = {lines->count, lines->open, 0};
  pdb_models_step(&models, record);
  const bool begins = models.count > lines->count;
  lines->first = lines->count == 0 && (record == PDB_MODEL || !begins);
  lines->count = models.count;
  lines->open = models.open;
  lines->behind = !models.open && record != PDB_END;
  return begins;
}

/* From a column on, without what begins with `before`. */
static struct field title_in(struct field line, size_t column, const char *before) {
  const struct field text = field_in_columns(line.text, line.length, column, line.length);
  const size_t length = strlen(before);
  if (text.length < length || memcmp(text.text, before, length) != 0) return (struct field){"", 0};
  return field_in_columns(text.text, text.length, length + 1, text.length);
}

struct field pdb_title_of(const char *text, size_t length) {
  struct field compound = {"", 0}, name = {"", 0};
  while (length > 0) {
    const struct field line = molecule_text_next_line(&text, &length);
    if (begins_with_word(line.text, line.length, "TITLE")) return title_in(line, 11, "");
    if (pdb_record_of(line.text, line.length) == PDB_ATOM) break;
    if (compound.length == 0 && begins_with_word(line.text, line.length, "COMPND")) compound = title_in(line, 11, "");
    if (name.length == 0 && begins_with_word(line.text, line.length, "REMARK")) name = title_in(line, 7, "Name =");
  }
  return compound.length > 0 ? compound : name;
}
