/* Residues and chains: which atoms belong together, and what they sum to. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/index_file.h"
#include "read/molecule.h"

/* Whether the file says anything. */
bool residue_label_says(const struct residue_label *label);

/* The name of the residue for a person: "THR A 1", as far as the file says. */
#define RESIDUE_TEXT_BYTES 56
const char *residue_text(char out[RESIDUE_TEXT_BYTES], const struct residue_label *label);

/* Whether two atoms of the same file with these labels belong to one residue, if they are neighbours. */
bool residue_label_same(const struct residue_label *a, const struct residue_label *b);

enum grouping {
  GROUPING_NONE,
  /* A residue: neighbours in the file with the same chain, name, number and insertion code, and of mmCIF with the same
   * label_asym_id, of .mol2 with the same number before the name. Numbers may begin anew in the same chain, as those of
   * water do after 9999; so residues of one name that lie apart are two. Where numbers are missing or stars, an atom's
   * name that comes again begins one. */
  GROUPING_RESIDUE,
  /* A chain: all atoms with its letter, wherever they stand: ligands and water often follow all the chains. */
  GROUPING_CHAIN,
  /* A group of an index file, which may share atoms with others. */
  GROUPING_GROUP
};

/* Atoms that belong together. */
struct atom_group {
  uint32_t first; /* the first of them in the file; its label names the group; UINT32_MAX: there is none */
  uint32_t atoms;
  size_t member;    /* where they begin among the members of all groups */
  double area;      /* sum over them, in the order of the file */
  const char *name; /* of a group of an index file */
};

/* The groups of a molecule, in the order of their first atoms, or of the index file. */
struct atom_groups {
  enum grouping grouping;
  uint32_t count;
  struct atom_group *group; /* [count] */
  uint32_t *member;         /* atoms, those of a group in a row */
  size_t members;
};

#define ATOM_GROUPS_NONE \
  { GROUPING_NONE, 0, NULL, NULL, 0 }

/* Group the atoms; areas are 0. Atoms whose `part` [atoms] is 0 do not count, and residues and chains of none but such
 * are left out. part: NULL for all. False: memory is short. Free the groups on true and on false. */
bool atom_groups_make(const struct molecule *molecule, enum grouping grouping, const struct index_file *index,
                      const uint8_t *part, struct atom_groups *groups, struct failure *failure);

/* The sum of area [atoms] over a group. */
double atom_group_sum(const struct atom_groups *groups, const struct atom_group *group, const double *area);

/* The same of every group becomes its area. */
void atom_groups_sum(struct atom_groups *groups, const double *area);

/* The chain of each atom as a number, 0, 1, ..: chains count in the order of their first atoms. *number [atoms] is to
 * be freed on true. False: memory is short. */
bool chain_numbers_make(const struct molecule *molecule, uint32_t **number, struct failure *failure);

void atom_groups_free(struct atom_groups *groups);
