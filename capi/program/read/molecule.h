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

/* The name of a residue for a person; empty where the file does not say. */
struct residue_label {
  char chain[12];
  char name[8];
  char number[12]; /* as written, without the insertion code */
  char insertion[2];
  uint16_t repeat; /* where the number does not tell residues apart: which of them in a row it is, modulo 65536 */
  uint32_t asym;   /* of mmCIF: the number of label_asym_id in the molecule's table; 0: none */
};

#define RESIDUE_LABEL_NONE \
  { "", "", "", "", 0, 0 }

/* Whether the number tells the residue from others: it is neither missing nor stars. */
static inline bool residue_is_numbered(const struct residue_label *residue) {
  return residue->number[0] != '\0' && residue->number[0] != '*';
}

/* Of atoms in files without residues. */
extern const struct residue_label residue_nameless;

/* Residues of a molecule, which stay where they are as more come. */
struct residue_block;
struct residue_list {
  struct residue_block *first, *last;
  size_t used; /* of the last block */
};

/* The serial number of an atom as written, which in large files is none, or in a component its name; empty where no
 * bonds are stated by it. */
struct serial_label {
  char text[6];
};

/* The kind of a bond, where the file says. */
enum bond_order { BOND_UNKNOWN, BOND_SINGLE, BOND_DOUBLE, BOND_TRIPLE, BOND_AROMATIC };

/* A bond that the file states. There may be no such atoms, or several. */
struct stated_bond {
  struct serial_label serial[2];
  enum bond_order order; /* unknown: it is stated as often as it is manifold */
  uint32_t model;        /* that it is stated in, which may say again what others do */
  char component[8];     /* in a file of components: its own, while other ones' are there too; empty: any */
};

