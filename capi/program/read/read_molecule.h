/* From a file to a molecule. The extension of the name tells the format, unless the user does. */
#ifndef HARDSPHERE_TOOL_READ_MOLECULE_H
#define HARDSPHERE_TOOL_READ_MOLECULE_H

#include <stdbool.h>

#include "read/failure.h"
#include "read/line_reader.h"
#include "read/molecule.h"

/* A format. The next one is one more file with one of these, its name in enum molecule_format, and its place in the
 * list of read_molecule.c. */
struct molecule_reader {
  const char *name;       /* for --format */
  const char *extensions; /* in capitals, without dots, between blanks; digits may follow one that ends in '#' */
  bool has_radii;
  bool has_elements;
  bool has_residues;
  bool has_hetatm;
  const char *unit;
  /* Read the model of the file that the molecule asks for, from the first line on. */
  bool (*read)(struct line_reader *reader, struct molecule *molecule, struct failure *failure);
  /* The same for the next model as a frame of a trajectory, read_next_model; NULL where there are no such files. */
  enum line_status (*next)(struct line_reader *reader, bool *begun, bool wanted, struct molecule *molecule,
                           struct failure *failure);
};

extern const struct molecule_reader xyzr_reader; /* x y z r */
extern const struct molecule_reader pdb_reader;  /* fixed columns */
extern const struct molecule_reader pqr_reader;  /* PDB records with charge and radius */
extern const struct molecule_reader xyz_reader;  /* element x y z */
extern const struct molecule_reader cif_reader;  /* mmCIF */
extern const struct molecule_reader gro_reader;  /* fixed columns, in nanometres */

/* Tell by its name, which stands in no columns, what element an atom of the labelled residue is, or that it is none. It
 * is empty if the name does not tell. */
void label_take_element(struct atom_label *label, struct field name);

/* The same if the atom is a bead, by the names in the label, whatever element the file guesses from them: B or S. */
void label_check_bead(struct atom_label *label);

/* Read as many atoms as are announced, or step over them if they are not wanted. *read: how many there were. */
typedef enum line_status announced_atoms(struct line_reader *reader, uint64_t count, bool wanted,
                                         struct molecule *molecule, uint64_t *read, struct failure *failure);

/* The next model of a format in which each begins with the number of its atoms. That is `count`, from the line that was
 * read last. False: the model, if it is wanted, or one before it breaks off, or an atom cannot be read. */
bool read_announced_model(struct line_reader *reader, uint64_t count, announced_atoms *read_atoms,
                          struct molecule *molecule, struct failure *failure);

/* Read the next model of a file, one after the other from the first line on, or step over it. The molecule is empty at
 * first, and `most` says how many atoms there may be; its frame gets what the file tells. *begun, false before the
 * first model, is the reader's. LINE_END: there is none left. */
enum line_status read_next_model(enum molecule_format format, struct line_reader *reader, bool *begun, bool wanted,
                                 struct molecule *molecule, struct failure *failure);

/* Whether a format's files are read as trajectories. */
bool format_has_frames(enum molecule_format format);

/* The names of all formats as a person lists them: "a, b or c", each with the prefix before it. */
#define FORMAT_LIST_BYTES 120
const char *molecule_format_list(char out[FORMAT_LIST_BYTES], const char *prefix);

/* The format of that name or extension, in any case of its letters; false if there is none. */
bool molecule_format_named(const char *name, enum molecule_format *format);

/* The format that a file name's extension asks for; false if there is none. */
bool molecule_format_of(const char *path, enum molecule_format *format, struct failure *failure);

/* Read one model of a file (line_reader_open), counted from 1, into a molecule that was not initialised; free it with
 * molecule_free on true and on false. Radii are 0 in formats without radii: molecule_take_radii is to follow. Every
 * file is either read in full or refused, and so is one without atoms. */
bool read_molecule(const char *path, enum molecule_format format, uint64_t model, struct molecule *molecule,
                   struct failure *failure);

#endif
