/* The atoms of one file, as balls. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/assembly.h"
#include "read/failure.h"
#include "read/fields.h"
#include "read/file_box.h"
#include "read/file_choice.h"
#include "read/file_format.h"
#include "read/name_table.h"
#include "read/radii.h"
#include "read/radii_table.h"
#include "read/symmetry.h"

enum { RESIDUE_NAME_BYTES = 24 };

/* The name of a residue for a person; empty where the file does not say. */
struct residue_label {
  char chain[12];
  char name[RESIDUE_NAME_BYTES];
  char number[12]; /* as written, without the insertion code */
  char insertion[2];
  uint16_t repeat; /* counts residues in a row that have the same names and numbers, modulo 65536 */
  uint32_t asym;   /* of mmCIF: the number of label_asym_id in the molecule's table; of .mol2 the number before its
                      name; 0: none */
};

#define RESIDUE_LABEL_NONE \
  { "", "", "", "", 0, 0 }

/* Whether the number distinguishes the residue from others: it is neither missing nor stars. */
static inline bool residue_is_numbered(const struct residue_label *residue) {
  return residue->number[0] != '\0' && residue->number[0] != '*';
}

/* The residue of atoms in files without residues. */
extern const struct residue_label residue_nameless;

/* Residues of a molecule; they stay where they are in memory when others are added. */
struct residue_block;
struct residue_list {
  struct residue_block *first, *last;
  size_t used; /* of the last block */
};

/* The serial number of an atom as written, which in large files may be no number; in a component the atom's name, if
 * there is room for it; empty if no bonds are stated by it. */
struct serial_label {
  char text[7];
};

/* The kind of a bond, if the file says it. */
enum bond_order { BOND_UNKNOWN, BOND_SINGLE, BOND_DOUBLE, BOND_TRIPLE, BOND_AROMATIC };

/* A bond that the file states. There may be no such atoms, or several. */
struct stated_bond {
  struct serial_label serial[2];
  enum bond_order order;              /* unknown: a double bond is stated twice, a triple one three times */
  uint32_t model;                     /* the model that states it; models may repeat bonds of others */
  char component[RESIDUE_NAME_BYTES]; /* in a file of several components: the one that states it; empty: any */
};

/* The name of an atom for a person; empty where the file does not say it. Files have many atoms: it is kept small. */
struct atom_label {
  const struct residue_label *residue; /* in a molecule, neighbouring atoms of a residue share it */
  char name[8];
  struct element_symbol element; /* empty if neither columns nor names tell it */
  bool hetatm : 1;               /* the file says that it belongs to no chain: to a ligand, an ion, water */
  bool by_name : 1;              /* its radius is that of its residue's and its own name */
  bool by_number : 1;            /* the file has the atomic number of the element */
  bool by_letters : 1;           /* its element is a guess by the letters of its name */
  bool contradicted : 1;         /* its name begins with another element than the file states */
  /* No atom, but several atoms in a coarse-grained model: it needs a radius by the names of residue and atom. */
  bool bead : 1;
  /* No atom, but a position beside one; becomes a ball only if the user gives its symbol a radius. */
  bool virtual_site : 1;
  bool partly : 1;           /* of a crystal: its occupancy is below 1 */
  bool polar : 1;            /* polarity.h */
  bool apolar : 1;           /* polarity.h */
  unsigned char decimals[3]; /* digits behind the points of its coordinates if they are fractions of a cell; else 0 */
};

#define ATOM_LABEL_NONE                                                                                  \
  {                                                                                                      \
    &residue_nameless, "", {""}, false, false, false, false, false, false, false, false, false, false, { \
      0                                                                                                  \
    }                                                                                                    \
  }

/* Further data of an atom in a file, which only pictures show. */
struct atom_extra {
  struct serial_label serial;
  bool has_value;
  double value; /* the temperature factor, or of .mol2 and .pqr files the charge, in elementary charges */
};

