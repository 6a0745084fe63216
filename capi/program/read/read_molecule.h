/* From a file to a molecule. The extension of its name tells the format, unless the user states it. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/line_reader.h"
#include "read/molecule.h"
#include "read/molecule_texts.h"

/* The number of an atom, by which bonds name it, as a short text. False: it is no number, or too large. */
bool serial_of_number(struct field text, struct serial_label *serial);

/* Read as many atoms as are announced, or step over them if they are not wanted. *read: the number found. */
typedef enum line_status announced_atoms(struct line_reader *reader, uint64_t count, bool wanted,
                                         struct molecule *molecule, uint64_t *read, struct failure *failure);

/* Read the next model of a format in which each model begins with the number of its atoms. It is `count`, from the line
 * that was read last. False: the model, if it is wanted, or one before it breaks off, or an atom cannot be read. */
bool read_announced_model(struct line_reader *reader, uint64_t count, announced_atoms *read_atoms,
                          struct molecule *molecule, struct failure *failure);

/* Read the chosen part of a file (line_reader_open) into a molecule that was not initialised; free it with
 * molecule_free on true and on false. In formats without radii they are 0 until molecule_take_radii. keeps:
 * molecule_keeping. A file is either read in full or refused; one without atoms is refused. */
bool read_molecule(const char *path, const struct file_format *format, const struct file_choice *choice, unsigned keeps,
                   struct molecule *molecule, struct failure *failure);

/* The same for one of several molecules of a file. The molecule is all zeros, or was read by this function before, and
 * its memory is used again. Line numbers are those of the file. */
bool read_molecule_text(struct molecule_text *text, const struct file_format *format, const struct file_choice *choice,
                        unsigned keeps, struct molecule *molecule, struct failure *failure);
