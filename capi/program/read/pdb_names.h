/* Columns 18 to 22 of the atom records of a .pdb file, which hold names of residues and chains in two ways. */
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
 * A file has one of the two ways: where both would do, the one counts that more of its residues show by these rules,
 * and the fourth letter if as many do. Zeros at first. */
struct pdb_names {
  uint64_t long_residues, long_chains; /* that were seen */
  struct residue_label **either;       /* residues in which both would do */
  size_t count, room;
  const struct residue_label *last; /* that was looked at */
  /* Chains without a name, which end with a TER record. */
  uint64_t ends;   /* records before the last atom of one */
  uint64_t number; /* of the chain, from 1 on; 0: there was none */
  bool loose;      /* its last atom is of water, or an ion */
};

/* Take name and chain of an atom record with its columns up to 22. */
void pdb_names_read(const struct pdb_names *names, const char *text, struct residue_label *residue);

/* Note the residue of the last atom of the molecule, which was read so and has a letter in column 21. False: memory is
 * short. */
bool pdb_names_note(struct pdb_names *names, const char *text, struct molecule *molecule, struct failure *failure);

/* Name a chain that has no name: where so many TER records were before its atom and one of them since the last such
 * atom, it is another chain, ".2" and so on. Water and ions behind water and ions are no other one: some programs write
 * TER behind each molecule. `atom` is the atom's name. */
void pdb_names_number(struct pdb_names *names, uint64_t ends, const char *atom, struct residue_label *residue);

/* At the end of the file: what both ways would do for is named by that of the file. */
void pdb_names_finish(struct pdb_names *names);

void pdb_names_free(struct pdb_names *names);