#define ATOM_EXTRA_NONE \
  { {""}, false, 0.0 }

/* The contents of a file beside the atoms that became balls, counted in atoms, but models in models. */
struct left_out {
  uint64_t other_models;
  uint64_t alternate_locations;
  uint64_t virtual_sites;
  uint64_t unplaced;         /* the file has no coordinates of them */
  uint64_t hydrogens_of_set; /* in this set of radii heavy atoms include them */
  /* By the user's choice; each atom counts once: */
  uint64_t water;
  uint64_t hetatm; /* other than water */
  uint64_t hydrogen;
  uint64_t others;
};

/* The data of a molecule or of a frame of a trajectory beside its atoms. */
struct frame_stamp {
  uint64_t number; /* counted from 1; 0: it is no frame of a trajectory */
  bool first;      /* it is the first of the frames that are looked at */
  bool timed;
  double time; /* as the file has it: in picoseconds, or in another unit of its writer */
  bool stepped;
  int64_t step; /* of the simulation */
  struct box_record box;
};

struct molecule {
  const struct file_format *format;
  uint32_t atoms;
  uint32_t capacity;
  uint32_t read;            /* atoms that were read, also those left out since */
  uint32_t most;            /* so many may be read */
  double *xyz;              /* [atoms][3]; it and the next two are NULL after molecule_drop_balls */
  double *radius;           /* [atoms] */
  uint32_t *line;           /* [atoms], the line from which an atom was read; 0: none, or beyond 4 billion */
  uint32_t points;          /* atoms whose radius was 0 at molecule_drop_balls */
  struct atom_label *label; /* [atoms] */
  struct residue_list residues;
  uint32_t residue_begin;   /* the first atom of the last residue */
  unsigned keeps;           /* further arrays that it keeps: molecule_keeping */
  uint32_t *place;          /* [atoms], its place among all atoms of the file's molecule, or NULL */
  uint32_t *coordinate;     /* [atoms], its place among those read, as frames of a trajectory have them, or NULL */
  struct atom_extra *extra; /* [atoms], or NULL */
  struct file_choice choice;
  bool location_found; /* some atom has the location whose letter is chosen */
  uint64_t model;      /* which model was read, counted from 1; or EVERY_MODEL */
  uint64_t models;     /* how many the file has */
  uint64_t number;     /* if a file's molecules are read one by one: its place among them, counted from 1; else 0 */
  uint64_t copy;       /* if atoms of several models are read: the model of those now added; else 0 */
  struct stated_bond *bond; /* [bonds] as they are read */
  size_t bonds;
  size_t bond_capacity;
  struct left_out left_out;
  struct frame_stamp frame;
  const char *remark;       /* a line on the file that a user should read, not owned; or NULL */
  const char *coordinates;  /* if they are not the usual ones: the name of their first item, not owned; else NULL */
  struct symmetry symmetry; /* it belongs to the box of the frame */
  struct assemblies assemblies;
  struct name_table asyms; /* of mmCIF: the values of label_asym_id */
};

enum molecule_keeping { KEEP_NO_MORE = 0, KEEP_PLACES = 1, KEEP_EXTRAS = 2 };

/* Prepare for reading the chosen part of a file. */
void molecule_init(struct molecule *molecule, const struct file_format *format, const struct file_choice *choice,
                   unsigned keeps);

/* Whether the model of that number, counted from 1, is to be read; atoms added from now on are of this model. */
static inline bool molecule_wants_model(struct molecule *molecule, uint64_t model) {
  if (molecule->model == EVERY_MODEL) molecule->copy = model;
  return molecule->model == EVERY_MODEL || molecule->model == model;
}

/* Give the chain of a residue its name in the copy of that number: the same in the first copy, with "-2" behind it in
 * the second. False: the name has no room for that. */
bool chain_name_copy(struct residue_label *residue, uint64_t copy, struct failure *failure);

