/* Atoms of a PDB file that stand there more than once, at alternate locations: which record counts. */
#ifndef HARDSPHERE_TOOL_ALTERNATE_LOCATIONS_H
#define HARDSPHERE_TOOL_ALTERNATE_LOCATIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct seen_location;

/* The atoms and residues seen so far: a hash table with open addressing. */
struct alternate_locations {
  struct seen_location *slots;
  size_t capacity; /* a power of two, or 0 */
  size_t used;
};

#define ALTERNATE_LOCATIONS_NONE \
  { NULL, 0, 0 }

/* Whether an atom record belongs to the molecule; records must be shown in the order of the file.
 *   1. A record without a letter for its location always does.
 *   2. A record with a letter does if its atom (chain, residue number, atom name) appeared first with that letter.
 *   3. If a residue has two names (a mixture), only the name of its first lettered record does.
 * False: memory is short. */
bool alternate_locations_keep(struct alternate_locations *seen, const char *record, size_t length, bool *keep);

void alternate_locations_free(struct alternate_locations *seen);

#endif
