/* Atoms at several locations, when the user does not want simply the first: all are read, and chosen afterwards. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/alternate_locations.h"
#include "read/failure.h"
#include "read/fields.h"
#include "read/molecule.h"

struct located_atom;

/* Zeros at first. */
struct location_choice {
  struct located_atom *located;
  size_t count, room;
};

/* Note the location of the last atom of the molecule, which is one of a residue, or of an assembly of disordered atoms;
 * then its group is the location. An empty location counts if the same atom is at others, too. An occupancy that is not
 * given, or is no number, counts as 1. False: memory is short. */
bool location_choice_add(struct location_choice *choice, const struct molecule *molecule,
                         const struct residue_place *place, const char *name, const char *residue,
                         struct field location, struct field occupancy, struct failure *failure);

/* Keep each atom at one location, and leave out the others:
 *   1. of a residue one location counts: that of the largest mean occupancy, or the user's letter; the first one in the
 *      file if several are as large, or if there is no such letter;
 *   2. an atom that is not there counts where its own occupancy is largest, or first in the file;
 *   3. of a residue with two names (a mixture) only the name at that location counts.
 * The molecule's location_found tells whether the letter is anywhere. False: memory is short. */
bool location_choice_finish(struct location_choice *choice, struct molecule *molecule, struct failure *failure);

void location_choice_free(struct location_choice *choice);