/* Whether a label has room for a text: of two chains whose names were cut to one, an atom of the one would be another
 * location of an atom of the other, and so with residues. `what` is what the reason calls it: "the chain's name". */
bool label_fits(struct field text, size_t room, const char *what, uint64_t line, struct failure *failure);

/* The same, and copy it. */
bool label_take(char *out, size_t room, struct field text, const char *what, uint64_t line, struct failure *failure);

/* Whether a chain has no name of its own; what copies and TER records add is not counted. */
bool chain_is_nameless(const char *chain);

/* Whether a user who writes this name means the chain: "." is each nameless chain, ".1" the first of them. */
bool chain_is_named(const char *chain, struct field name);

/* Forget all atoms, but keep their memory. */
void molecule_empty(struct molecule *molecule);

/* Forget all that is known of the molecule, but keep the memory of its atoms. */
void molecule_renew(struct molecule *molecule);

/* Append an atom, and its residue unless it is that of the atom before. If the residue's number is "****" or missing,
 * an atom begins a new residue if its name occurs again: that of the residue's first atom, or one with other names in
 * between (atoms called H may follow each other). With missing numbers this holds only in amino acids, nucleotides,
 * water and ions: elsewhere names may be mere elements. False: memory is short, or there are too many atoms for the
 * library or for the caller's `most`. */
bool molecule_add(struct molecule *molecule, const double xyz[3], double radius, const struct atom_label *label,
                  uint64_t line, struct failure *failure);

/* The data kept of the last appended atom, beside its label; NULL: none. */
struct atom_extra *molecule_last_extra(const struct molecule *molecule);

/* The residue of the last appended atom, which must have one. */
struct residue_label *molecule_last_residue(const struct molecule *molecule);

/* How many atoms the file's molecule has, also those of other locations and without coordinates. */
uint32_t molecule_atoms_of_file(const struct molecule *molecule);

/* Append a bond that the file states. False when memory is short. */
bool molecule_add_bond(struct molecule *molecule, const struct stated_bond *bond, struct failure *failure);

/* Keep the atoms whose keep [atoms] is not 0, as if the others had not been read, but they have their places in the
 * file. */
void molecule_keep_atoms(struct molecule *molecule, const uint8_t *keep);

/* Atom `from` takes the place of atom `to`. */
void molecule_move_atom(struct molecule *molecule, uint32_t to, uint32_t from);

/* Take the radius of every atom from the table, if the table has it, else from its element; radii that the user gave
 * for elements come before both. Nothing is done if the format has radii. If the table has the residue, but no
 * hydrogens at all, its heavy atoms include the hydrogens, which are left out. Virtual sites to which the user gave no
 * radius are left out. Other symbols of no element and without a radius are refused, all of them in one message, and so
 * are beads and atoms whose names do not tell the element. */
bool molecule_take_radii(struct molecule *molecule, const struct radii *radii, const struct radii_table *table,
                         struct failure *failure);

/* Give back the memory of the balls, once the library has copied them. Only functions of labels may be called then. */
void molecule_drop_balls(struct molecule *molecule);

/* How many balls of radius 0 there are. */
uint32_t molecule_points(const struct molecule *molecule);

/* The mean radius of all atoms; 0 if there are none. */
double molecule_mean_radius(const struct molecule *molecule);

/* Whether the atom belongs to a water molecule, by the name of its residue. */
bool atom_is_water(const struct atom_label *label);

/* Whether it belongs to a chain of residues. An atom that the file calls HETATM does if its residue is a modified
 * one. */
bool atom_is_of_chain(const struct atom_label *label);

bool atom_is_hydrogen(const struct atom_label *label);

void molecule_free(struct molecule *molecule);

/* Copy a field into a label; the rest that has no room is cut off, between characters of UTF-8. */
void label_copy(char *out, size_t room, struct field text);

/* Whether z is 0 for all atoms from that one on, as in drawings and in files that never had coordinates. */
bool molecule_is_flat(const struct molecule *molecule, uint32_t first);
