/* What .pdb and .pqr files have in common: lines that begin with the name of a record. */
#ifndef HARDSPHERE_TOOL_PDB_RECORDS_H
#define HARDSPHERE_TOOL_PDB_RECORDS_H

#include <stdbool.h>
#include <stddef.h>

#include "failure.h"
#include "line_reader.h"

enum pdb_record {
  PDB_ATOM,  /* ATOM or HETATM, blanks before it allowed */
  PDB_MODEL, /* a model begins */
  PDB_END,   /* END or ENDMDL: the first model is over */
  PDB_OTHER, /* any other record of the format */
  PDB_BLANK, /* nothing, or a line that begins with '#' */
  PDB_ALIEN  /* no record of the format */
};

/* What the line is, by its first columns. */
enum pdb_record pdb_record_of(const char *line, size_t length);

/* Step to the next atom record of the first model. LINE_END: there is none left. A file that has lines, but not one
 * record of the format, fails. */
enum line_status pdb_next_atom(struct line_reader *reader, bool *record_seen, bool *model_seen,
                               struct failure *failure);

#endif
