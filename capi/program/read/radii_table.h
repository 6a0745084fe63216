/* Radii by the names of residues and atoms, as they are used for proteins: an atom's radius may include its
 * hydrogens. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hardsphere.h"
#include "read/failure.h"

/* Bytes of a name, with the NUL behind it. */
enum { RADII_NAME_BYTES = 8 };

struct radii_table {
  hsp_residue_atom *entries;
  size_t count;
  size_t capacity;
  bool hydrogens;  /* there are radii for hydrogens; if not, heavy atoms include them */
  uint32_t *slots; /* a hash table of the names */
  size_t slot_count;
};

#define RADII_TABLE_NONE \
  { NULL, 0, 0, false, NULL, 0 }

/* Make a table of a set of the library, HSP_RADII_*. Free the table on true and on false. */
bool radii_table_make(struct radii_table *table, uint32_t set, struct failure *failure);

/* Read a table from a file, in one of three forms; text behind a '#' is a comment:
 *   1. on each line the name of a residue, the name of an atom and a radius;
 *   2. as FreeSASA's configuration files: "types:", then on each line a type, its radius and perhaps a class, and
 *      "atoms:", then on each line a residue, an atom and its type; before them perhaps "name: NAME";
 *   3. as NACCESS's vdw.radii: "RESIDUE", a kind, the residue and a number, then for each of its atoms "ATOM", its
 *      name, its radius and perhaps whether it is polar, which is not kept.
 * The residue ANY or * stands for all residues that have no such atom in the table. Free the table on true and on
 * false. */
bool radii_table_read(struct radii_table *table, const char *path, struct failure *failure);

/* The radius of an atom by both names, in any case of their letters; false: the table has none. */
bool radii_table_find(const struct radii_table *table, const char *residue, const char atom[RADII_NAME_BYTES],
                      double *radius);

/* Whether the table has radii of a residue by its own name. */
bool radii_table_names(const struct radii_table *table, const char *residue);

/* Put the entries in alphabetical order, in which radii_table_read puts those of a file. */
void radii_table_sort(struct radii_table *table);

/* An entry; false beyond the last. */
bool radii_table_get(const struct radii_table *table, size_t i, const char **residue, const char **atom,
                     double *radius);

void radii_table_free(struct radii_table *table);
