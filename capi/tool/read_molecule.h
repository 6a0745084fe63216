/* From a file to a molecule. The extension of the name tells the format, unless the user does:
 *   .xyzr  x y z r          .pdb  fixed columns          .pqr  PDB records with charge and radius          .xyz */
#ifndef HARDSPHERE_TOOL_READ_MOLECULE_H
#define HARDSPHERE_TOOL_READ_MOLECULE_H

#include <stdbool.h>

#include "failure.h"
#include "line_reader.h"
#include "molecule.h"

/* The format of that name, its extension without the dot in any case of its letters; false if there is none. */
bool molecule_format_named(const char *name, enum molecule_format *format);

/* The format that a file name's extension asks for; false if there is none. */
bool molecule_format_of(const char *path, enum molecule_format *format, struct failure *failure);

/* Read one model of a file (line_reader_open), counted from 1, into a molecule that was not initialised; free it with
 * molecule_free on true and on false. Radii are 0 in formats without radii: molecule_take_radii is to follow. Every
 * file is either read in full or refused, and so is one without atoms. */
bool read_molecule(const char *path, enum molecule_format format, uint64_t model, struct molecule *molecule,
                   struct failure *failure);

/* One reader per format, from the first line on. */
bool read_xyzr(struct line_reader *reader, struct molecule *molecule, struct failure *failure);
bool read_pdb(struct line_reader *reader, struct molecule *molecule, struct failure *failure);
bool read_pqr(struct line_reader *reader, struct molecule *molecule, struct failure *failure);
bool read_xyz(struct line_reader *reader, struct molecule *molecule, struct failure *failure);

#endif
