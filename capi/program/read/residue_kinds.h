/* The meaning of names of residues: which are known. */
#pragma once

enum residue_kind { RESIDUE_OTHER, RESIDUE_AMINO_ACID, RESIDUE_NUCLEOTIDE, RESIDUE_WATER };

/* The kind of the residue of that name, in any case of its letters: the 20 amino acids, their protonation states and
 * frequent modifications, caps of chains, CHARMM's dipeptide of alanine; nucleotides; water, by the names that its
 * models go by. */
enum residue_kind residue_kind_of(const char *name);
