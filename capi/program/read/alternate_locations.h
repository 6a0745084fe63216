/* Atoms that stand in a file more than once, at alternate locations: which record counts. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/molecule.h"

/* Which residue. */
struct residue_place {
  char chain[12];
  char number[12];
  char insertion[2];
  char segment[6]; /* four characters of it */
};

struct residue_place residue_place_of(const struct residue_label *residue, struct field segment);

struct seen_location;
struct location_slot;
struct residue_visit;

/* The atoms and residues with letters seen so far, in the order of the file, and a hash table with open addressing over
 * them. Atoms without a letter wait in the molecule, residue by residue, until one of their residue has a letter; in
 * most files none has. */
struct alternate_locations {
  struct seen_location *seen;
  uint32_t count;
  uint32_t room;
  struct location_slot *slots;
  size_t capacity; /* a power of two, or 0 */
  struct residue_visit *visit;
  uint32_t visits, visit_room;
  uint32_t numbered; /* visits that are in the table of residues */
  uint32_t *residue; /* table of the first visits of residues, counted from 1 */
  size_t residues;   /* its size, a power of two, or 0 */
};

#define ALTERNATE_LOCATIONS_NONE \
  { .seen = NULL }

/* Whether an atom record belongs to the molecule; records must be shown in the order of the file, and each that does is
 * appended to the molecule before the next one is shown. Atoms and residues are distinguished by the label and, where a
 * format has it, the segment.
 *   1. A record without a letter (' ') for its location always does.
 *   2. A record with a letter does if its atom (chain, residue number, atom name) appeared first with that letter.
 *   3. If a residue has two names (a mixture), only the name of its first lettered record does.
 * False: memory is short. */
bool alternate_locations_keep(struct alternate_locations *locations, const struct molecule *molecule,
                              const struct atom_label *label, struct field segment, char letter, bool *keep);

/* The same, where neither this record nor the one before has a letter, and both are of one residue and segment. */
void alternate_locations_go_on(struct alternate_locations *locations);

void alternate_locations_free(struct alternate_locations *locations);
