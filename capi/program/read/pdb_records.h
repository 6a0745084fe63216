/* The common part of .pdb and .pqr files: lines that begin with the name of a record. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/failure.h"
#include "read/line_reader.h"
#include "read/molecule.h"

/* The last column that an atom record must have: x, y, z end in it. */
enum { LAST_COORDINATE_COLUMN = 54 };

enum pdb_record {
  PDB_ATOM,  /* ATOM or HETATM, blanks before it allowed */
  PDB_MODEL, /* a model begins */
  PDB_END,   /* END or ENDMDL: a model is over */
  PDB_OTHER, /* any other record of the format */
  PDB_BLANK, /* an empty line, or one that begins with '#' */
  PDB_ALIEN  /* no record of the format */
};

/* The kind of a reader's line, by its first columns. */
enum pdb_record pdb_record_of(const char *line, size_t length);

/* Whether the line begins with "ATOM  " or "HETATM", as atom records do in nearly all files. It is a reader's. */
bool pdb_record_is_plain_atom(const char *line, size_t length);

/* Whether an atom record is HETATM. */
bool pdb_record_is_hetatm(const char *line);

/* The models of a file. One begins with MODEL, or with an atom outside of every model; it ends with END, ENDMDL, the
 * next MODEL or the file. */
struct pdb_models {
  uint64_t count; /* models that have begun */
  bool open;      /* the last of them has not ended */
  uint64_t ends;  /* TER records so far */
};

#define PDB_MODELS_NONE \
  { 0, false, 0 }

/* Step over a record. */
void pdb_models_step(struct pdb_models *models, enum pdb_record record);

/* Step over a line of a file (begins of file_format). If the first model begins with MODEL, the lines before it are
 * common to all models. Records behind the end of a model belong to the next one, if there is one. */
bool pdb_begins_molecule(struct molecule_lines *lines, const struct line_reader *reader);

/* The title in the records before the first atom, or else the compound, or the name in a remark. */
struct field pdb_title_of(const char *text, size_t length);

/* Step to the next atom record of the molecule's model, and count the atoms of other models. In .pdb files CONECT
 * records give bonds, wherever they are. LINE_END: no atom record is left. A file that has lines, but not one record of
 * the format, fails. `models` and `record_seen` are zeros at first. */
enum line_status pdb_next_atom(struct line_reader *reader, struct molecule *molecule, struct pdb_models *models,
                               bool *record_seen, struct failure *failure);
