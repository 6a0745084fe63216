#include "pdb_records.h"

#include <string.h>

#include "characters.h"

/* Records of "Protein Data Bank contents guide", versions 2.3 and 3.3, and of programs in wide use, by the letters that
 * their names begin with. */
static const char *const other_records[] = {
    "ANISOU", "AUTHOR", "CAVEAT", "CISPEP", "COMPND", "CONECT", "CRYST1", "DBREF",  "EXPDTA", "FORMUL", "FTNOTE",
    "HEADER", "HELIX",  "HET",    "HYDBND", "JRNL",   "KEYWDS", "LINK",   "MASTER", "MDLTYP", "MODRES", "MTRIX",
    "NUMMDL", "OBSLTE", "ORIGX",  "REMARK", "REVDAT", "SCALE",  "SEQADV", "SEQRES", "SHEET",  "SIGATM", "SIGUIJ",
    "SITE",   "SLTBRG", "SOURCE", "SPLIT",  "SPRSDE", "SSBOND", "TER",    "TITLE",  "TURN",   "TVECT",  "USER",
};

/* Whether a line begins with the word, in any case, and the word ends there: no letter follows. */
static bool begins_with_word(const char *line, size_t length, const char *word) {
  size_t i = 0;
  while (i < length && word[i] != '\0' && to_upper(line[i]) == word[i]) ++i;
  return word[i] == '\0' && (i == length || !is_letter(line[i]));
}

static bool begins_with(const char *line, size_t length, const char *word) {
  size_t i = 0;
  while (i < length && word[i] != '\0' && to_upper(line[i]) == word[i]) ++i;
  return word[i] == '\0';
}

enum pdb_record pdb_record_of(const char *line, size_t length) {
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
    if (begins_with(line, length, other_records[i])) return PDB_OTHER;
  }
  return PDB_ALIEN;
}

enum line_status pdb_next_atom(struct line_reader *reader, bool *record_seen, bool *model_seen,
                               struct failure *failure) {
  bool alien_seen = false;
  for (;;) {
    const enum line_status status = line_reader_next(reader, failure);
    if (status == LINE_FAILED) return LINE_FAILED;
    if (status == LINE_END) {
      if (*record_seen || !alien_seen) return LINE_END;
      failure_in_input(failure, 0, "no PDB record in the file");
      return LINE_FAILED;
    }
    switch (pdb_record_of(reader->text, reader->length)) {
      case PDB_ATOM:
        *record_seen = true;
        return LINE_READ;
      case PDB_MODEL:
        *record_seen = true;
        if (*model_seen) return LINE_END;
        *model_seen = true;
        break;
      case PDB_END:
        return LINE_END;
      case PDB_OTHER:
        *record_seen = true;
        break;
      case PDB_BLANK:
        break;
      case PDB_ALIEN:
        alien_seen = true;
        break;
    }
  }
}
