/* Atoms that a file has more than once, at alternate locations: the choice of the record that counts. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/molecule.h"

/* The place of a residue in a file. */
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

/* The atoms and residues with letters seen so far, in the order of the file, with a hash table (open addressing). Atoms
 * without a letter are entered later, residue by residue, when an atom of their residue has a letter; in most files
 * none has. */
struct alternate_locations {
  struct seen_location *seen;
  uint32_t count;
  size_t room;
  struct location_slot *slots;
  size_t capacity; /* a power of two, or 0 */
  struct residue_visit *visit;
  uint32_t visits;
  size_t visit_room;
  uint32_t numbered; /* visits that are in the table of residues */
  uint32_t *residue; /* table of the first visits of residues, counted from 1 */
  size_t residues;   /* its size, a power of two, or 0 */
};

#define ALTERNATE_LOCATIONS_NONE \
  { .seen = NULL }

/* Decide whether an atom record belongs to the molecule. Records have to come in the order of the file, and each one
 * that belongs to it has to be appended to the molecule before the next call. Atoms and residues are distinguished by
 * the label and, if the format has it, the segment.
 *   1. A record without a letter for its location, an empty text, always does. .cif files may have words for letters,
 *      of which seven characters count.
 *   2. A record with a letter does if its atom (chain, residue number, atom name) appeared first with that letter.
 *   3. If a residue has two names (a mixture), only the name of its first lettered record does.
 * False: memory is short. */
bool alternate_locations_keep(struct alternate_locations *locations, const struct molecule *molecule,
                              const struct atom_label *label, struct field segment, struct field letter, bool *keep);

/* The same for a record without a letter, if the record before has none either and is of the same residue and
 * segment. */
void alternate_locations_go_on(struct alternate_locations *locations);

void alternate_locations_free(struct alternate_locations *locations);