/* The name of an atom for a person; empty where the file does not say. Files have many: it is kept small. */
struct atom_label {
  const struct residue_label *residue; /* in a molecule one for all neighbours of the residue */
  char name[8];
  struct element_symbol element; /* empty where neither columns nor names tell */
  bool hetatm : 1;               /* the file says that it belongs to no chain: to a ligand, an ion, water */
  bool by_name : 1;              /* its radius is by residue and atom */
  bool by_number : 1;            /* the file has the atomic number of the element */
  bool by_letters : 1;           /* its element is a guess by the letters of its name */
  bool contradicted : 1;         /* the file states another element than the name begins with */
  /* No atom, but several of a coarse-grained model, which needs a radius by residue and atom. */
  bool bead : 1;
  /* No atom, but a position beside one; becomes a ball only if the user gives its symbol a radius. */
  bool virtual_site : 1;
  bool partly : 1;           /* of a crystal: its occupancy is below 1 */
  bool polar : 1;            /* polarity.h */
  bool apolar : 1;           /* likewise */
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

/* The contents of a file beside the atoms that became balls, in atoms unless it says otherwise. */
struct left_out {
  uint64_t other_models;
  uint64_t alternate_locations;
  uint64_t virtual_sites;
  uint64_t unplaced;         /* for which the file has no coordinates */
  uint64_t hydrogens_of_set; /* for which heavy atoms stand in this set of radii */
  /* By the user's choice; each atom counts once: */
  uint64_t water;
  uint64_t hetatm; /* other than water */
  uint64_t hydrogen;
  uint64_t others;
};

/* The data of a molecule or of a frame of a trajectory beside its atoms. */
struct frame_stamp {
  uint64_t number; /* counted from 1; 0: it is no frame of a trajectory */
  bool first;      /* of those that are looked at */
  bool timed;
  double time; /* as the file has it: picoseconds, or whatever its writer took */
  bool stepped;
  int64_t step; /* of the simulation */
  struct box_record box;
};

struct molecule {
  const struct file_format *format;
  uint32_t atoms;
  uint32_t capacity;
  uint32_t read;            /* atoms that were read, whatever became of them */
  uint32_t most;            /* that may be read */
  double *xyz;              /* [atoms][3]; NULL, as the next two, after molecule_drop_balls */
  double *radius;           /* [atoms] */
  uint32_t *line;           /* [atoms], the line that an atom was read from; 0: none, or beyond 4 billion */
  uint32_t points;          /* atoms whose radius was 0 then */
  struct atom_label *label; /* [atoms] */
  struct residue_list residues;
  uint32_t residue_begin;   /* the first atom of the last of them */
  unsigned keeps;           /* what else: molecule_keeping */
  uint32_t *place;          /* [atoms], its place among those read, or NULL */
  struct atom_extra *extra; /* [atoms], or NULL */
  struct file_choice choice;
  bool location_found; /* some atom has the location whose letter is chosen */
  uint64_t model;      /* which model was read, counted from 1; or EVERY_MODEL */
  uint64_t models;     /* how many the file has */
  uint64_t number;     /* its place among many that are read one by one, counted from 1; 0: it is none of them */
  uint64_t copy;       /* the model that atoms are added of, where they are added to those of others; 0 or 1: none */
  struct stated_bond *bond; /* [bonds] as they are read */
  size_t bonds;
  size_t bond_capacity;
  struct left_out left_out;
  struct frame_stamp frame;
  const char *remark;       /* what a user should know of the file, in one line, not owned; or NULL */
  const char *coordinates;  /* where they are not the usual ones: the name of their first item, not owned; or NULL */
  struct symmetry symmetry; /* that goes with the box of the frame */
  struct assemblies assemblies;
  struct name_table asyms; /* of mmCIF: the values of label_asym_id */
};

enum molecule_keeping { KEEP_NO_MORE = 0, KEEP_PLACES = 1, KEEP_EXTRAS = 2 };

/* Prepare for reading what is chosen of a file. */
void molecule_init(struct molecule *molecule, const struct file_format *format, const struct file_choice *choice,
                   unsigned keeps);

/* Whether a model of that number, counted from 1, is to be read; all that is added from now on is of this one. */
static inline bool molecule_wants_model(struct molecule *molecule, uint64_t model) {
  if (molecule->model == EVERY_MODEL) molecule->copy = model;
  return molecule->model == EVERY_MODEL || molecule->model == model;
}

/* Give the chain of a residue the name that it has in a copy of that number: as it is in the first one, with "-2"
 * behind it in the second. False: it has no room for that. */
bool chain_name_copy(struct residue_label *residue, uint64_t copy, struct failure *failure);

/* Whether a chain has no name of its own, in a copy or behind a TER record either. */
bool chain_is_nameless(const char *chain);

/* Whether a user who writes the name means the chain: "." for all that are nameless, ".1" for the first of them. */
bool chain_is_named(const char *chain, struct field name);

/* Forget all atoms, but not the memory of them. */
void molecule_empty(struct molecule *molecule);

/* Forget all that is known of the molecule, but not the memory of its atoms, which it still has. */
void molecule_renew(struct molecule *molecule);

/* Append an atom, and its residue unless it is that of the atom before. Where numbers are "****" or missing the atom
 * begins a residue if its name comes again: that of the first one, or one with others in between, as atoms that are
 * called H may follow each other. Missing numbers count so in amino acids, nucleotides, water and ions alone: elsewhere
 * names may be mere elements. False when memory is short or there are too many: for the library, or for the caller's
 * `most`. */
bool molecule_add(struct molecule *molecule, const double xyz[3], double radius, const struct atom_label *label,
                  uint64_t line, struct failure *failure);

/* The data kept of the atom that was appended last beside its label; NULL: nothing. */
struct atom_extra *molecule_last_extra(const struct molecule *molecule);

/* The residue of the atom that was appended last, which has one. */
struct residue_label *molecule_last_residue(const struct molecule *molecule);

/* Append a bond that the file states. False when memory is short. */
bool molecule_add_bond(struct molecule *molecule, const struct stated_bond *bond, struct failure *failure);

/* Keep the atoms that are not 0 in keep [atoms]: as if the others had not been read. */
void molecule_keep_atoms(struct molecule *molecule, const uint8_t *keep);

/* Atom `from` takes the place of atom `to`. */
void molecule_move_atom(struct molecule *molecule, uint32_t to, uint32_t from);

/* Take the radius of every atom from the table, if it stands there, and else from its element; radii that the user gave
 * for elements come before both. Nothing is done if the format brings radii. Where the table names a residue, but no
 * hydrogens at all, heavy atoms stand for them, and they are left out. Virtual sites without a radius of the user's are
 * left out; other symbols without one, which no element has, are refused, all of them in one line, and so are beads and
 * atoms whose names do not tell the element. */
bool molecule_take_radii(struct molecule *molecule, const struct radii *radii, const struct radii_table *table,
                         struct failure *failure);

/* Give back the memory of balls that the library has. Only what is about labels may be called then. */
void molecule_drop_balls(struct molecule *molecule);

/* How many balls of radius 0 there are. */
uint32_t molecule_points(const struct molecule *molecule);

/* Of all atoms; 0 if there are none. */
double molecule_mean_radius(const struct molecule *molecule);

/* Whether the atom belongs to a water molecule, by the name of its residue. */
bool atom_is_water(const struct atom_label *label);

/* Whether it belongs to a chain of residues: what the file calls HETATM does if it is a modified residue. */
bool atom_is_of_chain(const struct atom_label *label);

bool atom_is_hydrogen(const struct atom_label *label);

void molecule_free(struct molecule *molecule);

/* Copy a field into a label; what does not fit is cut off. */
void label_copy(char *out, size_t room, struct field text);

/* Whether z is 0 of all atoms from that one on, as in drawings and in files that never had coordinates. */
bool molecule_is_flat(const struct molecule *molecule, uint32_t first);
