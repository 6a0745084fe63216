/* Columns 18 to 22 of the atom records of a .pdb file: the names of residues and chains, which files write in two
 * ways. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/line_reader.h"
#include "read/molecule.h"

/* The format has a residue's name in 18-20 and a chain's in 22. Programs of molecular dynamics write residues of four
 * letters into 18-21 (POPC, TIP3), others write chains of two into 21-22 (AA, BA). A letter in column 21 is the fourth
 * of a residue
 *   - where column 22 is blank, or 18-21 are a known name: of water, a lipid, an amino acid;
 * and the first of a chain
 *   - where column 20 is blank, or 18-20 are a known name of three letters or fewer.
 * Within a file only one of the two ways is used: if a residue fits both, the way counts in which more of the file's
 * residues can be read by these rules; the fourth letter of a residue if equally many. Zeros at first. */
struct pdb_names {
  uint64_t long_residues, long_chains; /* how many were seen */
  struct residue_label **either;       /* residues that fit both ways */
  size_t count, room;
  const struct residue_label *last; /* the residue looked at last */
  /* Chains without a name, which end with a TER record. */
  uint64_t ends;   /* TER records before the last atom of a nameless chain */
  uint64_t number; /* of its chain, from 1 on; 0: there was none */
  bool loose;      /* its last atom is of water, or an ion */
};

/* Take the names of residue and chain from an atom record that has its columns up to 22. */
void pdb_names_read(const struct pdb_names *names, const char *text, struct residue_label *residue);

/* Note the residue of the molecule's last atom, which pdb_names_read has read from a record with a letter in column 21.
 * False: memory is short. */
bool pdb_names_note(struct pdb_names *names, const char *text, struct molecule *molecule, struct failure *failure);

/* Name a chain that has no name. `ends` is the number of TER records before the atom. If one of them came since the
 * last atom of a nameless chain, another chain begins: ".2" and so on. Water and ions behind water and ions begin none,
 * as some programs write TER behind each molecule. `atom` is the atom's name. */
void pdb_names_number(struct pdb_names *names, uint64_t ends, const char *atom, struct residue_label *residue);

/* At the end of the file: residues that fit both ways are named in the file's way. */
void pdb_names_finish(struct pdb_names *names);

void pdb_names_free(struct pdb_names *names);
