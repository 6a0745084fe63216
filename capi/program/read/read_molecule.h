/* From a file to a molecule. The extension of the name tells the format, unless the user does. */
#ifndef HARDSPHERE_TOOL_READ_MOLECULE_H
#define HARDSPHERE_TOOL_READ_MOLECULE_H

#include <stdbool.h>

#include "read/failure.h"
#include "read/line_reader.h"
#include "read/molecule.h"
#include "read/residue_kinds.h"

/* Tell by its name, which stands in no columns, what element an atom of the labelled residue is, or that it is none. It
 * is empty if the name does not tell. seen: NULL, or as atom_kind_again. */
void label_take_element(struct kinds_seen *seen, struct atom_label *label, struct field name);

/* Take a symbol, a label that begins with one and goes on with something else, C1 or Fe3+, or an atomic number. False:
 * it is none of them. */
bool label_take_symbol(struct atom_label *label, struct field text);

/* The number of an atom, by which bonds name it, as a short text. False: it is none, or too large for that. */
bool serial_of_number(struct field text, struct serial_label *serial);

/* Tell whether the atom is a bead, by the names in the label, whatever element the file guesses from them: B or S. */
void label_check_bead(struct atom_label *label);

/* Read as many atoms as are announced, or step over them if they are not wanted. *read: how many there were. */
typedef enum line_status announced_atoms(struct line_reader *reader, uint64_t count, bool wanted,
                                         struct molecule *molecule, uint64_t *read, struct failure *failure);

/* The next model of a format in which each begins with the number of its atoms. That is `count`, from the line that was
 * read last. False: the model, if it is wanted, or one before it breaks off, or an atom cannot be read. */
bool read_announced_model(struct line_reader *reader, uint64_t count, announced_atoms *read_atoms,
                          struct molecule *molecule, struct failure *failure);

/* Read what is chosen of a file (line_reader_open) into a molecule that was not initialised; free it with molecule_free
 * on true and on false. Radii are 0 in formats without radii: molecule_take_radii is to follow. keeps:
 * molecule_keeping. Every file is either read in full or refused, and so is one without atoms. */
bool read_molecule(const char *path, const struct file_format *format, const struct file_choice *choice, unsigned keeps,
                   struct molecule *molecule, struct failure *failure);

#endif
